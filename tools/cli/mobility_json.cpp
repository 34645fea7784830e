#include "higherpair/linkage/four_bar_limits.hpp"
#include "higherpair/linkage/grashof.hpp"
#include "higherpair/linkage/instant_centers.hpp"
#include "higherpair/linkage/piston.hpp"
#include "higherpair/linkage/quick_return.hpp"
#include "higherpair/linkage/slider_crank_stroke.hpp"
#include "higherpair/mechanism/loops.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "higherpair/mechanism/pins.hpp"
#include "json_text.hpp"
#include "mobility_gears.hpp"
#include "mobility_report.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace higherpair::cli {
namespace {

using Json = nlohmann::ordered_json;

const char* cause_of(const Redundancy& set) {
  switch (set.cause) {
    case RedundancyCause::kSamePin:
      return "same_pin";
    case RedundancyCause::kParallelCranks:
      return "parallel_cranks";
    case RedundancyCause::kRollingOnPivots:
      return "rolling_on_pivots";
    case RedundancyCause::kSlidingOnPivots:
      return "sliding_on_pivots";
    case RedundancyCause::kSlidesAlone:
      return "slides_alone";
    case RedundancyCause::kMember:
      break;
  }
  return "member";
}

const char* inversion_of(const SliderCrankInMechanism& loop) {
  switch (loop.inversion) {
    case SliderCrankInversion::kGuide:
      return "guide fixed";
    case SliderCrankInversion::kCrank:
      return "crank fixed (turning guide)";
    case SliderCrankInversion::kCoupler:
      return "coupler fixed (rocking guide)";
    case SliderCrankInversion::kMoving:
      break;
  }
  return "on moving bodies";
}

bool are_joined(const Mechanism& mechanism, int a, int b) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
    return (joint.first.body == a && joint.second.body == b) ||
           (joint.first.body == b && joint.second.body == a);
  });
}

bool slides_on_ground(const Mechanism& mechanism, int body) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
    return joint.type == JointType::kPrismatic && (joint.first.body == 0 || joint.second.body == 0) &&
           (joint.first.body == body || joint.second.body == body);
  });
}

// The body that the lever moves to and fro on ground, joined to it or by one link; none if there is no such
// body.
std::optional<int> ram_of(const Mechanism& mechanism, int lever, int crank) {
  const int count = static_cast<int>(mechanism.bodies.size());
  for (int ram = 1; ram < count; ++ram) {
    if (ram == lever || ram == crank || !slides_on_ground(mechanism, ram)) continue;
    bool joined = are_joined(mechanism, ram, lever);
    for (int link = 1; link < count; ++link) {
      joined =
          joined || (link != crank && are_joined(mechanism, ram, link) && are_joined(mechanism, link, lever));
    }
    if (joined) return ram;
  }
  return std::nullopt;
}

class Writer {
public:
  explicit Writer(const MobilityFindings& findings)
      : findings_(findings),
        mechanism_(findings.model.mechanism()),
        length_(from_si(dimension::kLength, findings.model.units())),
        angle_(from_si(dimension::kAngle, findings.model.units())) {}

  [[nodiscard]] Json all() const {
    const Mobility& mobility = findings_.mobility;
    const bool known = mobility.assembled;
    Json json;
    json["format"] = 1;
    json["title"] = mechanism_.title;
    json["mobility"] = known ? Json(mobility.freedom) : Json();
    json["useful"] = known ? Json(mobility.useful()) : Json();
    json["count"] = count();
    json["rank"] = known ? rank() : Json();
    json["idle"] = idle();
    json["redundant"] = redundant();
    const bool structure = known && mobility.freedom == 0;
    json["structure"] =
        structure ? Json(mobility.rank < mobility.conditions ? "indeterminate" : "determinate") : Json();
    json["explanations"] = explanations(mechanism_, mobility);
    json["drivers"] = known ? drivers() : Json();
    json["plan"] = plan();
    json["four_bars"] = Json::array();
    for (const FourBarInMechanism& loop : find_four_bars(mechanism_)) {
      json["four_bars"].push_back(four_bar(loop));
    }
    json["slider_cranks"] = Json::array();
    for (const SliderCrankInMechanism& loop : find_slider_cranks(mechanism_)) {
      json["slider_cranks"].push_back(slider_crank(loop));
    }
    json["gears"] = gears_json(findings_);
    json["instant_centers"] = centers();
    return json;
  }

private:
  [[nodiscard]] const std::string& body(int index) const {
    return mechanism_.bodies[static_cast<std::size_t>(index)].name;
  }
  [[nodiscard]] const std::string& joint(int index) const {
    return mechanism_.joints[static_cast<std::size_t>(index)].name;
  }
  [[nodiscard]] Json bodies(const std::vector<int>& indices) const {
    Json names = Json::array();
    for (const int index : indices) {
      names.push_back(body(index));
    }
    return names;
  }
  [[nodiscard]] Json joints(const std::vector<int>& indices) const {
    Json names = Json::array();
    for (const int index : indices) {
      names.push_back(joint(index));
    }
    return names;
  }

  [[nodiscard]] Json count() const {
    const MobilityCount& count = findings_.mobility.count;
    Json json = {
        {"bodies", count.bodies},        {"joints", count.joints()},     {"revolute", count.revolutes},
        {"prismatic", count.prismatics}, {"slot", count.slots},          {"slipping", count.slipping},
        {"rolling", count.rolling},      {"gears", count.gears},         {"belts", count.belts},
        {"sum_f", count.freedoms()},     {"mobility", count.mobility()}, {"formula", formula_text(count)},
        {"multiple_pins", Json::array()}};
    for (const Pin& pin : find_pins(mechanism_)) {
      if (pin.ends.size() > 2) {
        Json names = Json::array();
        for (const BodyPoint& end : pin.ends) {
          names.push_back(body(end.body));
        }
        json["multiple_pins"].push_back({{"bodies", names}, {"joints", joints(pin.joints)}});
      }
    }
    return json;
  }

  [[nodiscard]] Json rank() const {
    const Mobility& mobility = findings_.mobility;
    return {{"conditions", mobility.conditions},
            {"coordinates", 3 * (mobility.count.bodies - 1)},
            {"rank", mobility.rank},
            {"positions", mobility.positions},
            {"freedom", mobility.freedom},
            {"at_start", mobility.start_freedom},
            {"shaky", mobility.shaky},
            {"singular", mobility.singular}};
  }

  [[nodiscard]] Json idle() const {
    Json json = Json::array();
    const auto texts = idle_texts(mechanism_, findings_.mobility);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const IdleFreedom& idle = findings_.mobility.idle[i];
      json.push_back({{"body", body(idle.body)},
                      {"x", length_.apply(idle.p_W.x())},
                      {"y", length_.apply(idle.p_W.y())},
                      {"text", texts[i]}});
    }
    return json;
  }

  [[nodiscard]] Json redundant() const {
    Json json = Json::array();
    for (const Redundancy& set : findings_.mobility.redundancies) {
      Json contacts = Json::array();
      for (const int contact : set.contacts) {
        contacts.push_back(mechanism_.contacts[static_cast<std::size_t>(contact)].name);
      }
      json.push_back({{"conditions", set.conditions},
                      {"cause", cause_of(set)},
                      {"joints", joints(set.joints)},
                      {"contacts", contacts},
                      {"bodies", bodies(set.bodies)}});
    }
    return json;
  }

  [[nodiscard]] Json drivers() const {
    const Mobility& mobility = findings_.mobility;
    std::vector<int> useless;
    for (const int driver : mobility.useless_drivers) {
      useless.push_back(mechanism_.drivers[static_cast<std::size_t>(driver)].joint);
    }
    const auto objection = driver_objection(mechanism_, mobility);
    return {{"given", mechanism_.drivers.size()},
            {"needed", mobility.useful()},
            {"missing", mobility.missing_drivers},
            {"useless", joints(useless)},
            {"joints_to_drive", joints(mobility.joints_to_drive)},
            {"loose_bodies", bodies(mobility.loose_bodies)},
            {"objection", objection ? Json(*objection) : Json()}};
  }

  [[nodiscard]] Json plan() const {
    Json json = Json::array();
    for (const PlanStep& step : findings_.plan) {
      json.push_back({{"bodies", bodies(step.bodies)}, {"text", step.text}});
    }
    return json;
  }

  [[nodiscard]] Json limits(const FourBar& linkage, FourBarLink link) const {
    Json json = Json::array();
    for (const FourBarLimit& limit : four_bar_limits(linkage, link)) {
      json.push_back({{"crank", angle_.apply(limit.theta2)},
                      {"coupler", angle_.apply(limit.theta3)},
                      {"rocker", angle_.apply(limit.theta4)},
                      {"change_point", limit.change_point}});
    }
    return json;
  }

  [[nodiscard]] Json four_bar(const FourBarInMechanism& loop) const {
    const FourBar& linkage = loop.linkage;
    Json json = {{"ground", body(loop.ground)},
                 {"crank", body(loop.crank)},
                 {"coupler", body(loop.coupler)},
                 {"rocker", body(loop.rocker)},
                 {"lengths",
                  {length_.apply(linkage.r1), length_.apply(linkage.r2), length_.apply(linkage.r3),
                   length_.apply(linkage.r4)}},
                 {"grashof", name_of(classify_grashof(linkage))},
                 {"margin", length_.apply(grashof_margin(linkage))}};
    Json full_turn;
    Json positions;
    constexpr std::array<std::pair<const char*, FourBarLink>, 3> kLinks = {
        {{"crank", FourBarLink::kCrank},
         {"coupler", FourBarLink::kCoupler},
         {"rocker", FourBarLink::kRocker}}};
    for (const auto& [name, link] : kLinks) {
      full_turn[name] = turns_fully(linkage, link);
      positions[name] = limits(linkage, link);
    }
    json["full_turn"] = full_turn;
    json["limits"] = positions;
    json["transmission"] = Json();
    if (const auto range = transmission_range(linkage)) {
      json["transmission"] = {{"smallest", angle_.apply(range->smallest)},
                              {"at_smallest", angle_.apply(range->at_smallest)},
                              {"largest", angle_.apply(range->largest)},
                              {"at_largest", angle_.apply(range->at_largest)}};
    }
    return json;
  }

  [[nodiscard]] Json dead_centre(const DeadCentre& at) const {
    return {{"crank", angle_.apply(at.theta2)}, {"slider", length_.apply(at.r1)}};
  }

  // Of a slider-crank whose guide moves: its parts by the names that they have then.
  [[nodiscard]] Json quick_return_of(const SliderCrankInMechanism& loop) const {
    const bool turning = loop.inversion == SliderCrankInversion::kCrank;
    if (!turning && loop.inversion != SliderCrankInversion::kCoupler) {
      return nullptr;
    }
    const int crank = turning ? loop.coupler : loop.crank;
    const int lever = turning ? loop.guide : loop.slider;
    const double r1 = turning ? loop.linkage.r2 : loop.linkage.r3;
    const double r2 = turning ? loop.linkage.r3 : loop.linkage.r2;
    Json json = {{"frame", body(0)},
                 {"crank", body(crank)},
                 {"lever", lever < 0 ? Json() : Json(body(lever))},
                 {"ram", nullptr},
                 {"frame_length", length_.apply(r1)},
                 {"crank_length", length_.apply(r2)},
                 {"lever_turns", nullptr},
                 {"swing", nullptr},
                 {"time_ratio", nullptr}};
    if (const auto ram = ram_of(mechanism_, lever, crank)) {
      json["ram"] = body(*ram);
    }
    if (const auto result = quick_return({r1, r2, loop.linkage.r4, 0})) {
      json["lever_turns"] = result->lever_turns;
      json["swing"] = result->lever_turns ? Json() : Json(angle_.apply(result->swing));
      json["time_ratio"] = result->time_ratio;
    }
    return json;
  }

  [[nodiscard]] Json slider_crank(const SliderCrankInMechanism& loop) const {
    const SliderCrank& linkage = loop.linkage;
    Json json = {{"guide", body(loop.guide)},
                 {"crank", body(loop.crank)},
                 {"coupler", body(loop.coupler)},
                 {"slider", loop.slider < 0 ? Json() : Json(body(loop.slider))},
                 {"joint", joint(loop.joint)},
                 {"inversion", inversion_of(loop)},
                 {"r2", length_.apply(linkage.r2)},
                 {"r3", length_.apply(linkage.r3)},
                 {"offset", length_.apply(linkage.r4)},
                 {"stroke", nullptr},
                 {"harmonic", nullptr},
                 {"quick_return", quick_return_of(loop)}};
    const auto mode =
        findings_.mobility.assembled ? mode_of(loop, findings_.mobility.start.bodies) : AssemblyMode::kPlus;
    if (const auto stroke = slider_crank_stroke(linkage, mode)) {
      json["stroke"] = {{"length", length_.apply(stroke->length)},
                        {"time_ratio", stroke->time_ratio},
                        {"turn_in", angle_.apply(stroke->turn_in)},
                        {"outer", dead_centre(stroke->outer)},
                        {"inner", dead_centre(stroke->inner)}};
    }
    const bool central = std::abs(linkage.r4) <= 1e-12 * (linkage.r2 + linkage.r3);
    if (central && linkage.r2 < linkage.r3) {
      const HarmonicError error = harmonic_error(linkage.r2 / linkage.r3);
      json["harmonic"] = {
          {"position", error.x.error}, {"velocity", error.v.error}, {"acceleration", error.a.error}};
    }
    return json;
  }

  [[nodiscard]] Json centers() const {
    Json json = Json::array();
    for (const InstantCenter& center : instant_centers(findings_.mobility.moving, size_of(mechanism_))) {
      Json one = {{"bodies", {body(static_cast<int>(center.i)), body(static_cast<int>(center.j))}}};
      switch (center.kind) {
        case InstantCenterKind::kUndefined:
          one["kind"] = "undefined";
          break;
        case InstantCenterKind::kPoint:
          one["kind"] = "point";
          one["x"] = length_.apply(center.p_W.x());
          one["y"] = length_.apply(center.p_W.y());
          break;
        case InstantCenterKind::kAtInfinity:
          one["kind"] = "at_infinity";
          one["x"] = center.u_W.x();
          one["y"] = center.u_W.y();
          break;
      }
      json.push_back(one);
    }
    return json;
  }

  const MobilityFindings& findings_;
  const Mechanism& mechanism_;
  Scaling length_;
  Scaling angle_;
};

}  // namespace

nlohmann::ordered_json mobility_json(const MobilityFindings& findings) {
  return Writer(findings).all();
}

std::string mobility_csv(const MobilityFindings& findings) {
  std::string csv = "key,value\n";
  const nlohmann::ordered_json flat = mobility_json(findings).flatten();
  for (const auto& [path, value] : flat.items()) {
    std::string text = value.is_null() || value.empty() ? "" : text_of(value);
    if (value.is_string()) {
      text = value.get<std::string>();
      if (text.find_first_of(",\"\n") != std::string::npos) {
        for (std::size_t at = text.find('"'); at != std::string::npos; at = text.find('"', at + 2)) {
          text.insert(at, 1, '"');
        }
        text.insert(0, 1, '"');
        text += '"';
      }
    }
    csv += path.substr(1) + ',' + text + '\n';
  }
  return csv;
}

}  // namespace higherpair::cli

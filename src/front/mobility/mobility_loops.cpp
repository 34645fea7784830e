#include "front/tolerances.hpp"
#include "higherpair/linkage/four_bar_limits.hpp"
#include "higherpair/linkage/grashof.hpp"
#include "higherpair/linkage/piston.hpp"
#include "higherpair/linkage/quick_return.hpp"
#include "higherpair/linkage/slider_crank_stroke.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/mechanism/loops.hpp"
#include "mobility_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

using Json = nlohmann::ordered_json;

const char* inversion_of(const SliderCrankInMechanism& loop) {
  static constexpr std::array kNames = {"guide fixed", "crank fixed (turning guide)",
                                        "coupler fixed (rocking guide)", "on moving bodies"};
  static_assert(kNames.size() == static_cast<std::size_t>(SliderCrankInversion::kMoving) + 1);
  return kNames[static_cast<std::size_t>(loop.inversion)];
}

bool are_joined(const Mechanism& mechanism, int a, int b) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(),
                     [&](const Joint& joint) { return joins(joint, a, b); });
}

bool slides_on_ground(const Mechanism& mechanism, int body) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
    return joint.type == JointType::kPrismatic && joins(joint, kGround, body);
  });
}

// The ram: a body that slides on ground, joined to the lever directly or by one link; none if there is no
// such body.
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

class LoopWriter : public MobilityParts {
public:
  [[nodiscard]] Json four_bar(const FourBarInMechanism& loop) const {
    const FourBar& linkage = loop.linkage;
    Json json = {{"ground", body(loop.ground)},
                 {"crank", body(loop.crank)},
                 {"coupler", body(loop.coupler)},
                 {"rocker", body(loop.rocker)},
                 {"lengths",
                  {length.apply(linkage.r1), length.apply(linkage.r2), length.apply(linkage.r3),
                   length.apply(linkage.r4)}},
                 {"grashof", name_of(classify_grashof(linkage))},
                 {"margin", length.apply(grashof_margin(linkage))}};
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
      json["transmission"] = {{"smallest", angle.apply(range->smallest)},
                              {"at_smallest", angle.apply(range->at_smallest)},
                              {"largest", angle.apply(range->largest)},
                              {"at_largest", angle.apply(range->at_largest)}};
    }
    return json;
  }

  [[nodiscard]] Json slider_crank(const SliderCrankInMechanism& loop) const {
    const SliderCrank& linkage = loop.linkage;
    Json json = {{"guide", body(loop.guide)},
                 {"crank", body(loop.crank)},
                 {"coupler", body(loop.coupler)},
                 {"slider", loop.slider < 0 ? Json() : Json(body(loop.slider))},
                 {"joint", mechanism.joints[loop.joint].name},
                 {"inversion", inversion_of(loop)},
                 {"r2", length.apply(linkage.r2)},
                 {"r3", length.apply(linkage.r3)},
                 {"offset", length.apply(linkage.r4)},
                 {"stroke", nullptr},
                 {"harmonic", nullptr},
                 {"quick_return", quick_return_of(loop)}};
    const auto mode =
        findings.mobility.assembled ? mode_of(loop, findings.mobility.start) : AssemblyMode::kPlus;
    if (const auto stroke = slider_crank_stroke(linkage, mode)) {
      json["stroke"] = {{"length", length.apply(stroke->length)},
                        {"time_ratio", stroke->time_ratio},
                        {"turn_in", angle.apply(stroke->turn_in)},
                        {"outer", dead_centre(loop, stroke->outer)},
                        {"inner", dead_centre(loop, stroke->inner)}};
    }
    const bool central = std::abs(linkage.r4) <= kCentralOffset * (linkage.r2 + linkage.r3);
    if (central && linkage.r2 < linkage.r3) {
      const HarmonicError error = harmonic_error(linkage.r2 / linkage.r3);
      json["harmonic"] = {
          {"position", error.x.error}, {"velocity", error.v.error}, {"acceleration", error.a.error}};
    }
    return json;
  }

private:
  [[nodiscard]] Json limits(const FourBar& linkage, FourBarLink link) const {
    Json json = Json::array();
    for (const FourBarLimit& limit : four_bar_limits(linkage, link)) {
      json.push_back({{"crank", angle.apply(limit.theta2)},
                      {"coupler", angle.apply(limit.theta3)},
                      {"rocker", angle.apply(limit.theta4)},
                      {"change_point", limit.change_point}});
    }
    return json;
  }

  [[nodiscard]] Json dead_centre(const SliderCrankInMechanism& loop, const DeadCentre& at) const {
    return {{"crank", angle.apply(at.theta2)}, {"slider", length.apply(loop.at_foot + at.r1)}};
  }

  // A slider-crank whose guide moves as a quick-return mechanism, with the names its parts have there.
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
                 {"frame_length", length.apply(r1)},
                 {"crank_length", length.apply(r2)},
                 {"lever_turns", nullptr},
                 {"swing", nullptr},
                 {"time_ratio", nullptr}};
    if (const auto ram = ram_of(mechanism, lever, crank)) {
      json["ram"] = body(*ram);
    }
    if (const auto result = quick_return({r1, r2, loop.linkage.r4, 0})) {
      json["lever_turns"] = result->lever_turns;
      json["swing"] = result->lever_turns ? Json() : Json(angle.apply(result->swing));
      json["time_ratio"] = result->time_ratio;
    }
    return json;
  }
};

}  // namespace

Json four_bars_json(const MobilityFindings& findings) {
  Json json = Json::array();
  for (const FourBarInMechanism& loop : find_four_bars(findings.model.mechanism())) {
    json.push_back(LoopWriter{{findings}}.four_bar(loop));
  }
  return json;
}

Json slider_cranks_json(const MobilityFindings& findings) {
  Json json = Json::array();
  for (const SliderCrankInMechanism& loop : find_slider_cranks(findings.model.mechanism())) {
    json.push_back(LoopWriter{{findings}}.slider_crank(loop));
  }
  return json;
}

}  // namespace higherpair

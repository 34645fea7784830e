#include "front/columns/column_set.hpp"
#include "higherpair/linkage/instant_centers.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "higherpair/mechanism/pins.hpp"
#include "mobility_parts.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace higherpair {
namespace {

using Json = nlohmann::ordered_json;

const char* cause_of(const Redundancy& set) {
  static constexpr std::array kNames = {"same_pin",          "parallel_cranks", "rolling_on_pivots",
                                        "sliding_on_pivots", "slides_alone",    "member"};
  static_assert(kNames.size() == static_cast<std::size_t>(RedundancyCause::kMember) + 1);
  return kNames[static_cast<std::size_t>(set.cause)];
}

// Names and titles may quote a file that is not UTF-8.
std::string text_of_json(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

class MobilityJson : public MobilityParts {
public:
  [[nodiscard]] Json all() const {
    const Mobility& mobility = findings.mobility;
    const bool known = mobility.assembled;
    Json json;
    json["format"] = 1;
    json["title"] = mechanism.title;
    json["mobility"] = known ? Json(mobility.freedom) : Json();
    json["useful"] = known ? Json(mobility.useful()) : Json();
    json["count"] = count();
    json["rank"] = known ? rank() : Json();
    json["idle"] = idle();
    json["redundant"] = redundant();
    const bool structure = known && mobility.freedom == 0;
    json["structure"] =
        structure ? Json(mobility.rank < mobility.conditions ? "indeterminate" : "determinate") : Json();
    json["explanations"] = explanations(mechanism, mobility);
    json["drivers"] = known ? drivers() : Json();
    json["plan"] = plan();
    json["four_bars"] = four_bars_json(findings);
    json["slider_cranks"] = slider_cranks_json(findings);
    json["gears"] = gears_json(findings);
    json["instant_centers"] = centers();
    return json;
  }

private:
  template <class Items>
  [[nodiscard]] static Json names(const std::vector<int>& indices, const Items& items) {
    Json names = Json::array();
    for (const int index : indices) {
      names.push_back(items[index].name);
    }
    return names;
  }
  [[nodiscard]] Json bodies(const std::vector<int>& indices) const {
    return names(indices, mechanism.bodies);
  }
  [[nodiscard]] Json joints(const std::vector<int>& indices) const {
    return names(indices, mechanism.joints);
  }

  [[nodiscard]] Json count() const {
    const MobilityCount& count = findings.mobility.count;
    Json json = {
        {"bodies", count.bodies},        {"joints", count.joints()},     {"revolute", count.revolutes},
        {"prismatic", count.prismatics}, {"slot", count.slots},          {"slipping", count.slipping},
        {"rolling", count.rolling},      {"gears", count.gears},         {"belts", count.belts},
        {"sum_f", count.freedoms()},     {"mobility", count.mobility()}, {"formula", formula_text(count)},
        {"multiple_pins", Json::array()}};
    for (const Pin& pin : find_pins(mechanism)) {
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
    const Mobility& mobility = findings.mobility;
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
    const auto texts = idle_texts(mechanism, findings.mobility);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const IdleFreedom& idle = findings.mobility.idle[i];
      json.push_back({{"body", body(idle.body)},
                      {"x", length.apply(idle.p_W.x())},
                      {"y", length.apply(idle.p_W.y())},
                      {"text", texts[i]}});
    }
    return json;
  }

  [[nodiscard]] Json redundant() const {
    Json json = Json::array();
    for (const Redundancy& set : findings.mobility.redundancies) {
      json.push_back({{"conditions", set.conditions},
                      {"cause", cause_of(set)},
                      {"joints", joints(set.joints)},
                      {"contacts", names(set.contacts, mechanism.contacts)},
                      {"bodies", bodies(set.bodies)}});
    }
    return json;
  }

  [[nodiscard]] Json drivers() const {
    const Mobility& mobility = findings.mobility;
    std::vector<int> useless;
    for (const int driver : mobility.useless_drivers) {
      useless.push_back(mechanism.drivers[driver].joint);
    }
    const auto objection = driver_objection(mechanism, mobility);
    return {{"given", mechanism.drivers.size()},
            {"needed", mobility.useful()},
            {"missing", mobility.missing_drivers},
            {"useless", joints(useless)},
            {"joints_to_drive", joints(mobility.joints_to_drive)},
            {"loose_bodies", bodies(mobility.loose_bodies)},
            {"objection", objection ? Json(*objection) : Json()}};
  }

  [[nodiscard]] Json plan() const {
    Json json = Json::array();
    for (const PlanStep& step : findings.plan) {
      json.push_back({{"bodies", bodies(step.bodies)}, {"text", step.text}});
    }
    return json;
  }

  // Two bodies that are at rest against each other for a moment have the centre that their joint gives them
  // in every other moment.
  void set_by_joint(std::span<const Pin> pins, InstantCenter& center) const {
    const std::vector<BodyMotion>& moving = findings.mobility.moving;
    const auto is_on = [](const Pin& pin, std::size_t body) {
      return std::any_of(pin.ends.begin(), pin.ends.end(),
                         [&](const BodyPoint& end) { return end.body == static_cast<int>(body); });
    };
    const auto common = std::find_if(pins.begin(), pins.end(), [&](const Pin& pin) {
      return is_on(pin, center.i) && is_on(pin, center.j);
    });
    if (common != pins.end()) {
      const BodyPoint& end = common->ends.front();
      center.kind = InstantCenterKind::kPoint;
      center.p_W = moving[end.body].X_WB * end.p_B;
      return;
    }
    for (const Joint& joint : mechanism.joints) {
      if (joint.type == JointType::kPrismatic &&
          joins(joint, static_cast<int>(center.i), static_cast<int>(center.j))) {
        center.kind = InstantCenterKind::kAtInfinity;
        center.u_W = perp(Vector2d(moving[joint.first.body].X_WB.R_WB * joint.direction_A));
      }
    }
  }

  [[nodiscard]] Json centers() const {
    Json json = Json::array();
    const std::vector<Pin> pins = find_pins(mechanism);
    for (InstantCenter& center : instant_centers(findings.mobility.moving, size_of(mechanism))) {
      if (center.kind == InstantCenterKind::kUndefined) {
        set_by_joint(pins, center);
      }
      Json one = {{"bodies", {body(static_cast<int>(center.i)), body(static_cast<int>(center.j))}}};
      switch (center.kind) {
        case InstantCenterKind::kUndefined:
          one["kind"] = "undefined";
          break;
        case InstantCenterKind::kPoint:
          one["kind"] = "point";
          one["x"] = length.apply(center.p_W.x());
          one["y"] = length.apply(center.p_W.y());
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
};

}  // namespace

nlohmann::ordered_json json_of(const MobilityFindings& findings) {
  return MobilityJson{{findings}}.all();
}

std::string mobility_json(const MobilityFindings& findings) {
  return text_of_json(json_of(findings));
}

std::string mobility_csv(const MobilityFindings& findings) {
  std::string csv = "key,value\n";
  const nlohmann::ordered_json flat = json_of(findings).flatten();
  for (const auto& [path, value] : flat.items()) {
    csv += path.substr(1) + ',';
    if (value.is_string()) {
      append_csv_text(value.get_ref<const std::string&>(), csv);
    } else if (!value.is_null() && !value.empty()) {
      csv += text_of_json(value);
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace higherpair

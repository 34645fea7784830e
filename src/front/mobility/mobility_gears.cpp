#include "higherpair/dynamics/tooth_force.hpp"
#include "higherpair/geometry/gear_pair.hpp"
#include "mobility_parts.hpp"

#include <cmath>

#include <fmt/core.h>

namespace higherpair {
namespace {

using Json = nlohmann::ordered_json;

Json mesh_json(const InvoluteTooth& first, const InvoluteTooth& second, const Scaling& length) {
  const PathOfContact path = path_of_contact(close_pair(first, second));
  return {{"approach", length.apply(path.approach)},
          {"recess", length.apply(path.recess)},
          {"length", length.apply(path.length())},
          {"contact_ratio", path.ratio},
          {"past_base", {length.apply(path.past_base[0]), length.apply(path.past_base[1])}},
          {"least_teeth", least_teeth(first.pressure_angle)}};
}

Json gears_of(const MobilityFindings& findings, const Joint& joint) {
  const Mechanism& mechanism = findings.model.mechanism();
  const Scaling length = from_si(dimension::kLength, findings.model.units());
  const Scaling angle = from_si(dimension::kAngle, findings.model.units());
  const double distance = pitch_point(mechanism, joint, findings.mobility.start).distance;
  const double second = distance / std::abs(joint.turning_ratio - 1);
  const double first = second * std::abs(joint.turning_ratio);
  const GearTeeth& teeth = *joint.teeth;
  Json json = {{"joint", joint.name},
               {"first", mechanism.bodies[joint.first.body].name},
               {"second", mechanism.bodies[joint.second.body].name},
               {"pitch_radii", {length.apply(first), length.apply(second)}},
               {"pressure_angle", angle.apply(teeth.pressure_angle)},
               {"module", nullptr},
               {"teeth", nullptr},
               {"mesh", nullptr}};
  if (teeth.module == 0) {
    return json;
  }
  json["module"] = length.apply(teeth.module);
  const PairTeeth pair = teeth_of_pair(joint.turning_ratio, distance, teeth.module);
  if (pair.are_whole) {
    const double z1 = std::round(pair.first);
    const double z2 = std::round(pair.second);
    json["teeth"] = {static_cast<int>(z1), static_cast<int>(z2)};
    if (joint.turning_ratio < 0) {
      json["mesh"] = mesh_json({teeth.module, z1, teeth.pressure_angle, 0},
                               {teeth.module, z2, teeth.pressure_angle, 0}, length);
    }
  }
  return json;
}

std::string number_text(const Json& value) {
  return fmt::format("{:.7g}", value.get<double>());
}

std::string mesh_text(const Json& pair, const std::string& length) {
  const Json& mesh = pair["mesh"];
  std::string text = fmt::format("  contact ratio {}; path of contact {} {}: {} of approach, {} of recess\n",
                                 number_text(mesh["contact_ratio"]), number_text(mesh["length"]), length,
                                 number_text(mesh["approach"]), number_text(mesh["recess"]));
  for (const std::size_t i : {0U, 1U}) {
    const std::string own = pair[i == 0 ? "first" : "second"].get<std::string>();
    const std::string other = pair[i == 0 ? "second" : "first"].get<std::string>();
    if (mesh["past_base"][i].get<double>() > 0) {
      text += fmt::format("  interference: the tips of {} go {} {} past the base circle of {}\n", other,
                          number_text(mesh["past_base"][i]), length, own);
    }
    if (pair["teeth"][i].get<double>() < mesh["least_teeth"].get<double>()) {
      text +=
          fmt::format("  a rack undercuts the teeth of {}: fewer than {:.4f} are, without profile shift\n",
                      own, mesh["least_teeth"].get<double>());
    }
  }
  return text;
}

}  // namespace

nlohmann::ordered_json gears_json(const MobilityFindings& findings) {
  Json json = Json::array();
  for (const Joint& joint : findings.model.mechanism().joints) {
    if (joint.teeth && findings.mobility.assembled) {
      json.push_back(gears_of(findings, joint));
    }
  }
  return json;
}

std::string gears_text(const nlohmann::ordered_json& gears, const std::string& length_unit,
                       const std::string& angle_unit) {
  std::string text;
  for (const Json& pair : gears) {
    const auto teeth = [&](std::size_t i) {
      return pair["teeth"].is_null() ? "" : fmt::format(" with {} teeth", pair["teeth"][i].get<int>());
    };
    text += fmt::format("\nGears {}: {}{}, {}{}; pitch radii {} and {} {}, pressure angle {} {}\n",
                        pair["joint"].get<std::string>(), pair["first"].get<std::string>(), teeth(0),
                        pair["second"].get<std::string>(), teeth(1), number_text(pair["pitch_radii"][0]),
                        number_text(pair["pitch_radii"][1]), length_unit, number_text(pair["pressure_angle"]),
                        angle_unit);
    if (!pair["mesh"].is_null()) {
      text += mesh_text(pair, length_unit);
    }
  }
  return text;
}

}  // namespace higherpair

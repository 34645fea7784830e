#include "higherpair/geometry/gear_pair.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/pins.hpp"
#include "higherpair/mechanism/plan_text.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "higherpair/numeric/contains.hpp"
#include "io/tolerances.hpp"
#include "reading.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

bool is_same_point(const Vector2d& a, const Vector2d& b) {
  return (a - b).norm() <= kSameGearPoint * (a.norm() + b.norm());
}

std::optional<int> find_carrier(Reading& reading, const PendingGears& gears, const std::vector<Pin>& pins,
                                const Mechanism& mechanism) {
  const Joint& joint = mechanism.joints[gears.joint];
  const std::vector<int> common = carriers_of(mechanism, joint, pins);
  if (gears.carrier) {
    const auto named = as_body(reading, *gears.carrier, mechanism);
    if (named && !contains(common, *named)) {
      report(reading, *gears.carrier, "expected a body that carries both wheels on pins at these points");
    }
    return named;
  }
  if (common.size() == 1) {
    return common.front();
  }
  report(reading, gears.between,
         common.empty() ? "no body carries both wheels: expected revolute joints at these two points to one "
                          "body, the arm or ground"
                        : fmt::format("several bodies carry both wheels ({}): expected carrier = \"...\", "
                                      "the one that keeps them in mesh",
                                      names_of(mechanism.bodies, common)));
  return std::nullopt;
}

// The centre of a wheel's pin, in the frame of the carrier.
std::optional<Vector2d> center_on(int carrier, const std::vector<Pin>& pins, const Mechanism& mechanism,
                                  const PointRef& wheel) {
  const Vector2d& center_B = point_of(mechanism, wheel);
  for (const Pin& pin : pins) {
    const auto end_on = [&](int body) {
      return std::find_if(pin.ends.begin(), pin.ends.end(),
                          [&](const BodyPoint& end) { return end.body == body; });
    };
    const auto end = end_on(wheel.body);
    if (end != pin.ends.end() && is_same_point(end->p_B, center_B) && end_on(carrier) != pin.ends.end()) {
      return end_on(carrier)->p_B;
    }
  }
  return std::nullopt;
}

void check_teeth(Reading& reading, const PendingGears& gears, const std::vector<Pin>& pins,
                 const Mechanism& mechanism) {
  const Joint& joint = mechanism.joints[gears.joint];
  const auto first = center_on(joint.carrier, pins, mechanism, joint.first);
  const auto second = center_on(joint.carrier, pins, mechanism, joint.second);
  if (!first || !second || !reading.mistakes.empty()) {
    return;  // a point with a mistake is at 0
  }
  if (is_same_point(*first, *second)) {
    report(reading, gears.between,
           "both wheels turn about one point: their teeth cannot mesh, so leave `pressure_angle` and "
           "`module` out");
    return;
  }
  if (!gears.module || joint.teeth->module == 0) {
    return;
  }
  const PairTeeth teeth = teeth_of_pair(joint.turning_ratio, (*second - *first).norm(), joint.teeth->module);
  if (!teeth.are_whole) {
    reading.notes.push_back(
        {gears.module->value->mark,
         fmt::format("{}: makes wheels of {:.6g} and {:.6g} teeth; of a pair with profile shift give "
                     "`pressure_angle` as it is at the pitch circles, and no `module`",
                     path_of(reading, *gears.module), teeth.first, teeth.second)});
  }
}

}  // namespace

void read_teeth(TableReader& table, Joint& joint) {
  if (joint.type != JointType::kGears) {
    for (const char* key : {"pressure_angle", "module"}) {
      table.refuse(key, "is of the teeth of gears; a belt passes on its torque alone");
    }
    return;
  }
  Reading& reading = table.reading();
  const auto angle = table.take("pressure_angle");
  const auto module = table.take("module");
  if (!angle && !module) {
    return;
  }
  GearTeeth teeth;
  if (angle) {
    const auto quantity = as_quantity(reading, *angle, {dimension::kAngle, Sign::kPositive});
    teeth.pressure_angle = quantity ? quantity->si : teeth.pressure_angle;
    if (!(teeth.pressure_angle < kPi / 2)) {
      report(reading, *angle, "must be below 90 deg; that of most gears is 20 deg");
    }
  }
  if (module) {
    const auto quantity = as_quantity(reading, *module, {dimension::kLength, Sign::kPositive});
    teeth.module = quantity ? quantity->si : 0;
  }
  if (joint.turning_ratio == 1) {
    report(reading, angle ? *angle : *module,
           "gears in a ring of the same size have one centre, and no teeth that could mesh");
  }
  joint.teeth = teeth;
}

void read_ratio(TableReader& table, Joint& joint) {
  const auto item = table.need("ratio", "a number");
  const auto quantity =
      item ? as_quantity(table.reading(), *item, {dimension::kNumber, Sign::kPositive}) : std::nullopt;
  const double ratio = quantity ? quantity->value : 1;
  if (!(ratio >= 1 / kLargestGearRatio && ratio <= kLargestGearRatio)) {
    report(table.reading(), *item, kGearRatioRule);
  }
  const bool gears = joint.type == JointType::kGears;
  const bool same_sense = gears ? table.flag("internal", false) : !table.flag("crossed", false);
  joint.turning_ratio = same_sense ? ratio : -ratio;
}

void set_carriers(Reading& reading, const std::vector<PendingGears>& pending, Mechanism& mechanism) {
  if (pending.empty()) {
    return;
  }
  const std::vector<Pin> pins = find_pins(mechanism);
  for (const PendingGears& gears : pending) {
    const auto carrier = find_carrier(reading, gears, pins, mechanism);
    Joint& joint = mechanism.joints[gears.joint];
    joint.carrier = carrier.value_or(0);
    if (carrier && joint.teeth) {
      check_teeth(reading, gears, pins, mechanism);
    }
    const auto theta = [&](int body) {
      return mechanism.bodies[body].guess_theta - mechanism.bodies[joint.carrier].guess_theta;
    };
    joint.relative_angle = theta(joint.second.body) - joint.turning_ratio * theta(joint.first.body);
  }
}

}  // namespace higherpair::io_detail

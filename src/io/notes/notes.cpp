#include "higherpair/io/notes.hpp"

#include "higherpair/analysis/start_ranges.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/units.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "io/schedule/schedule_timing.hpp"
#include "io/tolerances.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair {
namespace {

struct Moved {
  std::string name;
  double by = 0;  // [m]
};

// The point or curve of a body that is farthest from its position in the pose.
Moved farthest(const Body& body, const Pose<double>& X_WB) {
  const Pose<double> posed = {Rotation<double>::from_angle(body.guess_theta), body.guess_p_WB};
  Moved moved;
  const auto add = [&](const std::string& name, const Vector2d& p_B) {
    const double by = (X_WB * p_B - posed * p_B).norm();
    moved = by > moved.by ? Moved{name, by} : moved;
  };
  for (const NamedPoint& point : body.points) {
    add(point.name, point.p_B);
  }
  for (const NamedCurve& curve : body.curves) {
    add(curve.name, is_conic(curve.curve) && curve.curve.q > 0 ? center(curve.curve) : curve.curve.vertex_B);
  }
  return moved;
}

bool is_driven_body(const Mechanism& mechanism, int body) {
  return std::any_of(mechanism.drivers.begin(), mechanism.drivers.end(),
                     [&](const Driver& driver) { return has_end_on(mechanism.joints[driver.joint], body); });
}

// Whether all bodies are described in the frame of ground, with no pose of their own: such a description need
// not be in the start position.
bool is_drawing(const Mechanism& mechanism) {
  return std::all_of(mechanism.bodies.begin(), mechanism.bodies.end(),
                     [](const Body& body) { return body.guess_p_WB.isZero(0) && body.guess_theta == 0; });
}

bool slides(const Mechanism& mechanism, int body) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
    return joint.type == JointType::kPrismatic && has_end_on(joint, body);
  });
}

// The size of the mechanism as it has been assembled.
double assembled_size(Mechanism mechanism, const std::vector<BodyMotion>& bodies) {
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    mechanism.bodies[i].guess_p_WB = bodies[i].X_WB.p_WB;
    mechanism.bodies[i].guess_theta = bodies[i].theta;
  }
  return size_of(mechanism);
}

// The number to change so that a driver starts elsewhere.
struct StartKey {
  std::string path;
  double shift = 0;  // to be added to the driver's first position, in its unit
};

StartKey start_key(const Profile& profile, std::size_t driver) {
  const std::string path = driver_path(profile.mechanism.drivers[driver]);
  if (profile.programs.empty()) {
    return {path + ".start"};
  }
  const DriverProgram& program = profile.programs[driver];
  if (!program.positions.empty()) {
    return {path + ".positions"};
  }
  if (!program.law) {
    return {path + ".start"};
  }
  const auto& laws = profile.mechanism.laws;
  const auto named = std::find_if(
      laws.begin(), laws.end(), [&](const NamedLaw& law) { return program.law_name == "laws." + law.name; });
  const bool has_start = named != laws.end() && !named->law.segments.empty() &&
                         named->law.segments.front().type != LawType::kPolynomial;
  return has_start ? StartKey{program.law_name + ".start",
                              (*program.law)(program.law->begin()) - (*program.law)(0.0)}
                   : StartKey{program.law_name + " at time 0"};
}

// "from 65.835 to 294.16": few digits, rounded so that they stay within the range; "180" for a range without
// width.
std::string rounded_inwards(double low, double high) {
  const double unit = high > low ? std::pow(10, std::floor(std::log10(high - low)) - 3) : 0;
  const auto inside = [&](double x) { return unit > 0 && x >= low && x <= high ? x : (low + high) / 2; };
  const std::string from = fmt::format("{:.12g}", inside(std::ceil(low / unit) * unit));
  const std::string to = fmt::format("{:.12g}", inside(std::floor(high / unit) * unit));
  return from == to ? from : fmt::format("from {} to {}", from, to);
}

}  // namespace

Diagnostics start_notes(const Profile& profile, const std::vector<BodyMotion>& bodies) {
  const Mechanism& mechanism = profile.mechanism;
  Diagnostics notes;
  if (is_drawing(mechanism)) {
    return notes;
  }
  const double assembled = assembled_size(mechanism, bodies);
  const double posed = size_of(mechanism);
  const auto length = [&](double metres) { return with_unit(metres, dimension::kLength, profile.units, 4); };
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    const Moved moved = farthest(body, bodies[i].X_WB);
    // Wrong poses make the size too large. But the pose of a body that slides, such as a follower, may well
    // be elsewhere on its guide.
    const double size = slides(mechanism, static_cast<int>(i)) ? std::max(assembled, posed) : assembled;
    const double turned = std::abs(nearest_turn(bodies[i].theta - body.guess_theta, 0));
    const std::string far =
        moved.by > kFarFromPose * size
            ? fmt::format("{} is {} from where the pose has it at the start, in a mechanism of {}",
                          moved.name, length(moved.by), length(size))
        : turned > kTurnedFromPose ? fmt::format("is turned by {} from its pose at the start",
                                                 with_unit(turned, dimension::kAngle, profile.units, 4))
                                   : "";
    if (!far.empty() && !is_driven_body(mechanism, static_cast<int>(i))) {
      notes.push_back(
          about(profile.source,
                fmt::format("bodies.{}: {}; is that the assembly that is meant? Else give a better pose",
                            body.name, far)));
    }
  }
  return notes;
}

Diagnostics untouched_notes(const Profile& profile, const std::vector<std::size_t>& contacts) {
  Diagnostics notes;
  for (const std::size_t i : contacts) {
    notes.push_back(about(
        profile.source, fmt::format("contacts.{}: the two bodies touch nowhere on the path, so that it moves "
                                    "nothing; check their dimensions and poses, and the driver's range",
                                    profile.mechanism.contacts[i].name)));
  }
  return notes;
}

Diagnostics direction_notes(const Profile& profile, const DriverSchedule& schedule) {
  const Mechanism& mechanism = profile.mechanism;
  Diagnostics notes;
  if (schedule.is_timed() || schedule.is_listed()) {
    return notes;
  }
  for (std::size_t i = 0; i < profile.programs.size(); ++i) {
    const double velocity = profile.programs[i].velocity;
    const double from = schedule.state(0, i).profile.position;
    const double to = schedule.state(schedule.size() - 1, i).profile.position;
    if (!((to - from) * velocity < 0)) {
      continue;
    }
    const Dimension position = driver_dimension(mechanism, i);
    const bool is_default =
        velocity == default_program(mechanism, mechanism.drivers[i], profile.units).velocity;
    notes.push_back(io_detail::mistake(
        profile, i, "velocity",
        fmt::format(
            "is {:.6g} {}{}, but the rows go from {:.6g} to {:.6g} {}: rates are those of the motion in "
            "the other direction; {} velocity = {:.6g}",
            velocity, unit_text(rate_of(position), profile.units), is_default ? ", the default" : "", from,
            to, unit_text(position, profile.units), is_default ? "give" : "exchange start and end, or set",
            -velocity)));
  }
  return notes;
}

std::string start_advice(const Profile& profile, const std::vector<double>& drivers, double tolerance,
                         const std::atomic<bool>* stop) {
  const Mechanism& mechanism = profile.mechanism;
  const auto ranges = find_start_ranges(mechanism, drivers, tolerance, stop);
  if (!ranges) {
    return "";
  }
  const StartKey key = start_key(profile, 0);
  if (ranges->empty()) {
    return fmt::format("; it is possible with no other {} that was tried", key.path);
  }
  const Dimension dimension = driver_dimension(mechanism);
  const Scaling scaling = from_si(dimension, profile.units);
  std::string text;
  for (const StartRange& range : *ranges) {
    text += (text.empty() ? "" : " or ") +
            rounded_inwards(scaling.apply(range.low) + key.shift, scaling.apply(range.high) + key.shift);
  }
  return fmt::format("; it is possible, for example, with {} {} {}", key.path, text,
                     unit_text(dimension, profile.units));
}

}  // namespace higherpair

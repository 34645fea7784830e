#include "inputs.hpp"

#include "analysis/tolerances.hpp"
#include "higherpair/contact/step_length.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace higherpair {
namespace {

// The longest inner step of a driver [rad or m].
double longest_step_of(const Run& run, std::size_t driver) {
  const bool turns = driven_joint(run.mechanism(), driver).type == JointType::kRevolute;
  return turns ? kLargestTurn : kLargestSlide * driver_scale(run, driver);
}

// The breaks before and after a time.
std::array<double, 2> piece_at(const DriverCurve& curve, double time) {
  const auto next = std::upper_bound(curve.breaks.begin() + 1, curve.breaks.end() - 1, time);
  return {next[-1], *next};
}

// The fraction of the path from the row before to this one at which the inputs are.
double share_of(const Run& run, const std::vector<double>& inputs) {
  const std::vector<double>& from = run.work.row_before;
  const std::vector<double>& to = run.at.targets;
  const std::size_t leading = leading_input(run, from, to);
  const double whole = to[leading] - from[leading];
  return whole == 0 ? 1 : (inputs[leading] - from[leading]) / whole;
}

}  // namespace

void set_path(const Run& run, Path& path, const std::vector<double>& from, const std::vector<double>& to) {
  path.from.resize(from.size());
  path.to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {  // a few numbers: a loop costs less than copying blocks
    path.from[i] = from[i];
    path.to[i] = to[i];
  }
  path.length = path.is_single() ? to[0] - from[0] : from == to ? 0 : 1;
  path.share_from = 0;
  path.share_to = 1;
  if (path.curve != run.at.curve) {
    path.curve = run.at.curve;
  }
  path.is_chord = false;
  if (path.curve) {
    path.piece = piece_at(*path.curve, std::midpoint(from[0], to[0]));
  }
}

void set_part(const Run& run, Path& part, const std::vector<double>& from, const std::vector<double>& to) {
  set_path(run, part, from, to);
  part.share_from = share_of(run, from);
  part.share_to = share_of(run, to);
}

Path part_of_path(const Run& run, const std::vector<double>& from, const std::vector<double>& to) {
  Path path;
  set_part(run, path, from, to);
  return path;
}

double share_at(const Path& path, double s) {
  return std::lerp(path.share_from, path.share_to, path.length == 0 ? 1 : s / path.length);
}

void Path::inputs(double s, std::vector<double>& out) const {
  out.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    out[i] = s == length ? to[i] : from[i] + s * (is_single() ? 1 : to[i] - from[i]);
  }
}

void Path::motions(double s, std::vector<DriverMotion>& out) const {
  if (curve) {
    out.resize(curve->greatest_speeds.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = on_curve(s, i);
    }
    return;
  }
  out.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double rate = is_single() ? 1 : to[i] - from[i];
    out[i] = {s == length ? to[i] : from[i] + s * rate, rate, 0};
  }
}

// Beyond its piece the drivers go on with the accelerations at the end of it: what is looked for right ahead
// may not depend on a jump of their rates there.
DriverMotion Path::on_curve(double s, std::size_t driver) const {
  if (is_chord) {
    const double a = curve->motion(driver, from[0]).position, b = curve->motion(driver, to[0]).position;
    return {std::lerp(a, b, s / length), (b - a) / length, 0};
  }
  const double time = s == length ? to[0] : from[0] + s;
  const auto [begin, end] = piece;
  const double near = kTimeRounding * std::max(std::abs(end), end - begin);
  const double within = std::clamp(time, begin + near, end - near);
  DriverMotion motion = curve->motion(driver, within);
  const double rest = time - within;
  motion.position += rest * (motion.velocity + rest / 2 * motion.acceleration);
  motion.velocity += rest * motion.acceleration;
  return motion;
}

double driver_scale(const Run& run, std::size_t driver) {
  return driven_joint(run.mechanism(), driver).type == JointType::kRevolute ? 1 : run.plan().size;
}

double input_scale(const Run& run, std::size_t input) {
  return run.at.curve ? run.at.time_unit : driver_scale(run, input);
}

std::size_t leading_input(const Run& run, const std::vector<double>& from, const std::vector<double>& to) {
  const auto moved = [&](std::size_t i) { return std::abs(to[i] - from[i]) / input_scale(run, i); };
  std::size_t leading = 0;
  for (std::size_t i = 1; i < to.size(); ++i) {
    leading = moved(i) > moved(leading) ? i : leading;
  }
  return leading;
}

double distance_between(const Run& run, const std::vector<double>& from, const std::vector<double>& to) {
  const std::size_t i = leading_input(run, from, to);
  return std::abs(to[i] - from[i]) / input_scale(run, i);
}

double unit_of(const Run& run, const Path& path) {
  return path.is_single() ? input_scale(run, 0) : 1 / distance_between(run, path.from, path.to);
}

double size_at(const Run& run, const Path& path, double s) {
  if (path.is_single()) {
    return std::abs(path.from[0] + s);
  }
  double largest = 0;
  for (std::size_t i = 0; i < path.from.size(); ++i) {
    largest = std::max(largest, std::abs(std::lerp(path.from[i], path.to[i], s)) / driver_scale(run, i));
  }
  return largest * unit_of(run, path);
}

double least_steps(const Run& run, const Path& path) {
  double steps = 1;
  for (std::size_t i = 0; i < run.mechanism().drivers.size(); ++i) {
    const double way = path.curve ? std::abs(path.length) * path.curve->greatest_speeds[i]
                                  : std::abs(path.to[i] - path.from[i]);
    steps = std::max(steps, way / longest_step_of(run, i));
  }
  return steps;
}

void set_unit_motions(const Run& run, const std::vector<double>& inputs, std::vector<DriverMotion>& motions) {
  motions.resize(run.mechanism().drivers.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    motions[i] = run.at.curve ? run.at.curve->motion(i, inputs[0])
                              : DriverMotion{inputs[i], motions.size() == 1 ? 1.0 : 0.0, 0};
  }
}

bool enter_curve(Run& run, const std::shared_ptr<const DriverCurve>& curve, double time) {
  if (run.at.curve || !run.at.on_branch || run.at.beside || run.at.inputs != run.at.targets) {
    return false;
  }
  double pace = 0;
  for (std::size_t i = 0; i < curve->greatest_speeds.size(); ++i) {
    pace = std::max(pace, curve->greatest_speeds[i] / driver_scale(run, i));
  }
  run.at.curve = curve;
  run.at.time_unit = 1 / pace;
  run.at.inputs = {time};
  run.at.targets = {time};
  return true;
}

void leave_curve(Run& run) {
  for (std::vector<double>* inputs :
       {&run.at.inputs, &run.at.targets, &run.at.lost.from, &run.at.lost.at, &run.work.row_before}) {
    if (inputs->empty()) {
      continue;
    }
    std::vector<DriverMotion> motions;
    set_unit_motions(run, *inputs, motions);
    inputs->clear();
    for (const DriverMotion& motion : motions) {
      inputs->push_back(motion.position);
    }
  }
  run.at.lost.looked_to.reset();
  run.at.lost.other.reset();
  run.at.curve.reset();
}

}  // namespace higherpair

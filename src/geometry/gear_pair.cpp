#include "higherpair/geometry/gear_pair.hpp"

#include "higherpair/geometry/tolerances.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace higherpair {
namespace {

double pitch_radius(const InvoluteTooth& tooth) {
  return tooth.module * tooth.teeth / 2;
}

double tip_radius(const InvoluteTooth& tooth) {
  return pitch_radius(tooth) + (1 + tooth.profile_shift) * tooth.module;
}

// Distance along the line of action from its point on the base circle to the tip circle.
double reach_of_tip(const InvoluteTooth& tooth) {
  const double base = base_radius(tooth);
  return std::sqrt(std::max(0.0, (tip_radius(tooth) - base) * (tip_radius(tooth) + base)));
}

// Thickness of a tooth at the radius at which the pressure angle is α_w.
double thickness(const InvoluteTooth& tooth, double alpha_w) {
  return 2 * base_radius(tooth) / std::cos(alpha_w) *
         (half_angle_at_base(tooth) - involute_function(alpha_w));
}

}  // namespace

double involute_function(double pressure_angle) {
  return std::tan(pressure_angle) - pressure_angle;
}

// inv α is convex and increasing, so that from above Newton's method approaches the root without passing it.
// Bounds from above follow from α³/3 <= inv α and tan α - π/2 <= inv α.
double inverse_involute(double value) {
  assert(value >= 0);
  double alpha = std::min(std::cbrt(3 * value), std::atan(value + kPi / 2));
  constexpr int kMost = 50;
  for (int i = 0; i < kMost && alpha > 0; ++i) {
    const double tangent = std::tan(alpha);
    const double step = (tangent - alpha - value) / (tangent * tangent);
    alpha -= step;
    if (!(std::abs(step) > kInvoluteSettled * alpha)) {
      break;
    }
  }
  return alpha;
}

double least_teeth(double pressure_angle) {
  const double sine = std::sin(pressure_angle);
  return 2 / (sine * sine);
}

GearPair close_pair(const InvoluteTooth& first, const InvoluteTooth& second) {
  const double alpha = first.pressure_angle;
  const double shift = first.profile_shift + second.profile_shift;
  const double involute =
      involute_function(alpha) + 2 * std::tan(alpha) * shift / (first.teeth + second.teeth);
  const double alpha_w = shift == 0 ? alpha : inverse_involute(std::max(0.0, involute));
  return {first, second, (base_radius(first) + base_radius(second)) / std::cos(alpha_w)};
}

double working_pressure_angle(const GearPair& pair) {
  return std::acos(std::min(1.0, (base_radius(pair.first) + base_radius(pair.second)) / pair.distance));
}

PathOfContact path_of_contact(const GearPair& pair) {
  const double tangent = std::tan(working_pressure_angle(pair));
  const double base1 = base_radius(pair.first) * tangent;  // from the pitch point to the base points
  const double base2 = base_radius(pair.second) * tangent;
  PathOfContact path;
  path.approach = reach_of_tip(pair.second) - base2;
  path.recess = reach_of_tip(pair.first) - base1;
  path.ratio = path.length() / (kPi * pair.first.module * std::cos(pair.first.pressure_angle));
  path.past_base = {path.approach - base1, path.recess - base2};
  return path;
}

double backlash(const GearPair& pair) {
  const double alpha_w = working_pressure_angle(pair);
  const double pitch = 2 * kPi * base_radius(pair.first) / std::cos(alpha_w) / pair.first.teeth;
  return pitch - thickness(pair.first, alpha_w) - thickness(pair.second, alpha_w);
}

PairTeeth teeth_of_pair(double turning_ratio, double distance, double module) {
  const double second = 2 * distance / std::abs(turning_ratio - 1) / module;
  const double first = second * std::abs(turning_ratio);
  const auto is_whole = [](double z) { return std::abs(z - std::round(z)) <= kWholeTooth; };
  return {first, second, is_whole(first) && is_whole(second)};
}

}  // namespace higherpair

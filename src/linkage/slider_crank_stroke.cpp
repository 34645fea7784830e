#include "higherpair/linkage/slider_crank_stroke.hpp"

#include "higherpair/geometry/pose.hpp"
#include "higherpair/linkage/angles.hpp"
#include "higherpair/linkage/reach.hpp"

#include <cassert>

namespace higherpair {

std::optional<SliderCrankStroke> slider_crank_stroke(const SliderCrank& linkage, AssemblyMode mode) {
  const double r2 = linkage.r2, r3 = linkage.r3, r4 = linkage.r4;
  assert(r2 > 0 && r3 > 0);
  if (!(balance(r3, -r2, -std::abs(r4), 0.0) > 0)) return std::nullopt;

  const auto coordinate = [&](double distance) {
    return sign(mode) * std::sqrt((distance - r4) * (distance + r4));
  };
  const Vector2d outer(coordinate(r3 + r2), r4);
  const Vector2d inner(coordinate(r3 - r2), r4);

  SliderCrankStroke stroke;
  stroke.outer = {principal_angle(linkage.theta1 + angle_of(outer)), outer.x()};
  // Folded, the crank points away from the slider.
  stroke.inner = {principal_angle(linkage.theta1 + angle_of(-inner)), inner.x()};
  stroke.length = 4 * r2 * r3 / (std::abs(outer.x()) + std::abs(inner.x()));
  const double skew = angle_from_to(outer, inner);
  stroke.turn_in = kPi + skew;
  stroke.time_ratio = (kPi + std::abs(skew)) / (kPi - std::abs(skew));
  return stroke;
}

}  // namespace higherpair

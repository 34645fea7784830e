#include "higherpair/linkage/angles.hpp"

namespace higherpair {

double absolute_angle(const Rotation<double>& u, double reference) {
  return principal_angle(std::atan2(u.sin, u.cos) + reference);
}

double root_angle(const CosineLine<double>& line) {
  return 2 * std::atan2(std::sqrt(std::abs(line.at_0)), std::sqrt(std::abs(line.at_pi)));
}

}  // namespace higherpair

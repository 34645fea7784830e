#include "higherpair/linkage/four_bar_limits.hpp"

#include "higherpair/linkage/angles.hpp"
#include "higherpair/linkage/rrr_dyad.hpp"

#include <array>
#include <cassert>
#include <cmath>

namespace higherpair {
namespace {

/// Links 2, 3, 4 are indices 0, 1, 2.
struct Triangle {
  std::size_t X = 0;
  std::size_t Y = 0;
  std::size_t Z = 0;
  double side = 1;  ///< u_Z = side u_Y
};

/// (a + b)² - r1² and r1² - (a - b)² with a = |w_Y + side w_Z|, b = |w_X|; exactly zero at a change point.
Reach<double> reach_of(double r1, double w_Y, double w_Z, double b) {
  return {balance(w_Y, w_Z, b, -r1) * balance(w_Y, w_Z, b, r1),
          balance(r1, -w_Y, -w_Z, b) * balance(r1, w_Y, w_Z, -b), 0};
}

FourBarLimit limit_at(const Triangle& triangle, const std::array<Rotation<double>, 3>& u, double theta1) {
  FourBarLimit limit;
  limit.theta2 = absolute_angle(u[0], theta1);
  limit.theta3 = absolute_angle(u[1], theta1);
  limit.theta4 = absolute_angle(u[2], theta1);
  limit.same_direction = triangle.side > 0;
  const double sine = u[2].cos * u[1].sin - u[2].sin * u[1].cos;
  const bool crank = triangle.X == 0;
  limit.mode = crank || sine >= 0 ? AssemblyMode::kPlus : AssemblyMode::kMinus;
  return limit;
}

Rotation<double> times(double sign, const Rotation<double>& u) {
  return {sign * u.cos, sign * u.sin};
}

/// Where Y and Z cancel each other, X lies on the ground link while they swing together: a branch of its own,
/// which meets the others where all links are in line.
std::vector<FourBarLimit> limits_of_folded(const FourBar& linkage, const Triangle& triangle, double w_X) {
  std::vector<FourBarLimit> limits;
  if (balance(linkage.r1, -std::abs(w_X), 0.0, 0.0) != 0) return limits;
  for (const double sense : {1.0, -1.0}) {
    std::array<Rotation<double>, 3> u;
    u[triangle.X] = {w_X > 0 ? 1.0 : -1.0, 0};
    u[triangle.Y] = {sense, 0};
    u[triangle.Z] = {triangle.side * sense, 0};
    limits.push_back(limit_at(triangle, u, linkage.theta1));
    limits.back().change_point = true;
  }
  return limits;
}

/// Positions of the closed triangle: one on each side of the ground link, or one in line with it.
std::vector<FourBarLimit> limits_of(const FourBar& linkage, const Triangle& triangle) {
  const std::array<double, 3> w{linkage.r2, linkage.r3, -linkage.r4};
  const double sum = balance(w[triangle.Y], triangle.side * w[triangle.Z], 0.0, 0.0);
  if (sum == 0) return limits_of_folded(linkage, triangle, w[triangle.X]);
  const double sign_Y = sum > 0 ? 1 : -1;
  const double sign_X = w[triangle.X] > 0 ? 1 : -1;
  const double b = std::abs(w[triangle.X]);
  const Reach<double> reach =
      reach_of(linkage.r1, sign_Y * w[triangle.Y], sign_Y * triangle.side * w[triangle.Z], b);
  if (!(reach.slack() >= 0)) return {};

  std::vector<FourBarLimit> limits;
  const bool in_line = reach.slack() == 0;
  for (const double sigma : {1.0, -1.0}) {
    if (in_line && sigma < 0) break;
    const RrrPosition<double> position =
        rrr_position(Vector2d(linkage.r1, 0), std::abs(sum), b, reach, sigma);
    std::array<Rotation<double>, 3> u;
    u[triangle.Y] = times(sign_Y, position.u_a);
    u[triangle.Z] = times(triangle.side, u[triangle.Y]);
    u[triangle.X] = times(-sign_X, position.u_b);
    limits.push_back(limit_at(triangle, u, linkage.theta1));
    limits.back().change_point = in_line;
  }
  return limits;
}

}  // namespace

std::vector<FourBarLimit> four_bar_limits(const FourBar& linkage, FourBarLink link) {
  assert(linkage.r1 > 0 && linkage.r2 > 0 && linkage.r3 > 0 && linkage.r4 > 0);
  assert(link != FourBarLink::kFrame);
  const std::size_t X = static_cast<std::size_t>(link) - 2;
  std::vector<FourBarLimit> limits;
  for (const double side : {1.0, -1.0}) {
    const std::vector<FourBarLimit> more = limits_of(linkage, {X, (X + 1) % 3, (X + 2) % 3, side});
    limits.insert(limits.end(), more.begin(), more.end());
  }
  return limits;
}

}  // namespace higherpair

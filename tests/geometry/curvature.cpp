#include "geometry/curvature.hpp"

#include <cassert>
#include <cmath>

namespace higherpair {
namespace {

Vector2d gradient(const std::array<double, 6>& k, const Vector2d& p) {
  return {2 * k[0] * p.x() + k[2] * p.y() + k[3], 2 * k[1] * p.y() + k[2] * p.x() + k[4]};
}

CurvePointShape shape(const Vector2d& p, const Vector2d& n, double kappa) {
  return {n, kappa, kappa == 0 ? p : Vector2d(p - n / kappa)};
}

}  // namespace

CurvePointShape shape_by_slope(const std::array<double, 6>& k, const Vector2d& p) {
  const Vector2d grad = gradient(k, p);
  assert(grad.norm() > 0);
  const bool steep = std::abs(grad.x()) > std::abs(grad.y());
  // As y(x) or, where steep, as x(y): then A and B, and D and E, are exchanged.
  const double f_along = steep ? grad.y() : grad.x();
  const double f_across = steep ? grad.x() : grad.y();
  const double square_along = steep ? k[1] : k[0];
  const double square_across = steep ? k[0] : k[1];
  const double slope = -f_along / f_across;
  const double second = -((2 * square_across * slope + 2 * k[2]) * slope + 2 * square_along) / f_across;
  const double length = std::hypot(1.0, slope);
  // The body lies on the side of -∇f: a curve that bends to that side (y'' against f_across) is convex.
  const double kappa = std::copysign(1.0, f_across) * -second / (length * length * length);
  return shape(p, grad.normalized(), kappa);
}

CurvePointShape shape_by_gradient(const std::array<double, 6>& k, const Vector2d& p) {
  const Vector2d grad = gradient(k, p);
  const double length = grad.norm();
  assert(length > 0);
  const Vector2d n = grad / length;
  const double bending = 2 * (k[0] * n.y() * n.y() - k[2] * n.x() * n.y() + k[1] * n.x() * n.x());
  return shape(p, n, bending / length);
}

}  // namespace higherpair

#include "higherpair/geometry/arc_length.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace higherpair {
namespace {

// The series of R_F and R_D for nearly equal arguments, about their means (DLMF 19.36.1, 19.36.2).
double rf_series(double x, double y, double z) {
  const double mean = (x + y + z) / 3;
  const double X = 1 - x / mean;
  const double Y = 1 - y / mean;
  const double Z = -X - Y;
  const double E2 = X * Y - Z * Z;
  const double E3 = X * Y * Z;
  const double series = 1 - E2 / 10 + E3 / 14 + E2 * E2 / 24 - 3 * E2 * E3 / 44 - 5 * E2 * E2 * E2 / 208 +
                        3 * E3 * E3 / 104 + E2 * E2 * E3 / 16;
  return series / std::sqrt(mean);
}

double rd_series(double x, double y, double z) {
  const double mean = (x + y + 3 * z) / 5;
  const double X = 1 - x / mean;
  const double Y = 1 - y / mean;
  const double Z = -(X + Y) / 3;
  const double XY = X * Y;
  const double E2 = XY - 6 * Z * Z;
  const double E3 = (3 * XY - 8 * Z * Z) * Z;
  const double E4 = 3 * (XY - Z * Z) * Z * Z;
  const double E5 = XY * Z * Z * Z;
  const double series = 1 - 3 * E2 / 14 + E3 / 6 + 9 * E2 * E2 / 88 - 3 * E4 / 22 - 9 * E2 * E3 / 52 +
                        3 * E5 / 26 - E2 * E2 * E2 / 16 + 3 * E3 * E3 / 40 + 3 * E2 * E4 / 20 +
                        45 * E2 * E2 * E3 / 272 - 9 * (E3 * E4 + E2 * E5) / 68;
  return series / (mean * std::sqrt(mean));
}

struct Carlson {
  double rf;
  double rd;
};

// R_F(x, y, z) and R_D(x, y, z) by duplication (DLMF 19.26.18, 19.26.20), which takes the same square roots
// for both, until the arguments differ by 1 %: what the series leave out is below 1e-16 then. \pre x >= 0; y,
// z > 0
Carlson carlson(double x, double y, double z) {
  constexpr double kNearlyEqual = 0.01;
  double sum = 0;
  double quarter_power = 1;
  while (std::max({x, y, z}) - std::min({x, y, z}) > kNearlyEqual * std::max({x, y, z})) {
    const double root_x = std::sqrt(x);
    const double root_y = std::sqrt(y);
    const double root_z = std::sqrt(z);
    const double lambda = root_x * root_y + (root_x + root_y) * root_z;
    sum += quarter_power / (root_z * (z + lambda));
    quarter_power /= 4;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
  }
  return {rf_series(x, y, z), 3 * sum + quarter_power * rd_series(x, y, z)};
}

// To the normal turned by the angle of cosine c and sine s, |angle| <= π/2.
double arc_from_vertex(const Curve& curve, double c, double s) {
  const double w2 = c * c + curve.q * s * s;
  assert(w2 > 0);
  const auto [rf, rd] = carlson(c * c, 1, w2);
  return curve.semi_latus * s * (rf + (1 - curve.q) / 3 * s * s * rd);
}

}  // namespace

double arc_length(const Curve& curve, double psi) {
  if (!is_conic(curve)) {
    return 0;
  }
  if (curve.kind == CurveKind::kCircle) {
    return curve.semi_latus * psi;
  }
  if (curve.q <= 0) {
    return arc_from_vertex(curve, std::cos(psi), std::sin(psi));
  }
  // Half turns are left to cos and sin, which know all digits of π: at its tips a thin ellipse makes a length
  // of a rounding of the angle.
  double half_turns = std::round(psi / kPi);
  const double sign = std::fmod(half_turns, 2) == 0 ? 1 : -1;
  const double c = sign * std::cos(psi);
  double s = sign * std::sin(psi);
  if (c < 0) {
    half_turns += s > 0 ? 1 : -1;
    s = -s;
  }
  const double arc = arc_from_vertex(curve, c, s);
  return half_turns == 0 ? arc : arc + 2 * half_turns * arc_from_vertex(curve, 0, 1);
}

double vertex_normal_angle(const Curve& curve) {
  return angle_of(-curve.axis_B);
}

}  // namespace higherpair

// Any six coefficients give a curve or an error. All parameters of a curve are finite, and its vertex
// satisfies its own implicit equation.
#include "higherpair/geometry/curve.hpp"
#include "target.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace {

using namespace higherpair;

void check(const Curve& curve) {
  const bool sound = curve.vertex_B.allFinite() && std::abs(curve.axis_B.norm() - 1) < 1e-12 &&
                     curve.semi_latus > 0 && std::isfinite(curve.semi_latus) && curve.q <= 1;
  if (!sound) {
    std::abort();
  }
  const auto k = implicit_coefficients(curve);
  const double x = curve.vertex_B.x();
  const double y = curve.vertex_B.y();
  // The quadratic coefficients share the rounding error of the largest of them.
  double terms = std::max({std::abs(k[0]), std::abs(k[1]), std::abs(k[2])}) * (x * x + y * y);
  double value = 0;
  for (const double term : {k[0] * x * x, k[1] * y * y, k[2] * x * y, k[3] * x, k[4] * y, k[5]}) {
    value += term;
    terms += std::abs(term);
  }
  const double tolerance = 1e-12 * terms + std::numeric_limits<double>::min();  // digits are lost below that
  if (!(std::abs(value) <= tolerance) && std::isfinite(terms)) {
    std::abort();
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Eight numbers in machine representation (the coefficients and a point near the branch), then the side.
  double numbers[8] = {};
  if (size < sizeof numbers) {
    return 0;
  }
  std::memcpy(numbers, data, sizeof numbers);
  const Side side = size > sizeof numbers && data[sizeof numbers] % 2 != 0 ? Side::kOutside : Side::kInside;
  std::array<double, 6> coefficients{};
  std::copy_n(numbers, 6, coefficients.begin());
  const Vector2d near(numbers[6], numbers[7]);
  for (const auto& curve :
       {make_conic(coefficients, side, near), make_conic(coefficients, side, std::nullopt)}) {
    if (curve) {
      check(*curve);
    }
  }
  return 0;
}

#pragma once

#include <cmath>

namespace higherpair::io_detail {

/// A number as the unevaluated sum high + low with |low| <= ulp(high)/2: about 32 decimal digits. Code that
/// uses it is compiled without contraction of a*b + c (fused multiply-add), which would undo the error terms.
struct DoubleDouble {
  double high = 0;
  double low = 0;
};

/// a + b for |a| >= |b|, exactly.
[[nodiscard]] inline DoubleDouble ordered_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b, exactly.
[[nodiscard]] inline DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a b, exactly.
[[nodiscard]] inline DoubleDouble exact_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

[[nodiscard]] inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = exact_product(a.high, b.high);
  return ordered_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

[[nodiscard]] inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double quotient = a.high / b.high;
  const DoubleDouble product = exact_product(quotient, b.high);
  const double rest = ((a.high - product.high) - product.low) + (a.low - quotient * b.low);
  return ordered_sum(quotient, rest / b.high);
}

}  // namespace higherpair::io_detail

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

/// An axis from `low` to `high` and where its ticks are: at multiples of a round step.
struct Ticks {
  double low = 0;
  double high = 1;
  double step = 1;
  int exponent = 0;            ///< labels show values divided by 10^exponent
  std::vector<double> values;  ///< within the axis
  [[nodiscard]] std::string label(double value) const;
};

/// Ticks from `low` to `high` at steps of 1, 2 or 5 times a power of ten; at those of a circle (15, 30, 45,
/// 90, 180, 360) where the unit is deg and the span is long enough.
/// \param most  number of steps, >= 1
/// \pre low < high, both finite
[[nodiscard]] Ticks make_ticks(double low, double high, std::string_view unit, int most);

/// The range that an axis of these values needs, with a margin; around a constant, which differences of
/// rounding size are as well.
struct AxisRange {
  double low = 0;
  double high = 0;
};
[[nodiscard]] AxisRange padded_range(double lowest, double highest);

/// "deg/s^2" as print has it: "deg/s²"; products with a dot; empty for a pure number.
[[nodiscard]] std::string printed_unit(std::string_view unit);

/// "×10⁶"; empty for 0.
[[nodiscard]] std::string printed_factor(int exponent);

/// A number with a true minus sign and at most `decimals` decimals, without zeros at the end.
[[nodiscard]] std::string printed_number(double value, int decimals);

}  // namespace higherpair

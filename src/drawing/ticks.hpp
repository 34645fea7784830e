#pragma once

#include "higherpair/drawing/printed_number.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

/// An axis from `low` to `high` and its ticks, at multiples of a round step.
struct Ticks {
  double low = 0;
  double high = 1;
  double step = 1;
  int exponent = 0;            ///< labels show values divided by 10^exponent
  std::vector<double> values;  ///< within the axis
  [[nodiscard]] std::string label(double value) const;
};

/// Ticks from `low` to `high` with a step of 1, 2 or 5 times a power of ten. For the unit deg, if the span is
/// large enough, the step is 15, 30, 45, 90, 180 or 360.
/// \param most  number of steps, >= 1
/// \pre low < high, both finite
[[nodiscard]] Ticks make_ticks(double low, double high, std::string_view unit, int most);

/// The range of an axis for values from `lowest` to `highest`, with a margin. If the values are equal to
/// within rounding, the range is wide enough to show a constant; if none is beyond `noise`, it is one about
/// 0.
struct AxisRange {
  double low = 0;
  double high = 0;
};
[[nodiscard]] AxisRange padded_range(double lowest, double highest, double noise);

/// A unit in print after a factor: "×10⁶ mm", "×10⁶"; without it if the exponent is 0.
[[nodiscard]] std::string printed_unit(std::string_view unit, int exponent);

/// A number with a true minus sign and at most `decimals` decimals, without trailing zeros.
[[nodiscard]] std::string printed_number(double value, int decimals);

}  // namespace higherpair

#pragma once

#include <string>
#include <string_view>

namespace higherpair {

/// A number with at most `digits` significant digits, as on the page of a report: "40480", "−0.5"; from ten
/// millions on and below 0.0001 with a power of ten: "7.4·10⁻⁷".
/// \pre  finite; 1 <= digits <= 17
[[nodiscard]] std::string printed_significant(double value, int digits);

/// "deg/s^2" in print: "deg/s²"; products with a dot; empty for a pure number.
[[nodiscard]] std::string printed_unit(std::string_view unit);

}  // namespace higherpair

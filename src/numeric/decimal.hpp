#pragma once

#include <charconv>
#include <string>

namespace higherpair {

/// Appends the shortest decimal number that reads back as x, with -0 written as 0.
void append_decimal(double x, std::string& out);

/// The same in scientific notation with no more digits than necessary, as 1.25e+20: append_decimal() writes
/// out whole numbers of up to 21 digits.
[[nodiscard]] std::string shortest_digits(double x);

/// x rounded to so many significant digits, at most 17.
[[nodiscard]] double rounded_to(double x, int digits);

/// std::from_chars for double, which some standard libraries (libc++ before 20) do not have.
std::from_chars_result read_decimal(const char* first, const char* last, double& x);

}  // namespace higherpair

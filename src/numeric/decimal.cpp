#include "decimal.hpp"

#include <array>

#include <fmt/format.h>

#ifndef __cpp_lib_to_chars
#include <fast_float/fast_float.h>
#include <iterator>
#endif

namespace higherpair {

#ifdef __cpp_lib_to_chars

void append_decimal(double x, std::string& out) {
  char text[32];
  out.append(text, std::to_chars(text, text + sizeof text, x == 0 ? 0.0 : x).ptr);
}

std::string shortest_digits(double x) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, x, std::chars_format::scientific).ptr};
}

std::from_chars_result read_decimal(const char* first, const char* last, double& x) {
  return std::from_chars(first, last, x);
}

#else

void append_decimal(double x, std::string& out) {
  fmt::format_to(std::back_inserter(out), "{}", x == 0 ? 0.0 : x);
}

std::string shortest_digits(double x) {
  return fmt::format("{}", x);
}

std::from_chars_result read_decimal(const char* first, const char* last, double& x) {
  const fast_float::from_chars_result result = fast_float::from_chars(first, last, x);
  return {result.ptr, result.ec};
}

#endif

// Not std::stod, which reads the decimal point of the locale.
double rounded_to(double x, int digits) {
  std::array<char, 32> text;
  const char* end = fmt::format_to_n(text.data(), text.size(), "{:.{}g}", x, digits).out;
  double rounded = x;
  (void)read_decimal(text.data(), end, rounded);
  return rounded;
}

}  // namespace higherpair

#include "decimal.hpp"

#ifndef __cpp_lib_to_chars
#include <fast_float/fast_float.h>
#include <iterator>

#include <fmt/format.h>
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

}  // namespace higherpair

#pragma once

#include "complex.hpp"

#include <compare>
#include <string>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace higherpair {

/// A number of 100 decimal digits. The polynomials whose roots are the contacts have up to 16 roots, which
/// cluster where levers are long compared with the bodies (a ratio of 1000 costs 24 digits), and every double
/// or nearly double root halves the digits that are left: in doubles the roots would be lost altogether.
///
/// A wrapper of Boost's number whose operations are compiled once: as templates they would cost seconds in
/// every source file.
class Extended {
public:
  using Number = boost::multiprecision::number<
      boost::multiprecision::cpp_bin_float<100, boost::multiprecision::digit_base_10, void, int>,
      boost::multiprecision::et_off>;

  Extended() = default;  ///< 0
  Extended(int x);
  Extended(double x);
  explicit Extended(long double x);
  explicit Extended(const std::string& decimal);
  explicit Extended(const Number& x) : x_(x) {}

  [[nodiscard]] const Number& number() const { return x_; }

  Extended& operator+=(const Extended& b);

  friend Extended operator+(const Extended& a, const Extended& b);
  friend Extended operator-(const Extended& a, const Extended& b);
  friend Extended operator*(const Extended& a, const Extended& b);
  friend Extended operator/(const Extended& a, const Extended& b);
  friend Extended operator-(const Extended& a);

  friend bool operator==(const Extended& a, const Extended& b);
  friend std::partial_ordering operator<=>(const Extended& a, const Extended& b);

  friend Extended abs(const Extended& x);
  friend Extended sqrt(const Extended& x);
  friend Extended cos(const Extended& x);
  friend Extended sin(const Extended& x);
  friend Extended atan(const Extended& x);

  friend double to_double(const Extended& x);
  friend long double to_long_double(const Extended& x);

private:
  Number x_;
};

/// |a| to the precision of long double, whose range of exponents is wide enough.
[[nodiscard]] long double magnitude(const Complex<Extended>& a);

}  // namespace higherpair

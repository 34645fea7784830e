#pragma once

#include "complex.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace higherpair {

/// A number of 100 decimal digits. The polynomials whose roots are the contacts have up to 16 roots that
/// crowd together where levers are long against the bodies (a ratio of 1000 costs 24 digits), and every
/// double or nearly double root halves the digits that are left: doubles would lose the roots altogether.
using Extended = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<100, boost::multiprecision::digit_base_10, void, int>,
    boost::multiprecision::et_off>;

[[nodiscard]] inline double to_double(const Extended& x) {
  return x.convert_to<double>();
}

}  // namespace higherpair

#include "higherpair/numeric/roots.hpp"

#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

namespace higherpair {

std::optional<double> root_between(const std::function<double(double)>& f, double at_0, double h,
                                   double at_h) {
  if (at_0 == 0) {
    return 0.0;
  }
  if (at_h == 0) {
    return h;
  }
  if (!(std::signbit(at_0) != std::signbit(at_h)) || !std::isfinite(at_0) || !std::isfinite(at_h)) {
    return std::nullopt;
  }
  // Where f has no value, returning 0 ends the search.
  bool known = true;
  const auto known_value = [&](double x) {
    const double value = f(x);
    known = known && std::isfinite(value);
    return known ? value : 0;
  };
  std::uintmax_t calls = 200;
  const bool forward = h > 0;
  const auto bracket = boost::math::tools::toms748_solve(
      known_value, forward ? 0.0 : h, forward ? h : 0.0, forward ? at_0 : at_h, forward ? at_h : at_0,
      boost::math::tools::eps_tolerance<double>(52), calls);
  return known ? std::optional((bracket.first + bracket.second) / 2) : std::nullopt;
}

}  // namespace higherpair

#pragma once

#include <functional>
#include <optional>

namespace higherpair {

/// The root of f between 0 and h, to within rounding; h may be negative. None where the values at the two
/// ends have the same sign, or f is not finite somewhere during the search.
[[nodiscard]] std::optional<double> root_between(const std::function<double(double)>& f, double at_0,
                                                 double h, double at_h);

}  // namespace higherpair

#pragma once

#include "higherpair/cam/motion_law.hpp"
#include "numeric/peaks.hpp"

#include <functional>

namespace higherpair {

/// A law and its first two derivatives with respect to its coordinate.
struct Lift {
  double s = 0, v = 0, a = 0;
};

/// Where a function of the lift is largest.
struct Worst {
  Peak peak;
  Lift lift;
};

/// Over the whole law; both sides count at jumps. Places where the function is a NaN are ignored; -inf if
/// there are no others.
[[nodiscard]] Worst worst_of(const MotionLaw& law, const std::function<double(const Lift&)>& f);

}  // namespace higherpair

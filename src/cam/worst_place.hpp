#pragma once

#include "higherpair/cam/motion_law.hpp"
#include "numeric/peaks.hpp"

#include <functional>

namespace higherpair {

/// A law and its first two derivatives by its coordinate.
struct Lift {
  double s = 0, v = 0, a = 0;
};

/// Where a function of the lift is largest.
struct Worst {
  Peak peak;
  Lift lift;
};

/// On the whole law; at jumps on both sides. Places where the function is a NaN do not count; nowhere: -inf.
[[nodiscard]] Worst worst_of(const MotionLaw& law, const std::function<double(const Lift&)>& f);

}  // namespace higherpair

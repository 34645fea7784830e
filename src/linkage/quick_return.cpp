#include "higherpair/linkage/quick_return.hpp"

#include "higherpair/geometry/pose.hpp"
#include "higherpair/linkage/reach.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace higherpair {

std::optional<QuickReturn> quick_return(const InvertedSliderCrank& linkage) {
  const double s = std::min(linkage.r1, linkage.r2);
  const double l = std::max(linkage.r1, linkage.r2);
  const double e = std::abs(linkage.r4);
  assert(s > 0);
  if (!(balance(l, -s, -e, 0.0) > 0)) return std::nullopt;

  const double skew = std::acos((e - s) / l) - std::acos((e + s) / l);
  QuickReturn result;
  result.lever_turns = linkage.r2 > linkage.r1;
  result.swing = result.lever_turns ? 0 : skew;
  result.time_ratio = (kPi + skew) / (kPi - skew);
  return result;
}

}  // namespace higherpair

#pragma once

#include "higherpair/geometry/one_freedom.hpp"

namespace higherpair::testing {

/// A body that turns about a point of the ground, which is the body's own origin.
inline OneFreedom pivot(double x, double y) {
  OneFreedom freedom;
  freedom.p_WO = Vector2d(x, y);
  return freedom;
}

}  // namespace higherpair::testing

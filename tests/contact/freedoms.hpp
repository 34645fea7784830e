#pragma once

#include "higherpair/geometry/one_freedom.hpp"

namespace higherpair::testing {

/// A body that turns about a point of the ground, which is the body's own origin.
inline OneFreedom pivot(double x, double y) {
  OneFreedom freedom;
  freedom.p_WO = Vector2d(x, y);
  return freedom;
}

/// A body that slides in the direction of this angle, from where its own origin is at q = 0.
inline OneFreedom slide(double x, double y, double angle) {
  OneFreedom freedom;
  freedom.turns = false;
  freedom.p_WO = {x, y};
  freedom.direction_W = unit_vector(angle);
  return freedom;
}

}  // namespace higherpair::testing

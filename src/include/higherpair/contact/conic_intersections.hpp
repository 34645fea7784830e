#pragma once

#include "higherpair/geometry/curve.hpp"
#include "higherpair/geometry/pose.hpp"

#include <vector>

namespace higherpair {

/// A common point of two conics.
struct ConicIntersection {
  Vector2d p_W = Vector2d::Zero();  ///< in ground [m]
  int multiplicity = 1;             ///< 1: they cross; 2: they touch; 3: same curvature; 4: one order more
};

enum class IntersectionStatus {
  kPoints,      ///< `points` holds every common point, none to four
  kCoincident,  ///< the two curves are the same to within rounding; `points` is empty
  kNotConics,   ///< a line or a point; `points` is empty
};

struct ConicIntersections {
  IntersectionStatus status = IntersectionStatus::kNotConics;
  std::vector<ConicIntersection> points;
};

/// All common points of two conics (of hyperbolas: of the branches that exist) at the present poses of their
/// bodies. A point of the first is a rational function of degree 2 of e^{iθ}, so that the second one's
/// equation is a polynomial of degree 4 in it, whose roots on the unit circle are the answer. Like the list
/// of contacts it is solved in numbers of 100 digits: the points are right to the last digits for the given
/// doubles, and those that their rounding (1e-13 of the size) cannot tell apart are one entry with their
/// multiplicity.
[[nodiscard]] ConicIntersections intersect_conics(const Curve& curve1, const Pose<double>& X_W1,
                                                  const Curve& curve2, const Pose<double>& X_W2);

}  // namespace higherpair

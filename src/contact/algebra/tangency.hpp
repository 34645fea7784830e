#pragma once

#include "extended_form.hpp"
#include "higherpair/contact/contact_pair.hpp"
#include "polynomial_roots.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// A pair of curves in extended numbers: the doubles of the pair are taken as exact, and lengths are divided
/// by a power of two near the size of the pair. The origin is the follower's pivot, or its joint at q = 0.
struct TangencyProblem {
  Form<Extended> first;   ///< at the driver position
  Form<Extended> second;  ///< of the follower at q = 0
  PencilMotion<Extended> motion;
  double length = 1;                         ///< of one unit of this problem [m]
  Vector2d origin_W = Vector2d::Zero();      ///< [m]
  PlacedCurve<double> first_W, second_at_0;  ///< the same curves, in units of this problem
};

[[nodiscard]] TangencyProblem make_problem(const ContactPair& pair, double u);

/// Follower's coordinate: e^{iq} (turning) or q in units of the problem as the real part (sliding).
using Coordinate = Complex<Extended>;

/// Body 2 at a coordinate; moved() leaves its dual A at q = 0.
[[nodiscard]] Form<Extended> moved(const TangencyProblem& problem, const Coordinate& at);
[[nodiscard]] Form<Extended> moved_with_dual(const TangencyProblem& problem, const Coordinate& at);

/// A position and a point at which the two curves are tangent.
struct Tangency {
  Coordinate at;
  Complex<Extended> w;  ///< the point
  /// false: a double root only to within the rounding of doubles; a change of that size may remove it.
  bool exact = true;
};

/// How well a point and position satisfy the conditions of contact, in units of the problem.
struct TangencyShape {
  double distance = 0;       ///< of the point from the farther curve
  double misalignment = 0;   ///< |sine| of the angle between the normals
  Complex<Extended> G1, G2;  ///< gradients, out of the bodies; 0 for a point
  double kappa1 = 0, kappa2 = 0;
};

[[nodiscard]] TangencyShape shape_at(const TangencyProblem& problem, const Tangency& tangency);

/// The degenerate conic λ₀ S1 + S2 of the pencil's double root λ₀ at a coordinate. \pre two conics
struct DoubleMember {
  Matrix3c<Extended> M;
  bool coincident = false;  ///< M = 0: the two conics are the same
};
[[nodiscard]] DoubleMember double_member(const TangencyProblem& problem, const Coordinate& at);

/// The tangencies at a root of the contact polynomial whose nearest real coordinate is `at`: none where the
/// contact is complex, at infinity, or farther off than rounding explains.
[[nodiscard]] std::vector<Tangency> tangencies_at(const TangencyProblem& problem, const Coordinate& at);

/// Whether the contact point at a root of the contact polynomial is finite.
[[nodiscard]] bool has_finite_point(const TangencyProblem& problem, const Coordinate& at);

/// The mean of two tangencies that are the same to within the rounding of doubles (everything between them
/// touches as well as they do); else none.
[[nodiscard]] std::optional<Tangency> merged(const TangencyProblem& problem, const Tangency& a,
                                             const Tangency& b);

}  // namespace higherpair

#pragma once

#include "higherpair/contact/common_normal.hpp"
#include "higherpair/geometry/one_freedom.hpp"

#include <cmath>

namespace higherpair {

/// Two curves that touch: one on the driver (body 1), one on the follower (body 2), each with one freedom
/// against ground. Their coordinates are u (driver) and q (follower).
struct ContactPair {
  Curve curve1;
  OneFreedom motion1;
  Curve curve2;
  OneFreedom motion2;
};

/// Whether both curves are conics, lines or points, whose contacts are roots of polynomials.
[[nodiscard]] inline bool is_algebraic(const ContactPair& pair) {
  return pair.curve1.support == nullptr && pair.curve2.support == nullptr;
}

/// The size of a pair, independent of its position [m]: the arms from the joints to the two curves, the
/// distance of the joints, and the smaller of the two curves' sizes (so a nearly flat curve does not make the
/// pair huge). > 0.
[[nodiscard]] double size_of_pair(const ContactPair& pair);

/// How far two coordinates of a joint are apart: less than half a turn [rad], or as a fraction of a size.
[[nodiscard]] inline double coordinate_distance(const OneFreedom& motion, double size, double a, double b) {
  return std::abs(motion.turns ? nearest_turn(a - b, 0) : (a - b) / size);
}

/// Where the two curves touch (p2 - p1 = 0 to within rounding) and how the contact moves with the driver.
struct ContactPosition : CommonNormal {
  double u = 0;        ///< driver coordinate [rad or m]
  double q = 0;        ///< follower coordinate [rad or m]
  double dq = 0;       ///< dq/du
  double d2q = 0;      ///< d²q/du²
  double dphi = 0;     ///< d(angle of n)/du
  double sliding = 0;  ///< t·(v2 - v1) of the material points for du/dt = 1 [m per unit of u]
  double dgap_q = 0;   ///< d(gap_q)/du along the motion
  double gap_q = 0;    ///< ∂(gap)/∂q = n·(velocity of body 2 at p per q); 0 at a limit position
};

/// Why there is no ContactPosition.
enum class ContactStatus {
  kOk,
  kNoContact,  ///< the osculating circles cannot touch here, or no point has the normal: at or beyond a limit
  kNotConverged,  ///< 13 passes did not bring the two points together
  kOtherBranch,   ///< the solution found has the other sign of gap_q
};

struct ContactResult {
  ContactStatus status = ContactStatus::kNotConverged;
  ContactPosition at;  ///< meaningful with kOk only
  double step_n = 0;   ///< |change of n| from the guess to the solution
};

/// The follower's position at which the two curves touch, by osculating circles: both curves are replaced by
/// their circles of curvature for the normals n and -n, the equivalent linkage is solved in closed form for
/// the follower, and its line of centres gives the next n. Formulated in increments from the present pose, so
/// that huge radii do not cancel. Rates are for unit driver velocity; they are 0 where gap_q = 0.
/// \param u       driver coordinate
/// \param q       guess of the follower's coordinate; the answer is continuous with it (no whole turns are
///                taken off)
/// \param n_W     guess of the common normal, out of body 1; ignored where a body is a line
/// \param branch  +1 or -1: the sign of ∂gap/∂q of the contact wanted
[[nodiscard]] ContactResult solve_contact(const ContactPair& pair, double u, double q, const Vector2d& n_W,
                                          int branch);

}  // namespace higherpair

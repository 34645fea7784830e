#pragma once

#include "higherpair/analysis/driver_motion.hpp"
#include "higherpair/contact/dwell_contact.hpp"
#include "higherpair/contact/rolling.hpp"
#include "higherpair/contact/tracker.hpp"
#include "higherpair/geometry/known_rotation.hpp"
#include "higherpair/mechanism/constraint_rows.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <array>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// Data of a group that is kept from position to position.
struct GroupState {
  int mode = 1;  ///< assembly mode σ, or the sign of ∂gap/∂q of a contact: the branch
  /// Signed measure of singularity: changes sign at a change point; 0 to within rounding: singular.
  double sine = 1;
  double sine_rate = 0;  ///< per unit of the path
  double lever = 1;      ///< order of magnitude of `sine` away from change points
  double noise = 0;      ///< |sine| up to this counts as 0
  /// Contact that may separate (Keep::kGap): it is open, the body stays in place on its joint.
  bool open = false;
  double open_at = 0;  ///< then: the coordinate of its freedom [rad or m]
};

using PairTrack = std::variant<std::monostate, ContactTrack, RollingTrack, DwellContact>;

/// A position of a whole mechanism and its rates.
struct State {
  std::vector<BodyMotion> bodies;       ///< of Mechanism::bodies
  std::vector<KnownRotation> turns;     ///< rotation of each body, known at a position near by
  std::vector<ContactMotion> contacts;  ///< of Mechanism::contacts
  std::vector<GroupState> groups;       ///< of Plan::groups
  std::vector<PairTrack> tracks;        ///< of Plan::groups; none where the group is not a tracked pair
};

/// Whether the bodies of both have the same poses to within `near` [rad, of the size].
[[nodiscard]] bool have_same_poses(const State& a, const State& b, double size, double near);

/// Continuation of coupled bodies from a limit to where they can be assembled again, along the path of least
/// violation of their conditions F = 0: while the violation is not 0 the Jacobian J is singular. The sign of
/// the determinant of J bordered by its singular vectors changes where another part of the bodies turns over.
struct LeastViolation {
  Eigen::VectorXd left, right;  ///< singular vectors of J, continuous along the path; empty: J is not square
  int sign = 0;                 ///< sign of the bordered determinant where the path began; 0: unknown
};

}  // namespace higherpair

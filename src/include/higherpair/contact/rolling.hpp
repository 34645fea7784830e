#pragma once

#include "higherpair/contact/contact_pair.hpp"

namespace higherpair {

/// A contact without slip, followed while the driver moves.
struct RollingTrack {
  ContactPair pair;
  ContactPosition at;  ///< dq, d2q, dphi and sliding are those of rolling; gap_q is that of the contact
  double phi = 0;      ///< angle of at.n_W, continuous [rad]
  double arc_difference = 0;  ///< arc of curve 1 less arc of curve 2 along t, constant since the start [m]
};

/// Residual of the rolling conditions at a position [m]: the largest of gap, tangential distance, and
/// difference of the arcs (at the start: distance of the contact point from where both material points can
/// have the same velocity). 0 to within rounding for a pair that can roll.
struct RollingResult {
  double mismatch = 0;
  bool converged = false;
};

/// Finds the rolling position nearest to the follower's coordinate q: gap = 0, common tangent, and a contact
/// point at which the two joints let both bodies have the same velocity (for two pivots: on their line).
/// Least squares, so that a coordinate that these conditions do not determine (discs about their centres)
/// stays exactly q.
/// \param n_W guess of the normal out of body 1
[[nodiscard]] RollingResult start_rolling(RollingTrack& track, const ContactPair& pair, double u, double q,
                                          const Vector2d& n_W);

/// Moves to the driver position u: gap = 0, common tangent, equal arcs, by least squares (of full rank also
/// where tangency alone is singular), in inner steps that agree with what the rates predict. Where none does,
/// the result has not converged, and the track is as far as it could be followed. ω2 from equal velocities at
/// the contact point (the instant centre), α2 from a2 - a1 = n (ω2 u2 - ω1 u1).
[[nodiscard]] RollingResult roll_to(RollingTrack& track, double u);

}  // namespace higherpair

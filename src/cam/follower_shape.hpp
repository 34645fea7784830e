#pragma once

#include "higherpair/cam/flank.hpp"
#include "worst_place.hpp"

#include <limits>
#include <optional>

namespace higherpair {

/// A size as one number y >= 0, 0 where the cam has shrunk to nothing: the follower rests at origin + sense
/// y.
struct SizeRange {
  double origin = 0;
  double sense = 1;
  double most = std::numeric_limits<double>::infinity();  ///< y beyond which the cam does not grow
  double step = 1;                                        ///< for a search

  [[nodiscard]] double rest(double y) const { return origin + sense * y; }
};

/// A round follower: its centre and its radius, < 0 of a ring.
struct Round {
  Vector2d centre_B;
  double radius = 0;
};
[[nodiscard]] std::optional<Round> round_of(const FlankOrigin& cam);

/// The centre of a round follower in ground, for a unit rate of the cam.
struct Centre {
  Vector2d from_cam;  ///< from the cam's pivot (a sliding cam: from ground's origin)
  Vector2d u;         ///< velocity for a unit rate of the follower
  Vector2d v;         ///< of the cam's material there
  Vector2d w;         ///< against the cam
  Vector2d a;         ///< acceleration against the cam, as seen from it
};
[[nodiscard]] Centre centre_at(const FlankOrigin& cam, const Round& round, const Lift& lift, double rest);

/// What the tangent of the pressure angle is made of: the motion of the centre against the cam along the
/// follower's path, with its sign, and across it.
struct Inclination {
  double along = 0;
  double across = 0;
};
[[nodiscard]] Inclination inclination_of(const Centre& centre);

/// Curvature of the centre's path against the cam, > 0 where its centre of curvature is on the cam's side:
/// κ = -n·a/|w|².
[[nodiscard]] double pitch_curvature_at(const FlankOrigin& cam, const Centre& centre);

/// y is the height over the cam's pivot along a guide, or the angle of the arm from the line of the pivots.
[[nodiscard]] SizeRange sizes_of_round(const FlankOrigin& cam, const Round& round);

/// A flat face: its support about the cam's pivot by the angle φ of its normal in the cam's frame.
struct Face {
  double height = 0;  ///< distance from the pivot
  double radius = 0;  ///< of curvature of the flank: height + d²height/dφ²
};
[[nodiscard]] Face face_at(const FlankOrigin& cam, const Lift& lift, double rest);

/// y is the height of the face, or the angle by which it is turned out from along the line of the pivots.
[[nodiscard]] SizeRange sizes_of_flat(const FlankOrigin& cam);

}  // namespace higherpair

#pragma once

#include "higherpair/cam/flank.hpp"
#include "higherpair/cam/sizing.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "worst_place.hpp"

#include <optional>

namespace higherpair {

/// The cam's size as one number y >= 0; at y = 0 it shrinks to a point. The follower's rest position is
/// origin + sense y.
struct SizeRange {
  double origin = 0;
  double sense = 1;
  double most = kInf;  ///< y beyond which the cam does not grow any more
  double step = 1;     ///< initial step of a search

  [[nodiscard]] double rest(double y) const { return origin + sense * y; }
};

/// A round follower: its centre and its radius, < 0 for a ring.
struct Round {
  Vector2d center_B;
  double radius = 0;
};
[[nodiscard]] std::optional<Round> round_of(const FlankOrigin& cam);

/// Motion of the centre of a round follower in ground, for a unit rate of the cam.
struct Center {
  Vector2d from_cam;  ///< position relative to the cam's pivot (for a sliding cam: to the origin of ground)
  Vector2d u;         ///< velocity for a unit rate of the follower
  Vector2d v;         ///< velocity of the cam's material there
  Vector2d w;         ///< velocity relative to the cam
  Vector2d a;         ///< acceleration relative to the cam, in its frame
};
[[nodiscard]] Center center_at(const FlankOrigin& cam, const Round& round, const Lift& lift, double rest);

/// Which of a follower's points shape the flank: with w the velocity of its centre of curvature there
/// relative to the cam, for a unit rate of the cam, its outward normal is -side · perp(w)/|w|. The sign is
/// the same all along a flank, that of a dwell: wherever it changed, w would be 0.
[[nodiscard]] double side_of(const FlankOrigin& cam);

/// Components of the tangent of the pressure angle: the motion of the centre relative to the cam along the
/// follower's path, and across it, both signed.
struct Inclination {
  double along = 0;
  double across = 0;
};
[[nodiscard]] Inclination inclination_of(const Center& center);

/// Curvature of the centre's path relative to the cam, > 0 where its centre of curvature is on the cam's
/// side: κ = -n·a/|w|².
[[nodiscard]] double pitch_curvature_at(const FlankOrigin& cam, const Center& center);

/// y is the height above the cam's pivot along a guide, or the angle of the arm from the line of the pivots.
[[nodiscard]] SizeRange sizes_of_round(const FlankOrigin& cam, const Round& round);

/// A flat face: its support function about the cam's pivot, of the angle φ of its normal in the cam's frame.
struct Face {
  double height = 0;  ///< distance from the pivot
  double radius = 0;  ///< radius of curvature of the flank: height + d²height/dφ²
};
[[nodiscard]] Face face_at(const FlankOrigin& cam, const Lift& lift, double rest);

/// The size of a turning cam under a round or flat follower at `rest`; `at` is copied into it.
[[nodiscard]] CamSize size_at(const FlankOrigin& cam, double rest, double at);

/// Whether the follower moves back towards the cam's pivot; `away`: the sign of a lift that leads away from
/// it, `sense`: that in which the cam turns.
[[nodiscard]] inline bool returns(const Lift& lift, double away, double sense) {
  return away * lift.v * sense < 0;
}

/// y is the height of the face, or the angle by which it is turned outwards from the line of the pivots.
[[nodiscard]] SizeRange sizes_of_flat(const FlankOrigin& cam);

}  // namespace higherpair

#pragma once

#include "higherpair/cam/flank.hpp"

#include <optional>

namespace higherpair {

// How large a cam must be, from its law's exact derivatives (Norton, Cam Design and Manufacturing Handbook,
// 7; Rothbart, Cam Design Handbook, 3). The follower's curve is round (a roller, a knife edge) or flat, the
// cam turns; lengths [m], angles [rad], coordinates of joints as in CamMotion.

/// A value and the coordinate of the cam's joint at which the law takes it.
struct CamPlace {
  double value = 0;
  double at = 0;
};

/// The size of a cam: the position of its follower where the law is 0.
struct CamSize {
  double rest = 0;    ///< coordinate of the follower's joint there
  double radius = 0;  ///< of the prime circle through the centre of a round follower; of a flat one the base
                      ///< circle, which the face touches
  double base_radius = 0;  ///< of the base circle
  double at = 0;           ///< coordinate of the cam's joint that decides; of the present size 0
};

/// The size that a cam has; none of a cam that slides, or of another follower than a round or flat one.
[[nodiscard]] std::optional<CamSize> size_of(const FlankOrigin& cam);

/// Largest pressure angles as handbooks take them at the centre of a round follower: between the normal of
/// the pitch curve and the path of the centre. With u the velocity of the centre for a unit rate of the
/// follower, q′ its rate for a unit rate of the cam and v that of the cam's material at the centre,
///     tan α = |u q′ - v·û| / |û × v|,   û = u/|u|.
struct PressureLimits {
  double out = 0;    ///< where the follower moves away from the cam's pivot, or rests; 0 < α < π/2
  double back = 0;   ///< where it returns
  double sense = 1;  ///< of the cam's turning: sign of the rate of its joint
};

/// The largest of these angles on the whole law. None without a round follower.
[[nodiscard]] std::optional<CamPlace> largest_center_pressure(const FlankOrigin& cam);

/// Signed curvature of the pitch curve, that of the centre of a round follower against the cam, where it is
/// largest (convex) and smallest (concave if < 0) [1/m]. None without a round follower.
struct PitchCurvature {
  CamPlace greatest, least;
};
[[nodiscard]] std::optional<PitchCurvature> pitch_curvature(const FlankOrigin& cam);

/// Smallest radii of curvature of a flank: 0 < flank's radius forbids undercut alone.
struct RadiusLimits {
  double convex = 0;
  double concave = 0;
};

/// The smallest cam that keeps the limits, the follower's joint and curve as they are: only its rest moves.
/// Every place of the law asks for a size; the largest of these is found by exchange: the size that the worst
/// place of a size asks for is tried next, which converges like Newton's method, for at the worst place the
/// condition's derivative along the law is 0. None where no size does it.
/// @{
[[nodiscard]] std::optional<CamSize> smallest_for_pressure(const FlankOrigin& cam,
                                                           const PressureLimits& limits);
[[nodiscard]] std::optional<CamSize> smallest_for_radius(const FlankOrigin& cam, const RadiusLimits& limits);
/// @}

/// The largest radius of a round follower on the same pitch curve whose flank has no smaller convex radius of
/// curvature than this: 1/κ - convex at the largest curvature κ of the pitch curve. None where that is convex
/// nowhere, so that every radius does it, or the follower is not round.
[[nodiscard]] std::optional<CamPlace> largest_follower(const FlankOrigin& cam, double convex);

/// A cam whose sliding follower's guide may also be moved to the side.
struct OffsetSize {
  double radius = 0;  ///< of the prime circle
  double offset = 0;  ///< of the guide from the cam's pivot, along `direction` turned by -90° [m]
  double rest = 0;    ///< height of the centre over the pivot along the guide where the law is 0 [m]
};

/// The smallest of them that keeps the limits: with both coordinates (offset e, height d) the conditions
///     d >= ±(q′ - e)/tan α - s
/// are half planes, whose point next to the pivot is found by exchange. None without a sliding round
/// follower.
[[nodiscard]] std::optional<OffsetSize> smallest_with_offset(const FlankOrigin& cam,
                                                             const PressureLimits& limits);

}  // namespace higherpair

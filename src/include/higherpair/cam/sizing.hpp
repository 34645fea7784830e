#pragma once

#include "higherpair/cam/flank.hpp"

#include <functional>
#include <optional>

namespace higherpair {

// Necessary size of a cam, from the exact derivatives of its law (Norton, Cam Design and Manufacturing
// Handbook, 7; Rothbart, Cam Design Handbook, 6 and 7). The follower's curve is round (a roller, a knife
// edge) or flat, the cam turns; lengths [m], angles [rad], coordinates of joints as in CamMotion.

/// A value and the coordinate of the cam's joint at which it occurs.
struct CamPlace {
  double value = 0;
  double at = 0;
};

/// The size of a cam, given by the position of its follower where the law is 0.
struct CamSize {
  double rest = 0;  ///< coordinate of the follower's joint there
  /// Of the prime circle through the centre of a round follower; for a flat one of the base circle, which the
  /// face touches.
  double radius = 0;
  double base_radius = 0;  ///< of the base circle
  double at = 0;           ///< coordinate of the cam's joint that determines the size; 0 for the present size
};

/// The present size of a cam; none for a sliding cam, or a follower that is neither round nor flat.
[[nodiscard]] std::optional<CamSize> size_of(const FlankOrigin& cam);

/// Largest permissible pressure angles, as handbooks define them at the centre of a round follower: between
/// the normal of the pitch curve and the path of the centre. With u the velocity of the centre for a unit
/// rate of the follower, q′ the follower's rate for a unit rate of the cam and v the velocity of the cam's
/// material at the centre,
///     tan α = |u q′ - v·û| / |û × v|,   û = u/|u|.
struct PressureLimits {
  double out = 0;    ///< while the follower moves away from the cam's pivot, or dwells; 0 < α < π/2
  double back = 0;   ///< while it returns
  double sense = 1;  ///< of the cam's turning: sign of the rate of its joint
};

/// The largest of these angles over the whole law. None without a round follower.
[[nodiscard]] std::optional<CamPlace> largest_center_pressure(const FlankOrigin& cam);

/// The largest signed curvature, > 0 where it is convex, of the pitch curve: the path of the centre of a
/// round follower relative to the cam [1/m]. None without a round follower.
[[nodiscard]] std::optional<CamPlace> largest_pitch_curvature(const FlankOrigin& cam);

/// Least permissible radii of curvature of a flank; 0 only forbids undercut.
struct RadiusLimits {
  double convex = 0;
  double concave = 0;
};

/// The smallest cam that respects the limits, with the follower's joint and curve unchanged: only the rest
/// position varies. Every place of the law requires a size; the largest of these is found by exchange: the
/// size required at the worst place for the current size is tried next. This converges like Newton's method,
/// because the derivative of the condition along the law is 0 at the worst place. None where no size is
/// sufficient.
/// @{
[[nodiscard]] std::optional<CamSize> smallest_for_pressure(const FlankOrigin& cam,
                                                           const PressureLimits& limits);
[[nodiscard]] std::optional<CamSize> smallest_for_radius(const FlankOrigin& cam, const RadiusLimits& limits);
/// @}

/// The largest radius of a round follower on the same pitch curve whose flank has no convex radius of
/// curvature smaller than `convex`: 1/κ - convex at the largest curvature κ of the pitch curve. None where
/// the pitch curve is nowhere convex, so that any radius is possible, or the follower is not round.
[[nodiscard]] std::optional<CamPlace> largest_follower(const FlankOrigin& cam, double convex);

/// Whether a flank can be cut, by whatever it may be refused for.
using FlankTest = std::function<bool(const FlankOrigin&)>;

/// The smallest cam beyond a size whose flank can be cut, and the largest follower below a radius, with all
/// else unchanged: the given one, if just beyond it the flank can be cut; otherwise found by trials at
/// growing distances, then by bisection to within a thousandth, on the side where it can. A condition of the
/// whole flank, such as that it does not cross itself, has no one place that determines the size. None where
/// no trial succeeds. \pre a cam with a size_of(); for the radius, a circle with the body inside
/// @{
[[nodiscard]] std::optional<CamSize> smallest_that_can_be_cut(const FlankOrigin& cam, const CamSize& from,
                                                              const FlankTest& can_be_cut);
[[nodiscard]] std::optional<double> largest_that_can_be_cut(const FlankOrigin& cam, double from_radius,
                                                            const FlankTest& can_be_cut);
/// @}

/// The largest cam and the smallest radius that these try.
[[nodiscard]] CamSize largest_tried(const FlankOrigin& cam, const CamSize& from);
[[nodiscard]] double smallest_radius_tried(double from_radius);

/// A cam with a sliding follower whose guide may also be offset.
struct OffsetSize {
  double radius = 0;  ///< of the prime circle
  double offset = 0;  ///< of the guide from the cam's pivot, along `direction` turned by -90° [m]
  double rest = 0;    ///< height of the centre above the pivot along the guide where the law is 0 [m]
};

/// The smallest of them that respects the limits: in both coordinates (offset e, height d) the conditions
///     d >= ±(q′ - e)/tan α - s
/// are half planes, whose common point closest to the pivot is found by exchange. None without a sliding
/// round follower.
[[nodiscard]] std::optional<OffsetSize> smallest_with_offset(const FlankOrigin& cam,
                                                             const PressureLimits& limits);

}  // namespace higherpair

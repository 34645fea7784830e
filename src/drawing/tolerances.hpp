#pragma once

// The tolerances of this room: what of numbers, arrows and polygons is rounding, and what is too small to be
// seen. Sizes of a picture's parts are beside the code that draws them.

namespace higherpair {

// Axes.

/// Values below this are rounding, in any unit a profile would have.
inline constexpr double kNoTickValue = 1e-10;
/// A spread below this share of the values is rounding as well.
inline constexpr double kNoTickSpread = 1e-9;
/// Of a step: how near an end of the axis a tick may be to be on it.
inline constexpr double kOnTick = 1e-6;
/// Of a step: the tick at 0.
inline constexpr double kTickAtZero = 1e-9;

// Polygons and arrows.

/// Of the longest arrow: shorter ones are rounding.
inline constexpr double kNegligibleArrow = 1e-9;
/// Of the largest force in the mechanism: less is rounding.
inline constexpr double kNegligibleForce = 1e-9;
/// Of the largest arrow: at rest but for these rows.
inline constexpr double kOutOfProportion = 1e-4;
/// Of the size of what is drawn: points nearer to each other are one.
inline constexpr double kSameNode = 1e-9;
/// Of the longest arrow: points with one label.
inline constexpr double kSameLabelledPoint = 1e-6;
/// Of its longest arrow: a force polygon thinner than this is a line.
inline constexpr double kFlatForces = 0.015;
/// The same of velocities, where points are compared.
inline constexpr double kFlatMotion = 0.004;
/// The same, to find the scale.
inline constexpr double kThinPolygon = 1e-3;

}  // namespace higherpair

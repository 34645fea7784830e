#pragma once

// Tolerances of drawings: which differences of numbers, arrows and polygons are due to rounding, and which
// are too small to be visible. Sizes of the parts of a picture are beside the code that draws them.

namespace higherpair {

// Axes.

/// Places on the axis x below this count as 0, in any unit that a profile is likely to use.
inline constexpr double kNoTickValue = 1e-10;
/// Anything below this is 0: the powers of ten of its ticks would not be numbers.
inline constexpr double kLeastTickValue = 1e-290;
/// Anything beyond this is not drawn: sums and squares of it would not be numbers.
inline constexpr double kLargestPlotted = 1e150;
/// Relative to the largest of the values: a smaller spread is rounding.
inline constexpr double kNoTickSpread = 1e-9;
/// As a fraction of a step: a tick this far beyond an end of the axis is still on it.
inline constexpr double kOnTick = 1e-6;
/// As a fraction of a step: ticks this close to 0 are the tick at 0.
inline constexpr double kTickAtZero = 1e-9;

// Scenes.

/// Relative to the largest coordinate: a mechanism of smaller extent is a single point, but for rounding.
inline constexpr double kNoExtent = 1e-9;

// Polygons and arrows.

/// Relative to the longest arrow: shorter ones are rounding.
inline constexpr double kNegligibleArrow = 1e-9;
/// Relative to the largest force in the mechanism: smaller ones are rounding.
inline constexpr double kNegligibleForce = 1e-9;
/// Relative to the largest arrow of all rows: if the median of the rows is smaller, most rows are at rest and
/// the largest arrow alone sets the scale.
inline constexpr double kOutOfProportion = 1e-4;
/// Relative to the size of the mechanism: points of a body that are closer to each other are one.
inline constexpr double kSameNode = 1e-9;
/// Relative to the longest arrow: points that are closer to each other share a label.
inline constexpr double kSameLabelledPoint = 1e-6;
/// Relative to its longest arrow: a force polygon thinner than this is drawn as a line.
inline constexpr double kFlatForces = 0.015;
/// The same for polygons of velocity and acceleration, whose points are compared.
inline constexpr double kFlatMotion = 0.004;
/// Relative to the longest arrow: smallest width and height assumed in finding the scale.
inline constexpr double kThinPolygon = 1e-3;

}  // namespace higherpair

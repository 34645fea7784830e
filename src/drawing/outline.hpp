#pragma once

#include "higherpair/geometry/curve.hpp"

#include <vector>

namespace higherpair {

/// \name Outlines as points x, y, x, y, … of closed paths, in the unit of the input.
/// @{

/// All points within `radius` of the hull of `points`: a disc, a bar with round ends, a plate with round
/// corners.
[[nodiscard]] std::vector<double> rounded_hull(std::vector<Vector2d> points, double radius);

/// A rectangle about `middle` with its length along the unit vector `along`.
[[nodiscard]] std::vector<double> rectangle(const Vector2d& middle, const Vector2d& along, double length,
                                            double width);

/// The material bounded by a curve: the interior of a closed one, or a ring of `thickness` around it if the
/// material is outside; for an open conic or a face a strip of that thickness behind it.
/// \param range  ends of the strip: coordinates from the vertex along the curve's axis turned by +90°
[[nodiscard]] std::vector<double> material(const Curve& curve, double thickness,
                                           const std::array<double, 2>& range);
/// @}

/// Adds a point to a path.
inline void append(std::vector<double>& path, const Vector2d& p) {
  path.insert(path.end(), {p.x(), p.y()});
}

/// Separates two pieces of a path.
void append_break(std::vector<double>& path);

}  // namespace higherpair

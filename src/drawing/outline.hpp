#pragma once

#include "higherpair/drawing/picture.hpp"
#include "higherpair/geometry/curve.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// \name Outlines as points x, y, x, y, … of closed paths, in the unit of what goes in.
/// @{

/// All points within `radius` of the hull of `points`: a disc, a bar with round ends, a plate with round
/// corners.
[[nodiscard]] std::vector<double> rounded_hull(std::vector<Vector2d> points, double radius);

/// A rectangle about `middle` with its length along the unit vector `along`.
[[nodiscard]] std::vector<double> rectangle(const Vector2d& middle, const Vector2d& along, double length,
                                            double width);

/// The material that a curve bounds: within a closed one; a ring of `thickness` outside of it; of an open
/// curve or face a strip of that thickness behind it, as far as `reach` on both sides of the vertex, or of
/// the given range along a face. \param range  of the coordinate along a face's direction axis turned +90°,
/// or of y of an open conic
[[nodiscard]] std::vector<double> material(const Curve& curve, double thickness,
                                           const std::array<double, 2>& range);
/// @}

/// Adds a point to a path.
inline void append(std::vector<double>& path, const Vector2d& p) {
  path.insert(path.end(), {p.x(), p.y()});
}

/// Breaks a path into pieces apart.
void append_break(std::vector<double>& path);

}  // namespace higherpair

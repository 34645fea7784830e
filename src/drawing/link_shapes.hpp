#pragma once

#include "sketch.hpp"

#include <vector>

namespace higherpair {

// In units of symbols.
inline constexpr double kFace = 2.5;  ///< thickness of faces and rings
inline constexpr double kWedge = 5;   ///< length of a knife edge

/// Points along a boundary.
[[nodiscard]] std::vector<Vector2d> outline_of(const Boundary& boundary);

/// Whether a curve is a closed chain with its material inside.
[[nodiscard]] bool is_plate(const NamedCurve& named);

/// The points that the bar or plate of a body holds together: named points, and where the curves are.
[[nodiscard]] std::vector<Vector2d> anchors_of(const Sketch& sketch, int body);

/// A bar or plate between the points of a body.
void add_link(Sketch& sketch, int body);

}  // namespace higherpair

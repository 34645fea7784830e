#pragma once

#include "sketch.hpp"

#include <vector>

namespace higherpair {

// Sizes in units of symbols.
inline constexpr double kFace = 2.5;  ///< thickness of faces and rings
inline constexpr double kWedge = 5;   ///< length of a knife edge

/// Points along a boundary.
[[nodiscard]] std::vector<Vector2d> drawn_outline(const Boundary& boundary);

/// Whether a curve is a closed chain with its material inside.
[[nodiscard]] bool is_plate(const NamedCurve& named);

/// Whether a curve is a closed chain with its material outside.
[[nodiscard]] bool is_ring(const NamedCurve& named);

/// The points joined by the bar or plate of a body: its named points, a point of each of its curves,
/// and the ends of its rails and slots.
[[nodiscard]] std::vector<Vector2d> anchors_of(const Sketch& sketch, int body);

/// A bar or plate between the points of a body.
void add_link(Sketch& sketch, int body);

}  // namespace higherpair

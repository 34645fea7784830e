#pragma once

#include "sketch.hpp"

#include <array>
#include <vector>

namespace higherpair {

/// A touching point of a curve, seen from its body: the point, and the outward normal.
struct Touch {
  Vector2d p_B, n_B;
};

/// In all rows in which something touches the curve.
[[nodiscard]] std::vector<Touch> touches_of(const Sketch& sketch, int body, std::size_t curve);

/// Whether a contact holds the curve from both sides, as a slot does a pin.
[[nodiscard]] bool is_held(const Sketch& sketch, int body, std::size_t curve);

/// From a knife edge into its body: against the mean of the normals.
[[nodiscard]] Vector2d edge_direction(const Sketch& sketch, int body, std::size_t curve);

/// How far the touching points of a curve go along its vertex's tangent, with some room [m].
[[nodiscard]] std::array<double, 2> touched_range(const Sketch& sketch, int body, std::size_t curve);

}  // namespace higherpair

#pragma once

#include "sketch.hpp"

#include <array>
#include <vector>

namespace higherpair {

/// A contact point of a curve, in the frame of its body, and the outward normal there.
struct Touch {
  Vector2d p_B, n_B;
};

/// The contact points of the curve in all rows in which something touches it.
[[nodiscard]] std::vector<Touch> touches_of(const Sketch& sketch, int body, std::size_t curve);

/// Whether a contact encloses the curve from both sides, as a slot does a pin.
[[nodiscard]] bool is_held(const Sketch& sketch, int body, std::size_t curve);

/// The direction from a knife edge into its body, opposite to the mean of the normals.
[[nodiscard]] Vector2d edge_direction(const Sketch& sketch, int body, std::size_t curve);

/// The range of the contact points of a curve along the tangent at its vertex, with some margin [m].
[[nodiscard]] std::array<double, 2> touched_range(const Sketch& sketch, int body, std::size_t curve);

}  // namespace higherpair

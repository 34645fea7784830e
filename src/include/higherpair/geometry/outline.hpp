#pragma once

#include "higherpair/geometry/polyline.hpp"

#include <cstddef>
#include <vector>

namespace higherpair {

/// A cone of unit vectors: its axis, and the longest chord from there to one of them; 2: all directions.
struct NormalCone {
  Vector2d middle = Vector2d::UnitX();
  double chord = 2;
};

/// The normals of a span between two places at which they are a and b, at most from one sample to the next.
[[nodiscard]] NormalCone cone_between(const Vector2d& a, const Vector2d& b);

/// Whether vectors of two cones may be opposed to each other, the second one being turned by R_12.
[[nodiscard]] inline bool may_be_opposed(const NormalCone& a, const NormalCone& b,
                                         const Rotation<double>& R_12) {
  const double chords = a.chord + b.chord + kRoundingOfNormal;
  return (a.middle + R_12 * b.middle).squaredNorm() <= chords * chords;
}

/// The samples of a boundary as a polyline in the body's frame, with cones of the outward normals along it.
class Outline {
public:
  Outline(const std::vector<Boundary::Sample>& samples, std::vector<Polyline> solids);

  [[nodiscard]] const Polyline& polyline() const { return polyline_; }
  /// The chains, where there are several and all are closed with the material inside. They may overlap: the
  /// nearest place of a point within one of them may be on another.
  [[nodiscard]] const std::vector<Polyline>& solids() const { return solids_; }
  /// Those between the ends of a part, and those of all parts of a node.
  [[nodiscard]] const NormalCone& normals_of_part(std::size_t i) const { return of_parts_[i]; }
  [[nodiscard]] const NormalCone& normals_of_node(std::size_t i) const { return of_nodes_[i]; }

private:
  Polyline polyline_;
  std::vector<Polyline> solids_;
  std::vector<NormalCone> of_parts_, of_nodes_;
};

/// Boundary::samples() as a polyline with a tree for searches.
[[nodiscard]] inline const Outline& outline_of(const Boundary& boundary) {
  return *boundary.outline_;
}

}  // namespace higherpair

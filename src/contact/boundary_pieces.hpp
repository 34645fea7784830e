#pragma once

#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/pose.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

// Two boundaries as short pieces, grouped into blocks with bounding circles and cones of normals: finds which
// parts are near each other.

namespace higherpair {

/// A cone of unit vectors: its axis and the longest chord from there to one of them.
struct NormalCone {
  Vector2d middle = Vector2d::Zero();
  double chord = 0;
};

/// The boundary between two neighbouring samples, in the frame of body 1.
struct BoundaryPiece {
  Vector2d from, to;
  NormalCone normals;
  BoundaryPlace begin, end;

  [[nodiscard]] double length() const { return (to - from).norm(); }
  [[nodiscard]] Vector2d middle() const { return (from + to) / 2; }
  /// Fraction of the chord at which it is nearest to a point.
  [[nodiscard]] double share_at(const Vector2d& p) const {
    const double squared = (to - from).squaredNorm();
    return squared > 0 ? std::clamp((p - from).dot(to - from) / squared, 0.0, 1.0) : 0.5;
  }
  [[nodiscard]] BoundaryPlace place_at(const Vector2d& p) const {
    return {begin.span, std::lerp(begin.t, end.t, share_at(p))};
  }
  [[nodiscard]] double distance_to(const Vector2d& p) const {
    return (from + share_at(p) * (to - from) - p).norm();
  }
};

/// Neighbouring pieces and a circle about them.
struct PieceBlock {
  std::size_t begin = 0, end = 0;  ///< pieces
  Vector2d center = Vector2d::Zero();
  double radius = 0;
  NormalCone normals;
};

struct BoundaryPieces {
  std::vector<BoundaryPiece> pieces;
  std::vector<PieceBlock> blocks;
};

/// The pieces of a boundary that are no farther from `center` than `reach`.
[[nodiscard]] BoundaryPieces boundary_pieces(const Boundary& boundary, const Pose<double>& X_1B,
                                             const Vector2d& center, double reach);

/// Calls `found` with a place on either piece for all pairs of pieces that may have points with a common
/// normal at most `reach` apart.
void for_each_facing(
    const BoundaryPieces& one, const BoundaryPieces& two, double reach,
    const std::function<void(const BoundaryPlace& place1, const BoundaryPlace& place2)>& found);

/// The place nearest to a point, measured to the chords of the pieces; none if all blocks are farther away
/// than `reach`.
[[nodiscard]] std::optional<BoundaryPlace> nearest_place(const BoundaryPieces& all, const Vector2d& p,
                                                         double reach);

}  // namespace higherpair

#pragma once

#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/curve.hpp"

#include <vector>

namespace higherpair {

/// The normals of a piece as an interval [rad]: one whole turn for a closed curve.
[[nodiscard]] inline Bounds normals_of(const SupportPiece& piece) {
  return piece.kind == PieceKind::kClosed ? Bounds{-kPi, kPi} : piece.phi;
}

/// The chains of spans that make up a curve given by its support function, including its corners; ends within
/// 1e-12 of `reach` of each other meet. None for a curve with cusps, which bounds no body.
/// \param curve  must outlive the chains  \param reach  where flat faces without an end are cut off [m]
[[nodiscard]] std::vector<Boundary> support_chains(const SupportCurve& curve, double reach);

}  // namespace higherpair

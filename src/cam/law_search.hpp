#pragma once

#include "law_pieces.hpp"

#include <vector>

namespace higherpair {

/// Zeros of the k-th derivative of a piece from x = from to x = to, ascending. Intervals in which bounds show
/// that there is none, or at most one, are settled directly; others are halved. An interval in which the
/// absolute value is nowhere above `negligible` counts as one zero.
[[nodiscard]] std::vector<double> zeros_of(const LawPieces& law, const LawPiece& piece, int k, double from,
                                           double to, double negligible);

}  // namespace higherpair

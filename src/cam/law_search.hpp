#pragma once

#include "law_pieces.hpp"

#include <vector>

namespace higherpair {

/// Zeros of the k-th derivative of a piece from x = from to x = to, ascending. Intervals in which bounds
/// leave none, or one at most, are settled by them; others are halved. What is smaller than `negligible`
/// throughout an interval is one zero.
[[nodiscard]] std::vector<double> zeros_of(const LawPieces& law, const LawPiece& piece, int k, double from,
                                           double to, double negligible);

}  // namespace higherpair

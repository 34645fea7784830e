#pragma once

#include "json_writer.hpp"

#include <span>

namespace higherpair {

/// Writes numbers, one for each row, as short JSON that web/src/packed.ts reads:
///     null                                  none is finite
///     v                                     all are v
///     [e, n, "digits", from, to, …]         rows from ≤ k < to are undefined; the others, times 10^e, are
///                                           whole numbers, whose n-th differences are written in base 32
/// Smoothly varying numbers take two or three characters a row.
/// \param step  largest step to which numbers may be rounded; > 0
void write_packed(JsonWriter& json, std::span<const double> values, double step);

}  // namespace higherpair

#pragma once

#include "tangency_sheet.hpp"

#include <array>
#include <memory>
#include <optional>

// Proofs that a sheet's function has no zero in a cell without zeros on its rim.

namespace higherpair {

/// A stretch of a boundary with its enclosure; its two halves and its two ends are computed on demand.
class StretchNode {
public:
  StretchNode(const TangencySheet& sheet, bool first, int span, const Bounds& t);

  [[nodiscard]] int span() const { return span_; }
  [[nodiscard]] const Bounds& t() const { return t_; }
  [[nodiscard]] const SheetStretch& stretch() const { return stretch_; }
  [[nodiscard]] bool is_place() const { return t_.low == t_.high; }
  [[nodiscard]] StretchNode& half(bool high) { return child(high ? 1 : 0); }
  [[nodiscard]] StretchNode& end(bool high) { return child(high ? 3 : 2); }

private:
  [[nodiscard]] StretchNode& child(std::size_t k);

  const TangencySheet* sheet_;
  bool first_;
  int span_;
  Bounds t_;
  SheetStretch stretch_;
  std::array<std::unique_ptr<StretchNode>, 4> children_;  // halves, ends
};

/// What a search of a cell for zeros of F - level has found.
struct CellLook {
  std::optional<Vector2d> place;  ///< the two parameters of a point where it has the opposite sign
  bool proven = true;             ///< false: no such point was found, but a zero could not be excluded
};

/// Searches the cell of two stretches on whose rim F - level has the sign of `sign`. Parts of it are
/// discarded where their bounds exclude a zero, or where F is monotonic in one parameter and has no zero at
/// the end where sign·F is least; the others are halved.
[[nodiscard]] CellLook look_into_cell(const TangencySheet& sheet, StretchNode& one, StretchNode& two,
                                      double level, double sign);

}  // namespace higherpair

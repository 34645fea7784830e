#pragma once

#include "tangency_sheet.hpp"

#include <array>
#include <memory>
#include <optional>

// Proofs that a sheet's function has no zero in a cell that has none on its rim.

namespace higherpair {

/// A stretch of a boundary, what encloses it, and the two halves and two ends of it, worked out when they are
/// asked for.
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

/// Whether F - level is 0 somewhere in a cell.
struct CellLook {
  std::optional<Vector2d> place;  ///< the two parameters of a place where it has the other sign
  bool proven = true;             ///< false: there is no such place, but a zero could not be excluded
};

/// Looks into the cell of two stretches on whose rim F - level has the sign of `sign`: parts of it are
/// left out where their bounds exclude a zero, or where F rises or falls with one parameter throughout and
/// has none on the side on which it is least; the others are halved.
[[nodiscard]] CellLook look_into_cell(const TangencySheet& sheet, StretchNode& one, StretchNode& two,
                                      double level, double sign);

}  // namespace higherpair

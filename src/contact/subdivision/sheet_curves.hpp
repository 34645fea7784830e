#pragma once

#include "higherpair/contact/contact_map.hpp"
#include "tangency_sheet.hpp"

#include <optional>
#include <vector>

// The curves along which a function of two places is zero.

namespace higherpair {

/// A short and nearly straight part of such a curve, on which each of the two places stays within one span.
struct SheetStep {
  BoundaryPlace from1, from2;
  BoundaryPlace to1, to2;
  Vector2d width = Vector2d::Ones();  ///< of the cell that contains it: the unit of the parameters
};

struct SheetCurve {
  /// Each begins where the previous one ends; at a joint, with the place on the next span.
  std::vector<SheetStep> steps;
  bool closed = false;
  int ends_at_begin = 0, ends_at_end = 0;  ///< of an open curve: the boundary, 1 or 2, that ends there
};

struct SheetCurves {
  std::vector<SheetCurve> curves;
  bool complete = true;  ///< false: a curve was lost, or could not be separated from another one
};

/// All tangencies of a sheet. The spans of both boundaries are cut into parts fine enough to show their
/// shape; zeros are found along all sides of the cells of this grid; cells are halved until each is crossed
/// by one nearly straight curve, and bounds of F or of its slopes exclude an additional closed one. Curves of
/// equal normals do not pass corners: they end there.
/// \param range  once it is stopped, some are missing
[[nodiscard]] SheetCurves sheet_curves(const TangencySheet& sheet, const MapRange& range);

/// A point of a step: the zero of F, to within rounding, on the line perpendicular to its chord (in widths of
/// the cell) at the fraction `share` (0: from, 1: to). None if Newton's method finds none nearby.
struct SheetPlaces {
  BoundaryPlace place1, place2;
  SheetPoint at;
};
[[nodiscard]] std::optional<SheetPlaces> place_on(const TangencySheet& sheet, const SheetStep& step,
                                                  double share);

}  // namespace higherpair

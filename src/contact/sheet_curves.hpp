#pragma once

#include "higherpair/contact/contact_map.hpp"
#include "tangency_sheet.hpp"

#include <optional>
#include <vector>

// The curves along which a function of two places is zero.

namespace higherpair {

/// A short and nearly straight part of such a curve: the two places move within one span each.
struct SheetStep {
  BoundaryPlace from1, from2;
  BoundaryPlace to1, to2;
  Vector2d width = Vector2d::Ones();  ///< of the cell that it lies in: what the parameters are compared by
};

struct SheetCurve {
  std::vector<SheetStep>
      steps;  ///< each begins where the one before ends; at a joint by another span's place
  bool closed = false;
  int ends_at_begin = 0, ends_at_end = 0;  ///< of an open one: the boundary, 1 or 2, that has an end there
};

struct SheetCurves {
  std::vector<SheetCurve> curves;
  bool complete = true;  ///< false: a curve was lost, or could not be told from another one
};

/// All tangencies of a sheet. The spans of both boundaries are cut into the parts that show their shape; on
/// every side of the cells of that grid the zeros are found; cells are halved until each is crossed by one
/// nearly straight curve, and bounds of F or of its slopes exclude a closed one besides.
/// Normals that are equal do not pass corners: such curves end there.
/// \param range  where is_stopped(range) some are missing
[[nodiscard]] SheetCurves sheet_curves(const TangencySheet& sheet, const MapRange& range);

/// A place on a step: on the line that crosses its chord at right angles (in widths of the cell) at `share`
/// (0: from, 1: to) the zero of F, to within rounding. None where Newton's method finds none near.
struct SheetPlaces {
  BoundaryPlace place1, place2;
  SheetPoint at;
};
[[nodiscard]] std::optional<SheetPlaces> place_on(const TangencySheet& sheet, const SheetStep& step,
                                                  double share);

}  // namespace higherpair

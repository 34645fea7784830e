#pragma once

#include "higherpair/geometry/contour.hpp"
#include "higherpair/io/units.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair::io_detail {

/// A line, arc or other curve of a drawing, in metres.
struct DxfPiece {
  ContourPiece piece;
  std::optional<Curve> whole;  ///< of a circle or ellipse without ends
  std::size_t layer = 0;       ///< index of DxfDrawing::layers
  int line = 0;                ///< of the file, on which its entity begins
};

/// What may hold curves too but is not read: the insertion of a block, a 3D face.
struct DxfStranger {
  std::string type;
  std::size_t layer = 0;
  int line = 0;
};

struct DxfDrawing {
  std::vector<std::string> layers;  ///< of what was read, in the order of the file
  std::vector<DxfPiece> pieces;
  std::vector<DxfStranger> strangers;
};

struct DxfFault {
  int line = 0;
  std::string message;
};

/// Reads the lines and curves in the model space of an ASCII drawing: LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE
/// and POLYLINE with bulges, SPLINE. Heights above the plane are left out, as is what has no curves (texts,
/// dimensions, hatches, points). Entities seen from below are mirrored.
/// \param unit       of its numbers; none: what its header says ($INSUNITS)
/// \param otherwise  where the header says nothing either
[[nodiscard]] tl::expected<DxfDrawing, DxfFault> read_dxf(std::string_view text, std::optional<Unit> unit,
                                                          Unit otherwise);

}  // namespace higherpair::io_detail

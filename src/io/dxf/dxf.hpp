#pragma once

#include "higherpair/geometry/contour.hpp"
#include "higherpair/io/units.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair::io_detail {

/// How the sweep of an arc is given.
enum class DxfSweep { kNone, kBulge, kAngles };

/// The most decimals with which numbers of one kind are written.
struct DxfDecimals {
  int lengths = 0;
  int bulges = 0;
  int angles = 0;
};

/// A line, arc or other curve of a drawing, in metres.
struct DxfPiece {
  ContourPiece piece;
  std::optional<Curve> whole;  ///< the whole curve, if it is a full circle or ellipse
  std::size_t layer = 0;       ///< index of DxfDrawing::layers
  int line = 0;                ///< line of the file on which its entity begins
  DxfSweep sweep = DxfSweep::kNone;
  std::string type;      ///< of its entity: "LINE"
  DxfDecimals decimals;  ///< of its entity's numbers
};

/// An entity that may contain curves but is not read, such as a block insertion or a 3D face.
struct DxfStranger {
  std::string type;
  std::size_t layer = 0;
  int line = 0;
};

struct DxfDrawing {
  std::vector<std::string> layers;  ///< of the entities read, in the order of the file
  std::vector<DxfPiece> pieces;
  std::vector<DxfStranger> strangers;
  double unit = 1;  ///< of its lengths [m]
};

struct DxfFault {
  int line = 0;
  std::string message;
};

/// Reads the lines and curves in the model space of an ASCII drawing: LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE
/// and POLYLINE with bulges, SPLINE. Heights above the plane are dropped, and so are entities without curves
/// (texts, dimensions, hatches, points). Entities seen from below are mirrored.
/// \param unit       of its numbers; none: the unit in its header ($INSUNITS)
/// \param otherwise  the unit where the header gives none either
[[nodiscard]] tl::expected<DxfDrawing, DxfFault> read_dxf(std::string_view text, std::optional<Unit> unit,
                                                          Unit otherwise);

}  // namespace higherpair::io_detail

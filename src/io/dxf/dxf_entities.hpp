#pragma once

#include "dxf.hpp"
#include "dxf_pairs.hpp"

namespace higherpair::io_detail {

/// The curves of one entity of a drawing, in metres.
struct DxfShape {
  std::vector<ContourPiece> pieces;
  std::optional<Curve> whole;  ///< the whole curve, if it is a full circle or ellipse
};

/// Whether an entity of this type is a curve that dxf_shape() reads.
[[nodiscard]] bool is_dxf_curve(std::string_view type);

/// \pre is_dxf_curve(entity.type)
/// \param vertices  of a POLYLINE: the groups that follow it
/// \param unit      converts its numbers to metres
[[nodiscard]] tl::expected<DxfShape, DxfFault> dxf_shape(const DxfGroup& entity,
                                                         const std::vector<DxfGroup>& vertices,
                                                         const Scaling& unit);

}  // namespace higherpair::io_detail

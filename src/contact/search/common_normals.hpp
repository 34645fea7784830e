#pragma once

#include "higherpair/contact/common_normal.hpp"
#include "higherpair/geometry/curve_queries.hpp"

#include <optional>

namespace higherpair {

/// The normals n for which one body has a point with the outward normal n and the other one with -n.
struct CommonNormals {
  std::optional<NormalArc> arc;  ///< none: all normals
  bool empty = false;
  bool cover_ring = true;  ///< whether these are all normals of the ring, if one of the bodies is a ring
};

/// \pre neither curve is a line
[[nodiscard]] CommonNormals common_normals(const PlacedCurve<double>& curve1,
                                           const PlacedCurve<double>& curve2);

/// Whether the gap along a common normal is a minimum: κ1 + κ2 + g κ1 κ2 > 0.
[[nodiscard]] bool is_least_gap(const CommonNormal& at);

}  // namespace higherpair

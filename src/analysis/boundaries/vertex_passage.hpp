#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/contact/near_places.hpp"

#include <cstddef>
#include <optional>

namespace higherpair {

/// A corner of one body of a contact has come to the end of a face of the other, at a convex corner or a
/// notch, in run.at.state.
struct VertexPassage {
  NearPlace beyond;      ///< the place that touches there too and at which the contact goes on
  std::size_t side = 0;  ///< the body whose face ends: 0 the contact's first, 1 its second
  bool notch = false;
};

/// How a contact of two corners goes on; by themselves they do not determine a common normal. Beyond a notch
/// the corner slides on the next face. At a convex corner the normal turns on until it is again that of a
/// face: of the next face of that body, or of the other body's face beside its corner. None elsewhere, and
/// where the corner does not enter the notch.
[[nodiscard]] std::optional<VertexPassage> vertex_passage(const Run& run, std::size_t contact);

}  // namespace higherpair

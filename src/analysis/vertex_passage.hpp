#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/contact/near_places.hpp"

#include <cstddef>
#include <optional>

namespace higherpair {

/// Where a corner of one body of a contact has come to the end of a face of the other, at a convex corner or
/// a notch, in run.at.state.
struct VertexPassage {
  NearPlace beyond;      ///< that touches there too, and that the contact goes on at
  std::size_t side = 0;  ///< whose face ends: 0 the contact's first body, 1 its second
  bool notch = false;
};

/// Two corners have no normal in common by themselves. Beyond a notch the corner slides on the next face. At
/// a convex corner the normal turns on until it is that of a face again: of the next face of that body, or of
/// the other body's face beside its corner. None elsewhere, and where the corner does not go into the notch.
[[nodiscard]] std::optional<VertexPassage> vertex_passage(const Run& run, std::size_t contact);

}  // namespace higherpair

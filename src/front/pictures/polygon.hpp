#pragma once

#include "higherpair/analysis/row.hpp"
#include "higherpair/drawing/picture.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/io/units.hpp"
#include "higherpair/mechanism/description.hpp"

#include <vector>

namespace higherpair {

/// The polygons of a row in the units of tables: of velocities, of accelerations, and of the forces on each
/// body. \param reactions  null: without those of forces
[[nodiscard]] std::vector<Polygon> polygons_in(const Mechanism& mechanism, const MotionRow& row,
                                               const Reactions* reactions, const Units& units);

}  // namespace higherpair

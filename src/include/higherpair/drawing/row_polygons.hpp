#pragma once

#include "higherpair/analysis/row.hpp"
#include "higherpair/drawing/picture.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/mechanism/description.hpp"

#include <string>
#include <vector>

namespace higherpair {

/// The velocities of the joints' points and of the centres of curvature of contacts: from the pole (0, 0) an
/// arrow to each, and between those of one body, or of one equivalent link, their relative velocity. A point
/// that slides along a moving body is related to the point of that body with which it coincides at that
/// instant (A′). If the rates are not defined there are no arrows but a note.
[[nodiscard]] Polygon velocity_polygon(const Mechanism& mechanism, const MotionRow& row);

/// The accelerations of the same points, those of joints also in their normal and tangential parts, those
/// along a slide with Coriolis' acceleration.
[[nodiscard]] Polygon acceleration_polygon(const Mechanism& mechanism, const MotionRow& row);

/// For every moving body all forces on it, head to tail: weight, inertia, loads, springs, driving forces,
/// then joints and contacts. The polygons close. A body on which no force acts has none; a note names a force
/// that the balance does not determine.
[[nodiscard]] std::vector<Polygon> force_polygons(const Mechanism& mechanism, const MotionRow& row,
                                                  const Reactions& reactions);

/// The polygon in another unit.
/// \param factor  by which its numbers are multiplied
[[nodiscard]] Polygon in_unit(Polygon polygon, double factor, const std::string& unit);

}  // namespace higherpair

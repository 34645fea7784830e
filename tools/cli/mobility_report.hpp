#pragma once

#include "higherpair/front/mobility.hpp"

#include <string>

#include <nlohmann/json.hpp>

namespace higherpair::cli {

/// The findings as JSON, lengths and angles in the profile's units. Keys:
/// - `format` 1, `title`; `mobility` (by rank) and `useful` (without idle freedoms), null if not assembled
/// - `count`: `bodies`, `joints`, `revolute`, `prismatic`, `slot`, `slipping`, `rolling`, `gears`, `belts`,
/// `sum_f`, `mobility`,
///   `formula`, `multiple_pins` [{`bodies`, `joints`}]
/// - `rank` (null if not assembled): `conditions`, `coordinates`, `rank`, `positions`, `freedom`, `at_start`,
///   `shaky`, `singular`
/// - `idle` [{`body`, `x`, `y`, `text`}]
/// - `redundant` [{`conditions`, `cause`, `joints`, `contacts`, `bodies`}] with `cause` one of `same_pin`,
///   `parallel_cranks`, `rolling_on_pivots`, `sliding_on_pivots`, `slides_alone`, `member`
/// - `structure`: `determinate`, `indeterminate` or null; `explanations` [sentences]
/// - `drivers`: `given`, `needed`, `missing`, `useless` [joints], `joints_to_drive`, `loose_bodies`,
///   `objection` (null if they fit)
/// - `plan` [{`bodies`, `text`}]
/// - `four_bars` [{`ground`, `crank`, `coupler`, `rocker`, `lengths` [r1 … r4], `grashof`, `margin`
///   (p + q - s - l), `full_turn`, `limits`, `transmission`}]: `full_turn` {`crank`, `coupler`, `rocker`};
///   `limits` the same with lists of {`crank`, `coupler`, `rocker`, `change_point`}: positions in which that
///   link stands still, its dead points as a driver; `transmission` {`smallest`, `at_smallest`, `largest`,
///   `at_largest`}; all angles from the line of the ground pivots
/// - `slider_cranks` [{`guide`, `crank`, `coupler`, `slider` (null: a slot), `joint`, `inversion`, `r2`,
/// `r3`,
///   `offset`, `stroke`, `harmonic`, `quick_return`}]: `stroke` null or {`length`, `time_ratio`, `turn_in`,
///   `outer`, `inner`
///   {`crank`, `slider`}}, crank angles from the line of sliding; `harmonic` null (with an offset) or the
///   largest errors {`position`, `velocity`, `acceleration`} in units of r, rω, rω²; `quick_return` null
///   unless ground is the crank or coupler of the loop, then by what its parts are called in that inversion:
///   `frame`, `crank`, `lever` (null: a slot in the rod), `ram` (null if there is none), `frame_length`,
///   `crank_length`, and null where the crank does not turn fully: `lever_turns`, `swing`, `time_ratio`
/// - `gears`: see mobility_gears.hpp
/// - `instant_centers` [{`bodies` [two], `kind` `point` | `at_infinity` | `undefined`, `x`, `y` (for
/// `at_infinity`
///   the unit direction)}], empty where the drivers do not set all velocities
[[nodiscard]] nlohmann::ordered_json mobility_json(const MobilityFindings& findings);

/// The same as readable text.
[[nodiscard]] std::string mobility_text(const MobilityFindings& findings);

/// The findings as CSV, `key,value`: one row for each value of mobility_json, its key the path to it
/// (`four_bars/0/grashof`). Text that holds a comma or a quote is quoted.
[[nodiscard]] std::string mobility_csv(const MobilityFindings& findings);

}  // namespace higherpair::cli

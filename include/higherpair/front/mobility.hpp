#pragma once

#include "higherpair/front/model.hpp"
#include "higherpair/mechanism/mobility.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// Bodies whose positions are solved together, and how.
struct PlanStep {
  std::vector<int> bodies;  ///< indices into Mechanism::bodies
  std::string text;
};

/// The mobility of a mechanism, and how it is solved.
struct MobilityFindings {
  Model model;
  Mobility mobility;           ///< SI units
  std::vector<PlanStep> plan;  ///< in the order of solution; empty if the drivers do not determine the
                               ///< positions of all bodies
  std::optional<std::string> objection;  ///< why it cannot be run
};

/// Counts freedoms, finds the rank, and tries to start the mechanism. Fails only for invalid input, such as a
/// driver's positions or a tolerance that is not > 0.
[[nodiscard]] Result<MobilityFindings> mobility_of(const Model& model, double tolerance = 1e-9);

/// The findings as the text of a JSON object, lengths and angles in the profile's units. Keys:
/// - `format` 1, `title`; `mobility` (by rank) and `useful` (without idle freedoms), null if not assembled
/// - `count`: `bodies`, `joints`, `revolute`, `prismatic`, `slot`, `slipping`, `rolling`, `gears`, `belts`,
///   `sum_f`, `mobility`, `formula`, `multiple_pins` [{`bodies`, `joints`}]
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
///   link is at rest, its dead points as a driver; `transmission` {`smallest`, `at_smallest`, `largest`,
///   `at_largest`}; all angles from the line of the ground pivots
/// - `slider_cranks` [{`guide`, `crank`, `coupler`, `slider` (null: a slot), `joint`, `inversion`,
///   `r2`, `r3`, `offset`, `stroke`, `harmonic`, `quick_return`}]: `stroke` null or {`length`,
///   `time_ratio`, `turn_in`, `outer`, `inner` {`crank`, `slider`}}, crank angles from the line of
///   sliding; `harmonic` null (with an offset) or the largest errors {`position`, `velocity`,
///   `acceleration`} in units of r, rω, rω²; `quick_return` null unless ground is the crank or coupler of
///   the loop, then with its parts as they are called in that inversion: `frame`, `crank`, `lever` (null: a
///   slot in the rod), `ram` (null if there is none), `frame_length`, `crank_length`, and null where the
///   crank does not turn fully: `lever_turns`, `swing`, `time_ratio`
/// - `gears` [{`joint`, `first`, `second` (bodies), `pitch_radii` [two], `pressure_angle`, `module` (null if
///   not given), `teeth` [two] (null where they are no whole numbers), `mesh`}], those whose teeth are known:
///   `mesh`, of outer gears with whole teeth, else null: {`approach`, `recess`, `length` of the path of
///   contact, `contact_ratio`, `past_base` [two] (> 0: interference at that wheel's root), `least_teeth`
///   (fewer are undercut by a rack)}
/// - `instant_centers` [{`bodies` [two], `kind` `point` | `at_infinity` | `undefined`, `x`, `y` (for
///   `at_infinity` the unit direction)}], empty where the drivers do not set all velocities
[[nodiscard]] std::string mobility_json(const MobilityFindings& findings);

/// The same in sentences, with the Grashof class of every four-bar and the stroke of every slider-crank.
[[nodiscard]] std::string mobility_text(const MobilityFindings& findings);

/// The same as CSV, `key,value`: one row for each value of mobility_json, its key the path to it
/// (`four_bars/0/grashof`). Text that holds a comma or a quote is quoted.
[[nodiscard]] std::string mobility_csv(const MobilityFindings& findings);

}  // namespace higherpair

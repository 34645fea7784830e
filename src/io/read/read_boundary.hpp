#pragma once

#include "higherpair/geometry/contour.hpp"
#include "reading.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair::io_detail {

/// Pieces of a boundary as they were read, each beginning where the one before ends.
struct Outline {
  std::vector<ContourPiece> pieces;
  bool closed = false;
  double tolerance = 0;     ///< ends that are no farther apart count as meeting [m]
  bool has_inside = false;  ///< an open curve that has an inside, as a closed one has
  /// What messages call each piece: "spans.2", "line 120"; empty: they speak of the whole curve.
  std::vector<std::string> names = {};
  /// The points by which the curve was given, and their names for messages.
  std::vector<Vector2d> points = {};
  std::vector<std::string> point_names = {};
  bool has_fillet = false;                    ///< whether the type of the curve has the key `fillet`
  std::optional<Curve> whole = std::nullopt;  ///< the circle or ellipse that all of it is, if any
};

/// The curve with its material on the side that its table gives (`side` for a closed one, `material` for an
/// open one). None if its pieces do not meet or it crosses itself, which is reported.
[[nodiscard]] std::optional<NamedCurve> curve_of(TableReader& table, Outline outline);

/// The curve as its outline is directed, with the material on the left.
[[nodiscard]] std::optional<NamedCurve> boundary_curve(TableReader& table, const Outline& outline);

/// Whether two neighbouring pieces do not meet; reports the first gap.
[[nodiscard]] bool report_gaps(TableReader& table, const Outline& outline);

/// \name Curves made of spans, by type; each reports its mistakes and then returns none.
/// @{
[[nodiscard]] std::optional<NamedCurve> read_arc(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_segment(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_chain(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_spline(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_involute(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_gear(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_dxf_curve(TableReader& table);
/// The distance `by` of an offset, whose other keys have been asked for; nothing if one of them is wrong.
[[nodiscard]] std::optional<double> read_offset_distance(TableReader& table);
/// The curve at this distance from another one of the same body.
[[nodiscard]] std::optional<NamedCurve> read_offset(TableReader& table, double by, const NamedCurve& source);
/// @}

/// \name Single pieces, as curves of their own or as parts of a chain
/// @{
[[nodiscard]] std::optional<ContourPiece> arc_piece(TableReader& table);
[[nodiscard]] std::optional<ContourPiece> segment_piece(TableReader& table);
[[nodiscard]] std::optional<ContourPiece> involute_piece(TableReader& table);
/// \param closed  whether the spline returns to its first point
[[nodiscard]] std::optional<ContourPiece> spline_piece(TableReader& table, bool closed);
/// @}

/// \name For messages, in the profile's units
/// @{
[[nodiscard]] std::string length_text(const Reading& reading, double metres);
[[nodiscard]] std::string point_text(const Reading& reading, const Vector2d& p);
/// @}

}  // namespace higherpair::io_detail

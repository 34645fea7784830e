#pragma once

#include "higherpair/geometry/contour.hpp"
#include "higherpair/geometry/spline_span.hpp"
#include "reading.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair::io_detail {

/// What was read, unless there was a mistake since.
class Mistakes {
public:
  explicit Mistakes(const Reading& reading) : reading_(reading), before_(reading.mistakes.size()) {}
  [[nodiscard]] bool none() const { return reading_.mistakes.size() == before_; }

private:
  const Reading& reading_;
  std::size_t before_;
};

/// Pieces of a boundary as they were read, each beginning where the one before ends.
struct Outline {
  std::vector<ContourPiece> pieces;
  bool closed = false;
  double tolerance = 0;     ///< ends that are no farther apart meet [m]
  bool has_inside = false;  ///< as a closed one has, although it is open
  /// What messages call a piece: "spans.2", "line 120"; none: the whole curve.
  std::vector<std::string> names = {};
  /// The points that the curve was given by, and their names for messages.
  std::vector<Vector2d> points = {};
  std::vector<std::string> point_names = {};
  std::optional<Curve> whole = std::nullopt;  ///< what all of it is, where that has closed forms
};

/// The curve on whichever side its table says (`side` of a closed one, `material` of an open one), if it is a
/// boundary that does not cross itself.
[[nodiscard]] std::optional<NamedCurve> curve_of(TableReader& table, Outline outline);

/// The same as it is, its material on the left.
[[nodiscard]] std::optional<NamedCurve> boundary_curve(TableReader& table, const Outline& outline);

/// Whether two neighbours do not meet, which is reported.
[[nodiscard]] bool report_gaps(TableReader& table, const Outline& outline);

/// \name Curves that are boundaries of spans, by their type; each reports its mistakes and then returns none.
/// @{
[[nodiscard]] std::optional<NamedCurve> read_arc(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_segment(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_chain(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_spline(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_involute(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_gear(TableReader& table);
[[nodiscard]] std::optional<NamedCurve> read_dxf_curve(TableReader& table);
/// The curve at a distance from another one of the same body.
[[nodiscard]] std::optional<NamedCurve> read_offset(TableReader& table, const NamedCurve& source);
/// @}

/// \name Pieces, alone or in a chain
/// @{
[[nodiscard]] std::optional<ContourPiece> arc_piece(TableReader& table);
[[nodiscard]] std::optional<ContourPiece> segment_piece(TableReader& table);
[[nodiscard]] std::optional<ContourPiece> involute_piece(TableReader& table);
/// \param closed  whether the spline goes back to its first point
[[nodiscard]] std::optional<ContourPiece> spline_piece(TableReader& table, bool closed);
/// @}

/// \name For messages, in the profile's units
/// @{
[[nodiscard]] std::string length_text(const Reading& reading, double metres);
[[nodiscard]] std::string point_text(const Reading& reading, const Vector2d& p);
/// @}

}  // namespace higherpair::io_detail

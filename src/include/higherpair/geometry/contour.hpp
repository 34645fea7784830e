#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// \name Pieces of a contour as in drawings, each from its beginning to its end [m, rad].
/// @{
struct LinePiece {
  Vector2d from = Vector2d::Zero();
  Vector2d to = Vector2d::Zero();
};

struct ArcPiece {
  Vector2d center = Vector2d::Zero();
  double radius = 1;
  double from = 0;   ///< angle of its beginning, seen from the centre
  double sweep = 0;  ///< > 0 counter-clockwise, at most a full turn
};

/// Any other curve is a span.
using ContourPiece = std::variant<LinePiece, ArcPiece, SpanPtr>;
/// @}

struct PieceEnd {
  Vector2d p_B = Vector2d::Zero();
  Vector2d t_B = Vector2d::UnitX();  ///< direction of the path
};

/// The end of a part of a span that ends at t.
[[nodiscard]] PieceEnd end_at(const Span& span, double t);
[[nodiscard]] PieceEnd begin_of(const ContourPiece& piece);
[[nodiscard]] PieceEnd end_of(const ContourPiece& piece);
[[nodiscard]] ContourPiece reversed(const ContourPiece& piece);
/// The span with the material on the left of the path.
[[nodiscard]] SpanPtr span_of(const ContourPiece& piece);
[[nodiscard]] std::vector<SpanPtr> spans_of(const std::vector<ContourPiece>& pieces);

/// The whole contour in the opposite sense.
[[nodiscard]] std::vector<ContourPiece> reversed(const std::vector<ContourPiece>& pieces);

/// Twice the area enclosed on the left of a closed contour, from as many points as its spans need to show
/// their shape: < 0 where it runs clockwise [m²].
[[nodiscard]] double enclosed_area(const std::vector<ContourPiece>& pieces);

/// Half the diagonal of the box around all pieces [m].
[[nodiscard]] double size_of(const std::vector<ContourPiece>& pieces);

/// Moves the ends of straight lines onto the ends of their neighbours, where rounding separates them.
/// \pre every piece ends where the next begins, to within rounding
void close_gaps(std::vector<ContourPiece>& pieces, bool closed);

/// The arc between two points that turns through `sweep` [rad]; below kStraightSweep a line.
[[nodiscard]] ContourPiece bow_piece(const Vector2d& from, const Vector2d& to, double sweep);

/// How an arc was given by rounded numbers.
struct SweepRounding {
  double error = 0;        ///< largest error of its sweep [rad]
  bool of_circle = false;  ///< given by the centre and radius of its circle
};

/// Makes joints of arcs with arcs and lines smooth where no more than rounded numbers, as in a drawing, keeps
/// them from it. Lines between circles that are given become tangents. Otherwise it is the least change of
/// the ends and sweeps of the pieces, each relative to its rounding, under which their directions agree;
/// nothing changes where that would take more than the rounding.
///
/// \param length  step to which coordinates are rounded [m]
/// \param sweeps  of each piece; ignored for others than arcs
void undo_rounding(std::vector<ContourPiece>& pieces, bool closed, double length,
                   std::span<const SweepRounding> sweeps);

struct Contour {
  std::vector<ContourPiece> pieces;  ///< each begins where the one before ends
  /// Index of the given piece each comes from; for a fillet that of the piece before it.
  std::vector<int> sources;
  bool closed = false;
};

/// Why corners cannot be given fillets.
struct FilletFault {
  enum class Kind {
    kTooLarge,  ///< the fillet does not fit between its neighbours
    kOther,     ///< a corner at a piece that is neither line nor arc
    kCusp,      ///< the path turns back
  } kind = Kind::kTooLarge;
  int piece = 0;                     ///< the first of the two that meet there
  Vector2d at_B = Vector2d::Zero();  ///< the corner
};

/// Replaces every corner between lines and arcs, convex or not, by a tangent arc of this radius [m].
[[nodiscard]] tl::expected<Contour, FilletFault> with_fillets(const std::vector<ContourPiece>& pieces,
                                                              bool closed, double radius);

/// The largest radius up to `radius` [m] that fits everywhere, to three digits; 0: none.
[[nodiscard]] double largest_fillet(const std::vector<ContourPiece>& pieces, bool closed, double radius);

/// More than two ends meet, so that the continuation is ambiguous.
struct JoinFault {
  Vector2d at_B = Vector2d::Zero();
  std::vector<int> pieces;  ///< at least three, that meet there
};

/// Joins pieces in any order and sense to contours: ends within `tolerance` [m] of each other meet. In the
/// order of their first pieces.
[[nodiscard]] tl::expected<std::vector<Contour>, JoinFault> join(const std::vector<ContourPiece>& pieces,
                                                                 double tolerance);

/// Two places of a boundary at the same point.
struct SelfCrossing {
  BoundaryPlace first;
  BoundaryPlace second;
  Vector2d p_B = Vector2d::Zero();
};

/// The first self-crossing along a boundary; crossings that would need a finer division than the parts of its
/// spans may be missed.
[[nodiscard]] std::optional<SelfCrossing> find_self_crossing(const Boundary& boundary);

/// Why a boundary has no offset.
struct OffsetFault {
  enum class Kind {
    kCusp,    ///< the offset is not smaller than the radius of curvature there
    kCorner,  ///< its neighbours' offsets would cross there
  } kind = Kind::kCusp;
  Vector2d at_B = Vector2d::Zero();
  double limit = 0;  ///< kCusp: what the offset's size must stay below [m]
};

/// The spans at a distance [m] along the outward normals (< 0: into the material). Corners become arcs; an
/// arc whose offset would shrink to its centre is left out, so that its neighbours meet in a corner.
[[nodiscard]] tl::expected<std::vector<SpanPtr>, OffsetFault> offset_spans(const Boundary& boundary,
                                                                           double distance);

}  // namespace higherpair

#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <optional>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// \name Pieces of a contour as drawings have them, each from its begin to its end [m, rad].
/// @{
struct LinePiece {
  Vector2d from = Vector2d::Zero();
  Vector2d to = Vector2d::Zero();
};

struct ArcPiece {
  Vector2d center = Vector2d::Zero();
  double radius = 1;
  double from = 0;   ///< angle of its begin, seen from the centre
  double sweep = 0;  ///< > 0 counter-clockwise, at most a full turn
};

/// Of any other curve a span.
using ContourPiece = std::variant<LinePiece, ArcPiece, SpanPtr>;
/// @}

struct PieceEnd {
  Vector2d p_B = Vector2d::Zero();
  Vector2d t_B = Vector2d::UnitX();  ///< direction of the path
};

[[nodiscard]] PieceEnd begin_of(const ContourPiece& piece);
[[nodiscard]] PieceEnd end_of(const ContourPiece& piece);
[[nodiscard]] ContourPiece reversed(const ContourPiece& piece);
/// The span with the material on the left of the path.
[[nodiscard]] SpanPtr span_of(const ContourPiece& piece);
[[nodiscard]] std::vector<SpanPtr> spans_of(const std::vector<ContourPiece>& pieces);

/// The whole contour, run through the other way.
[[nodiscard]] std::vector<ContourPiece> reversed(const std::vector<ContourPiece>& pieces);

/// Twice the area on the left of a closed contour, by as many points as its spans take to show their shape:
/// < 0 where it runs clockwise [m²].
[[nodiscard]] double enclosed_area(const std::vector<ContourPiece>& pieces);

/// Half the diagonal of the box around all pieces [m].
[[nodiscard]] double size_of(const std::vector<ContourPiece>& pieces);

/// Puts the ends of straight lines onto the ends of their neighbours, where they are apart by rounding only.
/// \pre every piece ends where the next begins, but for rounding
void close_gaps(std::vector<ContourPiece>& pieces, bool closed);

struct Contour {
  std::vector<ContourPiece> pieces;  ///< each begins where the one before ends
  std::vector<int> sources;          ///< indices of them as given; of a rounding the piece before it
  bool closed = false;
};

/// Why corners cannot be rounded.
struct FilletFault {
  enum class Kind {
    kTooLarge,  ///< the rounding does not fit between its neighbours
    kOther,     ///< a corner at a piece that is neither line nor arc
    kCusp,      ///< the path turns back
  } kind = Kind::kTooLarge;
  int piece = 0;                     ///< the first of the two that meet there
  Vector2d at_B = Vector2d::Zero();  ///< the corner
};

/// Every corner, convex or not, between lines and arcs as a tangent arc of this radius [m].
[[nodiscard]] tl::expected<Contour, FilletFault> with_fillets(const std::vector<ContourPiece>& pieces,
                                                              bool closed, double radius);

/// The largest radius up to `radius` that fits everywhere, to three digits [m]; 0: none.
[[nodiscard]] double largest_fillet(const std::vector<ContourPiece>& pieces, bool closed, double radius);

/// More than two ends meet, so that it is not clear how to go on.
struct JoinFault {
  Vector2d at_B = Vector2d::Zero();
  std::vector<int> pieces;  ///< that meet there, at least three
};

/// Pieces in any order and sense as contours: ends no farther from each other than `tolerance` [m] meet. In
/// the order of their first pieces.
[[nodiscard]] tl::expected<std::vector<Contour>, JoinFault> join(const std::vector<ContourPiece>& pieces,
                                                                 double tolerance);

/// Two places of a boundary that are one point.
struct SelfCrossing {
  BoundaryPlace first;
  BoundaryPlace second;
  Vector2d p_B = Vector2d::Zero();
};

/// Where a boundary crosses itself, the first along it; crossings that need a finer look than its spans' own
/// parts may be missed.
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

/// The spans at a distance [m] along the outward normals (< 0: into the material); corners become arcs, and
/// an arc about a centre at just this distance is left out, so that its neighbours meet in a corner.
[[nodiscard]] tl::expected<std::vector<SpanPtr>, OffsetFault> offset_spans(const Boundary& boundary,
                                                                           double distance);

}  // namespace higherpair

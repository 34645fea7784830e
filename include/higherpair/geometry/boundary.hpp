#pragma once

#include "higherpair/geometry/curve.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

class Outline;
class Polyline;

/// A point of a span, in the body's frame B; t = n turned +90°.
struct SpanPoint {
  Vector2d p_B = Vector2d::Zero();   ///< [m]
  Vector2d n_B = Vector2d::UnitX();  ///< unit outward normal
  double kappa = 0;  ///< signed curvature [1/m], > 0 where the material is convex; 0 at a corner
  double slope = 0;  ///< dκ/ds along t [1/m²]
  double speed = 1;  ///< ds/dt > 0 [m per unit of the parameter]; at a corner dφ/dt = 1
};

/// d²κ/ds², d³κ/ds³ and d⁴κ/ds⁴ along t [1/m³, 1/m⁴, 1/m⁵].
using CurvatureRates = std::array<double, 3>;

/// Enclosures of the rates of a span over an interval of its parameter, rounding included.
struct SpanBounds {
  Bounds speed;  ///< ds/dt [m per unit of the parameter]; 0 at a corner
  Bounds turn;  ///< dφ/dt = κ ds/dt of the normal's angle φ [rad per unit of the parameter]; 1 at a corner
};

/// A smooth part of a boundary as a function of a parameter that grows along the tangent t, with the material
/// on its left. Points, normals and curvatures are continuous over its range, inflections included: unlike
/// the angle of the normal, a parameter has no singularity there. A new kind of curve is a class that
/// implements this interface.
class Span {
public:
  virtual ~Span() = default;

  /// The point at a parameter within range(); the values continue smoothly a little beyond it.
  [[nodiscard]] virtual SpanPoint at(double t) const = 0;
  [[nodiscard]] virtual Bounds range() const = 0;
  /// The rates of the curvature beyond SpanPoint::slope, on which derivatives of motions beyond the third
  /// depend. None for a kind of curve that does not have them: nor have the motions, then.
  [[nodiscard]] virtual std::optional<CurvatureRates> curvature_rates(double /*t*/) const {
    return std::nullopt;
  }
  /// Bounds over an interval within range(); their excess shrinks in proportion to it. None for a kind of
  /// curve that has no bounds: no list of its contacts can be proven complete.
  [[nodiscard]] virtual std::optional<SpanBounds> bounds(const Bounds& /*t*/) const { return std::nullopt; }
  /// A convex corner: one point with all normals between those of its neighbours; t is the angle of the
  /// normal [rad].
  [[nodiscard]] virtual bool is_corner() const { return false; }
  /// Number of equal parts of the range that resolve the shape of the span to about 1 %.
  [[nodiscard]] virtual int parts() const { return 32; }
  /// Parameters within the range, ascending, between which its shape is simple: the ends of polynomial
  /// pieces, or of stretches of a motion law. Features that are narrow against the whole show in samples of
  /// each.
  [[nodiscard]] virtual std::vector<double> breaks() const { return {}; }
};

using SpanPtr = std::shared_ptr<const Span>;

/// \name Spans of the elementary curves
/// @{
/// The part of a conic between two outward normals, which turn counter-clockwise from `from` to `to` [rad];
/// with the material outside of the conic it is traversed from `to` to `from`.
/// \pre is_conic(curve); from < to <= from + 2π; an open conic has all of these normals
[[nodiscard]] SpanPtr conic_span(const Curve& curve, double from, double to);
/// A straight edge, the material on its left. \pre the two points differ
[[nodiscard]] SpanPtr face_span(const Vector2d& from_B, const Vector2d& to_B);
/// A part of the line through a point along a unit vector, by the distance from the point: near it, places on
/// a long line are exact.
[[nodiscard]] SpanPtr face_span(const Vector2d& origin_B, const Vector2d& t_B, const Bounds& range);
/// A convex corner, its normals turning counter-clockwise from `from` to `to` [rad]. \pre from < to
[[nodiscard]] SpanPtr corner_span(const Vector2d& at_B, double from, double to);
/// The same points with the material on the other side. \pre not a corner
[[nodiscard]] SpanPtr reversed_span(SpanPtr span);
/// Points at a distance [m] along the outward normals (< 0: into the material) of a span that is not a
/// corner.
/// \pre 1 + κ distance > 0 all along: no cusp
[[nodiscard]] SpanPtr offset_span(SpanPtr span, double distance);
/// @}

/// A location on a boundary.
struct BoundaryPlace {
  int span = -1;  ///< index of Boundary::spans(); -1: nowhere
  double t = 0;   ///< its parameter
};

/// How one span joins the next.
enum class SpanJoint {
  kSmooth,         ///< position, normal and curvature are continuous
  kCurvatureJump,  ///< only position and normal are continuous
  kNotch,          ///< a concave corner: no convex body touches it
  kEnd,            ///< the end of an open boundary
};

/// Why spans do not form a boundary.
struct BoundaryFault {
  enum class Kind { kEmpty, kGap, kOpen, kCusp } kind = Kind::kEmpty;
  int span = 0;         ///< the first of the two spans, or the one with the cusp
  double distance = 0;  ///< kGap, kOpen: between their ends [m]
};

/// A chain of spans, closed or open; or several chains of one body. Convex corners are spans of their own.
class Boundary {
public:
  /// \param tolerance  largest distance at which ends of neighbours count as joined [m]
  [[nodiscard]] static tl::expected<Boundary, BoundaryFault> make(std::vector<SpanPtr> spans, bool closed,
                                                                  double tolerance);

  /// Several boundaries of one body as one; their spans follow each other. \pre not empty
  [[nodiscard]] static Boundary of_parts(const std::vector<Boundary>& parts);

  [[nodiscard]] const std::vector<SpanPtr>& spans() const { return spans_; }
  /// Whether no part of it has ends.
  [[nodiscard]] bool is_closed() const { return closed_; }
  /// Whether it is one chain, convex throughout: any convex body that touches it lies entirely on the other
  /// side.
  [[nodiscard]] bool is_convex() const { return convex_; }
  /// Middle of the box around its samples, and half the diagonal of that box [m].
  [[nodiscard]] const Vector2d& middle_B() const { return middle_B_; }
  [[nodiscard]] double size() const { return size_; }
  /// The span after (`forward`) or before one in its chain; in an open chain, too, the first follows the
  /// last.
  [[nodiscard]] int next_span(int span, bool forward) const {
    return (forward ? next_ : previous_)[static_cast<std::size_t>(span)];
  }
  /// The joint at the end of a span.
  [[nodiscard]] SpanJoint joint_after(int span) const { return joints_[static_cast<std::size_t>(span)]; }

  [[nodiscard]] SpanPoint at(const BoundaryPlace& place) const {
    return spans_[static_cast<std::size_t>(place.span)]->at(place.t);
  }
  /// See Span::curvature_rates.
  [[nodiscard]] std::optional<CurvatureRates> curvature_rates(const BoundaryPlace& place) const {
    return spans_[static_cast<std::size_t>(place.span)]->curvature_rates(place.t);
  }
  /// Whether a span has the same curvature in all its samples.
  [[nodiscard]] bool is_arc(int span) const { return arcs_[static_cast<std::size_t>(span)]; }
  [[nodiscard]] bool is_corner(const BoundaryPlace& place) const {
    return spans_[static_cast<std::size_t>(place.span)]->is_corner();
  }

  /// The place an arc length `ds` [m] farther along the tangent, or on a corner a rotation `dphi` [rad] of
  /// the normal farther; across as many joints as it takes, at most onto a corner and not past it. `stopped`
  /// if an end or a notch is in the way.
  struct Advance {
    BoundaryPlace place;
    bool stopped = false;
    bool at_end = false;  ///< stopped by an end of an open chain
  };
  [[nodiscard]] Advance advance(const BoundaryPlace& from, double ds, double dphi) const;

  /// Points along the whole boundary, in order.
  struct Sample {
    BoundaryPlace place;
    SpanPoint point;
  };
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

private:
  friend const Outline& outline_of(const Boundary& boundary);
  void set_outline(std::vector<Polyline> solids);
  [[nodiscard]] std::vector<Polyline> solids() const;

  std::vector<SpanPtr> spans_;
  std::vector<SpanJoint> joints_;
  std::vector<int> next_, previous_;
  std::vector<bool> arcs_;
  std::vector<Sample> samples_;
  std::shared_ptr<const Outline> outline_;
  bool closed_ = false;
  bool convex_ = false;
  Vector2d middle_B_ = Vector2d::Zero();
  double size_ = 0;
};

/// The line, corner, circle or parabola with the same point, normal, curvature and rate of change of
/// curvature: it can replace the boundary in everything that a contact does up to jerk. Within 1e-6 or so of
/// an inflection, where no conic has that rate, the circle of curvature.
/// \param arc  whether the curve is an arc; at a vertex of another, where the rate is 0, it can vary with
///             dimensions, and so can that of a parabola but not that of a circle
[[nodiscard]] Curve local_curve(const SpanPoint& point, bool corner, bool arc = true);

/// A whole curve as a boundary. Open conics end `reach` [m] from their vertices, a line `reach` from its
/// point on either side; a point becomes a corner with all normals. \pre a curve given by its support has no
/// cusps
[[nodiscard]] Boundary boundary_of(const Curve& curve, double reach);

}  // namespace higherpair

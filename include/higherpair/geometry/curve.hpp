#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

enum class PieceKind {
  kArc,     ///< φ runs through an interval: it rises along the boundary where this is convex, and falls
            ///< where it is concave; a corner is an arc of radius 0
  kClosed,  ///< the whole curve; φ makes one full turn
  kFace,    ///< flat: one normal only
};

/// A part of a boundary, in the body's frame. Consecutive pieces share a point: if their normals agree it is
/// a smooth joint or a jump of curvature; if not, there is a corner between them, which is a piece of its
/// own. Where no piece follows, the boundary ends.
struct SupportPiece {
  PieceKind kind = PieceKind::kArc;
  /// Range of normals [rad]; for a face it encloses the angle of its normal; unused for a closed curve.
  Bounds phi;
  Bounds along;  ///< faces only: p·t of the ends, t = normal turned +90° [m]; ±infinity: no end
};

/// The support h = p·n of a boundary point p with outward normal n(φ), both in the body's frame, and what
/// follows from it: h′ = p·t, so that p = h n + h′ t, the radius of curvature ρ = h + h″ (> 0 convex,
/// < 0 concave), and its derivative. For a face: those of any one of its points, as if it were a corner.
struct SupportValue {
  double h = 0;      ///< [m]
  double dh = 0;     ///< [m]
  double rho = 0;    ///< [m]
  double drho = 0;   ///< dρ/dφ [m]
  double error = 0;  ///< h and h′ are within this of the truth [m]
};

/// A boundary given piecewise by its support function: any curve of smooth arcs, corners and flat faces. This
/// interface is all that the library needs to find, follow and list contacts without missing any: a new kind
/// of curve is a class that implements it (see make_curve). Conics, lines and points have closed forms
/// instead. All values must be finite: Model::from() looks at some of each piece, and refuses others.
class SupportCurve {
public:
  SupportCurve() = default;
  SupportCurve(const SupportCurve&) = delete;
  SupportCurve& operator=(const SupportCurve&) = delete;
  virtual ~SupportCurve() = default;

  /// The pieces in their order along the boundary.
  [[nodiscard]] virtual const std::vector<SupportPiece>& pieces() const = 0;
  /// The support at one normal of the piece: any angle for a closed curve, else one within its bounds.
  [[nodiscard]] virtual SupportValue at(std::size_t piece, double phi) const = 0;
  /// Bounds of ρ over an interval of normals of the piece: they may be wide but never too narrow; the tighter
  /// they are, the faster the search.
  [[nodiscard]] virtual Bounds radius(std::size_t piece, const Bounds& phi) const = 0;
};

enum class CurveKind { kCircle, kEllipse, kParabola, kHyperbola, kLine, kPoint, kSupport, kChain };

/// Which side of a curve is the body: the convex one (with the focus) or the other (a ring, a slot).
enum class Side { kInside, kOutside };

/// The boundary of a body in the body's frame B: a conic, a flat face (line) or a knife edge (point), which
/// have closed forms; or any curve given by its support.
///
/// A conic is represented by a vertex on its focal axis. With x from the vertex along `axis_B` (to the convex
/// side) and y across,
///     y² = 2 ℓ x - q x²,    ℓ = semi_latus > 0,    q = 1 - e²  (e: eccentricity).
/// One form for circle (q = 1), ellipse (0 < q < 1), parabola (q = 0) and the branch of a hyperbola at that
/// vertex (q < 0). It stays well conditioned through q = 0 and for huge, nearly flat curves, where centre and
/// axes do not.
struct Curve {
  CurveKind kind = CurveKind::kPoint;
  Side side = Side::kInside;             ///< always kInside for line and point
  Vector2d vertex_B = Vector2d::Zero();  ///< vertex [m]; a point of the line; the point itself; else origin
  Vector2d axis_B = Vector2d::UnitX();  ///< unit; from the vertex to the convex side; line: into the material
  double semi_latus = 0;                ///< ℓ [m], radius of curvature at the vertex; 0 for all but conics
  double q = 1;                         ///< 1 - e²; 1 for line and point, 0 for a curve given by its support
  const SupportCurve* support = nullptr;  ///< for kSupport; not owned
  std::size_t piece = 0;                  ///< index of the piece of `support` that touches
  /// For a circle or line that stands for a nearly straight part of a boundary: κ [1/m], and dκ/ds along n
  /// turned +90° [1/m²], at the vertex; else 0.
  double kappa = 0, slope = 0;
};

enum class CurveError {
  kNotFinite,        ///< a NaN or an infinity among the numbers
  kNotPositive,      ///< a radius, semi-axis or focal length <= 0
  kZeroNormal,       ///< the normal of a line is the zero vector
  kNoQuadraticPart,  ///< A = B = C = 0: not a conic
  kImaginary,        ///< no real point satisfies the equation
  kSinglePoint,      ///< only a single point satisfies it
  kLines,            ///< it is a pair of lines (crossing, parallel or one counted twice)
  kOutOfRange,       ///< its size, place or axis ratio leaves the range of double (beyond 1e±150 or so)
  kBranchNeeded,     ///< a hyperbola, and no point near the wanted branch is given
  kBranchUnclear,    ///< the given point is as near to one branch as to the other
};

/// What the error means, as the end of a sentence: "the conic ...".
[[nodiscard]] std::string_view describe(CurveError error);

using CurveResult = tl::expected<Curve, CurveError>;

/// \name Curves by their natural parameters; lengths [m], angles [rad], all in the body's frame.
/// @{
[[nodiscard]] CurveResult make_circle(const Vector2d& center_B, double radius, Side side = Side::kInside);
/// `rotation` is the angle of the first semi-axis from the x axis.
[[nodiscard]] CurveResult make_ellipse(const Vector2d& center_B, const std::array<double, 2>& semi_axes,
                                       double rotation, Side side = Side::kInside);
/// `rotation` is the direction from the vertex to the focus.
[[nodiscard]] CurveResult make_parabola(const Vector2d& vertex_B, double focal_length, double rotation,
                                        Side side = Side::kInside);
/// The branch that opens towards `rotation`; `semi_axes` = {a, b} of x²/a² - y²/b² = 1 about the centre.
[[nodiscard]] CurveResult make_hyperbola(const Vector2d& center_B, const std::array<double, 2>& semi_axes,
                                         double rotation, Side side = Side::kInside);
/// A flat face through `point_B` with outward normal `normal_B` (any length > 0).
[[nodiscard]] CurveResult make_line(const Vector2d& point_B, const Vector2d& normal_B);
/// A knife edge.
[[nodiscard]] CurveResult make_point(const Vector2d& at_B);
/// A smooth piece of a curve of any other kind. Its side is kOutside if it is concave.
/// \param support  outlives the curve \pre `piece` is convex or concave throughout, and not a face, which is
///                 a line
[[nodiscard]] Curve make_curve(const SupportCurve& support, std::size_t piece = 0);
/// @}

/// The conic A x² + B y² + C x y + D x + E y + F = 0 (that order); a common factor of the six, even a
/// negative one, has no effect. `near_B` picks the branch of a hyperbola (required there, ignored elsewhere).
/// A conic within rounding of a parabola counts as one (|λ₁| <= 8 eps |λ₂| for the eigenvalues of the
/// quadratic part), and one within rounding of a degenerate conic is refused.
[[nodiscard]] CurveResult make_conic(const std::array<double, 6>& coefficients, Side side = Side::kInside,
                                     const std::optional<Vector2d>& near_B = std::nullopt);

/// The coefficients A … F of the curve's equation in the body's frame, signed so that f < 0 in the body and
/// scaled so that |∇f| = 1 at the vertex. A line gives the distance from the face; a point (no body) gives
/// its squared distance.
[[nodiscard]] std::array<double, 6> implicit_coefficients(const Curve& curve);

/// Whether the curve is a straight line, a flat face.
[[nodiscard]] inline bool is_line(const Curve& curve) {
  return curve.kind == CurveKind::kLine;
}

/// Whether the curve is a point, a knife edge.
[[nodiscard]] inline bool is_point(const Curve& curve) {
  return curve.kind == CurveKind::kPoint;
}

/// Whether the curve has radii of curvature other than 0 and infinity: neither a line nor a point.
[[nodiscard]] inline bool is_curved(const Curve& curve) {
  return !is_line(curve) && !is_point(curve);
}

/// Whether the curve is a conic, to which their closed forms apply.
[[nodiscard]] inline bool is_conic(const Curve& curve) {
  return is_curved(curve) && curve.kind != CurveKind::kSupport && curve.kind != CurveKind::kChain;
}

/// Semi-axes of an ellipse or hyperbola along and across `axis_B` [m]: {ℓ/|q|, ℓ/√|q|}. q must not be 0.
[[nodiscard]] std::array<double, 2> semi_axes(const Curve& curve);

/// Centre of a circle, ellipse or hyperbola in the body's frame [m]. q must not be 0.
[[nodiscard]] Vector2d center(const Curve& curve);

}  // namespace higherpair

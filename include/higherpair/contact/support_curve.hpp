#pragma once

#include "higherpair/geometry/curve.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace higherpair {

/// Everything from low to high, both included.
struct Bounds {
  double low = 0;
  double high = 0;

  [[nodiscard]] bool contains(double x) const { return low <= x && x <= high; }
  [[nodiscard]] double width() const { return high - low; }
};

enum class PieceKind {
  kArc,     ///< the angle φ of the outward normal moves through an interval; a corner is an arc of radius 0
  kClosed,  ///< the whole curve; φ goes round once
  kFace,    ///< flat: one normal only
};

/// A part of a boundary, in the body's frame.
struct SupportPiece {
  PieceKind kind = PieceKind::kArc;
  Bounds
      phi;  ///< normals [rad]; of a face: encloses the angle of its normal; of a closed curve without meaning
  Bounds along;  ///< of a face: p·t of its ends, t = normal turned +90° [m]; ±infinity: no end
};

/// The support h = p·n of a boundary point p with outward normal n(φ), both in the body's frame, and what
/// follows from it: h′ = p·t, so that p = h n + h′ t, and the radius of curvature ρ = h + h″ (> 0 convex,
/// < 0 concave). Of a face: those of one of its points, whichever, as if it were a corner.
struct SupportValue {
  double h = 0;      ///< [m]
  double dh = 0;     ///< [m]
  double rho = 0;    ///< [m]
  double error = 0;  ///< h and h′ are within this of the truth [m]
};

/// A boundary that is given piece by piece by its support: any curve made of smooth arcs, corners and flat
/// faces. What it promises is all that a search for contacts needs in order to miss none.
class SupportCurve {
public:
  SupportCurve() = default;
  SupportCurve(const SupportCurve&) = delete;
  SupportCurve& operator=(const SupportCurve&) = delete;
  virtual ~SupportCurve() = default;

  /// The pieces in their order along the boundary.
  [[nodiscard]] virtual const std::vector<SupportPiece>& pieces() const = 0;
  /// The support at one normal of the piece; any angle of a closed curve, else one between its bounds.
  [[nodiscard]] virtual SupportValue at(std::size_t piece, double phi) const = 0;
  /// Bounds of ρ over an interval of normals of the piece: the closer, the faster the search; they may be
  /// wide, never too narrow.
  [[nodiscard]] virtual Bounds radius(std::size_t piece, const Bounds& phi) const = 0;
};

/// What encloses h, h′ and ρ over an interval of normals.
struct SupportBounds {
  Bounds h;
  Bounds dh;
  Bounds rho;
};

/// Bounds of a piece over at most a half turn of normals, rounded outwards: from h and h′ at the
/// middle and the bounds of ρ, h + h″ = ρ integrated. Their width beyond the change of h and h′ falls with
/// the square of the interval.
[[nodiscard]] SupportBounds bounds_over(const SupportCurve& curve, std::size_t piece, const Bounds& phi);

/// A conic, line or point of the library as such a curve, its errors those of an evaluation in intervals. Of
/// a parabola or a branch of a hyperbola, on which h grows without bound towards the ends of the cone of
/// normals, the part is taken that is no farther across from its axis than `reach` [m], > 0: it holds every
/// point within that distance of the vertex. Beyond 1e5 semi-latera recta (for a narrow hyperbola: semi-axes
/// across) it ends in any case, since there angles of normals have too few digits left.
[[nodiscard]] std::unique_ptr<SupportCurve> make_support_curve(const Curve& curve, double reach);

}  // namespace higherpair

#pragma once

#include <cstddef>
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
  kArc,     ///< φ moves through an interval: upwards along the boundary where it is convex, downwards where
            ///< it is concave; a corner is an arc of radius 0
  kClosed,  ///< the whole curve; φ goes round once
  kFace,    ///< flat: one normal only
};

/// A part of a boundary, in the body's frame. Two pieces that follow each other share a point: with the same
/// normal it is a smooth joint or a jump of curvature; with another one a corner lies between them, which is
/// a piece of its own; where none follows, the boundary ends.
struct SupportPiece {
  PieceKind kind = PieceKind::kArc;
  /// Normals [rad]; of a face: encloses the angle of its normal; of a closed curve without meaning.
  Bounds phi;
  Bounds along;  ///< of a face: p·t of its ends, t = normal turned +90° [m]; ±infinity: no end
};

/// The support h = p·n of a boundary point p with outward normal n(φ), both in the body's frame, and what
/// follows from it: h′ = p·t, so that p = h n + h′ t, the radius of curvature ρ = h + h″ (> 0 convex,
/// < 0 concave), and its derivative. Of a face: those of one of its points, whichever, as if it were a
/// corner.
struct SupportValue {
  double h = 0;      ///< [m]
  double dh = 0;     ///< [m]
  double rho = 0;    ///< [m]
  double drho = 0;   ///< dρ/dφ [m]
  double error = 0;  ///< h and h′ are within this of the truth [m]
};

/// A boundary that is given piece by piece by its support: any curve made of smooth arcs, corners and flat
/// faces. What it promises is all that the library needs to place, follow and list contacts and to miss none:
/// a new kind of curve is a class that gives it (see make_curve in curve.hpp). Conics, lines and points have
/// closed forms instead.
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

}  // namespace higherpair

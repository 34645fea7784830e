#pragma once

#include "higherpair/geometry/curve.hpp"

#include <memory>
#include <optional>

namespace higherpair {

/// A point of a span, in the body's frame B; t = n turned +90°.
struct SpanPoint {
  Vector2d p_B = Vector2d::Zero();   ///< [m]
  Vector2d n_B = Vector2d::UnitX();  ///< unit outward normal
  double kappa = 0;  ///< signed curvature [1/m], > 0 where the material is convex; of a corner 0
  double slope = 0;  ///< dκ/ds along t [1/m²]
  double speed = 1;  ///< ds/dt > 0 [m per unit of the parameter]; of a corner dφ/dt = 1
};

/// What encloses a span over an interval of its parameter, rounding included.
struct SpanBounds {
  Bounds speed;  ///< ds/dt [m per unit of the parameter]; of a corner 0
  Bounds turn;  ///< dφ/dt = κ ds/dt of the normal's angle φ [rad per unit of the parameter]; of a corner 1
};

/// A smooth part of a boundary by a parameter that grows along t, with the material on its left.
/// Points, normals and curvatures are continuous over its range, and through inflections: unlike the angle of
/// the normal a parameter has no singularity there. A new kind of curve is a class that gives this.
class Span {
public:
  virtual ~Span() = default;

  /// The point at a parameter within range(); a little beyond it the values go on smoothly.
  [[nodiscard]] virtual SpanPoint at(double t) const = 0;
  [[nodiscard]] virtual Bounds range() const = 0;
  /// Bounds over an interval within range(): they close up on the values as fast as it shrinks. None of a
  /// kind of curve that does not give them: of its contacts no list can be proven complete.
  [[nodiscard]] virtual std::optional<SpanBounds> bounds(const Bounds& /*t*/) const { return std::nullopt; }
  /// A convex corner: one point with all normals between those of its neighbours; t is the angle of the
  /// normal [rad].
  [[nodiscard]] virtual bool is_corner() const { return false; }
  /// How many equal parts of the range show the shape of the span to about a part in a hundred.
  [[nodiscard]] virtual int parts() const { return 32; }
};

using SpanPtr = std::shared_ptr<const Span>;

/// \name Spans of the elementary curves
/// @{
/// The part of a conic between two outward normals, which turn counter-clockwise from `from` to `to` [rad];
/// on the outside of a conic it is run through from `to` to `from`.
/// \pre is_conic(curve); from < to <= from + 2π; an open conic has all of these normals
[[nodiscard]] SpanPtr conic_span(const Curve& curve, double from, double to);
/// A straight edge, the material on its left. \pre the two points differ
[[nodiscard]] SpanPtr face_span(const Vector2d& from_B, const Vector2d& to_B);
/// A convex corner, its normals turning counter-clockwise from `from` to `to` [rad]. \pre from < to
[[nodiscard]] SpanPtr corner_span(const Vector2d& at_B, double from, double to);
/// The same points with the material on the other side. \pre no corner
[[nodiscard]] SpanPtr reversed_span(SpanPtr span);
/// Points at a distance [m] along the outward normals (< 0: into the material) of a span that is no corner.
/// \pre 1 + κ distance > 0 all along: no cusp
[[nodiscard]] SpanPtr offset_span(SpanPtr span, double distance);
/// @}

}  // namespace higherpair

#pragma once

#include "higherpair/analysis/run.hpp"

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace higherpair {

/// Derivatives of what a boundary is at one place: its point, normal, curvature and dκ/ds, in the body's
/// frame.
struct PlaceDerivative {
  Vector2d p_B = Vector2d::Zero(), n_B = Vector2d::Zero();
  double kappa = 0, slope = 0;
};

/// Those of the numbers of its local_curve() there.
[[nodiscard]] Curve local_curve_derivative(const SpanPoint& at, const Curve& local,
                                           const PlaceDerivative& by);

/// A boundary, and of each of its spans the parameters at its ends and breaks: in between the curve changes
/// smoothly with the numbers it is made from, but a break may move along it.
struct BoundaryPieces {
  std::shared_ptr<const Boundary> boundary;
  std::vector<std::vector<double>> ends;
};

/// How the boundaries of contacts change with a parameter p from which a mechanism is made.
///
/// A contact depends on its boundaries only through their points, normals and curvatures near the contact,
/// which are those of a simple curve that agrees with the boundary there (local_curve). Their derivatives
/// with respect to p, at the same fraction of the same piece of a span, are eighth-order differences of
/// boundaries made with changed p; everything else that depends on p is differentiated exactly. Which place
/// is taken as the same for another p does not matter: a curve that slides along itself stays the same curve.
/// So curves need not know how they depend on p.
class BoundaryDerivatives {
public:
  /// The mechanisms made with p changed by -4 … 4 steps.
  using Family = std::array<const Mechanism*, 9>;

  /// None where not all of them have the same spans with as many breaks.
  [[nodiscard]] static std::optional<BoundaryDerivatives> of(const Family& mechanisms, double step);

  /// Derivatives with respect to p at a place, at a constant fraction of its piece.
  /// \param side  0: of the contact's first curve, 1: of its second
  [[nodiscard]] PlaceDerivative at(std::size_t contact, std::size_t side, const BoundaryPlace& place) const;

  /// Deviation of the derivatives from sixth-order differences, relative to the larger of their size and the
  /// size to be expected if a change of p by `scale` makes a different boundary: an upper estimate of their
  /// error.
  [[nodiscard]] double error(double scale) const;

  /// The largest derivative of a point, normal or curvature, relative to the size to be expected as above.
  [[nodiscard]] double largest(double scale) const;

private:
  using Boundaries = std::array<BoundaryPieces, 9>;

  std::vector<std::array<Boundaries, 2>> contacts_;  // empty for contacts that are not by_boundary
  double step_ = 0;
};

/// The derivative of a mechanism with respect to a parameter p.
struct MechanismDerivative {
  MechanismDerivative() = default;
  MechanismDerivative(Mechanism by)  // NOLINT(google-explicit-constructor)
      : numbers(std::move(by)) {}

  Mechanism numbers;                                      ///< every number replaced by its derivative
  std::shared_ptr<const BoundaryDerivatives> boundaries;  ///< null: the boundaries of contacts do not change
  /// If found by differences: the step of p, and the error of the boundaries (see
  /// BoundaryDerivatives::error).
  double step = 0, error = 0;
};

}  // namespace higherpair

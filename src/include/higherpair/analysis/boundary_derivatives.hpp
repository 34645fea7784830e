#pragma once

#include "higherpair/analysis/run.hpp"

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace higherpair {

/// How the boundaries of contacts change with a parameter p from which a mechanism is made.
///
/// A contact depends on its boundaries by nothing but their points, normals and curvatures about the place of
/// contact, which are those of the curve that is like them there (local_curve). The derivatives of these by
/// p, at the same share of the same span, are differences of the eighth order of the boundaries made with p
/// changed; whatever else depends on p follows exactly. Which place counts as the same for another p does not
/// matter: a curve that slides along itself stays the same curve. So this needs no kind of curve to know how
/// it is made.
class BoundaryDerivatives {
public:
  /// With p changed by -4 … 4 steps.
  using Family = std::array<const Mechanism*, 9>;

  /// None where not all of them have the same spans.
  [[nodiscard]] static std::optional<BoundaryDerivatives> of(const Family& mechanisms, double step);

  /// The derivatives by p of the numbers of the curve that is like the boundary at a place.
  /// \param side  0: of the contact's first curve, 1: of its second
  [[nodiscard]] Curve of_local_curve(std::size_t contact, std::size_t side, const BoundaryPlace& place) const;

  /// How far the derivatives are from differences of the sixth order, of the larger of what they are and of
  /// what is to be expected where a change of p by `scale` makes another boundary: more than their error.
  [[nodiscard]] double error(double scale) const;

  /// The largest derivative of a point, normal or curvature, of what is to be expected as above.
  [[nodiscard]] double largest(double scale) const;

private:
  using Boundaries = std::array<std::shared_ptr<const Boundary>, 9>;

  std::vector<std::array<Boundaries, 2>> contacts_;  // null of those that are not by_boundary
  double step_ = 0;
};

/// The derivative of a mechanism by a parameter.
struct MechanismDerivative {
  MechanismDerivative() = default;
  MechanismDerivative(Mechanism by)  // NOLINT(google-explicit-constructor)
      : numbers(std::move(by)) {}

  Mechanism numbers;                                      ///< every number by p, in place of the number
  std::shared_ptr<const BoundaryDerivatives> boundaries;  ///< null: those of contacts do not change
  /// By differences: the step of p, and how far off boundaries may be (see BoundaryDerivatives::error).
  double step = 0, error = 0;
};

}  // namespace higherpair

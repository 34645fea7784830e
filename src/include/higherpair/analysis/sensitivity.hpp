#pragma once

#include "higherpair/analysis/boundary_derivatives.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// Derivative of a row with respect to a parameter p of the mechanism or of its drivers: of the contents of a
/// MotionRow, per unit of p.
struct RowSensitivity {
  std::vector<BodyMotion> bodies;  ///< of Mechanism::bodies; in the pose only p_WB and theta are derivatives
  std::vector<double> phi;         ///< for each contact: of the angle of its normal
  std::vector<double> phi_dot;
  std::vector<double> arcs;  ///< of the constant arc difference of each rolling contact
};

/// What is required of a row besides positions. Rates that are not required stay 0; without them a row takes
/// a fifth of the time.
enum class RatesAsked {
  kNone,
  kAll,
  kRegular,  ///< all of a row that does not meet a change point: the same in less time
};

/// Whether a change point is so near to run.row that its rates are those of a series through it, which is so
/// for derivatives by every parameter. \param motions  drivers of the row
[[nodiscard]] bool meets_change_point(const Run& run, const std::vector<DriverMotion>& motions);

/// Why a row has no derivatives.
enum class NoSensitivity {
  kNoRates,   ///< it has no rates, or its conditions leave a freedom
  kDiverges,  ///< it is next to a change point that another p does away with: they grow without bounds there
};

/// Derivatives of a running analysis with respect to one parameter p, on the branch on which it runs. With F
/// the conditions of the joints, contacts and drivers (conditions.hpp), as functions of the coordinates x and
/// of p,
///     ∂F/∂x dx/dp = -∂F/∂p,
/// and likewise for every order of x as a power series in time: exact, without solving again for another p.
/// The constants of rolling contacts (arc differences) depend on p through the position in which the run was
/// started: there a body that is turned by nothing but a rolling contact has the angle of its pose.
class Sensitivity {
public:
  /// \param run         at the position in which it was started; its `row` is not used
  /// \param derivative  of the mechanism with respect to p
  /// \param drivers     derivatives of the first positions of the drivers with respect to p [rad or m]
  /// None where the start is singular.
  [[nodiscard]] static std::optional<Sensitivity> at_start(const Run& run, MechanismDerivative derivative,
                                                           const std::vector<double>& drivers);

  /// The sensitivity of run.row.
  /// \param motions      drivers of the row
  /// \param derivatives  of their positions, velocities and accelerations with respect to p
  [[nodiscard]] tl::expected<RowSensitivity, NoSensitivity> of_row(
      const Run& run, const std::vector<DriverMotion>& motions, const std::vector<DriverMotion>& derivatives,
      RatesAsked rates = RatesAsked::kAll) const;

  /// Every number of the mechanism replaced by its derivative, except the curves of contacts by_boundary.
  [[nodiscard]] const Mechanism& derivative() const { return derivative_.numbers; }
  /// The boundaries' derivatives at a row's contact by_boundary that touches: where it is, moving along them
  /// with p.
  [[nodiscard]] std::array<PlaceDerivative, 2> of_places(const Run& run, const RowSensitivity& of_row,
                                                         std::size_t contact) const;

private:
  /// The same as derivative() for run.mechanism(), whose curves agree with the boundaries at the row's
  /// contacts: those at a constant fraction of a span, which is enough up to accelerations.
  [[nodiscard]] Mechanism derivative_at(const Run& run) const;
  [[nodiscard]] Curve of_local_curve(const Run& run, std::size_t contact, std::size_t side) const;
  [[nodiscard]] PlaceDerivative at_fixed_place(std::size_t contact, std::size_t side,
                                               const BoundaryPlace& place) const;

  MechanismDerivative derivative_;
  std::vector<double> arcs_;
};

}  // namespace higherpair

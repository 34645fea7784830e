#pragma once

#include "higherpair/analysis/boundary_derivatives.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// How a row changes with a parameter p of the mechanism or of its drivers: the derivative by p of what a
/// MotionRow holds, per unit of p.
struct RowSensitivity {
  std::vector<BodyMotion> bodies;  ///< of Mechanism::bodies; of the pose only p_WB and theta are derivatives
  std::vector<double> phi;         ///< of each contact: of the angle of its normal
  std::vector<double> phi_dot;
  std::vector<double> arcs;  ///< of the arc difference held by each contact that rolls
};

/// What is asked for of a row besides positions; what is not stays 0, which takes a fifth of the time.
enum class RatesAsked { kNone, kAll };

/// Derivatives of a running analysis by one parameter p, on the branch on which it runs. With F the
/// conditions of the joints, contacts and drivers (conditions.hpp), as functions of the coordinates x and of
/// p,
///     ∂F/∂x dx/dp = -∂F/∂p,
/// and likewise for every order of x as a power series in time: exact, no position is found again with
/// another p. What rolling contacts hold (the difference of arcs) depends on p by the position in which the
/// run was started: there a body that nothing but a rolling contact turns has the angle of its pose.
class Sensitivity {
public:
  /// \param run         at the position in which it was started; its `row` is not used
  /// \param derivative  of the mechanism by p
  /// \param drivers     derivatives of the first positions of the drivers by p [rad or m]
  /// None where the start is singular.
  [[nodiscard]] static std::optional<Sensitivity> at_start(const Run& run, MechanismDerivative derivative,
                                                           const std::vector<double>& drivers);

  /// Of run.row. None where the row has no rates.
  /// \param motions      drivers of the row
  /// \param derivatives  of their positions, velocities and accelerations by p
  [[nodiscard]] std::optional<RowSensitivity> of_row(const Run& run, const std::vector<DriverMotion>& motions,
                                                     const std::vector<DriverMotion>& derivatives,
                                                     RatesAsked rates = RatesAsked::kAll) const;

  /// Every number of the mechanism by p, in place of the number; but for the curves of contacts by_boundary.
  [[nodiscard]] const Mechanism& derivative() const { return derivative_.numbers; }
  /// The same of run.mechanism(), whose curves are like those boundaries at the row's contacts.
  [[nodiscard]] Mechanism derivative_at(const Run& run) const;

private:
  MechanismDerivative derivative_;
  std::vector<double> arcs_;
};

}  // namespace higherpair

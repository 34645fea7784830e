#pragma once

#include "higherpair/analysis/sensitivity.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace higherpair {

/// The derivatives of a function towards smaller and larger numbers; they differ at a kink.
struct SidedSlope {
  double down = 0;
  double up = 0;

  [[nodiscard]] bool is_kink() const { return down != up; }
};

/// The derivatives with respect to p of functions of a run's mechanism and row: joint coordinates, columns,
/// forces. The row is displaced along its sensitivity, which to first order gives the row for another p, and
/// the functions are differentiated by eighth-order differences. They need no derivatives of their own; where
/// a function is smooth the error is of the size of rounding.
/// \param f  function of a displaced run, of which only `mechanism`, `plan` and `row` may be used, and of the
/// displacement of p
[[nodiscard]] std::vector<SidedSlope> slopes_along(
    const Run& run, const Sensitivity& by, const RowSensitivity& of_row,
    const std::function<std::vector<double>(const Run&, double)>& f);

/// The same; at a kink the mean of both sides.
[[nodiscard]] std::vector<double> derivative_along(
    const Run& run, const Sensitivity& by, const RowSensitivity& of_row,
    const std::function<std::vector<double>(const Run&, double)>& f);

/// The mechanism with every number changed by h times its derivative.
[[nodiscard]] Mechanism displaced(Mechanism mechanism, const Mechanism& derivative, double h);

/// The derivative of a mechanism that is made from a parameter p, by eighth-order differences. None where it
/// cannot be made within 4 h of p, or is not smooth there. \param at  makes it for p displaced by its
/// argument \param scale  a change of p that makes a different mechanism
[[nodiscard]] std::optional<MechanismDerivative> mechanism_derivative(
    const std::function<std::optional<Mechanism>(double)>& at, double h, double scale);

/// The same with the widest of several steps between 1e-3 and 1e-9 of the scale that leaves only rounding
/// errors, otherwise with the best of them.
[[nodiscard]] std::optional<MechanismDerivative> mechanism_derivative(
    const std::function<std::optional<Mechanism>(double)>& at, double scale);

}  // namespace higherpair

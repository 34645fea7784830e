#pragma once

#include "higherpair/analysis/sensitivity.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace higherpair {

/// The derivative by p of functions of a run's mechanism and row: joint coordinates, columns, forces. The row
/// is displaced along its sensitivity, which to first order is what another p would make of it, and the
/// functions are differentiated by differences of the eighth order. No function need know how; what the
/// differences leave is of the size of rounding where a function is smooth.
/// \param f  of a displaced run, of which `mechanism`, `plan` and `row` may be used, and of the displacement
///           of p
[[nodiscard]] std::vector<double> derivative_along(
    const Run& run, const Sensitivity& by, const RowSensitivity& of_row,
    const std::function<std::vector<double>(const Run&, double)>& f);

/// The mechanism with every number changed by h times its derivative.
[[nodiscard]] Mechanism displaced(Mechanism mechanism, const Mechanism& derivative, double h);

/// The derivative of a mechanism that is made from a parameter p, by differences of the eighth order. None
/// where it cannot be made within 4 h of p, or is not smooth there. \param at  makes it for p displaced by
/// its argument \param scale  of p: a change by as much makes another mechanism
[[nodiscard]] std::optional<MechanismDerivative> mechanism_derivative(
    const std::function<std::optional<Mechanism>(double)>& at, double h, double scale);

/// The same with the widest of several steps between 1e-3 and 1e-9 of the scale that leaves no error but
/// rounding, else with the best of them.
[[nodiscard]] std::optional<MechanismDerivative> mechanism_derivative(
    const std::function<std::optional<Mechanism>(double)>& at, double scale);

}  // namespace higherpair

#pragma once

#include "higherpair/analysis/row.hpp"
#include "higherpair/analysis/run.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// Time derivatives of a body's frame in ground, from the 0th up to the requested order; the others are 0.
struct BodyDerivatives {
  std::array<Vector2d, kHighestDerivative + 1> p_WB;  ///< of the origin [m/s^k]
  std::array<double, kHighestDerivative + 1> theta;   ///< of the angle [rad/s^k]
};

/// The time derivatives of all bodies up to `order` at run.row. With every coordinate a power series in time,
/// the conditions of joints, contacts (gap, common normal, no slip) and drivers hold order by order:
///     J x_k = -(contribution of the lower orders to the conditions at order k),
/// with the same Jacobian J in each. Neither finite differences nor equivalent linkages are used. Next to a
/// change point they are those of the series through it. None where the conditions leave a body free to move
/// (a singular position), the row has no rates, or branches come so near each other that rounding decides.
/// \param drivers  those of the row \param order  1 … kHighestDerivative
/// \param higher  of the drivers; none: their accelerations are constant
[[nodiscard]] std::optional<std::vector<BodyDerivatives>> derivatives_of(
    const Run& run, const std::vector<DriverMotion>& drivers, int order,
    std::span<const HigherRates> higher = {});

/// The k-th time derivative of a point of the body, in ground [m/s^k].
/// \param p_B  in the body's frame [m]
[[nodiscard]] Vector2d point_derivative(const BodyDerivatives& body, const Vector2d& p_B, int k);

}  // namespace higherpair

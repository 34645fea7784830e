#pragma once

#include "free_assembly.hpp"

namespace higherpair {

/// Whether turning a body about one of its points changes nothing: it has contacts, and all that holds it is
/// pins at that point and curves round about it that slip.
/// \param p_B  the point, body frame [m]
[[nodiscard]] bool turns_idly(const SizedMechanism& sized, int body, const Vector2d& p_B);

/// The same about a pin of the body, or where it has none about the centre of a round curve that touches.
[[nodiscard]] bool turns_idly(const SizedMechanism& sized, int body);

/// Whether all curves of a body that touch are round about its first pin, or about one point if it has none,
/// but for a distance (kNearlyRound) at which its contacts hardly set its angle.
[[nodiscard]] bool is_nearly_round(const SizedMechanism& sized, int body);

}  // namespace higherpair

#pragma once

#include "higherpair/mechanism/description.hpp"

#include <vector>

// Which coordinates enter which condition of a mechanism, regardless of their values.

namespace higherpair {

/// A coordinate of a body: x or y of a reference point (a pin, if it has one), or its angle.
enum class Coordinate { kX = 0, kY = 1, kAngle = 2 };

[[nodiscard]] inline int variable(int body, Coordinate coordinate) {
  return 3 * body + static_cast<int>(coordinate);
}

/// One condition: its bodies and the coordinates that enter it.
struct Condition {
  std::vector<int> bodies;  // only moving ones
  std::vector<int> variables;
  int row = kNoRow;  // row in conditions_at(); only for joints and contacts

  static constexpr int kNoRow = -1;
};

/// The items of a mechanism in the order of their names: the order of the description must not affect
/// results, not even by rounding.
struct NameOrder {
  explicit NameOrder(const Mechanism& mechanism);

  std::vector<int> bodies, joints, contacts, drivers;
};

/// The conditions of drivers, joints and contacts, with those of the slip of rolling contacts last: where
/// conditions contradict or repeat each other, a later one counts as the surplus.
[[nodiscard]] std::vector<Condition> structural_conditions(const Mechanism& mechanism,
                                                           const NameOrder& order);

/// Of the ends of pins, whether they are at their body's reference point, of the curves of contacts, whether
/// they are round about it, and of the bodies of rolling contacts, whether they are nearly round: all
/// dimensions on which structural_conditions() and phase_bodies() depend.
[[nodiscard]] std::vector<bool> coincidences_of(const Mechanism& mechanism);

}  // namespace higherpair

#pragma once

#include "higherpair/mechanism/description.hpp"

#include <vector>

// Which coordinates enter which condition of a mechanism, whatever their values.

namespace higherpair {

/// A coordinate of a body: x and y of a reference point (a pin, where it has one), and its angle.
enum class Coordinate { kX = 0, kY = 1, kAngle = 2 };

[[nodiscard]] inline int variable(int body, Coordinate coordinate) {
  return 3 * body + static_cast<int>(coordinate);
}

/// One condition: its bodies and the coordinates that enter.
struct Condition {
  std::vector<int> bodies;  // moving ones
  std::vector<int> variables;
  int row = kNoRow;  // in conditions_at(), of joints and contacts

  static constexpr int kNoRow = -1;
};

/// The items of a mechanism in the order of their names: the order of the description must not matter, not
/// even for rounding.
struct NameOrder {
  explicit NameOrder(const Mechanism& mechanism);

  std::vector<int> bodies, joints, contacts, drivers;
};

/// The conditions of drivers, joints and contacts, those of the slip of rolling contacts last: where
/// conditions contradict or repeat each other, a later one counts as the surplus.
[[nodiscard]] std::vector<Condition> structural_conditions(const Mechanism& mechanism,
                                                           const NameOrder& order);

}  // namespace higherpair

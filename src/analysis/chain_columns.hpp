#pragma once

#include "chain_group.hpp"
#include "chain_kernel.hpp"
#include "higherpair/analysis/dyad_chain.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// Where a body's angle comes from.
struct ChainAngle {
  enum class Source { kFixed, kDriver, kRotation } source = Source::kFixed;
  int body = 0;       ///< of kRotation: whose rotation says it
  double factor = 0;  ///< of the driver's position
  double offset = 0;  ///< [rad]
};

/// A column with what it takes to fill it in.
struct ChainTask {
  ChainColumn column;
  Vector2d p_B = Vector2d::Zero();
  ChainAngle angle;
  double posed_angle = 0;  ///< of kRotation: of that body in its pose [rad]
  ChainTouch touch;        ///< of kPressure
  std::vector<double> values;
};

/// Whether the column is of a joint's reaction or of the driver's effort.
[[nodiscard]] constexpr bool is_force(ChainColumn::Quantity quantity) {
  return quantity >= ChainColumn::Quantity::kForceX;
}

/// Whether it is an angle that a rotation gives but for whole turns.
[[nodiscard]] constexpr bool is_unwound(const ChainTask& task) {
  return task.column.quantity == ChainColumn::Quantity::kAngle &&
         task.angle.source == ChainAngle::Source::kRotation;
}

/// The rates that the columns want.
[[nodiscard]] ChainRates rates_for(std::span<const ChainColumn> columns);

/// Of which bodies more than their turning is wanted: by columns, forces, or groups that hang on them.
[[nodiscard]] std::vector<char> placed_bodies(std::span<const ChainGroup> groups,
                                              std::span<const ChainColumn> columns, std::size_t bodies);

/// Where the angles of all bodies come from; those of riders from their carriers.
[[nodiscard]] std::vector<ChainAngle> angles_of(std::span<const ChainGroup> groups, std::size_t bodies);

/// The contact with this index; null where it places none of the groups.
[[nodiscard]] const ChainTouch* touch_in(std::span<const ChainGroup> groups, int contact);

/// Whether a contact has the angle of kPressure: its second body is one on ground that it places.
[[nodiscard]] bool has_pressure(const Mechanism& mechanism, std::span<const ChainGroup> groups, int contact);

}  // namespace higherpair

#pragma once

#include "chain_group.hpp"
#include "chain_kernel.hpp"
#include "higherpair/analysis/dyad_chain.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// Where a body's angle comes from: that of a turning, or factor (driver's position), and the offset.
struct ChainAngle {
  double factor = 0;
  int turning = -1;   ///< index of ChainTurning; none: -1
  double offset = 0;  ///< [rad]
};

/// A body whose angle, which its rotation gives but for whole turns, is followed from row to row, by less
/// than half a turn each. In the first row it is the one nearest to its pose's.
struct ChainTurning {
  int body = 0;
  bool sprung = false;     ///< whether a spring asks for it
  double posed_angle = 0;  ///< [rad]
  double first_angle = 0;  ///< the result, in the first row [rad]
};

/// A column with what it takes to fill it in.
struct ChainTask {
  ChainColumn column;
  Vector2d p_B = Vector2d::Zero();
  ChainAngle angle;
  ChainTouch touch;  ///< of kPressure
  std::vector<double> values;
};

/// Whether the column is of a joint's reaction or of the driver's effort.
[[nodiscard]] constexpr bool is_force(ChainColumn::Quantity quantity) {
  return quantity >= ChainColumn::Quantity::kForceX;
}

/// The rates that the columns want.
[[nodiscard]] ChainRates rates_for(std::span<const ChainColumn> columns);

/// Bodies whose places are needed as well as their angles: by columns, forces, or groups that depend on them.
[[nodiscard]] std::vector<char> placed_bodies(std::span<const ChainGroup> groups,
                                              std::span<const ChainColumn> columns, std::size_t bodies);

/// Where the angles of all bodies come from; those of riders from their carriers. Bodies that turn are put
/// into `turnings`.
[[nodiscard]] std::vector<ChainAngle> angles_of(std::span<const ChainGroup> groups, std::size_t bodies,
                                                std::vector<ChainTurning>& turnings);

/// The contact with this index; null where it places none of the groups.
[[nodiscard]] const ChainTouch* touch_in(std::span<const ChainGroup> groups, int contact);

/// Whether a contact has the angle of kPressure: its second body is one on ground that it places.
[[nodiscard]] bool has_pressure(const Mechanism& mechanism, std::span<const ChainGroup> groups, int contact);

}  // namespace higherpair

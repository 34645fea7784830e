#pragma once

#include "chain_group.hpp"
#include "chain_kernel.hpp"
#include "higherpair/analysis/dyad_chain.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// The angle of a body as that of a turning, or as factor times the driver's position, plus an offset.
struct ChainAngle {
  double factor = 0;
  int turning = -1;   ///< index of ChainTurning; none: -1
  double offset = 0;  ///< [rad]
};

/// A body whose angle is followed from row to row, by less than half a turn each, because its rotation gives
/// it only up to whole turns. In the first row the angle is the one nearest to that of the pose.
struct ChainTurning {
  int body = 0;
  bool sprung = false;     ///< whether a torsion spring needs it
  double posed_angle = 0;  ///< [rad]
  double first_angle = 0;  ///< result: the angle in the first row [rad]
};

/// A column and all that is needed to fill it.
struct ChainTask {
  ChainColumn column;
  Vector2d p_B = Vector2d::Zero();
  ChainAngle angle;
  ChainTouch touch;  ///< for kPressure
  std::vector<double> values;
};

/// Whether the column is of a joint's reaction or of the driver's effort.
[[nodiscard]] constexpr bool is_force(ChainColumn::Quantity quantity) {
  return quantity >= ChainColumn::Quantity::kForceX;
}

/// The rates that the columns need.
[[nodiscard]] ChainRates rates_for(std::span<const ChainColumn> columns);

/// Bodies whose positions are needed and not only their angles: by columns, by forces, or by groups that
/// depend on them.
[[nodiscard]] std::vector<char> placed_bodies(std::span<const ChainGroup> groups,
                                              std::span<const ChainColumn> columns, std::size_t bodies);

/// How the angles of all bodies are obtained; riders take those of their carriers. Bodies that turn are
/// appended to `turnings`.
[[nodiscard]] std::vector<ChainAngle> angles_of(std::span<const ChainGroup> groups, std::size_t bodies,
                                                std::vector<ChainTurning>& turnings);

/// The contact with this index; null if no group is placed by it.
[[nodiscard]] const ChainTouch* touch_in(std::span<const ChainGroup> groups, int contact);

/// Whether kPressure is defined for a contact: its second body has to be joined to ground and placed by the
/// contact, and its first must not be ground.
[[nodiscard]] bool has_pressure(const Mechanism& mechanism, std::span<const ChainGroup> groups, int contact);

}  // namespace higherpair

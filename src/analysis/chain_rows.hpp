#pragma once

#include "chain_kernel.hpp"
#include "chain_ovals.hpp"
#include "higherpair/analysis/dyad_chain.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace higherpair {

/// Rows are worked out so many at a time: several packs, since one would wait for its own results.
inline constexpr std::size_t kChainRows = 16;

/// The driver in the rows, each kind of number in an array of its own; filled up to a multiple of kChainRows.
struct ChainSchedule {
  std::vector<double> position;  ///< [rad or m]
  std::vector<double> cosine;
  std::vector<double> sine;
  std::vector<double> velocity;
  std::vector<double> acceleration;
};

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
  ChainTouch touch;  ///< of kPressure
  std::vector<double> values;
};

/// What there is room for.
inline constexpr std::size_t kMostChainBodies = 64;
inline constexpr std::size_t kMostChainGroups = 64;

/// All rows of a chain.
struct ChainRowsJob {
  std::span<const ChainGroup> groups;
  std::span<const double> modes;  ///< of the groups: +1 or -1
  const ChainSchedule& schedule;
  ChainRates rates;
  std::size_t bodies;  ///< so many, with ground and the links between discs
  double size;         ///< of the mechanism [m]; for contacts of ovals
  std::span<ChainTask> tasks;
  std::span<ChainWatch<double>> watches;  ///< of the groups: the result for all rows
  std::span<OvalRow> ovals;  ///< of the groups: where a contact is in the first row, then the last
};

/// Positions, and rates as far as the columns need them, of all bodies in all rows; into the tasks' values.
/// Of angles by kRotation the one in (-π, π], without its offset. By the widest packs that the machine has.
void fill_chain_rows(const ChainRowsJob& job);

/// In packs of 4 and 8, where the machine has AVX2, and AVX-512F, DQ and VL.
void fill_by_4(const ChainRowsJob& job);
void fill_by_8(const ChainRowsJob& job);

}  // namespace higherpair

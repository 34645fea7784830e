#pragma once

#include "chain_columns.hpp"
#include "chain_kernel.hpp"
#include "chain_loads.hpp"
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

/// What there is room for.
inline constexpr std::size_t kMostChainBodies = 64;
inline constexpr std::size_t kMostChainGroups = 64;

/// All rows of a chain.
struct ChainRowsJob {
  std::span<const ChainGroup> groups;
  std::span<const double> modes;  ///< of the groups: +1 or -1
  const ChainSchedule& schedule;
  ChainRates rates;
  std::span<const char>
      placed;   ///< of the bodies, with ground and the links between discs: see placed_bodies()
  double size;  ///< of the mechanism [m]; for contacts of ovals
  std::span<ChainTask> tasks;
  std::span<ChainTurning> turnings;
  std::span<ChainWatch<double>> watches;  ///< of the groups: the result for all rows
  std::span<OvalRow> ovals;         ///< of the groups: where a contact is in the first row, then the last
  ChainStatics* statics = nullptr;  ///< where tasks are of forces; `rates` are accelerations then
};

/// Positions, and rates as far as the columns need them, of all bodies in all rows; into the tasks' values.
/// By the widest packs that the machine has.
void fill_chain_rows(const ChainRowsJob& job);

/// In packs of 4 and 8, where the machine has AVX2, and AVX-512F, DQ and VL.
void fill_by_4(const ChainRowsJob& job);
void fill_by_8(const ChainRowsJob& job);

}  // namespace higherpair

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

/// Number of rows that are computed at a time: several packs, since a single one would wait for its own
/// results.
inline constexpr std::size_t kChainRows = 16;

/// The driver in all rows as separate arrays, padded to a multiple of kChainRows.
struct ChainSchedule {
  std::vector<double> position;  ///< [rad or m]
  std::vector<double> cosine;
  std::vector<double> sine;
  std::vector<double> velocity;
  std::vector<double> acceleration;
};

/// Capacity.
inline constexpr std::size_t kMostChainBodies = 64;
inline constexpr std::size_t kMostChainGroups = 64;

/// All rows of a chain.
struct ChainRowsJob {
  std::span<const ChainGroup> groups;
  std::span<const double> modes;  ///< of the groups: +1 or -1
  const ChainSchedule& schedule;
  ChainRates rates;
  std::span<const char>
      placed;   ///< of the bodies, including ground and the links of contacts: see placed_bodies()
  double size;  ///< of the mechanism [m]; for contacts of ovals
  std::span<ChainTask> tasks;
  std::span<ChainTurning> turnings;
  std::span<ChainWatch<double>> watches;  ///< of the groups: the result for all rows
  std::span<OvalRow> ovals;         ///< of the groups: a contact in the first row; on return, in the last
  ChainStatics* statics = nullptr;  ///< if tasks are of forces; `rates` must then be kAccelerations
};

/// Computes positions, and rates as far as the columns need them, of all bodies in all rows, and fills in the
/// tasks' values. Uses the widest packs that the machine supports.
void fill_chain_rows(const ChainRowsJob& job);

/// The same in packs of 4 (AVX2) and of 8 (AVX-512F, DQ and VL).
void fill_by_4(const ChainRowsJob& job);
void fill_by_8(const ChainRowsJob& job);

}  // namespace higherpair

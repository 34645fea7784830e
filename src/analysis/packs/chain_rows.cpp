#include "chain_rows.hpp"

#include "chain_loop.hpp"

#include <cassert>

namespace higherpair {
namespace {

[[gnu::flatten]] void fill_by_2(const ChainRowsJob& job) {
  chain_loop::fill<PackPair<2>>(job);
}

using Fill = void (*)(const ChainRowsJob&);

Fill widest() {
#ifdef HIGHERPAIR_WIDE_PACKS
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl")) {
    return fill_by_8;
  }
  if (__builtin_cpu_supports("avx2")) {
    return fill_by_4;
  }
#endif
  return fill_by_2;
}

}  // namespace

void fill_chain_rows(const ChainRowsJob& job) {
  assert(job.schedule.position.size() % kChainRows == 0);
  assert(job.placed.size() <= kMostChainBodies && job.groups.size() <= kMostChainGroups);
  static const Fill fill_widest = widest();
  fill_widest(job);
}

}  // namespace higherpair

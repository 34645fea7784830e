#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace higherpair {

/// More threads than this are not used: each needs memory.
inline constexpr int kMostThreads = 1024;

/// Number of threads to use; 0 or less means as many as there are usable cores.
[[nodiscard]] inline int thread_count(int wanted) {
  return wanted > 0 ? std::min(wanted, kMostThreads) : tbb::info::default_concurrency();
}

/// Does the work on this many threads, which may be more than there are cores.
template <class Work>
void on_threads(int threads, const Work& work) {
  std::optional<tbb::global_control> more;
  if (threads > tbb::info::default_concurrency()) {
    more.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  tbb::task_arena(threads).execute(work);
}

/// Calls f(0) to f(count - 1), in any order, on this many threads; 0 or less means as many as there are
/// usable cores.
template <class F>
void for_each_on_threads(std::size_t count, int threads, const F& f) {
  on_threads(thread_count(threads), [&] { tbb::parallel_for(std::size_t{0}, count, f); });
}

}  // namespace higherpair

#pragma once

#include <optional>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

namespace higherpair {

/// So many threads; 0: as many as there are cores to be used.
[[nodiscard]] inline int thread_count(int wanted) {
  return wanted > 0 ? wanted : tbb::info::default_concurrency();
}

/// Does the work on so many threads, which may be more than there are cores.
template <class Work>
void on_threads(int threads, const Work& work) {
  std::optional<tbb::global_control> more;
  if (threads > tbb::info::default_concurrency()) {
    more.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  tbb::task_arena(threads).execute(work);
}

}  // namespace higherpair

#pragma once

#include "higherpair/front/motion.hpp"

namespace higherpair {

/// Settings of the run on which a task is based: the members that both kinds of settings share.
template <class Settings>
[[nodiscard]] RunSettings run_settings(const Settings& settings, bool in_time) {
  RunSettings run;
  run.in_time = in_time;
  run.samples = settings.samples;
  run.tolerance = settings.tolerance;
  run.stop = settings.stop;
  return run;
}

}  // namespace higherpair

#pragma once

#include "higherpair/front/motion.hpp"

namespace higherpair {

/// The run that a task is worked out from: what its settings say by the same names.
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

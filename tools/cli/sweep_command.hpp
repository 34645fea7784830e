#pragma once

#include "higherpair/front/sweep.hpp"
#include "output_options.hpp"
#include "run_identity.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct SweepOptions : ProfileOptions {
  std::string output = "-";
  std::optional<std::int64_t> samples;
  double tolerance = 1e-9;
  int threads = 0;  ///< 0: as many as there are cores
  bool resume = false;
  std::string part = "1/1";  ///< K/N
};

/// Adds the arguments of `sweep` to a command or to a program of its own.
void add_sweep_options(CLI::App& command, SweepOptions& options);

/// A sweep that is ready to run.
struct OpenedSweep {
  Model model;
  Sweep sweep;
  RunIdentity identity;
};

/// Reads the profile; prints its notes unless `quiet`. \param stop  ends the work on blocks once true
[[nodiscard]] Result<OpenedSweep> open_sweep(const SweepOptions& options, const std::atomic<bool>& stop);

/// Computes the blocks of a sweep from `first` on and passes them to `take`, as run_sweep does.
using SweepRunner = std::function<void(const OpenedSweep& sweep, std::int64_t first,
                                       const std::function<bool(const SweepBlock&)>& take)>;

/// Runs the sweep; returns the exit code.
[[nodiscard]] int sweep_command(const SweepOptions& options, const SweepRunner& run);

}  // namespace higherpair::cli

// `sweep` on many MPI ranks, for clusters. It is a program of its own, so that `higherpair` does not need
// MPI.
#include "higherpair/front/model.hpp"
#include "mpi/dispatcher.hpp"
#include "mpi/messages.hpp"
#include "mpi/worker.hpp"
#include "outcome.hpp"
#include "signals.hpp"
#include "sweep_command.hpp"
#include "tell.hpp"

#include <atomic>
#include <cstdio>
#include <exception>
#include <mpi.h>
#include <new>
#include <sstream>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

int threads_of(const SweepOptions& options) {
  return options.threads == 0 ? 1 : options.threads;
}

int command_of_rank_0(const SweepOptions& options) {
  const SweepRunner run = [&](const OpenedSweep& opened, std::int64_t first, const auto& take) {
    Dispatcher dispatcher(opened.sweep, identity_text(opened.identity), threads_of(options), interruption());
    dispatcher.run(first, take);
  };
  const int code = sweep_command(options, run);
  dismiss_workers();
  return code;
}

void work(SweepOptions options) {
  std::atomic<bool> stop = false;
  listen_to_signals();
  options.quiet = true;
  const auto opened = open_sweep(options, stop);
  if (!opened) {
    only_listen();  // rank 0 reports the reason, or has a file that is missing here
    return;
  }
  work_for_rank_0(opened->sweep, identity_text(opened->identity), threads_of(options), stop, interruption());
}

// All ranks read the same command line; only rank 0 prints.
int run(int argc, char** argv) {
  CLI::App app("Many variants of a mechanism on many ranks, as `higherpair sweep` runs them on one machine.",
               "higherpair-sweep-mpi");
  app.set_version_flag("--version", "higherpair-sweep-mpi " + std::string(version()));
  SweepOptions options;
  end_on_signals();
  add_sweep_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream unheard;
    const bool speaks = own_rank() == 0;
    const int code = speaks ? app.exit(error) : app.exit(error, unheard, unheard);
    return exit_code_of(code);
  }
  int code = kExitOk;
  if (own_rank() == 0) {
    code = command_of_rank_0(options);
  } else {
    work(options);
  }
  MPI_Bcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return code;
}

}  // namespace
}  // namespace higherpair::cli

int main(int argc, char** argv) {
  int level = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &level);
  int code = higherpair::cli::kExitMachine;
  try {
    code = higherpair::cli::run(argc, argv);
    std::fflush(stdout);
  } catch (const std::bad_alloc&) {
    higherpair::cli::tell("higherpair: out of memory\n");
    MPI_Abort(MPI_COMM_WORLD, code);
  } catch (const std::exception& error) {
    higherpair::cli::tell("higherpair: {}\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, code);
  }
  MPI_Finalize();
  return code;
}

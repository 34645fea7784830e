#pragma once

#include "higherpair/higherpair.hpp"
#include "output_options.hpp"

#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace higherpair::cli {

inline constexpr int kExitOk = 0;
inline constexpr int kExitMachine = 1;
inline constexpr int kExitInput = 2;
inline constexpr int kExitMechanism = 3;
inline constexpr int kExitRows = 4;
inline constexpr int kExitInterrupted = 130;

/// The exit code for arguments that the parser ended with this one: its own codes are above 100, and all mean
/// kExitInput.
[[nodiscard]] constexpr int exit_code_of(int parser) {
  return parser == kExitOk || parser == kExitMachine ? parser : kExitInput;
}

struct RunOptions : ProfileOptions {
  std::optional<std::string> csv;
  std::optional<std::string> json;
  std::optional<std::string> hdf5;
  std::optional<std::string> events;  ///< file of the events, as CSV
  RunSettings settings;
  int threads = 0;  ///< 0: as many as there are cores
  bool summary = false;
};

/// Prints what is wrong on standard error; returns the exit code.
[[nodiscard]] int report_error(const Error& error);

/// Prints notes on standard error, unless `quiet`.
void print_notes(const Diagnostics& notes, bool quiet);

/// Opens the model of a profile file; prints its notes unless `quiet`.
/// \param outputs  files to be written; refused if the profile reads one of them
[[nodiscard]] Result<Model> open_model(const ProfileOptions& options, const std::vector<NamedFile>& outputs,
                                       bool quiet);
[[nodiscard]] inline Result<Model> open_model(const ProfileOptions& options,
                                              const std::vector<NamedFile>& outputs) {
  return open_model(options, outputs, options.quiet);
}

/// Prints the events of a path on standard error.
void print_events(const std::vector<Event>& events, const Model& model);

/// Prints on standard error the events passed before the position drawn, if there are any.
void print_passed(const std::vector<Event>& passed, const Model& model);

/// From this call on INT, TERM and HUP end the program at once with kExitInterrupted, which is for use while
/// no output has been begun, and a write to a pipe that nobody reads fails.
void end_on_signals();

/// From this call on INT, TERM and HUP only set interruption().
void listen_to_signals();
[[nodiscard]] const std::atomic<bool>& interruption();

/// The exit code after an output could not be written, by interruption() or by a failure.
[[nodiscard]] int exit_unwritten();

/// The exit code after a failed run; prints the error, unless interruption() is the cause.
[[nodiscard]] int exit_failed(const Error& error);

/// Runs `analyze`, `step` or `forces`; returns the exit code.
[[nodiscard]] int run_command(const RunOptions& options);

}  // namespace higherpair::cli

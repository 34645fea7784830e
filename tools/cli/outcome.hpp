#pragma once

#include "higherpair/io/diagnostic.hpp"

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

/// Prints what is wrong on standard error; returns the exit code.
[[nodiscard]] int report_error(const Error& error);

/// The exit code after a failed run; prints the error, unless interruption() is the cause.
[[nodiscard]] int exit_failed(const Error& error);

/// The exit code after an output could not be written, by interruption() or by a failure.
[[nodiscard]] int exit_unwritten();

/// Prints notes on standard error, unless `quiet`.
void print_notes(const Diagnostics& notes, bool quiet);

}  // namespace higherpair::cli

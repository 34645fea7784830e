#pragma once

namespace higherpair::cli {

/// Runs the command that the command line names; returns the exit code.
[[nodiscard]] int run_program(int argc, char** argv);

}  // namespace higherpair::cli

#pragma once

#include "higherpair/front/motion.hpp"

#include <string>
#include <vector>

namespace higherpair::bench {

/// A long run of a shipped profile, making the table of `analyze` or `forces`.
struct LongRun {
  std::string profile;  ///< "four_bar"
  bool forces = false;
};

[[nodiscard]] std::vector<LongRun> long_runs();

/// Ends the program with a message unless two threads give the same lines of CSV as row by row.
void check_long_run(const LongRun& run);

/// Computes all rows as CSV on this many threads and discards the text; returns the number of rows.
double work_out(const LongRun& run, int threads);

/// A computed block of rows, to measure formatting.
struct ReadyBlock {
  std::vector<Column> columns;
  RowBlock rows;
};

[[nodiscard]] ReadyBlock ready_block(const LongRun& run);

}  // namespace higherpair::bench

#pragma once

#include "higherpair/front/motion.hpp"

#include <string>
#include <vector>

namespace higherpair::bench {

/// A long run of a shipped profile, as `analyze` or `forces` makes its table.
struct LongRun {
  std::string profile;  ///< "four_bar"
  bool forces = false;
};

[[nodiscard]] std::vector<LongRun> long_runs();

/// Ends the program with a message unless the lines of CSV are the same row by row and on two threads.
void check_long_run(const LongRun& run);

/// Works out its rows as CSV on so many threads, and throws the text away; returns the number of rows.
double work_out(const LongRun& run, int threads);

/// A block of rows: of which lines can be made.
struct ReadyBlock {
  std::vector<Column> columns;
  RowBlock rows;
};

[[nodiscard]] ReadyBlock ready_block(const LongRun& run);

}  // namespace higherpair::bench

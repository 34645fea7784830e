#pragma once

#include "higherpair/front/motion.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace higherpair {

/// Consecutive rows of a run.
struct RowBlock {
  std::int64_t first = 0;  ///< number of its first row
  std::vector<RowStatus> statuses;
  std::vector<double> values;  ///< row after row, one for each column, as Row::values

  [[nodiscard]] std::size_t size() const { return statuses.size(); }
  /// The values of its i-th row.
  [[nodiscard]] std::span<const double> row(std::size_t i) const {
    const std::size_t width = values.size() / statuses.size();
    return std::span(values).subspan(i * width, width);
  }
};

/// What is written of a block: as many texts as there are outputs.
using BlockTexts = std::vector<std::string>;

/// Works out all rows of a run in blocks, on several threads at once, and gives them to `take` in their
/// order, one block at a time. Rows, events and everything else are those of Analysis::next to the last bit,
/// whatever the number of threads; the analysis is left as it is after the last row, without motion() and
/// reactions(). Memory does not grow with the number of rows. Ends early where `take` returns false, or the
/// run is stopped.
/// \pre no row of the analysis has been taken
/// \param threads  so many; 0: as many as there are cores to be used
/// \param texts    makes what is written of a block, on any thread, several at once; the texts that it gets
///                 are empty, as many as it left of an earlier block, so that their memory is used again
/// \param take     gets the blocks and their texts in order, one at a time; false ends the run
void run_blocks(Analysis& analysis, int threads,
                const std::function<void(const RowBlock&, BlockTexts&)>& texts,
                const std::function<bool(const RowBlock&, const BlockTexts&)>& take);

/// The lines of CSV (with their ends) of a block, appended to `out`: those of append_csv_row.
void append_csv_rows(const std::vector<Column>& columns, const RowBlock& block, std::string& out);

}  // namespace higherpair

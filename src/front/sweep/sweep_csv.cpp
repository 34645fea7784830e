#include "front/columns/column_set.hpp"
#include "higherpair/front/sweep.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace higherpair {

std::string sweep_csv_header(const Sweep& sweep) {
  std::string header;
  for (const Column& column : sweep.columns()) {
    header += csv_head(column) + ",";
  }
  return header + "cause\n";
}

void append_sweep_csv(const Sweep& sweep, const SweepBlock& block, std::string& out) {
  const std::size_t width = sweep.columns().size();
  const auto columns = std::span(sweep.columns()).subspan(1);
  for (std::size_t row = 0; row < block.causes.size(); ++row) {
    const auto values = std::span(block.values).subspan(row * width, width);
    out += std::to_string(static_cast<std::int64_t>(values[0])) + ',';
    append_csv_cells(columns, values.subspan(1), out);
    out += ',';
    append_csv_text(block.causes[row], out);
    out += '\n';
  }
}

}  // namespace higherpair

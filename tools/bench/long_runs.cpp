#include "long_runs.hpp"

#include "cases.hpp"
#include "higherpair/front/model.hpp"

#include <functional>

#include <fmt/core.h>

namespace higherpair::bench {
namespace {

Analysis start(const LongRun& run, std::int64_t rows) {
  const auto model = Model::open(fmt::format("{}/{}.toml", HIGHERPAIR_PROFILES, run.profile));
  require(model.has_value(), run.profile + " cannot be read");
  RunSettings settings;
  settings.samples = rows;
  settings.forces = run.forces;
  auto analysis = model->start(settings);
  require(analysis.has_value(), run.profile + " cannot be started");
  return *std::move(analysis);
}

// Passes on the lines of the table, block by block.
void for_each_text(Analysis& analysis, int threads, const std::function<void(const std::string&)>& take) {
  run_blocks(
      analysis, threads,
      [&](const RowBlock& block, BlockTexts& texts) {
        texts.resize(1);
        append_csv_rows(analysis.columns(), block, texts[0]);
      },
      [&](const RowBlock&, const BlockTexts& texts) {
        take(texts[0]);
        return true;
      });
}

}  // namespace

std::vector<LongRun> long_runs() {
  return {{"four_bar"}, {"watt_sixbar_forces", true}, {"ellipse_cam_roller"}};
}

void check_long_run(const LongRun& run) {
  constexpr std::int64_t kRows = 10000;
  std::string one_by_one;
  Analysis analysis = start(run, kRows);
  Row row;
  while (analysis.next(row)) append_csv_row(analysis.columns(), row, one_by_one);
  std::string in_blocks;
  Analysis blocks = start(run, kRows);
  for_each_text(blocks, 2, [&](const std::string& text) { in_blocks += text; });
  require(in_blocks == one_by_one, run.profile + ": blocks and rows differ");
}

double work_out(const LongRun& run, int threads) {
  constexpr std::int64_t kRows = 200000;
  Analysis analysis = start(run, kRows);
  std::size_t bytes = 0;
  for_each_text(analysis, threads, [&](const std::string& text) { bytes += text.size(); });
  require(bytes > 0, run.profile + ": no text");
  return static_cast<double>(kRows);
}

ReadyBlock ready_block(const LongRun& run) {
  Analysis analysis = start(run, 3600);
  ReadyBlock ready;
  ready.columns = analysis.columns();
  Row row;
  while (analysis.next(row)) {
    ready.rows.statuses.push_back(row.status);
    ready.rows.values.insert(ready.rows.values.end(), row.values.begin(), row.values.end());
  }
  return ready;
}

}  // namespace higherpair::bench

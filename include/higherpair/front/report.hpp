#pragma once

#include "higherpair/front/model.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// What a report is to show.
struct ReportSettings {
  bool in_time = false;                 ///< rows in time, as RunSettings::in_time
  std::optional<std::int64_t> samples;  ///< in place of that of the profile
  double tolerance = 1e-9;              ///< largest closure error of an ok row, of the size of the mechanism
  std::int64_t most_rows = 1441;        ///< >= 2; of a longer run the page holds every n-th row and the last
  std::string source;                   ///< text of the profile, shown at the foot; empty: none
  const std::atomic<bool>* stop = nullptr;  ///< once true, the run ends and there is no page
  /// Called after every row; may be empty.
  std::function<void(std::int64_t row, std::int64_t size)> progress;
};

/// An interactive page about a run, and how the run went.
struct Report {
  std::string html;           ///< one self-contained file; asks nothing of any network; empty once stopped
  bool good = true;           ///< as Analysis::good
  bool stopped = false;       ///< by ReportSettings::stop
  std::int64_t size = 0;      ///< rows of the run
  std::int64_t every = 1;     ///< the page holds one row in so many of them, and the last
  Diagnostics notes;          ///< as Analysis::notes
  std::vector<Event> events;  ///< as Analysis::events
};

/// Runs the model once, with forces where it has masses, loads or springs, and puts what it does into a page.
/// Fails for settings that are wrong or where the page was not built in (kInput), and where the mechanism
/// cannot be started (kMechanism).
[[nodiscard]] Result<Report> report_of(const Model& model, const ReportSettings& settings = {});

}  // namespace higherpair

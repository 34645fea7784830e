#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/front/model.hpp"

#include <atomic>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace higherpair {

/// The smallest and the largest value of a column over all rows of a run, and where they are.
struct ColumnExtremes {
  struct Value {
    double value = std::numeric_limits<double>::quiet_NaN();
    double driver = 0;  ///< position of the driver ReportData::driver
    std::int64_t row = 0;
  };
  Value low, high;
};

/// What a report shows of a run.
struct ReportData {
  std::vector<Column> columns;
  std::int64_t size = 0;                 ///< rows of the whole run
  std::size_t driver = 0;                ///< of Mechanism::drivers, the one by which places are named
  std::vector<Row> rows;                 ///< that the page holds
  std::vector<MotionRow> motions;        ///< the same
  std::vector<Reactions> reactions;      ///< the same, of a run with forces
  std::vector<ColumnExtremes> extremes;  ///< of columns, over the whole run
  /// Of columns: what is small against it by kReportNoise is rounding.
  std::vector<double> scales;
  std::vector<Event> events;
  bool good = true;
};

/// The largest of all values in the unit of each column; of an acceleration at least speed²/way.
[[nodiscard]] std::vector<double> scales_of(const ReportData& data);

/// A finding at the top of the page, such as the stroke of the follower.
struct Fact {
  std::string of;  ///< joint or contact
  std::string name;
  double value = 0;
  std::string unit;
  std::string column;                     ///< to be looked at
  std::vector<ColumnExtremes::Value> at;  ///< where; empty: everywhere
};

[[nodiscard]] std::vector<Fact> facts_of(const Mechanism& mechanism, const ReportData& data);

/// The columns that are plotted at first, plot by plot.
[[nodiscard]] std::vector<std::vector<std::string>> first_plots(const Mechanism& mechanism,
                                                                const ReportData& data);

/// Everything that the page needs, as one object of JSON that may stand within HTML.
/// \param source  text of the profile \param stop  once true, what is long is left out
[[nodiscard]] std::string json_of(const Model& model, const ReportData& data, const std::string& source,
                                  const std::atomic<bool>* stop = nullptr);

/// The row of the page that is at this row of the run, or the next one.
[[nodiscard]] std::size_t page_row(const ReportData& data, std::int64_t row);

}  // namespace higherpair

#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace higherpair {

/// The smallest and the largest value of a column over all rows of a run, and where they are.
struct ColumnExtremes {
  struct Value {
    double value = kNoValue;
    double driver = 0;  ///< position of the driver with index ReportData::driver
    std::int64_t row = 0;
  };
  Value low, high;
};

/// The data of a run that a report shows.
struct ReportData {
  std::vector<Column> columns;
  std::int64_t size = 0;                 ///< number of rows of the whole run
  std::size_t driver = 0;                ///< index in Mechanism::drivers; its positions name places
  std::vector<Row> rows;                 ///< shown on the page
  std::vector<MotionRow> motions;        ///< of these rows
  std::vector<Reactions> reactions;      ///< of these rows, in a run with forces
  std::vector<ColumnExtremes> extremes;  ///< of the columns, over the whole run
  std::vector<double> scales;            ///< of the columns; see scales_of
  std::vector<Event> events;
  bool good = true;
};

/// A fact at the top of the page, such as the stroke of the follower.
struct Fact {
  std::string of;  ///< joint or contact
  std::string name;
  double value = 0;
  std::string unit;
  std::string column;                     ///< to be shown for it
  std::vector<ColumnExtremes::Value> at;  ///< where the value occurs; empty: everywhere
};

/// \param turn  a full turn in the unit of angles
[[nodiscard]] std::vector<Fact> facts_of(const Mechanism& mechanism, double turn, const ReportData& data);

/// The columns that are plotted at first, one list for each plot.
[[nodiscard]] std::vector<std::vector<std::string>> first_plots(const Mechanism& mechanism,
                                                                const ReportData& data);

/// All data of the page, as one JSON object that may be embedded in HTML.
/// \param source  text of the profile \param stop  once true, the long parts are left out
[[nodiscard]] std::string json_of(const Model& model, const ReportData& data, const std::string& source,
                                  const std::atomic<bool>* stop = nullptr);

/// The page's row that is this row of the run, or the next one after it.
[[nodiscard]] std::size_t page_row(const ReportData& data, std::int64_t row);

}  // namespace higherpair

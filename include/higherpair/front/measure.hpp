#pragma once

#include "higherpair/front/model.hpp"
#include "higherpair/io/tasks.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace higherpair {

/// What a measure comes to. Numbers are in the units of the run.
struct Measured {
  /// Undefined (NaN) where no row has a value; of first, last and at where this row has none, or is not
  /// there.
  double value = std::numeric_limits<double>::quiet_NaN();
  /// The row that it is from, of several the first: position of the (first) driver, of a run in
  /// time the time. NaN of range, mean and rms, and where the value is undefined.
  double where = std::numeric_limits<double>::quiet_NaN();
};

/// The settings with the columns that the measures need, and no others; forces and jerk are worked out where
/// a column needs it. Fails, with the place of each, for columns that do not exist (the message names those
/// that are like it) or hold words, and where the model's rows have none at the place that `at` wants.
[[nodiscard]] Result<RunSettings> settings_for(const Model& model, std::span<const Measure> measures,
                                               RunSettings settings = {});

/// Works measures out row by row, so that no table need be kept. A row counts in a measure whatever its
/// status, if it has a value in the column: what numbers of rows that are not ok are worth, their statuses
/// say.
class MeasureSet {
public:
  /// \param columns  of a run with settings_for() these measures
  MeasureSet(std::vector<Measure> measures, const std::vector<Column>& columns);

  /// Forgets all rows.
  void clear();
  /// Takes the next row of the run.
  void add(const Row& row);

  [[nodiscard]] std::size_t size() const { return measures_.size(); }
  /// Of the rows so far.
  [[nodiscard]] Measured value(std::size_t measure) const;
  /// Of the value, "deg/s^2".
  [[nodiscard]] const std::string& unit(std::size_t measure) const { return units_[measure]; }
  /// The column of Measured::where in a row, and its unit, "deg".
  [[nodiscard]] std::size_t where_slot() const { return where_slot_; }
  [[nodiscard]] const std::string& where_unit() const { return where_unit_; }

private:
  struct Seen {
    double value = std::numeric_limits<double>::quiet_NaN();
    double where = std::numeric_limits<double>::quiet_NaN();
  };
  // What one measure keeps of the rows.
  struct State {
    Seen best;              // the row whose value it is; of range the largest
    double low = 0;         // of range the smallest value; of at how far the row is from the place
    long double sum = 0;    // of v or v²: neither rounds nor overflows where a double's would
    std::int64_t rows = 0;  // with a value; not counted of first, last and at
  };

  void take(const Seen& seen, const Measure& measure, State& state) const;

  std::vector<Measure> measures_;
  std::vector<State> states_;
  std::vector<std::size_t> slots_;  // of their columns in a row
  std::vector<std::string> units_;
  std::size_t where_slot_ = 0;
  std::string where_unit_;
  std::int64_t rows_ = 0;
  double low_where_ = 0;  // where rows have been
  double high_where_ = 0;
};

}  // namespace higherpair

#pragma once

#include "higherpair/front/model.hpp"
#include "higherpair/io/tasks.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace higherpair {

/// The value of a measure, in the units of the run.
struct Measured {
  /// NaN if no row has a value; for first, last and at: if that row has none, or does not exist.
  double value = std::numeric_limits<double>::quiet_NaN();
  /// The row that the value comes from (the first of several), by the position of the (first) driver, or by
  /// the time in a run in time. NaN for range, mean and rms, and if the value is undefined.
  double where = std::numeric_limits<double>::quiet_NaN();
};

/// The settings with only the columns that the measures need; forces and jerk are turned on if a column needs
/// them. Fails, with the place of each mistake, for columns that do not exist (the message suggests similar
/// names) or hold words, and if none of the model's rows is where `at` asks for.
[[nodiscard]] Result<RunSettings> settings_for(const Model& model, std::span<const Measure> measures,
                                               RunSettings settings = {});

/// Evaluates measures row by row, so that no table need be kept. Every row with a value in the column counts,
/// whatever its status: the statuses say how far the numbers of rows that are not ok can be trusted.
class MeasureSet {
public:
  /// \pre `columns` are those of a run with the settings from settings_for() for these measures
  MeasureSet(std::vector<Measure> measures, const std::vector<Column>& columns);

  /// Forgets all rows.
  void clear();
  /// Takes the next row of the run.
  void add(const Row& row);

  [[nodiscard]] std::size_t size() const { return measures_.size(); }
  /// The value over the rows so far.
  [[nodiscard]] Measured value(std::size_t measure) const;
  /// The unit of the value, "deg/s^2".
  [[nodiscard]] const std::string& unit(std::size_t measure) const { return units_[measure]; }
  /// The column of Measured::where in a row, and its unit, "deg".
  [[nodiscard]] std::size_t where_slot() const { return where_slot_; }
  [[nodiscard]] const std::string& where_unit() const { return where_unit_; }

private:
  // What one measure keeps of the rows.
  struct State {
    Measured best;          // the row with the value; for range that of the largest
    double low = 0;         // for range the smallest value; for at the distance of the row from the place
                            // asked for
    long double sum = 0;    // of v or v²: more digits and range than a double, against rounding and overflow
    std::int64_t rows = 0;  // with a value; not counted for first, last and at
  };

  void take(const Measured& seen, const Measure& measure, State& state) const;

  std::vector<Measure> measures_;
  std::vector<State> states_;
  std::vector<std::size_t> slots_;  // indices of their columns in a row
  std::vector<std::string> units_;
  std::size_t where_slot_ = 0;
  std::string where_unit_;
  std::int64_t rows_ = 0;
  double low_where_ = 0;  // range of `where` over the rows so far
  double high_where_ = 0;
};

}  // namespace higherpair

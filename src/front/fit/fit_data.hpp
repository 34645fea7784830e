#pragma once

#include "front/model_data.hpp"
#include "higherpair/front/fit.hpp"
#include "higherpair/io/design_task.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// Where the rows are: a driver's positions, or times.
struct FitWhere {
  std::string name;
  std::string unit;
  std::vector<double> values;  ///< in each row, in that unit
  bool offset = false;         ///< whether its zero is unknown
  bool unit_given = false;     ///< in the table's header
  Place place;
};

/// A measured column that takes part in a fit.
struct FitColumn {
  std::string name;
  std::string unit;
  std::vector<double> values;  ///< in each row, in that unit; NaN: missing
  std::optional<double> deviation;
  double weight = 1;
  bool offset = false;
  bool unit_given = false;  ///< in the table's header
  Place place;
};

/// The path of a point in a measuring frame of its own: indices of its columns in FitData::columns.
struct FitFrame {
  FitTask::Frame task;
  std::size_t x = 0, y = 0;
};

/// The table with the number of each row's line: from 1 where it has none. Fails for columns of different
/// lengths.
[[nodiscard]] Result<MeasuredTable> whole(MeasuredTable table);

/// Measured data, converted to the names and units of a model's tables.
struct FitData {
  Model model;
  std::shared_ptr<const DesignTask> variables;
  FitTask task;  ///< with the changes from the settings
  std::vector<int> lines;
  RunSettings settings = {};         ///< of a run that computes the columns
  std::vector<FitWhere> where = {};  ///< for each driver, or for time alone
  std::vector<FitColumn> columns = {};
  std::vector<FitFrame> frames = {};
  std::vector<std::string> notes = {};

  [[nodiscard]] std::size_t rows() const { return lines.size(); }
  [[nodiscard]] bool in_time() const { return settings.in_time; }
  [[nodiscard]] int values() const;
};

[[nodiscard]] Result<FitData> fit_data(const Model& model, const MeasuredTable& measured,
                                       const FitSettings& settings);

}  // namespace higherpair

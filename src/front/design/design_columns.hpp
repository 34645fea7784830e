#pragma once

#include "higherpair/analysis/sensitivity.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/tasks.hpp"
#include "higherpair/io/units.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace higherpair {

/// A column of the motion of a body, one of its points or a revolute joint: its derivative follows from those
/// of the bodies alone.
struct BodyColumn {
  std::size_t body = 0;
  std::optional<std::size_t> point;  ///< none: the origin of the body's frame
  std::size_t quantity = 0;          ///< index of kMotionEndings
  double scale = 1;                  ///< from SI units to the table's
  std::size_t minus = 0;             ///< of angles: the body relative to which they are; 0: ground
};

/// The column of this name; none if it is of another kind.
[[nodiscard]] std::optional<BodyColumn> body_column(const Mechanism& mechanism, const Units& units,
                                                    const std::string& name);

[[nodiscard]] const Dimension& dimension_of(const BodyColumn& column);
/// Of the time derivative: 0 for positions and angles.
[[nodiscard]] int order_of(const BodyColumn& column);

/// The derivative of the column by a parameter, in the row of a run.
[[nodiscard]] double column_slope(const BodyColumn& column, const Run& run, const Mechanism& derivative,
                                  const RowSensitivity& of_row);

/// To first order a measure is a sum over some rows of weight times its column.
struct WeightedRow {
  std::size_t row = 0;
  double weight = 1;
};
/// \param values  of the column, NaN where undefined \param places  driver positions of the rows, as in
/// tables. Empty where the measure is undefined.
[[nodiscard]] std::vector<WeightedRow> rows_of(const Measure& measure, std::span<const double> values,
                                               std::span<const double> places);

/// The driver's position in each row, as in tables.
[[nodiscard]] std::vector<double> places_of(const DriverSchedule& schedule);

/// For each position of the driver, the first of the rows nearest to it; none where no row is there.
[[nodiscard]] std::vector<std::optional<std::size_t>> rows_at(std::span<const double> positions,
                                                              std::span<const double> places);

}  // namespace higherpair

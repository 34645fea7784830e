#pragma once

#include "higherpair/analysis/sensitivity.hpp"
#include "higherpair/io/tasks.hpp"
#include "higherpair/io/units.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace higherpair {

/// A column of a body's motion, or of a point's: its derivative follows from that of the body alone.
struct BodyColumn {
  std::size_t body = 0;
  std::optional<std::size_t> point;  ///< none: of the body's frame
  std::size_t quantity = 0;          ///< x, y, vx, vy, ax, ay, and of a body angle, omega, alpha behind them
  double scale = 1;                  ///< from SI units to the table's
};

/// The column of this name; none where it is another one.
[[nodiscard]] std::optional<BodyColumn> body_column(const Mechanism& mechanism, const Units& units,
                                                    const std::string& name);

/// Its derivative by a parameter in the row of a run.
[[nodiscard]] double column_slope(const BodyColumn& column, const Run& run, const Mechanism& derivative,
                                  const RowSensitivity& of_row);

/// A measure is, to first order, the sum of weights times its column in some rows.
struct WeightedRow {
  std::size_t row = 0;
  double weight = 1;
};
/// \param values  of the column, NaN where undefined \param places  of the driver in the rows, as tables show
/// them. Empty where the measure is undefined.
[[nodiscard]] std::vector<WeightedRow> rows_of(const Measure& measure, std::span<const double> values,
                                               std::span<const double> places);

}  // namespace higherpair

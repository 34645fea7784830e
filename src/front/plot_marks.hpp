#pragma once

#include "higherpair/drawing/picture.hpp"
#include "higherpair/front/motion.hpp"

#include <span>

namespace higherpair {

/// The values of x, and whether they never turn back.
struct XColumn {
  std::span<const double> values;
  bool monotone = false;
};

[[nodiscard]] XColumn x_column(const ColumnValues& x);

/// Adds the rows that are not ok: shaded, or in words where x turns back.
/// \param driver  the first driver
void add_ranges(const Motion& motion, const XColumn& x, const ColumnValues& driver, PlotData& data);

/// Adds the events: lines at x, or points on the series, which are there, where x turns back.
void add_events(const Motion& motion, const XColumn& x, const ColumnValues& driver, PlotData& data);

}  // namespace higherpair

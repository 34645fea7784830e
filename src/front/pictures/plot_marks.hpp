#pragma once

#include "higherpair/drawing/picture.hpp"
#include "higherpair/front/motion.hpp"

#include <span>

namespace higherpair {

/// The values of x, and whether they are monotone, never turning back.
struct XColumn {
  std::span<const double> values;
  bool monotone = false;
};

[[nodiscard]] XColumn x_column(const ColumnValues& x);

/// Adds the rows that are not ok: as shaded ranges, or as notes where x is not monotone.
/// \param driver  the first driver
void add_ranges(const Motion& motion, const XColumn& x, const ColumnValues& driver, PlotData& data);

/// Interrupts the series, which must be present, where an event says that they or x jump.
void add_breaks(const Motion& motion, const XColumn& x, PlotData& data);

/// Adds the events: as lines at x, or, where x is not monotone, as points on the series with their breaks,
/// which must be present.
void add_events(const Motion& motion, const XColumn& x, const ColumnValues& driver, PlotData& data);

}  // namespace higherpair

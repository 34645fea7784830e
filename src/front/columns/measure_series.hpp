#pragma once

#include "front/tolerances.hpp"
#include "higherpair/front/measure.hpp"
#include "higherpair/io/units.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace higherpair {

struct Extremes {
  double low = 0;
  double high = 0;
};
/// \pre there are values, none of them NaN
[[nodiscard]] Extremes extremes_of(std::span<const double> values);

/// Whether a row at the distance `off` from the place `at` is there. \param span  of the places of all rows
[[nodiscard]] inline bool is_there(double off, double at, double span) {
  return off <= kAtPlace * std::max(span, std::abs(at));
}

/// A column of a whole run, defined in every row.
struct Series {
  std::span<const double> values;  ///< in SI units
  Extremes extremes;               ///< of these values
  Scaling scale;                   ///< to the units of the run; its factor > 0
  std::span<const double> where;   ///< for each row, as Measured::where
};

/// What MeasureSet returns for these rows, identical in every digit.
/// \param wants_where  false: Measured::where may be left undefined
[[nodiscard]] Measured measured(const Measure& measure, const Series& series, bool wants_where);

}  // namespace higherpair

#include "column_scales.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>

namespace higherpair {
namespace {

using LargestOfUnit = std::map<std::string, double>;

// Scale of "mm/s^2" from those of "mm/s" and "mm": accelerations that ought to vanish are rounding of that
// size.
double from_speed(const std::string& unit, const LargestOfUnit& largest) {
  const std::size_t slash = unit.find('/');
  if (slash == std::string::npos || !unit.ends_with("^2")) {
    return 0;
  }
  const auto speed = largest.find(unit.substr(0, unit.size() - 2));
  const auto distance = largest.find(unit.substr(0, slash));
  const bool known = speed != largest.end() && distance != largest.end() && distance->second > 0;
  return known ? speed->second * speed->second / distance->second : 0;
}

}  // namespace

double largest_of(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

std::vector<double> scales_of(const std::vector<Column>& columns, const std::vector<double>& largest) {
  LargestOfUnit of_unit;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    double& found = of_unit[columns[k].unit];
    found = std::max(found, largest[k]);
  }
  std::vector<double> scales;
  for (const Column& column : columns) {
    scales.push_back(std::max(of_unit[column.unit], from_speed(column.unit, of_unit)));
  }
  return scales;
}

}  // namespace higherpair

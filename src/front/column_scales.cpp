#include "report_data.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace higherpair {
namespace {

using LargestOfUnit = std::map<std::string, double>;

LargestOfUnit largest_of(const ReportData& data) {
  LargestOfUnit largest;
  for (std::size_t k = 0; k < data.columns.size(); ++k) {
    const auto& [low, high] = data.extremes[k];
    if (!std::isnan(low.value)) {
      double& found = largest[data.columns[k].unit];
      found = std::max({found, std::abs(low.value), std::abs(high.value)});
    }
  }
  return largest;
}

// Scale of "mm/s^2" from those of "mm/s" and "mm": accelerations that ought to vanish are rounding of that
// size.
double from_speed(const std::string& unit, const LargestOfUnit& largest) {
  const std::size_t slash = unit.find('/');
  if (slash == std::string::npos || !unit.ends_with("^2")) {
    return 0;
  }
  const auto speed = largest.find(unit.substr(0, unit.size() - 2));
  const auto way = largest.find(unit.substr(0, slash));
  const bool known = speed != largest.end() && way != largest.end() && way->second > 0;
  return known ? speed->second * speed->second / way->second : 0;
}

}  // namespace

std::vector<double> scales_of(const ReportData& data) {
  const LargestOfUnit largest = largest_of(data);
  std::vector<double> scales;
  for (const Column& column : data.columns) {
    const auto found = largest.find(column.unit);
    scales.push_back(std::max(found == largest.end() ? 0 : found->second, from_speed(column.unit, largest)));
  }
  return scales;
}

}  // namespace higherpair

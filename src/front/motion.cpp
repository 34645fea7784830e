#include "higherpair/front/motion.hpp"

#include "front/columns/column_set.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "model_data.hpp"

#include <algorithm>
#include <stdexcept>

namespace higherpair {

Motion::Motion(Analysis analysis) : columns_(analysis.columns()), values_(columns_.size()) {
  constexpr std::int64_t kMostReserved = 1 << 20;
  for (std::vector<double>& values : values_) {
    values.reserve(static_cast<std::size_t>(std::min(analysis.size(), kMostReserved)));
  }
  Row row;
  while (analysis.next(row)) {
    statuses_.push_back(row.status);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      values_[i].push_back(row.values[i]);
    }
  }
  events_ = analysis.events();
  notes_ = analysis.notes();
  stopped_ = analysis.stopped();
  good_ = analysis.good() && !stopped_;
}

Result<ColumnValues> Motion::find_column(std::string_view name) const& {
  if (const std::size_t i = column_slot(columns_, name); i < columns_.size()) {
    return ColumnValues{columns_[i].name, columns_[i].unit, values_[i]};
  }
  std::vector<std::string> names;
  for (const Column& column : columns_) {
    names.push_back(column.name);
  }
  return wrong(Place{"column " + std::string(name)},
               "there is none of this name; " + suggestion(name, names));
}

ColumnValues Motion::column(std::string_view name) const& {
  const Result<ColumnValues> found = find_column(name);
  if (!found) {
    throw std::out_of_range(to_string(found.error()));
  }
  return *found;
}

}  // namespace higherpair

#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

namespace higherpair::cli {

/// CSV columns for values whose unit differs from row to row: one column for each unit.
class UnitColumns {
public:
  /// \param units  units of the values, repeated or not; "1" if there are none
  explicit UnitColumns(const std::vector<std::string>& units) {
    for (const std::string& unit : units) {
      if (std::find(units_.begin(), units_.end(), unit) == units_.end()) {
        units_.push_back(unit);
      }
    }
    if (units_.empty()) {
      units_.emplace_back("1");
    }
  }

  /// ",NAME[UNIT]" for each unit.
  [[nodiscard]] std::string heads(const std::string& name) const {
    std::string text;
    for (const std::string& unit : units_) {
      text += fmt::format(",{}[{}]", name, unit);
    }
    return text;
  }

  /// The value in the column of its unit and empty fields in the others, each preceded by a comma.
  [[nodiscard]] std::string cells(const std::string& unit, std::optional<double> value) const {
    std::string text;
    for (const std::string& column : units_) {
      text += value && column == unit ? fmt::format(",{}", *value) : ",";
    }
    return text;
  }

private:
  std::vector<std::string> units_;
};

}  // namespace higherpair::cli

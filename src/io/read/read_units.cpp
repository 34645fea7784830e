#include "reading.hpp"

namespace higherpair::io_detail {
namespace {

std::vector<std::string> unit_names(const Dimension& dimension) {
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(Unit::kPoundForce); ++i) {
    const auto unit = static_cast<Unit>(i);
    if (dimension_of(unit) == dimension) {
      names.emplace_back(name_of(unit));
    }
  }
  return names;
}

void read_unit(TableReader& table, const std::string& key, Unit& unit) {
  const auto item = table.take(key);
  if (!item) {
    return;
  }
  const std::vector<std::string> names = unit_names(dimension_of(unit));
  if (const auto choice = as_choice(table.reading(), *item, names)) {
    unit = *find_unit(names[*choice]);
  }
}

}  // namespace

void read_units(TableReader& root) {
  auto table = as_reader(root.reading(), root.take("units"), "a table");
  if (!table) {
    return;
  }
  Units& units = root.reading().units;
  read_unit(*table, "length", units.length);
  read_unit(*table, "angle", units.angle);
  read_unit(*table, "mass", units.mass);
  read_unit(*table, "time", units.time);
  read_unit(*table, "force", units.force);
  table->finish();
}

}  // namespace higherpair::io_detail

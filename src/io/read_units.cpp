#include "reading.hpp"

#include <array>

#include <fmt/format.h>

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
  const auto item = root.take("units");
  const Table* table = item ? as_table(root.reading(), *item, "a table") : nullptr;
  if (table == nullptr) {
    return;
  }
  Units& units = root.reading().units;
  TableReader reader(root.reading(), *table, item->value->mark, item->path);
  read_unit(reader, "length", units.length);
  read_unit(reader, "angle", units.angle);
  read_unit(reader, "mass", units.mass);
  read_unit(reader, "time", units.time);
  read_unit(reader, "force", units.force);
  reader.finish();
}

}  // namespace higherpair::io_detail

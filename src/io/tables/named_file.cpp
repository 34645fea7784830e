#include "named_file.hpp"

#include "io/document/text_file.hpp"

#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {

std::optional<std::string> read_named_file(TableReader& table, const Item& item, const std::string& what) {
  Reading& reading = table.reading();
  const auto name = as_text(reading, item);
  if (!name) {
    return std::nullopt;
  }
  const std::string path = beside(reading.sources.front(), *name);
  auto text = read_text_file(path, what);
  if (!text) {
    report(reading, item, text.error());
    return std::nullopt;
  }
  reading.files.push_back(path);
  return *std::move(text);
}

void report_in_file(TableReader& table, const Item& item, int line, const std::string& message) {
  report(table.reading(), item, fmt::format("line {}: {}", line, message));
}

std::optional<Unit> read_file_unit(TableReader& table) {
  const auto item = table.take("units");
  const auto name = item ? as_text(table.reading(), *item) : std::nullopt;
  const auto unit = name ? find_unit(*name) : std::nullopt;
  if (name && (!unit || dimension_of(*unit) != dimension::kLength)) {
    report(table.reading(), *item, "expected a unit of length: m, cm, mm, um, km, in, ft");
    return std::nullopt;
  }
  return unit;
}

std::optional<PointTable> read_point_file(TableReader& table, const Item& item, const PointColumns& columns,
                                          const Units& units) {
  const auto text = read_named_file(table, item, "table");
  if (!text) {
    return std::nullopt;
  }
  auto points = read_points(*text, columns, units);
  if (!points) {
    for (const std::string& mistake : points.error()) {
      report(table.reading(), item, mistake);
    }
    return std::nullopt;
  }
  return *std::move(points);
}

std::optional<PointTable> read_place_file(TableReader& table, const Item& item) {
  const Units units = {.length = read_file_unit(table).value_or(table.reading().units.length)};
  return read_point_file(table, item, {{"x", "y"}, {dimension::kLength, dimension::kLength}}, units);
}

}  // namespace higherpair::io_detail

// The path of a point as a design's objective.
#include "io/tables/named_file.hpp"
#include "number_unit.hpp"
#include "read_design.hpp"

#include <string>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

using PointPath = DesignTask::PointPath;

void check_points(Reading& reading, const Item& item, const PointPath& path) {
  if (path.through.size() < 2) {
    report(reading, item, "expected at least two points: one alone is no path");
  }
  for (std::size_t i = 1; i < path.through.size(); ++i) {
    if (path.through[i] == path.through[i - 1]) {
      report(reading, item, fmt::format("points {} and {} are the same: leave one out", i, i + 1));
    }
  }
}

void read_list_of_points(Reading& reading, const Item& list, PointPath& path) {
  const auto items = as_items(reading, list, "a list of points, [[x, y], …]", 0);
  if (!items) return;
  for (const Item& entry : *items) {
    const auto point = as_vector(reading, entry, dimension::kLength);
    if (!point) return;
    path.through.push_back(*point);
  }
  check_points(reading, list, path);
}

void read_file_of_points(TableReader& table, const Item& file, PointPath& path) {
  const auto read = read_place_file(table, file);
  if (!read) return;
  for (const auto& [x, y] : read->points) path.through.emplace_back(x.si, y.si);
  check_points(table.reading(), file, path);
}

void read_positions(Reading& reading, const Item& at, const Mechanism& mechanism, PointPath& path) {
  const std::size_t count = path.through.size();
  const auto items =
      as_items(reading, at, fmt::format("a list of {} positions of the driver, one for each point", count),
               count, count);
  for (const Item& item : items.value_or(std::vector<Item>{})) {
    if (const auto position = as_number_in(reading, item, unit_of_driver(mechanism)))
      path.at.push_back(*position);
  }
}

}  // namespace

FreePlacement read_free(Reading& reading, const Item& free) {
  static const std::vector<std::string> names = {"position", "turn", "scale"};
  FreePlacement placement;
  const auto items = as_items(
      reading, free, "a list of \"position\", \"turn\" and \"scale\", such as [\"position\", \"turn\"]");
  for (const Item& item : items.value_or(std::vector<Item>{})) {
    const auto choice = as_choice(reading, item, names);
    bool* const flags[] = {&placement.position, &placement.turn, &placement.scale};
    if (choice) *flags[*choice] = true;
  }
  return placement;
}

std::optional<PointPath> read_point_path(TableReader& table, const Mechanism& mechanism) {
  Reading& reading = table.reading();
  PointPath path;
  bool known = false;
  if (const auto item = table.need("point", "the point whose path is meant, \"coupler.E\"")) {
    const auto point = as_point(reading, *item, mechanism);
    if (point && point->body == 0) report(reading, *item, "a point of ground does not move");
    if (point) path.point = as_text(reading, *item).value();
    path.ref = point.value_or(PointRef());
    known = point.has_value();
  }
  if (const auto file = table.take("file")) {
    table.refuse("through", "the points are in the file already: one of the two");
    read_file_of_points(table, *file, path);
  } else if (const auto list = table.need(
                 "through", "[[x, y], …], the points of the path in ground (or a `file` with them)")) {
    read_list_of_points(reading, *list, path);
  }
  path.timed = table.flag("timed", false);
  path.ordered = table.flag("ordered", true);
  path.closed = table.flag("closed", false);
  if (!path.timed) {
    table.refuse("at", "holds for a path with timed = true");
  } else if (const auto at = table.take("at")) {
    read_positions(reading, *at, mechanism, path);
  }
  if (path.timed && path.closed) table.refuse("closed", "the points of a timed path have their rows");
  if (const auto free = table.take("free")) {
    const FreePlacement placement = read_free(reading, *free);
    path.free_position = placement.position;
    path.free_turn = placement.turn;
    path.free_scale = placement.scale;
    // A mistake with fewer points is reported elsewhere.
    if (path.free_position && path.through.size() == 2) {
      report(reading, *free, "expected at least three points: two have no form but their distance");
    }
  }
  return known && path.through.size() > 1 ? std::optional(std::move(path)) : std::nullopt;
}

}  // namespace higherpair::io_detail

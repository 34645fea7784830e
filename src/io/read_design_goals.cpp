#include "higherpair/io/suggestion.hpp"
#include "point_table.hpp"
#include "read_boundary.hpp"
#include "read_design.hpp"
#include "read_measure.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace higherpair::io_detail {
namespace {

using PointPath = DesignTask::PointPath;

bool find_point(Reading& reading, const Item& item, const Mechanism& mechanism, PointPath& path) {
  std::vector<std::string> names;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      names.push_back(body.name + "." + body.points[p].name);
      if (names.back() == path.point) {
        path.ref = {static_cast<int>(b), static_cast<int>(p)};
        if (b == 0) report(reading, item, "a point of ground does not move");
        return true;
      }
    }
  }
  report(reading, item, "there is no such point; " + suggestion(path.point, names));
  return false;
}

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
  const auto* items = std::get_if<Array>(&list.value->content);
  if (items == nullptr) {
    report(reading, list, "expected a list of points, [[x, y], …]");
    return;
  }
  for (std::size_t i = 0; i < items->size(); ++i) {
    const Item entry = {&(*items)[i], fmt::format("{}.{}", list.path, i)};
    const auto point = as_vector(reading, entry, dimension::kLength);
    if (!point) return;
    path.through.push_back(*point);
  }
  check_points(reading, list, path);
}

void read_file_of_points(TableReader& table, const Item& file, PointPath& path) {
  Reading& reading = table.reading();
  const std::optional<Unit> unit = read_file_unit(table);
  const auto text = read_named_file(table, file, "table");
  if (!text) return;
  const auto read = read_points(*text, {{"x", "y"}, {dimension::kLength, dimension::kLength}},
                                {.length = unit.value_or(reading.units.length)});
  if (!read) {
    for (const std::string& mistake : read.error()) report(reading, file, mistake);
    return;
  }
  for (const auto& [x, y] : read->points) path.through.emplace_back(x.si, y.si);
  check_points(reading, file, path);
}

void read_positions(Reading& reading, const Item& at, PointPath& path) {
  const auto* items = std::get_if<Array>(&at.value->content);
  if (items == nullptr || items->size() != path.through.size()) {
    report(reading, at,
           fmt::format("expected a list of {} positions of the driver, one for each point",
                       path.through.size()));
    return;
  }
  for (std::size_t i = 0; i < items->size(); ++i) {
    const auto position = as_plain_number(reading, {&(*items)[i], fmt::format("{}.{}", at.path, i)});
    if (position) path.at.push_back(*position);
  }
}

std::optional<PointPath> read_point_path(TableReader& table, const Mechanism& mechanism) {
  Reading& reading = table.reading();
  PointPath path;
  bool known = false;
  if (const auto item = table.need("point", "the point whose path is meant, \"coupler.E\"")) {
    path.point = as_text(reading, *item).value_or("");
    known = !path.point.empty() && find_point(reading, *item, mechanism, path);
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
    read_positions(reading, *at, path);
  }
  if (path.timed && path.closed) table.refuse("closed", "the points of a timed path have their rows");
  return known && path.through.size() > 1 ? std::optional(std::move(path)) : std::nullopt;
}

// `follow`: pairs of a position of the driver and the value that the column is to have there.
void read_follow(TableReader& table, const Item& follow, DesignTask::Objective& objective) {
  Reading& reading = table.reading();
  table.refuse("of", "the column is followed at the positions in `follow`");
  table.refuse("at", "the positions are those in `follow`");
  table.refuse("target", "the values are those in `follow`");
  Measure measure;
  if (const auto column = table.need("column", "the name of a column, such as \"follower.angle\"")) {
    measure.place = place_of(reading, column->value->mark);
    measure.path = column->path;
    measure.column = as_text(reading, *column).value_or("");
  }
  measure.of = MeasureKind::kAt;
  const auto* items = std::get_if<Array>(&follow.value->content);
  if (items == nullptr || items->size() < 2) {
    report(reading, follow, "expected a list of at least two pairs, [[driver, value], …]");
    return;
  }
  for (std::size_t i = 0; i < items->size(); ++i) {
    const auto pair =
        as_list(reading, {&(*items)[i], fmt::format("{}.{}", follow.path, i)}, {dimension::kNumber}, 2);
    if (!pair) return;
    measure.at = (*pair)[0].value;
    objective.followed.push_back(measure);
    objective.values.push_back((*pair)[1].value);
  }
}

}  // namespace

std::optional<double> as_plain_number(Reading& reading, const Item& item) {
  if (std::holds_alternative<std::string>(item.value->content)) {
    report(reading, item, "expected a plain number, in the unit that it has in the profile or in tables");
    return std::nullopt;
  }
  const auto quantity = as_quantity(reading, item, {dimension::kNumber});
  return quantity ? std::optional(quantity->value) : std::nullopt;
}

std::optional<double> optional_plain_number(TableReader& table, const std::string& key) {
  const auto item = table.take(key);
  return item ? as_plain_number(table.reading(), *item) : std::nullopt;
}

std::optional<DesignTask::Objective> read_objective(TableReader& table, const Profile& profile) {
  Reading& reading = table.reading();
  DesignTask::Objective objective;
  objective.path_of_key = table.path();
  objective.place = place_of(reading, table.mark());
  if (const auto path = table.take("path")) {
    table.refuse("column", "this objective is a path: make an objective of its own of the column");
    table.refuse("of", "belongs to `column`");
    table.refuse("target", "a path is met as well as it can be");
    if (const Table* content = as_table(reading, *path, "a path, { point = …, through = … }")) {
      TableReader reader(reading, *content, path->value->mark, path->path);
      objective.path = read_point_path(reader, profile.mechanism);
      reader.finish();
    }
  } else if (const auto follow = table.take("follow")) {
    read_follow(table, *follow, objective);
  } else {
    objective.measure = read_measure(table);
    objective.target = optional_plain_number(table, "target");
  }
  if (const auto weight = table.take("weight")) {
    objective.weight = as_plain_number(reading, *weight).value_or(1);
    if (!(objective.weight > 0)) report(reading, *weight, "must be > 0");
  }
  const bool complete = objective.path || objective.measure || !objective.followed.empty();
  return complete ? std::optional(std::move(objective)) : std::nullopt;
}

std::optional<DesignTask::Constraint> read_constraint(TableReader& table, const Profile& profile) {
  Reading& reading = table.reading();
  DesignTask::Constraint constraint;
  constraint.path_of_key = table.path();
  constraint.place = place_of(reading, table.mark());
  if (const auto pin = table.take("transmission")) {
    table.refuse("column", "this constraint is one of a transmission angle");
    table.refuse("of", "a transmission angle counts where it is least");
    const auto joint = as_joint(reading, *pin, profile.mechanism);
    if (joint && profile.mechanism.joints[static_cast<std::size_t>(*joint)].type != JointType::kRevolute) {
      report(reading, *pin, "expected a revolute joint, the pin between two links");
    } else if (joint) {
      constraint.transmission = DesignTask::Transmission{as_text(reading, *pin).value_or(""), *joint};
    }
  } else {
    constraint.measure = read_measure(table);
  }
  constraint.below = optional_plain_number(table, "below");
  constraint.above = optional_plain_number(table, "above");
  const auto wrong = [&](const std::string& what) {
    reading.mistakes.push_back({table.mark(), table.path() + ": " + what});
  };
  if (!constraint.below && !constraint.above) {
    wrong("a limit is missing: below = … or above = …");
  } else if (constraint.below && constraint.above && !(*constraint.above < *constraint.below)) {
    wrong(fmt::format("nothing is above {} and below {}", *constraint.above, *constraint.below));
  }
  const bool complete = constraint.measure || constraint.transmission;
  return complete ? std::optional(std::move(constraint)) : std::nullopt;
}

}  // namespace higherpair::io_detail

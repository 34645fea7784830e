// How far the mechanism extends, as an objective or constraint of a design.
#include "read_design.hpp"

#include <numeric>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

using Extent = DesignTask::Extent;

std::optional<Extent> read_reach(TableReader& table, const Item& reach, const Mechanism& mechanism) {
  Reading& reading = table.reading();
  table.refuse("size", "this is a reach: make an entry of its own of the size");
  table.refuse("bodies", "a reach is that of one point");
  const auto from = table.need("from", "the point from which the reach is measured, such as \"ground.O\"");
  const auto point = as_point(reading, reach, mechanism);
  const auto origin = from ? as_point(reading, *from, mechanism) : std::nullopt;
  if (!point || !origin) {
    return std::nullopt;
  }
  if (point->body == origin->body) {
    report(reading, reach, "both points are of one body: their distance does not change as it moves");
    return std::nullopt;
  }
  Extent extent{Extent::Kind::kReach, *point, *origin, {}, ""};
  extent.words =
      fmt::format("reach of {} from {}", as_text(reading, reach).value(), as_text(reading, *from).value());
  return extent;
}

// The bodies given by `bodies`; all bodies if the key is absent.
std::vector<int> bodies_that_count(TableReader& table, const Mechanism& mechanism) {
  std::vector<int> bodies(mechanism.bodies.size());
  std::iota(bodies.begin(), bodies.end(), 0);
  const auto item = table.take("bodies");
  if (!item) {
    return bodies;
  }
  bodies.clear();
  const auto items = as_items(table.reading(), *item, "a list of bodies, such as [\"crank\", \"coupler\"]");
  for (const Item& one : items.value_or(std::vector<Item>{})) {
    if (const auto body = as_body(table.reading(), one, mechanism)) bodies.push_back(*body);
  }
  return bodies;
}

std::optional<Extent> read_size(TableReader& table, const Item& size, const Mechanism& mechanism) {
  const auto choice = as_choice(table.reading(), size, {"width", "height", "largest"});
  table.refuse("from", "belongs to a reach");
  Extent extent;
  extent.bodies = bodies_that_count(table, mechanism);
  if (!choice) {
    return std::nullopt;
  }
  constexpr Extent::Kind kKinds[] = {Extent::Kind::kWidth, Extent::Kind::kHeight, Extent::Kind::kLargest};
  extent.kind = kKinds[*choice];
  extent.words = *choice == 2 ? "width or height" : as_text(table.reading(), size).value();
  return extent;
}

}  // namespace

bool is_extent(const TableReader& table) {
  return table.has("reach") || table.has("size");
}

std::optional<Extent> read_extent(TableReader& table, const Mechanism& mechanism) {
  table.refuse("column", "this is about how far the mechanism comes: make an entry of its own of the column");
  table.refuse("of", "an extent is the largest already");
  const auto reach = table.take_kind("reach");
  return reach ? read_reach(table, *reach, mechanism) : read_size(table, *table.take("size"), mechanism);
}

}  // namespace higherpair::io_detail

#include "number_unit.hpp"

#include "higherpair/io/column_dimension.hpp"
#include "higherpair/io/coordinate.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

NumberUnit with_dimension(const Dimension& dimension, const std::string& whose) {
  if (dimension == dimension::kNumber) {
    return {std::nullopt, whose + " has no unit: write a plain number"};
  }
  return {dimension, ""};
}

NumberUnit in_tables(const std::optional<Dimension>& dimension, const std::string& whose) {
  if (dimension) {
    return with_dimension(*dimension, whose);
  }
  return {
      std::nullopt,
      fmt::format("the unit of `{}` is not known here: write a plain number, in the unit of tables", whose)};
}

// Reports a text where only a plain number is possible.
bool refuses(Reading& reading, const Item& item, const NumberUnit& unit) {
  if (unit.dimension || !std::holds_alternative<std::string>(item.value->content)) {
    return false;
  }
  if (!unit.objection.empty()) {
    report(reading, item, unit.objection);
  }
  return true;
}

Expected expected_in(const NumberUnit& unit) {
  return {unit.dimension.value_or(dimension::kNumber)};
}

}  // namespace

NumberUnit unit_of_paths(const Reading& reading, const std::vector<std::string>& paths) {
  const auto dimension_at = [&](const std::string& path) { return varied_dimension(reading, path); };
  const auto dimension = paths.empty() ? std::nullopt : dimension_at(paths.front());
  if (!dimension && !reading.mistakes.empty()) {
    return {};
  }
  const auto other = std::find_if(paths.begin(), paths.end(),
                                  [&](const std::string& path) { return dimension_at(path) != dimension; });
  if (other != paths.end()) {
    return {std::nullopt,
            fmt::format("{} and {} have different units: write a plain number", paths.front(), *other)};
  }
  return with_dimension(dimension.value_or(dimension::kNumber), paths.front());
}

NumberUnit unit_of_column(const Reading& reading, const Mechanism& mechanism, const std::string& column) {
  const bool is_jerk = column.ends_with(".jerk") || column.ends_with(".jerk_linkage");
  if (is_jerk && !reading.mistakes.empty()) {
    return {};  // a mechanism with mistakes cannot be planned
  }
  return in_tables(column_dimension(mechanism, column), column);
}

NumberUnit unit_of_figure(const Mechanism& mechanism, const std::string& item, const std::string& quantity) {
  return in_tables(figure_dimension(mechanism, item, quantity), quantity);
}

NumberUnit unit_of_driver(const Mechanism& mechanism) {
  if (mechanism.drivers.empty() || mechanism.drivers.front().joint < 0) {
    return {};
  }
  return {driver_dimension(mechanism), ""};
}

NumberUnit unit_of_place(const Mechanism& mechanism, bool in_time) {
  return in_time ? NumberUnit{dimension::kTime, ""} : unit_of_driver(mechanism);
}

NumberUnit product_of(const NumberUnit& a, const NumberUnit& b) {
  if (!a.dimension || !b.dimension) {
    return a.dimension ? b : a;
  }
  return with_dimension(*a.dimension * *b.dimension, "this covariance");
}

NumberUnit no_unit() {
  return {std::nullopt, "this has no unit: write a plain number"};
}

std::optional<double> number_read(const Reading& reading, const Value& value) {
  if (const auto number = number_in(value)) {
    return number;
  }
  const auto* text = std::get_if<std::string>(&value.content);
  const auto known = reading.varied.find(&value);
  if (text == nullptr || known == reading.varied.end() || !known->second) {
    return std::nullopt;
  }
  const auto quantity = parse_quantity(*text, *known->second, reading.units);
  return quantity ? std::optional(quantity->profile) : std::nullopt;
}

std::optional<double> as_number_in(Reading& reading, const Item& item, const NumberUnit& unit) {
  if (refuses(reading, item, unit)) {
    return std::nullopt;
  }
  const auto quantity = as_quantity(reading, item, expected_in(unit));
  return quantity ? std::optional(quantity->profile) : std::nullopt;
}

std::optional<double> as_positive_in(Reading& reading, const Item& item, const NumberUnit& unit) {
  const auto number = as_number_in(reading, item, unit);
  if (number && !(*number > 0)) {
    report(reading, item, "must be > 0");
    return std::nullopt;
  }
  return number;
}

std::optional<std::vector<double>> as_numbers_in(Reading& reading, const Item& item, const NumberUnit& unit,
                                                 std::size_t count) {
  const std::vector<Item> items = items_of(item);
  if (std::any_of(items.begin(), items.end(), [&](const Item& one) { return refuses(reading, one, unit); })) {
    return std::nullopt;
  }
  const auto list = as_list(reading, item, expected_in(unit), count);
  if (!list) {
    return std::nullopt;
  }
  std::vector<double> numbers;
  for (const Quantity& quantity : *list) numbers.push_back(quantity.profile);
  return numbers;
}

}  // namespace higherpair::io_detail

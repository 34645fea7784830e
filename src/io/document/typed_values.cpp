#include "typed_values.hpp"

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/numeric/contains.hpp"
#include "io/units/unit_table.hpp"
#include "numeric/joined_words.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace higherpair::io_detail {
namespace {

// A list such as [30,5, 2] that was probably meant as [30.5, 2]; not one to which an override has added.
bool may_be_decimal_commas(const Array& items, std::size_t count) {
  const auto is_whole = [&](const Value& item) {
    return std::holds_alternative<std::int64_t>(item.content) &&
           item.mark.source == items.front().mark.source;
  };
  const auto is_zero = [](const Value& item) {
    const auto* number = std::get_if<std::int64_t>(&item.content);
    return number != nullptr && *number == 0;
  };
  return items.size() > count && items.size() <= 2 * count &&
         std::all_of(items.begin(), items.end(), is_whole) &&
         !std::all_of(items.begin(), items.end(), is_zero);
}

// Whether a text would be right without its quotes: one of `words`, or a number, or a list.
bool is_quoted_needlessly(const Item& item, std::string_view expected,
                          std::initializer_list<std::string_view> words) {
  const auto* text = std::get_if<std::string>(&item.value->content);
  if (text == nullptr) {
    return false;
  }
  const Value bare = parse_override_value(*text, 0);
  if (expected.starts_with("a list")) {
    return std::holds_alternative<Array>(bare.content);
  }
  const bool is_number =
      std::holds_alternative<std::int64_t>(bare.content) || std::holds_alternative<double>(bare.content);
  return words.size() == 0 ? is_number : contains(words, *text);
}

bool has_sign(double value, Sign sign) {
  return sign == Sign::kAny || value > 0 || (sign == Sign::kNotNegative && value == 0);
}

// A number without a unit of its own, which is in the profile's unit.
std::optional<Quantity> plain_quantity(Reading& reading, const Item& item, double value,
                                       const Dimension& dimension) {
  const Quantity quantity = {value, to_si(dimension, reading.units).apply(value), value};
  if (!std::isfinite(quantity.si)) {
    report(reading, item, "must be a finite number");
    return std::nullopt;
  }
  return quantity;
}

std::optional<Quantity> quantity_of_any_sign(Reading& reading, const Item& item, const Dimension& dimension) {
  if (const auto* integer = std::get_if<std::int64_t>(&item.value->content)) {
    return plain_quantity(reading, item, static_cast<double>(*integer), dimension);
  }
  if (const auto* number = std::get_if<double>(&item.value->content)) {
    return plain_quantity(reading, item, *number, dimension);
  }
  const auto* text = std::get_if<std::string>(&item.value->content);
  if (text == nullptr || dimension == dimension::kNumber) {
    report_kind(reading, item, what_number(dimension, reading.units));
    return std::nullopt;
  }
  const auto quantity = parse_quantity(*text, dimension, reading.units);
  if (!quantity) {
    report(reading, item, quantity.error());
    return std::nullopt;
  }
  return *quantity;
}

void report_sign(Reading& reading, const Item& item, const Expected& expected) {
  std::string unit;
  if (!std::holds_alternative<std::string>(item.value->content) && expected.dimension != dimension::kNumber) {
    unit = fmt::format(" {}", unit_text(expected.dimension, reading.units));
  }
  reading.mistakes.push_back(
      {item.value->mark, fmt::format("{} = {}{}: must be {} 0", path_of(reading, item), text_of(*item.value),
                                     unit, expected.sign == Sign::kPositive ? ">" : ">=")});
}

// A unit vector. At multiples of 90° its sine or cosine differs from 0 only by the rounding of the angle.
Vector2d direction_of(double angle) {
  const double rounding = std::numeric_limits<double>::epsilon() * std::max(1.0, std::abs(angle));
  Vector2d direction = unit_vector(angle);
  for (int axis : {0, 1}) {
    if (std::abs(direction(axis)) <= rounding) {
      direction(axis) = 0;
      direction(1 - axis) = std::copysign(1.0, direction(1 - axis));
    }
  }
  return direction;
}

// Adds the places of all that a value contains.
void add_places(const Value& value, ValuePlaces& places) {
  if (const auto* table = std::get_if<Table>(&value.content)) {
    for (const Entry& entry : *table) {
      places[&entry.value] = {&value, &entry.key, 0};
      add_places(entry.value, places);
    }
  } else if (const auto* items = std::get_if<Array>(&value.content)) {
    for (std::size_t i = 0; i < items->size(); ++i) {
      places[&(*items)[i]] = {&value, nullptr, i};
      add_places((*items)[i], places);
    }
  }
}

}  // namespace

std::string path_of(Reading& reading, const Item& item) {
  if (reading.places == nullptr) {
    ValuePlaces places;
    add_places(*reading.document, places);
    reading.places = std::make_shared<const ValuePlaces>(std::move(places));
  }
  std::vector<std::string> parts;
  for (const Value* value = item.value; value != reading.document;) {
    const ValuePlace& place = reading.places->at(value);
    parts.push_back(place.key != nullptr ? *place.key : std::to_string(place.index));
    value = place.parent;
  }
  std::reverse(parts.begin(), parts.end());
  return fmt::format("{}", fmt::join(parts, "."));
}

std::optional<Dimension> varied_dimension(const Reading& reading, std::string_view path) {
  const Value* value = end_of_path(std::get<Table>(reading.document->content), path).value;
  const auto found = reading.varied.find(value);
  return found == reading.varied.end() ? std::nullopt : found->second;
}

Place place_of(const Reading& reading, const Mark& mark) {
  return {reading.sources[mark.source], mark.line, mark.column};
}

std::vector<Item> items_of(const Item& item) {
  std::vector<Item> items;
  if (const auto* values = std::get_if<Array>(&item.value->content)) {
    items.reserve(values->size());
    for (const Value& value : *values) {
      items.push_back({&value});
    }
  }
  return items;
}

void report(Reading& reading, const Item& item, std::string_view rule, const std::string& lacks) {
  const std::string path = path_of(reading, item);
  Mistake mistake{item.value->mark, fmt::format("{} = {}: {}", path, text_of(*item.value), rule)};
  if (!std::holds_alternative<Table>(item.value->content)) mistake.subject = path;
  if (!lacks.empty()) mistake.lacks.push_back(lacks);
  reading.mistakes.push_back(std::move(mistake));
}

void report_kind(Reading& reading, const Item& item, std::string_view what,
                 std::initializer_list<std::string_view> words) {
  const auto* text = std::get_if<std::string>(&item.value->content);
  const std::string advice = text == nullptr                           ? ""
                             : is_quoted_needlessly(item, what, words) ? "leave the quotes out"
                                                                       : separator_advice(*text);
  report(reading, item,
         fmt::format("expected {}, found {}{}{}", what, kind_of(*item.value), advice.empty() ? "" : ": ",
                     advice));
}

std::string what_number(const Dimension& dimension, const Units& units) {
  if (dimension == dimension::kNumber) {
    return "a number";
  }
  return fmt::format("{} (a number in {} or a string with its unit)", describe(dimension),
                     unit_text(dimension, units));
}

const Table* as_table(Reading& reading, const Item& item, std::string_view what) {
  const auto* table = std::get_if<Table>(&item.value->content);
  const auto* items = std::get_if<Array>(&item.value->content);
  if (items != nullptr && !items->empty() && std::holds_alternative<Table>(items->front().content)) {
    report(reading, item, fmt::format("a heading has one pair of brackets: [{}]", path_of(reading, item)));
  } else if (table == nullptr) {
    report_kind(reading, item, what);
  }
  return table;
}

std::optional<std::string> as_text(Reading& reading, const Item& item) {
  if (const auto* text = std::get_if<std::string>(&item.value->content)) {
    return *text;
  }
  report_kind(reading, item, "a string");
  return std::nullopt;
}

std::optional<bool> as_flag(Reading& reading, const Item& item) {
  if (const auto* flag = std::get_if<bool>(&item.value->content)) {
    return *flag;
  }
  report_kind(reading, item, "true or false", {"true", "false"});
  return std::nullopt;
}

std::optional<std::int64_t> as_integer(Reading& reading, const Item& item) {
  if (const auto* integer = std::get_if<std::int64_t>(&item.value->content)) {
    return *integer;
  }
  const auto* number = std::get_if<double>(&item.value->content);
  constexpr double kExactIntegers = 9007199254740992;  // 2^53
  if (number != nullptr && std::abs(*number) <= kExactIntegers && *number == std::trunc(*number)) {
    return static_cast<std::int64_t>(*number);
  }
  report_kind(reading, item, "an integer");
  return std::nullopt;
}

std::optional<std::int64_t> as_count(Reading& reading, const Item& item, const CountRange& range) {
  const auto count = as_integer(reading, item);
  if (count && (*count < range.least || *count > range.most)) {
    report(reading, item, fmt::format("expected an integer from {} to {}", range.least, range.most));
    return std::nullopt;
  }
  return count;
}

std::optional<std::uint64_t> as_seed(Reading& reading, const Item& item) {
  const auto seed = as_integer(reading, item);
  if (seed && *seed < 0) {
    report(reading, item, "must be >= 0");
    return std::nullopt;
  }
  return seed ? std::optional(static_cast<std::uint64_t>(*seed)) : std::nullopt;
}

std::optional<Quantity> as_quantity(Reading& reading, const Item& item, const Expected& expected) {
  if (const auto varied = reading.varied.find(item.value); varied != reading.varied.end()) {
    varied->second = expected.dimension;
  }
  const auto quantity = quantity_of_any_sign(reading, item, expected.dimension);
  if (quantity && !has_sign(quantity->si, expected.sign)) {
    report_sign(reading, item, expected);
    return std::nullopt;
  }
  if (quantity && expected.dimension == dimension::kAngle && !is_sharp_angle(quantity->si)) {
    report(reading, item, "is more than 1e9 turns: its place within the turn is rounding");
    return std::nullopt;
  }
  if (quantity && reading.lists_quantities) {
    reading.quantities.push_back({path_of(reading, item), expected.dimension, quantity->profile});
  }
  if (quantity && expected.dimension != dimension::kNumber && std::abs(quantity->si) > kLargestQuantity) {
    report(reading, item,
           fmt::format("must be at most 1e50 {}: products of larger numbers are out of range",
                       unit_text(expected.dimension, kSiUnits)));
    return std::nullopt;
  }
  return quantity;
}

std::optional<std::vector<Quantity>> as_list(Reading& reading, const Item& item, const Expected& expected,
                                             std::size_t count) {
  const auto* items = std::get_if<Array>(&item.value->content);
  const auto what = [&] { return count == 0 ? "a list" : fmt::format("a list of {} numbers", count); };
  if (items == nullptr) {
    report_kind(reading, item, what());
    return std::nullopt;
  }
  if (count != 0 && items->size() != count) {
    report(reading, item,
           fmt::format("expected {}, found {}{}", what(), items->size(),
                       may_be_decimal_commas(*items, count) ? kPointNotComma : ""));
    return std::nullopt;
  }
  std::vector<Quantity> list;
  list.reserve(items->size());
  bool complete = true;
  for (const Value& one : *items) {
    const auto quantity = as_quantity(reading, {&one}, expected);
    complete = complete && quantity.has_value();
    list.push_back(quantity.value_or(Quantity{}));
  }
  return complete ? std::optional(std::move(list)) : std::nullopt;
}

std::optional<std::vector<Item>> as_items(Reading& reading, const Item& item, std::string_view expected,
                                          std::size_t fewest, std::size_t most) {
  const auto* values = std::get_if<Array>(&item.value->content);
  if (values == nullptr || values->size() < fewest || values->size() > most) {
    report(reading, item, fmt::format("expected {}", expected));
    return std::nullopt;
  }
  return items_of(item);
}

std::optional<Vector2d> as_vector(Reading& reading, const Item& item, const Dimension& dimension) {
  const auto list = as_list(reading, item, {dimension}, 2);
  if (!list) {
    return std::nullopt;
  }
  return Vector2d((*list)[0].si, (*list)[1].si);
}

std::optional<Vector2d> as_direction(Reading& reading, const Item& item) {
  if (const auto* text = std::get_if<std::string>(&item.value->content)) {
    if (text->find_first_of("0123456789") == std::string::npos) {
      report(reading, item,
             "is no direction: expected [dx, dy], such as [0, 1], or an angle, such as \"90 deg\"");
      return std::nullopt;
    }
  }
  if (!std::holds_alternative<Array>(item.value->content)) {
    const auto angle = as_quantity(reading, item, {dimension::kAngle});
    return angle ? std::optional(direction_of(angle->si)) : std::nullopt;
  }
  const auto vector = as_vector(reading, item, dimension::kNumber);
  if (!vector) {
    return std::nullopt;
  }
  if (vector->isZero(0)) {
    report(reading, item, "must not be the zero vector");
    return std::nullopt;
  }
  const Vector2d scaled = *vector / vector->cwiseAbs().maxCoeff();  // prevents overflow of the squares
  return Vector2d(scaled.normalized());
}

std::optional<std::size_t> as_choice(Reading& reading, const Item& item,
                                     const std::vector<std::string>& choices) {
  const auto text = as_text(reading, item);
  if (!text) {
    return std::nullopt;
  }
  const auto choice = std::find(choices.begin(), choices.end(), *text);
  if (choice == choices.end()) {
    const std::string likely = did_you_mean(*text, choices);
    report(reading, item,
           fmt::format("expected one of {}{}{}", joined_words(choices), likely.empty() ? "" : "; ", likely));
    return std::nullopt;
  }
  return static_cast<std::size_t>(choice - choices.begin());
}

}  // namespace higherpair::io_detail

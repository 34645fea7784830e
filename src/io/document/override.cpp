#include "document.hpp"
#include "encoding.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/names.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <utility>

#include <fmt/ranges.h>

namespace higherpair::io_detail {
namespace {

using Step = tl::expected<Value*, std::string>;

std::vector<std::string> split_path(std::string_view path) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t dot = path.find('.');
    parts.emplace_back(trimmed(path.substr(0, dot)));
    if (dot == std::string_view::npos) {
      return parts;
    }
    path.remove_prefix(dot + 1);
  }
}

std::optional<std::size_t> item_number(std::string_view part) {
  std::size_t number = 0;
  const auto [end, status] = std::from_chars(part.data(), part.data() + part.size(), number);
  const bool is_number = status == std::errc() && end == part.data() + part.size();
  return is_number ? std::optional(number) : std::nullopt;
}

// An item of a list. The index just past the end appends a new item; the whole list is then marked as set by
// the option.
Step item_of(Value& list, const std::string& part, const Mark& mark) {
  auto& items = std::get<Array>(list.content);
  const auto number = item_number(part);
  if (!number || *number > items.size()) {
    return tl::unexpected(
        fmt::format("`{}` is no item of a list of {} (the first one is 0)", part, items.size()));
  }
  if (*number == items.size()) {
    items.push_back({Table{}, mark});
    list.mark = mark;
  }
  return &items[*number];
}

Step entry_of(Table& table, const std::string& part, const Mark& mark) {
  if (item_number(part)) {
    return tl::unexpected(fmt::format("there is no list that `{}` could be an item of", part));
  }
  if (!is_name(part)) {
    return tl::unexpected(fmt::format("`{}` is no name (letters, digits, _ and -)", part));
  }
  const auto entry =
      std::find_if(table.begin(), table.end(), [&](const Entry& candidate) { return candidate.key == part; });
  if (entry != table.end()) {
    return &entry->value;
  }
  table.push_back({part, mark, {Table{}, mark}});
  return &table.back().value;
}

// The value at the next part of the path; a new empty table if there is none.
Step descend(Value& value, const std::string& part, const Mark& mark) {
  if (std::holds_alternative<Array>(value.content)) {
    return item_of(value, part, mark);
  }
  if (auto* table = std::get_if<Table>(&value.content)) {
    return entry_of(*table, part, mark);
  }
  return tl::unexpected(
      fmt::format("there is no `{}` in {}, which is {}", part, text_of(value), kind_of(value)));
}

// What to say of the path if the document cannot be read with it (see Overridden::doubt). The last
// part is a key, whose names are known to the reader.
std::string doubt_about(const Value& document, std::span<const std::string> parts) {
  const Value* value = &document;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const Value* const next = find_part(*value, parts[i]);
    if (next != nullptr) {
      value = next;
      continue;
    }
    const auto* table = std::get_if<Table>(&value->content);
    std::vector<std::string> names;
    for (const Entry& entry : table == nullptr ? Table() : *table) {
      names.push_back(entry.key);
    }
    const std::string likely = i == 0 ? "" : did_you_mean(parts[i], names);
    return likely.empty()
               ? ""
               : fmt::format("there is no `{}` in {}; {}", parts[i], fmt::join(parts.first(i), "."), likely);
  }
  return "";
}

}  // namespace

const Value* find_part(const Value& value, std::string_view part) {
  if (const auto* table = std::get_if<Table>(&value.content)) {
    return find(*table, part);
  }
  const auto* items = std::get_if<Array>(&value.content);
  const auto number = item_number(part);
  return items != nullptr && number && *number < items->size() ? &(*items)[*number] : nullptr;
}

Value* find_path(Value& document, std::string_view path) {
  Value* value = &document;
  for (const std::string& part : split_path(path)) {
    value = const_cast<Value*>(find_part(*value, part));  // `document` is not const
    if (value == nullptr) break;
  }
  return value;
}

tl::expected<Overridden, std::string> apply_override(Value document, std::string_view assignment,
                                                     int number) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    return tl::unexpected(std::string("expected PATH=VALUE, such as driver.samples=721"));
  }
  if (encoding_mistake(assignment)) {
    return tl::unexpected(std::string("is not UTF-8, as all texts of a profile are"));
  }
  Value* target = &document;
  const std::vector<std::string> parts = split_path(assignment.substr(0, equals));
  const std::string doubt = doubt_about(document, parts);
  for (const std::string& part : parts) {
    const Step next = descend(*target, part, {number, 0, 0});
    if (!next) {
      return tl::unexpected(doubt.empty() ? next.error() : doubt);
    }
    target = *next;
  }
  *target = parse_override_value(trimmed(assignment.substr(equals + 1)), number);
  return Overridden{std::move(document), doubt};
}

}  // namespace higherpair::io_detail

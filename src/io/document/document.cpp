#include "document.hpp"

#include "encoding.hpp"
#include "higherpair/io/names.hpp"
#include "numeric/utf8.hpp"
#include "syntax_help.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/core.h>

// Disables the parser's assertions: one of them fails on a mistake that the parser goes on to report as an
// error, `[` at the end of a line.
#define TOML_ASSERT(expression) static_cast<void>(0)
#include <toml++/toml.h>

namespace higherpair::io_detail {
namespace {

constexpr std::size_t kLongestText = 40;  // of a value in a message
constexpr int kDeepestKey = 500;          // dots in one key: the parser recurses through them

Mark mark_of(const toml::source_region& region, int source) {
  if (source > 0) {
    return {source, 0, 0};
  }
  return {0, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Value convert(const toml::node& node, int source);

Array convert_items(const toml::array& items, int source) {
  Array array;
  array.reserve(items.size());
  for (const toml::node& item : items) {
    array.push_back(convert(item, source));
  }
  return array;
}

// The parser sorts its tables by key; restore the order of the file.
Table convert_entries(const toml::table& entries, int source) {
  Table table;
  table.reserve(entries.size());
  std::vector<std::pair<Mark, std::size_t>> order;
  for (const auto& [key, node] : entries) {
    order.emplace_back(mark_of(key.source(), 0), table.size());
    table.push_back({std::string(key.str()), mark_of(key.source(), source), convert(node, source)});
  }
  std::sort(order.begin(), order.end());
  Table sorted;
  sorted.reserve(table.size());
  for (const auto& [mark, index] : order) {
    sorted.push_back(std::move(table[index]));
  }
  return sorted;
}

Value convert(const toml::node& node, int source) {
  const Mark mark = mark_of(node.source(), source);
  switch (node.type()) {
    case toml::node_type::string:
      return {node.as_string()->get(), mark};
    case toml::node_type::integer:
      return {node.as_integer()->get(), mark};
    case toml::node_type::floating_point:
      return {node.as_floating_point()->get(), mark};
    case toml::node_type::boolean:
      return {node.as_boolean()->get(), mark};
    case toml::node_type::array:
      return {convert_items(*node.as_array(), source), mark};
    case toml::node_type::table:
      return {convert_entries(*node.as_table(), source), mark};
    default:
      return {DateTime{}, mark};
  }
}

// The position of a key with so many dotted parts that the recursive parser would run out of stack.
std::optional<Mark> find_too_deep_key(std::string_view text) {
  int line = 1;
  int column = 0;
  int dots = 0;
  for (const char c : text) {
    ++column;
    if (c == '.') {
      if (++dots > kDeepestKey) return Mark{0, line, column};
    } else if (std::string_view("=,{}[]#\n").find(c) != std::string_view::npos) {
      dots = 0;
    }
    if (c == '\n') {
      ++line;
      column = 0;
    }
  }
  return std::nullopt;
}

// Turns the exception of the TOML library into a result; it is caught nowhere else.
tl::expected<toml::table, toml::parse_error> parse_toml(std::string_view text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    return tl::unexpected(error);
  }
}

// Cuts a text, but never within a UTF-8 character.
std::string_view shortened(std::string_view text) {
  std::size_t length = std::min(text.size(), kLongestText);
  while (length > 0 && length < text.size() && !begins_character(text[length])) --length;
  return text.substr(0, length);
}

std::string in_quotes(std::string_view text) {
  const std::string_view head = shortened(text);
  return fmt::format("\"{}{}\"", visible(head), head.size() < text.size() ? "…" : "");
}

const Entry* find_entry(const Table& table, std::string_view key) {
  const auto entry =
      std::find_if(table.begin(), table.end(), [&](const Entry& candidate) { return candidate.key == key; });
  return entry == table.end() ? nullptr : &*entry;
}

std::string items_text(const Array& items) {
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (text.size() > kLongestText) {
      return text + ", …]";
    }
    text += (i == 0 ? "" : ", ") + text_of(items[i]);
  }
  return text + "]";
}

}  // namespace

const Value* find(const Table& table, std::string_view key) {
  const Entry* entry = find_entry(table, key);
  return entry == nullptr ? nullptr : &entry->value;
}

PathEnd end_of_path(const Table& document, std::string_view path) {
  PathEnd end;
  const Table* table = &document;
  do {
    const std::string_view part = path.substr(0, path.find('.'));
    path.remove_prefix(std::min(part.size() + 1, path.size()));
    if (table == nullptr) {
      end.value = find_part(*end.value, part);
    } else {
      const Entry* entry = find_entry(*table, part);
      end = entry == nullptr ? PathEnd{nullptr, end.entry} : PathEnd{&entry->value, entry};
    }
    table = end.value == nullptr ? nullptr : std::get_if<Table>(&end.value->content);
  } while (end.value != nullptr && !path.empty());
  return end;
}

std::optional<double> number_in(const Value& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value.content)) return static_cast<double>(*integer);
  const auto* number = std::get_if<double>(&value.content);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

namespace {

using FoundNumber = std::function<void(const std::string& path, double number)>;

void visit_numbers(const Value& value, const std::string& path, const FoundNumber& found) {
  if (const auto* table = std::get_if<Table>(&value.content)) {
    for (const Entry& entry : *table) {
      visit_numbers(entry.value, fmt::format("{}.{}", path, entry.key), found);
    }
  } else if (const auto* items = std::get_if<Array>(&value.content)) {
    for (std::size_t i = 0; i < items->size(); ++i) {
      visit_numbers((*items)[i], fmt::format("{}.{}", path, i), found);
    }
  } else if (const auto number = number_in(value)) {
    found(path, *number);
  }
}

}  // namespace

void for_each_number(const Table& document, const FoundNumber& found) {
  for (const Entry& entry : document) {
    visit_numbers(entry.value, entry.key, found);
  }
}

std::string_view kind_of(const Value& value) {
  constexpr std::string_view kKinds[] = {"a string", "an integer", "a number", "a boolean",
                                         "a date",   "a list",     "a table"};
  return kKinds[value.content.index()];
}

std::string text_of(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.content)) return in_quotes(*text);
  if (const auto* integer = std::get_if<std::int64_t>(&value.content)) return fmt::format("{}", *integer);
  if (const auto* number = std::get_if<double>(&value.content)) return fmt::format("{}", *number);
  if (const auto* flag = std::get_if<bool>(&value.content)) return *flag ? "true" : "false";
  if (const auto* items = std::get_if<Array>(&value.content)) return items_text(*items);
  return std::holds_alternative<Table>(value.content) ? "{…}" : "(a date)";
}

tl::expected<Value, Diagnostic> parse_document(std::string_view text, const std::string& source_name) {
  const auto mistake = [&](const Mistake& found) {
    return tl::unexpected(Diagnostic{{source_name, found.mark.line, found.mark.column}, found.message});
  };
  text = without_bom(text);
  if (const auto found = encoding_mistake(text)) {
    return mistake(*found);
  }
  if (const auto mark = find_too_deep_key(text)) {
    return mistake({*mark, "this key has too many dotted parts to be one of a profile"});
  }
  const auto table = parse_toml(text);
  if (!table) {
    const toml::source_position place = table.error().source().begin;
    return mistake(explain_syntax(text, {0, static_cast<int>(place.line), static_cast<int>(place.column)},
                                  table.error().description()));
  }
  return convert(*table, 0);
}

Value parse_override_value(std::string_view text, int number) {
  Value as_string = {std::string(text), {number, 0, 0}};
  const std::string line = "value = " + std::string(text);
  if (find_too_deep_key(line)) {
    return as_string;
  }
  const auto table = parse_toml(line);
  if (!table || table->size() != 1) {
    return as_string;
  }
  return convert(*table->get("value"), number);
}

}  // namespace higherpair::io_detail

#include "toml_text.hpp"

#include "higherpair/io/names.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

std::string string_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    } else {
      result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    }
  }
  return result + '"';
}

std::string key_text(const std::string& key) {
  return is_name(key) ? key : string_text(key);
}

std::string entry_text(const Entry& entry) {
  return fmt::format("{} = {}", key_text(entry.key), toml_text(entry.value));
}

template <class Items, class Text>
std::string joined_texts(const Items& items, const Text& text) {
  std::string all;
  for (const auto& item : items) all += (all.empty() ? "" : ", ") + text(item);
  return all;
}

}  // namespace

std::string toml_text(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.content)) return string_text(*text);
  if (const auto* items = std::get_if<Array>(&value.content)) {
    return fmt::format("[{}]", joined_texts(*items, toml_text));
  }
  if (const auto* table = std::get_if<Table>(&value.content)) {
    return table->empty() ? "{}" : fmt::format("{{ {} }}", joined_texts(*table, entry_text));
  }
  return text_of(value);
}

std::string toml_section(const std::string& name, const Table& table) {
  std::string text;
  std::string tables;
  for (const Entry& entry : table) {
    const auto* inner = std::get_if<Table>(&entry.value.content);
    if (inner == nullptr) {
      text += entry_text(entry) + "\n";
      continue;
    }
    tables += fmt::format("{}[{}.{}]\n", tables.empty() ? "" : "\n", key_text(name), key_text(entry.key));
    for (const Entry& one : *inner) tables += entry_text(one) + "\n";
  }
  if (text.empty() && !tables.empty()) {
    return tables;
  }
  return fmt::format("[{}]\n{}{}{}", key_text(name), text, tables.empty() ? "" : "\n", tables);
}

bool same_content(const Value& a, const Value& b) {
  const auto number = number_in(a);
  if (number || number_in(b)) {
    return number == number_in(b);
  }
  if (a.content.index() != b.content.index()) {
    return false;
  }
  if (std::holds_alternative<DateTime>(a.content)) {
    return true;
  }
  if (const auto* items = std::get_if<Array>(&a.content)) {
    const auto& others = std::get<Array>(b.content);
    return std::equal(items->begin(), items->end(), others.begin(), others.end(), same_content);
  }
  if (const auto* table = std::get_if<Table>(&a.content)) {
    const auto& others = std::get<Table>(b.content);
    return table->size() == others.size() &&
           std::all_of(table->begin(), table->end(), [&](const Entry& entry) {
             const Value* other = find(others, entry.key);
             return other != nullptr && same_content(entry.value, *other);
           });
  }
  const auto* text = std::get_if<std::string>(&a.content);
  return text != nullptr ? *text == std::get<std::string>(b.content)
                         : std::get<bool>(a.content) == std::get<bool>(b.content);
}

}  // namespace higherpair::io_detail

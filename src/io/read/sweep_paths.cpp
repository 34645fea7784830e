#include "higherpair/io/diagnostic.hpp"
#include "higherpair/numeric/contains.hpp"
#include "reading.hpp"
#include "sweep_reading.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

std::vector<std::string> keys_of(const Table& table) {
  std::vector<std::string> keys;
  for (const Entry& entry : table) keys.push_back(entry.key);
  return keys;
}

// The keys of a table, or the indices of a list's items.
std::vector<std::string> parts_of(const Value& value) {
  std::vector<std::string> parts;
  if (const auto* table = std::get_if<Table>(&value.content)) {
    parts = keys_of(*table);
  } else if (const auto* items = std::get_if<Array>(&value.content)) {
    for (std::size_t i = 0; i < items->size(); ++i) parts.push_back(fmt::format("{}", i));
  }
  return parts;
}

// The path of the first number in a table or list; empty if there is none.
std::string number_below(const Table& document, std::string_view path) {
  std::string first;
  for_each_number(document, [&](const std::string& other, double /*number*/) {
    if (first.empty() && other.starts_with(fmt::format("{}.", path))) first = other;
  });
  return first;
}

struct NumberAtPath {
  std::string objection;   // why it does not lead to a number of the profile; empty if it does
  std::string text;        // the number, where it is written with a unit of its own
  std::string lacks = {};  // the path of what is not there, or is no number
};

NumberAtPath number_at(const Table& document, std::string_view path) {
  const Value* value = nullptr;
  std::string done;
  for (std::string_view rest = path; !rest.empty();) {
    const std::string part(rest.substr(0, rest.find('.')));
    const Value* next = value == nullptr ? find(document, part) : find_part(*value, part);
    if (next == nullptr) {
      return {fmt::format("there is no `{}` in {}; {}", part, done.empty() ? "the profile" : done,
                          suggestion(part, value == nullptr ? keys_of(document) : parts_of(*value))),
              "", done.empty() ? part : fmt::format("{}.{}", done, part)};
    }
    value = next;
    done += done.empty() ? part : "." + part;
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
  }
  if (value == nullptr) {
    return {"expected the path of a number", ""};
  }
  const auto& content = value->content;
  if (const auto* text = std::get_if<std::string>(&content)) {
    return {"", *text};
  }
  if (std::holds_alternative<double>(content) || std::holds_alternative<std::int64_t>(content)) {
    return {};
  }
  const std::string example = number_below(document, path);
  return {fmt::format("this is {}; expected the path of a number{}{}", kind_of(*value),
                      example.empty() ? "" : ", such as ", example),
          "", std::string(path)};
}

std::optional<std::string> read_path(Reading& reading, const Item& item, SweepPaths& paths) {
  auto path = as_text(reading, item);
  if (!path) {
    return std::nullopt;
  }
  const bool own = *path == paths.task || path->starts_with(paths.task + ".");
  auto [objection, text, lacks] = own ? NumberAtPath{} : number_at(paths.document, *path);
  if (own) {
    objection = paths.task == "sweep" ? "a sweep cannot vary itself" : "tolerances have none themselves";
  } else if (objection.empty() && contains(paths.taken, *path)) {
    objection = "another variable sets this already";
  }
  paths.taken.push_back(*path);
  if (!objection.empty()) {
    report(reading, item, objection, lacks);
  } else if (!text.empty()) {
    paths.with_unit.push_back(
        {item.value->mark,
         fmt::format("{}: the profile gives {} as \"{}\", and plain values of a sweep are in the "
                     "profile's `units`: if that is not meant, give them a unit of their own, too",
                     path_of(reading, item), *path, text)});
  }
  return path;
}

}  // namespace

void note_varied(const Table& document, Reading& reading) {
  const auto table_at = [](const Table* table, std::string_view key) {
    const Value* value = table == nullptr ? nullptr : find(*table, key);
    return value == nullptr ? nullptr : std::get_if<Table>(&value->content);
  };
  const auto note = [&](const Value& value) {
    const auto* path = std::get_if<std::string>(&value.content);
    const Value* varied = path == nullptr ? nullptr : end_of_path(document, *path).value;
    if (varied != nullptr) reading.varied.emplace(varied, std::nullopt);
  };
  for (const Table* variables :
       {table_at(table_at(&document, "sweep"), "variables"),
        table_at(table_at(&document, "design"), "variables"), table_at(&document, "tolerances")}) {
    for (std::size_t i = 0; variables != nullptr && i < variables->size(); ++i) {
      const auto* variable = std::get_if<Table>(&(*variables)[i].value.content);
      const Value* path = variable == nullptr ? nullptr : find(*variable, "path");
      if (path == nullptr) continue;
      note(*path);
      const auto* items = std::get_if<Array>(&path->content);
      for (std::size_t k = 0; items != nullptr && k < items->size(); ++k) {
        note((*items)[k]);
        const auto* entry = std::get_if<Table>(&(*items)[k].content);
        if (const Value* own = entry == nullptr ? nullptr : find(*entry, "path")) note(*own);
      }
    }
  }
}

void read_paths(TableReader& table, SweepPaths& paths, SweepVariable& variable) {
  const auto item = table.need("path", "the path of a number of the profile, or a list of several");
  if (!item) {
    return;
  }
  const bool several = std::holds_alternative<Array>(item->value->content);
  const std::vector<Item> items = several ? items_of(*item) : std::vector{*item};
  if (items.empty()) {
    report(table.reading(), *item, "expected at least one path");
  }
  for (const Item& one : items) {
    variable.paths.push_back(read_path(table.reading(), one, paths).value_or(""));
  }
}

}  // namespace higherpair::io_detail

#include "table_reader.hpp"

#include "higherpair/io/suggestion.hpp"
#include "names.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace higherpair::io_detail {
namespace {

constexpr std::array<std::string_view, 14> kTopLevelKeys = {
    "format",   "title",  "description", "gravity", "units", "bodies",  "joints",
    "contacts", "driver", "drivers",     "laws",    "loads", "springs", "limits"};

constexpr std::int64_t kMostCounted = 1'000'000'000;
constexpr std::string_view kMoveUp = "it belongs to the top level: move it above the first [table]";

bool is_top_level(std::string_view key) {
  return std::find(kTopLevelKeys.begin(), kTopLevelKeys.end(), key) != kTopLevelKeys.end();
}

}  // namespace

std::optional<Item> TableReader::take(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) {
    known_.push_back(key);
  }
  const Value* value = find(*table_, key);
  return value == nullptr ? std::nullopt : std::optional(Item{value, path_of(key)});
}

std::optional<Item> TableReader::need(const std::string& key, std::string_view what) {
  auto item = take(key);
  if (!item) {
    reading_->mistakes.push_back({mark_, fmt::format("{} is missing: expected {}", path_of(key), what)});
  }
  return item;
}

void TableReader::refuse(const std::string& key, std::string_view reason) {
  if (const Value* value = find(*table_, key)) {
    report(*reading_, {value, path_of(key)}, reason);
    refused_.push_back(key);
  }
}

double TableReader::quantity(const std::string& key, const Expected& expected, double otherwise) {
  const auto item = take(key);
  const auto quantity = item ? as_quantity(*reading_, *item, expected) : std::nullopt;
  return quantity ? quantity->si : otherwise;
}

double TableReader::need_quantity(const std::string& key, const Expected& expected) {
  const auto item = need(key, what_number(expected.dimension, reading_->units));
  const auto quantity = item ? as_quantity(*reading_, *item, expected) : std::nullopt;
  return quantity ? quantity->si : 0;
}

Vector2d TableReader::need_vector(const std::string& key, const Dimension& dimension) {
  const auto item = need(key, "[x, y]");
  const auto vector = item ? as_vector(*reading_, *item, dimension) : std::nullopt;
  return vector.value_or(Vector2d::Zero());
}

std::string TableReader::text(const std::string& key) {
  const auto item = take(key);
  return item ? as_text(*reading_, *item).value_or("") : "";
}

bool TableReader::flag(const std::string& key, bool otherwise) {
  const auto item = take(key);
  return item ? as_flag(*reading_, *item).value_or(otherwise) : otherwise;
}

std::optional<std::int64_t> TableReader::count(const std::string& key, std::int64_t least) {
  const auto item = take(key);
  const auto value = item ? as_integer(*reading_, *item) : std::nullopt;
  if (value && (*value < least || *value > kMostCounted)) {
    report(*reading_, *item, fmt::format("expected a number from {} to {}", least, kMostCounted));
    return std::nullopt;
  }
  return value;
}

void TableReader::finish() const {
  const auto has = [](const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  for (const Entry& entry : *table_) {
    if (!has(known_, entry.key) && !has(refused_, entry.key)) {
      report_unknown(entry);
    }
  }
}

void TableReader::report_unknown(const Entry& entry) const {
  const bool repeated = path_ == entry.key || path_.ends_with("." + entry.key);
  const bool move_up = !path_.empty() && is_top_level(entry.key);
  const std::string remedy =
      repeated  ? fmt::format("under the heading [{}] its keys have no `{}.` before them", path_, entry.key)
      : move_up ? std::string(kMoveUp)
                : suggestion(entry.key, known_);
  reading_->mistakes.push_back(
      {entry.key_mark, fmt::format("{}: unknown key; {}", path_of(entry.key), remedy)});
}

std::string TableReader::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

void for_each_named(Reading& reading, const Item& item, std::string_view what,
                    const std::function<void(const std::string& name, const Item& item)>& read) {
  const Table* table = as_table(reading, item, fmt::format("a table of names, each with {}", what));
  if (table == nullptr) {
    return;
  }
  for (const Entry& entry : *table) {
    const std::string path = fmt::format("{}.{}", item.path, entry.key);
    if (is_name(entry.key)) {
      read(entry.key, {&entry.value, path});
    } else {
      reading.mistakes.push_back(
          {entry.key_mark,
           fmt::format("{}: a name begins with a letter or _ and goes on with letters, digits, _ and -",
                       path)});
    }
  }
}

void for_each_table(Reading& reading, const Item& item, std::string_view what,
                    const std::function<void(const std::string& name, TableReader& table)>& read) {
  for_each_named(reading, item, what, [&](const std::string& name, const Item& entry) {
    if (const auto* table = std::get_if<Table>(&entry.value->content)) {
      TableReader reader(reading, *table, entry.value->mark, entry.path);
      read(name, reader);
    } else if (is_top_level(name)) {
      report(reading, entry, kMoveUp);
    } else {
      report_kind(reading, entry, what);
    }
  });
}

void for_each_in_list(TableReader& table, const std::string& key,
                      const std::function<void(TableReader& entry)>& read) {
  Reading& reading = table.reading();
  const auto item = table.take(key);
  if (!item) {
    return;
  }
  const auto* items = std::get_if<Array>(&item->value->content);
  if (items == nullptr || items->empty()) {
    report(reading, *item, fmt::format("expected a list of tables, [[{}]]", item->path));
    return;
  }
  for (std::size_t i = 0; i < items->size(); ++i) {
    const Item one = {&(*items)[i], fmt::format("{}.{}", item->path, i)};
    if (const Table* content = as_table(reading, one, "a table")) {
      TableReader entry(reading, *content, one.value->mark, one.path);
      read(entry);
      entry.finish();
    }
  }
}

}  // namespace higherpair::io_detail

#include "table_reader.hpp"

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/names.hpp"
#include "higherpair/numeric/contains.hpp"
#include "numeric/joined_words.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// Those that hold tables.
constexpr std::array<std::string_view, 16> kTopLevelTables = {
    "units",   "bodies",  "joints", "contacts", "driver", "drivers",    "laws", "loads",
    "springs", "drawing", "limits", "sweep",    "design", "tolerances", "fit",  "extra"};

constexpr std::array<std::string_view, 8> kDriverKeys = {"start",    "end",          "samples",  "positions",
                                                         "velocity", "acceleration", "duration", "time_step"};

// Reported as misplaced even if a similar key exists in the table.
constexpr std::array<std::string_view, 4> kOnlyTopLevel = {"format", "title", "description", "gravity"};

constexpr std::string_view kMoveUp = "it belongs to the top level: move it above the first [table]";

std::vector<std::string> each_once(const std::vector<std::string>& names) {
  std::vector<std::string> once;
  for (const std::string& name : names) {
    if (!contains(once, name)) once.push_back(name);
  }
  return once;
}

[[maybe_unused]] bool is_top_level(std::string_view key) {
  return contains(kOnlyTopLevel, key) || contains(kTopLevelTables, key);
}

}  // namespace

std::optional<Item> TableReader::take(const std::string& key) {
  known_.push_back(key);
  const Value* value = find(*table_, key);
  return value == nullptr ? std::nullopt : std::optional(Item{value});
}

std::optional<Item> TableReader::take_kind(const std::string& key) {
  return has(key) ? take(key) : std::nullopt;
}

std::optional<Item> TableReader::need(const std::string& key, std::string_view what) {
  auto item = take(key);
  if (!item) {
    report_missing(key, what);
  }
  return item;
}

void TableReader::report_missing(std::string_view key, std::string_view what) const {
  const std::string path = path_to(key);
  std::vector<std::string> lacks = {path};
  for (const std::string& other : instead_) lacks.push_back(path_to(other));
  reading_->mistakes.push_back(
      {mark(), fmt::format("{} is missing: expected {}", path, what), "", std::move(lacks)});
}

std::optional<std::size_t> TableReader::need_type(std::string_view what,
                                                  const std::vector<std::string>& names) {
  if (const auto item = take("type")) return as_choice(*reading_, *item, names);
  const auto meant = std::find_if(table_->begin(), table_->end(), [](const Entry& entry) {
    return !did_you_mean(entry.key, {"type"}).empty();
  });
  if (meant == table_->end()) {
    (void)need("type", what);
  } else {
    report_unknown(*meant);
  }
  return std::nullopt;
}

void TableReader::refuse(const std::string& key, std::string_view reason, std::string_view lacks) {
  if (const Value* value = find(*table_, key)) {
    report(*reading_, {value}, reason, lacks.empty() ? "" : path_to(lacks));
  }
  refused_.push_back(key);
}

double TableReader::quantity(const std::string& key, const Expected& expected, double otherwise) {
  const auto quantity = take(key, as_quantity, expected);
  return quantity ? quantity->si : otherwise;
}

double TableReader::need_quantity(const std::string& key, const Expected& expected) {
  const auto item = take(key);
  if (!item) {
    report_missing(key, what_number(expected.dimension, reading_->units));
    return 0;
  }
  const auto quantity = as_quantity(*reading_, *item, expected);
  return quantity ? quantity->si : 0;
}

Vector2d TableReader::need_vector(const std::string& key, const Dimension& dimension) {
  return need(key, "[x, y]", as_vector, dimension).value_or(Vector2d::Zero());
}

std::string TableReader::text(const std::string& key) {
  return take(key, as_text).value_or("");
}

bool TableReader::flag(const std::string& key, bool otherwise) {
  return take(key, as_flag).value_or(otherwise);
}

bool TableReader::has(std::string_view key) const {
  return find(*table_, key) != nullptr;
}

void TableReader::finish() const {
  assert(!path().empty() || std::all_of(known_.begin(), known_.end(), is_top_level));
  for (const Entry& entry : *table_) {
    if (!contains(known_, entry.key) && !contains(refused_, entry.key)) {
      report_unknown(entry);
    }
  }
}

void TableReader::report_unknown(const Entry& entry) const {
  const std::string path = this->path();
  const bool repeated = path == entry.key || path.ends_with("." + entry.key);
  const std::vector<std::string> known = each_once(known_);
  const bool is_table = std::holds_alternative<Table>(entry.value.content);
  std::vector<std::string> meant = meant_names(entry.key, known);
  if (meant.empty()) meant = meant_names(entry.key, refused_);
  const std::string own = did_you_mean(meant);
  const bool move_up = !path.empty() && (contains(kOnlyTopLevel, entry.key) ||
                                         (is_table && contains(kTopLevelTables, entry.key)));
  const bool is_dotted = entry.key.find('.') != std::string::npos;
  const bool is_of_driver = path.empty() && own.empty() && contains(kDriverKeys, entry.key);
  const std::string remedy =
      is_dotted      ? fmt::format("{} is written without quotes: {}", is_table ? "a heading" : "a key",
                              is_table ? "[" + entry.key + "]" : entry.key)
      : is_of_driver ? fmt::format("did you mean `driver.{}`?", entry.key)
      : repeated ? fmt::format("under the heading [{}] its keys have no `{}.` before them", path, entry.key)
      : move_up  ? std::string(kMoveUp)
      : own.empty() ? fmt::format("there {} {}", known.size() == 1 ? "is only" : "are", joined_words(known))
                    : own;
  for (std::string& name : meant) name = path_to(name);
  reading_->mistakes.push_back({entry.key_mark,
                                fmt::format("{}: unknown key; {}", path_to(entry.key), remedy),
                                "",
                                {},
                                std::move(meant),
                                &entry.value});
}

std::string TableReader::path_to(std::string_view key) const {
  const std::string own = path();
  return own.empty() ? std::string(key) : fmt::format("{}.{}", own, key);
}

void report_whole(TableReader& table, std::string_view message, std::vector<std::string> lacks) {
  table.reading().mistakes.push_back(
      {table.mark(), fmt::format("{}: {}", table.path(), message), "", std::move(lacks)});
}

void note_whole(TableReader& table, std::string_view message) {
  table.reading().notes.push_back({table.mark(), fmt::format("{}: {}", table.path(), message)});
}

std::optional<TableReader> as_reader(Reading& reading, const std::optional<Item>& item,
                                     std::string_view what) {
  const Table* table = item ? as_table(reading, *item, what) : nullptr;
  return table == nullptr ? std::nullopt : std::optional(TableReader(reading, *item->value));
}

void for_each_named(Reading& reading, const std::optional<Item>& item, std::string_view what,
                    const std::function<void(const std::string& name, const Item& item)>& read) {
  if (!item) {
    return;
  }
  const Table* table = std::get_if<Table>(&item->value->content);
  if (table == nullptr) {
    (void)as_table(reading, *item, fmt::format("a table of names, each with {}", what));
    return;
  }
  for (const Entry& entry : *table) {
    if (is_name(entry.key)) {
      read(entry.key, {&entry.value});
    } else {
      reading.mistakes.push_back(
          {entry.key_mark, fmt::format("{}: {}", path_of(reading, {&entry.value}), kNameRule)});
    }
  }
}

void read_named_table(Reading& reading, const std::string& name, const Item& item, std::string_view what,
                      const std::function<void(const std::string& name, TableReader& table)>& read) {
  if (std::holds_alternative<Table>(item.value->content)) {
    TableReader reader(reading, *item.value);
    read(name, reader);
  } else if (contains(kOnlyTopLevel, name)) {
    report(reading, item, kMoveUp);
  } else {
    report_kind(reading, item, what);
  }
}

void for_each_table(Reading& reading, const std::optional<Item>& item, std::string_view what,
                    const std::function<void(const std::string& name, TableReader& table)>& read) {
  for_each_named(reading, item, what, [&](const std::string& name, const Item& entry) {
    const bool is_table = std::holds_alternative<Table>(entry.value->content);
    read_named_table(
        reading, name, entry,
        is_table ? std::string(what)
                 : fmt::format("{} with a heading of its own, [{}.NAME]", what, path_of(reading, *item)),
        read);
  });
}

void for_each_in_list(TableReader& table, const std::string& key,
                      const std::function<void(TableReader& entry)>& read) {
  Reading& reading = table.reading();
  const auto item = table.take(key);
  const std::vector<Item> items = item ? items_of(*item) : std::vector<Item>{};
  if (item && items.empty()) {
    report(reading, *item, fmt::format("expected a list of tables, [[{}]]", path_of(reading, *item)));
  }
  for (const Item& one : items) {
    if (auto entry = as_reader(reading, one, "a table")) {
      read(*entry);
      entry->finish();
    }
  }
}

}  // namespace higherpair::io_detail

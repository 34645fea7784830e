#pragma once

#include "higherpair/io/diagnostic.hpp"
#include "typed_values.hpp"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/core.h>

namespace higherpair::io_detail {

/// Reads one table of a profile key by key. The keys that were asked for are known, all others are not.
class TableReader {
public:
  /// \param table  a value of the document that is a table
  TableReader(Reading& reading, const Value& table)
      : reading_(&reading), value_(&table), table_(&std::get<Table>(table.content)) {
    known_.reserve(table_->size() + 8);
  }

  [[nodiscard]] Reading& reading() const { return *reading_; }
  [[nodiscard]] const Mark& mark() const { return value_->mark; }
  [[nodiscard]] std::string path() const { return path_of(*reading_, {value_}); }
  [[nodiscard]] const Table& entries() const { return *table_; }

  /// The item at `key`, or nothing if the table has no such key.
  [[nodiscard]] std::optional<Item> take(const std::string& key);

  /// The same for a key that decides what the table is about: it is known only if it is there.
  [[nodiscard]] std::optional<Item> take_kind(const std::string& key);

  /// The item at `key`; if the key is missing, reports that and `what` it should be.
  [[nodiscard]] std::optional<Item> need(const std::string& key, std::string_view what);

  /// The item at `key`, converted by `as` (as_quantity, as_choice, …); nothing if it is absent or wrong.
  template <class T, class... More>
  [[nodiscard]] std::optional<T> take(const std::string& key,
                                      std::optional<T> (*as)(Reading&, const Item&, More...),
                                      const std::type_identity_t<More>&... more) {
    const auto item = take(key);
    return item ? as(*reading_, *item, more...) : std::nullopt;
  }

  /// The same for a key that must be present.
  template <class T, class... More>
  [[nodiscard]] std::optional<T> need(const std::string& key, std::string_view what,
                                      std::optional<T> (*as)(Reading&, const Item&, More...),
                                      const std::type_identity_t<More>&... more) {
    const auto item = need(key, what);
    return item ? as(*reading_, *item, more...) : std::nullopt;
  }

  /// The index in `names` of the value of the key `type`. The other keys of a table depend on it: if it is
  /// absent but another key looks like a misspelt `type`, that key is reported instead.
  [[nodiscard]] std::optional<std::size_t> need_type(std::string_view what,
                                                     const std::vector<std::string>& names);

  [[nodiscard]] bool has(std::string_view key) const;

  /// Reports that the key is present, and why it must not be.
  /// \param lacks  the key beside which it may be, if any
  void refuse(const std::string& key, std::string_view reason, std::string_view lacks = "");

  /// \name A value, or the default if it is absent (or wrong, which is reported); lengths etc. in SI units.
  /// @{
  [[nodiscard]] double quantity(const std::string& key, const Expected& expected, double otherwise = 0);
  [[nodiscard]] double need_quantity(const std::string& key, const Expected& expected);
  [[nodiscard]] Vector2d need_vector(const std::string& key, const Dimension& dimension);
  [[nodiscard]] std::string text(const std::string& key);
  [[nodiscard]] bool flag(const std::string& key, bool otherwise);
  /// @}

  /// Keys that belong here, although after a mistake nothing asks for them.
  void knows(std::initializer_list<const char*> keys) {
    known_.insert(known_.end(), keys.begin(), keys.end());
  }

  /// Keys of which one would do in place of any that is missing from now on.
  void instead(std::initializer_list<const char*> keys) { instead_.assign(keys.begin(), keys.end()); }

  /// Reports every key that is not known.
  void finish() const;

  [[nodiscard]] std::string path_to(std::string_view key) const;

private:
  void report_unknown(const Entry& entry) const;
  void report_missing(std::string_view key, std::string_view what) const;

  Reading* reading_;
  const Value* value_;
  const Table* table_;
  std::vector<std::string> known_;    ///< some repeatedly
  std::vector<std::string> refused_;  ///< keys that must not be there
  std::vector<std::string> instead_;  ///< keys that would do in place of a missing one
};

/// Adds a mistake, or a note of a probable one, about a table as a whole.
/// \param lacks  paths of what is missing, any one of which would do
void report_whole(TableReader& table, std::string_view message, std::vector<std::string> lacks = {});
void note_whole(TableReader& table, std::string_view message);

/// The index of the first of `things` that has this name.
template <class Things>
[[nodiscard]] std::optional<int> index_of(const Things& things, std::string_view name) {
  const auto found =
      std::find_if(things.begin(), things.end(), [&](const auto& thing) { return thing.name == name; });
  return found == things.end() ? std::nullopt : std::optional(static_cast<int>(found - things.begin()));
}

/// All names, without empty ones.
template <class Things>
[[nodiscard]] std::vector<std::string> names_of(const Things& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) {
    if (!thing.name.empty()) names.push_back(thing.name);
  }
  return names;
}

/// "there is no body `crnk`; did you mean `crank`?"
/// \param none  how that begins: "there is no body", or has_no() for a part of a body
template <class Things>
[[nodiscard]] std::string no_such(std::string_view none, std::string_view name, const Things& things) {
  return fmt::format("{} `{}`; {}", none, name, suggestion(name, names_of(things)));
}

/// "body `crank` has no point"
[[nodiscard]] inline std::string has_no(std::string_view body, std::string_view kind) {
  return fmt::format("body `{}` has no {}", body, kind);
}

/// The index in `things` of the one named by an item; reports that there is none, as no_such() says it.
/// \param home  path of the table that the things are in, such as "bodies"
template <class Things>
[[nodiscard]] std::optional<int> named_thing(Reading& reading, const Item& item, std::string_view name,
                                             std::string_view none, const Things& things,
                                             const std::string& home) {
  const auto index = index_of(things, name);
  if (!index) {
    report(reading, item, no_such(none, name, things),
           things.empty() ? home : fmt::format("{}.{}", home, name));
  }
  return index;
}

/// The same for the name of a table.
template <class Things>
[[nodiscard]] std::optional<int> named_thing(TableReader& table, std::string_view name, std::string_view none,
                                             const Things& things, const std::string& home) {
  const auto index = index_of(things, name);
  if (!index) report_whole(table, no_such(none, name, things), {fmt::format("{}.{}", home, name)});
  return index;
}

/// A reader of an item, which must be a table; otherwise reports that `what` was expected.
[[nodiscard]] std::optional<TableReader> as_reader(Reading& reading, const std::optional<Item>& item,
                                                   std::string_view what);

/// Calls `read` for every entry of a table of named things (bodies, points, joints, …); reports keys that are
/// not valid names. The table may be absent.
void for_each_named(Reading& reading, const std::optional<Item>& item, std::string_view what,
                    const std::function<void(const std::string& name, const Item& item)>& read);

/// The same where every entry is itself a table.
void for_each_table(Reading& reading, const std::optional<Item>& item, std::string_view what,
                    const std::function<void(const std::string& name, TableReader& table)>& read);

/// Reads one such entry; otherwise reports that `what` was expected.
void read_named_table(Reading& reading, const std::string& name, const Item& item, std::string_view what,
                      const std::function<void(const std::string& name, TableReader& table)>& read);

/// Calls `read` for every table of the list [[key]], which may be absent; reports keys that `read` has not
/// asked for.
void for_each_in_list(TableReader& table, const std::string& key,
                      const std::function<void(TableReader& entry)>& read);

}  // namespace higherpair::io_detail

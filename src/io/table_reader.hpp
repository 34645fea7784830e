#pragma once

#include "typed_values.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace higherpair::io_detail {

/// One table of a profile, read key by key. It remembers which keys were asked for: the others are unknown.
class TableReader {
public:
  TableReader(Reading& reading, const Table& table, const Mark& mark, std::string path)
      : reading_(&reading), table_(&table), mark_(mark), path_(std::move(path)) {}

  [[nodiscard]] Reading& reading() const { return *reading_; }
  [[nodiscard]] const Mark& mark() const { return mark_; }
  [[nodiscard]] const std::string& path() const { return path_; }

  /// The item at `key`, or nothing if the table has no such key.
  [[nodiscard]] std::optional<Item> take(const std::string& key);

  /// The same; reports that the key is missing and `what` it should be.
  [[nodiscard]] std::optional<Item> need(const std::string& key, std::string_view what);

  /// Reports that the key is present, and why it must not be.
  void refuse(const std::string& key, std::string_view reason);

  /// \name A value, or the default if it is absent (or wrong, which is reported); lengths etc. in SI units.
  /// @{
  [[nodiscard]] double quantity(const std::string& key, const Expected& expected, double otherwise = 0);
  [[nodiscard]] double need_quantity(const std::string& key, const Expected& expected);
  [[nodiscard]] Vector2d need_vector(const std::string& key, const Dimension& dimension);
  [[nodiscard]] std::string text(const std::string& key);
  [[nodiscard]] bool flag(const std::string& key, bool otherwise);
  /// How many, from `least` to 10⁹; none where absent or wrong.
  [[nodiscard]] std::optional<std::int64_t> count(const std::string& key, std::int64_t least);
  /// @}

  /// Reports every key that was never asked for.
  void finish() const;

private:
  [[nodiscard]] std::string path_of(std::string_view key) const;
  void report_unknown(const Entry& entry) const;

  Reading* reading_;
  const Table* table_;
  Mark mark_;
  std::string path_;
  std::vector<std::string> known_;    ///< keys that were asked for
  std::vector<std::string> refused_;  ///< keys that are present and must not be
};

/// Calls `read` for every entry of a table of named things (bodies, points, joints, …) whose name is a name.
void for_each_named(Reading& reading, const Item& item, std::string_view what,
                    const std::function<void(const std::string& name, const Item& item)>& read);

/// The same, where every thing is a table itself.
void for_each_table(Reading& reading, const Item& item, std::string_view what,
                    const std::function<void(const std::string& name, TableReader& table)>& read);

/// Calls `read` for every table of the list [[key]], which may be absent; whatever keys it leaves are
/// reported.
void for_each_in_list(TableReader& table, const std::string& key,
                      const std::function<void(TableReader& entry)>& read);

}  // namespace higherpair::io_detail

#pragma once

#include "document.hpp"
#include "higherpair/geometry/vector.hpp"
#include "higherpair/io/units.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::io_detail {

struct Mistake {
  Mark mark;
  std::string message;
};

/// What all readers share: the units of the profile and the mistakes found so far.
struct Reading {
  std::vector<std::string> sources;  ///< the names of the sources that marks are in
  Units units;
  std::vector<Mistake> mistakes;
  std::vector<Mistake> notes;      ///< what is probably a slip, found while reading
  std::vector<std::string> files;  ///< paths of those that were read besides the profile
  /// Of the numbers that a task varies, by their paths, the dimension as which they were read; none: not as
  /// quantities.
  std::map<std::string, std::optional<Dimension>> varied;
  bool lists_quantities = false;  ///< whether all quantities are listed as they are read
  struct ReadQuantity {
    std::string path;
    Dimension dimension;
    double profile = 0;  ///< in the profile's unit
  };
  std::vector<ReadQuantity> quantities;
};

[[nodiscard]] Place place_of(const Reading& reading, const Mark& mark);

/// A value of the document with its path ("bodies.cam.curves.disc.radius"), by which messages call it.
struct Item {
  const Value* value = nullptr;
  std::string path;
};

/// Notes a mistake about an item: "PATH = VALUE: rule".
void report(Reading& reading, const Item& item, std::string_view rule);

enum class Sign { kAny, kPositive, kNotNegative };

/// What a number in a profile has to be.
struct Expected {
  Dimension dimension;
  Sign sign = Sign::kAny;
};

/// \name Typed access. Each reports what is not as expected and then returns nothing.
/// @{
[[nodiscard]] const Table* as_table(Reading& reading, const Item& item, std::string_view what);
[[nodiscard]] std::optional<std::string> as_text(Reading& reading, const Item& item);
[[nodiscard]] std::optional<bool> as_flag(Reading& reading, const Item& item);
/// An integer, also one written as 361.0 or 1e3.
[[nodiscard]] std::optional<std::int64_t> as_integer(Reading& reading, const Item& item);
/// A finite number in the profile's unit, or a string with its own unit.
[[nodiscard]] std::optional<Quantity> as_quantity(Reading& reading, const Item& item,
                                                  const Expected& expected);
/// A list of quantities; any number of them where `count` is 0.
[[nodiscard]] std::optional<std::vector<Quantity>> as_list(Reading& reading, const Item& item,
                                                           const Expected& expected, std::size_t count = 0);
/// A list of two quantities, in SI units.
[[nodiscard]] std::optional<Vector2d> as_vector(Reading& reading, const Item& item,
                                                const Dimension& dimension);
/// A unit vector from an angle or from a list of two numbers, which is normalised. Angles within rounding of
/// a quarter turn give exact zeros and ones.
[[nodiscard]] std::optional<Vector2d> as_direction(Reading& reading, const Item& item);
/// The place of a word in a list of allowed ones.
[[nodiscard]] std::optional<std::size_t> as_choice(Reading& reading, const Item& item,
                                                   const std::vector<std::string>& choices);
/// @}

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

#pragma once

#include "document.hpp"
#include "higherpair/geometry/pose.hpp"
#include "higherpair/io/units.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace higherpair::io_detail {

/// Where a value of a document is: what it is in, and its key or its index there.
struct ValuePlace {
  const Value* parent = nullptr;
  const std::string* key = nullptr;  ///< null: an item of a list
  std::size_t index = 0;
};
using ValuePlaces = std::unordered_map<const Value*, ValuePlace>;

/// What all readers share: the units of the profile and the mistakes found so far.
struct Reading {
  const Value* document = nullptr;   ///< a table, with all values that are read
  std::vector<std::string> sources;  ///< the names of the sources that marks refer to
  Units units;
  std::vector<Mistake> mistakes;
  std::vector<Mistake> notes;      ///< probable mistakes found while reading
  std::vector<std::string> files;  ///< paths of the files read besides the profile
  /// For each number that a task varies: the dimension as which it was read; none if it was not read as a
  /// quantity.
  std::map<const Value*, std::optional<Dimension>> varied;
  bool lists_quantities = false;  ///< whether all quantities are listed as they are read
  /// Whether mistakes name remedies that have to be searched for; not in one of many variants.
  bool advises = true;
  struct ReadQuantity {
    std::string path;
    Dimension dimension;
    double profile = 0;  ///< in the profile's unit
  };
  std::vector<ReadQuantity> quantities;
  std::shared_ptr<const ValuePlaces> places;  ///< of all values, once path_of() has been asked for one
};

/// Detects whether mistakes were reported since its construction.
class Mistakes {
public:
  explicit Mistakes(const Reading& reading) : reading_(reading), before_(reading.mistakes.size()) {}
  [[nodiscard]] bool none() const { return reading_.mistakes.size() == before_; }

private:
  const Reading& reading_;
  std::size_t before_;
};

[[nodiscard]] Place place_of(const Reading& reading, const Mark& mark);

/// A value of the document.
struct Item {
  const Value* value = nullptr;
};

/// The path of an item, "bodies.cam.curves.disc.radius", which names it in messages. The first call finds the
/// places of all values: most readings need none.
[[nodiscard]] std::string path_of(Reading& reading, const Item& item);

/// The dimension as which the number at this path was read; none if no task varies it, or if it was not read
/// as a quantity.
[[nodiscard]] std::optional<Dimension> varied_dimension(const Reading& reading, std::string_view path);

/// The items of a list; empty for any other value.
[[nodiscard]] std::vector<Item> items_of(const Item& item);

/// Reports a mistake about an item: "PATH = VALUE: rule".
/// \param lacks  the path of what it names and what is not there, if any
void report(Reading& reading, const Item& item, std::string_view rule, const std::string& lacks = "");

enum class Sign { kAny, kPositive, kNotNegative };

/// Requirements for a number in a profile.
struct Expected {
  Dimension dimension;
  Sign sign = Sign::kAny;
};

/// Reports that an item is not `what` was expected, and whether it would be right without its quotes: as one
/// of `words` if there are any, otherwise as a number.
void report_kind(Reading& reading, const Item& item, std::string_view what,
                 std::initializer_list<std::string_view> words = {});

/// "a length (a number in mm or a string with its unit)".
[[nodiscard]] std::string what_number(const Dimension& dimension, const Units& units);

/// \name Typed access. Each reports a value that is not as expected and then returns nothing.
/// @{
[[nodiscard]] const Table* as_table(Reading& reading, const Item& item, std::string_view what);
[[nodiscard]] std::optional<std::string> as_text(Reading& reading, const Item& item);
[[nodiscard]] std::optional<bool> as_flag(Reading& reading, const Item& item);
/// An integer, also one written as 361.0 or 1e3.
[[nodiscard]] std::optional<std::int64_t> as_integer(Reading& reading, const Item& item);
struct CountRange {
  std::int64_t least = 0;
  std::int64_t most = 1'000'000'000;
};
[[nodiscard]] std::optional<std::int64_t> as_count(Reading& reading, const Item& item,
                                                   const CountRange& range);
/// The seed of a pseudorandom sequence: an integer >= 0.
[[nodiscard]] std::optional<std::uint64_t> as_seed(Reading& reading, const Item& item);
/// A finite number in the profile's unit, or a string with its own unit.
[[nodiscard]] std::optional<Quantity> as_quantity(Reading& reading, const Item& item,
                                                  const Expected& expected);
/// A list of quantities; any number of them where `count` is 0.
[[nodiscard]] std::optional<std::vector<Quantity>> as_list(Reading& reading, const Item& item,
                                                           const Expected& expected, std::size_t count = 0);
/// The items of a list of anything, from `fewest` to `most` of them; otherwise reports what was `expected`.
[[nodiscard]] std::optional<std::vector<Item>> as_items(
    Reading& reading, const Item& item, std::string_view expected, std::size_t fewest = 1,
    std::size_t most = std::numeric_limits<std::size_t>::max());
/// A list of two quantities, in SI units.
[[nodiscard]] std::optional<Vector2d> as_vector(Reading& reading, const Item& item,
                                                const Dimension& dimension);
/// A unit vector from an angle or from a list of two numbers, which is normalised. Angles within rounding of
/// a quarter turn give exact zeros and ones.
[[nodiscard]] std::optional<Vector2d> as_direction(Reading& reading, const Item& item);
/// The index of a word in a list of allowed ones.
[[nodiscard]] std::optional<std::size_t> as_choice(Reading& reading, const Item& item,
                                                   const std::vector<std::string>& choices);
/// @}

}  // namespace higherpair::io_detail

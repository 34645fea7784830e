#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/names.hpp"
#include "higherpair/io/units.hpp"
#include "numeric/joined_words.hpp"
#include "unit_table.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr int kMostMended = 3;         // unknown words in one unit
constexpr std::size_t kShortWord = 2;  // too short to be a misspelling: an unknown `nm` is no `mm`

// Names of units used elsewhere, and how to write them here.
struct OtherName {
  std::string_view name;
  std::string_view unit;
  std::string_view advice;
};
constexpr OtherName kOtherNames[] = {{"Hz", "rev/s", "rev/s"},
                                     {"rps", "rev/s", "rev/s"},
                                     {"mps", "m/s", "m/s"},
                                     {"U", "rev", "rev, or rpm for U/min"},
                                     {"r", "rev", "rev, or rpm for r/min"},
                                     {"lbs", "lb", "lb"},
                                     {"µm", "um", "um"},
                                     {"μm", "um", "um"}};

// The unit of this name, in whatever letters; empty if there is none.
std::string spelt_unit(std::string_view word) {
  const std::vector<std::string> names = all_unit_names();
  const auto exact = std::find(names.begin(), names.end(), word);
  const auto unit =
      exact != names.end() ? exact : std::find_if(names.begin(), names.end(), [&](const auto& name) {
        return same_letters(name, word);
      });
  return unit == names.end() ? "" : *unit;
}

// What a word that is no unit may have been meant to be, the likeliest first.
std::vector<std::string> candidates(std::string_view word) {
  std::vector<std::string> found = {spelt_unit(word)};
  for (const OtherName& other : kOtherNames) {
    if (word == other.name) found.emplace_back(other.unit);
  }
  for (std::size_t i = 1; i < word.size(); ++i) {
    const std::string first = spelt_unit(word.substr(0, i));
    const std::string second = spelt_unit(word.substr(i));
    if (first.empty() || second.empty()) continue;
    found.push_back(fmt::format("{} {}", first, second));
    found.push_back(fmt::format("{}/{}", first, second));
  }
  const std::vector<std::string> names = all_unit_names();
  const bool is_synonym_of_one = std::any_of(names.begin(), names.end(),
                                             [&](const std::string& name) { return is_synonym(word, name); });
  if (word.size() > kShortWord || is_synonym_of_one) {
    for (std::string& name : meant_names(word, names)) found.push_back(std::move(name));
  }
  std::erase(found, "");
  return found;
}

// A power without its ^, as in m2, gets it.
std::string with_power(std::string_view text) {
  const bool is_digit = !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0;
  return (is_digit ? "^" : "") + std::string(text);
}

// The unit with all its unknown words mended so that it is one of the expected dimension; empty if there is
// no such way.
std::string mended(std::string_view text, const Dimension& expected, int depth) {
  const auto product = parse_unit(text);
  if (product) return same_quantity(product->dimension, expected) ? std::string(text) : "";
  const std::string& word = product.error().unknown;
  if (word.empty() || depth == kMostMended) return "";
  const std::size_t at = product.error().at;
  for (const std::string& candidate : candidates(word)) {
    const std::string tried =
        fmt::format("{}{}{}", text.substr(0, at), candidate, with_power(text.substr(at + word.size())));
    if (std::string whole = mended(tried, expected, depth + 1); !whole.empty()) return whole;
  }
  return "";
}

// The names of all units of a base quantity, such as lengths.
std::vector<std::string> units_of(const Dimension& expected) {
  std::vector<std::string> names;
  for (const std::string& name : all_unit_names()) {
    const auto unit = parse_unit(name);
    if (unit && same_quantity(unit->dimension, expected)) names.push_back(name);
  }
  return names;
}

}  // namespace

std::string unit_advice(std::string_view text, std::string_view unknown, const Dimension& expected) {
  const std::string whole = mended(text, expected, 0);
  for (const OtherName& other : kOtherNames) {
    if (!whole.empty() && unknown == other.name) return fmt::format(": write {}", other.advice);
  }
  if (!whole.empty()) return fmt::format(" (did you mean `{}`?)", whole);
  const std::vector<std::string> names =
      trimmed(text) == unknown ? units_of(expected) : std::vector<std::string>();
  return names.size() < 2 ? "" : fmt::format(" (there are {})", joined_words(names));
}

}  // namespace higherpair::io_detail

std::string higherpair::separator_advice(std::string_view text) {
  static const std::regex kComma(R"(([+-]?\d+),(\d+)\s*(?:[#A-Za-z°µμ}\]].*)?)");
  static const std::regex kGrouped(
      R"(([+-]?[1-9]\d{0,2})([,.' ])(\d{3}(?:\2\d{3})*)(?:([.,])(\d+))?\s*(?:[#A-Za-z°µμ}\]].*)?)");
  const char *const begin = text.data(), *const end = begin + text.size();
  std::cmatch comma, grouped;
  const bool has_comma = std::regex_match(begin, end, comma, kComma);
  const bool is_grouped = std::regex_match(begin, end, grouped, kGrouped) && grouped[2] != grouped[4];
  if (has_comma) {
    return fmt::format(
        "a decimal number is written with a point: {0}.{1}{2}", comma[1].str(), comma[2].str(),
        is_grouped ? fmt::format("; if thousands are meant, write {}{}", comma[1].str(), comma[2].str())
                   : "");
  }
  const bool is_right = is_grouped && grouped[2] == "." && grouped[3].length() == 3 && !grouped[4].matched;
  if (!is_grouped || is_right) {
    return "";
  }
  std::string digits = grouped[1].str() + grouped[3].str();
  digits.erase(std::remove(digits.begin(), digits.end(), *grouped[2].first), digits.end());
  return fmt::format("write {}{}{}: no separator of thousands{}", digits, grouped[4].matched ? "." : "",
                     grouped[5].str(), grouped[4] == "," ? ", and a point for decimals" : "");
}

#include "higherpair/io/names.hpp"
#include "higherpair/numeric/contains.hpp"
#include "io/units/unit_table.hpp"
#include "syntax_rules.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr const char* kNumber = R"([+-]?(?:\d[\d_]*\.?[\d_]*|\.\d+)(?:[eE][+-]?\d+)?)";

// The spelling required here for a unit written as a sign behind a number.
std::string spelled_unit(std::string_view unit) {
  if (unit == "°") return "deg";
  if (unit == "\"" || unit == "''") return "in";
  if (unit == "'") return "ft";
  if (unit == "µm" || unit == "μm") return "um";
  return std::string(unit);
}

// A number with a unit but without quotes: 30 mm, 30°, 30".
Finding unquoted_unit(std::size_t at, std::string_view token) {
  static const std::regex kWithUnit(fmt::format(R"(({})\s*([A-Za-z°µμ"'][^=;:()]*))", kNumber));
  std::cmatch match;
  if (!std::regex_match(token.data(), token.data() + token.size(), match, kWithUnit)) {
    return std::nullopt;
  }
  const std::string unit = spelled_unit(match[2].str());
  const std::string_view name = word_of(unit);
  const bool known = is_unit_name(name) || match[2].str() != unit;
  return known ? Finding({at, fmt::format("a number with its unit is written in quotes: \"{} {}\"",
                                          match[1].str(), unit)})
               : std::nullopt;
}

bool begins_with_digit(std::string_view text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0;
}

// A number with a digit on either side of its point, and without leading zeros.
std::string written_out(std::string_view number) {
  const std::string_view sign = number.substr(0, number.starts_with('-') || number.starts_with('+') ? 1 : 0);
  number.remove_prefix(sign.size());
  while (number.starts_with('0') && begins_with_digit(number.substr(1))) {
    number.remove_prefix(1);
  }
  const std::size_t point = number.find('.');
  if (point == std::string_view::npos) {
    return fmt::format("{}{}", sign, number);
  }
  const std::string_view behind = number.substr(point + 1);
  return fmt::format("{}{}{}.{}{}", sign, point == 0 ? "0" : "", number.substr(0, point),
                     begins_with_digit(behind) ? "" : "0", behind);
}

// Numbers that TOML does not allow, and expressions: .5, 5., 007, 1e400.
Finding odd_number(std::size_t at, std::string_view token, std::string_view message) {
  static const std::regex kNumberAlone(kNumber);
  static const std::regex kSum(fmt::format(
      R"(\(?{0}\s*(?:[+*^]|-(?!-)|/(?![/*])).*|.*\w\(.*\)|\(.*\)|\w+\s*[*/^]\s*\w+|pi)", kNumber));
  if (!std::regex_match(token.begin(), token.end(), kNumberAlone)) {
    return std::regex_match(token.begin(), token.end(), kSum)
               ? Finding({at, fmt::format("nothing is worked out here: write the number instead of `{}`",
                                          shown(token))})
               : std::nullopt;
  }
  if (contains_text(message, "representable") || contains_text(message, "interpreted")) {
    return Found{at, fmt::format("{} is too large for a number", shown(token))};
  }
  const std::string number = written_out(token);
  return number == token ? std::nullopt
                         : Finding({at, fmt::format("{} is written {} in TOML", shown(token), number)});
}

// A word without quotes: revolute instead of "revolute".
Finding bare_word(std::size_t at, std::string_view token) {
  static const std::regex kWords(R"([A-Za-z_][\w.+/ -]*)");
  if (!std::regex_match(token.begin(), token.end(), kWords)) {
    return std::nullopt;
  }
  std::string lower(token);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto is = [&](std::initializer_list<std::string_view> words) { return contains(words, lower); };
  if (is({"true", "yes", "on", "tru", "ture", "t", "y"})) {
    return Found{at, fmt::format("write true instead of `{}`", shown(token))};
  }
  if (is({"false", "no", "off", "fals", "flase", "f", "n"})) {
    return Found{at, fmt::format("write false instead of `{}`", shown(token))};
  }
  if (is({"none", "null", "nil", "undefined"})) {
    return Found{at, "leave the key out where it has no value"};
  }
  return Found{at, fmt::format("a text is written in quotes: \"{}\"", shown(token))};
}

// x = 1 instead of { x = 1 }, and a string with only its closing quotation mark.
Finding half_enclosed(std::size_t at, std::string_view token) {
  static const std::regex kKey(R"(\w+\s*=.*)");
  if (token.empty()) {
    return Found{at, "a value is missing here"};
  }
  if (std::regex_match(token.begin(), token.end(), kKey)) {
    return Found{at, fmt::format("keys within a value are a table in braces: {{ {}, ... }}", shown(token))};
  }
  if (token.back() == '"' && std::count(token.begin(), token.end(), '"') == 1) {
    return Found{at, fmt::format("the opening quotation mark of `{}` is missing", shown(token))};
  }
  return std::nullopt;
}

// Anything that follows a complete value.
Finding behind_value(const SyntaxScan& scan, std::string_view message) {
  const std::string_view here = scan.line_from(scan.stop);
  if (!contains_text(message, "expected a comment or whitespace") && !here.starts_with(';')) {
    return std::nullopt;
  }
  if (here.starts_with(';')) {
    return Found{scan.stop, "a line ends without a semicolon"};
  }
  std::string_view rest = here.starts_with(',') ? trimmed(here.substr(1)) : here;
  if (begins_statement(rest)) {
    return Found{scan.stop, fmt::format("one key on a line: put `{}` on the next one", shown(rest))};
  }
  if (rest.empty()) {
    return Found{scan.stop, "a line ends without a comma"};
  }
  if (here.starts_with("//") || here.starts_with("/*") || here.starts_with("%") || here.starts_with("--")) {
    return Found{scan.stop, "a comment begins with #"};
  }
  if (here.starts_with(',')) {
    return Found{scan.stop, "several values are a list in brackets: [1, 2]"};
  }
  const std::string_view before = trimmed(scan.text.substr(scan.token, scan.stop - scan.token));
  return scan.after_value || (!before.empty() && std::isdigit(static_cast<unsigned char>(before.back())) != 0)
             ? Finding({scan.stop, fmt::format("nothing but a comment may follow the value on its line: `{}`",
                                               shown(rest))})
             : std::nullopt;
}

}  // namespace

Finding unit_mistake(const SyntaxScan& scan) {
  if (scan.expecting != Expecting::kValue || scan.after_value) {
    return std::nullopt;
  }
  const std::size_t at = std::min(scan.text.find_first_not_of(" \t\r\n", scan.token), scan.text.size());
  return unquoted_unit(at, scan.last_token());
}

Finding value_mistake(const SyntaxScan& scan, std::string_view message) {
  if (scan.expecting != Expecting::kValue) {
    return std::nullopt;
  }
  const std::size_t at = std::min(scan.text.find_first_not_of(" \t\r\n", scan.token), scan.text.size());
  const std::string_view line = scan.line_from(at);
  const std::string_view token = scan.last_token();
  if (scan.after_value) {
    return behind_value(scan, message);
  }
  if (scan.open.empty() && trimmed(scan.line_from(scan.token)).empty()) {
    return Found{scan.token, "a value is missing after the ="};
  }
  if (line.starts_with("=") || line.starts_with(":")) {
    return Found{at, "one = joins a key and its value"};
  }
  if (scan.open.empty()) {
    if (std::string advice = separator_advice(line); !advice.empty()) return Found{at, std::move(advice)};
  }
  if (auto number = odd_number(at, token, message)) return number;
  if (auto behind = behind_value(scan, message)) return behind;
  if (line.starts_with("(")) {
    return Found{at, "a list is written in brackets: [1, 2]"};
  }
  if (auto half = half_enclosed(at, token)) return half;
  if (auto word = bare_word(at, token)) return word;
  return Found{
      at, fmt::format("`{}` is no value: expected a number, a \"text\" in quotes, true, false, or a [list]",
                      shown(token))};
}

}  // namespace higherpair::io_detail

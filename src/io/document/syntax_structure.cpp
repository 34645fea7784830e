#include "encoding.hpp"
#include "higherpair/io/names.hpp"
#include "higherpair/io/units.hpp"
#include "higherpair/numeric/contains.hpp"
#include "syntax_rules.hpp"

#include <algorithm>
#include <iterator>
#include <regex>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr std::string_view kKeyCharacters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-.";

std::string path_of(const Statement& statement) {
  return statement.key.empty() || statement.heading.empty() ? statement.heading + statement.key
                                                            : statement.heading + "." + statement.key;
}

// An earlier statement of the same heading or key; otherwise one whose key or table contains it or is
// contained in it.
const Statement* earlier(const SyntaxScan& scan, const Statement& last) {
  const std::string wanted = path_of(last);
  const auto end = scan.statements.begin() + (&last - scan.statements.data());
  const auto same =
      std::find_if(scan.statements.begin(), end, [&](const Statement& s) { return path_of(s) == wanted; });
  if (same != end) {
    return &*same;
  }
  const auto around = std::find_if(scan.statements.begin(), end, [&](const Statement& s) {
    const std::string other = path_of(s);
    return (!s.key.empty() && wanted.starts_with(other + ".")) || other.starts_with(wanted + ".");
  });
  return around == end ? nullptr : &*around;
}

// The number without exponent, with its sign, at the end of a text; empty where the text ends otherwise.
std::string_view last_number(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789.";
  const std::size_t digits = text.find_last_not_of(kDigits) + 1;
  const bool has_sign = digits > 0 && (text[digits - 1] == '-' || text[digits - 1] == '+');
  const std::size_t begin = has_sign ? digits - 1 : digits;
  const bool is_part =
      begin > 0 && (text[begin - 1] == '+' || contains_text(kKeyCharacters, text.substr(begin - 1, 1)));
  return digits == text.size() || is_part ? std::string_view() : text.substr(begin);
}

// A decimal comma, 30,5 or 1.000,5, within a table in braces: its second half is found where a key is
// expected.
Finding decimal_comma_in_table(const SyntaxScan& scan, std::size_t at) {
  static const std::regex kDecimals(R"((\d+)\s*(?:[,}#A-Za-z°].*)?)");
  if (!scan.in_table() || scan.text[at - 1] != ',') {
    return std::nullopt;
  }
  const std::string_view whole = last_number(scan.text.substr(0, at - 1));
  const std::string_view behind = scan.line_from(at);
  std::cmatch decimals;
  if (whole.empty() || !std::regex_match(behind.data(), behind.data() + behind.size(), decimals, kDecimals)) {
    return std::nullopt;
  }
  std::string advice = separator_advice(fmt::format("{},{}", whole, decimals[1].str()));
  return advice.empty() ? std::nullopt : Finding({at - 1 - whole.size(), std::move(advice)});
}

// The last heading: the parser refuses some only at the statement that follows.
std::vector<Statement>::const_iterator last_heading(const SyntaxScan& scan) {
  const auto heading = std::find_if(scan.statements.rbegin(), scan.statements.rend(),
                                    [](const Statement& statement) { return statement.key.empty(); });
  return heading == scan.statements.rend() ? scan.statements.end() - 1 : std::prev(heading.base());
}

// A key within braces that is there already, or whose front part is.
Finding repeated_in_braces(const SyntaxScan& scan, std::string_view message) {
  const bool behind_equals = scan.expecting == Expecting::kValue;
  const std::size_t end = behind_equals ? scan.token - 1 : scan.text.find('=', scan.token);
  const std::size_t begin = scan.text.find_last_of(",{", end) + 1;
  const std::string_view key = trimmed(scan.text.substr(begin, end - begin));
  const std::size_t at = scan.text.find_first_not_of(" \t", begin);
  if (contains_text(message, "as dotted")) {
    return Found{at,
                 fmt::format("`{}` is a part of what is written in this table already, as a whole: put it "
                             "there",
                             shown(key))};
  }
  return Found{at, fmt::format("`{}` is in this table a second time: keep one of them", shown(key))};
}

// A key such as `points.A`, where `points` has a heading of its own: the keys of a table stay together.
Finding table_elsewhere(const SyntaxScan& scan, const Statement& last) {
  const std::string wanted = path_of(last);
  const Statement* table = nullptr;
  for (const Statement& other : scan.statements) {
    const bool around = other.key.empty() && wanted.starts_with(other.heading + ".") &&
                        other.heading.size() > last.heading.size();
    if (around && (table == nullptr || other.heading.size() > table->heading.size())) table = &other;
  }
  if (table == nullptr || last.key.empty()) return std::nullopt;
  return Found{last.at,
               fmt::format("`{}` belongs to [{}] in line {}, where all keys of that table must be: put "
                           "`{}` there",
                           last.key, table->heading, mark_at(scan.text, table->at).line,
                           wanted.substr(table->heading.size() + 1))};
}

// Tables that a profile repeats, each with a heading in two pairs of brackets.
bool is_list_of_tables(std::string_view heading) {
  constexpr std::string_view kLists[] = {"objectives", "constraints", "columns", "frames", "correlations"};
  return contains(kLists, heading.substr(heading.rfind('.') + 1));
}

Finding repeated_heading(const SyntaxScan& scan, const Statement& last, const Statement& before) {
  const int line = mark_at(scan.text, before.at).line;
  const bool same = before.heading == last.heading && before.key.empty();
  if (same && is_list_of_tables(last.heading)) {
    return Found{last.at, fmt::format("each table of this list is headed [[{}]], here and in line {}",
                                      last.heading, line)};
  }
  if (scan.text.substr(last.at, 2) == "[[" && !is_list_of_tables(last.heading)) {
    return Found{last.at, fmt::format("[[{0}]] begins a list: write [{0}.NAME], each with a name of its own",
                                      last.heading)};
  }
  const std::string_view hint =
      last.heading == "driver" ? " (several drivers are tables [drivers.NAME])" : "";
  return Found{
      last.at,
      same ? fmt::format("[{}] is here a second time after line {}: put all its keys under one heading{}",
                         last.heading, line, hint)
           : fmt::format("[{}] is written in line {} already, as a key: put all its keys there", last.heading,
                         line)};
}

Finding repeated_key(const SyntaxScan& scan, const Statement& last, const Statement& before) {
  const int line = mark_at(scan.text, before.at).line;
  const bool same = before.heading == last.heading && before.key == last.key;
  return Found{last.at,
               same
                   ? fmt::format("`{}` is here a second time after line {}: keep one of them", last.key, line)
                   : fmt::format("`{}` is written in line {} already, as a whole: put all of it there",
                                 last.key, line)};
}

}  // namespace

Finding redefinition(const SyntaxScan& scan, std::string_view message) {
  if ((!contains_text(message, "cannot redefine") && !contains_text(message, "cannot insert")) ||
      scan.statements.empty()) {
    return std::nullopt;
  }
  if (scan.in_table()) return repeated_in_braces(scan, message);
  const auto last = contains_text(message, "table header") ? last_heading(scan) : scan.statements.end() - 1;
  if (auto table = table_elsewhere(scan, *last)) return table;
  const Statement* before = earlier(scan, *last);
  if (before == nullptr) {
    return Found{last->at, "a key is written a second time here"};
  }
  return last->key.empty() ? repeated_heading(scan, *last, *before) : repeated_key(scan, *last, *before);
}

Finding heading_mistake(const SyntaxScan& scan, std::string_view message) {
  if (scan.expecting != Expecting::kHeading) {
    return std::nullopt;
  }
  const std::string_view line = scan.line_from(scan.token);
  const std::size_t close = line.find(']');
  const std::string_view name = trimmed(line.substr(std::min(line.find_first_not_of('['), line.size())));
  if (contains_text(message, "blank bare keys") || name.empty() || name[0] == ']') {
    return Found{scan.token, "a heading needs a name between its brackets, such as [driver]"};
  }
  if (close == std::string_view::npos) {
    return Found{scan.token, fmt::format("the closing ] of the heading {} is missing", shown(line))};
  }
  if (line.starts_with("[[") || line.substr(close).starts_with("]]")) {
    return Found{scan.token, fmt::format("the heading of a table has one pair of brackets: [{}]",
                                         shown(name.substr(0, name.find(']'))))};
  }
  const std::string_view behind = trimmed(line.substr(close + 1));
  if (!behind.empty() && behind[0] != '#') {
    return Found{scan.token + close + 1,
                 fmt::format("a heading is a line of its own: put `{}` on the next one", shown(behind))};
  }
  return Found{scan.token,
               fmt::format("[{}] is no heading: it is names of letters, digits, _ and -, joined by points, "
                           "as in [bodies.cam]",
                           shown(name.substr(0, name.find(']'))))};
}

Finding bracket_mistake(const SyntaxScan& scan, std::string_view message) {
  const std::string_view here = scan.line_from(scan.stop);
  const char c = here.empty() ? '\n' : here.front();
  if (scan.open.empty()) {
    return scan.expecting == Expecting::kValue && (c == ']' || c == '}')
               ? Finding({scan.stop, fmt::format("this {} closes nothing: there is one too many", c)})
               : std::nullopt;
  }
  if (scan.in_table() && (trimmed(here).empty() || here.front() == '#')) {
    return Found{
        scan.open.back(),
        fmt::format("the table that {{ begins here must be closed by }} on the same line; longer ones are "
                    "written as a table of their own, [{}], with a line for each key",
                    path_of(scan.statements.back()))};
  }
  if (contains_text(message, "dangling comma") || contains_text(message, "saw comma")) {
    return Found{scan.stop, "there is a comma too many here"};
  }
  if (scan.in_list() && (here.empty() || begins_statement(here))) {
    return Found{scan.open.back(), "the list that [ begins here is not closed by ]"};
  }
  if (contains_text(message, "expected comma")) {
    return Found{scan.stop, fmt::format("a comma is missing before `{}`", shown(here))};
  }
  if (c == ';') {
    return Found{scan.stop, "write a comma instead of the semicolon"};
  }
  return std::nullopt;
}

Finding key_mistake(const SyntaxScan& scan) {
  if (scan.expecting != Expecting::kKey) {
    return std::nullopt;
  }
  const std::size_t at = std::min(scan.text.find_first_not_of(" \t", scan.token), scan.text.size());
  const std::string_view line = scan.line_from(at);
  if (at == 0 && (line.starts_with('{') || line.starts_with('<'))) {
    return Found{
        at, fmt::format("this looks like {}; a profile is TOML: lines key = value under headings [table]",
                        line[0] == '{' ? "JSON" : "XML or HTML")};
  }
  for (const std::string_view comment : {"//", "/*", ";", "%", "--", "!", "'"}) {
    if (line.starts_with(comment)) return Found{at, "a comment begins with #"};
  }
  if (auto comma = decimal_comma_in_table(scan, at)) return comma;
  const std::string_view key = line.substr(0, std::min(line.find_first_not_of(kKeyCharacters), line.size()));
  const std::string_view behind = trimmed(line.substr(key.size()));
  if (line.starts_with('=')) {
    return Found{at, "a key is missing before the ="};
  }
  if (character_length(line) > 1 || (key.empty() && !line.empty())) {
    return Found{at, fmt::format("`{}` cannot begin a key: keys are of letters, digits, _ and -",
                                 shown(line.substr(0, std::max<std::size_t>(character_length(line), 1))))};
  }
  if (key.starts_with('.') || key.ends_with('.') || contains_text(key, "..")) {
    return Found{at, "the parts of a key are words, joined by single points"};
  }
  if (behind.starts_with(']')) {
    return Found{at, fmt::format("the opening [ of the heading [{}] is missing", shown(key))};
  }
  if (behind.starts_with(':')) {
    return Found{scan.stop, "key and value are joined by =, not by :"};
  }
  if (behind.empty()) {
    return Found{
        at, fmt::format("`{}` is no line of TOML: expected key = value, or a heading [table]", shown(key))};
  }
  static const std::regex kWords(R"((\w+(?:[ \t]+\w+)+)[ \t]*=.*)");
  std::cmatch match;
  if (std::regex_match(line.data(), line.data() + line.size(), match, kWords)) {
    std::string joined = match[1].str();
    std::replace_if(
        joined.begin(), joined.end(), [](char c) { return c == ' ' || c == '\t'; }, '_');
    return Found{at, fmt::format("a key is one word: {}", shown(joined))};
  }
  return Found{at, fmt::format("expected = after the key `{}`", shown(key))};
}

}  // namespace higherpair::io_detail

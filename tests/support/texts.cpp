#include "support/texts.hpp"

#include <algorithm>

namespace higherpair::testing {
namespace {

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

bool meets(const ExpectedLine& expected, std::string_view line) {
  return expected.is_whole ? line == expected.text : has(line, expected.text);
}

std::string listed(const std::vector<std::string>& lines) {
  std::string list = lines.empty() ? "there are no lines" : "the lines are";
  for (const std::string& line : lines) list += "\n  \"" + line + "\"";
  return list;
}

}  // namespace

::testing::AssertionResult contains(std::string_view text, std::string_view part) {
  const bool is_there = has(text, part);
  return ::testing::AssertionResult(is_there)
         << '"' << text << (is_there ? "\" contains \"" : "\" does not contain \"") << part << '"';
}

::testing::AssertionResult contains_all(std::string_view text,
                                        std::initializer_list<std::string_view> parts) {
  for (const std::string_view part : parts) {
    if (!has(text, part)) return contains(text, part);
  }
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult lines_are(const std::vector<std::string>& lines,
                                     std::initializer_list<ExpectedLine> expected) {
  if (lines.size() == expected.size() && std::equal(expected.begin(), expected.end(), lines.begin(), meets)) {
    return ::testing::AssertionSuccess();
  }
  auto differ = ::testing::AssertionFailure() << listed(lines) << "\nexpected are " << expected.size();
  for (const ExpectedLine& line : expected) {
    differ << (line.is_whole ? "\n  \"" : "\n  … \"") << line.text << (line.is_whole ? "\"" : "\" …");
  }
  return differ;
}

::testing::AssertionResult a_line_contains(const std::vector<std::string>& lines, std::string_view part) {
  const bool is_there =
      std::any_of(lines.begin(), lines.end(), [&](const std::string& line) { return has(line, part); });
  return ::testing::AssertionResult(is_there)
         << listed(lines) << (is_there ? "\nand one contains \"" : "\nand none contains \"") << part << '"';
}

}  // namespace higherpair::testing

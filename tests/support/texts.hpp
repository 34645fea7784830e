#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

// What texts are to say, for EXPECT_TRUE and EXPECT_FALSE. GoogleMock's matchers say the same, but each takes
// two to three times as long to compile, and there are more than a thousand.

namespace higherpair::testing {

/// A line that is expected: a text, or what `part` stands for.
struct ExpectedLine {
  ExpectedLine(const char* line) : text(line) {}         // NOLINT(google-explicit-constructor)
  ExpectedLine(const std::string& line) : text(line) {}  // NOLINT(google-explicit-constructor)
  ExpectedLine(std::string_view line, bool whole) : text(line), is_whole(whole) {}

  std::string_view text;
  bool is_whole = true;
};

/// A line with `text` in it.
inline ExpectedLine part(std::string_view text) {
  return {text, false};
}

/// Whether `part` is somewhere in `text`.
::testing::AssertionResult contains(std::string_view text, std::string_view part);

/// Whether each of `parts` is somewhere in `text`.
::testing::AssertionResult contains_all(std::string_view text, std::initializer_list<std::string_view> parts);

/// Whether `lines` are those expected, in this order, and no others.
::testing::AssertionResult lines_are(const std::vector<std::string>& lines,
                                     std::initializer_list<ExpectedLine> expected);

/// Whether `part` is somewhere in one of `lines` at least.
::testing::AssertionResult a_line_contains(const std::vector<std::string>& lines, std::string_view part);

}  // namespace higherpair::testing

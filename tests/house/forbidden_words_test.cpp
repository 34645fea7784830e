// No file contains a note of unfinished work or a path of somebody's machine.
#include "house/tree.hpp"
#include "support/texts.hpp"

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace higherpair::house {
namespace {

using ::testing::IsEmpty;
using testing::lines_are;

// Written in pieces, so that this file passes its own test.
const std::regex& forbidden() {
  static const std::regex pattern(
      "\\b(TO"
      "DO|FIX"
      "ME|XX"
      "X)\\b|(^|[^\\w.}-])/(wo"
      "rk|ro"
      "ot|ho"
      "me|tm"
      "p|User"
      "s)(/|\\b)");
  return pattern;
}

std::vector<std::string> forbidden_words(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (std::regex_search(line, forbidden())) {
      found.push_back(std::to_string(number) + ": " + line);
    }
  }
  return found;
}

bool is_text(const std::string& text) {
  return text.find('\0') == std::string::npos;
}

TEST(ForbiddenWords, NoFileOfTheTreeHasThem) {
  const auto files = project_files();
  EXPECT_GT(files.size(), 10U) << "the tree was not found";
  for (const auto& file : files) {
    const std::string text = read_file(root() / file);
    if (is_text(text)) {
      EXPECT_THAT(forbidden_words(text), IsEmpty()) << file;
    }
  }
}

TEST(ForbiddenWords, AreFoundInMadeUpText) {
  const std::string note = std::string("// TO") + "DO: later";
  EXPECT_TRUE(lines_are(forbidden_words("fine\n" + note + "\n"), {"2: " + note}));
  for (const std::string folder : {"wo"
                                   "rk",
                                   "ro"
                                   "ot",
                                   "ho"
                                   "me",
                                   "tm"
                                   "p"}) {
    const std::string path = "see \"/" + folder + "/notes.txt\"";
    EXPECT_TRUE(lines_are(forbidden_words(path), {"1: " + path}));
  }
}

TEST(ForbiddenWords, OrdinaryWordsAndPathsAreNot) {
  EXPECT_THAT(forbidden_words("the method, in work/loss terms; ${dir}/tm"
                              "p; src/ro"
                              "ot.cpp; /usr/include"),
              IsEmpty());
}

}  // namespace
}  // namespace higherpair::house

// Small numbers that decide something are defined in the header of tolerances of their room, each under a
// name of its own: rooms see each other's headers, and the linker would confuse two constants with the same
// name.
#include "house/tree.hpp"
#include "support/texts.hpp"

#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace higherpair::house {
namespace {

using ::testing::IsEmpty;
using testing::lines_are;

// The constants of a source whose values have a negative exponent.
std::vector<std::string> small_constants(const std::string& text) {
  static const std::regex declares(R"(constexpr [^(){}=;]*\b(k\w+)\b[^();]*[0-9.]e-[0-9])");
  std::vector<std::string> found;
  for (std::size_t at = text.find("constexpr "); at != std::string::npos;
       at = text.find("constexpr ", at + 1)) {
    const std::string statement = text.substr(at, text.find(';', at) - at);
    std::smatch match;
    if (std::regex_search(statement, match, declares, std::regex_constants::match_continuous)) {
      found.push_back(match[1]);
    }
  }
  return found;
}

// The numbers of a source with a negative exponent, outside comments and texts.
std::vector<std::string> small_numbers(const std::string& text) {
  static const std::regex comment_or_text(R"(//[^\n]*|"(?:[^"\\\n]|\\.)*")");
  static const std::regex number(R"(\b[0-9][0-9.]*e-[0-9]+)");
  const std::string code = std::regex_replace(text, comment_or_text, "");
  std::vector<std::string> found;
  for (std::sregex_iterator match(code.begin(), code.end(), number), end; match != end; ++match) {
    found.push_back(match->str());
  }
  return found;
}

// The constants that a header of tolerances defines.
std::vector<std::string> constants_of(const std::string& text) {
  static const std::regex defines(R"(\ninline constexpr [\w:]+(?: double)? (k\w+)(?= ?[={]))");
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), defines), end; match != end; ++match) {
    found.push_back((*match)[1]);
  }
  return found;
}

bool is_source_of_rooms(const std::string& path) {
  return (path.starts_with("include/") || path.starts_with("src/")) &&
         (path.ends_with(".hpp") || path.ends_with(".cpp"));
}

TEST(Tolerances, AreInTheHeaderOfTheirRoom) {
  // Public ones, and those that are not tolerances.
  const std::set<std::string> others = {"kConstraintTolerance", "kDefaultExportTolerance", "kLeastFitChance",
                                        "kQuarterPiRest", "kPrecisePi"};
  for (const auto& file : project_files()) {
    const std::string path = file.generic_string();
    if (is_source_of_rooms(path) && !path.ends_with("/tolerances.hpp")) {
      for (const std::string& name : small_constants(read_file(root() / file))) {
        EXPECT_TRUE(others.contains(name)) << path << ": " << name << " belongs in tolerances.hpp";
      }
    }
  }
}

TEST(Tolerances, HaveNames) {
  // The limit below which the shortest digits of a number need an exponent, and the differences of π and π/4
  // from their doubles.
  const std::set<std::string> others = {"1e-99", "1.2246467991473532e-16", "3.061616997868383e-17"};
  for (const auto& file : project_files()) {
    const std::string path = file.generic_string();
    if (is_source_of_rooms(path) && path.starts_with("src/") && !path.ends_with("/tolerances.hpp")) {
      for (const std::string& number : small_numbers(read_file(root() / file))) {
        EXPECT_TRUE(others.contains(number)) << path << ": " << number << " belongs in tolerances.hpp";
      }
    }
  }
}

TEST(Tolerances, ARoomHasOneHeaderOfThem) {
  std::map<std::string, std::vector<std::string>> headers;
  for (const auto& file : project_files()) {
    const std::string path = file.generic_string();
    if (is_source_of_rooms(path) && path.ends_with("/tolerances.hpp")) {
      headers[file.parent_path().filename().string()].push_back(path);
    }
  }
  EXPECT_GT(headers.size(), 5U);
  for (const auto& [room, paths] : headers) {
    EXPECT_EQ(paths.size(), 1U) << room << " has " << ::testing::PrintToString(paths);
  }
}

TEST(Tolerances, AConstantHasItsNameForItself) {
  std::map<std::string, std::vector<std::string>> places;
  for (const auto& file : project_files()) {
    const std::string path = file.generic_string();
    if (is_source_of_rooms(path) && path.ends_with(".hpp")) {
      for (const std::string& name : constants_of(read_file(root() / file))) {
        places[name].push_back(path);
      }
    }
  }
  EXPECT_GT(places.size(), 300U);
  for (const auto& [name, files] : places) {
    EXPECT_EQ(files.size(), 1U) << name << " is defined in " << ::testing::PrintToString(files);
  }
}

TEST(Tolerances, AreSeenInMadeUpSources) {
  EXPECT_TRUE(lines_are(small_constants("constexpr double kNear = 1e-9;  // of the size\n"
                                        "static constexpr double kFar =\n    2.5e-3 * kPi;\n"
                                        "constexpr std::array kSteps = {1e-3, 1e-4};\n"),
                        {"kNear", "kFar", "kSteps"}));
  EXPECT_THAT(small_constants("constexpr int kHalvings = 24;  // 2^-24 < 1e-7\n"
                              "constexpr double kLongest = 0.3;\n"
                              "constexpr double half(double x) { return x < 1e-9 ? 0 : x / 2; }\n"),
              IsEmpty());
  EXPECT_TRUE(
      lines_are(small_numbers("x < 1e-9 ? 2.5e-3 : 0;  // 1e-7\nreport(\"at \\\"1e-5\\\"\"); y = 1e9;\n"),
                {"1e-9", "2.5e-3"}));
  EXPECT_TRUE(lines_are(
      constants_of("\ninline constexpr double kNear = 1e-9;\ninline constexpr long double kTiny = 1;"
                   "\ninline constexpr std::array kSteps = {1.0};\n"),
      {"kNear", "kTiny", "kSteps"}));
}

}  // namespace
}  // namespace higherpair::house

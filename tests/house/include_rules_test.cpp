#include "house/include_rules.hpp"

#include "house/tree.hpp"
#include "support/texts.hpp"

#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace higherpair::house {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using testing::lines_are;

bool is_source(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".hpp" || extension == ".h" || extension == ".cpp" || extension == ".ipp";
}

TEST(IncludeRules, TheTreeKeepsThem) {
  int sources = 0;
  for (const auto& file : project_files()) {
    if (is_source(file)) {
      ++sources;
      EXPECT_THAT(include_violations(file, read_file(root() / file)), IsEmpty());
    }
  }
  EXPECT_GT(sources, 10) << "the tree was not found";
}

// The installed headers are those that the umbrella header includes; all others are private.
TEST(IncludeRules, PublicHeadersAreThoseThatTheFrontDoorIncludes) {
  const std::string folder = "include/";
  std::set<std::string> found;
  std::vector<std::string> open = {"higherpair/higherpair.hpp"};
  const std::regex include("#include \"(higherpair/[^\"]+)\"");
  while (!open.empty()) {
    const std::string header = open.back();
    open.pop_back();
    if (!found.insert(folder + header).second) {
      continue;
    }
    const std::string text = read_file(root() / (folder + header));
    for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match) {
      open.push_back((*match)[1]);
    }
  }
  for (const auto& file : project_files()) {
    if (file.string().starts_with(folder)) {
      EXPECT_THAT(found, Contains(file.string())) << "belongs in src/include";
    }
  }
}

TEST(IncludeRules, ARoomMayUseItselfAndTheRoomsBelow) {
  EXPECT_THAT(include_violations("include/higherpair/contact/track.hpp",
                                 "#pragma once\n"
                                 "#include \"higherpair/contact/pair.hpp\"\n"
                                 "#include \"higherpair/linkage/dyad.hpp\"\n"
                                 "#include <higherpair/geometry/curve.hpp>\n"),
              IsEmpty());
  EXPECT_THAT(include_violations("src/io/csv.cpp",
                                 "#include \"higherpair/dynamics/reactions.hpp\"\n"
                                 "#include \"higherpair/cam/law.hpp\"\n"),
              IsEmpty());
}

TEST(IncludeRules, AnIncludeThatPointsUpIsFoundWithItsLine) {
  EXPECT_TRUE(lines_are(
      include_violations("include/higherpair/geometry/curve.hpp",
                         "#pragma once\n\n  # include \"higherpair/contact/pair.hpp\"  // why not\n"),
      {"include/higherpair/geometry/curve.hpp:3: higherpair/contact/pair.hpp: "
       "geometry may not use contact"}));
  EXPECT_TRUE(lines_are(include_violations("src/linkage/dyad.cpp", "#include <higherpair/io/profile.hpp>\n"),
                        {"src/linkage/dyad.cpp:1: higherpair/io/profile.hpp: linkage may not use io"}));
}

TEST(IncludeRules, RoomsBesideEachOtherDoNotKnowEachOther) {
  EXPECT_TRUE(lines_are(include_violations("src/cam/law.cpp", "#include \"higherpair/analysis/table.hpp\"\n"),
                        {"src/cam/law.cpp:1: higherpair/analysis/table.hpp: cam may not use analysis"}));
}

TEST(IncludeRules, APrivateHeaderIsFoundByAnyOfItsNames) {
  EXPECT_THAT(include_violations("src/contact/track.cpp", "#include \"pencil.hpp\"\n"), IsEmpty());
  EXPECT_TRUE(lines_are(include_violations("src/contact/track.cpp", "#include \"../analysis/run.hpp\"\n"),
                        {"src/contact/track.cpp:1: ../analysis/run.hpp: contact may not use analysis"}));
  EXPECT_TRUE(lines_are(include_violations("src/contact/track.cpp", "#include \"analysis/run.hpp\"\n"),
                        {"src/contact/track.cpp:1: analysis/run.hpp: contact may not use analysis"}));
  EXPECT_TRUE(lines_are(include_violations("include/higherpair/io/csv.hpp", "#include \"io/writer.hpp\"\n"),
                        {"include/higherpair/io/csv.hpp:1: io/writer.hpp: "
                         "a public header includes a private one"}));
}

TEST(IncludeRules, HeadersThatRoomsShareKeepTheirOrder) {
  EXPECT_THAT(include_violations("src/include/higherpair/contact/box.hpp",
                                 "#include \"higherpair/geometry/curve.hpp\"\n"),
              IsEmpty());
  EXPECT_TRUE(lines_are(
      include_violations("src/include/higherpair/contact/box.hpp",
                         "#include \"higherpair/analysis/run.hpp\"\n#include \"contact/pencil.hpp\"\n"),
      {"src/include/higherpair/contact/box.hpp:1: higherpair/analysis/run.hpp: "
       "contact may not use analysis",
       "src/include/higherpair/contact/box.hpp:2: contact/pencil.hpp: "
       "a public header includes a private one"}));
}

TEST(IncludeRules, APrivateHeaderIsForItsOwnRoom) {
  for (const std::string header : {"analysis/step.hpp", "../analysis/step.hpp"}) {
    EXPECT_TRUE(
        lines_are(include_violations("src/dynamics/reactions.cpp", "#include \"" + header + "\"\n"),
                  {"src/dynamics/reactions.cpp:1: " + header + ": this header is private to analysis"}));
  }
  EXPECT_THAT(include_violations("src/contact/exact/exact_pair.hpp", "#include \"../extended.hpp\"\n"),
              IsEmpty());
}

TEST(IncludeRules, PrivateHeadersOfNumericAreForAllRooms) {
  EXPECT_THAT(include_violations("src/dynamics/statics.cpp", "#include \"numeric/least_norm.hpp\"\n"),
              IsEmpty());
  EXPECT_TRUE(lines_are(
      include_violations("include/higherpair/linkage/dyad.hpp", "#include \"numeric/least_norm.hpp\"\n"),
      {"include/higherpair/linkage/dyad.hpp:1: numeric/least_norm.hpp: "
       "a public header includes a private one"}));
  EXPECT_TRUE(lines_are(
      include_violations("src/numeric/least_norm.hpp", "#include \"higherpair/geometry/pose.hpp\"\n"),
      {"src/numeric/least_norm.hpp:1: higherpair/geometry/pose.hpp: numeric may not use geometry"}));
}

TEST(IncludeRules, TheLibraryDoesNotIncludeTestsOrTools) {
  EXPECT_TRUE(lines_are(include_violations("src/io/csv.cpp", "#include \"../../tests/house/tree.hpp\"\n"),
                        {"src/io/csv.cpp:1: ../../tests/house/tree.hpp: "
                         "the library does not include what is outside of it"}));
}

TEST(IncludeRules, PublicHeadersShowOnlyEigenAndExpected) {
  EXPECT_THAT(include_violations("include/higherpair/contact/pair.hpp",
                                 "#include <optional>\n"
                                 "#include <Eigen/Core>\n"
                                 "#include <tl/expected.hpp>\n"),
              IsEmpty());
  for (const std::string header : {"CGAL/Algebraic_kernel_d_1.h", "nlopt.hpp", "toml++/toml.h", "toml.hpp",
                                   "nlohmann/json.hpp", "CLI/CLI.hpp", "fmt/core.h", "boost/version.hpp"}) {
    EXPECT_TRUE(
        lines_are(include_violations("include/higherpair/contact/pair.hpp", "#include <" + header + ">\n"),
                  {"include/higherpair/contact/pair.hpp:1: " + header +
                   ": a public header includes only the standard library, Eigen and tl::expected"}));
  }
}

TEST(IncludeRules, ALibraryStaysInItsRoom) {
  EXPECT_THAT(include_violations("src/contact/exact.cpp", "#include <CGAL/Gmpz.h>\n"), IsEmpty());
  EXPECT_THAT(include_violations("src/io/profile.cpp", "#include <toml++/toml.h>\n"), IsEmpty());
  EXPECT_THAT(include_violations("src/numeric/arena.hpp", "#include <tbb/parallel_for.h>\n"), IsEmpty());
  EXPECT_TRUE(lines_are(include_violations("src/analysis/run.cpp", "#include <tbb/parallel_for.h>\n"),
                        {"src/analysis/run.cpp:1: tbb/parallel_for.h: this library belongs to numeric"}));
  EXPECT_TRUE(lines_are(include_violations("src/analysis/run.cpp", "#include <CGAL/Gmpz.h>\n"),
                        {"src/analysis/run.cpp:1: CGAL/Gmpz.h: this library belongs to contact"}));
  EXPECT_TRUE(lines_are(include_violations("src/io/profile.cpp", "#include <CLI/CLI.hpp>\n"),
                        {"src/io/profile.cpp:1: CLI/CLI.hpp: this library is for tools"}));
}

TEST(IncludeRules, AFileOrHeaderInNoRoomIsFound) {
  EXPECT_TRUE(lines_are(include_violations("include/higherpair/everything.hpp", ""),
                        {"include/higherpair/everything.hpp: the file stands in no room that we know"}));
  EXPECT_THAT(
      include_violations("include/higherpair/higherpair.hpp", "#include \"higherpair/front/model.hpp\"\n"),
      IsEmpty());
  EXPECT_TRUE(lines_are(include_violations("src/attic/box.cpp", ""),
                        {"src/attic/box.cpp: the file stands in no room that we know"}));
  EXPECT_TRUE(lines_are(include_violations("src/io/csv.cpp", "#include \"higherpair/everything.hpp\"\n"),
                        {"src/io/csv.cpp:1: higherpair/everything.hpp: "
                         "the header stands in no room that we know"}));
}

TEST(IncludeRules, TestsAndToolsAreFree) {
  EXPECT_THAT(include_violations("tools/cli/main.cpp", "#include <CLI/CLI.hpp>\n#include <CGAL/Gmpz.h>\n"),
              IsEmpty());
  EXPECT_THAT(include_violations("tests/io/csv_test.cpp", "#include <nlohmann/json.hpp>\n"), IsEmpty());
}

}  // namespace
}  // namespace higherpair::house

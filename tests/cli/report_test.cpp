// The command `report`: what it writes, what it refuses, and how it ends.
#include "program_testing.hpp"
#include "support/texts.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>

namespace {

using higherpair::testing::contains;
using higherpair::testing::contains_all;
using higherpair::testing::Outcome;
using higherpair::testing::ProgramTest;
using higherpair::testing::read_file;
using higherpair::testing::shipped_profile;
namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string report_profile(const std::string& name) {
  return shipped_profile(name + ".toml");
}

std::string quoted(const fs::path& path) {
  std::string text = "'";
  text += path.string();
  return text += '\'';
}

class Report : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    has_page_ = run(report_profile("knife_edge") + " -o " + quoted(page_)).code == 0;
    fs::remove(page_);
  }

  [[nodiscard]] Outcome run(const std::string& arguments) const { return run_program("report " + arguments); }
  [[nodiscard]] std::string to_page() const { return " -o " + quoted(page_); }

  const fs::path page_ = folder_ / "a page.html";
  bool has_page_ = false;
};

TEST_F(Report, SaysWhatIsMissingWhereThePageWasNotBuilt) {
  if (has_page_) GTEST_SKIP() << "this build has the page";
  const Outcome outcome = run(report_profile("knife_edge") + to_page());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains_all(outcome.err, {"built without the page", "HIGHERPAIR_REPORT=ON"}));
  EXPECT_FALSE(fs::exists(page_));
}

// The force is least in both dwells, and the torque as large in one sense as in the other; speeds have no
// sign.
TEST_F(Report, NamesTheFirstOfEqualExtremes) {
  if (!has_page_) GTEST_SKIP() << "this build has no page";
  EXPECT_EQ(run(report_profile("checked_cam") + to_page()).code, 0);
  const std::string page = read_file(page_);
  const auto fact = [&](const std::string& name) {
    const std::size_t begin = page.find("\"name\":\"" + name + "\"");
    return page.substr(begin, page.find("]}", begin) - begin);
  };
  EXPECT_TRUE(contains(fact("Min. force"), "\"driver\":0,"));
  EXPECT_TRUE(contains(fact("Max. driving torque"), "\"driver\":57,"));
  EXPECT_TRUE(contains(fact("Max. pressure angle"), "\"driver\":54,"));
  EXPECT_TRUE(contains(fact("Max. speed"), "\"value\":1200,"));
  EXPECT_TRUE(contains_all(fact("Max. sliding"), {"\"value\":2513.27", "\"driver\":120,"}));
}

TEST_F(Report, WritesOnePageThatAsksForNothing) {
  if (!has_page_) GTEST_SKIP() << "this build has no page";
  EXPECT_EQ(run(report_profile("knife_edge") + to_page()).code, 0);
  const std::string page = read_file(page_);
  EXPECT_TRUE(contains_all(page, {"<!doctype html>", "default-src 'none'", "</html>"}));
  EXPECT_THAT(page, AllOf(Not(HasSubstr("src=")), Not(HasSubstr("@REPORT_DATA@"))));
}

TEST_F(Report, EscapesWhatTheProfileSays) {
  if (!has_page_) GTEST_SKIP() << "this build has no page";
  EXPECT_EQ(run(report_profile("knife_edge") + to_page() + " --set 'title=\"</script><b>x\"'").code, 0);
  EXPECT_THAT(read_file(page_), AllOf(HasSubstr("\\u003c/script>\\u003cb>x"), Not(HasSubstr("<b>x"))));
}

TEST_F(Report, WritesTheMotionInTimeAndWithOtherNumbersOfRows) {
  if (!has_page_) GTEST_SKIP() << "this build has no page";
  EXPECT_EQ(
      run(report_profile("eccentric_disc_oscillating_roller") + to_page() + " --time --samples 11").code, 0);
  EXPECT_TRUE(contains_all(read_file(page_), {"\"name\":\"time\"", "\"size\":11,"}));
}

TEST_F(Report, ThinsALongRunButKnowsItsExtremes) {
  if (!has_page_) GTEST_SKIP() << "this build has no page";
  const Outcome outcome = run(report_profile("knife_edge") + to_page() + " --samples 20001");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(
      contains(outcome.err, "the page holds one in 14 of 20001 rows; its extremes and events are of all"));
  EXPECT_LT(fs::file_size(page_), 2U << 20U);
  EXPECT_TRUE(contains(read_file(page_), "\"size\":20001,"));
  EXPECT_FALSE(contains(run(report_profile("knife_edge") + to_page()).err, "the page holds"));
}

TEST_F(Report, IsWrittenThoughThePathIsNotGood) {
  if (!has_page_) GTEST_SKIP() << "this build has no page";
  const Outcome outcome = run(report_profile("lock_up") + to_page());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.err, "limit_position"));
  EXPECT_TRUE(fs::exists(page_));
}

TEST_F(Report, IsNotWrittenForWhatCannotBeStarted) {
  if (!has_page_) GTEST_SKIP() << "this build has no page";
  EXPECT_EQ(run(report_profile("lock_up") + to_page() + " --set driver.start=180").code, 3);
  EXPECT_FALSE(fs::exists(page_));
}

TEST_F(Report, RefusesPlacesThatCannotHoldAPage) {
  const std::string knife = report_profile("knife_edge");
  const auto refuses = [&](const std::string& arguments, const std::string& message) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_TRUE(contains(outcome.err, message)) << arguments;
  };
  refuses(knife, "--output is required");
  refuses(knife + " -o " + quoted(folder_ / "page.txt"), "give it a name that ends in .html");
  refuses(knife + to_page() + " --samples -3", "samples");
  fs::copy_file(knife, page_);
  refuses(quoted(page_) + to_page(), "is the file that is read as FILE");
  EXPECT_EQ(read_file(page_), read_file(knife));
}

}  // namespace

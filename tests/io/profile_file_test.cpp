#include "higherpair/io/profile_reader.hpp"
#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::crank_profile;
using ::testing::ElementsAre;
using testing::lines_are;
using testing::messages;
using testing::part;
using testing::read;

// A temporary folder of its own.
class ProfileFile : public ::testing::Test {
protected:
  ProfileFile()
      : folder_(std::filesystem::temp_directory_path() /
                ("higherpair_profile_file_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~ProfileFile() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  [[nodiscard]] std::string write(const std::string& text) const {
    std::ofstream(path("a.toml"), std::ios::binary) << text;
    return path("a.toml");
  }

  static std::string only_message(const std::string& path) {
    const auto profile = read_profile_file(path);
    if (profile || profile.error().size() != 1) return "(not one message)";
    return to_string(profile.error().front());
  }

private:
  std::filesystem::path folder_;
};

TEST_F(ProfileFile, IsReadWithItsOverrides) {
  const testing::Overrides overrides = {"driver.samples=7"};
  const auto profile = read_profile_file(write(crank_profile()), overrides);
  ASSERT_TRUE(profile);
  EXPECT_EQ(profile->programs[0].samples, 7);
  EXPECT_EQ(profile->programs[0].place.source, path("a.toml"));
}

TEST_F(ProfileFile, LongerThanABlockIsReadWhole) {
  std::string text = crank_profile("positions = [");
  for (int i = 0; i < 50'000; ++i) text += std::to_string(i) + ", ";
  const auto profile = read_profile_file(write(text + "]\n"));
  ASSERT_TRUE(profile);
  EXPECT_EQ(profile->programs[0].positions.size(), 50'000U);
  EXPECT_EQ(profile->programs[0].positions.back(), 49'999);
}

TEST_F(ProfileFile, ThatDoesNotExistIsReportedWithTheReason) {
  EXPECT_EQ(only_message(path("none.toml")),
            path("none.toml") + ": cannot be opened: No such file or directory");
}

TEST_F(ProfileFile, ThatIsADirectoryIsReportedWithTheReason) {
  EXPECT_EQ(only_message(path("")), path("") + ": cannot be read: Is a directory");
}

TEST_F(ProfileFile, ThatIsNoTextIsReportedWithThePlace) {
  std::string garbage = "a = 1\nb = ";
  for (int i = 255; i > 0; --i) garbage += static_cast<char>(i);
  EXPECT_TRUE(contains(only_message(write(garbage)), "a.toml:2:"));
  EXPECT_TRUE(contains(only_message(write(std::string(1000, '\0'))), "a.toml:1:"));
}

TEST(ProfileText, MayBeginWithAByteOrderMarkAndEndItsLinesWithCarriageReturns) {
  std::string text = "\xef\xbb\xbf";
  for (const char c : crank_profile("samples = 5\n")) {
    text += c == '\n' ? "\r\n" : std::string(1, c);
  }
  EXPECT_EQ(read(text).programs[0].samples, 5);
}

TEST(ProfileText, ThatIsEmptyLacksADriver) {
  const std::string message =
      "test.toml:1:1: driver is missing: add a table [driver] with joint = \"...\", the joint that is driven";
  EXPECT_THAT(messages(""), ElementsAre(message));
  EXPECT_THAT(messages("# nothing but a comment\n"), ElementsAre(message));
}

TEST(ProfileText, WithAMistakeOfSyntaxReportsTheFirstOne) {
  EXPECT_TRUE(lines_are(messages("title = \"x\n[bodies\n"), {part("test.toml:1:9: ")}));
  EXPECT_TRUE(lines_are(messages(crank_profile("[joints.pivot]\n")), {part("test.toml:12:")}));
}

TEST(ProfileText, NestedTooDeepIsNoProfile) {
  std::string key = "a";
  for (int i = 0; i < 300'000; ++i) key += ".a";
  EXPECT_TRUE(lines_are(messages(key + " = 1\n"), {part("too many dotted parts")}));
  EXPECT_TRUE(lines_are(messages("a = " + std::string(100'000, '[')), {part("test.toml:1:")}));
}

}  // namespace
}  // namespace higherpair

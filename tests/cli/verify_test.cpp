#include "support/texts.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using higherpair::testing::contains;

namespace fs = std::filesystem;

struct Verdict {
  int code = -1;
  std::string out;
};

Verdict verify(const std::string& arguments) {
  std::FILE* pipe = popen((std::string(HIGHERPAIR_PROGRAM) + " verify " + arguments + " 2>&1").c_str(), "r");
  Verdict outcome;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
    outcome.out += static_cast<char>(c);
  }
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

std::string reference(const std::string& name) {
  return std::string(HIGHERPAIR_SOURCE_DIR) + "/tools/cli/verify/" + name;
}

// A shipped table with one piece of text replaced, in a file that is removed with the object.
class ChangedTable {
public:
  ChangedTable(const std::string& name, const std::string& from, const std::string& to)
      : path_(fs::temp_directory_path() / ("higherpair-verify-" + std::to_string(getpid()) + ".csv")) {
    std::ostringstream text;
    text << std::ifstream(reference(name)).rdbuf();
    std::string table = text.str();
    const std::size_t at = table.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    std::ofstream(path_) << (at == std::string::npos ? table : table.replace(at, from.size(), to));
  }
  ~ChangedTable() { fs::remove(path_); }
  ChangedTable(const ChangedTable&) = delete;
  ChangedTable& operator=(const ChangedTable&) = delete;

  [[nodiscard]] std::string path() const { return path_.string(); }

private:
  fs::path path_;
};

TEST(Verify, HoldsForEveryReferenceThatIsShipped) {
  const Verdict outcome = verify("--json -");
  ASSERT_EQ(outcome.code, 0) << outcome.out;
  const auto json = nlohmann::json::parse(outcome.out);
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(reference(""))) {
    files += entry.path().extension() == ".toml" ? 1 : 0;
  }
  EXPECT_GE(files, 10U);
  EXPECT_EQ(json.at("references").size(), files);
  for (const nlohmann::json& one : json.at("references")) {
    EXPECT_TRUE(one.at("ok").get<bool>()) << one;
    EXPECT_FALSE(one.at("source").get<std::string>().empty()) << one;
    EXPECT_GT(one.at("seconds").get<double>(), 0) << one;
    EXPECT_GE(one.at("columns").size(), 2U) << one;
  }
}

TEST(Verify, PrintsValueErrorAndTime) {
  const Verdict outcome = verify("");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(contains(outcome.out, "ok     Watt six-bar\n"));
  EXPECT_TRUE(contains(outcome.out, "wheel_pivot.velocity[deg/s]"));
  EXPECT_TRUE(contains(outcome.out, "microseconds"));
  EXPECT_FALSE(contains(outcome.out, "FAILED"));
  EXPECT_EQ(verify("--quiet").out, "");
}

TEST(Verify, FailsWhereOneDigitOfATableIsWrong) {
  // At the first position the rocker turns exactly as fast as the coupler, at 20 rad/s.
  const ChangedTable table("four_bar_plus.csv", ",20.0,", ",20.00000001,");
  const Verdict outcome = verify(reference("four_bar_plus.toml") + " " + table.path());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.out, "FAILED"));
  EXPECT_TRUE(contains(outcome.out, "expected 20.00000001"));
  EXPECT_EQ(verify(reference("four_bar_plus.toml") + " " + table.path() + " --bound 1e-8").code, 0);
}

TEST(Verify, FailsWhereTheRunHasNoSuchColumnOrRow) {
  const ChangedTable column("geneva_wheel.csv", "wheel_pivot.velocity", "no_pivot.velocity");
  const Verdict outcome = verify(reference("geneva_wheel.toml") + " " + column.path());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.out, "there is no column no_pivot.velocity[deg/s]"));
  EXPECT_TRUE(contains(verify(reference("geneva_wheel.toml") + " " + reference("pin_in_slot.csv")).out,
                       "there is no column"));
}

// Every column of a run that locks in part of its turn: words, empty fields, and columns of rounding only.
TEST(Verify, ReadsTheProgramsOwnTables) {
  const std::string profile = std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/lock_up.toml";
  const fs::path table =
      fs::temp_directory_path() / ("higherpair-verify-own-" + std::to_string(getpid()) + ".csv");
  const std::string run = std::string(HIGHERPAIR_PROGRAM) + " analyze --quiet " + profile;
  ASSERT_EQ(WEXITSTATUS(std::system((run + " --csv " + table.string()).c_str())), 4);
  const Verdict same = verify(profile + " " + table.string());
  EXPECT_EQ(same.code, 0) << same.out;
  EXPECT_FALSE(contains(same.out, "residual"));
  ASSERT_EQ(std::system(("sed -i s/not_assemblable/singular/ " + table.string()).c_str()), 0);
  const Verdict other = verify(profile + " " + table.string());
  EXPECT_EQ(other.code, 4);
  EXPECT_TRUE(contains(other.out, "status is not_assemblable, expected singular"));
  fs::remove(table);
}

TEST(Verify, FailsWhereTheTableIsNoTable) {
  const ChangedTable table("geneva_wheel.csv", "-45.0,", "-45.0x,");
  const Verdict outcome = verify(reference("geneva_wheel.toml") + " " + table.path());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.out, "table row 1: '-45.0x' is no number"));
}

TEST(Verify, TakesNoInfinityForANumber) {
  for (const char* wrong : {"inf,", "nan,", "1e400,"}) {
    const ChangedTable table("geneva_wheel.csv", "-45.0,", wrong);
    EXPECT_EQ(verify(reference("geneva_wheel.toml") + " " + table.path()).code, 4) << wrong;
  }
}

TEST(Verify, RefusesFilesThatItCannotRead) {
  EXPECT_EQ(verify("no_such.toml no_such.csv").code, 2);
  EXPECT_EQ(verify(reference("geneva_wheel.toml")).code, 2);
  EXPECT_EQ(verify(reference("geneva_wheel.toml") + " " + reference("")).code, 2);
  EXPECT_EQ(verify(reference("geneva_wheel.csv") + " " + reference("geneva_wheel.csv")).code, 2);
  EXPECT_EQ(verify("--json /dev/full").code, 1);
}

}  // namespace

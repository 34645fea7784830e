// Everything that the README and the pages of docs/ show is real: commands run, profiles are analysed, the
// README's C++ is the program that the install test compiles, and paths and links lead somewhere. Blocks are
// distinguished by their language:
//   sh, console    commands; those of higherpair are run, in console blocks with the output shown
//   toml           a whole profile
//   toml fragment  part of a profile
//   cpp, cmake     README: parts of tests/install; the programs of docs/library.md run in tests/library
//   text           nothing to run
#include "house/readme.hpp"

#include "house/tree.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <sys/wait.h>
#include <utility>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace higherpair::house {
namespace {

namespace fs = std::filesystem;
using testing::contains;
using ::testing::ElementsAre;
using testing::lines_are;

std::string readme() {
  return read_file(root() / "README.md");
}

// The README and the pages of docs/, relative to the root.
std::vector<fs::path> pages() {
  std::vector<fs::path> pages = {"README.md"};
  for (const fs::path& file : project_files()) {
    if (file.parent_path() == "docs" && file.extension() == ".md") {
      pages.push_back(file);
    }
  }
  return pages;
}

struct ShownBlock : Block {
  std::string place;  // page and line
};

std::vector<ShownBlock> all_blocks() {
  std::vector<ShownBlock> blocks;
  for (const fs::path& page : pages()) {
    for (const Block& block : fenced_blocks(read_file(root() / page))) {
      blocks.push_back({block, page.string() + ":" + std::to_string(block.line)});
    }
  }
  return blocks;
}

std::vector<ShownBlock> blocks_in(const std::set<std::string>& languages) {
  std::vector<ShownBlock> chosen;
  for (const ShownBlock& block : all_blocks()) {
    if (languages.contains(block.language)) {
      chosen.push_back(block);
    }
  }
  return chosen;
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  std::string word;
  while (stream >> word) {
    words.push_back(word);
  }
  return words;
}

// A folder in which the commands of the pages work as in the root of the tree without leaving anything there.
class ReadmeCommands : public ::testing::Test {
protected:
  void SetUp() override {
    if (!fs::exists(fs::path(HIGHERPAIR_PROGRAM_DIR) / "higherpair")) {
      GTEST_SKIP() << "the program is not part of this build";
    }
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::path(HIGHERPAIR_PROGRAM_DIR).parent_path().parent_path() / "readme_test" / name;
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "out");
    fs::create_directory_symlink(root() / "profiles", folder_ / "profiles");
  }

  struct Outcome {
    int exit_code = -1;
    std::string output;
    std::string errors;
  };

  [[nodiscard]] Outcome run(const std::string& command) const {
    const std::string script = "cd '" + folder_.string() +
                               "' && PATH='" HIGHERPAIR_PROGRAM_DIR "':\"$PATH\" && (" + command +
                               ") >output.txt 2>errors.txt </dev/null";
    const int status = std::system(script.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder_ / "output.txt"),
            read_file(folder_ / "errors.txt")};
  }

  fs::path folder_;
};

TEST_F(ReadmeCommands, OfHigherpairRunAndPrintWhatIsShown) {
  for (const ShownBlock& block : blocks_in({"sh", "console"})) {
    for (const Command& command : commands_of(block)) {
      if (words_of(command.line).front() != "higherpair") {
        continue;
      }
      const Outcome outcome = run(command.line);
      EXPECT_EQ(outcome.exit_code, 0) << block.place << ": " << command.line << "\n" << outcome.errors;
      if (block.language == "console") {
        EXPECT_TRUE(matches_with_gaps(outcome.output, command.output))
            << command.line << "\nprints\n"
            << outcome.output << "and " << block.place << " shows\n"
            << command.output;
      }
    }
  }
}

TEST_F(ReadmeCommands, AnalyseTheProfilesThatAreShown) {
  for (const ShownBlock& block : blocks_in({"toml"})) {
    std::ofstream(folder_ / "shown.toml") << block.text;
    const Outcome outcome = run("higherpair analyze shown.toml --quiet");
    EXPECT_EQ(outcome.exit_code, 0) << block.place;
    EXPECT_EQ(outcome.errors, "") << block.place;
  }
}

TEST(Pages, AreTheReadmeAndThoseOfDocs) {
  EXPECT_THAT(pages(), ::testing::IsSupersetOf({fs::path("README.md"), fs::path("docs/profiles.md"),
                                                fs::path("docs/results.md"), fs::path("docs/method.md")}));
}

TEST(Pages, HaveBlocksOfEveryKindThatIsChecked) {
  std::set<std::string> kinds = {"sh", "console", "toml", "cpp", "cmake"};
  for (const std::string& kind : kinds) EXPECT_FALSE(blocks_in({kind}).empty()) << kind;
  kinds.insert({"toml fragment", "text"});
  for (const ShownBlock& block : all_blocks()) {
    EXPECT_TRUE(kinds.contains(block.language)) << block.place << ": " << block.language;
  }
}

// Except for the character that marks omitted lines.
TEST(Pages, ShowAsciiInTheirBlocks) {
  for (const ShownBlock& block : all_blocks()) {
    std::istringstream lines(block.text);
    for (std::string line; std::getline(lines, line);) {
      const bool ascii = std::all_of(line.begin(), line.end(), [](unsigned char c) { return c < 128; });
      EXPECT_TRUE(ascii || line == "…") << block.place << ": " << line;
    }
  }
}

// Without the file that it writes.
std::string without_output(const std::string& command) {
  return std::regex_replace(command, std::regex(" -o \\S+"), "");
}

TEST(Pages, ShowThePicturesOfTheCommandsAboveThem) {
  std::map<std::string, std::string> made;  // picture: its command
  for (const Block& block : fenced_blocks(read_file(root() / "docs/pictures/README.md"))) {
    for (const Command& command : commands_of(block)) {
      const std::vector<std::string> words = words_of(command.line);
      const auto option = std::find(words.begin(), words.end(), "-o");
      ASSERT_LT(option + 1, words.end());
      made["pictures/" + fs::path(*(option + 1)).filename().string()] = without_output(command.line);
    }
  }
  const std::string page = read_file(root() / "docs/drawing.md");
  const std::regex shown("```sh\n(higherpair [^\n]+)\n```\n\n!\\[[^\n]*\\]\\(([^)]+)\\)");
  int count = 0;
  for (auto match = std::sregex_iterator(page.begin(), page.end(), shown); match != std::sregex_iterator();
       ++match, ++count) {
    EXPECT_EQ(without_output((*match)[1].str()), made[(*match)[2].str()]) << (*match)[2].str();
  }
  EXPECT_GE(count, 4);
}

TEST(Readme, ShowsTheTwoCommandsOnItsFirstScreen) {
  const std::vector<Block> blocks = fenced_blocks(readme());
  ASSERT_FALSE(blocks.empty());
  EXPECT_LT(blocks.front().line, 25);
  EXPECT_TRUE(contains(blocks.front().text, "tools/demo"));
  EXPECT_TRUE(contains(blocks.front().text, "tools/test"));
}

TEST(Pages, CommandsNameScriptsAndPresetsThatExist) {
  const auto presets = nlohmann::json::parse(read_file(root() / "CMakePresets.json"));
  std::set<std::string> names;
  for (const auto& preset : presets["configurePresets"]) {
    names.insert(preset["name"].get<std::string>());
  }
  for (const ShownBlock& block : blocks_in({"sh", "console"})) {
    for (const Command& command : commands_of(block)) {
      const std::vector<std::string> words = words_of(command.line);
      const std::string& program = words.front();
      if (program.starts_with("tools/")) {
        const auto permissions = fs::status(root() / program).permissions();
        EXPECT_NE(permissions & fs::perms::owner_exec, fs::perms::none) << command.line;
      } else {
        EXPECT_THAT(program, ::testing::AnyOf("cmake", "ctest", "higherpair")) << command.line;
      }
      for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        EXPECT_TRUE(words[i] != "--preset" || names.contains(words[i + 1])) << command.line;
      }
    }
  }
}

TEST(Readme, ShowsTheProgramThatTheInstallTestCompiles) {
  std::vector<std::string> examples;
  for (const Block& block : fenced_blocks(readme())) {
    if (block.language == "cpp") {
      examples.push_back(block.text);
    }
  }
  EXPECT_THAT(examples, ElementsAre(read_file(root() / "tests/install/main.cpp")));
}

TEST(Readme, ShowsCMakeLinesThatTheInstallTestRuns) {
  const std::string project = read_file(root() / "tests/install/CMakeLists.txt");
  for (const ShownBlock& block : blocks_in({"cmake"})) {
    EXPECT_TRUE(contains(project, block.text)) << block.place;
  }
}

// The matches of `pattern` on the pages, with the page.
std::vector<std::pair<fs::path, std::string>> catches(const std::regex& pattern) {
  std::vector<std::pair<fs::path, std::string>> caught;
  for (const fs::path& page : pages()) {
    const std::string text = read_file(root() / page);
    for (auto match = std::sregex_iterator(text.begin(), text.end(), pattern);
         match != std::sregex_iterator(); ++match) {
      caught.emplace_back(page, (*match)[1].str());
    }
  }
  return caught;
}

TEST(Pages, PathsInBackticksExist) {
  const auto paths = catches(std::regex("`((include|src|tests|tools|profiles|cmake|docs)/[\\w./-]*)`"));
  EXPECT_GT(paths.size(), 10U);
  for (const auto& [page, path] : paths) {
    EXPECT_TRUE(fs::exists(root() / path)) << page << ": " << path;
  }
}

TEST(Pages, HeadersInBackticksExist) {
  const auto headers = catches(std::regex("`(\\w+/\\w+\\.hpp)`"));
  EXPECT_GT(headers.size(), 5U);
  for (const auto& [page, header] : headers) {
    EXPECT_TRUE(fs::exists(root() / "include/higherpair" / header) ||
                fs::exists(root() / "src/include/higherpair" / header))
        << page << ": " << header;
  }
}

TEST(Pages, LinksToEachOtherLeadSomewhere) {
  const auto links = catches(std::regex("\\]\\(([\\w./-]+)\\)"));
  EXPECT_GT(links.size(), 5U);
  for (const auto& [page, link] : links) {
    EXPECT_TRUE(fs::exists(root() / page.parent_path() / link)) << page << ": " << link;
  }
}

TEST(FencedBlocks, AreFoundWithLanguageAndLine) {
  const auto blocks = fenced_blocks("a\n```sh\nls\n\n```\nb\n```\nplain\n```\n");
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_EQ(blocks[0].line, 2);
  EXPECT_EQ(blocks[0].language, "sh");
  EXPECT_EQ(blocks[0].text, "ls\n\n");
  EXPECT_EQ(blocks[1].line, 7);
  EXPECT_EQ(blocks[1].language, "");
  EXPECT_EQ(blocks[1].text, "plain\n");
}

TEST(Commands, OfAScriptAreItsLinesWithoutComments) {
  std::vector<std::string> lines;
  for (const Command& command : commands_of({1, "sh", "# first\nls -l   # all\n\ncp a \\\n  b\n"})) {
    lines.push_back(command.line);
  }
  EXPECT_TRUE(lines_are(lines, {"ls -l", "cp a   b"}));
}

TEST(Commands, OfAConsoleCarryTheirOutput) {
  const auto commands = commands_of({1, "console", "$ echo a\na\n$ true\n"});
  ASSERT_EQ(commands.size(), 2U);
  EXPECT_EQ(commands[0].line, "echo a");
  EXPECT_EQ(commands[0].output, "a\n");
  EXPECT_EQ(commands[1].line, "true");
  EXPECT_EQ(commands[1].output, "");
}

TEST(MatchesWithGaps, TakesAnEllipsisForAnyLines) {
  EXPECT_TRUE(matches_with_gaps("a\nb\nc\n", "a\nb\nc\n"));
  EXPECT_TRUE(matches_with_gaps("a\nb\nc\n", "a\n…\n"));
  EXPECT_TRUE(matches_with_gaps("a\nb\nc\n", "…\nb\n…\nc\n"));
  EXPECT_FALSE(matches_with_gaps("a\nb\nc\n", "a\nb\n"));
  EXPECT_FALSE(matches_with_gaps("a\nb\nc\n", "a\n…\nd\n"));
  EXPECT_FALSE(matches_with_gaps("a\nb\n", "a\nb\nc\n"));
}

}  // namespace
}  // namespace higherpair::house

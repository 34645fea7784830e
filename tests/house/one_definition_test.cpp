// The linker would confuse two types with the same name where a function of either is not inlined: a type's
// name may occur only once per namespace in the library.
#include "house/tree.hpp"

#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace higherpair::house {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// The types that a formatted source defines outside unnamed namespaces, with their namespaces.
std::set<std::string> shared_types(const std::string& text) {
  static const std::regex opens(R"((?:inline )?namespace ?([\w:]*) ?\{.*)");
  static const std::regex closes(R"(\}  // namespace.*)");
  static const std::regex defines(
      R"((?:struct|class|enum class) (?:\[\[\w+\]\] )?(\w+)(?!\w|<|::|;)(?:.*\{.*|.*[^;]|))");
  std::vector<std::string> spaces;
  std::set<std::string> found;
  std::istringstream lines(text);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, opens)) {
      spaces.push_back(match[1]);
    } else if (std::regex_match(line, closes)) {
      spaces.pop_back();
    } else if (std::regex_match(line, match, defines)) {
      std::string name;
      bool hidden = false;
      for (const std::string& space : spaces) {
        hidden = hidden || space.empty();
        name += space + "::";
      }
      if (!hidden) found.insert(name + match[1].str());
    }
  }
  return found;
}

TEST(OneDefinition, ATypeOfTheLibraryHasItsNameForItself) {
  std::map<std::string, std::vector<std::string>> places;
  for (const auto& file : project_files()) {
    const std::string path = file.generic_string();
    const bool is_source = path.ends_with(".hpp") || path.ends_with(".cpp");
    if (is_source &&
        (path.starts_with("include/") || path.starts_with("src/") || path.starts_with("tools/cli/"))) {
      for (const std::string& type : shared_types(read_file(root() / file))) {
        places[type].push_back(path);
      }
    }
  }
  EXPECT_GT(places.size(), 100U);
  for (const auto& [type, files] : places) {
    EXPECT_EQ(files.size(), 1U) << type << " is defined in " << ::testing::PrintToString(files);
  }
}

TEST(OneDefinition, IsSeenInMadeUpSources) {
  EXPECT_THAT(shared_types("namespace a {\nstruct B {\n};\nnamespace c {\nclass D final : public B {\n};\n"
                           "enum class E { kOne };\n}  // namespace c\n}  // namespace a\n"),
              ElementsAre("a::B", "a::c::D", "a::c::E"));
  EXPECT_THAT(
      shared_types("namespace a {\nnamespace {\nstruct B {\n};\n}  // namespace\nstruct C;\nstruct B::D {\n"
                   "};\n}  // namespace a\n"),
      IsEmpty());
}

}  // namespace
}  // namespace higherpair::house

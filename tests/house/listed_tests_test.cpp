// A test file that its folder's CMakeLists.txt does not list would never run, and never fail.
#include "house/tree.hpp"

#include <filesystem>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair::house {
namespace {

TEST(ListedTests, EveryTestFileIsBuilt) {
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root() / "tests")) {
    const std::filesystem::path& file = entry.path();
    if (!file.string().ends_with("_test.cpp")) {
      continue;
    }
    const std::string list = read_file(file.parent_path() / "CMakeLists.txt");
    const std::string name = file.filename().string();
    // Tests of exact arithmetic are listed under a condition.
    EXPECT_TRUE(list.find(" " + name) != std::string::npos || list.find(":" + name) != std::string::npos)
        << file;
    ++count;
  }
  EXPECT_GT(count, 50);
}

}  // namespace
}  // namespace higherpair::house

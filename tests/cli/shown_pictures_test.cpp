// The pictures of the documentation are the same as what the program draws.
#include "program_testing.hpp"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>

namespace {

using higherpair::testing::read_file;

namespace fs = std::filesystem;

// Equal except for the last digits of numbers, which other compilers may round differently.
bool is_alike(const std::string& a, const std::string& b) {
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    const auto begins_number = [](const std::string& text, std::size_t at) {
      return std::isdigit(static_cast<unsigned char>(text[at])) != 0 || text[at] == '-';
    };
    if (!begins_number(a, i) || !begins_number(b, k)) {
      if (a[i++] != b[k++]) return false;
      continue;
    }
    char *end_a = nullptr, *end_b = nullptr;
    const double x = std::strtod(&a[i], &end_a), y = std::strtod(&b[k], &end_b);
    if (!(std::abs(x - y) <= 0.011)) return false;
    if (end_a == &a[i] || end_b == &b[k]) {
      if (a[i++] != b[k++]) return false;
      continue;
    }
    i = static_cast<std::size_t>(end_a - a.data());
    k = static_cast<std::size_t>(end_b - b.data());
  }
  return i == a.size() && k == b.size();
}

TEST(Pictures, AreCurrent) {
  const fs::path root = HIGHERPAIR_SOURCE_DIR;
  const fs::path folder = fs::temp_directory_path() / ("higherpair-pictures-" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::ifstream list(root / "docs/pictures/README.md");
  int count = 0;
  for (std::string line; std::getline(list, line);) {
    if (line.rfind("higherpair ", 0) != 0) continue;
    const std::string option = " -o ";
    const std::size_t at = line.find(option) + option.size();
    const std::string picture = line.substr(at, line.find(' ', at) - at);
    const fs::path made = folder / fs::path(picture).filename();
    line.replace(at, picture.size(), made.string());
    line.replace(0, std::string("higherpair").size(), HIGHERPAIR_PROGRAM);
    const std::string command = "cd " + root.string() + " && " + line + " >/dev/null 2>&1";
    (void)std::system(command.c_str());
    EXPECT_TRUE(is_alike(read_file(made), read_file(root / picture)))
        << picture
        << " is not what the program draws: make it anew with the command in docs/pictures/README.md";
    ++count;
  }
  EXPECT_GE(count, 6);
  fs::remove_all(folder);
}

TEST(Pictures, AreToldApart) {
  EXPECT_TRUE(is_alike("M1.5 -2 L3 4", "M1.505 -2 L3 4.00001"));
  EXPECT_FALSE(is_alike("M1.5 -2 L3 4", "M1.6 -2 L3 4"));
  EXPECT_FALSE(is_alike("M1.5 -2 L3 4", "M1.5 -2 L3 4 5"));
  EXPECT_FALSE(is_alike("a", "b"));
}

}  // namespace

#include "house/tree.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace higherpair::house {
namespace fs = std::filesystem;

namespace {

bool is_foreign_folder(const fs::path& folder) {
  const std::string name = folder.filename().string();
  const bool at_top = folder.parent_path() == root();
  return (name.starts_with('.') && name != ".ci") || name == "node_modules" ||
         (at_top && (name == "build" || name == "out"));
}

}  // namespace

fs::path root() {
  return HIGHERPAIR_SOURCE_DIR;
}

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw std::runtime_error("cannot read " + path.string());
  }
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<fs::path> project_files() {
  std::vector<fs::path> files;
  for (auto entry = fs::recursive_directory_iterator(root()); entry != fs::recursive_directory_iterator();
       ++entry) {
    if (entry->is_directory() && is_foreign_folder(entry->path())) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file() && entry->path().filename() != ".git") {
      files.push_back(entry->path().lexically_relative(root()));
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace higherpair::house

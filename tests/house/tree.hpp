#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace higherpair::house {

/// The root of the project's source tree.
[[nodiscard]] std::filesystem::path root();

/// The whole text of a file; throws std::runtime_error when it cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// Every file of the project below `root()`, relative to it and sorted, without build/, out/ and hidden
/// folders of tools (.ci belongs to the project).
[[nodiscard]] std::vector<std::filesystem::path> project_files();

}  // namespace higherpair::house

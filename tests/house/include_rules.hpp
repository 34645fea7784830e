#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::house {

/// The include rules that one file of the library violates, one sentence each (`src/…:3: …`); empty if none.
/// Files outside include/ and src/ may include anything.
///
/// - The file and the header are in rooms (folders); the header's room is the file's own or one below it.
/// - A private header (src/) may be used in its own room only, except those of src/numeric.
/// - A public header includes only the project's own headers, the standard library, Eigen and tl::expected.
/// - Some libraries belong to one room (CGAL to contact) or to none (CLI11, which is for tools).
///
/// Purely textual: an include in a block comment or behind #if counts as well.
/// \param file relative to the root of the tree, such as `src/contact/track.cpp`
[[nodiscard]] std::vector<std::string> include_violations(const std::filesystem::path& file,
                                                          std::string_view text);

}  // namespace higherpair::house

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::house {

/// What is wrong with the includes of one file of the library, one sentence each (`src/…:3: …`); empty when
/// all is well. A file outside include/ and src/ may include what it likes.
///
/// - The file and the header are in rooms; the header's room is the file's own or one below it.
/// - A private header (src/) is for its own room only, but for those of src/numeric.
/// - A public header includes only the standard library, Eigen and tl::expected besides our own headers.
/// - Some libraries belong to one room (CGAL to contact) or to none (CLI11, which is for tools).
///
/// Textual: an include in a block comment or behind #if counts as well.
/// \param file relative to the root of the tree, as `src/contact/track.cpp`
[[nodiscard]] std::vector<std::string> include_violations(const std::filesystem::path& file,
                                                          std::string_view text);

}  // namespace higherpair::house

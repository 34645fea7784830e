#pragma once

#include <string>

#include <tl/expected.hpp>

namespace higherpair::io_detail {

/// The bytes of a file; the error is the end of a sentence about it. \param what  "profile", what it ought to
/// be
[[nodiscard]] tl::expected<std::string, std::string> read_text_file(const std::string& path,
                                                                    const std::string& what);

/// A file that a profile names: relative to the folder of the profile.
/// \param profile  what messages call the profile, the path of its file
[[nodiscard]] std::string beside(const std::string& profile, const std::string& file);

}  // namespace higherpair::io_detail

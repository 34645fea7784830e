#pragma once

#include <string>

#include <tl/expected.hpp>

namespace higherpair::io_detail {

/// The bytes of a file; the error is the end of a sentence that begins with its name.
/// \param what  what the file should be, such as "profile"
[[nodiscard]] tl::expected<std::string, std::string> read_text_file(const std::string& path,
                                                                    const std::string& what);

/// The path of a file named in a profile, relative to the profile's folder.
/// \param profile  path of the profile's file
[[nodiscard]] std::string beside(const std::string& profile, const std::string& file);

}  // namespace higherpair::io_detail

#pragma once

#include "higherpair/io/profile.hpp"
#include "io/document/table_reader.hpp"

namespace higherpair::io_detail {

/// Probable mistakes in a profile that is valid, in the order of the file; the user may still mean them.
/// \param document  the text that the profile was read from
[[nodiscard]] Diagnostics profile_notes(const Reading& reading, const Value& document,
                                        const Profile& profile);

}  // namespace higherpair::io_detail

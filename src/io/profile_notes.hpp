#pragma once

#include "higherpair/io/profile.hpp"
#include "table_reader.hpp"

namespace higherpair::io_detail {

/// What in a profile without mistakes is probably a slip although it may be meant, in the order of the file.
/// \param document  the text that the profile was read from
[[nodiscard]] Diagnostics profile_notes(const Reading& reading, const Value& document,
                                        const Profile& profile);

}  // namespace higherpair::io_detail

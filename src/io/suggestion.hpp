#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace higherpair::io_detail {

/// How many single-character edits (insert, delete, replace, swap of neighbours) turn one name into the
/// other; upper and lower case count as equal.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The end of a message about a name that does not exist: "did you mean `disc`?" with the (at most three)
/// nearest of the existing names; if none is near, a list of what exists; "there is none" without any.
[[nodiscard]] std::string suggestion(std::string_view name, const std::vector<std::string>& existing);

}  // namespace higherpair::io_detail

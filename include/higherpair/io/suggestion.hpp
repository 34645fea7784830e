#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

/// How many single-character edits (insert, delete, replace, swap of neighbours) turn one name into the
/// other; upper and lower case count as equal.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// "did you mean `revolute`?": the existing names that the field also calls `name` (pin, hinge), else the at
/// most three nearest; empty if there is none.
[[nodiscard]] std::string did_you_mean(std::string_view name, const std::vector<std::string>& existing);

/// The end of a message about a name that does not exist: did_you_mean; if that is empty, a list of what
/// exists; "there is none" without any.
[[nodiscard]] std::string suggestion(std::string_view name, const std::vector<std::string>& existing);

}  // namespace higherpair

#pragma once

#include "document.hpp"

#include <vector>

namespace higherpair::io_detail {

/// Mistakes in the order of their marks, without those that follow from another one:
/// - what is missing is there under an unknown key that was probably meant to be it;
/// - what cannot be used has a mistake of its own;
/// - several places name the same thing that does not exist: the first one lists the lines of the others.
[[nodiscard]] std::vector<Mistake> without_consequences(std::vector<Mistake> mistakes);

}  // namespace higherpair::io_detail

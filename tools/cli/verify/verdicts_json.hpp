#pragma once

#include "verify/reference.hpp"

#include <string>
#include <vector>

namespace higherpair::cli {

/// The output of `verify --json`.
/// \param bound  largest error accepted, relative to the column's largest value
[[nodiscard]] std::string verdicts_json(const std::vector<Verdict>& verdicts, double bound);

}  // namespace higherpair::cli

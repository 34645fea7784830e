#pragma once

#include "verify/reference.hpp"

#include <string>
#include <vector>

namespace higherpair::cli {

/// What `verify --json` writes. \param bound  of errors, relative to the column's largest value
[[nodiscard]] std::string verdicts_json(const std::vector<Verdict>& verdicts, double bound);

}  // namespace higherpair::cli

#pragma once

#include "higherpair/front/contacts.hpp"

#include <string>

namespace higherpair::cli {

/// The report as readable text, as CSV (contacts only), and as JSON.
[[nodiscard]] std::string branches_text(const BranchesReport& report);
[[nodiscard]] std::string branches_csv(const BranchesReport& report);
[[nodiscard]] std::string branches_json(const BranchesReport& report);

}  // namespace higherpair::cli

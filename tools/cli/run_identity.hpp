#pragma once

#include "higherpair/front/model.hpp"

#include <map>
#include <string>
#include <vector>

namespace higherpair::cli {

/// Everything that determines the results of a run, item by item: runs with equal identities have equal
/// results. Values are short texts without line ends.
using RunIdentity = std::map<std::string, std::string>;

/// The items for the program's version, the profile's text, and the files that it reads.
[[nodiscard]] RunIdentity model_identity(const std::string& profile, const Model& model);

/// A checksum of several texts that also depends on where each one ends.
[[nodiscard]] std::string sum_of(const std::vector<std::string>& texts);

/// Converts an identity to lines of text, and back.
[[nodiscard]] std::string identity_text(const RunIdentity& identity);
[[nodiscard]] RunIdentity identity_in(std::string_view text);

}  // namespace higherpair::cli

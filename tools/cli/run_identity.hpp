#pragma once

#include "higherpair/front/model.hpp"

#include <map>
#include <string>
#include <vector>

namespace higherpair::cli {

/// What a run is, thing by thing: two runs have the same results where all of it is equal. Values are short
/// texts without line ends.
using RunIdentity = std::map<std::string, std::string>;

/// The program's version, the text of the profile and of every file that it reads.
[[nodiscard]] RunIdentity model_identity(const std::string& profile, const Model& model);

/// A checksum of texts, each apart from the next.
[[nodiscard]] std::string sum_of(const std::vector<std::string>& texts);

/// All of it as lines of text, and back.
[[nodiscard]] std::string identity_text(const RunIdentity& identity);
[[nodiscard]] RunIdentity identity_in(std::string_view text);

}  // namespace higherpair::cli

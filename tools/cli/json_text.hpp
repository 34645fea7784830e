#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace higherpair::cli {

/// JSON as text; names and titles may quote a file that is not UTF-8.
/// \param indent  of its levels; -1: all in one line
[[nodiscard]] inline std::string text_of(const nlohmann::ordered_json& json, int indent = 2) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace higherpair::cli

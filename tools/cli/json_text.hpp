#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace higherpair::cli {

/// JSON as text. Invalid UTF-8, which names and titles may quote from a file, is replaced.
/// \param indent  per level; -1: all on one line
[[nodiscard]] inline std::string text_of(const nlohmann::ordered_json& json, int indent = -1) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// The content of a JSON file. \param indent  per level
[[nodiscard]] inline std::string document_of(const nlohmann::ordered_json& json, int indent = 2) {
  return text_of(json, indent) + "\n";
}

/// The number, or null if it is undefined, for which JSON has no number.
[[nodiscard]] inline nlohmann::ordered_json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}
[[nodiscard]] inline nlohmann::ordered_json number_or_null(const std::optional<double>& value) {
  return value ? number_or_null(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace higherpair::cli

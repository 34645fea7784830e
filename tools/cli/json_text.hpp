#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace higherpair::cli {

/// JSON as text; names and titles may quote a file that is not UTF-8.
/// \param indent  of its levels; -1: all in one line
[[nodiscard]] inline std::string text_of(const nlohmann::ordered_json& json, int indent = 2) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// A file of JSON.
[[nodiscard]] inline std::string document_of(const nlohmann::ordered_json& json) {
  return text_of(json) + "\n";
}

/// JSON has no number for what is not defined.
[[nodiscard]] inline nlohmann::ordered_json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}
[[nodiscard]] inline nlohmann::ordered_json number_or_null(const std::optional<double>& value) {
  return value ? number_or_null(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace higherpair::cli

#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace higherpair::cli {

/// JSON as text; names and titles may quote a file that is not UTF-8.
[[nodiscard]] inline std::string text_of(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace higherpair::cli

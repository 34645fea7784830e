#include "run_identity.hpp"

#include "checksum.hpp"
#include "file_text.hpp"
#include "higherpair/front/model.hpp"

#include <fmt/core.h>

namespace higherpair::cli {

RunIdentity model_identity(const std::string& profile, const Model& model) {
  std::vector<std::string> files;
  for (const std::string& path : model.profile().files) {
    files.push_back(file_text(path).value_or(""));
  }
  return {{"version", std::string(version())},
          {"profile", sum_of({file_text(profile).value_or("")})},
          {"files", sum_of(files)}};
}

std::string sum_of(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) {
    all += fmt::format("{} {}\n", text.size(), text);
  }
  return fmt::format("{:016x}", checksum(all));
}

std::string identity_text(const RunIdentity& identity) {
  std::string text;
  for (const auto& [name, value] : identity) {
    text += fmt::format("{} {}\n", name, value);
  }
  return text;
}

RunIdentity identity_in(std::string_view text) {
  RunIdentity identity;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    const std::string_view line = text.substr(0, end);
    const std::size_t space = line.find(' ');
    if (space != std::string_view::npos) {
      identity[std::string(line.substr(0, space))] = line.substr(space + 1);
    }
    text.remove_prefix(end + 1);
  }
  return identity;
}

}  // namespace higherpair::cli

#pragma once

#include <string>

namespace higherpair::cli {

/// A sentence wrapped at spaces to lines of at most 80 characters, every line indented by `indent` spaces.
[[nodiscard]] inline std::string paragraph(const std::string& sentence, std::size_t indent) {
  constexpr std::size_t kPageWidth = 80;
  std::string text, line(indent, ' ');
  const std::string start = line;
  std::string rest = sentence;
  while (!rest.empty()) {
    const std::size_t space = rest.find(' ');
    const std::string word = rest.substr(0, space);
    rest = space == std::string::npos ? "" : rest.substr(space + 1);
    if (line.size() > start.size() && line.size() + 1 + word.size() > kPageWidth) {
      text += line + "\n";
      line = start;
    }
    line += (line.size() > start.size() ? " " : "") + word;
  }
  return text + line + "\n";
}

}  // namespace higherpair::cli

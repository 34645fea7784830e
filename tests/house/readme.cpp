#include "house/readme.hpp"

#include <algorithm>
#include <sstream>

namespace higherpair::house {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream stream{std::string(text)};
  std::string line;
  while (std::getline(stream, line)) {
    lines.push_back(line);
  }
  return lines;
}

std::string without_comment(const std::string& line) {
  const std::string command = line.starts_with('#') ? "" : line.substr(0, line.find(" #"));
  return command.substr(0, command.find_last_not_of(' ') + 1);
}

std::vector<Command> script_commands(const std::string& text) {
  std::vector<Command> commands;
  std::string command;
  for (const std::string& line : lines_of(text)) {
    command += without_comment(line);
    if (command.ends_with('\\')) {
      command.pop_back();
      continue;
    }
    if (!command.empty()) {
      commands.push_back({command, ""});
    }
    command.clear();
  }
  return commands;
}

std::vector<Command> console_commands(const std::string& text) {
  std::vector<Command> commands;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("$ ")) {
      commands.push_back({line.substr(2), ""});
    } else if (!commands.empty()) {
      commands.back().output += line + "\n";
    }
  }
  return commands;
}

// Whether actual[a…] reads as expected[e…].
bool matches_from(const std::vector<std::string>& actual, std::size_t a,
                  const std::vector<std::string>& expected, std::size_t e) {
  if (e == expected.size()) {
    return a == actual.size();
  }
  if (expected[e] == "…") {
    for (std::size_t next = a; next <= actual.size(); ++next) {
      if (matches_from(actual, next, expected, e + 1)) {
        return true;
      }
    }
    return false;
  }
  return a < actual.size() && actual[a] == expected[e] && matches_from(actual, a + 1, expected, e + 1);
}

}  // namespace

std::vector<Block> fenced_blocks(std::string_view markdown) {
  std::vector<Block> blocks;
  bool inside = false;
  int number = 0;
  for (const std::string& line : lines_of(markdown)) {
    ++number;
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) {
        blocks.push_back({number, line.substr(3), ""});
      }
    } else if (inside) {
      blocks.back().text += line + "\n";
    }
  }
  return blocks;
}

std::vector<Command> commands_of(const Block& block) {
  return block.language == "console" ? console_commands(block.text) : script_commands(block.text);
}

bool matches_with_gaps(const std::string& actual, const std::string& expected) {
  return matches_from(lines_of(actual), 0, lines_of(expected), 0);
}

}  // namespace higherpair::house

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace higherpair::house {

/// A fenced block of a Markdown text.
struct Block {
  int line = 0;          ///< of the opening fence
  std::string language;  ///< what follows the opening fence: "sh", "toml", …; may be empty
  std::string text;      ///< the lines between the fences, each with its end
};

/// All fenced blocks (three backticks at the start of a line), in order.
[[nodiscard]] std::vector<Block> fenced_blocks(std::string_view markdown);

/// A command and what it prints.
struct Command {
  std::string line;
  std::string output;
};

/// The commands of a block: in "sh" every line that is not empty or a comment (a trailing ` # comment` is cut
/// off, a line that ends in a backslash goes on); in "console" the lines after `$ `, each with the output
/// that follows it.
[[nodiscard]] std::vector<Command> commands_of(const Block& block);

/// Whether `actual` reads as `expected`, in which a line consisting of … stands for any number of lines.
[[nodiscard]] bool matches_with_gaps(const std::string& actual, const std::string& expected);

}  // namespace higherpair::house

#pragma once

#include <string>
#include <vector>

namespace higherpair {

/// A place in the user's input.
struct Place {
  std::string source;  ///< a file's name, or the option `--set PATH=VALUE` itself
  int line = 0;        ///< from 1; 0: the whole source is meant
  int column = 0;      ///< from 1, in characters; 0 with line 0
};

/// One mistake in the user's input: what is wrong and what is expected.
struct Diagnostic {
  Place place;
  std::string message;
};

/// All mistakes found, in the order of the file; those of overrides come last.
using Diagnostics = std::vector<Diagnostic>;

/// A mistake of a source as a whole.
[[nodiscard]] Diagnostic about(std::string source, std::string message);

/// "file:line:column: message", or "source: message" where no line is known.
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

/// The same of what may be meant though it is probably a slip: "file:line:column: note: message".
[[nodiscard]] std::string note_text(const Diagnostic& note);

}  // namespace higherpair

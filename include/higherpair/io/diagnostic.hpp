#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// A place in the user's input.
struct Place {
  /// A file's name; or "override PATH=VALUE"; or a setting and its value, "setting columns follower.*".
  std::string source;
  int line = 0;    ///< from 1; 0: the whole source is meant
  int column = 0;  ///< from 1, in characters; 0 with line 0
};

/// One mistake in the user's input: what is wrong and what is expected.
struct Diagnostic {
  Place place;
  std::string message;
};

/// All mistakes found, in the order of the file; those of overrides come last.
using Diagnostics = std::vector<Diagnostic>;

/// A mistake that concerns a source as a whole.
[[nodiscard]] Diagnostic about(std::string source, std::string message);

/// "file:line:column: message", or "source: message" where no line is known.
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

/// The same for a note, on something valid that is probably a slip: "file:line:column: note: message".
[[nodiscard]] std::string note_text(const Diagnostic& note);

/// The existing names for which `name` is a common synonym (pin, hinge), else at most three of the most
/// similar.
[[nodiscard]] std::vector<std::string> meant_names(std::string_view name,
                                                   const std::vector<std::string>& existing);

/// "did you mean `revolute`?" of such names; empty if there is none.
[[nodiscard]] std::string did_you_mean(const std::vector<std::string>& meant);
[[nodiscard]] std::string did_you_mean(std::string_view name, const std::vector<std::string>& existing);

/// Whether `name` is another word for `word` in textbooks or other programs: "frame" for "ground".
[[nodiscard]] bool is_synonym(std::string_view name, std::string_view word);

/// The end of a message about a name that does not exist: did_you_mean; if that is empty, a list of the
/// existing names, or "none is defined".
[[nodiscard]] std::string suggestion(std::string_view name, const std::vector<std::string>& existing);

enum class ErrorKind {
  kInput,      ///< the profile, a value or an option is wrong: nothing was tried
  kMechanism,  ///< the mechanism cannot be started: its mobility, no assembly, no contact
  kInternal,   ///< two computations of the same result disagree: a fault of the library
};

/// Why something could not be done: what is wrong, where, and what would be right. At least one diagnostic;
/// for a profile all semantic mistakes at once.
struct Error {
  ErrorKind kind = ErrorKind::kInput;
  Diagnostics diagnostics;
};

/// The diagnostics, one to a line, without a line end after the last.
[[nodiscard]] std::string to_string(const Error& error);

template <class T>
using Result = tl::expected<T, Error>;

}  // namespace higherpair

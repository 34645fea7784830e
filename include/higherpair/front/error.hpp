#pragma once

#include "higherpair/io/diagnostic.hpp"

#include <string>

#include <tl/expected.hpp>

namespace higherpair {

enum class ErrorKind {
  kInput,      ///< the profile, a value or an option is wrong: nothing was tried
  kMechanism,  ///< the mechanism cannot be started: its mobility, no assembly, no contact
  kInternal,   ///< two ways of working the same out disagree: a fault of the library
};

/// Why something could not be done: what is wrong, where, and what would be right. At least one diagnostic;
/// of a profile all mistakes of meaning at once.
struct Error {
  ErrorKind kind = ErrorKind::kInput;
  Diagnostics diagnostics;
};

/// The diagnostics, one to a line, without a line end after the last.
[[nodiscard]] std::string to_string(const Error& error);

template <class T>
using Result = tl::expected<T, Error>;

}  // namespace higherpair

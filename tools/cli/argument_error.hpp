#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace higherpair::cli {

/// The message for arguments that `app` has refused with `error`, with a pointer to help: "--samples ten:
/// must be an integer; see higherpair analyze --help".
[[nodiscard]] std::string argument_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace higherpair::cli

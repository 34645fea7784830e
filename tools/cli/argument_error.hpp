#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace higherpair::cli {

/// What is wrong with the arguments that `app` has refused with `error`, and where help is:
/// "--samples ten: must be an integer; see higherpair analyze --help".
[[nodiscard]] std::string argument_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace higherpair::cli

#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace higherpair::cli {

/// "there is no command analyse; did you mean `analyze`? See higherpair --help"; for the name of a profile
/// "did you mean `higherpair analyze cam.toml`?".
[[nodiscard]] std::string unknown_command(const CLI::App& app, std::string_view name);

/// The message if no command is given: "a command is missing: one of analyze, …".
[[nodiscard]] std::string no_command(const CLI::App& app);

/// The message for the first argument that the command does not know, such as "analyze has no option --cvs;
/// did you mean `--csv`?" or "analyze does not take `b.toml`". Empty if it knows all.
[[nodiscard]] std::string unknown_argument(const CLI::App& command);

}  // namespace higherpair::cli

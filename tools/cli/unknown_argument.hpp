#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace higherpair::cli {

/// "there is no command analyse; did you mean `analyze`?; see higherpair --help"; of a profile's name
/// "did you mean `higherpair analyze cam.toml`?".
[[nodiscard]] std::string unknown_command(const CLI::App& app, std::string_view name);

/// Where none is given: "a command is missing: one of analyze, …".
[[nodiscard]] std::string no_command(const CLI::App& app);

/// "analyze has no option --cvs; did you mean `--csv`?", "analyze does not take `b.toml`": of the first
/// argument that the command does not know. Empty if it knows all.
[[nodiscard]] std::string unknown_argument(const CLI::App& command);

}  // namespace higherpair::cli

#include "unknown_argument.hpp"

#include "higherpair/io/suggestion.hpp"

#include <algorithm>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace higherpair::cli {

std::string unknown_command(const CLI::App& app, std::string_view name) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return fmt::format("there is no command {}; {}", name, suggestion(name, names));
}

std::string unknown_argument(const CLI::App& command) {
  const std::vector<std::string> extras = command.remaining();
  if (extras.empty()) {
    return "";
  }
  const auto option = std::find_if(extras.begin(), extras.end(), [](const std::string& extra) {
    return extra.size() > 1 && extra[0] == '-';
  });
  if (option == extras.end()) {
    return fmt::format("{} does not take `{}`", command.get_name(), extras.front());
  }
  const std::string given = option->substr(0, option->find('='));
  std::vector<std::string> names;
  for (const CLI::Option* known : command.get_options()) {
    for (const std::string& name : known->get_lnames()) {
      names.push_back(name);
    }
  }
  const std::size_t dashes = std::min(given.find_first_not_of('-'), given.size());
  std::string likely = did_you_mean(given.substr(dashes), names);
  for (std::size_t at = likely.find(" `"); at != std::string::npos; at = likely.find(" `", at + 1)) {
    likely.replace(at, 2, " `--");
  }
  return fmt::format("{} has no option {}; {}", command.get_name(), given,
                     likely.empty() ? "see higherpair " + command.get_name() + " --help" : likely);
}

}  // namespace higherpair::cli

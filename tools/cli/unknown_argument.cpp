#include "unknown_argument.hpp"

#include "higherpair/io/diagnostic.hpp"

#include <algorithm>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

namespace higherpair::cli {

namespace {

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return names;
}

bool is_profile(std::string_view name) {
  constexpr std::string_view kEnd = ".toml";
  return name.size() > kEnd.size() && name.substr(name.size() - kEnd.size()) == kEnd;
}

}  // namespace

std::string unknown_command(const CLI::App& app, std::string_view name) {
  const std::string remedy = is_profile(name) ? fmt::format("did you mean `higherpair analyze {}`?", name)
                                              : suggestion(name, command_names(app));
  return fmt::format("there is no command {}; {}; see higherpair --help", name, remedy);
}

std::string no_command(const CLI::App& app) {
  return fmt::format("a command is missing: one of {}; see higherpair --help",
                     fmt::join(command_names(app), ", "));
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
  const CLI::App* const whole = command.get_parent();
  const std::string name = (whole == nullptr ? "" : whole->get_name() + " ") + command.get_name();
  return fmt::format("{} has no option {}; {}", command.get_name(), given,
                     likely.empty() ? "see " + name + " --help" : likely);
}

}  // namespace higherpair::cli

#include "unknown_argument.hpp"

#include "higherpair/io/diagnostic.hpp"

#include <algorithm>
#include <span>
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

bool is_command(const CLI::App& app, const std::string& name) {
  const std::vector<std::string> names = command_names(app);
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Options by which other programs say what is a key of the driver here.
struct DriverKey {
  std::string_view option;
  std::string_view key;
};
constexpr DriverKey kDriverKeys[] = {
    {"positions", "positions"},
    {"start", "start"},
    {"from", "start"},
    {"end", "end"},
    {"to", "end"},
    {"speed", "velocity"},
    {"velocity", "velocity"},
    {"omega", "velocity"},
    {"rpm", "velocity"},
    {"samples", "samples"},
    {"steps", "samples"},
    {"duration", "duration"},
    {"time-step", "time_step"},
    {"acceleration", "acceleration"},
};

// "set it by --set driver.start=…" for an option of other programs; empty for others, and where `names` has
// an option that begins so.
std::string driver_key(const CLI::App& command, std::string_view option, std::span<const std::string> names) {
  const auto* const known = std::find_if(std::begin(kDriverKeys), std::end(kDriverKeys),
                                         [&](const DriverKey& one) { return one.option == option; });
  const bool is_begin = std::any_of(names.begin(), names.end(),
                                    [&](const std::string& name) { return name.starts_with(option); });
  return known == std::end(kDriverKeys) || is_begin || command.get_option_no_throw("--set") == nullptr
             ? ""
             : fmt::format("it is a key of the profile's driver: --set driver.{}=…", known->key);
}

bool is_profile(std::string_view name) {
  constexpr std::string_view kEnd = ".toml";
  return name.size() > kEnd.size() && name.substr(name.size() - kEnd.size()) == kEnd;
}

}  // namespace

std::string unknown_command(const CLI::App& app, std::string_view name) {
  if (name == "help" || name == "version") {
    return fmt::format("there is no command {0}; did you mean `higherpair --{0}`?", name);
  }
  const std::string remedy = is_profile(name) ? fmt::format("did you mean `higherpair analyze {}`?", name)
                                              : suggestion(name, command_names(app));
  return fmt::format("there is no command {}; {} higherpair --help", name,
                     remedy + (remedy.ends_with('?') ? " See" : "; see"));
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
  const std::string word = given.substr(dashes);
  const CLI::App* const whole = command.get_parent();
  const std::string name = (whole == nullptr ? "" : whole->get_name() + " ") + command.get_name();
  const std::string unknown = fmt::format("{} has no option {}; ", command.get_name(), given);
  if (whole != nullptr && is_command(*whole, word)) {
    return unknown + fmt::format("did you mean the command `{} {}`?", whole->get_name(), word);
  }
  if (const std::string key = driver_key(command, word, names); !key.empty()) {
    return unknown + key;
  }
  std::string likely = did_you_mean(word, names);
  for (std::size_t at = likely.find(" `"); at != std::string::npos; at = likely.find(" `", at + 1)) {
    likely.replace(at, 2, " `--");
  }
  if (!likely.empty()) {
    return unknown + likely;
  }
  const std::string other = whole == nullptr ? "" : did_you_mean(word, command_names(*whole));
  return unknown + (other.empty() ? "see " + name + " --help" : "as a command, " + other);
}

}  // namespace higherpair::cli

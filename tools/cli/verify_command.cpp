#include "commands.hpp"
#include "file_text.hpp"
#include "option_checks.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "signals.hpp"
#include "tell.hpp"
#include "verify/reference.hpp"
#include "verify/verdicts_json.hpp"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace higherpair::cli {
namespace {

struct VerifyOptions {
  std::optional<std::string>
      profile;  ///< with `table`: checks this pair of files instead of the shipped ones
  std::optional<std::string> table;
  std::optional<std::string> json;
  double bound = 1e-11;  ///< largest error of a column, relative to its largest value
  bool quiet = false;
};

std::optional<std::string> text_in(const std::string& path) {
  auto text = file_text(path);
  if (!text) tell("{}: cannot be read\n", path);
  return text;
}

void print(const Verdict& verdict, double bound) {
  fmt::print("{:<6} {}\n       {}\n", verdict.holds(bound) ? "ok" : "FAILED", verdict.title, verdict.source);
  if (!verdict.failure.empty()) {
    fmt::print("       {}\n", verdict.failure);
    return;
  }
  for (const ColumnCheck& check : verdict.columns) {
    fmt::print("       {:<34} {:>22} error {:.1e}{}\n", check.column, check.value, check.error,
               check.error <= bound ? "" : fmt::format(", expected {}", check.expected));
  }
  fmt::print("       {:.0f} microseconds\n", 1e6 * verdict.seconds);
}

int report(const std::vector<Verdict>& verdicts, const VerifyOptions& options) {
  std::size_t failed = 0;
  double worst = 0;
  for (const Verdict& verdict : verdicts) {
    const bool ok = verdict.holds(options.bound);
    failed += ok ? 0 : 1;
    worst = std::max(worst, verdict.columns.empty() ? 0 : verdict.worst().error);
    if (options.json != "-" && !(ok && options.quiet)) {
      print(verdict, options.bound);
    }
  }
  if (options.json != "-" && !options.quiet) {
    fmt::print("{} of {} references hold; largest error {:.1e} of the column's largest value, bound {:.0e}\n",
               verdicts.size() - failed, verdicts.size(), worst, options.bound);
  }
  if (options.json) {
    if (!write_files({{*options.json, verdicts_json(verdicts, options.bound)}}, &interruption())) {
      return exit_unwritten();
    }
  }
  return failed == 0 ? kExitOk : kExitRows;
}

// Runs `verify`; returns the exit code: 4 if a reference does not hold.
int verify_command(const VerifyOptions& options) {
  std::vector<Verdict> verdicts;
  if (!options.profile) {
    for (const Reference& reference : shipped_references()) {
      verdicts.push_back(verify(reference));
    }
    return report(verdicts, options);
  }
  if (!options.table) {
    tell("higherpair: verify: a profile needs the table that it is checked against\n");
    return kExitInput;
  }
  const auto profile = text_in(*options.profile);
  const auto table = text_in(*options.table);
  if (!profile || !table) {
    return kExitInput;
  }
  const auto model = Model::from_text(*profile, *options.profile);
  if (!model) {
    return report_error(model.error());
  }
  if (const auto refused = refused_output(*model, given({{"--json", options.json}}))) {
    return report_error(*refused);
  }
  if (model->mechanism().drivers.empty()) {
    return report_error(model->start().error());
  }
  verdicts.push_back(verify({*options.profile, *profile, *table}));
  return report(verdicts, options);
}

}  // namespace

CommandRun add_verify(CLI::App& command) {
  const auto options = std::make_shared<VerifyOptions>();
  command.add_option("PROFILE", options->profile, "check this profile instead of the shipped references");
  command.add_option("TABLE", options->table,
                     "CSV of what is right for it: the rows of analyze or step, all columns or some");
  command.add_option("--json", options->json, "write values, errors and times as JSON to this file");
  command.add_option("--bound", options->bound, "largest error, relative to a column's largest value")
      ->check(positive_number());
  command.add_flag("--quiet", options->quiet, "print only what fails");
  command.final_callback([options] {
    std::vector<NamedFile> inputs;
    if (options->profile) inputs.push_back({"PROFILE", *options->profile});
    if (options->table) inputs.push_back({"TABLE", *options->table});
    if (options->json) check_files(inputs, {{"--json", *options->json}});
  });
  return [options] { return verify_command(*options); };
}

}  // namespace higherpair::cli

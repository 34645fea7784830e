#include "commands.hpp"
#include "higherpair/front/mobility.hpp"
#include "option_checks.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "tell.hpp"

#include <memory>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

struct MobilityOptions : ProfileOptions {
  std::optional<std::string> csv;
  std::optional<std::string> json;
  double tolerance = 1e-9;
};

int write(const MobilityOptions& options, const MobilityFindings& findings) {
  const Forms forms = {[&] { return mobility_csv(findings); }, [&] { return mobility_json(findings) + "\n"; },
                       [&] { return mobility_text(findings); }};
  return write_forms(options.csv, options.json, forms) ? kExitOk : exit_unwritten();
}

// Runs `mobility`; returns the exit code: 3 if the drivers do not fit the mechanism or it cannot be started;
// the findings obtained are printed all the same.
int mobility_command(const MobilityOptions& options) {
  const auto findings =
      open_model(options, given({{"--csv", options.csv}, {"--json", options.json}}))
          .and_then([&](const Model& model) { return mobility_of(model, options.tolerance); });
  if (!findings) {
    return report_error(findings.error());
  }
  if (const int code = write(options, *findings); code != kExitOk) {
    return code;
  }
  if (findings->objection && !options.quiet) {
    tell("{}: {}\n", options.profile, *findings->objection);
  }
  return findings->objection ? kExitMechanism : kExitOk;
}

}  // namespace

CommandRun add_mobility(CLI::App& command) {
  const auto options = std::make_shared<MobilityOptions>();
  add_profile_options(command, *options);
  add_output_options(command, options->profile, {"the findings, one to a row,", options->csv},
                     {"the findings", options->json});
  command.add_option("--tolerance", options->tolerance, "largest closure error, relative to the size")
      ->check(positive_number());
  add_unused_samples(command, "the first driver position counts");
  return [options] { return mobility_command(*options); };
}

}  // namespace higherpair::cli

#include "mobility_command.hpp"

#include "higherpair/analysis/run.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "json_text.hpp"
#include "mobility_report.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "positive_number.hpp"
#include "run_command.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace higherpair::cli {
namespace {

MobilityQuestion question_of(const DriverSchedule& schedule) {
  MobilityQuestion question;
  for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
    const DriverState state = schedule.state(0, i);
    question.drivers.push_back(state.si.position);
    question.velocities.push_back(state.si.velocity);
  }
  return question;
}

int write(const MobilityOptions& options, const MobilityFindings& findings) {
  const Forms forms = {[&] { return mobility_csv(findings); },
                       [&] { return text_of(mobility_json(findings)) + "\n"; },
                       [&] { return mobility_text(findings); }};
  return write_forms(options.csv, options.json, forms) ? kExitOk : kExitMachine;
}

// Why the mechanism cannot be run, by the rank first.
std::optional<std::string> refusal(const MobilityFindings& findings,
                                   const tl::expected<Run, StartFailure>& run) {
  if (auto objection = driver_objection(findings.profile.mechanism, findings.mobility)) {
    return objection;
  }
  return run ? std::nullopt : std::optional(run.error().reason);
}

}  // namespace

CLI::App* add_mobility_command(CLI::App& app, MobilityOptions& options) {
  CLI::App* command = app.add_subcommand("mobility",
                                         "degree of freedom by count and by rank, idle freedoms, order of "
                                         "solution, Grashof class of every four-bar");
  command->add_option("FILE", options.profile, "profile of the mechanism (TOML)")->required();
  add_output_options(*command, {"the findings, one to a row,", options.csv}, {"the findings", options.json});
  command
      ->add_option("--set", options.overrides, "PATH=VALUE: override or add a key of the profile; repeatable")
      ->allow_extra_args(false);
  command->add_option("--tolerance", options.tolerance, "largest closure error, relative to the size")
      ->check(positive_number());
  add_unused_samples(*command);
  command->add_flag("--quiet", options.quiet, "no messages about drivers on standard error");
  return command;
}

int mobility_command(const MobilityOptions& options) {
  const auto profile = read_profile_file(options.profile, options.overrides);
  if (!profile) {
    return report_input(profile.error());
  }
  const auto schedule = DriverSchedule::analyze(*profile, std::nullopt);
  if (!schedule) {
    return report_input(schedule.error());
  }
  MobilityQuestion question = question_of(*schedule);
  const auto run = start_run(profile->mechanism, question.drivers, options.tolerance);
  if (run) {
    question.start = MechanismPosition{run->state.bodies, run->state.contacts};
  }
  MobilityFindings findings{*profile, analyse_mobility(profile->mechanism, question), std::nullopt};
  if (auto plan = make_plan(profile->mechanism)) {
    findings.plan = *std::move(plan);
  }
  if (const int code = write(options, findings); code != kExitOk) {
    return code;
  }
  const auto reason = refusal(findings, run);
  if (reason && !options.quiet) {
    fmt::print(stderr, "{}: {}\n", options.profile, *reason);
  }
  return reason ? kExitMechanism : kExitOk;
}

}  // namespace higherpair::cli

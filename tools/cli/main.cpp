#include "branches_command.hpp"
#include "check_command.hpp"
#include "design_command.hpp"
#include "draw_command.hpp"
#include "export_command.hpp"
#include "fit_command.hpp"
#include "higherpair/analysis/row.hpp"
#include "map_command.hpp"
#include "mobility_command.hpp"
#include "output_options.hpp"
#include "plot_command.hpp"
#include "polygon_command.hpp"
#include "positive_number.hpp"
#include "report_command.hpp"
#include "run_command.hpp"
#include "sensitivity_command.hpp"
#include "sweep_command.hpp"
#include "unknown_argument.hpp"
#include "verify_command.hpp"

#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using higherpair::cli::add_output_options;
using higherpair::cli::BranchesOptions;
using higherpair::cli::RunOptions;
using higherpair::cli::VerifyOptions;

CLI::App* add_run_command(CLI::App& app, const std::string& name, const std::string& text,
                          RunOptions& options) {
  CLI::App* command = app.add_subcommand(name, text);
  command->add_option("FILE", options.profile, "profile of the mechanism (TOML)")->required();
  add_output_options(*command, options.profile, {"the table", options.csv},
                     {"the table and the events", options.json}, nullptr, &options.events, &options.hdf5);
  command->add_option("--hdf5", options.hdf5, "write the table and the events as HDF5 to this file");
  command->add_option("--events", options.events,
                      "write the events as CSV to this file (-: standard output)");
  higherpair::cli::add_set_option(*command, options.overrides);
  command->add_option("--samples", options.samples, "number of rows");
  higherpair::cli::add_tolerance_option(*command, options.tolerance);
  higherpair::cli::add_threads_option(*command, options.threads);
  command->add_flag("--quiet", options.quiet, "no events, notes and progress on standard error");
  command->add_flag("--jerk", options.jerk,
                    "columns of the true jerk, and of that of the frozen equivalent linkage");
  command
      ->add_option("--derivatives", options.derivatives,
                   "columns of all time derivatives of bodies and points from the third to this one")
      ->check(CLI::Range(3, higherpair::kHighestDerivative));
  command
      ->add_option("--columns", options.columns,
                   "GLOB[,GLOB]: only these columns, such as follower.*,touch.rho*; repeatable")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_flag("--summary", options.summary, "print the range of every column on standard output");
  return command;
}

CLI::App* add_branches_command(CLI::App& app, BranchesOptions& options) {
  CLI::App* command = app.add_subcommand(
      "branches", "every contact of the two curves at the first driver position, free or not");
  command->add_option("FILE", options.profile, "profile of the mechanism (TOML)")->required();
  add_output_options(*command, options.profile, {"the list", options.csv}, {"the list", options.json});
  higherpair::cli::add_unused_samples(*command, "the first driver position counts");
  higherpair::cli::add_set_option(*command, options.overrides);
  command->add_option("--tolerance", options.tolerance, "largest closure error, relative to the size")
      ->check(higherpair::cli::positive_number());
  command->add_flag("--quiet", options.quiet, "no notes and remarks on standard error");
  command->add_flag("--certify", options.certify, "decide every contact in exact arithmetic");
  return command;
}

CLI::App* add_verify_command(CLI::App& app, VerifyOptions& options) {
  CLI::App* command = app.add_subcommand(
      "verify", "works out mechanisms whose motion is published or has a closed form, and compares");
  command->add_option("PROFILE", options.profile, "check this profile instead of the shipped references");
  command->add_option("TABLE", options.table,
                      "CSV of what is right for it: the rows of analyze or step, all columns or some");
  command->add_option("--json", options.json, "write values, errors and times as JSON to this file");
  command->add_option("--bound", options.bound, "largest error, relative to a column's largest value")
      ->check(higherpair::cli::positive_number());
  command->add_flag("--quiet", options.quiet, "print only what fails");
  command->final_callback([&options] {
    std::vector<higherpair::cli::NamedFile> inputs;
    if (options.profile) inputs.push_back({"PROFILE", *options.profile});
    if (options.table) inputs.push_back({"TABLE", *options.table});
    if (options.json) higherpair::cli::refuse_shared_files(inputs, {{"--json", *options.json}});
  });
  return command;
}

int run(int argc, char** argv) {
  CLI::App app("Analyses planar mechanisms whose bodies touch, by their equivalent linkages.", "higherpair");
  app.set_version_flag("--version", "higherpair " HIGHERPAIR_VERSION);
  app.require_subcommand(1);
  RunOptions analyze;
  RunOptions step;
  step.timed = true;
  RunOptions forces;
  forces.forces = true;
  const CLI::App* analyze_command =
      add_run_command(app, "analyze", "motion at every driver position of the profile", analyze);
  const CLI::App* step_command =
      add_run_command(app, "step", "motion in time, with the driver's velocity and acceleration", step);
  CLI::App* forces_command = add_run_command(
      app, "forces",
      "motion at every driver position, with the reactions of joints and contacts and the effort "
      "of the drivers; there is no friction but what rolling needs",
      forces);
  forces_command->add_flag("--time", forces.timed, "the motion in time, as step has it");
  BranchesOptions branches;
  const CLI::App* branches_command = add_branches_command(app, branches);
  higherpair::cli::MobilityOptions mobility;
  const CLI::App* mobility_command = higherpair::cli::add_mobility_command(app, mobility);
  higherpair::cli::MapOptions map;
  const CLI::App* map_command = higherpair::cli::add_map_command(app, map);
  higherpair::cli::DrawOptions draw;
  const CLI::App* draw_command = higherpair::cli::add_draw_command(app, draw);
  higherpair::cli::ExportOptions exported;
  const CLI::App* export_command = higherpair::cli::add_export_command(app, exported);
  higherpair::cli::PlotOptions plot;
  const CLI::App* plot_command = higherpair::cli::add_plot_command(app, plot);
  higherpair::cli::PolygonOptions polygon;
  const CLI::App* polygon_command = higherpair::cli::add_polygon_command(app, polygon);
  higherpair::cli::ReportOptions report;
  const CLI::App* report_command = higherpair::cli::add_report_command(app, report);
  higherpair::cli::CheckOptions check;
  const CLI::App* check_command = higherpair::cli::add_check_command(app, check);
  higherpair::cli::SweepOptions sweep;
  const CLI::App* sweep_command = higherpair::cli::add_sweep_command(app, sweep);
  higherpair::cli::SensitivityOptions sensitivity;
  const CLI::App* sensitivity_command = higherpair::cli::add_sensitivity_command(app, sensitivity);
  higherpair::cli::DesignCommandOptions design;
  const CLI::App* design_command = higherpair::cli::add_design_command(app, design);
  higherpair::cli::FitCommandOptions fit;
  const CLI::App* fit_command = higherpair::cli::add_fit_command(app, fit);
  VerifyOptions verify;
  const CLI::App* verify_command = add_verify_command(app, verify);
  bool known = argc < 2 || argv[1][0] == '-';
  for (CLI::App* command : app.get_subcommands({})) {
    command->set_version_flag("--version", "higherpair " HIGHERPAIR_VERSION);
    known = known || command->check_name(argv[1]);
  }
  if (!known) {
    fmt::print(stderr, "higherpair: {}; see higherpair --help\n",
               higherpair::cli::unknown_command(app, argv[1]));
    return higherpair::cli::kExitInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    for (const CLI::App* command : app.get_subcommands()) {
      fmt::print(stderr, "higherpair: {}\n", higherpair::cli::unknown_argument(*command));
    }
    return higherpair::cli::kExitInput;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? higherpair::cli::kExitOk : higherpair::cli::kExitInput;
  }
  if (branches_command->parsed()) {
    return higherpair::cli::branches_command(branches);
  }
  if (map_command->parsed()) {
    return higherpair::cli::map_command(map);
  }
  if (draw_command->parsed()) {
    return higherpair::cli::draw_command(draw);
  }
  if (export_command->parsed()) {
    return higherpair::cli::export_command(exported);
  }
  if (plot_command->parsed()) {
    return higherpair::cli::plot_command(plot);
  }
  if (polygon_command->parsed()) {
    return higherpair::cli::polygon_command(polygon);
  }
  if (report_command->parsed()) {
    return higherpair::cli::report_command(report);
  }
  if (check_command->parsed()) {
    return higherpair::cli::check_command(check);
  }
  if (sweep_command->parsed()) {
    return higherpair::cli::sweep_command(sweep);
  }
  if (sensitivity_command->parsed()) {
    return higherpair::cli::sensitivity_command(sensitivity);
  }
  if (design_command->parsed()) {
    return higherpair::cli::design_command(design);
  }
  if (fit_command->parsed()) {
    return higherpair::cli::fit_command(fit);
  }
  if (verify_command->parsed()) {
    return higherpair::cli::verify_command(verify);
  }
  if (mobility_command->parsed()) {
    return higherpair::cli::mobility_command(mobility);
  }
  return higherpair::cli::run_command(analyze_command->parsed() ? analyze
                                      : step_command->parsed()  ? step
                                                                : forces);
}

// What was printed may still be on its way.
int flushed(int code) {
  std::cout.flush();
  const bool good = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (good || code != higherpair::cli::kExitOk) {
    return code;
  }
  fmt::print(stderr, "higherpair: cannot write to standard output\n");
  return higherpair::cli::kExitMachine;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return flushed(run(argc, argv));
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "higherpair: out of memory\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "higherpair: {}\n", error.what());
  }
  return higherpair::cli::kExitMachine;
}

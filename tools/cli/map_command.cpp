#include "map_command.hpp"

#include "higherpair/analysis/mapped_contacts.hpp"
#include "higherpair/contact/contact_map.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "json_text.hpp"
#include "map_report.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "positive_number.hpp"
#include "run_command.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace higherpair::cli {
namespace {

bool write_all(const MapOptions& options, const MapReport& report) {
  return write_forms(options.csv, options.json,
                     {[&] { return map_csv(report); }, [&] { return text_of(map_json(report), -1) + "\n"; },
                      [&] { return map_text(report); }});
}

// The whole turn from the start; of a slide the way that the profile drives it.
MapRange range_of(const MappedContact& mapped, const DriverSchedule& schedule, const MapOptions& options) {
  MapRange range;
  range.start = mapped.u;
  range.tolerance = options.tolerance;
  range.samples = options.samples.value_or(schedule.size() > 1 ? schedule.size() : kDefaultSamples);
  if (mapped.pair.motion1.turns) {
    return range;
  }
  double low = mapped.u;
  double high = mapped.u;
  for (std::int64_t k = 0; k < schedule.size(); ++k) {
    const double u =
        mapped.known.sign * schedule.state(k, static_cast<std::size_t>(*mapped.driver)).si.position;
    low = std::min(low, u);
    high = std::max(high, u);
  }
  range.start = low;
  range.end = high;
  return range;
}

ContactMapReport report_of(const Profile& profile, const MappedContact& mapped,
                           const DriverSchedule& schedule, const MapOptions& options) {
  ContactMapReport refused;
  refused.contact = profile.mechanism.contacts[static_cast<std::size_t>(mapped.contact)].name;
  refused.refusal = mapped.refusal;
  if (!refused.refusal.empty()) {
    return refused;
  }
  const MapRange range = range_of(mapped, schedule, options);
  if (!mapped.pair.motion1.turns && range.start == range.end) {
    refused.refusal = "the driver slides and stays where it is: give driver.end";
    return refused;
  }
  return map_report(profile, mapped, map_contacts(mapped.pair, range));
}

int fail(const MapOptions& options, const std::string& reason) {
  fmt::print(stderr, "{}: {}\n", options.profile, reason);
  return kExitMechanism;
}

void print_remarks(const MapOptions& options, const MapReport& report, const MappedContacts& mapped) {
  if (options.quiet) {
    return;
  }
  if (!mapped.not_started.empty()) {
    fmt::print(stderr, "{}: the mechanism stands on no branch: {}\n", options.profile, mapped.not_started);
  }
  const bool text = !options.csv && !options.json;
  for (const ContactMapReport& contact : report.contacts) {
    if (!contact.refusal.empty() && !text) {
      fmt::print(stderr, "{}: contacts.{}: no map: {}\n", options.profile, contact.contact, contact.refusal);
    }
    if (!contact.complete && !text) {
      fmt::print(stderr, "{}: contacts.{}: not every branch could be followed to its end\n", options.profile,
                 contact.contact);
    }
  }
}

// Why no contact has a map.
std::string refusal_of(const MapReport& report) {
  if (report.contacts.empty()) {
    return "the mechanism has no contact to map";
  }
  std::string text = "no contact has a map";
  for (const ContactMapReport& contact : report.contacts) {
    text += "; contacts." + contact.contact + ": " + contact.refusal;
  }
  return text;
}

}  // namespace

CLI::App* add_map_command(CLI::App& app, MapOptions& options) {
  CLI::App* command = app.add_subcommand(
      "map",
      "every contact of the two curves over the driver's turn: branches, and where they begin and end");
  command->add_option("FILE", options.profile, "profile of the mechanism (TOML)")->required();
  add_output_options(*command, {"the branches", options.csv}, {"the map", options.json});
  command
      ->add_option("--set", options.overrides, "PATH=VALUE: override or add a key of the profile; repeatable")
      ->allow_extra_args(false);
  command->add_option("--samples", options.samples, "number of rows over the range, both ends included")
      ->check(CLI::Range(std::int64_t{2}, std::int64_t{10'000'000}));
  command
      ->add_option("--tolerance", options.tolerance,
                   "largest overlap of a contact that counts as free, relative to the size")
      ->check(positive_number());
  command->add_flag("--quiet", options.quiet, "no remarks on standard error");
  return command;
}

int map_command(const MapOptions& options) {
  const auto profile = read_profile_file(options.profile, options.overrides);
  if (!profile) {
    return report_input(profile.error());
  }
  if (const auto code = refuse_without_driver(options.profile, *profile)) {
    return *code;
  }
  const auto schedule = DriverSchedule::analyze(*profile);
  if (!schedule) {
    return report_input(schedule.error());
  }
  const auto mapped = mapped_contacts(profile->mechanism, schedule->first_positions(), options.tolerance);
  if (!mapped) {
    return fail(options, mapped.error());
  }
  MapReport report;
  report.title = profile->mechanism.title;
  report.length_unit = unit_text(dimension::kLength, profile->units);
  report.angle_unit = unit_text(dimension::kAngle, profile->units);
  for (const MappedContact& contact : mapped->contacts) {
    report.contacts.push_back(report_of(*profile, contact, *schedule, options));
  }
  if (std::all_of(report.contacts.begin(), report.contacts.end(),
                  [](const ContactMapReport& contact) { return !contact.refusal.empty(); })) {
    return fail(options, refusal_of(report));
  }
  if (!write_all(options, report)) {
    return kExitMachine;
  }
  print_remarks(options, report, *mapped);
  const bool complete = std::all_of(report.contacts.begin(), report.contacts.end(),
                                    [](const ContactMapReport& contact) { return contact.complete; });
  return complete ? kExitOk : kExitRows;
}

}  // namespace higherpair::cli

#include "branches_command.hpp"

#include "branches_report.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "json_text.hpp"
#include "output_file.hpp"
#include "run_command.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <tl/expected.hpp>

namespace higherpair::cli {
namespace {

int write_all(const BranchesOptions& options, const BranchesReport& report) {
  const Forms forms = {[&] { return branches_csv(report); },
                       [&] { return text_of(branches_json(report)) + "\n"; },
                       [&] { return branches_text(report); }};
  if (!write_forms(options.csv, options.json, forms)) {
    return kExitMachine;
  }
  if ((options.csv || options.json) && !options.quiet) {
    for (const ContactReport& contact : report.contacts) {
      for (const std::string& remark : {contact.note, contact.certificate}) {
        if (!remark.empty()) {
          fmt::print(stderr, "{}: contacts.{}: {}\n", options.profile, contact.contact, remark);
        }
      }
    }
  }
  return kExitOk;
}

int fail(const BranchesOptions& options, const std::string& reason) {
  fmt::print(stderr, "{}: {}\n", options.profile, reason);
  return kExitMechanism;
}

// Lists the positions of one follower; an error ends the command with its exit code.
tl::expected<ContactReport, int> list_contact(const BranchesOptions& options, const Profile& profile,
                                              const ContactPlace& place) {
  const CurveContacts found = find_curve_contacts(place.pair, place.u);
  ContactReport report = report_on(profile, place, found);
  const std::string name = "contacts." + report.contact + ": ";
  if (found.status == ContactsStatus::kNoPair) {
    return tl::unexpected(fail(options, name + std::string(describe(found.status))));
  }
  if (options.certify) {
    const Certificate certificate = certify_contacts(place.pair, place.u, found);
    if (certificate.status == CertificateStatus::kDisagreement) {
      fmt::print(stderr, "{}: {}{}\n", options.profile, name, describe(certificate.status));
      return tl::unexpected(kExitMachine);
    }
    add_certificate(certificate, found, profile, place, report);
  }
  return report;
}

}  // namespace

int branches_command(const BranchesOptions& options) {
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
  const auto branches = list_branches(profile->mechanism, schedule->first_positions());
  if (!branches) {
    return fail(options, branches.error().reason);
  }
  BranchesReport report = report_on(*profile, *schedule, *branches);
  report.certified = options.certify;
  for (const ContactPlace& place : branches->contacts) {
    auto contact = list_contact(options, *profile, place);
    if (!contact) {
      return contact.error();
    }
    report.contacts.push_back(std::move(*contact));
  }
  const bool nothing = report.assemblies.empty() &&
                       std::all_of(report.contacts.begin(), report.contacts.end(),
                                   [](const ContactReport& contact) { return contact.entries.empty(); });
  const auto run = nothing ? start_run(profile->mechanism, schedule->first_positions(), options.tolerance)
                           : tl::expected<Run, StartFailure>();
  if (!run) {
    return fail(options, run.error().reason);
  }
  return write_all(options, report);
}

}  // namespace higherpair::cli

#include "branches_report.hpp"
#include "commands.hpp"
#include "option_checks.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "tell.hpp"

#include <memory>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

struct BranchesOptions : ProfileOptions {
  std::optional<std::string> csv;
  std::optional<std::string> json;
  BranchesSettings settings;
};

int write_all(const BranchesOptions& options, const BranchesReport& report) {
  const Forms forms = {[&] { return branches_csv(report); }, [&] { return branches_json(report); },
                       [&] { return branches_text(report); }};
  if (!write_forms(options.csv, options.json, forms)) {
    return exit_unwritten();
  }
  if ((options.csv || options.json) && !options.quiet) {
    for (const ContactReport& contact : report.contacts) {
      for (const std::string& remark :
           {contact.note, contact.complete ? "" : contact.proof, contact.certificate}) {
        if (!remark.empty()) {
          tell("{}: contacts.{}: {}\n", options.profile, contact.contact, remark);
        }
      }
    }
  }
  return kExitOk;
}

// Lists every contact at the first driver position; returns the exit code.
int branches_command(const BranchesOptions& options) {
  if (options.settings.certify && !can_certify()) {
    tell(
        "higherpair: --certify: this build has no exact arithmetic; configure it with "
        "-DHIGHERPAIR_EXACT=ON, which needs CGAL, GMP and MPFR\n");
    return kExitInput;
  }
  const auto report = open_model(options, given({{"--csv", options.csv}, {"--json", options.json}}))
                          .and_then([&](const Model& model) { return branches_of(model, options.settings); });
  return report ? write_all(options, *report) : report_error(report.error());
}

}  // namespace

CommandRun add_branches(CLI::App& command) {
  const auto options = std::make_shared<BranchesOptions>();
  add_profile_options(command, *options);
  add_output_options(command, options->profile, {"the list", options->csv}, {"the list", options->json});
  add_unused_samples(command, "the first driver position counts");
  command
      .add_option("--tolerance", options->settings.tolerance, "largest closure error, relative to the size")
      ->check(positive_number());
  command.add_flag("--certify", options->settings.certify, "decide every contact in exact arithmetic");
  return [options] { return branches_command(*options); };
}

}  // namespace higherpair::cli

#include "branches_command.hpp"

#include "branches_report.hpp"
#include "json_text.hpp"
#include "output_file.hpp"
#include "run_command.hpp"

#include <fmt/format.h>

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
      for (const std::string& remark :
           {contact.note, contact.complete ? "" : contact.proof, contact.certificate}) {
        if (!remark.empty()) {
          fmt::print(stderr, "{}: contacts.{}: {}\n", options.profile, contact.contact, remark);
        }
      }
    }
  }
  return kExitOk;
}

}  // namespace

int branches_command(const BranchesOptions& options) {
  if (options.certify && !can_certify()) {
    fmt::print(stderr,
               "higherpair: --certify: this build has no exact arithmetic; configure it with "
               "-DHIGHERPAIR_EXACT=ON, which needs CGAL, GMP and MPFR\n");
    return kExitInput;
  }
  const auto report = open_model(options.profile, options.overrides, options.quiet,
                                 given({{"--csv", options.csv}, {"--json", options.json}}))
                          .and_then([&](const Model& model) {
                            return branches_of(model, {options.certify, options.tolerance});
                          });
  return report ? write_all(options, *report) : report_error(report.error());
}

}  // namespace higherpair::cli

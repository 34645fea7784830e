#include "commands.hpp"
#include "design_report.hpp"
#include "journal.hpp"
#include "option_checks.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "search_bytes.hpp"
#include "signals.hpp"
#include "status_line.hpp"
#include "tell.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace higherpair::cli {
namespace {

struct DesignCommandOptions : ProfileOptions {
  std::string output;  ///< the new profile
  std::optional<std::string> json;
  std::optional<std::string> page;  ///< --report
  bool resume = false;
  DesignSettings settings;
};

std::string best_so_far(const DesignProgress& progress) {
  return fmt::format("{} searches, best {:.9g}{}", progress.starts, progress.objective,
                     progress.violation > kConstraintTolerance ? " (violates a constraint)" : "");
}

// The path of the numbered result: out/better.toml, out/better.2.toml, …
std::string numbered(const std::string& path, int number) {
  if (number == 1) return path;
  std::filesystem::path name(path);
  const std::string ending = name.extension().string();
  return name.replace_extension().string() + fmt::format(".{}", number) + ending;
}

// The best profile, and as many further ones of the best as there are.
std::vector<FileText> profiles_of(const DesignReport& report, const DesignCommandOptions& options) {
  std::vector<FileText> files = {{options.output, report.text}};
  for (std::size_t k = 1; k < report.optima.size() && !report.optima[k].text.empty(); ++k) {
    files.push_back({numbered(options.output, static_cast<int>(k + 1)), report.optima[k].text});
  }
  return files;
}

std::vector<NamedFile> outputs_of(const DesignCommandOptions& options) {
  std::vector<NamedFile> outputs =
      given({{"--output", options.output}, {"--json", options.json}, {"--report", options.page}});
  for (int k = 2; k <= options.settings.best; ++k) {
    outputs.push_back({fmt::format("--best {}", k), numbered(options.output, k)});
  }
  return outputs;
}

void check_options(const DesignCommandOptions& options) {
  if (options.output == "-" && options.settings.best > 1) {
    throw CLI::ValidationError("--best", "several profiles need a file name: --output BETTER.toml");
  }
  if (options.resume && is_direct(options.output)) {
    throw CLI::ValidationError("--resume",
                               "needs a regular file as --output: only beside it is kept what is done");
  }
  check_files({{"FILE", options.profile}}, outputs_of(options));
}

// Everything that the result of a single search depends on; their number is not part of it.
RunIdentity identity_of(const DesignCommandOptions& options, const Model& model) {
  RunIdentity identity = model_identity(options.profile, model);
  identity["--set"] = sum_of(options.overrides);
  identity["--seed"] = options.settings.seed ? fmt::format("{}", *options.settings.seed) : "-";
  return identity;
}

DesignSettings settings_of(const DesignCommandOptions& options, StatusLine& line) {
  DesignSettings settings = options.settings;
  settings.progress = [&line](const DesignProgress& progress) { line.show(best_so_far(progress)); };
  return settings;
}

// Runs the searches that are not in the journal yet. If the disk is full the search goes on, only unrecorded.
Result<DesignReport> find_design(const Model& model, const DesignCommandOptions& options,
                                 std::vector<DesignSearchEnd> known, Journal& journal) {
  StatusLine line(!options.quiet);
  DesignSettings settings = settings_of(options, line);
  settings.known = std::move(known);
  if (!journal.path().empty()) {
    settings.ended = [&journal](const DesignSearchEnd& end) {
      if (journal.error().empty()) (void)journal.append(search_bytes(end));
    };
  }
  return design(model, settings);
}

// Removes the journal, or reports where it is kept.
void end_journal(Journal& journal, bool goes_on) {
  if (!journal.error().empty()) {
    tell("higherpair: {}\n", journal.error());
  }
  if (!goes_on || journal.records() == 0) {
    journal.remove();
  } else if (!journal.path().empty()) {
    tell("higherpair: {} searches are kept in {}: --resume goes on from there\n", journal.records(),
         journal.path());
  }
}

// Writes the results; returns the exit code. A page that cannot be made keeps nothing else from being
// written.
int write_report(const Model& model, const DesignCommandOptions& options, const DesignReport& report) {
  std::vector<FileText> files = profiles_of(report, options);
  if (options.json) files.push_back({*options.json, design_json(report)});
  std::optional<Error> no_page;
  if (options.page) {
    if (auto page = design_page(model, report)) {
      files.push_back({*options.page, *std::move(page)});
    } else {
      no_page = std::move(page.error());
    }
  }
  const bool to_output = options.output == "-" || options.json == "-" || options.page == "-";
  // The best so far is written after a signal, too.
  if (!write_files(files, report.end == DesignEnd::kStopped ? nullptr : &interruption())) {
    return exit_unwritten();
  }
  if (!to_output) {
    fmt::print("{}", design_text(report));
  }
  if (no_page) {
    return report_error(*no_page);
  }
  if (report.end == DesignEnd::kStopped) {
    return kExitInterrupted;
  }
  const bool as_found = std::all_of(report.optima.begin(), report.optima.end(),
                                    [](const auto& optimum) { return optimum.as_found.value_or(true); });
  return report.holds && as_found ? kExitOk : kExitRows;
}

// Searches for the design that the profile asks for and writes it as a profile; returns the exit code: 4 if
// the best design found violates a constraint or a profile does not start as it was found, 130 if the search
// was interrupted; the best so far is written all the same. If the output is a regular file, finished
// searches are kept in OUTPUT.searches until it is written.
int design_command(const DesignCommandOptions& options) {
  const auto model = open_model(options, outputs_of(options));
  if (!model) {
    return report_error(model.error());
  }
  listen_to_signals();
  Journal journal(is_direct(options.output) ? "" : target_of(options.output) + ".searches", "search");
  std::vector<DesignSearchEnd> known;
  const auto take = [&](std::string_view record) {
    auto end = search_of(record);
    const bool readable = end.has_value();
    if (readable) known.push_back(*std::move(end));
    return readable;
  };
  if (!journal.path().empty() && !journal.open(identity_of(options, *model), options.resume, take)) {
    return report_journal(journal);
  }
  print_notes(design_notes(*model), options.quiet);
  const auto report = find_design(*model, options, std::move(known), journal);
  const int code = report ? write_report(*model, options, *report) : report_error(report.error());
  end_journal(journal, code == kExitInterrupted || code == kExitMachine);
  return code;
}

}  // namespace

CommandRun add_design(CLI::App& command) {
  const auto options = std::make_shared<DesignCommandOptions>();
  options->settings.stop = &interruption();
  add_profile_options(command, *options, "profile of the mechanism with [design] (TOML)");
  command.add_option("-o,--output", options->output, "the new profile; -: standard output")->required();
  command.add_option("--json", options->json, "what was found as JSON, to this file; -: standard output");
  command.add_option("--report", options->page, "a page with what was found, drawn before and after (HTML)");
  command
      .add_option("--best", options->settings.best,
                  "number of different designs, the best first: BETTER.toml, BETTER.2.toml, ... (default 1)")
      ->check(CLI::Range(1, 10));
  command
      .add_option("--seed", options->settings.seed,
                  "of the random starts (default 1): the same seed, the same result")
      ->check(not_negative());
  command
      .add_option("--time", options->settings.seconds, "seconds after which the best so far is the result")
      ->check(positive_number());
  command
      .add_option("--evaluations", options->settings.evaluations,
                  "candidates after which no further search begins (default 2000000)")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000'000}));
  command.add_option("--starts", options->settings.starts, "searches (default 200)")
      ->check(CLI::Range(1, 100'000'000));
  add_threads_option(command, options->settings.threads);
  command.add_flag("--resume", options->resume,
                   "go on where an interrupted run of the same search has ended");
  command.final_callback([options] { check_options(*options); });
  return [options] { return design_command(*options); };
}

}  // namespace higherpair::cli

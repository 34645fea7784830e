#include "sweep_command.hpp"

#include "commands.hpp"
#include "hdf5_file.hpp"
#include "higherpair/higherpair.hpp"
#include "journal.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "signals.hpp"
#include "sweep/block_bytes.hpp"
#include "sweep/progress.hpp"
#include "sweep/table_file.hpp"
#include "tell.hpp"

#include <charconv>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace higherpair::cli {
namespace {

struct Part {
  int number = 1;
  int of = 1;
};

// Parses "3/8"; none if it is not a valid part.
std::optional<Part> part_of(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto number = [](std::string_view digits) {
    int value = 0;
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return status == std::errc() && end == digits.data() + digits.size() ? value : 0;
  };
  if (slash == std::string_view::npos) {
    return std::nullopt;
  }
  const Part part = {number(text.substr(0, slash)), number(text.substr(slash + 1))};
  return part.number >= 1 && part.number <= part.of ? std::optional(part) : std::nullopt;
}

CLI::Validator part_option() {
  return {[](const std::string& text) {
            return part_of(text)
                       ? std::string()
                       : fmt::format("'{}' is no part; expected K/N, such as 3/8, K from 1 to N", text);
          },
          "K/N"};
}

void check_output(const SweepOptions& options) {
  const std::string& path = options.output;
  check_files({{"FILE", options.profile}}, {{"--output", path}});
  if (is_direct(path)) {
    if (is_hdf5(path)) throw CLI::ValidationError("--output", path + ": HDF5 needs a regular file");
    if (options.resume) {
      throw CLI::ValidationError("--resume",
                                 "needs a regular file as --output: only beside it is kept what is done");
    }
    return;
  }
  if (is_hdf5(path)) {
    if (const auto objection = hdf5_objection()) {
      throw CLI::ValidationError("--output", path + ": " + *objection + "; choose a .csv");
    }
  } else if (!path.ends_with(".csv")) {
    throw CLI::ValidationError("--output", path + ": expected a name that ends in .csv, .h5 or .hdf5");
  }
}

// Everything that the table depends on.
RunIdentity identity_of(const SweepOptions& options, const Model& model) {
  RunIdentity identity = model_identity(options.profile, model);
  identity["--set"] = sum_of(options.overrides);
  identity["--samples"] = options.samples ? fmt::format("{}", *options.samples) : "-";
  identity["--tolerance"] = fmt::format("{}", options.tolerance);
  identity["--part"] = options.part;
  return identity;
}

// Warns of unreadable variants before hours are spent.
void print_forecast(const SweepForecast& forecast) {
  if (forecast.unreadable > 0) {
    tell(
        "higherpair: of {} variants that were tried {} cannot be read, about {:.2g} % of all; they "
        "become rows "
        "with the status not_started. The first, variant {}: {}\n",
        forecast.tried, forecast.unreadable,
        100 * static_cast<double>(forecast.unreadable) / static_cast<double>(forecast.tried),
        forecast.variant, forecast.cause);
  }
}

// Prints why the sweep has stopped, if there is a reason to give, and how much of it is kept.
void print_stop(std::string why, const Journal& journal, const SweepSummary& summary, const Sweep& sweep) {
  if (!journal.path().empty()) {
    why += fmt::format("{}{} of {} variants are kept in {}: --resume goes on from there",
                       why.empty() ? "" : "; ", summary.variants(), sweep.size(), journal.path());
  }
  if (!why.empty()) tell("higherpair: {}\n", why);
}

// Computes all blocks that are not in the journal; returns the exit code if it does not reach the end.
std::optional<int> run_blocks(const SweepOptions& options, const OpenedSweep& opened, const SweepRunner& run,
                              Journal& journal, SweepSummary& summary) {
  const Sweep& sweep = opened.sweep;
  SweepProgress progress(summary.variants(), sweep.size(), !options.quiet);
  run(opened, journal.records(), [&](const SweepBlock& block) {
    if (!journal.append(block_bytes(block, sweep.columns().size()))) {
      return false;
    }
    summary.add(block);
    progress.at(summary.variants());
    return !interruption();
  });
  progress.clear();
  if (!journal.error().empty()) {
    print_stop(journal.error(), journal, summary, sweep);
    return kExitMachine;
  }
  if (summary.variants() < sweep.size()) {
    print_stop("interrupted", journal, summary, sweep);
    return kExitInterrupted;
  }
  return std::nullopt;
}

int finish(const SweepOptions& options, const Model& model, const Sweep& sweep, Journal& journal,
           SweepSummary& summary) {
  const std::string& title = model.mechanism().title;
  bool all = true;
  const EachBlock each = [&](const std::function<void(const SweepBlock&)>& take) {
    const TakeBlock place = [&](const SweepBlock& block) {
      summary.place(block);
      take(block);
      return !interruption();
    };
    all = journal.read(records_as_blocks(sweep.columns().size(), place));
    return all;
  };
  const auto failure = write_table(options.output, sweep, {title, options.profile}, options.threads, each);
  if (failure || !all) {
    const bool interrupted = !all && journal.error().empty();
    print_stop(interrupted ? "interrupted" : all ? *failure : journal.error(), journal, summary, sweep);
    return interrupted ? kExitInterrupted : kExitMachine;
  }
  journal.remove();
  if (!options.quiet && !is_direct(options.output)) {
    fmt::print("{}", summary.text(title));
  }
  return summary.good() ? kExitOk : kExitRows;
}

}  // namespace

void add_sweep_options(CLI::App& command, SweepOptions& options) {
  add_profile_options(command, options);
  command.add_option("-o,--output", options.output, "table of the results: .csv or .h5 (-: standard output)");
  command.add_option("--samples", options.samples,
                     "number of rows of each variant, in place of driver.samples");
  add_tolerance_option(command, options.tolerance);
  add_threads_option(command, options.threads);
  command.add_flag("--resume", options.resume, "go on where an interrupted run of the same sweep has ended");
  command.add_option("--part", options.part, "the Kth of N equal parts of the variants alone")
      ->check(part_option());
  command.final_callback([&options] { check_output(options); });
}

Result<OpenedSweep> open_sweep(const SweepOptions& options, const std::atomic<bool>& stop) {
  auto model = open_model(options, {{"--output", options.output}});
  if (!model) {
    return tl::unexpected(std::move(model.error()));
  }
  listen_to_signals();
  const Part part = part_of(options.part).value_or(Part());
  auto sweep = Sweep::of(*model, {options.tolerance, options.samples, part.number, part.of, &stop});
  if (!sweep) {
    return tl::unexpected(std::move(sweep.error()));
  }
  RunIdentity identity = identity_of(options, *model);
  return OpenedSweep{*std::move(model), *std::move(sweep), std::move(identity)};
}

int sweep_command(const SweepOptions& options, const SweepRunner& run) {
  const auto opened = open_sweep(options, interruption());
  if (!opened) {
    return report_error(opened.error());
  }
  const Sweep& sweep = opened->sweep;
  SweepSummary summary(sweep);
  Journal journal(is_direct(options.output) ? "" : target_of(options.output) + ".blocks", "sweep");
  const TakeBlock add = [&](const SweepBlock& block) {
    summary.add(block);
    return true;
  };
  if (!journal.open(opened->identity, options.resume, records_as_blocks(sweep.columns().size(), add))) {
    return report_journal(journal);
  }
  if (!options.quiet) {
    print_forecast(sweep.forecast());
  }
  if (const auto code = run_blocks(options, *opened, run, journal, summary)) {
    return *code;
  }
  return finish(options, opened->model, sweep, journal, summary);
}

CommandRun add_sweep(CLI::App& command) {
  const auto options = std::make_shared<SweepOptions>();
  add_sweep_options(command, *options);
  return [options] {
    return sweep_command(*options, [&](const OpenedSweep& opened, std::int64_t first, const auto& take) {
      run_sweep(opened.sweep, first, options->threads, take);
    });
  };
}

}  // namespace higherpair::cli

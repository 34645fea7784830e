// Random contacts and mechanisms, every result of which is tested against laws. Failing cases are reduced and
// printed as profiles.
#include "child.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "packs_law.hpp"
#include "random_sketch.hpp"
#include "rows_law.hpp"
#include "shrink_sketch.hpp"
#include "trial.hpp"
#include "truth_law.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <limits>
#include <map>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

namespace {

using higherpair::fire::Case;
using higherpair::fire::Cases;
using higherpair::fire::Counts;
using higherpair::fire::Depth;
using higherpair::fire::Trial;

void print_failure(long number, const Case& one, const Trial& trial, Depth depth) {
  fmt::print("# case {}, row {}: {}: {}\n", number, trial.failure.row, trial.failure.law,
             trial.failure.detail);
  const Case small = higherpair::fire::shrink(one, trial.failure.law, depth);
  const Trial again = higherpair::fire::try_case(small, depth);
  fmt::print("# shrunk, row {}: {}\n{}\n", again.failure.row, again.failure.detail,
             higherpair::fire::profile_of(small, "broken law: " + trial.failure.law));
  std::fflush(stdout);  // a long run may be stopped by the user
}

void print_summary(std::uint64_t seed, const Counts& counts, const std::map<std::string, long>& broken) {
  for (const auto& [law, times] : broken) {
    fmt::print("broken law: {}: {}\n", law, times);
  }
  fmt::print(
      "seed {}: {} cases, {} with a contact, {} profiles run, {} refused, {} rows of which {} flagged, {} "
      "rates against differences, {} cases failed\n",
      seed, counts.cases, counts.found, counts.runs, counts.refused, counts.rows, counts.flagged,
      counts.compared, counts.failed);
}

struct Options {
  std::string law = "pairs";
  std::string kind = "all";
  bool print = false;
  bool shrink = true;
  unsigned patience = 20;
  double shrinking = 60;  // seconds
  std::uint64_t seed = 1;
  long first = 0;
  long count = 1000;
  double seconds = 0;  // 0: no limit
  long every = 1;
  long shown = 10;
};

int run(const Options& options) {
  Cases cases(options.seed);
  Counts counts;
  std::map<std::string, long> broken;  // number of failures of each law
  const auto start = std::chrono::steady_clock::now();
  for (long i = 0; i - options.first < options.count; ++i) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    if (options.seconds > 0 && spent.count() > options.seconds) {
      break;
    }
    const Case one = cases.next();
    if (i < options.first) {
      continue;
    }
    const Depth depth = i % options.every == 0 ? Depth::kWhole : Depth::kPair;
    const Trial trial = higherpair::fire::try_case(one, depth);
    counts += trial.counts;
    if (trial.failure) {
      ++broken[trial.failure.law];
      if (counts.failed <= options.shown) {
        print_failure(i, one, trial, depth);
      }
    }
  }
  print_summary(options.seed, counts, broken);
  return counts.failed == 0 && counts.found > 0 ? 0 : 1;
}

using higherpair::fire::ChildResult;
using higherpair::fire::Failure;
using higherpair::fire::Sketch;
using higherpair::fire::SketchKind;

// Tests a case against the rows or truth law, in a child process.
Failure try_rows(const Sketch& sketch, const Options& options) {
  const ChildResult result = higherpair::fire::in_child(
      [&]() -> std::string {
        const auto profile =
            higherpair::read_profile_text(higherpair::fire::profile_of(sketch, "case"), "case");
        if (!profile) {
          return "refused by the reader\n" + to_string(profile.error().front());
        }
        if (options.law == "truth" && !sketch.twin.empty()) {
          const auto twin = higherpair::read_profile_text(
              higherpair::fire::profile_of(sketch.twin.front(), "twin"), "twin");
          if (!twin) {
            return "twin refused by the reader\n" + to_string(twin.error().front());
          }
          const Failure failure = higherpair::fire::twin_law(*profile, *twin);
          return failure.law + "\n" + failure.detail;
        }
        const Failure failure = options.law == "truth"
                                    ? higherpair::fire::truth_law(*profile)
                                    : higherpair::fire::rows_law(*profile, sketch.duration > 0);
        return failure.law + "\n" + failure.detail;
      },
      options.patience);
  if (result.end != ChildResult::End::kAnswered) {
    return {result.end == ChildResult::End::kLate ? "no end" : "crash", "", 0};
  }
  const std::size_t line = result.answer.find('\n');
  return {result.answer.substr(0, line), result.answer.substr(line + 1), 0};
}

struct Tally {
  long cases = 0;
  long failed = 0;
  std::map<std::string, long> broken;
  std::map<std::string, long> passed;  // by remark
};

// Prints the reduced case as a profile; its number identifies the original one. A case without an end takes
// all its processor time at every trial, so the reduction ends after some time.
void print_sketch(SketchKind kind, long number, const Sketch& sketch, const Failure& failure,
                  const Options& options) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(options.shrinking);
  const auto still_fails = [&](const Sketch& smaller) {
    return Clock::now() < end && try_rows(smaller, options).law == failure.law;
  };
  const bool shrinks = options.shrink && (options.law != "truth" || sketch.twin.empty());
  const Sketch small = shrinks ? shrink(sketch, still_fails) : sketch;
  if (shrinks && Clock::now() >= end) {
    fmt::print("# not made smaller after {} seconds\n", options.shrinking);
  }
  fmt::print("{}\n", profile_of(small, fmt::format("{} {}: {}", name_of(kind), number, failure.law)));
}

Tally try_kind(SketchKind kind, const Options& options) {
  Tally tally;
  for (long i = options.first; i < options.first + options.count; ++i) {
    const Sketch sketch = higherpair::fire::random_sketch(kind, options.seed, static_cast<std::uint64_t>(i));
    if (options.print) {
      fmt::print("{}\n", profile_of(sketch, fmt::format("{} {}", name_of(kind), i)));
      for (const Sketch& twin : sketch.twin) {
        fmt::print("{}\n", profile_of(twin, fmt::format("twin of {} {}", name_of(kind), i)));
      }
      continue;
    }
    ++tally.cases;
    const Failure failure = try_rows(sketch, options);
    if (!failure && !failure.detail.empty()) {
      ++tally.passed[failure.detail];
    }
    if (failure) {
      ++tally.failed;
      const bool shown = ++tally.broken[failure.law] <= options.shown;
      fmt::print("# {} {}: {}: {}\n", name_of(kind), i, failure.law, failure.detail);
      if (shown) {
        print_sketch(kind, i, sketch, failure, options);
      }
      std::fflush(stdout);
    }
  }
  return tally;
}

int run_rows(const Options& options) {
  long failed = 0;
  const auto one = higherpair::fire::kind_named(options.kind);
  for (const SketchKind kind : one ? std::vector{*one} : higherpair::fire::all_kinds()) {
    const Tally tally = try_kind(kind, options);
    if (options.print) {
      continue;
    }
    failed += tally.failed;
    fmt::print("{}: {} of {} cases fail\n", name_of(kind), tally.failed, tally.cases);
    for (const auto& [law, times] : tally.broken) {
      fmt::print("    {:4} {}\n", times, law);
    }
    for (const auto& [remark, times] : tally.passed) {
      fmt::print("    ({} passed: {})\n", times, remark);
    }
  }
  return failed == 0 ? 0 : 1;
}

int run_packs(const Options& options) {
  long tried = 0;
  long broken = 0;
  for (const std::string_view kind : higherpair::fire::chain_kinds()) {
    if (options.kind == "all" || options.kind == kind) {
      ++tried;
      broken += higherpair::fire::try_packs(kind, options.seed, options.first, options.count);
    }
  }
  if (tried == 0) {
    fmt::print(stderr, "fire: --kind {}: the packs law knows {}\n", options.kind,
               fmt::join(higherpair::fire::chain_kinds(), ", "));
  }
  return broken == 0 && tried > 0 ? 0 : 1;
}

int start(int argc, char** argv) {
  Options options;
  CLI::App app("Random contacts and mechanisms against the laws that they have to obey.", "fire");
  app.add_option("--seed", options.seed, "of the first case; the same cases for a seed everywhere");
  app.add_option("--first", options.first, "number of the first case to try; 0 unless given")
      ->check(CLI::NonNegativeNumber);
  const CLI::Option* count =
      app.add_option("--count", options.count, "number of cases; 1000 if --seconds is not given either")
          ->check(CLI::NonNegativeNumber);
  app.add_option("--seconds", options.seconds, "stop after so long, however few cases")
      ->check(CLI::PositiveNumber);
  app.add_option("--whole", options.every, "read and run the whole profile of every so manyth case only")
      ->check(CLI::PositiveNumber);
  app.add_option("--show", options.shown, "print at most so many failures")->check(CLI::NonNegativeNumber);
  app.add_option(
         "--law", options.law,
         "pairs: contacts and their rates; rows: that nothing depends on the rows; packs: rows worked out "
         "many at a time")
      ->check(CLI::IsMember({"pairs", "rows", "truth", "packs"}));
  app.add_option("--kind", options.kind, "of mechanisms for the other laws; all unless given");
  app.add_flag("--print", options.print, "print the profiles only");
  app.add_flag("!--whole-cases", options.shrink, "print failing mechanisms as they are, not made small");
  app.add_option("--patience", options.patience, "seconds of processor time that a case may take");
  app.add_option("--shrinking", options.shrinking,
                 "seconds that making a failing mechanism small may take; 60 unless given")
      ->check(CLI::NonNegativeNumber);
  CLI11_PARSE(app, argc, argv);
  if (options.seconds > 0 && count->count() == 0) {
    options.count = std::numeric_limits<long>::max();
  }
  if (options.law == "packs") {
    return run_packs(options);
  }
  return options.law != "pairs" ? run_rows(options) : run(options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return start(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "fire: {}\n", error.what());
    return 1;
  }
}

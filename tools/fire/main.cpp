// Trial by fire: random contacts and mechanisms, every result held against laws; what fails is made small and
// printed as a profile.
#include "trial.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <limits>
#include <map>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

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
  std::fflush(stdout);  // a long run may be stopped by hand
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
  std::map<std::string, long> broken;  // how often each law
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
  CLI11_PARSE(app, argc, argv);
  if (options.seconds > 0 && count->count() == 0) {
    options.count = std::numeric_limits<long>::max();
  }
  return run(options);
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

#include "higherpair/design/optimise.hpp"

#include "higherpair/numeric/stop.hpp"
#include "numeric/arena.hpp"
#include "numeric/random.hpp"
#include "search.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <unordered_map>
#include <utility>

namespace higherpair {
namespace {

// The best so far becomes known to further searches after every batch of this many. The size does not depend
// on the number of threads, which therefore does not affect the result.
constexpr int kBatch = 16;

// A search begins at the best of this many random candidates, since most linkages cannot turn at all.
constexpr int kCandidates = 40;

// Every third search begins near the best so far.
constexpr int kNearBest = 3;

constexpr std::size_t kMostOptima = 10;

bool holds(const DesignPoint& point) {
  return !point.x.empty() && point.violation <= kConstraintTolerance;
}

bool is_sound(const DesignVariable& variable) {
  return variable.low < variable.high && std::isfinite(variable.high - variable.low) &&
         std::isfinite(variable.start) && std::isfinite(variable.step) && variable.step >= 0 &&
         (!variable.log || variable.low > 0);
}

class Optimiser {
public:
  Optimiser(const DesignProblem& problem, const DesignOptions& options)
      : problem_(problem), options_(options), deadline_{options.stop, end_of(options.seconds)} {
    for (const DesignSearchEnd& end : options.known) {
      const bool fits = end.best.x.empty() || end.best.x.size() == problem.variables.size();
      if (fits && end.evaluations > 0) known_[end.number] = &end;
    }
  }

  DesignOutcome run() {
    std::optional<DesignEnd> end;
    for (int first = 0; !end; first += kBatch) {
      const int count = std::min(kBatch, std::max(1, options_.starts) - first);
      for (const DesignSearchEnd& one : run_batch(first, count)) {
        take(one);
        end = end ? end : end_after();
        if (end && *end != DesignEnd::kTime && *end != DesignEnd::kStopped) {
          break;  // what the batch found beyond the end is dropped: it would depend on the batch's size
        }
      }
      report();
    }
    return finished(*end);
  }

private:
  static std::chrono::steady_clock::time_point end_of(double seconds) {
    using Clock = std::chrono::steady_clock;
    constexpr double kYear = 365 * 86400.0;  // more than a year may be more than the clock can count
    return seconds > 0 && seconds < kYear
               ? Clock::now() + std::chrono::ceil<Clock::duration>(std::chrono::duration<double>(seconds))
               : Clock::time_point::max();
  }

  // Results of the searches in order; one that was not run for lack of time has 0 evaluations.
  std::vector<DesignSearchEnd> run_batch(int first, int count) {
    std::vector<DesignSearchEnd> ends(static_cast<std::size_t>(count));
    for_each_on_threads(ends.size(), options_.threads, [&](std::size_t k) {
      const int number = first + static_cast<int>(k);
      DesignSearchEnd& end = ends[k];
      if (const auto known = known_.find(number); known != known_.end()) {
        end = *known->second;
      } else if (number == 0 || !deadline_.is_over()) {
        end = search_from(number);
        tell(end);
      }
    });
    return ends;
  }

  // Not after the deadline: a search that was cut short would have ended elsewhere.
  void tell(const DesignSearchEnd& end) {
    if (options_.ended && !deadline_.is_over()) {
      const std::lock_guard lock(telling_);
      options_.ended(end);
    }
  }

  [[nodiscard]] DesignSearchEnd search_from(int start) const {
    Random random(options_.seed, start);
    Search search(problem_, problem_.start_branch, deadline_);
    Eigen::VectorXd u(search.size());
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      const DesignVariable& variable = problem_.variables[i];
      u(i) = to_unit(variable, variable.start);
    }
    if (start > 0 && start % kNearBest == 0 && !best_.x.empty()) {
      search.use_branch(best_.branch);
      u = near_best(search, random);
    } else if (start > 0) {
      u = best_of_candidates(search, random);
    }
    search_locally(search, u, options_.method, random.number());
    return {start, search.best(), search.evaluations()};
  }

  [[nodiscard]] Eigen::VectorXd near_best(const Search& search, Random& random) const {
    Eigen::VectorXd u = search.unit_of(best_.x);
    const double share = kNearBestLeast * std::pow(kNearBestMost / kNearBestLeast, random.uniform());
    for (double& v : u) {
      v = std::clamp(v + share * (2 * random.uniform() - 1), 0.0, 1.0);
    }
    return u;
  }

  // The search goes on in the branch of the best candidate.
  [[nodiscard]] Eigen::VectorXd best_of_candidates(Search& search, Random& random) const {
    DesignPoint best;
    for (int k = 0; k < kCandidates && !search.stopped(); ++k) {
      search.use_branch(random.below(problem_.branches));
      Eigen::VectorXd u(search.size());
      std::generate(u.begin(), u.end(), [&] { return random.uniform(); });
      (void)search.evaluate(u);
      if (!search.best().x.empty() && (best.x.empty() || is_better(search.best(), best))) {
        best = search.best();
      }
    }
    if (best.x.empty()) {
      return Eigen::VectorXd::Constant(search.size(), 0.5);
    }
    search.use_branch(best.branch);
    return search.unit_of(best.x);
  }

  void take(const DesignSearchEnd& result) {
    if (result.evaluations == 0) {
      return;
    }
    ++starts_;
    evaluations_ += result.evaluations;
    if (result.best.x.empty()) {
      return;
    }
    if (best_.x.empty() || is_better(result.best, best_)) {
      best_ = result.best;
    }
    const auto same = std::find_if(optima_.begin(), optima_.end(),
                                   [&](const DesignPoint& other) { return is_same(result.best, other); });
    if (same == optima_.end()) {
      optima_.push_back(result.best);
    } else if (is_better(result.best, *same)) {
      *same = result.best;
    }
  }

  [[nodiscard]] bool is_same(const DesignPoint& a, const DesignPoint& b) const {
    for (std::size_t i = 0; i < a.x.size(); ++i) {
      const DesignVariable& variable = problem_.variables[i];
      if (std::abs(to_unit(variable, a.x[i]) - to_unit(variable, b.x[i])) > kSameOptimum) {
        return false;
      }
    }
    return a.branch == b.branch;
  }

  [[nodiscard]] std::optional<DesignEnd> end_after() const {
    if (options_.target && holds(best_) && best_.objective <= *options_.target) return DesignEnd::kTarget;
    if (evaluations_ >= options_.evaluations) return DesignEnd::kEvaluations;
    if (is_raised(options_.stop)) return DesignEnd::kStopped;
    if (deadline_.is_over()) return DesignEnd::kTime;
    if (starts_ >= options_.starts) return DesignEnd::kStarts;
    return std::nullopt;
  }

  void report() const {
    if (options_.progress) {
      options_.progress({evaluations_, starts_, best_.objective, best_.violation});
    }
  }

  [[nodiscard]] DesignOutcome finished(DesignEnd end) {
    DesignOutcome outcome;
    outcome.free = outcome.best = best_;
    outcome.starts = starts_;
    outcome.end = end;
    // What is left to do is short: it may take longer than the time that the searches had.
    const Deadline deadline{end == DesignEnd::kStopped ? nullptr : options_.stop};
    std::int64_t further = 0;
    if (!best_.x.empty()) {
      outcome.best = made(best_, deadline, further);
      outcome.multipliers = multipliers_of(outcome.best, deadline, further);
    }
    outcome.different = static_cast<int>(optima_.size());
    std::stable_sort(optima_.begin(), optima_.end(), is_better);
    optima_.resize(std::min(optima_.size(), kMostOptima));
    outcome.optima = std::move(optima_);
    const auto count = static_cast<std::size_t>(std::max(0, options_.alternatives));
    for (std::size_t k = 0; k < std::min(count, outcome.optima.size()); ++k) {
      outcome.made.push_back(k == 0 ? outcome.best : made(outcome.optima[k], deadline, further));
    }
    outcome.evaluations = evaluations_ + further;
    return outcome;
  }

  // The design rounded to the steps of the variables.
  [[nodiscard]] DesignPoint made(const DesignPoint& point, const Deadline& deadline,
                                 std::int64_t& evaluations) const {
    const bool stepped = std::any_of(problem_.variables.begin(), problem_.variables.end(),
                                     [](const DesignVariable& variable) { return variable.step > 0; });
    if (!stepped) {
      return point;
    }
    Search search(problem_, point.branch, deadline);
    DesignPoint rounded = rounded_to_steps(search, point, options_.method);
    evaluations += search.evaluations();
    return rounded;
  }

  // Those of the remaining problem: variables with steps stay where they are.
  [[nodiscard]] std::vector<double> multipliers_of(const DesignPoint& point, const Deadline& deadline,
                                                   std::int64_t& evaluations) const {
    Search search(problem_, point.branch, deadline);
    for (std::size_t i = 0; i < point.x.size(); ++i) {
      if (problem_.variables[i].step > 0) search.fix(i, point.x[i]);
    }
    std::vector<double> multipliers = multipliers_at(search, point);
    evaluations += search.evaluations();
    return multipliers;
  }

  const DesignProblem& problem_;
  const DesignOptions& options_;
  Deadline deadline_;
  std::unordered_map<int, const DesignSearchEnd*> known_;
  std::mutex telling_;
  DesignPoint best_;
  std::vector<DesignPoint> optima_;
  int starts_ = 0;
  std::int64_t evaluations_ = 0;
};

}  // namespace

const std::vector<std::string>& design_method_names() {
  static const std::vector<std::string> names = {"auto",   "least-squares", "slsqp",
                                                 "cobyla", "bobyqa",        "isres"};
  return names;
}

DesignOutcome optimise(const DesignProblem& problem, const DesignOptions& options) {
  const auto& variables = problem.variables;
  const bool sound = !variables.empty() && std::all_of(variables.begin(), variables.end(), is_sound);
  return sound ? Optimiser(problem, options).run() : DesignOutcome{};
}

}  // namespace higherpair

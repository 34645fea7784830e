#include "fit_starts.hpp"

#include "front/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/stop.hpp"
#include "numeric/arena.hpp"
#include "numeric/random.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace higherpair {
namespace {

constexpr int kMostIterations = 100;
constexpr int kBoundedStarts = 12;  // searches where all variables have bounds
constexpr int kCandidates = 10;     // random points, the best of which begins a search

class Starts {
public:
  Starts(const FitProblem& problem, const FitSettings& settings) : problem_(problem), settings_(settings) {}

  // Each search is independent, so that the number of threads makes no difference.
  FitStart best() {
    const Eigen::VectorXd first = problem_.start();
    const int count = start_count();
    FitStart found{first, 1, 1};
    if (count == 1) return found;
    std::vector<LeastSquaresFit> ends(static_cast<std::size_t>(count));
    const auto one = [&](int k) {
      if (stopped()) return;
      const auto from = k == 0 ? std::optional(first) : random_start(k);
      if (from) {
        ends[k] = minimise(problem_, *from, problem_.spread_scales(), settings_.stop);
      }
      tell(ends[k], count);
    };
    one(0);
    for_each_on_threads(ends.size() - 1, settings_.threads,
                        [&](std::size_t k) { one(static_cast<int>(k) + 1); });
    const LeastSquaresFit* best = nullptr;
    std::vector<const LeastSquaresFit*> different;
    found.starts = 0;
    for (const LeastSquaresFit& end : ends) {
      if (!std::isfinite(end.sum)) continue;
      ++found.starts;
      if (std::none_of(different.begin(), different.end(),
                       [&](const LeastSquaresFit* other) { return is_same(end.x, other->x); })) {
        different.push_back(&end);
      }
      if (best == nullptr || end.sum < best->sum * (1 - kBetterSum)) best = &end;
    }
    found.different = static_cast<int>(different.size());
    if (best != nullptr) found.x = best->x;
    return found;
  }

private:
  [[nodiscard]] bool stopped() const { return is_raised(settings_.stop); }

  [[nodiscard]] int start_count() const {
    const auto& variables = problem_.data().variables->variables;
    const bool bounded = std::all_of(variables.begin(), variables.end(), [](const auto& variable) {
      return std::isfinite(variable.range.low) && std::isfinite(variable.range.high);
    });
    return problem_.data().task.starts.value_or(bounded ? kBoundedStarts : 1);
  }

  // The sum of squares is in units of spread.
  void tell(const LeastSquaresFit& end, int count) {
    if (!settings_.progress) return;
    const std::lock_guard lock(telling_);
    least_ = std::min(least_, end.sum);
    ++progress_.starts;
    progress_.all_starts = count;
    progress_.off = std::sqrt(least_ / static_cast<double>(problem_.values().size()));
    settings_.progress(progress_);
  }

  [[nodiscard]] double range(Eigen::Index i) const {
    const double width = problem_.high()(i) - problem_.low()(i);
    return std::isfinite(width) ? width : problem_.motion().scale(static_cast<std::size_t>(i));
  }

  [[nodiscard]] bool is_same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    for (Eigen::Index i = 0; i < eigen_index(problem_.data().variables->variables.size()); ++i) {
      if (std::abs(a(i) - b(i)) > kSameFitEnd * range(i)) return false;
    }
    return true;
  }

  [[nodiscard]] std::optional<Eigen::VectorXd> random_start(int number) const {
    Random random(problem_.data().task.seed.value_or(1), number);
    std::optional<Eigen::VectorXd> best;
    double least = kInf;
    for (int k = 0; k < kCandidates && !stopped(); ++k) {
      std::vector<double> variables;
      for (Eigen::Index i = 0; i < eigen_index(problem_.data().variables->variables.size()); ++i) {
        const double share = random.uniform();
        const double low = problem_.low()(i), high = problem_.high()(i);
        const double at = problem_.data().variables->variables[i].range.start;
        variables.push_back(std::isfinite(low) && std::isfinite(high)
                                ? low + share * (high - low)
                                : std::clamp(at + (share - 0.5) * range(i), low, high));
      }
      const auto x = problem_.start_from(variables);
      const auto residuals = x ? problem_.residuals(*x) : std::nullopt;
      const double sum = residuals ? problem_.squares(*residuals) : least;
      if (sum < least) {
        least = sum;
        best = x;
      }
    }
    return best;
  }

  const FitProblem& problem_;
  const FitSettings& settings_;
  std::mutex telling_;
  FitProgress progress_;
  double least_ = kInf;
};

}  // namespace

LeastSquaresFit minimise(const FitProblem& problem, const Eigen::VectorXd& from,
                         const Eigen::VectorXd& scales, const std::atomic<bool>* stop) {
  LeastSquaresProblem squares;
  squares.residuals = [&](const Eigen::VectorXd& x, Eigen::VectorXd& r) {
    auto residuals = problem.residuals(x);
    if (!residuals) return false;
    r = residuals->cwiseProduct(scales);
    return true;
  };
  squares.jacobian = [&](const Eigen::VectorXd& x, Eigen::MatrixXd& J) {
    auto jacobian = problem.jacobian(x);
    if (!jacobian) return false;
    J = scales.asDiagonal() * *jacobian;
    return true;
  };
  squares.low = problem.low();
  squares.high = problem.high();
  LeastSquaresOptions options;
  options.iterations = kMostIterations;
  options.stop = stop;
  for (std::size_t i = 0; i < problem.values().size(); ++i) {
    options.rounding = std::max(
        options.rounding, kValueNoise * problem.largest(problem.values()[i].column) * scales(eigen_index(i)));
  }
  return least_squares(squares, from, options);
}

FitStart best_start(const FitProblem& problem, const FitSettings& settings) {
  return Starts(problem, settings).best();
}

}  // namespace higherpair

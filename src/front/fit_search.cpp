#include "fit_search.hpp"

#include "arena.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace higherpair {
namespace {

constexpr double kHuberBend = 1.345, kTukeyEnd = 4.685;
constexpr double kOfDeviation = 1.4826;   // of normal noise: standard deviation over median of sizes
constexpr double kNoiseRounding = 1e-13;  // of the largest value of a column: what no noise is smaller than
constexpr double kSettled = 1e-6;         // noise and weights that change by less
constexpr int kMostRounds = 60, kMostIterations = 100;
constexpr int kHuberRounds = 3;     // before Tukey's loss, which forgets what is far off at once
constexpr int kBoundedStarts = 12;  // where all variables have bounds
constexpr int kCandidates = 10;     // random ones of which the best is where a search begins
constexpr double kSameEnd = 1e-4;   // of a range: ends of two searches are one

using Sizes = std::vector<double>;

// The sizes of all residuals of a column, ascending.
Sizes sizes_in(const FitProblem& problem, const Eigen::VectorXd& residuals, std::size_t column) {
  Sizes sizes;
  for (std::size_t i = 0; i < problem.values().size(); ++i) {
    if (problem.values()[i].column == column) sizes.push_back(std::abs(residuals(place(i))));
  }
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

double median_of(const Sizes& sizes) {
  const std::size_t n = sizes.size();
  return n == 0 ? 0 : (sizes[(n - 1) / 2] + sizes[n / 2]) / 2;
}

class Search {
public:
  Search(const FitProblem& problem, const FitSettings& settings)
      : problem_(problem), settings_(settings), loss_(problem.data().task.loss) {}

  FitSolution run() {
    solution_.x = best_start();
    const auto residuals = problem_.residuals(solution_.x, &solution_.missing);
    if (!residuals) {
      return std::move(solution_);
    }
    solution_.started = true;
    solution_.residuals = *residuals;
    find_constant_columns();
    solution_.noise.resize(problem_.data().columns.size());
    solution_.weights = Eigen::VectorXd::Ones(residuals->size());
    refine();
    return std::move(solution_);
  }

private:
  [[nodiscard]] bool stopped() const { return settings_.stop != nullptr && settings_.stop->load(); }

  // Least squares of residuals in these units.
  [[nodiscard]] LeastSquaresFit minimise(const Eigen::VectorXd& from, const Eigen::VectorXd& scales,
                                         int iterations) const {
    LeastSquaresProblem squares;
    squares.residuals = [&](const Eigen::VectorXd& x, Eigen::VectorXd& r) {
      auto residuals = problem_.residuals(x);
      if (!residuals) return false;
      r = residuals->cwiseProduct(scales);
      return true;
    };
    squares.jacobian = [&](const Eigen::VectorXd& x, Eigen::MatrixXd& J) {
      auto jacobian = problem_.jacobian(x);
      if (!jacobian) return false;
      J = scales.asDiagonal() * *jacobian;
      return true;
    };
    squares.low = problem_.low();
    squares.high = problem_.high();
    LeastSquaresOptions options;
    options.iterations = iterations;
    options.stop = settings_.stop;
    for (std::size_t i = 0; i < problem_.values().size(); ++i) {
      options.rounding = std::max(options.rounding,
                                  1e-15 * problem_.largest(problem_.values()[i].column) * scales(place(i)));
    }
    return least_squares(squares, from, options);
  }

  // By the spread of each column, before its noise is known.
  [[nodiscard]] Eigen::VectorXd spread_scales() const {
    Eigen::VectorXd scales(place(problem_.values().size()));
    for (std::size_t i = 0; i < problem_.values().size(); ++i) {
      scales(place(i)) = 1 / problem_.spread(problem_.values()[i].column);
    }
    return scales;
  }

  [[nodiscard]] int start_count() const {
    const auto& variables = problem_.data().variables->variables;
    const bool bounded = std::all_of(variables.begin(), variables.end(), [](const auto& variable) {
      return std::isfinite(variable.range.low) && std::isfinite(variable.range.high);
    });
    return problem_.data().task.starts.value_or(bounded ? kBoundedStarts : 1);
  }

  // Each by itself, so that the number of threads makes no difference.
  Eigen::VectorXd best_start() {
    const Eigen::VectorXd first = problem_.start();
    const int count = start_count();
    solution_.starts = 1;
    solution_.different = 1;
    if (count == 1) return first;
    std::vector<LeastSquaresFit> ends(static_cast<std::size_t>(count));
    const Eigen::VectorXd scales = spread_scales();
    const auto one = [&](int k) {
      const auto from = k == 0 ? std::optional(first) : random_start(k);
      if (from && !stopped()) ends[static_cast<std::size_t>(k)] = minimise(*from, scales, kMostIterations);
    };
    one(0);
    for_each_on_threads(ends.size() - 1, settings_.threads,
                        [&](std::size_t k) { one(static_cast<int>(k) + 1); });
    const LeastSquaresFit* best = nullptr;
    std::vector<const LeastSquaresFit*> different;
    solution_.starts = 0;
    for (const LeastSquaresFit& end : ends) {
      if (!std::isfinite(end.sum)) continue;
      ++solution_.starts;
      if (std::none_of(different.begin(), different.end(),
                       [&](const LeastSquaresFit* other) { return is_same(end.x, other->x); })) {
        different.push_back(&end);
      }
      if (best == nullptr || end.sum < best->sum * (1 - 1e-9)) best = &end;
    }
    solution_.different = static_cast<int>(different.size());
    return best == nullptr ? first : best->x;
  }

  [[nodiscard]] double range(Eigen::Index i) const {
    const double width = problem_.high()(i) - problem_.low()(i);
    return std::isfinite(width) ? width : problem_.motion().scale(static_cast<std::size_t>(i));
  }

  [[nodiscard]] bool is_same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    for (Eigen::Index i = 0; i < place(problem_.data().variables->variables.size()); ++i) {
      if (std::abs(a(i) - b(i)) > kSameEnd * range(i)) return false;
    }
    return true;
  }

  [[nodiscard]] std::optional<Eigen::VectorXd> random_start(int number) const {
    const std::uint64_t seed = problem_.data().task.seed.value_or(1);
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                           static_cast<std::uint32_t>(number)};
    std::mt19937_64 engine(sequence);
    std::optional<Eigen::VectorXd> best;
    double least = std::numeric_limits<double>::infinity();
    const Eigen::VectorXd scales = spread_scales();
    for (int k = 0; k < kCandidates && !stopped(); ++k) {
      std::vector<double> variables;
      for (Eigen::Index i = 0; i < place(problem_.data().variables->variables.size()); ++i) {
        const double share = static_cast<double>(engine() >> 11) * 0x1p-53;
        const double low = problem_.low()(i), high = problem_.high()(i);
        const double at = problem_.data().variables->variables[static_cast<std::size_t>(i)].range.start;
        variables.push_back(std::isfinite(low) && std::isfinite(high)
                                ? low + share * (high - low)
                                : std::clamp(at + (share - 0.5) * range(i), low, high));
      }
      const auto x = problem_.start_from(variables);
      const auto residuals = x ? problem_.residuals(*x) : std::nullopt;
      const double sum = residuals ? residuals->cwiseProduct(scales).squaredNorm() : least;
      if (sum < least) {
        least = sum;
        best = x;
      }
    }
    return best;
  }

  void find_constant_columns() {
    constexpr double kNothing = 1e-12;  // of the largest change
    const auto jacobian = problem_.jacobian(solution_.x);
    const std::size_t count = problem_.data().columns.size();
    solution_.constant.assign(count, false);
    if (!jacobian) return;
    Eigen::VectorXd effects = Eigen::VectorXd::Zero(place(count));
    const std::size_t variables = problem_.data().variables->variables.size();
    for (std::size_t i = 0; i < problem_.values().size(); ++i) {
      const std::size_t column = problem_.values()[i].column;
      for (Eigen::Index p = 0; p < problem_.size(); ++p) {
        const auto unknown = static_cast<std::size_t>(p);
        const double scale = unknown < variables ? problem_.motion().scale(unknown) : 1;
        const double effect = std::abs((*jacobian)(place(i), p)) * scale / problem_.spread(column);
        effects(place(column)) = std::max(effects(place(column)), effect);
      }
    }
    for (std::size_t c = 0; c < count; ++c) {
      solution_.constant[c] = effects(place(c)) <= kNothing * effects.maxCoeff();
    }
  }

  // Noise of each column from its residuals: per degree of freedom, robustly where the loss is.
  [[nodiscard]] std::vector<double> estimated_noise() const {
    const auto count = static_cast<double>(problem_.values().size());
    const double freedoms = count - static_cast<double>(problem_.size());
    const double share = freedoms > 0 ? std::sqrt(count / freedoms) : 1;
    std::vector<double> noise;
    for (std::size_t c = 0; c < problem_.data().columns.size(); ++c) {
      const Sizes sizes = sizes_in(problem_, solution_.residuals, c);
      double square = 0;
      for (const double size : sizes) square += size * size;
      const double estimate =
          loss_ == FitLoss::kSquares
              ? std::sqrt(square / static_cast<double>(std::max<std::size_t>(1, sizes.size())))
              : kOfDeviation * median_of(sizes);
      noise.push_back(std::max(share * estimate, kNoiseRounding * problem_.largest(c)));
    }
    return noise;
  }

  // Sets noise and weights from the residuals; by how much they have changed.
  double reweight(FitLoss loss) {
    const std::vector<FitColumn>& columns = problem_.data().columns;
    const std::vector<double> estimated = estimated_noise();
    double change = 0;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double next = columns[c].deviation.value_or(estimated[c]);
      if (solution_.noise[c] > 0) change = std::max(change, std::abs(next / solution_.noise[c] - 1));
      solution_.noise[c] = next;
    }
    solution_.deviations = estimated;
    for (std::size_t i = 0; i < problem_.values().size(); ++i) {
      const double u = solution_.residuals(place(i)) / solution_.noise[problem_.values()[i].column];
      const double weight = weight_of(loss, u);
      change = std::max(change, std::abs(weight - solution_.weights(place(i))));
      solution_.weights(place(i)) = weight;
    }
    return change;
  }

  // Whether noise, known or not, makes no difference to where the least is.
  [[nodiscard]] bool is_plain() const {
    const std::vector<FitColumn>& columns = problem_.data().columns;
    std::size_t unknown = 0;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      unknown += columns[c].deviation || solution_.constant[c] ? 0 : 1;
    }
    const auto fitted =
        static_cast<std::size_t>(std::count(solution_.constant.begin(), solution_.constant.end(), false));
    return loss_ == FitLoss::kSquares && (unknown == 0 || (unknown == 1 && fitted == 1));
  }

  void refine() {
    (void)reweight(loss_ == FitLoss::kTukey ? FitLoss::kHuber : loss_);
    for (int round = 0; round < kMostRounds; ++round) {
      const LeastSquaresFit found = minimise(solution_.x, scales_of(problem_, solution_), kMostIterations);
      solution_.iterations += found.iterations;
      if (found.end == LeastSquaresEnd::kUndefined) return;
      solution_.x = found.x;
      if (auto residuals = problem_.residuals(solution_.x, &solution_.missing)) {
        solution_.residuals = *std::move(residuals);
      }
      const bool huber = loss_ == FitLoss::kTukey && round < kHuberRounds;
      const double change = reweight(huber ? FitLoss::kHuber : loss_);
      if (found.end == LeastSquaresEnd::kStopped) {
        solution_.end = FitEnd::kStopped;
        return;
      }
      const bool settled = is_plain() || (!huber && change <= kSettled);
      if (settled) {
        solution_.end = found.end == LeastSquaresEnd::kConverged ? FitEnd::kConverged : FitEnd::kNotConverged;
        return;
      }
    }
  }

  const FitProblem& problem_;
  const FitSettings& settings_;
  FitLoss loss_;
  FitSolution solution_;
};

}  // namespace

double weight_of(FitLoss loss, double u) {
  const double size = std::abs(u);
  switch (loss) {
    case FitLoss::kHuber:
      return size <= kHuberBend ? 1 : kHuberBend / size;
    case FitLoss::kTukey:
      return size < kTukeyEnd ? std::pow(1 - u * u / (kTukeyEnd * kTukeyEnd), 2) : 0;
    case FitLoss::kSquares:
      break;
  }
  return 1;
}

double slope_of(FitLoss loss, double u) {
  const double size = std::abs(u);
  switch (loss) {
    case FitLoss::kHuber:
      return size <= kHuberBend ? 1 : 0;
    case FitLoss::kTukey: {
      const double share = u * u / (kTukeyEnd * kTukeyEnd);
      return size < kTukeyEnd ? (1 - share) * (1 - 5 * share) : 0;
    }
    case FitLoss::kSquares:
      break;
  }
  return 1;
}

Eigen::VectorXd scales_of(const FitProblem& problem, const FitSolution& solution) {
  Eigen::VectorXd scales(place(problem.values().size()));
  for (std::size_t i = 0; i < problem.values().size(); ++i) {
    const std::size_t column = problem.values()[i].column;
    scales(place(i)) = solution.constant[column]
                           ? 0
                           : std::sqrt(problem.data().columns[column].weight * solution.weights(place(i))) /
                                 solution.noise[column];
  }
  return scales;
}

FitSolution solve_fit(const FitProblem& problem, const FitSettings& settings) {
  return Search(problem, settings).run();
}

}  // namespace higherpair

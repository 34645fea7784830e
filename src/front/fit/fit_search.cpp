#include "fit_search.hpp"

#include "fit_loss.hpp"
#include "fit_starts.hpp"
#include "front/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr double kOfDeviation = 1.4826;  // for normal noise: standard deviation divided by the median
                                         // absolute value
constexpr int kMostRounds = 60;          // of new weights; twelve are usually enough
constexpr int kHuberRounds = 3;          // before Tukey's loss, which ignores far-off values at once

using Sizes = std::vector<double>;

// The sizes of all residuals of a column, ascending.
Sizes sizes_in(const FitProblem& problem, const Eigen::VectorXd& residuals, std::size_t column) {
  Sizes sizes;
  for (std::size_t i = 0; i < problem.values().size(); ++i) {
    if (problem.values()[i].column == column) sizes.push_back(std::abs(residuals(eigen_index(i))));
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
    FitStart start = best_start(problem_, settings_);
    solution_.x = std::move(start.x);
    solution_.starts = start.starts;
    solution_.different = start.different;
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
  void find_constant_columns() {
    const auto jacobian = problem_.jacobian(solution_.x);
    const std::size_t count = problem_.data().columns.size();
    solution_.constant.assign(count, false);
    if (!jacobian) return;
    Eigen::VectorXd effects = Eigen::VectorXd::Zero(eigen_index(count));
    const std::size_t variables = problem_.data().variables->variables.size();
    for (std::size_t i = 0; i < problem_.values().size(); ++i) {
      const std::size_t column = problem_.values()[i].column;
      for (Eigen::Index p = 0; p < problem_.size(); ++p) {
        const auto unknown = static_cast<std::size_t>(p);
        const double scale = unknown < variables ? problem_.motion().scale(unknown) : 1;
        const double effect = std::abs((*jacobian)(eigen_index(i), p)) * scale / problem_.spread(column);
        effects(eigen_index(column)) = std::max(effects(eigen_index(column)), effect);
      }
    }
    for (std::size_t c = 0; c < count; ++c) {
      solution_.constant[c] = effects(eigen_index(c)) <= kNoFitChange * effects.maxCoeff();
    }
  }

  // Noise of each column from its residuals, per degree of freedom; a robust estimate if the loss is robust.
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
              : robust_noise(problem_, solution_.residuals, c);
      noise.push_back(std::max(share * estimate, kNoiseRounding * problem_.largest(c)));
    }
    return noise;
  }

  // Sets noise and weights from the residuals; returns by how much they have changed.
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
      const double u = solution_.residuals(eigen_index(i)) / solution_.noise[problem_.values()[i].column];
      const double weight = weight_of(loss, u);
      change = std::max(change, std::abs(weight - solution_.weights(eigen_index(i))));
      solution_.weights(eigen_index(i)) = weight;
    }
    return change;
  }

  // Whether the location of the minimum is independent of the noise.
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

  void tell(int rounds) const {
    if (!settings_.progress) return;
    const double sum = problem_.squares(solution_.residuals);
    settings_.progress({solution_.starts, solution_.starts, rounds,
                        std::sqrt(sum / static_cast<double>(problem_.values().size()))});
  }

  void refine() {
    (void)reweight(loss_ == FitLoss::kTukey ? FitLoss::kHuber : loss_);
    for (int round = 0; round < kMostRounds; ++round) {
      const LeastSquaresFit found =
          minimise(problem_, solution_.x, scales_of(problem_, solution_, solution_.weights), settings_.stop);
      solution_.iterations += found.iterations;
      if (found.end == LeastSquaresEnd::kUndefined) return;
      solution_.x = found.x;
      if (auto residuals = problem_.residuals(solution_.x, &solution_.missing)) {
        solution_.residuals = *std::move(residuals);
      }
      tell(round + 1);
      const bool huber = loss_ == FitLoss::kTukey && round < kHuberRounds;
      const double change = reweight(huber ? FitLoss::kHuber : loss_);
      if (found.end == LeastSquaresEnd::kStopped) {
        solution_.end = FitEnd::kStopped;
        return;
      }
      const bool settled = is_plain() || (!huber && change <= kNoiseSettled);
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

double robust_noise(const FitProblem& problem, const Eigen::VectorXd& residuals, std::size_t column) {
  return kOfDeviation * median_of(sizes_in(problem, residuals, column));
}

Eigen::VectorXd scales_of(const FitProblem& problem, const FitSolution& solution,
                          const Eigen::VectorXd& weights) {
  Eigen::VectorXd scales(eigen_index(problem.values().size()));
  for (std::size_t i = 0; i < problem.values().size(); ++i) {
    const std::size_t column = problem.values()[i].column;
    scales(eigen_index(i)) =
        solution.constant[column]
            ? 0
            : std::sqrt(problem.data().columns[column].weight * weights(eigen_index(i))) /
                  solution.noise[column];
  }
  return scales;
}

FitSolution solve_fit(const FitProblem& problem, const FitSettings& settings) {
  return Search(problem, settings).run();
}

}  // namespace higherpair

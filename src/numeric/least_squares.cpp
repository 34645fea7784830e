#include "least_squares.hpp"

#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/stop.hpp"
#include "higherpair/numeric/tolerances.hpp"
#include "least_norm.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/QR>

namespace higherpair {
namespace {

class Minimiser {
public:
  Minimiser(const LeastSquaresProblem& problem, const Eigen::VectorXd& start,
            const LeastSquaresOptions& options)
      : problem_(problem), options_(options), scale_(Eigen::VectorXd::Zero(start.size())) {
    fit_.x = within(start);
  }

  LeastSquaresFit run() {
    if (!problem_.residuals(fit_.x, fit_.r) || !fit_.r.allFinite()) {
      return std::move(fit_);
    }
    fit_.sum = fit_.r.squaredNorm();
    fit_.end = LeastSquaresEnd::kIterations;
    for (; fit_.iterations < options_.iterations; ++fit_.iterations) {
      if (const auto end = iterate()) {
        fit_.end = *end;
        break;
      }
    }
    return std::move(fit_);
  }

private:
  [[nodiscard]] bool is_stopped() const { return is_raised(options_.stop); }

  [[nodiscard]] Eigen::VectorXd within(const Eigen::VectorXd& x) const {
    return problem_.low.size() == 0 ? x : Eigen::VectorXd(x.cwiseMax(problem_.low).cwiseMin(problem_.high));
  }

  // One Jacobian, and steps with increasing damping until one reduces the sum.
  std::optional<LeastSquaresEnd> iterate() {
    if (is_stopped()) return LeastSquaresEnd::kStopped;
    Eigen::MatrixXd J;
    if (!problem_.jacobian(fit_.x, J) || !J.allFinite()) {
      return fit_.iterations == 0 ? LeastSquaresEnd::kUndefined : LeastSquaresEnd::kStuck;
    }
    fit_.J = std::move(J);
    scale_ = scale_.cwiseMax(fit_.J.colwise().norm().transpose());
    find_free();
    reduce();
    const double gain = best_gain();
    if (free_.empty() || gain <= std::max(kLeastGain * fit_.sum, rounding()))
      return LeastSquaresEnd::kConverged;
    unseen_ = gain <= kUnseenGain * fit_.sum;
    if (unseen_ && gain > gain_ / 2) return LeastSquaresEnd::kConverged;
    gain_ = gain;
    double raise = 2;
    while (!try_step()) {
      if (is_stopped()) return LeastSquaresEnd::kStopped;
      if (smallest_step_ || damping_ > kMostDamping) {
        return smallest_step_ || gain <= kNoGain * fit_.sum ? LeastSquaresEnd::kConverged
                                                            : LeastSquaresEnd::kStuck;
      }
      damping_ *= raise;
      raise *= 2;
    }
    return std::nullopt;
  }

  [[nodiscard]] double rounding() const {
    return static_cast<double>(fit_.r.size()) * options_.rounding * options_.rounding;
  }

  // All variables except those at a bound that would move beyond it, and those without any effect.
  void find_free() {
    free_.clear();
    const Eigen::VectorXd slope = fit_.J.transpose() * fit_.r;
    for (Eigen::Index i = 0; i < fit_.x.size(); ++i) {
      const bool bounded = problem_.low.size() > 0;
      const bool stays = (bounded && fit_.x(i) <= problem_.low(i) && slope(i) > 0) ||
                         (bounded && fit_.x(i) >= problem_.high(i) && slope(i) < 0);
      if (!stays && scale_(i) > 0) free_.push_back(i);
    }
  }

  // The parts of J and r that steps need: free variables, scaled, with as many rows as columns.
  void reduce() {
    const auto n = static_cast<Eigen::Index>(free_.size());
    Eigen::MatrixXd both(fit_.r.size(), n + 1);
    for (Eigen::Index k = 0; k < n; ++k) {
      const Eigen::Index i = free_[k];
      both.col(k) = fit_.J.col(i) / scale_(i);
    }
    both.col(n) = fit_.r;
    const Eigen::MatrixXd factor = triangular_factor(both);
    R_ = factor.leftCols(n);
    c_ = factor.col(n);
  }

  [[nodiscard]] double best_gain() const {
    return free_.empty() ? 0 : (R_ * LeastNormSolver(R_, kNoChangeRank).solve(c_)).squaredNorm();
  }

  // In units of x.
  [[nodiscard]] Eigen::VectorXd damped_step() const {
    const Eigen::Index n = R_.cols();
    Eigen::MatrixXd A(R_.rows() + n, n);
    A << R_, std::sqrt(damping_) * Eigen::MatrixXd::Identity(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(A.rows());
    b.head(c_.size()) = -c_;
    const Eigen::VectorXd scaled = LeastNormSolver(A).solve(b);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(fit_.x.size());
    for (Eigen::Index k = 0; k < n; ++k) {
      const Eigen::Index i = free_[k];
      step(i) = scaled(k) / scale_(i);
    }
    return step;
  }

  // True where the sum decreased; the damping is adapted to how well the gain was predicted.
  bool try_step() {
    const Eigen::VectorXd x = within(fit_.x + damped_step());
    const Eigen::VectorXd step = x - fit_.x;
    smallest_step_ = (step.array().abs() <= kNoFitStep * fit_.x.array().abs()).all();
    Eigen::VectorXd r;
    if (smallest_step_ || !problem_.residuals(x, r) || !r.allFinite()) return false;
    const double sum = r.squaredNorm();
    if (!(sum < fit_.sum || (unseen_ && sum <= (1 + kSameSum) * fit_.sum))) return false;
    const double foretold = fit_.sum - (fit_.r + fit_.J * step).squaredNorm();
    const double ratio = foretold > 0 ? (fit_.sum - sum) / foretold : 0;
    damping_ = std::max(kLeastDamping, damping_ * std::max(0.1, 1 - std::pow(2 * ratio - 1, 3)));
    fit_.x = x;
    fit_.r = std::move(r);
    fit_.sum = sum;
    return true;
  }

  const LeastSquaresProblem& problem_;
  const LeastSquaresOptions& options_;
  LeastSquaresFit fit_;
  Eigen::VectorXd scale_;  // for each variable: how strongly r changes with it
  std::vector<Eigen::Index> free_;
  Eigen::MatrixXd R_;
  Eigen::VectorXd c_;
  double damping_ = kFirstDamping;
  bool smallest_step_ = false;
  // Predicted gain of the best step, at the last Jacobian.
  double gain_ = kInf;
  bool unseen_ = false;
};

}  // namespace

Eigen::MatrixXd triangular_factor(const Eigen::MatrixXd& matrix) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(matrix);
  const Eigen::Index rows = std::min(matrix.rows(), matrix.cols());
  return qr.matrixQR().topRows(rows).triangularView<Eigen::Upper>();
}

LeastSquaresFit least_squares(const LeastSquaresProblem& problem, const Eigen::VectorXd& start,
                              const LeastSquaresOptions& options) {
  return Minimiser(problem, start, options).run();
}

}  // namespace higherpair

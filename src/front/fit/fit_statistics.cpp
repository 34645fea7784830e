#include "fit_statistics.hpp"

#include "fit_loss.hpp"
#include "front/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/tolerances.hpp"
#include "numeric/joined_words.hpp"
#include "numeric/least_squares.hpp"
#include "numeric/singular_values.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <fmt/core.h>

namespace higherpair {
namespace {

// A basis in whose directions as many unknowns as possible have no part: reduced row echelon form.
Eigen::MatrixXd sparse_basis(Eigen::MatrixXd rows) {
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    Eigen::Index row = 0, column = 0;
    rows.bottomRows(rows.rows() - k).cwiseAbs().maxCoeff(&row, &column);
    rows.row(k).swap(rows.row(k + row));
    rows.row(k) /= rows(k, column);
    for (Eigen::Index other = 0; other < rows.rows(); ++other) {
      if (other != k) rows.row(other) -= rows(other, column) * rows.row(k);
    }
  }
  return rows;
}

std::string list_of(const std::vector<std::string>& names) {
  if (names.size() == 1) return names.front();
  return fmt::format("{} and {}", joined_words(std::span(names).first(names.size() - 1)), names.back());
}

// \param z  changes of the unknowns that leave the residuals unchanged; only unknowns with a part
std::string direction_text(const std::vector<double>& z, const std::vector<double>& x,
                           const std::vector<std::string>& names) {
  if (z.size() == 1) return fmt::format("these columns do not say what {} is", names[0]);
  const auto alike = [](double a, double b) {
    return std::abs(a - b) <= kAlikeChanges * std::max(std::abs(a), std::abs(b));
  };
  const bool all_sized = std::all_of(x.begin(), x.end(), [](double value) { return value != 0; });
  bool one_share = all_sized;
  for (std::size_t i = 0; all_sized && i < z.size(); ++i) {
    one_share = one_share && alike(z[i] / x[i], z[0] / x[0]);
  }
  std::string only;
  if (one_share) {
    only = z.size() == 2 ? "only their ratio" : "only their ratios";
  } else if (z.size() == 2) {
    if (all_sized && alike(z[0] / x[0], -z[1] / x[1])) only = "only their product";
    if (alike(z[0], z[1])) only = "only their difference";
    if (alike(z[0], -z[1])) only = "only their sum";
  }
  if (!only.empty()) {
    return fmt::format("{} cannot be told apart by these columns: {}", list_of(names), only);
  }
  std::vector<std::string> shares;
  for (const double change : z) shares.push_back(fmt::format("{:.4g}", change / z[0]));
  return fmt::format(
      "{} cannot be told apart by these columns: changes in the proportion {} leave them as they are",
      list_of(names), joined_words(shares, " : "));
}

// Pseudoinverse of JᵀJ: directions that are not determined are left out.
Eigen::MatrixXd covariance_shape(const Eigen::MatrixXd& J) {
  const Eigen::VectorXd lengths = J.colwise().norm().cwiseMax(kNeverZero);
  const SingularValues svd = singular_values(triangular_factor(J * lengths.cwiseInverse().asDiagonal()));
  Eigen::MatrixXd root = Eigen::MatrixXd::Zero(J.cols(), J.cols());
  for (Eigen::Index k = 0; k < svd.values.size(); ++k) {
    if (svd.values(k) > kFitRank * svd.values(0)) root.col(k) = svd.V.col(k) / svd.values(k);
  }
  root = lengths.cwiseInverse().asDiagonal() * root;
  return root * root.transpose();
}

// The variance of residuals in units of noise; for a robust loss, with the lower efficiency of its minimum.
// Huber, Robust Statistics, 1981, section 7.6.
double variance_factor(const FitProblem& problem, const FitSolution& solution, int freedoms) {
  const FitLoss loss = problem.data().task.loss;
  double square = 0, slopes = 0, slopes_square = 0, count = 0;
  for (std::size_t i = 0; i < problem.values().size(); ++i) {
    const std::size_t column = problem.values()[i].column;
    if (solution.constant[column]) continue;
    const double u = solution.residuals(eigen_index(i)) / solution.noise[column];
    const double root = std::sqrt(problem.data().columns[column].weight);
    square += std::pow(root * weight_of(loss, u) * u, 2);
    slopes += slope_of(loss, u);
    slopes_square += std::pow(slope_of(loss, u), 2);
    count += 1;
  }
  const double variance = square / freedoms;
  if (loss == FitLoss::kSquares) return variance;
  const double mean = slopes / count;
  const double spread = slopes_square / count - mean * mean;
  const double correction = 1 + static_cast<double>(problem.size()) / count * spread / (mean * mean);
  return correction * correction * variance / (mean * mean);
}

// The unknowns that are not held by a bound; notes which are.
std::vector<Eigen::Index> free_unknowns(const FitProblem& problem, const FitSolution& solution,
                                        const Eigen::MatrixXd& jacobian, FitStatistics& statistics) {
  const Eigen::VectorXd scales = scales_of(problem, solution, solution.weights);
  const Eigen::VectorXd slope = jacobian.transpose() * scales.cwiseAbs2().cwiseProduct(solution.residuals);
  std::vector<Eigen::Index> free;
  for (Eigen::Index k = 0; k < problem.size(); ++k) {
    const bool at_bound = (solution.x(k) <= problem.low()(k) && slope(k) >= 0) ||
                          (solution.x(k) >= problem.high()(k) && slope(k) <= 0);
    statistics.at_bound[k] = at_bound;
    if (!at_bound) free.push_back(k);
  }
  return free;
}

// Derivatives by the free unknowns in units of the noise. Not weighted by the loss: the curvature of a robust
// loss is part of variance_factor.
Eigen::MatrixXd noise_jacobian(const FitProblem& problem, const FitSolution& solution,
                               const Eigen::MatrixXd& jacobian, const std::vector<Eigen::Index>& free) {
  const Eigen::VectorXd plain = scales_of(problem, solution, Eigen::VectorXd::Ones(jacobian.rows()));
  return plain.asDiagonal() * jacobian(Eigen::all, free);
}

// Finds the free unknowns that the columns do not determine.
void find_undetermined(const FitProblem& problem, const FitSolution& solution, const Eigen::MatrixXd& J,
                       const std::vector<Eigen::Index>& free, FitStatistics& statistics) {
  std::vector<std::string> names;
  for (const Eigen::Index k : free) names.push_back(problem.unknowns()[k].name);
  std::vector<bool> determined(free.size(), true);
  statistics.undetermined = idle_directions(J, solution.x(free), names, determined);
  for (std::size_t k = 0; k < free.size(); ++k) {
    statistics.determined[free[k]] = determined[k];
  }
}

void set_errors(const Eigen::MatrixXd& covariance, const std::vector<Eigen::Index>& free,
                FitStatistics& statistics) {
  const auto is_determined = [&](std::size_t k) { return statistics.determined[free[k]]; };
  for (std::size_t k = 0; k < free.size(); ++k) {
    if (!is_determined(k)) continue;
    statistics.errors(free[k]) = std::sqrt(covariance(eigen_index(k), eigen_index(k)));
    for (std::size_t l = 0; l < free.size(); ++l) {
      if (!is_determined(l)) continue;
      const double product =
          covariance(eigen_index(k), eigen_index(k)) * covariance(eigen_index(l), eigen_index(l));
      statistics.correlation(free[k], free[l]) =
          k == l        ? 1
          : product > 0 ? covariance(eigen_index(k), eigen_index(l)) / std::sqrt(product)
                        : kNoValue;
    }
  }
}

// Whether the residuals can be compared with given deviations.
bool has_all_deviations(const FitProblem& problem, const FitSolution& solution) {
  const std::vector<FitColumn>& columns = problem.data().columns;
  bool all = problem.data().task.loss == FitLoss::kSquares;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    all = all && (solution.constant[c] || (columns[c].deviation && columns[c].weight == 1));
  }
  return all;
}

// The chance that a sum of squares of normal noise, of deviation 1, is larger; 0 where it is too large for a
// number.
double chance_beyond(double square, double freedoms) {
  if (!std::isfinite(square)) return 0;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(freedoms), square));
}

}  // namespace

std::vector<std::string> idle_directions(const Eigen::MatrixXd& J, const Eigen::VectorXd& x,
                                         const std::vector<std::string>& names,
                                         std::vector<bool>& determined) {
  const Eigen::VectorXd lengths = J.colwise().norm();
  std::vector<std::string> sentences;
  Eigen::MatrixXd scaled = J;
  for (Eigen::Index i = 0; i < J.cols(); ++i) {
    if (lengths(i) > 0) scaled.col(i) /= lengths(i);
  }
  const SingularValues svd = singular_values(triangular_factor(scaled));
  Eigen::Index rank = 0;
  while (rank < svd.values.size() && svd.values(rank) > kFitRank * svd.values(0)) ++rank;
  const Eigen::Index idle = J.cols() - rank;
  if (idle == 0) return sentences;
  const Eigen::MatrixXd basis = sparse_basis(svd.V.rightCols(idle).transpose());
  for (Eigen::Index k = 0; k < idle; ++k) {
    std::vector<double> z, values;
    std::vector<std::string> own;
    for (Eigen::Index i = 0; i < J.cols(); ++i) {
      if (std::abs(basis(k, i)) < kPartOfDirection) continue;
      z.push_back(lengths(i) > 0 ? basis(k, i) / lengths(i) : 1);
      values.push_back(x(i));
      own.push_back(names[i]);
      determined[i] = false;
    }
    sentences.push_back(direction_text(z, values, own));
  }
  return sentences;
}

double student_quantile(double freedoms, double confidence) {
  return freedoms > 0 ? boost::math::quantile(
                            boost::math::complement(boost::math::students_t(freedoms), (1 - confidence) / 2))
                      : kNoValue;
}

FitStatistics fit_statistics(const FitProblem& problem, const FitSolution& solution) {
  const auto n = static_cast<std::size_t>(problem.size());
  FitStatistics statistics;
  statistics.errors = Eigen::VectorXd::Constant(problem.size(), kNoValue);
  statistics.correlation = Eigen::MatrixXd::Constant(problem.size(), problem.size(), kNoValue);
  statistics.at_bound.assign(n, false);
  statistics.determined.assign(n, true);
  const auto jacobian = problem.jacobian(solution.x);
  if (!jacobian) return statistics;
  const std::vector<Eigen::Index> free = free_unknowns(problem, solution, *jacobian, statistics);
  for (const FitProblem::Value& value : problem.values()) {
    statistics.freedoms += solution.constant[value.column] ? 0 : 1;
  }
  statistics.freedoms -= static_cast<int>(free.size());
  if (free.empty()) return statistics;
  const Eigen::MatrixXd J = noise_jacobian(problem, solution, *jacobian, free);
  find_undetermined(problem, solution, J, free, statistics);
  if (statistics.freedoms < 1) return statistics;
  const double variance = variance_factor(problem, solution, statistics.freedoms);
  statistics.quantile = student_quantile(statistics.freedoms, problem.data().task.confidence);
  set_errors(variance * covariance_shape(J), free, statistics);
  if (has_all_deviations(problem, solution)) {
    statistics.noise_ratio = std::sqrt(variance);
    statistics.chance = chance_beyond(variance * statistics.freedoms, statistics.freedoms);
  }
  return statistics;
}

Succession succession_of(const std::vector<double>& residuals) {
  constexpr std::size_t kFewest = 12;
  Succession succession;
  const std::size_t n = residuals.size();
  if (n < kFewest) return succession;
  double mean = 0;
  for (const double r : residuals) mean += r / static_cast<double>(n);
  double square = 0, product = 0;
  for (std::size_t i = 0; i < n; ++i) {
    square += std::pow(residuals[i] - mean, 2);
    if (i > 0) product += (residuals[i] - mean) * (residuals[i - 1] - mean);
  }
  if (!(square > 0)) return succession;
  succession.correlation = product / square;
  succession.systematic = succession.correlation > kSuccessionWorthSaying &&
                          succession.correlation * std::sqrt(static_cast<double>(n)) > kSureSuccession;
  return succession;
}

}  // namespace higherpair

#pragma once

#include "higherpair/design/optimise.hpp"
#include "higherpair/numeric/stop.hpp"
#include "numeric/eigen_index.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

namespace higherpair {

/// Whether a ranks before b.
[[nodiscard]] bool is_better(const DesignPoint& a, const DesignPoint& b);

/// When searches end with the best so far: once a flag is raised, or at a time.
struct Deadline {
  const std::atomic<bool>* stop = nullptr;
  std::chrono::steady_clock::time_point time = std::chrono::steady_clock::time_point::max();

  [[nodiscard]] bool is_over() const { return is_raised(stop) || std::chrono::steady_clock::now() >= time; }
};

/// Evaluates candidates in unit variables, u from 0 to 1 over the range of each, and keeps the best of all
/// that it has seen.
class Search {
public:
  Search(const DesignProblem& problem, int branch, const Deadline& deadline);

  [[nodiscard]] const DesignProblem& problem() const { return problem_; }
  [[nodiscard]] Eigen::Index size() const { return eigen_index(problem_.variables.size()); }

  /// Values at u, which is clamped to its range; values that are not finite become a violation.
  const DesignValues& evaluate(const Eigen::VectorXd& u);
  /// Derivatives of the values at u with respect to u.
  const DesignJacobian& differentiate(const Eigen::VectorXd& u);

  [[nodiscard]] const DesignPoint& best() const { return best_; }
  [[nodiscard]] Eigen::VectorXd best_unit() const;
  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }
  [[nodiscard]] bool stopped() const { return deadline_.is_over(); }

  /// Fixes a variable at a value for all further evaluations.
  void fix(std::size_t variable, double value);
  [[nodiscard]] bool is_fixed(std::size_t variable) const { return fixed_[variable]; }
  /// Switches to a branch; the best so far is forgotten.
  void use_branch(int branch);

  [[nodiscard]] Eigen::VectorXd unit_of(const std::vector<double>& x) const;

private:
  void set_x(const Eigen::VectorXd& u);
  void work_out(const Eigen::VectorXd& u, DesignValues& values);
  void note(const DesignValues& values);
  [[nodiscard]] double slope(std::size_t i) const;  // dx/du
  void by_differences(const Eigen::VectorXd& u);

  const DesignProblem& problem_;
  std::unique_ptr<DesignEvaluator> evaluator_;
  int branch_ = 0;
  Deadline deadline_;
  std::vector<double> x_, fixed_x_;
  std::vector<bool> fixed_;
  DesignValues values_, near_values_;
  DesignJacobian jacobian_;
  // The u of values_ and jacobian_, which are cached as methods ask for one u several times; empty: none.
  Eigen::VectorXd values_at_, jacobian_at_;
  DesignPoint best_;
  std::int64_t evaluations_ = 0;
};

[[nodiscard]] double objective_of(const DesignValues& values);
[[nodiscard]] Eigen::RowVectorXd objective_slope(const DesignValues& values, const DesignJacobian& jacobian);
[[nodiscard]] double violation_of(const DesignValues& values);

/// The value of a variable from its unit variable, and back.
[[nodiscard]] double from_unit(const DesignVariable& variable, double u);
[[nodiscard]] double to_unit(const DesignVariable& variable, double x);

/// One local search from u; its result is search.best().
void search_locally(Search& search, const Eigen::VectorXd& u, DesignMethod method, std::uint64_t seed);

/// Levenberg-Marquardt from u, with violated constraints as further residuals. Returns where it ends.
Eigen::VectorXd fit_least_squares(Search& search, const Eigen::VectorXd& u);

/// One of NLopt's methods from u.
void search_by_nlopt(Search& search, const Eigen::VectorXd& u, DesignMethod method, std::uint64_t seed);

/// A design near `point`, in its branch, whose stepped variables are multiples of their steps, with the
/// others optimised again.
[[nodiscard]] DesignPoint rounded_to_steps(Search& search, const DesignPoint& point, DesignMethod method);

/// DesignOutcome::multipliers.
[[nodiscard]] std::vector<double> multipliers_at(Search& search, const DesignPoint& point);

}  // namespace higherpair

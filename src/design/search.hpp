#pragma once

#include "higherpair/design/optimise.hpp"
#include "higherpair/numeric/stop.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace higherpair {

/// Whether a is a better design than b.
[[nodiscard]] bool is_better(const DesignPoint& a, const DesignPoint& b);

/// Candidates in unit variables, u from 0 to 1 over the range of each, and the best that was ever seen of
/// them.
class Search {
public:
  Search(const DesignProblem& problem, int branch, const std::atomic<bool>* stop);

  [[nodiscard]] const DesignProblem& problem() const { return problem_; }
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(problem_.variables.size()); }

  /// Values at u, which is moved into its range; what is not finite becomes a violation.
  const DesignValues& evaluate(const Eigen::VectorXd& u);
  /// Derivatives by u of the values there.
  const DesignJacobian& differentiate(const Eigen::VectorXd& u);

  [[nodiscard]] const DesignPoint& best() const { return best_; }
  [[nodiscard]] Eigen::VectorXd best_unit() const;
  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }
  [[nodiscard]] bool stopped() const { return is_raised(stop_); }

  /// Keeps a variable at a value of its own from now on.
  void fix(std::size_t variable, double value);
  [[nodiscard]] bool is_fixed(std::size_t variable) const { return fixed_[variable]; }
  /// Goes on in another branch; the best so far is forgotten.
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
  int branch_;
  const std::atomic<bool>* stop_;
  std::vector<double> x_, fixed_x_;
  std::vector<bool> fixed_;
  DesignValues values_, near_values_;
  DesignJacobian jacobian_;
  Eigen::VectorXd values_at_,
      jacobian_at_;  // the u of both; empty: none. Methods ask for one u several times
  DesignPoint best_;
  std::int64_t evaluations_ = 0;
};

[[nodiscard]] double objective_of(const DesignValues& values);
[[nodiscard]] double violation_of(const DesignValues& values);

/// The x of a unit variable, and back.
[[nodiscard]] double from_unit(const DesignVariable& variable, double u);
[[nodiscard]] double to_unit(const DesignVariable& variable, double x);

/// One local search from u; its result is search.best().
void search_locally(Search& search, const Eigen::VectorXd& u, DesignMethod method, std::uint64_t seed);

/// Levenberg-Marquardt from u, constraints that do not hold as further residuals. Where it ends.
Eigen::VectorXd fit_least_squares(Search& search, const Eigen::VectorXd& u);

/// One of NLopt's methods from u.
void search_by_nlopt(Search& search, const Eigen::VectorXd& u, DesignMethod method, std::uint64_t seed);

/// The design of the search's branch nearest to `point` whose numbers are of the steps of their variables,
/// the other variables following.
[[nodiscard]] DesignPoint rounded_to_steps(Search& search, const DesignPoint& point, DesignMethod method);

/// DesignOutcome::multipliers.
[[nodiscard]] std::vector<double> multipliers_at(Search& search, const DesignPoint& point);

}  // namespace higherpair

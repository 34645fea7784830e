#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// A number that the optimiser may choose.
struct DesignVariable {
  double low = 0;    ///< < high
  double high = 1;   ///< finite, as are all
  double start = 0;  ///< one out of the range counts as its nearer end
  double step = 0;   ///< > 0: only multiples of it can be manufactured; 0: any value
  bool log = false;  ///< searched on a logarithmic scale, for lengths of unknown order of magnitude; low > 0
};

/// The values of a candidate: its objective is cost + the sum of squares of `residuals`.
struct DesignValues {
  double cost = 0;              ///< sum of the objectives that are not squares
  Eigen::VectorXd residuals;    ///< DesignProblem::residuals of them
  Eigen::VectorXd constraints;  ///< each holds if <= 0; scaled to the order of 1 for a bad violation
};

/// Derivatives of DesignValues with respect to the variables.
struct DesignJacobian {
  Eigen::RowVectorXd cost;
  Eigen::MatrixXd residuals;    ///< one row for each residual
  Eigen::MatrixXd constraints;  ///< one row for each constraint
};

/// Evaluates candidates; used by one thread at a time. The values of a candidate do not depend on earlier
/// calls. They are finite everywhere within the bounds, even for a candidate that cannot work at all: its
/// constraints then measure how far it is from working.
class DesignEvaluator {
public:
  DesignEvaluator() = default;
  DesignEvaluator(const DesignEvaluator&) = delete;
  DesignEvaluator& operator=(const DesignEvaluator&) = delete;
  virtual ~DesignEvaluator() = default;

  /// \param branch  0 … DesignProblem::branches - 1
  virtual void evaluate(std::span<const double> x, int branch, DesignValues& values) = 0;

  /// Exact derivatives at x, if the evaluator has them; false: differences are used instead.
  virtual bool differentiate(std::span<const double> x, int branch, DesignJacobian& jacobian);
};

/// The objective, and the constraints that have to hold.
struct DesignProblem {
  std::vector<DesignVariable> variables;
  Eigen::Index residuals = 0;
  Eigen::Index constraints = 0;
  bool has_cost = false;  ///< false: DesignValues::cost is always 0
  bool smooth = true;     ///< false: values jump or have kinks almost everywhere; no derivatives are used
  int branches = 1;       ///< discrete alternatives for the same variables, such as assemblies; nothing is
                          ///< continuous between them
  int start_branch = 0;   ///< branch of the start
  /// Makes a new evaluator, which needs this problem; may be called from any thread.
  std::function<std::unique_ptr<DesignEvaluator>()> evaluator;
};

/// Method of the local searches.
enum class DesignMethod {
  kAuto,          ///< kLeastSquares where there is no cost, else kSlsqp; kCobyla where values are not smooth
  kLeastSquares,  ///< Levenberg-Marquardt, then kSlsqp where a constraint is active
  kSlsqp,         ///< sequential quadratic programming, by gradients
  kCobyla,        ///< linear models from values alone, without derivatives
  kBobyqa,        ///< quadratic models from values alone; constraints become penalties
  kIsres,         ///< evolutionary search over the whole range, once for each start
};

/// "auto", "least-squares", "slsqp", "cobyla", "bobyqa", "isres".
[[nodiscard]] const std::vector<std::string>& design_method_names();

/// What a search has found so far.
struct DesignProgress {
  std::int64_t evaluations = 0;
  int starts = 0;        ///< searches finished
  double objective = 0;  ///< of the best so far
  double violation = 0;  ///< its largest constraint; <= 0: all hold
};

/// A design and its values.
struct DesignPoint {
  std::vector<double> x;  ///< of the variables, within their bounds; empty where no value was finite
  int branch = 0;
  double objective = std::numeric_limits<double>::infinity();
  double violation = std::numeric_limits<double>::infinity();  ///< the largest constraint; <= 0: all hold
};

/// Result of one search.
struct DesignSearchEnd {
  int number = 0;  ///< 0 … DesignOptions::starts - 1
  DesignPoint best;
  std::int64_t evaluations = 0;
};

/// How a search is run.
struct DesignRun {
  /// > 0: the searches end after this time with the best so far, which then depends on the machine.
  double seconds = 0;
  int threads = 0;  ///< 0 or less: all, at most 1024; makes no difference to the result
  const std::atomic<bool>* stop = nullptr;  ///< once true, the best so far is returned
  /// Called from the caller's thread, from time to time; may be empty.
  std::function<void(const DesignProgress&)> progress;
  /// Results of earlier searches for the same problem with the same method and seed, in any order: they are
  /// not repeated, and the outcome is the same to the last bit.
  std::vector<DesignSearchEnd> known;
  /// Receives the result of every other search, from one thread at a time; not of a search that was cut
  /// short. May be empty.
  std::function<void(const DesignSearchEnd&)> ended;
};

struct DesignOptions : DesignRun {
  DesignMethod method = DesignMethod::kAuto;
  std::uint64_t seed = 1;
  int starts = 200;  ///< local searches, >= 1; the first one from the start of the variables
  /// No further start once this many are used; an exact gradient counts as one, one by differences as two or
  /// three for each variable.
  std::int64_t evaluations = 1'000'000;
  /// The search ends once the objective is this small and all constraints hold.
  std::optional<double> target;
  int alternatives = 1;  ///< number of optima returned rounded to steps, in DesignOutcome::made
};

enum class DesignEnd { kStarts, kEvaluations, kTime, kTarget, kStopped };

/// What a search has found.
struct DesignOutcome {
  DesignPoint best;  ///< best of all candidates evaluated, rounded to the steps of the variables
  DesignPoint free;  ///< the same before rounding to steps
  /// Distinct results of the searches, best first: two differ by more than 1e-3 of its range in some
  /// variable, or in the branch. At most 10.
  std::vector<DesignPoint> optima;
  int different = 0;  ///< how many distinct results there were in all
  /// The first DesignOptions::alternatives of them, rounded to the steps of the variables; the first one is
  /// `best`.
  std::vector<DesignPoint> made;
  int starts = 0;  ///< searches finished in all
  std::int64_t evaluations = 0;
  DesignEnd end = DesignEnd::kStarts;
  /// Lagrange multiplier of each constraint: how much smaller the objective would be for each unit by which
  /// its limit is relaxed, to first order at `best`, while variables with steps keep their values; >= 0, and
  /// 0 if it is inactive or the multiplier is unknown.
  std::vector<double> multipliers;
};

/// A constraint counts as satisfied up to this value.
inline constexpr double kConstraintTolerance = 1e-9;

/// Many local searches from random points within the ranges and from points near the best so far: the method
/// that did best on path tasks of linkages, whose objectives have many local minima. The same seed gives the
/// same result for any number of threads. Designs in which all constraints hold rank before others, which
/// rank by their largest violation. A value that is not finite counts as a violation. Without variables, or
/// if one is not as DesignVariable says, nothing is searched and the outcome has no designs.
[[nodiscard]] DesignOutcome optimise(const DesignProblem& problem, const DesignOptions& options = {});

}  // namespace higherpair

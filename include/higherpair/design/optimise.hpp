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

/// A number that an optimiser may choose.
struct DesignVariable {
  double low = 0;   ///< < high
  double high = 1;  ///< finite
  double start = 0;
  double step = 0;   ///< > 0: only multiples of it can be made; 0: any number
  bool log = false;  ///< searched by its logarithm: for lengths of unknown order; low > 0
};

/// What a candidate is worth: the objective is cost + the sum of squares of `residuals`.
struct DesignValues {
  double cost = 0;              ///< of objectives that are no squares
  Eigen::VectorXd residuals;    ///< always so many
  Eigen::VectorXd constraints;  ///< each holds where it is <= 0; of the order of 1 where one misses by far
};

/// Derivatives of DesignValues by the variables.
struct DesignJacobian {
  Eigen::RowVectorXd cost;
  Eigen::MatrixXd residuals;    ///< one row for each residual
  Eigen::MatrixXd constraints;  ///< one row for each constraint
};

/// Works candidates out; used by one thread at a time. What it says of a candidate depends on nothing that it
/// was asked before. Values are finite everywhere within the bounds, also of what cannot work at all:
/// constraints say how far it is from that.
class DesignEvaluator {
public:
  DesignEvaluator() = default;
  DesignEvaluator(const DesignEvaluator&) = delete;
  DesignEvaluator& operator=(const DesignEvaluator&) = delete;
  virtual ~DesignEvaluator() = default;

  /// \param branch  0 … DesignProblem::branches - 1
  virtual void evaluate(std::span<const double> x, int branch, DesignValues& values) = 0;

  /// Exact derivatives at x, where the evaluator has them; false: they are to be made by differences.
  virtual bool differentiate(std::span<const double> x, int branch, DesignJacobian& jacobian);
};

/// The objective, and the constraints that have to hold.
struct DesignProblem {
  std::vector<DesignVariable> variables;
  Eigen::Index residuals = 0;
  Eigen::Index constraints = 0;
  bool has_cost = false;  ///< false: DesignValues::cost is always 0
  bool smooth = true;     ///< false: values jump or have kinks almost everywhere; no derivatives are used
  int branches = 1;       ///< different designs for the same variables, between which nothing is continuous
  int start_branch = 0;   ///< of the start
  /// A new evaluator; may be called by any thread.
  std::function<std::unique_ptr<DesignEvaluator>()> evaluator;
};

/// How a local search is done.
enum class DesignMethod {
  kAuto,          ///< kLeastSquares where there is no cost, else kSlsqp; kCobyla where values are not smooth
  kLeastSquares,  ///< Levenberg-Marquardt, then kSlsqp where a constraint is active
  kSlsqp,         ///< sequential quadratic programming, by gradients
  kCobyla,        ///< linear models of values alone
  kBobyqa,        ///< quadratic models of values alone; constraints become penalties
  kIsres,         ///< a search by evolution over the whole range, one for each start
};

/// "auto", "least-squares", "slsqp", "cobyla", "bobyqa", "isres".
[[nodiscard]] const std::vector<std::string>& design_method_names();

/// What a search has found so far.
struct DesignProgress {
  std::int64_t evaluations = 0;
  int starts = 0;        ///< searches that are done
  double objective = 0;  ///< of the best so far
  double violation = 0;  ///< its largest constraint; <= 0: all hold
};

/// A design and what it is worth.
struct DesignPoint {
  std::vector<double> x;  ///< of the variables, within their bounds
  int branch = 0;
  double objective = 0;
  double violation = 0;  ///< the largest constraint; <= 0: all hold
};

/// How one of the searches has ended.
struct DesignSearchEnd {
  int number = 0;    ///< 0 … DesignOptions::starts - 1
  DesignPoint best;  ///< x is empty where no value was finite
  std::int64_t evaluations = 0;
};

struct DesignOptions {
  DesignMethod method = DesignMethod::kAuto;
  std::uint64_t seed = 1;
  int starts = 200;  ///< local searches, >= 1; the first one from the start of the variables
  std::int64_t evaluations = 1'000'000;  ///< no further start once so many are used; a gradient counts as one
                                         ///< for each variable unless it is exact
  double seconds = 0;            ///< > 0: no further start after so long; what is found then depends on the
                                 ///< machine
  std::optional<double> target;  ///< enough once the objective is this small and all constraints hold
  int threads = 0;               ///< 0: all; makes no difference to the result
  int alternatives = 1;          ///< so many of the optima are given as they can be made
  const std::atomic<bool>* stop = nullptr;              ///< once true, the best so far is returned
  std::function<void(const DesignProgress&)> progress;  ///< called by the caller's thread, from time to time
  /// Ends of searches of the same problem with the same method and seed, in any order: they are not made
  /// again, and the outcome is the same to the last bit.
  std::vector<DesignSearchEnd> known;
  /// Gets the end of every other search, by one thread at a time; not of one that was stopped on its way.
  std::function<void(const DesignSearchEnd&)> ended;
};

enum class DesignEnd { kStarts, kEvaluations, kTime, kTarget, kStopped };

/// What a search has found.
struct DesignOutcome {
  DesignPoint best;  ///< of all that was ever evaluated; with numbers of the steps of the variables
  DesignPoint free;  ///< the same before they were rounded to steps
  /// Ends of the searches that differ, best first: by more than 1e-3 of a range in some variable. At most 10.
  std::vector<DesignPoint> optima;
  int different = 0;  ///< how many they were
  /// The first DesignOptions::alternatives of them with numbers of the steps of the variables; the first one
  /// is `best`.
  std::vector<DesignPoint> made;
  int starts = 0;  ///< searches done
  std::int64_t evaluations = 0;
  DesignEnd end = DesignEnd::kStarts;
  /// Of each constraint: how much smaller the objective would be for each unit by which its limit is moved
  /// outwards, to first order at `free`; >= 0, and 0 where it is not active, or nothing is known.
  std::vector<double> multipliers;
};

/// Largest constraint with which a design counts as one in which all of them hold.
inline constexpr double kConstraintTolerance = 1e-9;

/// Many local searches from points spread over the ranges at random, and from points near the best ones: the
/// engine that was best on path tasks of linkages, whose objectives have many local minima. The same seed
/// gives the same result for any number of threads. Designs in which all constraints hold come before others;
/// among those that violate one the least violation is best. A value that is not finite counts as a
/// violation. \pre at least one variable, each with low < high
[[nodiscard]] DesignOutcome optimise(const DesignProblem& problem, const DesignOptions& options = {});

}  // namespace higherpair

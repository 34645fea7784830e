#pragma once

#include <functional>
#include <limits>
#include <memory>
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

}  // namespace higherpair

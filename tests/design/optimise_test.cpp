// The optimiser on functions whose optima are known in closed form.
#include "higherpair/design/optimise.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using Function = std::function<void(std::span<const double>, int, DesignValues&)>;

class ByFunction : public DesignEvaluator {
public:
  explicit ByFunction(Function function) : function_(std::move(function)) {}
  void evaluate(std::span<const double> x, int branch, DesignValues& values) override {
    function_(x, branch, values);
  }

private:
  Function function_;
};

DesignProblem problem_of(std::vector<DesignVariable> variables, const Function& function) {
  DesignProblem problem;
  problem.variables = std::move(variables);
  problem.evaluator = [function] { return std::make_unique<ByFunction>(function); };
  return problem;
}

// Rosenbrock's valley as squares: minimum 0 at (1, 1).
DesignProblem rosenbrock() {
  DesignProblem problem = problem_of({{-3, 4, -1.2}, {-2, 5, 1}}, [](auto x, int, DesignValues& values) {
    values.residuals = Eigen::Vector2d(10 * (x[1] - x[0] * x[0]), 1 - x[0]);
  });
  problem.residuals = 2;
  return problem;
}

// A cost with many minima, of which the lowest is at (0.3, 0.3): 0.
DesignProblem rastrigin() {
  DesignProblem problem = problem_of({{-5, 5.3, 4}, {-5, 5.1, -3}}, [](auto x, int, DesignValues& values) {
    values.cost = 0;
    for (const double v : x) {
      values.cost += (v - 0.3) * (v - 0.3) + 4 * (1 - std::cos(3 * (v - 0.3)));
    }
  });
  problem.has_cost = true;
  return problem;
}

// Minimum of x + y on the disc of radius 2 about (1, 0): at (1 - √2, -√2). Moving the limit of the constraint
// (x-1)² + y² - 4 <= 0 by 1 gains 1/(2 √2).
DesignProblem disc() {
  DesignProblem problem = problem_of({{-4, 5, 1.5}, {-5, 4, 0.4}}, [](auto x, int, DesignValues& values) {
    values.cost = x[0] + x[1];
    values.constraints.resize(1);
    values.constraints(0) = (x[0] - 1) * (x[0] - 1) + x[1] * x[1] - 4;
  });
  problem.has_cost = true;
  problem.constraints = 1;
  return problem;
}

DesignOptions few(int starts, DesignMethod method = DesignMethod::kAuto) {
  DesignOptions options;
  options.starts = starts;
  options.method = method;
  return options;
}

// 3 times the step 0.1 is 0.30000000000000004, which counts as the bound 0.3.
TEST(Optimise, RoundsToABoundThatIsAMultipleOfTheStep) {
  DesignVariable variable{0.1, 0.3, 0.2};
  variable.step = 0.1;
  DesignProblem problem = problem_of({variable}, [](auto x, int, DesignValues& values) {
    values.residuals = Eigen::VectorXd::Constant(1, x[0] - 0.28);
  });
  problem.residuals = 1;
  EXPECT_EQ(optimise(problem, few(1)).best.x[0], 0.3);
}

TEST(Optimise, LeastSquaresFollowACurvedValleyToItsEnd) {
  const DesignOutcome outcome = optimise(rosenbrock(), few(1));
  EXPECT_LE(outcome.best.objective, 1e-25);
  EXPECT_NEAR(outcome.best.x[0], 1, 1e-12);
  EXPECT_EQ(outcome.starts, 1);
}

TEST(Optimise, ManyStartsFindTheLowestOfManyMinima) {
  const DesignOutcome outcome = optimise(rastrigin(), few(40));
  EXPECT_LE(outcome.best.objective, 1e-12);
  EXPECT_NEAR(outcome.best.x[0], 0.3, 1e-6);
  EXPECT_GT(outcome.different, 1);
  ASSERT_FALSE(outcome.optima.empty());
  EXPECT_EQ(outcome.optima.front().objective, outcome.best.objective);
}

TEST(Methods, EndOnAConstraintThatTheyDoNotViolate) {
  for (const DesignMethod method : {DesignMethod::kAuto, DesignMethod::kSlsqp, DesignMethod::kCobyla,
                                    DesignMethod::kBobyqa, DesignMethod::kIsres}) {
    SCOPED_TRACE(static_cast<int>(method));
    const DesignOutcome outcome = optimise(disc(), few(3, method));
    // BOBYQA uses penalties and stops beside the edge; the other methods stop on it.
    const double near = method == DesignMethod::kBobyqa ? 2e-2 : 1e-4;
    EXPECT_LE(outcome.best.violation, kConstraintTolerance);
    EXPECT_NEAR(outcome.best.objective, 1 - 2 * std::sqrt(2.0), near);
  }
}

TEST(Optimise, AMultiplierIsWhatMovingTheLimitGains) {
  const DesignOutcome outcome = optimise(disc(), few(3));
  ASSERT_EQ(outcome.multipliers.size(), 1U);
  EXPECT_NEAR(outcome.multipliers[0], 1 / (2 * std::sqrt(2.0)), 1e-5);
}

// With x = -1/2 the other variable is -√(7/4 + c) at the limit moved by c.
TEST(Optimise, AMultiplierIsThatOfTheDesignThatIsRounded) {
  DesignProblem problem = disc();
  problem.variables[0].step = 0.5;
  const DesignOutcome outcome = optimise(problem, few(3));
  EXPECT_EQ(outcome.best.x[0], -0.5);
  ASSERT_EQ(outcome.multipliers.size(), 1U);
  EXPECT_NEAR(outcome.multipliers[0], 1 / std::sqrt(7), 1e-5);
}

TEST(Optimise, ResultsAreTheSameForAnyNumberOfThreads) {
  DesignOptions options = few(50);
  options.seed = 31;
  std::vector<DesignOutcome> outcomes;
  for (const int threads : {1, 2, 7, -3, 1000000000}) {
    options.threads = threads;
    outcomes.push_back(optimise(rastrigin(), options));
  }
  for (const DesignOutcome& outcome : outcomes) {
    EXPECT_EQ(outcome.best.x, outcomes.front().best.x);
    EXPECT_EQ(outcome.evaluations, outcomes.front().evaluations);
    EXPECT_EQ(outcome.different, outcomes.front().different);
    EXPECT_EQ(outcome.starts, 50);
  }
}

// Each search waits for the others, which come only if there are as many threads as were asked for.
TEST(Optimise, UsesAsManyThreadsAsItIsTold) {
  DesignOptions options = few(std::min(16, 1 + static_cast<int>(std::thread::hardware_concurrency())));
  options.threads = options.starts;
  std::mutex telling;
  std::condition_variable all;
  std::set<std::thread::id> seen;
  bool late = false;
  DesignProblem problem = problem_of({{-1, 2, 0.5}}, [&](auto x, int, DesignValues& values) {
    values.cost = x[0] * x[0];
    std::unique_lock lock(telling);
    seen.insert(std::this_thread::get_id());
    all.notify_all();
    const auto are_all_here = [&] { return std::ssize(seen) >= options.threads; };
    late = late || !all.wait_for(lock, std::chrono::seconds(10), are_all_here);
  });
  problem.has_cost = true;
  (void)optimise(problem, options);
  EXPECT_EQ(std::ssize(seen), options.threads);
}

TEST(Optimise, SearchesThatAreKnownAreNotMadeAgainAndChangeNothing) {
  DesignOptions options = few(50);
  options.seed = 31;
  std::vector<DesignSearchEnd> ends;
  options.ended = [&](const DesignSearchEnd& end) { ends.push_back(end); };
  const DesignOutcome whole = optimise(rastrigin(), options);
  ASSERT_EQ(ends.size(), 50U);
  for (const std::size_t known : {1U, 17U, 40U, 50U}) {
    options.known.assign(ends.rbegin(), ends.rbegin() + static_cast<std::ptrdiff_t>(known));
    std::size_t made = 0;
    options.ended = [&](const DesignSearchEnd&) { ++made; };
    const DesignOutcome outcome = optimise(rastrigin(), options);
    EXPECT_EQ(made, 50 - known);
    EXPECT_EQ(outcome.best.x, whole.best.x);
    EXPECT_EQ(outcome.best.objective, whole.best.objective);
    EXPECT_EQ(outcome.evaluations, whole.evaluations);
    EXPECT_EQ(outcome.starts, whole.starts);
    EXPECT_EQ(outcome.different, whole.different);
  }
}

TEST(Optimise, ASearchThatWasStoppedIsNotTold) {
  std::atomic<bool> stop = false;
  DesignOptions options = few(1000);
  options.threads = 1;
  options.stop = &stop;
  int told = 0;
  options.ended = [&](const DesignSearchEnd&) { stop = ++told == 5; };
  const DesignOutcome outcome = optimise(rastrigin(), options);
  EXPECT_EQ(outcome.end, DesignEnd::kStopped);
  EXPECT_EQ(told, 5);
}

TEST(Optimise, TimeEndsTheSearchThatRuns) {
  DesignProblem problem = rosenbrock();
  problem.evaluator = [inner = problem.evaluator] {
    return std::make_unique<ByFunction>(
        [of = std::shared_ptr<DesignEvaluator>(inner())](auto x, int branch, DesignValues& values) {
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
          of->evaluate(x, branch, values);
        });
  };
  DesignOptions options = few(1000);
  options.seconds = 0.03;
  int told = 0;
  options.ended = [&](const DesignSearchEnd&) { ++told; };
  const DesignOutcome outcome = optimise(problem, options);
  EXPECT_EQ(outcome.end, DesignEnd::kTime);
  EXPECT_FALSE(outcome.best.x.empty());
  EXPECT_LE(outcome.best.objective, 24.2);  // that of the start
  // At least the start is worked out; the first derivatives by differences may be under way.
  EXPECT_GE(outcome.evaluations, 1);
  EXPECT_LE(outcome.evaluations, 10);
  EXPECT_EQ(told, 0);
}

TEST(Optimise, EndsWhereItsTargetIsReached) {
  DesignOptions options = few(1000);
  options.target = 1e-20;
  const DesignOutcome outcome = optimise(rosenbrock(), options);
  EXPECT_EQ(outcome.end, DesignEnd::kTarget);
  EXPECT_EQ(outcome.starts, 1);
}

TEST(Optimise, EndsAfterItsEvaluationsForAnyNumberOfThreads) {
  DesignOptions options = few(100000);
  options.evaluations = 3000;
  options.threads = 1;
  const DesignOutcome one = optimise(rastrigin(), options);
  options.threads = 3;
  const DesignOutcome three = optimise(rastrigin(), options);
  EXPECT_EQ(one.end, DesignEnd::kEvaluations);
  EXPECT_EQ(one.starts, three.starts);
  EXPECT_EQ(one.best.x, three.best.x);
  EXPECT_LT(one.starts, 100);
}

TEST(Optimise, AStopKeepsTheBestSoFar) {
  std::atomic<bool> stop = false;
  DesignOptions options = few(1000000);
  options.stop = &stop;
  options.progress = [&](const DesignProgress& progress) { stop = progress.starts >= 16; };
  const DesignOutcome outcome = optimise(rastrigin(), options);
  EXPECT_EQ(outcome.end, DesignEnd::kStopped);
  EXPECT_FALSE(outcome.best.x.empty());
  EXPECT_LE(outcome.best.objective, 5);
}

TEST(Optimise, AnInfeasibleTaskGetsTheLeastViolation) {
  DesignProblem problem = disc();
  const auto inner = problem.evaluator;
  problem = problem_of(problem.variables, [](auto x, int, DesignValues& values) {
    values.cost = x[1];
    values.constraints.resize(2);
    values.constraints << x[0] - 1 + x[1] * x[1], 2 - x[0];  // x <= 1 - y² and x >= 2
  });
  problem.has_cost = true;
  problem.constraints = 2;
  const DesignOutcome outcome = optimise(problem, few(20));
  EXPECT_NEAR(outcome.best.violation, 0.5, 0.02);  // at x = 1.5, y = 0
}

TEST(Optimise, ValuesThatAreNotFiniteAreNeverTheBest) {
  DesignProblem problem = problem_of({{-1, 3, 2}}, [](auto x, int, DesignValues& values) {
    values.cost = x[0] < 0.5 ? std::numeric_limits<double>::quiet_NaN() : x[0] * x[0];
  });
  problem.has_cost = true;
  const DesignOutcome outcome = optimise(problem, few(20));
  EXPECT_NEAR(outcome.best.x[0], 0.5, 1e-3);
  EXPECT_GE(outcome.best.x[0], 0.5);
}

TEST(Optimise, NothingThatIsFiniteIsNoDesign) {
  DesignProblem problem = problem_of({{-1, 3, 2}}, [](auto, int, DesignValues& values) {
    values.cost = std::numeric_limits<double>::infinity();
  });
  problem.has_cost = true;
  const DesignPoint best = optimise(problem, few(20)).best;
  EXPECT_TRUE(best.x.empty());
  EXPECT_EQ(best.objective, std::numeric_limits<double>::infinity());
  EXPECT_EQ(best.violation, std::numeric_limits<double>::infinity());
}

TEST(Optimise, OfVariablesWithoutARangeSearchesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const DesignVariable& variable : {DesignVariable{0, 1, nan}, DesignVariable{nan, 1, 0},
                                         DesignVariable{1, 1, 1}, DesignVariable{-1, 1, 0, 0, true}}) {
    DesignProblem problem = rosenbrock();
    problem.variables[1] = variable;
    const DesignOutcome outcome = optimise(problem, few(3));
    EXPECT_TRUE(outcome.best.x.empty());
    EXPECT_EQ(outcome.evaluations, 0);
  }
  EXPECT_TRUE(optimise(DesignProblem{}).best.x.empty());
}

TEST(Optimise, StaysWithinBounds) {
  DesignProblem problem = rosenbrock();
  problem.variables[0].high = 0.8;
  const DesignOutcome outcome = optimise(problem, few(5));
  EXPECT_EQ(outcome.best.x[0], 0.8);
  EXPECT_NEAR(outcome.best.x[1], 0.64, 1e-6);
}

TEST(Optimise, LogarithmsReachVariablesOfUnknownOrder) {
  DesignProblem problem =
      problem_of({{1e-6, 1e6, 1, 0, true}, {1e-6, 1e6, 1, 0, true}}, [](auto x, int, DesignValues& values) {
        values.residuals = Eigen::Vector2d(x[0] * x[1] - 3, x[0] / (1e4 * x[1]) - 1);
      });
  problem.residuals = 2;
  const DesignOutcome outcome = optimise(problem, few(20));
  EXPECT_LE(outcome.best.objective, 1e-20);
  EXPECT_NEAR(outcome.best.x[0], std::sqrt(3e4), 1e-7);
}

TEST(Optimise, NumbersOfStepsAreMultiplesAndTheOthersFollow) {
  // The minimum on y = x² would be at x = 3.3; the allowed values around it are 3 and 3.5, of which 3.5 is
  // nearer.
  DesignProblem problem = problem_of({{0, 10, 1, 0.5}, {0, 100, 1}}, [](auto x, int, DesignValues& values) {
    values.residuals = Eigen::Vector2d(x[0] - 3.3, x[1] - x[0] * x[0]);
  });
  problem.residuals = 2;
  const DesignOutcome outcome = optimise(problem, few(5));
  EXPECT_NEAR(outcome.free.x[0], 3.3, 1e-9);
  EXPECT_EQ(outcome.best.x[0], 3.5);
  EXPECT_NEAR(outcome.best.x[1], 12.25, 1e-6);
}

TEST(Optimise, TheBestBranchIsFound) {
  DesignProblem problem = problem_of({{-2, 2, 1}}, [](auto x, int branch, DesignValues& values) {
    values.cost = x[0] * x[0] + 0.1 * (branch == 2 ? 0 : 1 + branch);
  });
  problem.has_cost = true;
  problem.branches = 4;
  const DesignOutcome outcome = optimise(problem, few(30));
  EXPECT_EQ(outcome.best.branch, 2);
  EXPECT_NEAR(outcome.best.objective, 0, 1e-12);
}

TEST(Optimise, ConstraintsOfSquaresAreHeldToo) {
  DesignProblem problem = rosenbrock();
  const auto squares = problem.evaluator;
  problem = problem_of(problem.variables, [](auto x, int, DesignValues& values) {
    values.residuals = Eigen::Vector2d(10 * (x[1] - x[0] * x[0]), 1 - x[0]);
    values.constraints.resize(1);
    values.constraints(0) = x[0] * x[0] + x[1] * x[1] - 1;
  });
  problem.residuals = 2;
  problem.constraints = 1;
  const DesignOutcome outcome = optimise(problem, few(10));
  EXPECT_LE(outcome.best.violation, kConstraintTolerance);
  // Where the valley leaves the unit disc: the minimum of the objective on x² + y² = 1.
  EXPECT_NEAR(outcome.best.objective, 0.0456748, 1e-6);
}

}  // namespace
}  // namespace higherpair

#include "design_evaluator.hpp"

#include "higherpair/design/optimise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace higherpair {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

// What dyads have to spare, of the size: on the very edge of their reach rounding loses the motion.
constexpr double kSpare = 1e-7;

// By so much constraints are held more than they have to be, so that what the optimiser tolerates is no
// violation.
constexpr double kInside = 2 * kConstraintTolerance;

constexpr double kGoodPath = -0.01;  // of the constraint on the path where it holds: not active

// What stands for a number that is not defined where a candidate does not work.
constexpr double kMissing = 1e3;
constexpr double kViolated = 1;

// Each row of a timed path.
std::vector<std::size_t> timed_rows(const DesignSetup& setup, const DesignTask::PointPath& path) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < path.through.size(); ++i) {
    std::size_t row = i;
    for (std::int64_t k = 0; !path.at.empty() && k < setup.schedule.size(); ++k) {
      const double position = setup.schedule.state(k).profile.position;
      if (std::abs(position - path.at[i]) <= 1e-9 * (1 + std::abs(position))) {
        row = static_cast<std::size_t>(k);
        break;
      }
    }
    rows.push_back(row);
  }
  return rows;
}

double degrees(double sine) {
  return std::asin(std::clamp(sine, 0.0, 1.0)) * 180 / kPi;
}

class ModelEvaluator : public DesignEvaluator {
public:
  explicit ModelEvaluator(std::shared_ptr<const DesignSetup> setup)
      : setup_(std::move(setup)),
        task_(setup_->numbers.task()),
        unit_(to_si(dimension::kLength, setup_->numbers.model().units()).apply(1)) {
    for (const DesignTask::Objective& objective : task_.objectives) {
      if (objective.path) timed_rows_.push_back(timed_rows(*setup_, *objective.path));
    }
  }

  void evaluate(std::span<const double> x, int branch, DesignValues& values) override {
    DesignRows rows = rows_of(*setup_, x, task_.keep_branch ? setup_->start_branch.value_or(0) : branch);
    values.cost = 0;
    std::vector<double> residuals;
    std::size_t path = 0;
    std::size_t measure = 0;
    for (const DesignTask::Objective& objective : task_.objectives) {
      const double root = std::sqrt(objective.weight);
      if (objective.path) {
        const Eigen::VectorXd misses = misses_in(rows, *objective.path, path++);
        for (const double miss : misses) residuals.push_back(root * miss);
        continue;
      }
      for (const double target : objective.values) {
        const double value = measured(rows, measure++);
        residuals.push_back(root * (std::isfinite(value) ? value - target : kMissing));
      }
      if (!objective.measure) continue;
      const double value = measured(rows, measure++);
      if (objective.target) {
        residuals.push_back(root * (std::isfinite(value) ? value - *objective.target : kMissing));
      } else {
        values.cost += objective.weight * (std::isfinite(value) ? value : kMissing);
      }
    }
    values.residuals =
        Eigen::Map<const Eigen::VectorXd>(residuals.data(), static_cast<Eigen::Index>(residuals.size()));
    const std::vector<double> constraints = constraints_of(rows, measure);
    values.constraints =
        Eigen::Map<const Eigen::VectorXd>(constraints.data(), static_cast<Eigen::Index>(constraints.size()));
  }

  DesignScore score(std::span<const double> x, int branch) {
    DesignRows rows = rows_of(*setup_, x, branch);
    DesignScore score;
    score.started = rows.started;
    score.missing = rows.missing;
    std::size_t path = 0;
    std::size_t measure = 0;
    for (const DesignTask::Objective& objective : task_.objectives) {
      if (!objective.values.empty()) {
        double sum = 0;
        for (const double target : objective.values) sum += std::pow(measured(rows, measure++) - target, 2);
        score.objectives.push_back(sum);
        continue;
      }
      score.objectives.push_back(objective.path ? misses_in(rows, *objective.path, path++).squaredNorm()
                                                : measured(rows, measure++));
      if (objective.path && !rows.started) score.objectives.back() = kUndefined;
    }
    std::size_t transmission = 0;
    for (const DesignTask::Constraint& constraint : task_.constraints) {
      if (constraint.transmission) {
        score.constraints.push_back(rows.started ? degrees(rows.transmissions[transmission]) : kUndefined);
        ++transmission;
      } else {
        score.constraints.push_back(measured(rows, measure++));
      }
    }
    return score;
  }

private:
  static double measured(const DesignRows& rows, std::size_t k) {
    return k < rows.measured.size() ? rows.measured[k] : kUndefined;
  }

  [[nodiscard]] Eigen::VectorXd misses_in(DesignRows& rows, const DesignTask::PointPath& path,
                                          std::size_t k) const {
    if (!rows.started) {
      return Eigen::VectorXd::Constant(miss_count(path), kMissing);
    }
    return misses_of(path, nearest_places(path, rows, rows.points[k], timed_rows_[k]), unit_);
  }

  [[nodiscard]] std::vector<double> constraints_of(const DesignRows& rows, std::size_t measure) const {
    std::vector<double> constraints;
    for (const double gap : rows.gaps) {
      constraints.push_back(std::isfinite(gap) ? gap / setup_->size + kSpare : 0.0);
    }
    constraints.push_back(rows.missing > 0 ? rows.missing : kGoodPath);
    std::size_t transmission = 0;
    for (const DesignTask::Constraint& constraint : task_.constraints) {
      // Sines in place of angles: smooth everywhere.
      const auto add = [&](double off) {
        constraints.push_back(std::isfinite(off) ? off + kInside : kViolated);
      };
      if (constraint.transmission) {
        const double sine = transmission < rows.transmissions.size() && rows.started
                                ? rows.transmissions[transmission]
                                : kUndefined;
        ++transmission;
        if (constraint.above) add(std::sin(*constraint.above * kPi / 180) - sine);
        if (constraint.below) add(sine - std::sin(*constraint.below * kPi / 180));
        continue;
      }
      const double value = measured(rows, measure++);
      if (constraint.above) add((*constraint.above - value) / scale_of(constraint));
      if (constraint.below) add((value - *constraint.below) / scale_of(constraint));
    }
    return constraints;
  }

  std::shared_ptr<const DesignSetup> setup_;
  const DesignTask& task_;
  double unit_;
  std::vector<std::vector<std::size_t>> timed_rows_;  // of each path
};

Eigen::Index closure_count(const DesignSetup& setup) {
  Eigen::Index modes = 0;
  for (int branches = setup.branches; branches > 1; branches /= 2) ++modes;
  return modes;
}

}  // namespace

double scale_of(const DesignTask::Constraint& constraint) {
  const double largest =
      std::max(std::abs(constraint.above.value_or(0)), std::abs(constraint.below.value_or(0)));
  return largest > 0 ? largest : 1;
}

DesignScore score_of(const DesignSetup& setup, std::span<const double> x, int branch) {
  return ModelEvaluator(std::shared_ptr<const DesignSetup>(std::shared_ptr<void>(), &setup)).score(x, branch);
}

std::vector<LimitPlaces> limit_places(const DesignSetup& setup) {
  std::vector<LimitPlaces> places;
  Eigen::Index next = closure_count(setup) + 1;
  for (const DesignTask::Constraint& constraint : setup.numbers.task().constraints) {
    LimitPlaces& limits = places.emplace_back();
    if (constraint.above) limits.above = next++;
    if (constraint.below) limits.below = next++;
  }
  return places;
}

DesignProblem problem_of(std::shared_ptr<const DesignSetup> setup) {
  const DesignTask& task = setup->numbers.task();
  DesignProblem problem;
  for (const DesignTask::Variable& variable : task.variables) problem.variables.push_back(variable.range);
  for (const DesignTask::Objective& objective : task.objectives) {
    problem.residuals += objective.path ? miss_count(*objective.path) : objective.target ? 1 : 0;
    problem.residuals += static_cast<Eigen::Index>(objective.values.size());
    problem.has_cost = problem.has_cost || (objective.measure && !objective.target);
  }
  problem.constraints = closure_count(*setup) + 1;
  for (const DesignTask::Constraint& constraint : task.constraints) {
    problem.constraints += (constraint.above ? 1 : 0) + (constraint.below ? 1 : 0);
  }
  problem.branches = task.keep_branch ? 1 : setup->branches;
  problem.start_branch = setup->start_branch.value_or(0);
  problem.evaluator = [setup] { return std::make_unique<ModelEvaluator>(setup); };
  return problem;
}

}  // namespace higherpair

#include "design_evaluator.hpp"

#include "design_gradient.hpp"
#include "front/tolerances.hpp"
#include "higherpair/design/optimise.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/eigen_index.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// Constraints are tightened by this much, so that what the optimiser tolerates is not a violation. One that
// no variable changes cannot be brought to the inside: it holds, or does not.
constexpr double kInside = 2 * kConstraintTolerance;
double tightened(double off, bool idle) {
  return idle && off <= kConstraintTolerance ? off - kInside : off + kInside;
}

// Values in place of undefined numbers, where a candidate does not work.
constexpr double kMissing = 1e3;
constexpr double kViolated = 1;

// The row of each point of a timed path.
std::vector<std::size_t> timed_rows(const DesignSetup& setup, const DesignTask::PointPath& path) {
  const auto there = rows_at(path.at, places_of(setup.schedule));
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < path.through.size(); ++i) {
    rows.push_back(path.at.empty() ? i : there[i].value_or(i));
  }
  return rows;
}

// The angle with this sine, in the unit of tables, and the reverse.
double angle_of(double sine, const Units& units) {
  return from_si(dimension::kAngle, units).apply(std::asin(std::clamp(sine, 0.0, 1.0)));
}

double sine_of(double angle, const Units& units) {
  return std::sin(to_si(dimension::kAngle, units).apply(angle));
}

class ModelEvaluator : public ScoringEvaluator {
public:
  explicit ModelEvaluator(const DesignSetup& setup)
      : setup_(setup),
        task_(setup.numbers.task()),
        paths_(task_.paths()),
        unit_(to_si(dimension::kLength, setup.numbers.model().units()).apply(1)),
        candidates_(setup) {
    for (const DesignTask::PointPath* path : paths_) timed_rows_.push_back(timed_rows(setup, *path));
    misses_.resize(paths_.size());
  }

  void evaluate(std::span<const double> x, int branch, DesignValues& values) override {
    go_to(x, task_.keep_branch ? setup_.start_branch.value_or(0) : branch);
    values.cost = 0;
    values.residuals.resize(setup_.residuals);
    for (std::size_t k = 0; k < task_.objectives.size(); ++k) {
      const DesignTask::Objective& objective = task_.objectives[k];
      const ObjectivePlace& place = setup_.objective_places[k];
      const double root = std::sqrt(objective.weight);
      auto residuals = values.residuals.segment(place.residual, residual_count(objective));
      if (objective.path()) {
        residuals = root * misses_[place.path];
      } else if (const auto* followed = objective.followed()) {
        for (std::size_t i = 0; i < followed->values.size(); ++i) {
          const double off = off_of(*followed, place, i);
          residuals(eigen_index(i)) = root * (std::isfinite(off) ? off : kMissing);
        }
      } else if (const double value = measured(place); objective.target) {
        residuals(0) = root * (std::isfinite(value) ? value - *objective.target : kMissing);
      } else {
        values.cost += objective.weight * (std::isfinite(value) ? value : kMissing * setup_.cost_scale);
      }
    }
    fill_constraints(values.constraints);
  }

  bool differentiate(std::span<const double> x, int branch, DesignJacobian& jacobian) override {
    go_to(x, task_.keep_branch ? setup_.start_branch.value_or(0) : branch);
    return add_gradient(setup_, candidates_, {x_, branch_, rows(), places_}, unit_, jacobian);
  }

  DesignScore score(std::span<const double> x, int branch) override {
    go_to(x, branch);
    DesignScore score;
    score.started = rows().started;
    score.missing = rows().missing;
    for (std::size_t k = 0; k < task_.objectives.size(); ++k) {
      const DesignTask::Objective& objective = task_.objectives[k];
      const ObjectivePlace& place = setup_.objective_places[k];
      auto& placement = score.placements.emplace_back();
      double& value = score.objectives.emplace_back(kNoValue);
      if (const auto* followed = objective.followed()) {
        value = 0;
        for (std::size_t i = 0; i < followed->values.size(); ++i) {
          value += std::pow(off_of(*followed, place, i), 2);
        }
      } else if (!objective.path()) {
        value = measured(place);
      } else if (rows().started) {
        value = misses_[place.path].squaredNorm();
        if (!objective.path()->is_free()) continue;
        const PathPlacement placed = placement_of(*objective.path(), places_[place.path]);
        placement = {placed.turn_and_scale(), placed.shift()};
      }
    }
    for (std::size_t k = 0; k < task_.constraints.size(); ++k) {
      const ConstraintPlace& place = setup_.constraint_places[k];
      score.constraints.push_back(task_.constraints[k].transmission()
                                      ? angle_of(sine_at(place), setup_.numbers.model().units())
                                      : measured(place));
    }
    return score;
  }

private:
  [[nodiscard]] const DesignRows& rows() const { return candidates_.rows(); }

  // Does nothing for the same candidate again: methods ask for its values and then for its derivatives.
  void go_to(std::span<const double> x, int branch) {
    if (branch == branch_ && std::equal(x.begin(), x.end(), x_.begin(), x_.end())) {
      return;
    }
    x_.assign(x.begin(), x.end());
    branch_ = branch;
    candidates_.work_out(x, branch);
    places_.clear();
    for (std::size_t k = 0; k < paths_.size(); ++k) misses_of_path(*paths_[k], k);
  }

  void misses_of_path(const DesignTask::PointPath& path, std::size_t k) {
    if (!rows().started) {
      misses_[k].setConstant(miss_count(path), kMissing);
      places_.emplace_back();
      return;
    }
    places_.push_back(nearest_places(path, candidates_.rows(), rows().points[k], timed_rows_[k]));
    misses_[k] = misses_of(path, places_.back(), unit_);
  }

  // By how much a column that is to follow given values misses the k-th of them.
  [[nodiscard]] double off_of(const DesignTask::Followed& followed, const ObjectivePlace& place,
                              std::size_t k) const {
    const double off = measured(place, k) - followed.values[k];
    return followed.change ? off - (measured(place) - followed.values[0]) : off;
  }

  // The k-th number of the quantity of an objective or constraint.
  template <class Place>
  [[nodiscard]] double measured(const Place& place, std::size_t k = 0) const {
    const std::size_t number = setup_.quantities[place.quantity].first + k;
    return number < rows().measured.size() ? rows().measured[number] : kNoValue;
  }

  // The least sine of a transmission angle.
  [[nodiscard]] double sine_at(const ConstraintPlace& place) const {
    return rows().started ? rows().transmissions[place.transmission] : kNoValue;
  }

  void fill_constraints(Eigen::VectorXd& values) const {
    values.resize(setup_.constraints);
    Eigen::Index next = 0;
    for (const double gap : rows().gaps) {
      values(next++) = std::isfinite(gap) ? (gap + setup_.spare()) / setup_.size : 0.0;
    }
    values(next) = rows().missing > 0 ? rows().missing : kGoodPath;
    const Units& units = setup_.numbers.model().units();
    for (std::size_t k = 0; k < task_.constraints.size(); ++k) {
      const DesignTask::Constraint& constraint = task_.constraints[k];
      const ConstraintPlace& place = setup_.constraint_places[k];
      const bool idle = k < setup_.idle.size() && setup_.idle[k];
      // For transmission angles, sines are used in place of angles: they are smooth everywhere.
      const bool is_angle = constraint.transmission() != nullptr;
      const double value = is_angle ? sine_at(place) : measured(place);
      const auto off_by = [&](double sign, double limit) {
        const double off =
            is_angle ? sign * (value - sine_of(limit, units)) : sign * (value - limit) / setup_.scales[k];
        return std::isfinite(off) ? tightened(off, idle) : kViolated;
      };
      if (place.above) values(*place.above) = off_by(-1, *constraint.above);
      if (place.below) values(*place.below) = off_by(1, *constraint.below);
    }
  }

  const DesignSetup& setup_;
  const DesignTask& task_;
  std::vector<const DesignTask::PointPath*> paths_;
  double unit_;
  DesignCandidates candidates_;
  std::vector<std::vector<std::size_t>> timed_rows_;  // of each path

  // The candidate evaluated last.
  std::vector<double> x_;
  int branch_ = 0;
  std::vector<std::vector<PathMiss>> places_;  // of each path
  std::vector<Eigen::VectorXd> misses_;
};

}  // namespace

// A limit of 0, or close to it, gives no scale; the value at the start does.
void set_scales(DesignSetup& setup) {
  const DesignTask& task = setup.numbers.task();
  setup.scales.assign(task.constraints.size(), 1);
  const DesignScore& start = setup.start_score;
  for (std::size_t k = 0; k < task.constraints.size(); ++k) {
    const DesignTask::Constraint& constraint = task.constraints[k];
    const double limit =
        std::max(std::abs(constraint.above.value_or(0)), std::abs(constraint.below.value_or(0)));
    const double there = std::isfinite(start.constraints[k]) ? std::abs(start.constraints[k]) : 0;
    const double largest = std::max(limit, there);
    setup.scales[k] = largest > 0 ? largest : 1;
  }
  for (const double objective : start.objectives) {
    if (std::isfinite(objective)) setup.cost_scale = std::max(setup.cost_scale, std::abs(objective));
  }
}

DesignScore score_of(const DesignSetup& setup, std::span<const double> x, int branch) {
  return ModelEvaluator(setup).score(x, branch);
}

std::unique_ptr<ScoringEvaluator> evaluator_of(const DesignSetup& setup) {
  return std::make_unique<ModelEvaluator>(setup);
}

}  // namespace higherpair

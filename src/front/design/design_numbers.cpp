#include "design_numbers.hpp"

#include "front/tolerances.hpp"
#include "higherpair/analysis/displaced.hpp"
#include "higherpair/mechanism/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// Whether the mechanism has no numbers other than those of for_each_number.
bool is_all_numbers(const Mechanism& mechanism) {
  const bool endless = std::all_of(mechanism.joints.begin(), mechanism.joints.end(),
                                   [](const Joint& joint) { return !joint.from && !joint.to; });
  return has_whole_curves(mechanism) && endless;
}

}  // namespace

bool same_programs(const std::vector<DriverProgram>& a, const std::vector<DriverProgram>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const DriverProgram& p, const DriverProgram& q) {
        return (p.start == q.start || !p.positions.empty()) && p.end == q.end && p.samples == q.samples &&
               p.positions == q.positions && p.velocity == q.velocity && p.acceleration == q.acceleration;
      });
}

bool has_whole_curves(const Mechanism& mechanism) {
  return std::all_of(mechanism.bodies.begin(), mechanism.bodies.end(), [](const Body& body) {
    return std::all_of(body.curves.begin(), body.curves.end(),
                       [](const NamedCurve& curve) { return curve.boundary == nullptr; });
  });
}

std::vector<double> start_values(const DesignTask& task) {
  std::vector<double> x;
  for (const DesignTask::Variable& variable : task.variables) x.push_back(variable.range.start);
  return x;
}

DesignNumbers::DesignNumbers(Model model, const DesignTask& task)
    : model_(std::move(model)), task_(&task), start_(start_values(task)) {
  base_ = numbers_of(model_.mechanism());
  const bool changes_laws =
      std::any_of(task.variables.begin(), task.variables.end(), [](const auto& variable) {
        return std::any_of(variable.paths.begin(), variable.paths.end(),
                           [](const std::string& path) { return path.starts_with("laws."); });
      });
  linear_ = !changes_laws && is_all_numbers(model_.mechanism()) && find_slopes();
}

std::vector<std::string> DesignNumbers::paths() const {
  std::vector<std::string> paths;
  for (const DesignTask::Variable& variable : task_->variables) {
    paths.insert(paths.end(), variable.paths.begin(), variable.paths.end());
  }
  return paths;
}

std::vector<double> DesignNumbers::values_of(std::span<const double> x) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (const double factor : task_->variables[i].factors) values.push_back(factor * x[i]);
  }
  return values;
}

// None of the variants is refused for being out of its bounds: differences at a bound go beyond it.
Result<ModelVariants> DesignNumbers::variants() const {
  return ModelVariants::of(model_, paths());
}

Result<Model> DesignNumbers::model_of(std::span<const double> x) const {
  const std::vector<std::string> at = paths();
  const std::vector<double> values = values_of(x);
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < values.size(); ++i) settings.emplace_back(at[i], values[i]);
  return model_.with(settings);
}

std::shared_ptr<const Model::Data> DesignNumbers::data_of(std::span<const double> x) const {
  const auto model = linear_ ? model_.with_mechanism(mechanism_of(x))
                             : variants().and_then([&](ModelVariants all) { return all.with(values_of(x)); });
  return model ? model->data().shared_from_this() : nullptr;
}

std::optional<std::vector<double>> DesignNumbers::numbers_at(std::span<const double> x) const {
  const auto model = model_of(x);
  if (!model || !same_programs(model->profile().programs, model_.profile().programs)) {
    return std::nullopt;
  }
  return numbers_of(model->mechanism());
}

// Finds the slopes from the ends of each range, and verifies them at two places where all variables differ
// from the start.
bool DesignNumbers::find_slopes() {
  for (std::size_t i = 0; i < start_.size(); ++i) {
    const DesignVariable& range = task_->variables[i].range;
    std::vector<double> x = start_;
    x[i] = range.high;
    const auto high = numbers_at(x);
    x[i] = range.low;
    const auto low = numbers_at(x);
    if (!high || !low || high->size() != base_.size()) {
      return false;
    }
    std::vector<double>& slope = slopes_.emplace_back();
    for (std::size_t k = 0; k < base_.size(); ++k) {
      slope.push_back(((*high)[k] - (*low)[k]) / (range.high - range.low));
    }
    std::vector<std::size_t>& changed = changed_.emplace_back();
    for (std::size_t k = 0; k < slope.size(); ++k) {
      if (slope[k] != 0) changed.push_back(k);
    }
  }
  for (const double share : {0.23, 0.71}) {
    std::vector<double> x;
    for (const DesignTask::Variable& variable : task_->variables) {
      x.push_back(variable.range.low + share * (variable.range.high - variable.range.low));
    }
    const auto numbers = numbers_at(x);
    if (!numbers) {
      return false;
    }
    const std::vector<double> linear = numbers_of(mechanism_of(x));
    for (std::size_t k = 0; k < linear.size(); ++k) {
      const double largest = std::max(std::abs(base_[k]), std::abs((*numbers)[k]));
      if (!(std::abs((*numbers)[k] - linear[k]) <= kLinearRounding * largest)) {
        return false;
      }
    }
  }
  return true;
}

void DesignNumbers::fill_numbers(std::span<const double> x, std::vector<double>& numbers) const {
  numbers.assign(base_.begin(), base_.end());
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (const std::size_t k : changed_[i]) {
      numbers[k] += slopes_[i][k] * (x[i] - start_[i]);
    }
  }
}

Mechanism DesignNumbers::mechanism_of(std::span<const double> x) const {
  Mechanism mechanism = model_.mechanism();
  std::vector<double> numbers;
  fill_numbers(x, numbers);
  for_each_number(mechanism, [&, k = std::size_t{0}](double& number) mutable { number = numbers[k++]; });
  return mechanism;
}

Mechanism DesignNumbers::linear_derivative(std::size_t variable) const {
  Mechanism mechanism = model_.mechanism();
  for_each_number(mechanism,
                  [&, k = std::size_t{0}](double& number) mutable { number = slopes_[variable][k++]; });
  return mechanism;
}

double DesignNumbers::scale(std::size_t variable) const {
  const DesignVariable& range = task_->variables[variable].range;
  return range.start != 0 ? std::abs(range.start) : (range.high - range.low) / 2;
}

std::optional<MechanismDerivative> DesignNumbers::derivative(std::size_t variable,
                                                             std::span<const double> x) const {
  if (linear_) return linear_derivative(variable);
  const std::vector<DriverProgram>& own = model_.profile().programs;
  if (std::any_of(own.begin(), own.end(), [](const DriverProgram& one) { return one.law.has_value(); })) {
    return std::nullopt;
  }
  auto all = variants();
  if (!all) {
    return std::nullopt;
  }
  std::vector<double> beside(x.begin(), x.end());
  const auto at = [&](double step) -> std::optional<Mechanism> {
    beside[variable] = x[variable] + step;
    const auto model = all->with(values_of(beside));
    return model && same_programs(model->profile().programs, own) ? std::optional(model->mechanism())
                                                                  : std::nullopt;
  };
  return mechanism_derivative(at, scale(variable));
}

}  // namespace higherpair

// Checks a plan that a program made for what the reader of profiles ensures.
#include "higherpair/sweep/tolerances.hpp"
#include "higherpair/sweep/variants.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair {
namespace {

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

// These and the following return the end of a sentence, empty where there is nothing wrong.
std::string fault_of_values(const std::vector<double>& values) {
  return values.empty()        ? "expected at least one of `values`"
         : !all_finite(values) ? "`values` must be finite"
                               : "";
}

std::string fault_of_ends(const Distribution& d) {
  return std::isfinite(d.low) && std::isfinite(d.high) && d.low < d.high
             ? ""
             : fmt::format("low = {}, high = {}: must be finite, and low below high", d.low, d.high);
}

std::string fault_of_normal(const Distribution& d) {
  if (!(std::isfinite(d.mean) && std::isfinite(d.deviation) && d.deviation > 0)) {
    return fmt::format("mean = {}, deviation = {}: must be finite, and the deviation above 0", d.mean,
                       d.deviation);
  }
  if (!(d.low < d.high)) {
    return fmt::format("low = {}, high = {}: low must be below high", d.low, d.high);
  }
  return share_within(d) >= kLeastShareWithin
             ? ""
             : "next to nothing of this distribution lies between its limits";
}

std::string fault_of(const Distribution& d) {
  switch (d.kind) {
    case DistributionKind::kValues:
      return fault_of_values(d.values);
    case DistributionKind::kNormal:
      return fault_of_normal(d);
    case DistributionKind::kTriangular:
      if (!(d.low <= d.mode && d.mode <= d.high)) {
        return fmt::format("mode = {}: must lie from low = {} to high = {}", d.mode, d.low, d.high);
      }
      [[fallthrough]];
    case DistributionKind::kUniform:
      break;
  }
  return fault_of_ends(d);
}

bool draws(const VariantPlan& plan) {
  return plan.method == SweepMethod::kRandom || plan.method == SweepMethod::kSobol;
}

std::string fault_of(const SweepVariable& variable, const VariantPlan& plan) {
  const Distribution& d = variable.distribution;
  if (draws(plan)) {
    return fault_of(d);
  }
  const std::size_t first = plan.variables.front().distribution.values.size();
  if (plan.method == SweepMethod::kList && d.values.size() != first) {
    return fmt::format("{} values, but the first variable has {}: in a list all have equally many",
                       d.values.size(), first);
  }
  if (variable.count == 0 || plan.method == SweepMethod::kList) {
    return fault_of_values(d.values);
  }
  return variable.count > 0 ? fault_of_ends(d) : fmt::format("count = {}: must be >= 0", variable.count);
}

std::string fault_of(const Correlation& correlation, const VariantPlan& plan) {
  const auto is_normal = [&](std::size_t variable) {
    return variable < plan.variables.size() &&
           plan.variables[variable].distribution.kind == DistributionKind::kNormal &&
           !plan.variables[variable].distribution.is_truncated();
  };
  if (correlation.first == correlation.second || !is_normal(correlation.first) ||
      !is_normal(correlation.second)) {
    return fmt::format("between {} and {}: must be the indices of two normal variables without limits",
                       correlation.first, correlation.second);
  }
  return std::abs(correlation.coefficient) < 1
             ? ""
             : fmt::format("coefficient = {}: must lie between -1 and 1", correlation.coefficient);
}

std::string fault_of_correlations(const VariantPlan& plan) {
  for (std::size_t i = 0; i < plan.correlations.size(); ++i) {
    const std::string fault = fault_of(plan.correlations[i], plan);
    if (!fault.empty()) return fmt::format("correlations.{}: {}", i, fault);
  }
  return correlation_factor(plan) ? "" : "correlations: these contradict each other";
}

}  // namespace

std::string fault_of(const VariantPlan& plan) {
  if (plan.variables.empty()) {
    return "variables: expected at least one";
  }
  for (const SweepVariable& variable : plan.variables) {
    const std::string fault = fault_of(variable, plan);
    if (!fault.empty()) return fmt::format("variables.{}: {}", variable.name, fault);
  }
  if (plan.method == SweepMethod::kSobol && plan.variables.size() > kMostSobolVariables) {
    return fmt::format("variables: a Sobol sequence has at most {}", kMostSobolVariables);
  }
  const double count = count_of(plan);
  if (!(count >= 1 && count <= static_cast<double>(kMostVariants))) {
    return fmt::format("count: {:.15g} variants, expected from 1 to {}", count, kMostVariants);
  }
  return draws(plan) ? fault_of_correlations(plan) : "";
}

}  // namespace higherpair

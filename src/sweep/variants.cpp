#include "higherpair/sweep/variants.hpp"

#include <Random123/threefry.h>
#include <algorithm>
#include <bit>
#include <cassert>
#include <set>
#include <utility>

#include <Eigen/Cholesky>
#include <boost/random/sobol.hpp>

namespace higherpair {
namespace {

constexpr std::size_t kDigits = 40;  // 2^40 > kMostVariants

// What a random word is for: words for different purposes are independent of each other.
enum class Purpose : std::uint64_t { kDraw, kShift };

std::uint64_t word(std::uint64_t seed, Purpose purpose, std::uint64_t variant, std::uint64_t variable) {
  const r123::Threefry2x64::ctr_type counter = {{variant, variable}};
  const r123::Threefry2x64::key_type key = {{seed, static_cast<std::uint64_t>(purpose)}};
  return r123::Threefry2x64()(counter, key)[0];
}

// The middle of one of 2^52 equal parts of 0 … 1: never 0, never 1.
double share_of(std::uint64_t word) {
  return (static_cast<double>(word >> 12U) + 0.5) * 0x1p-52;
}

// Point n is the XOR of the direction numbers at the set bits of n's Gray code. The Gray code of 2^(k+1) - 1
// has bit k alone set, so that this point is direction number k. Boost leaves out point 0: seed(m) makes
// point m + 1 the next one.
std::vector<std::uint64_t> sobol_directions(std::size_t variables) {
  boost::random::sobol_engine<std::uint64_t, 64> engine(variables);
  std::vector<std::uint64_t> directions(variables * kDigits);
  for (std::size_t k = 0; k < kDigits; ++k) {
    engine.seed((std::uint64_t{2} << k) - 2);
    for (std::size_t i = 0; i < variables; ++i) {
      directions[i * kDigits + k] = engine();
    }
  }
  return directions;
}

std::int64_t grid_count(const SweepVariable& variable) {
  return variable.count > 0 ? variable.count : static_cast<std::int64_t>(variable.distribution.values.size());
}

// low + (high - low) k/(n - 1), rounded once, and exact at both ends.
double grid_value(const SweepVariable& variable, std::int64_t k) {
  const Distribution& d = variable.distribution;
  if (variable.count == 0) {
    return d.values[k];
  }
  if (k == variable.count - 1 && k > 0) {
    return d.high;
  }
  const auto steps = static_cast<long double>(std::max<std::int64_t>(variable.count - 1, 1));
  return static_cast<double>(d.low + (static_cast<long double>(d.high) - d.low) *
                                         static_cast<long double>(k) / steps);
}

}  // namespace

double count_of(const VariantPlan& plan) {
  switch (plan.method) {
    case SweepMethod::kGrid: {
      double count = 1;
      for (const SweepVariable& variable : plan.variables) {
        count *= static_cast<double>(grid_count(variable));
      }
      return count;
    }
    case SweepMethod::kList:
      return plan.variables.empty() ? 0
                                    : static_cast<double>(plan.variables.front().distribution.values.size());
    case SweepMethod::kRandom:
    case SweepMethod::kSobol:
      break;
  }
  return static_cast<double>(plan.count);
}

std::vector<std::size_t> correlated_variables(const VariantPlan& plan) {
  std::set<std::size_t> variables;
  for (const Correlation& correlation : plan.correlations) {
    variables.insert({correlation.first, correlation.second});
  }
  return {variables.begin(), variables.end()};
}

std::optional<Eigen::MatrixXd> correlation_factor(const VariantPlan& plan) {
  const std::vector<std::size_t> variables = correlated_variables(plan);
  const auto n = static_cast<Eigen::Index>(variables.size());
  const auto place = [&](std::size_t variable) {
    return std::lower_bound(variables.begin(), variables.end(), variable) - variables.begin();
  };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
  for (const Correlation& correlation : plan.correlations) {
    const Eigen::Index i = place(correlation.first);
    const Eigen::Index j = place(correlation.second);
    matrix(i, j) = matrix(j, i) = correlation.coefficient;
  }
  const Eigen::LLT<Eigen::MatrixXd> decomposed(matrix);
  if (decomposed.info() != Eigen::Success) {
    return std::nullopt;
  }
  return Eigen::MatrixXd(decomposed.matrixL());
}

Variants::Variants(VariantPlan plan)
    : plan_(std::move(plan)), size_(static_cast<std::int64_t>(count_of(plan_))) {
  if (plan_.method == SweepMethod::kSobol) {
    directions_ = sobol_directions(plan_.variables.size());
    for (std::size_t i = 0; i < plan_.variables.size(); ++i) {
      shifts_.push_back(word(plan_.seed, Purpose::kShift, 0, i));
    }
  }
  if (!plan_.correlations.empty()) {
    correlated_ = correlated_variables(plan_);
    const auto factor = correlation_factor(plan_);
    assert(factor);
    factor_ = *factor;
  }
}

void Variants::take_grid(std::int64_t variant, std::span<double> values) const {
  for (std::size_t i = values.size(); i-- > 0;) {
    const std::int64_t count = grid_count(plan_.variables[i]);
    values[i] = grid_value(plan_.variables[i], variant % count);
    variant /= count;
  }
}

double Variants::share(std::int64_t variant, std::size_t variable) const {
  const auto number = static_cast<std::uint64_t>(variant);
  if (plan_.method == SweepMethod::kRandom) {
    return share_of(word(plan_.seed, Purpose::kDraw, number, variable));
  }
  std::uint64_t point = shifts_[variable];
  for (std::uint64_t code = number ^ (number >> 1U); code != 0; code &= code - 1) {
    point ^= directions_[variable * kDigits + static_cast<std::size_t>(std::countr_zero(code))];
  }
  return share_of(point);
}

// Independent normal numbers, times the Cholesky factor.
void Variants::correlate(std::int64_t variant, std::span<double> values) const {
  Eigen::VectorXd normal(static_cast<Eigen::Index>(correlated_.size()));
  for (Eigen::Index i = 0; i < normal.size(); ++i) {
    const std::size_t variable = correlated_[i];
    normal(i) = normal_quantile(share(variant, variable));
    const Distribution& d = plan_.variables[variable].distribution;
    values[variable] = d.mean + d.deviation * factor_.row(i).head(i + 1).dot(normal.head(i + 1));
  }
}

void Variants::values(std::int64_t variant, std::span<double> values) const {
  assert(variant >= 0 && variant < size_ && values.size() == plan_.variables.size());
  if (plan_.method == SweepMethod::kGrid) {
    take_grid(variant, values);
    return;
  }
  if (plan_.method == SweepMethod::kList) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = plan_.variables[i].distribution.values[variant];
    }
    return;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = quantile(plan_.variables[i].distribution, share(variant, i));
  }
  if (!correlated_.empty()) {
    correlate(variant, values);
  }
}

}  // namespace higherpair

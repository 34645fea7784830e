#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

enum class DistributionKind {
  kUniform,     ///< equally likely between `low` and `high`
  kNormal,      ///< of `mean` and `deviation`; truncated at `low` and `high` if these are finite
  kTriangular,  ///< density rises linearly from `low` to `mode` and falls to `high`
  kValues,      ///< one of `values`, all equally likely
};

/// Probability distribution of a variable.
struct Distribution {
  DistributionKind kind = DistributionKind::kUniform;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  double mean = 0;
  double deviation = 0;  ///< > 0, before truncation
  double mode = 0;       ///< low <= mode <= high
  std::vector<double> values;

  /// Whether it is a truncated normal distribution.
  [[nodiscard]] bool is_truncated() const;
};

/// The quantile: the value below which the share u of all values lies, 0 < u < 1. For kValues, the entry at
/// this share of the list. Never below `low` or above `high`.
[[nodiscard]] double quantile(const Distribution& distribution, double u);

/// The quantile of the normal distribution of mean 0 and deviation 1.
[[nodiscard]] double normal_quantile(double u);

/// The share of a normal distribution that lies between `low` and `high`.
[[nodiscard]] double share_within(const Distribution& distribution);

enum class SweepMethod {
  kGrid,  ///< every value of each variable with every value of the others; the last variable changes fastest
  kList,  ///< the first values of all variables, then the second ones, …
  kRandom,  ///< independent draws
  kSobol,   ///< the Sobol sequence, which fills the space evenly, shifted at random as a whole
};

/// A number of the profile that differs from variant to variant.
struct SweepVariable {
  std::string name;
  std::vector<std::string> paths;  ///< of the keys that take its value, as in the option --set
  Distribution distribution;       ///< for a list, and a grid of values: `values`
  std::int64_t count = 0;          ///< for a grid: number of values from low to high; 0: `values`
};

/// Two normal variables that do not vary independently of each other.
struct Correlation {
  std::size_t first = 0;  ///< index of the variable
  std::size_t second = 0;
  double coefficient = 0;  ///< -1 < coefficient < 1
};

/// What defines the variants.
struct VariantPlan {
  SweepMethod method = SweepMethod::kGrid;
  std::int64_t count = 0;  ///< number of variants; random and Sobol only
  std::uint64_t seed = 1;  ///< random and Sobol only
  std::vector<SweepVariable> variables;
  std::vector<Correlation> correlations;
};

/// More variants than this are refused as a slip.
inline constexpr std::int64_t kMostVariants = 100'000'000'000;
/// More variables than this have no Sobol sequence.
inline constexpr std::size_t kMostSobolVariables = 3667;

/// How many variants a plan has, as a double: a grid may have any number.
[[nodiscard]] double count_of(const VariantPlan& plan);

/// The first mistake in a plan, "variables.r: count = -1: must be >= 0"; empty if there is none.
[[nodiscard]] std::string fault_of(const VariantPlan& plan);

/// The variables that occur in correlations, ascending.
[[nodiscard]] std::vector<std::size_t> correlated_variables(const VariantPlan& plan);

/// The lower Cholesky factor L of their correlation matrix: L times a vector of independent standard normal
/// numbers has these correlations. None if the coefficients contradict each other, so that the matrix is not
/// positive definite.
[[nodiscard]] std::optional<Eigen::MatrixXd> correlation_factor(const VariantPlan& plan);

/// The values of the variables in every variant: a function of the plan and the variant's number alone,
/// whatever the earlier calls and the thread.
///
/// A random number is the word of Threefry-2x64-20 (Salmon et al., SC 2011) at (variant, variable) under the
/// seed; Sobol points are those of Joe and Kuo (SIAM J. Sci. Comput. 30, 2635), with the digits of each
/// variable flipped by one random word (a digital shift, which keeps their evenness). The quantile of the
/// variable's distribution turns either into a value.
class Variants {
public:
  /// \pre fault_of(plan) is empty
  explicit Variants(VariantPlan plan);

  [[nodiscard]] const VariantPlan& plan() const { return plan_; }
  [[nodiscard]] std::int64_t size() const { return size_; }

  /// \pre 0 <= variant < size()
  /// \param values  of all variables, in their order
  void values(std::int64_t variant, std::span<double> values) const;

private:
  [[nodiscard]] double share(std::int64_t variant, std::size_t variable) const;
  void take_grid(std::int64_t variant, std::span<double> values) const;
  void correlate(std::int64_t variant, std::span<double> values) const;

  VariantPlan plan_;
  std::int64_t size_ = 0;
  std::vector<std::uint64_t> directions_;  // Sobol only: for each variable one for each digit of the number
  std::vector<std::uint64_t> shifts_;      // Sobol only: one for each variable
  std::vector<std::size_t> correlated_;
  Eigen::MatrixXd factor_;  // Cholesky factor of their correlation matrix
};

}  // namespace higherpair

#pragma once

#include "higherpair/front/sensitivity.hpp"
#include "higherpair/io/tasks.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace higherpair {

/// So many standard deviations to either side are a statistical band: 99.73 % of a normal distribution.
inline constexpr double kBandSigmas = 3;
/// The quantiles between which as much lies.
inline constexpr double kBandQuantile = 0.00134989803163009;

/// How a result scatters where it changes with every number along its slope. With s_i the slopes, t_i half
/// the widths of the zones, m_i their middles and p_i the numbers of the profile:
///     centre = value + Σ s_i (m_i − p_i)
///     worst case: every number at the end of its zone that is worse
///     statistical: centre ± 3 σ, σ² = Σ Σ ρ_ik s_i σ_i s_k σ_k, but never beyond the worst case
/// with ρ_ii = 1 and ρ_ik of correlated numbers, else 0: the root sum of squares where none are (W. H.
/// Greenwood and K. W. Chase, Worst case tolerance analysis with nonlinear problems, 1988). A slope that is
/// another one to either side counts as the steeper one in σ.
struct ToleranceBand {
  double center = 0;
  double worst_low = 0, worst_high = 0;
  double deviation = 0;  ///< σ
  double low = 0, high = 0;
  /// Of each tolerance in σ²: Σ_k ρ_ik s_i σ_i s_k σ_k/σ², negative where its scatter makes up for that of
  /// others. Their sum is 1; all 0 where σ is.
  std::vector<double> shares;
  std::vector<std::size_t> order;  ///< the tolerances, the largest share first
  bool complete = true;            ///< false: some slopes are not known and count as 0

  std::optional<double> within;  ///< what is wanted: value ± within
  bool kept = true;              ///< the statistical band is within it
  bool worst_kept = true;        ///< so is the worst case
  /// Where it is not kept: the factor on the width of the zone of order.front() that would make it so; none:
  /// even without any scatter of this number it would not be.
  std::optional<double> tighten;
  /// The same factor on all zones at once; none: their middles alone are too far off.
  std::optional<double> tighten_all;
};

/// The bands of all results. \pre the report's numbers are those of the task
[[nodiscard]] std::vector<ToleranceBand> tolerance_bands(const ToleranceTask& task,
                                                         const SensitivityReport& report);

struct ToleranceVariantSettings {
  std::int64_t count = 100'000;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: as many as there are cores to be used
  std::optional<std::int64_t> samples;
  double tolerance = 1e-9;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::int64_t)> progress;  ///< told how many variants are done; may be empty
};

/// What of a result random variants show, beside what its slopes say of the same variants.
struct VariantBand {
  double low = 0, median = 0, high = 0;  ///< quantiles kBandQuantile, 0.5 and 1 - kBandQuantile
  double mean = 0, deviation = 0;
  double linear_low = 0, linear_median = 0, linear_high = 0;  ///< of value + Σ s_i (p_i − value of p_i)
  double farthest = 0;        ///< largest difference between a variant and its linear value
  double share_within = 1;    ///< of the variants; 1 where nothing is wanted
  std::int64_t variants = 0;  ///< that have the result
  /// Whether the quantiles differ from the linear ones by more than kCurved of the band's half width: the
  /// result bends within the tolerances, and the linear bands are that far off.
  bool curved = false;
};
inline constexpr double kCurved = 0.05;

struct ToleranceVariants {
  std::int64_t count = 0;
  std::int64_t good = 0;           ///< how many of them have a path that is good
  std::vector<VariantBand> bands;  ///< of the report's results
  bool stopped = false;
};

/// Runs random variants of the model, whose numbers scatter as the tolerances say, and takes the results of
/// each. Extremes are those of the rows; what the rows miss of an extreme of the model itself is added.
/// \pre report is sensitivity() of the model with its [tolerances]. Fails as Sweep::of does
[[nodiscard]] Result<ToleranceVariants> tolerance_variants(const Model& model,
                                                           const SensitivityReport& report,
                                                           const ToleranceVariantSettings& settings = {});

}  // namespace higherpair

#include "front/tolerances.hpp"
#include "higherpair/front/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace higherpair {
namespace {

// The parts of a result's scatter, σ² = Σ_i Σ_k ρ_ik d_i d_k with d_i = s_i σ_i.
class Scatter {
public:
  Scatter(const ToleranceTask& task, const std::vector<double>& deviations)
      : deviations_(deviations), parts_(deviations.size()) {
    for (std::size_t i = 0; i < deviations.size(); ++i) parts_[i] = deviations[i] * deviations[i];
    for (const Correlation& one : task.correlations) {
      const double common = one.coefficient * deviations[one.first] * deviations[one.second];
      parts_[one.first] += common;
      parts_[one.second] += common;
    }
    variance_ = std::max(0.0, std::accumulate(parts_.begin(), parts_.end(), 0.0));
  }

  [[nodiscard]] double variance() const { return variance_; }

  // Σ_k ρ_ik d_i d_k of each number: they add up to the variance.
  [[nodiscard]] const std::vector<double>& parts() const { return parts_; }

  // The largest factor on σ_i alone that brings the variance down to `target`; none if no factor does.
  [[nodiscard]] std::optional<double> factor_for(std::size_t i, double target) const {
    const double own = deviations_[i] * deviations_[i];
    const double common = parts_[i] - own;
    const double others = variance_ - own - 2 * common;
    // own f² + 2 common f + others = target
    const double square = common * common + own * (target - others);
    const double rounding = kVarianceRounding * own * variance_;
    const double factor = (std::sqrt(std::max(square, 0.0)) - common) / own;
    return square >= -rounding && factor >= 0 ? std::optional(factor) : std::nullopt;
  }

private:
  std::vector<double> deviations_, parts_;
  double variance_ = 0;
};

// Finds by which factors scatter would have to be reduced for the band to be kept.
void find_tightening(ToleranceBand& band, double value, const Scatter& scatter) {
  const double room = *band.within - std::abs(band.center - value);
  if (room < 0 || !(band.deviation > 0)) {
    return;
  }
  const double target = room / kBandSigmas;  // for σ
  band.tighten_all = target / band.deviation;
  band.tighten = scatter.factor_for(band.order.front(), target * target);
}

ToleranceBand band_of(const ToleranceTask& task, const ResultSensitivity& result,
                      std::optional<double> within) {
  ToleranceBand band;
  band.center = band.worst_low = band.worst_high = result.value;
  std::vector<double> deviations;
  double beyond = 0;  // how far normal numbers of fewer than 3 σ a zone take the result beyond its ends
  for (std::size_t i = 0; i < task.tolerances.size(); ++i) {
    const Tolerance& tolerance = task.tolerances[i];
    const Slope& slope = result.slopes[i];
    deviations.push_back(0);
    if (slope.kind == SlopeKind::kNone) {
      band.complete = false;
      continue;
    }
    const double low = slope.change(-tolerance.minus), high = slope.change(tolerance.plus);
    const bool around = tolerance.minus >= 0 && tolerance.plus >= 0;  // at a kink the nominal value counts
    band.worst_low += std::min({low, high, around ? 0 : low});
    band.worst_high += std::max({low, high, around ? 0 : high});
    band.center += slope.change(tolerance.middle() - tolerance.value);
    deviations.back() = slope.steepest() * tolerance.deviation();
    if (tolerance.kind == DistributionKind::kNormal) {
      beyond +=
          std::max(kBandSigmas / tolerance.sigmas - 1, 0.0) * std::abs(slope.steepest() * tolerance.half());
    }
  }
  const Scatter scatter(task, deviations);
  band.deviation = std::sqrt(scatter.variance());
  band.low = std::max(band.center - kBandSigmas * band.deviation, band.worst_low - beyond);
  band.high = std::min(band.center + kBandSigmas * band.deviation, band.worst_high + beyond);
  for (const double part : scatter.parts()) {
    band.shares.push_back(scatter.variance() > 0 ? part / scatter.variance() : 0);
  }
  band.order.resize(band.shares.size());
  std::iota(band.order.begin(), band.order.end(), std::size_t{0});
  std::stable_sort(band.order.begin(), band.order.end(),
                   [&](std::size_t a, std::size_t b) { return band.shares[a] > band.shares[b]; });
  band.within = within;
  if (within) {
    const auto fits = [&](double low, double high) {
      const double slack = kBandSlack * (std::abs(result.value) + *within);
      return high - result.value <= *within + slack && result.value - low <= *within + slack;
    };
    band.kept = fits(band.low, band.high);
    band.worst_kept = fits(band.worst_low, band.worst_high);
    if (!band.kept) find_tightening(band, result.value, scatter);
  }
  return band;
}

}  // namespace

std::vector<ToleranceBand> tolerance_bands(const ToleranceTask& task, const SensitivityReport& report) {
  std::vector<ToleranceBand> bands;
  for (const ResultSensitivity& result : report.results) {
    const auto wanted =
        std::find_if(task.results.begin(), task.results.end(), [&](const ToleranceResult& one) {
          return one.name == result.name && one.measure.column == result.measure.column;
        });
    bands.push_back(band_of(task, result, wanted == task.results.end() ? std::nullopt : wanted->within));
  }
  return bands;
}

}  // namespace higherpair

#include "higherpair/front/tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace higherpair {
namespace {

// How much a result changes with one number, along its slope.
double change_by(const Slope& slope, double of_number) {
  return (of_number < 0 ? slope.down : slope.up) * of_number;
}

// Of a wanted band: how far a narrower scatter brings it.
void find_tightening(ToleranceBand& band, double value, double most_share) {
  const double room = *band.within - std::abs(band.center - value);
  if (room < 0 || !(band.deviation > 0)) {
    return;
  }
  const double target = room / kBandSigmas / band.deviation;  // of σ
  band.tighten_all = target;
  const double square = (target * target - (1 - most_share)) / most_share;
  if (square >= 0) band.tighten = std::sqrt(square);
}

ToleranceBand band_of(const ToleranceTask& task, const ResultSensitivity& result,
                      std::optional<double> within) {
  ToleranceBand band;
  band.center = band.worst_low = band.worst_high = result.value;
  std::vector<double> variances;
  for (std::size_t i = 0; i < task.tolerances.size(); ++i) {
    const Tolerance& tolerance = task.tolerances[i];
    const Slope& slope = result.slopes[i];
    variances.push_back(0);
    if (slope.kind == SlopeKind::kNone) {
      band.complete = false;
      continue;
    }
    const double low = change_by(slope, -tolerance.minus), high = change_by(slope, tolerance.plus);
    const bool around = tolerance.minus >= 0 && tolerance.plus >= 0;  // of a kink the number itself counts
    band.worst_low += std::min({low, high, around ? 0 : low});
    band.worst_high += std::max({low, high, around ? 0 : high});
    band.center += change_by(slope, tolerance.middle() - tolerance.value);
    variances.back() = std::pow(slope.steepest() * tolerance.deviation(), 2);
  }
  const double variance = std::accumulate(variances.begin(), variances.end(), 0.0);
  band.deviation = std::sqrt(variance);
  band.low = std::max(band.center - kBandSigmas * band.deviation, band.worst_low);
  band.high = std::min(band.center + kBandSigmas * band.deviation, band.worst_high);
  for (const double one : variances) band.shares.push_back(variance > 0 ? one / variance : 0);
  band.order.resize(variances.size());
  std::iota(band.order.begin(), band.order.end(), std::size_t{0});
  std::stable_sort(band.order.begin(), band.order.end(),
                   [&](std::size_t a, std::size_t b) { return variances[a] > variances[b]; });
  band.within = within;
  if (within) {
    const auto fits = [&](double low, double high) {
      const double slack = 1e-12 * (std::abs(result.value) + *within);
      return high - result.value <= *within + slack && result.value - low <= *within + slack;
    };
    band.kept = fits(band.low, band.high);
    band.worst_kept = fits(band.worst_low, band.worst_high);
    if (!band.kept) find_tightening(band, result.value, band.shares[band.order.front()]);
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

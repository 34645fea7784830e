#pragma once

#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/tolerances.hpp"
#include "numeric/chebyshev.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

// The largest value of a function of one variable that is smooth except for jumps and kinks, to within
// rounding: samples show near which places it can be, and there the function is resolved by Chebyshev series.

/// A place and the value there.
struct Peak {
  double at = 0;
  double value = -kInf;
};

/// Limits of the cost of a search, and values that it may ignore.
struct PeakLimits {
  double shortest = 0;  ///< interval: position of a jump is known to this
  double noise = 0;     ///< smaller differences of values are rounding
  /// A value found elsewhere; lower ones are of no use.
  double known = -kInf;
  int calls = 3000;  ///< calls of the function between two neighbouring samples
};

/// The largest value of f strictly between two places, including its one-sided limits at jumps and ends.
/// Where f is a NaN it is not defined. Intervals are halved until the series of each has converged, or its
/// last terms are small and do not fall any more, so that they are rounding. The half next to the larger
/// values comes first; a half over which the series stays below what is already known, by many times its last
/// terms, is left out.
/// \param last  size of the last terms of the interval that was halved to give this one, and of that before:
/// at a kink one of them may not fall
template <class F>
void raise(const F& f, double from, double to, PeakLimits& limits, Peak& best,
           const std::array<double, 2>& last = {kInf, kInf}) {
  ChebyshevSeries values;
  const auto place = [&](double t) { return (from + to) / 2 + t * (to - from) / 2; };
  bool whole = true;
  double left = -kInf, right = left;
  for (std::size_t j = 0; j < kNodes; ++j) {
    const double at = place(node(j));
    const double value = f(at);
    values[j] = -value;
    if (!std::isfinite(value)) {
      whole = false;
      continue;
    }
    (j < kNodes / 2 ? left : right) = std::max(value, j < kNodes / 2 ? left : right);
    best = value > best.value ? Peak{at, value} : best;
  }
  limits.calls -= static_cast<int>(kNodes);
  double tail = kInf;
  std::array<double, 2> highest{tail, tail};  // upper bounds of the function in each half
  if (whole) {
    const ChebyshevSeries series = interpolate(values);
    tail = std::abs(series[kNodes - 1]) + std::abs(series[kNodes - 2]) + std::abs(series[kNodes - 3]);
    if (tail <= limits.noise || (tail <= kRoughTerms * limits.noise && tail * kTermsFall >= last[0] &&
                                 last[0] * kTermsFall >= last[1])) {
      LowestValue lowest{0, kInf};
      find_lower(series, std::max(kFineOfNoise * limits.noise, kFineOfTerms * tail), lowest);
      const double t = settled_minimum(series, lowest.t);
      if (-value_at(series, t) > best.value) {
        best = {t == -1 ? from : t == 1 ? to : place(t), -value_at(series, t)};
      }
      return;
    }
    for (const std::size_t side : {0U, 1U}) {
      const ChebyshevSeries own = half(series, side == 0 ? -1 : 1);
      highest[side] = spread(own) - own[0] + kFarthestSeries * tail;
    }
  }
  if (!(to - from > limits.shortest) || std::max(left, right) == -kInf || limits.calls <= 0) {
    return;
  }
  const double middle = (from + to) / 2;
  for (const bool first : {left >= right, left < right}) {
    if (highest[first ? 0 : 1] < std::max(best.value, limits.known) - limits.noise) {
      continue;
    }
    const std::array terms{tail, last[0]};
    first ? raise(f, from, middle, limits, best, terms) : raise(f, middle, to, limits, best, terms);
  }
}

/// Collects samples of stretches in which a function is continuous, and finds the largest value of all.
class PeakFinder {
public:
  /// Ascending places and the values there; a NaN: not defined. Values of two stretches may differ where they
  /// meet.
  /// \param from, to  ends of the stretch: the first and the last place, or beyond them
  void add(std::span<const double> at, std::span<const double> values, double from, double to) {
    const auto level = [&](std::size_t i) { return i < values.size() ? values[i] : kNoValue; };
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double before = level(i - 1), after = level(i + 1);  // level(-1) is beyond the end: a NaN
      scale_ = std::isfinite(values[i]) ? std::max(scale_, std::abs(values[i])) : scale_;
      if (!std::isfinite(values[i]) || before >= values[i] || after > values[i]) {
        continue;
      }
      const double low = i > 0 ? at[i - 1] : from, high = i + 1 < values.size() ? at[i + 1] : to;
      const auto slope = [&](double beside, double distance) {
        return std::isfinite(beside) ? (values[i] - beside) / distance : kInf;
      };
      const double steepest = std::max(i > 0 ? slope(before, at[i] - low) : 0.0,
                                       i + 1 < values.size() ? slope(after, high - at[i]) : 0.0);
      double open = kOpenRises * steepest * std::max(at[i] - low, high - at[i]);
      if (values.size() == 1 && to > from) open = kInf;
      candidates_.push_back({low, high, {at[i], values[i]}, open});
    }
  }

  /// The first of the places at which `f` has its largest value, to within rounding; none where it is nowhere
  /// defined, or where no sample shows that it may exceed what is known.
  /// \param limits  its noise is raised to at least the rounding of the largest sample
  template <class F>
  [[nodiscard]] std::optional<Peak> largest(const F& f, PeakLimits limits) {
    limits.noise = std::max(limits.noise, kPeakRounding * scale_);
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.peak.value > b.peak.value; });
    double best = limits.known;
    int left = kMostCalls;
    std::vector<Peak> found;
    for (const Candidate& candidate : candidates_) {
      if (candidate.peak.value + candidate.open < best) {
        continue;
      }
      Peak peak = candidate.peak;
      if (candidate.open > limits.noise && left > 0) {
        PeakLimits own = limits;
        own.known = best;
        raise(f, candidate.from, candidate.to, own, peak);
        left -= limits.calls - own.calls;
      }
      best = std::max(best, peak.value);
      found.push_back(peak);
    }
    std::optional<Peak> first;
    for (const Peak& peak : found) {
      if (peak.value >= best - limits.noise && (!first || peak.at < first->at)) {
        first = peak;
      }
    }
    return first;
  }

private:
  struct Candidate {
    double from = 0;
    double to = 0;
    Peak peak;
    double open = 0;  // how much higher the function may be between the samples
  };
  static constexpr int kMostCalls = 40000;
  // How much higher a function may be beside a sample, in multiples of what it rises by at the slope up to
  // it: towards an end it may rise ever faster.
  static constexpr double kOpenRises = 2;

  std::vector<Candidate> candidates_;
  double scale_ = 0;  // largest absolute value
};

}  // namespace higherpair

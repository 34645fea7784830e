#include "measure_series.hpp"

#include "front/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

constexpr std::size_t kParallel = 8;  // independent comparisons, which can be done at once

}  // namespace

Extremes extremes_of(std::span<const double> values) {
  std::array<double, kParallel> low;
  std::array<double, kParallel> high;
  low.fill(values.front());
  high.fill(values.front());
  std::size_t k = 0;
  for (; k + kParallel <= values.size(); k += kParallel) {
    for (std::size_t i = 0; i < kParallel; ++i) {
      const double value = values[k + i];
      low[i] = value < low[i] ? value : low[i];
      high[i] = value > high[i] ? value : high[i];
    }
  }
  for (; k < values.size(); ++k) {
    low[0] = std::min(low[0], values[k]);
    high[0] = std::max(high[0], values[k]);
  }
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
}

namespace {

// Scaling keeps the order, so that only the extremes have to be scaled. Values next to an extreme may become
// equal to it: the first of them is its row.
class SeriesMeasure {
public:
  SeriesMeasure(const Series& series, bool wants_where)
      : series_(series), extremes_(series.extremes), wants_where_(wants_where) {}

  [[nodiscard]] Measured highest() const {
    const double best = scaled(extremes_.high);
    return {best, first([&](double value) {
              return value >= extremes_.high - margin(extremes_.high) && scaled(value) == best;
            })};
  }

  [[nodiscard]] Measured lowest() const {
    const double best = scaled(extremes_.low);
    return {best, first([&](double value) {
              return value <= extremes_.low + margin(extremes_.low) && scaled(value) == best;
            })};
  }

  [[nodiscard]] Measured farthest() const {
    const double size = std::max(std::abs(extremes_.low), std::abs(extremes_.high));
    const double best = std::abs(scaled(size));
    return {best, first([&](double value) {
              return std::abs(value) >= size - margin(size) && std::abs(scaled(value)) == best;
            })};
  }

  [[nodiscard]] double range() const { return scaled(extremes_.high) - scaled(extremes_.low); }

private:
  [[nodiscard]] double scaled(double value) const { return series_.scale.apply(value); }
  static double margin(double value) { return kScalingRounding * std::abs(value); }

  template <class Is>
  [[nodiscard]] double first(const Is& is) const {
    if (!wants_where_) {
      return kNoValue;
    }
    const auto found = std::find_if(series_.values.begin(), series_.values.end(), is);
    return series_.where[found - series_.values.begin()];
  }

  const Series& series_;
  Extremes extremes_;
  bool wants_where_;
};

Measured at_place(const Series& series, double at) {
  const auto off = [&](double where) { return std::abs(where - at); };
  const auto nearest = std::min_element(series.where.begin(), series.where.end(),
                                        [&](double a, double b) { return off(a) < off(b); });
  const auto [low, high] = std::minmax_element(series.where.begin(), series.where.end());
  if (!is_there(off(*nearest), at, *high - *low)) {
    return {};
  }
  const auto row = static_cast<std::size_t>(nearest - series.where.begin());
  return {series.scale.apply(series.values[row]), *nearest};
}

Measured mean_of(const Series& series, bool squares) {
  long double sum = 0;
  for (const double value : series.values) {
    const long double scaled = series.scale.apply(value);
    sum += squares ? scaled * scaled : scaled;
  }
  const long double mean = sum / static_cast<long double>(series.values.size());
  return {static_cast<double>(squares ? std::sqrt(mean) : mean)};
}

}  // namespace

Measured measured(const Measure& measure, const Series& series, bool wants_where) {
  switch (measure.of) {
    case MeasureKind::kMax:
      return SeriesMeasure(series, wants_where).highest();
    case MeasureKind::kMin:
      return SeriesMeasure(series, wants_where).lowest();
    case MeasureKind::kMaxAbs:
      return SeriesMeasure(series, wants_where).farthest();
    case MeasureKind::kRange:
      return {SeriesMeasure(series, false).range()};
    case MeasureKind::kMean:
      return mean_of(series, false);
    case MeasureKind::kRms:
      return mean_of(series, true);
    case MeasureKind::kFirst:
      return {series.scale.apply(series.values.front()), series.where.front()};
    case MeasureKind::kLast:
      return {series.scale.apply(series.values.back()), series.where.back()};
    case MeasureKind::kAt:
      return at_place(series, measure.at);
  }
  return {};
}

}  // namespace higherpair

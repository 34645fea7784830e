#include "exact_slopes.hpp"

#include "arena.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/stop.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr std::size_t kChunk = 64;  // rows that are differentiated at once

}  // namespace

// A run that has moved to a place.
struct ExactSlopes::Stop {
  PathPlace place;
  Run run;
};

ExactSlopes::ExactSlopes(PathColumns& columns, const std::vector<PathResult>& results,
                         const std::vector<Measure>& measures,
                         const std::vector<std::unique_ptr<NumberSlopes>>& slopes, int threads)
    : columns_(columns), results_(results), measures_(measures), slopes_(slopes), threads_(threads) {}

bool ExactSlopes::stopped() const {
  const std::atomic<bool>* const stop = columns_.settings().stop;
  return is_raised(stop);
}

void ExactSlopes::take() {
  take_places();
  if (!stopped()) take_rows();
}

// Slopes of all columns at every place of an extreme, by every number.
void ExactSlopes::take_places() {
  std::vector<PathPlace> places;
  for (std::size_t m = 0; m < results_.size(); ++m) {
    for (const auto& part : results_[m].parts) {
      for (const ExtremePlace& extreme : part) places.push_back(extreme.place);
    }
  }
  std::sort(places.begin(), places.end(), [](auto& a, auto& b) { return a.row < b.row; });
  const auto same = [](auto& a, auto& b) { return a.row == b.row; };
  places.erase(std::unique(places.begin(), places.end(), same), places.end());
  std::vector<Stop> stops;
  PathWalk walk(columns_);
  for (const PathPlace& place : places) {
    if (stopped()) return;
    stops.push_back({place, walk.go_to(place)});
    place_index_[place.row] = stops.size() - 1;
  }
  at_places_.resize(slopes_.size());
  for_each_on_threads(slopes_.size(), threads_, [&](std::size_t i) {
    for (const Stop& stop : stops) {
      if (stopped()) return;
      at_places_[i].push_back(slopes_at(i, stop));
    }
  });
}

std::vector<double> ExactSlopes::slopes_at(std::size_t number, const Stop& stop) const {
  const std::size_t count = columns_.columns().size();
  switch (slopes_[number]->state()) {
    case NumberSlopes::State::kNoInfluence:
      return std::vector<double>(count, 0.0);
    case NumberSlopes::State::kExact:
      return slopes_[number]->at(stop.run, stop.place).value_or(std::vector<double>(count, kNoValue));
    default:
      return std::vector<double>(count, kNoValue);
  }
}

// Derivatives of means, over all rows that have a value.
void ExactSlopes::take_rows() {
  const bool needed = std::any_of(measures_.begin(), measures_.end(), [](const Measure& measure) {
    return measure.of == MeasureKind::kMean || measure.of == MeasureKind::kRms;
  });
  means_.assign(slopes_.size(), std::vector<double>(measures_.size(), 0.0));
  std::vector<std::int64_t> counted(measures_.size(), 0);
  const std::int64_t rows = columns_.drivers().schedule().size();
  PathWalk walk(columns_);
  std::vector<double> values;
  for (std::int64_t row = 0; needed && row < rows && !stopped();) {
    std::vector<Stop> stops;
    std::vector<std::vector<double>> at;
    for (; row < rows && stops.size() < kChunk && !stopped(); ++row) {
      const PathPlace place{static_cast<double>(row), columns_.parameter_of(row)};
      stops.push_back({place, walk.go_to(place)});
      columns_.values(stops.back().run, place, values);
      at.push_back(values);
      for (std::size_t m = 0; m < measures_.size(); ++m) {
        counted[m] += std::isnan(values[results_[m].column]) ? 0 : 1;
      }
    }
    for_each_on_threads(slopes_.size(), threads_, [&](std::size_t i) {
      for (std::size_t k = 0; k < stops.size() && !stopped(); ++k) add_means(i, stops[k], at[k]);
    });
  }
  for (std::vector<double>& means : means_) {
    for (std::size_t m = 0; m < means.size(); ++m) means[m] /= static_cast<double>(counted[m]);
  }
}

void ExactSlopes::add_means(std::size_t number, const Stop& stop, const std::vector<double>& values) {
  const std::vector<double> slopes = slopes_at(number, stop);
  for (std::size_t m = 0; m < measures_.size(); ++m) {
    const std::size_t column = results_[m].column;
    if (std::isnan(values[column])) continue;
    const double weight = measures_[m].of == MeasureKind::kRms
                              ? (results_[m].value > 0 ? values[column] / results_[m].value : 0)
                              : 1;
    means_[number][m] += weight * slopes[column];
  }
}

Slope ExactSlopes::of(std::size_t number, std::size_t measure) const {
  const PathResult& result = results_[measure];
  Slope slope;
  if (std::isnan(result.value)) {
    return slope;
  }
  if (result.parts.empty()) {
    slope.down = slope.up = means_[number][measure];
  } else {
    slope.down = slope.up = 0;
    for (const auto& part : result.parts) {
      double least = kInf, most = -least;
      for (const ExtremePlace& extreme : part) {
        const double one =
            extreme.weight * at_places_[number][place_index_.at(extreme.place.row)][result.column];
        least = std::isnan(one) ? one : std::min(least, one);
        most = std::isnan(one) ? one : std::max(most, one);
        if (std::isnan(one)) break;
      }
      slope.down += result.factor * least;
      slope.up += result.factor * most;
    }
  }
  const bool kink =
      std::abs(slope.up - slope.down) > kSameSlope * std::max(std::abs(slope.up), std::abs(slope.down));
  if (!kink) slope.down = slope.up = (slope.down + slope.up) / 2;
  slope.kind = std::isnan(slope.up) ? SlopeKind::kNone : kink ? SlopeKind::kKink : SlopeKind::kExact;
  return slope;
}

}  // namespace higherpair

#include "exact_slopes.hpp"

#include "front/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/stop.hpp"
#include "numeric/arena.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <boost/math/tools/minima.hpp>

namespace higherpair {
namespace {

constexpr std::size_t kChunk = 64;          // rows that are differentiated at once
constexpr std::uintmax_t kMostTrials = 40;  // of places within a stretch

// How much weight times a column gains with a small step of the number to one side (1: up, -1: down).
double gain_of(const SidedSlope& slope, double weight, double side) {
  return side * weight * (side > 0 ? slope.up : slope.down);
}

}  // namespace

ExactSlopes::ExactSlopes(PathColumns& columns, const std::vector<PathResult>& results,
                         const std::vector<Measure>& measures,
                         const std::vector<std::unique_ptr<NumberSlopes>>& slopes, int threads)
    : columns_(columns), results_(results), measures_(measures), slopes_(slopes), threads_(threads) {}

bool ExactSlopes::stopped() const {
  return is_raised(columns_.settings().stop);
}

void ExactSlopes::take() {
  take_places();
  if (!stopped()) take_rows();
}

ExactSlopes::Stop ExactSlopes::stop_at(const PathPlace& place, const Run& run) const {
  return {place, run, rates_to_ask(columns_, run, place)};
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
  PathWalk walk(columns_);
  for (const PathPlace& place : places) {
    if (stopped()) return;
    stops_.push_back(stop_at(place, walk.go_to(place)));
    place_index_[place.row] = stops_.size() - 1;
  }
  at_places_.resize(slopes_.size());
  extremes_.assign(slopes_.size(), std::vector<SidedSlope>(results_.size()));
  for_each_on_threads(slopes_.size(), threads_, [&](std::size_t i) {
    for (const Stop& stop : stops_) {
      if (stopped()) return;
      at_places_[i].push_back(slopes_at(i, stop));
    }
    for (std::size_t m = 0; m < results_.size() && !stopped(); ++m) {
      for (const auto& part : results_[m].parts) {
        const SidedSlope slope = of_part(i, m, part);
        extremes_[i][m].down += results_[m].factor * slope.down;
        extremes_[i][m].up += results_[m].factor * slope.up;
      }
    }
  });
}

// Of the largest weighted value of the column among the places of a part: each side follows the one that
// gains most. None where the column has a kink at an extreme that is a single place: the extreme moves along
// the path with it.
SidedSlope ExactSlopes::of_part(std::size_t number, std::size_t measure,
                                const std::vector<ExtremePlace>& part) const {
  const std::size_t column = results_[measure].column;
  SidedSlope slope;
  for (const double side : {-1.0, 1.0}) {
    std::vector<double> gains;
    for (const ExtremePlace& at : part) {
      const SidedSlope& there = at_places_[number][place_index_.at(at.place.row)].of[column];
      const bool moves = is_extreme(measures_[measure].of) && at.stretch == 0 && there.is_kink() &&
                         columns_.path().path.knots.size() > 1;
      gains.push_back(moves ? kNoValue : gain_of(there, at.weight, side));
    }
    const auto best = static_cast<std::size_t>(std::max_element(gains.begin(), gains.end()) - gains.begin());
    const double least = *std::min_element(gains.begin(), gains.end());
    double most = gains[best];
    if (std::any_of(gains.begin(), gains.end(), [](double gain) { return std::isnan(gain); })) {
      most = kNoValue;
    } else if (most - least > kSameSlope * std::max(std::abs(least), std::abs(most))) {
      const auto same = [&](std::size_t k) {
        return k < part.size() && part[k].stretch > 0 && part[k].stretch == part[best].stretch &&
               part[k].weight == part[best].weight;
      };
      const std::size_t from = same(best - 1) ? best - 1 : best, to = same(best + 1) ? best + 1 : best;
      if (from < to) most = std::max(most, gain_between(number, column, part[from], part[to], side));
    }
    (side < 0 ? slope.down : slope.up) = side * most;
  }
  return slope;
}

// The largest gain between two places of a stretch, by Brent's method.
double ExactSlopes::gain_between(std::size_t number, std::size_t column, const ExtremePlace& first,
                                 const ExtremePlace& last, double side) const {
  Stop stop = stops_[place_index_.at(first.place.row)];
  const auto gain = [&](double at) {
    stop.place = columns_.place(at);
    stop.rates = RatesAsked::kAll;
    move_to(stop.run, motions_of(columns_.drivers().at(stop.place)));
    return gain_of(slopes_at(number, stop).of[column], first.weight, side);
  };
  constexpr int kHalfOfDigits = 26;
  std::uintmax_t most = kMostTrials;
  const auto loss = [&](double at) { return stopped() ? 0 : -gain(at); };
  return -boost::math::tools::brent_find_minima(loss, first.place.at, last.place.at, kHalfOfDigits, most)
              .second;
}

ExactSlopes::PlaceSlopes ExactSlopes::slopes_at(std::size_t number, const Stop& stop) const {
  const std::size_t count = columns_.columns().size();
  PlaceSlopes none{std::vector<SidedSlope>(count, {kNoValue, kNoValue})};
  switch (slopes_[number]->state()) {
    case NumberSlopes::State::kNoInfluence:
      return {std::vector<SidedSlope>(count)};
    case NumberSlopes::State::kExact: {
      auto slopes = slopes_[number]->at(stop.run, stop.place, stop.rates);
      if (slopes) return {*std::move(slopes)};
      none.diverges = slopes.error() == NoSensitivity::kDiverges;
      return none;
    }
    default:
      return none;
  }
}

// Whether the derivative has no bounds at a place that counts.
bool ExactSlopes::diverges(std::size_t number, std::size_t measure) const {
  const auto& parts = results_[measure].parts;
  return parts.empty() ? means_diverge_[number] != 0
                       : std::any_of(parts.begin(), parts.end(), [&](const auto& part) {
                           return std::any_of(part.begin(), part.end(), [&](const ExtremePlace& at) {
                             return at_places_[number][place_index_.at(at.place.row)].diverges;
                           });
                         });
}

// Derivatives of means, over all rows that have a value.
void ExactSlopes::take_rows() {
  const bool needed = std::any_of(measures_.begin(), measures_.end(), [](const Measure& measure) {
    return measure.of == MeasureKind::kMean || measure.of == MeasureKind::kRms;
  });
  means_.assign(slopes_.size(), std::vector<SidedSlope>(measures_.size()));
  means_diverge_.assign(slopes_.size(), 0);
  std::vector<std::int64_t> counted(measures_.size(), 0);
  const std::int64_t rows = columns_.drivers().schedule().size();
  PathWalk walk(columns_);
  std::vector<double> values;
  for (std::int64_t row = 0; needed && row < rows && !stopped();) {
    std::vector<Stop> stops;
    std::vector<std::vector<double>> at;
    for (; row < rows && stops.size() < kChunk && !stopped(); ++row) {
      const PathPlace place = columns_.place_of_row(row);
      stops.push_back(stop_at(place, walk.go_to(place)));
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
  for (std::vector<SidedSlope>& means : means_) {
    for (std::size_t m = 0; m < means.size(); ++m) {
      means[m].down /= static_cast<double>(counted[m]);
      means[m].up /= static_cast<double>(counted[m]);
      if (vanishes(m)) means[m] = {-std::sqrt(means[m].down), std::sqrt(means[m].up)};
    }
  }
}

// A root mean square of zeros: it grows with the size of every change, as the root of the mean square of the
// slopes.
bool ExactSlopes::vanishes(std::size_t measure) const {
  return measures_[measure].of == MeasureKind::kRms &&
         !(results_[measure].value > results_[measure].rounding);
}

void ExactSlopes::add_means(std::size_t number, const Stop& stop, const std::vector<double>& values) {
  const PlaceSlopes slopes = slopes_at(number, stop);
  if (slopes.diverges) means_diverge_[number] = 1;
  for (std::size_t m = 0; m < measures_.size(); ++m) {
    const std::size_t column = results_[m].column;
    if (std::isnan(values[column])) continue;
    const auto [down, up] = slopes.of[column];
    const bool root = measures_[m].of == MeasureKind::kRms;
    means_[number][m].down += vanishes(m) ? down * down
                              : root      ? values[column] / results_[m].value * down
                                          : down;
    means_[number][m].up += vanishes(m) ? up * up : root ? values[column] / results_[m].value * up : up;
  }
}

Slope ExactSlopes::of(std::size_t number, std::size_t measure) const {
  const PathResult& result = results_[measure];
  Slope slope;
  if (std::isnan(result.value)) {
    return slope;
  }
  const SidedSlope& sided = (result.parts.empty() ? means_ : extremes_)[number][measure];
  slope.down = sided.down;
  slope.up = sided.up;
  const bool kink =
      std::abs(slope.up - slope.down) > kSameSlope * std::max(std::abs(slope.up), std::abs(slope.down));
  if (!kink) slope.down = slope.up = (slope.down + slope.up) / 2;
  slope.kind = std::isnan(slope.up) ? SlopeKind::kNone : kink ? SlopeKind::kKink : SlopeKind::kExact;
  if (slope.kind == SlopeKind::kNone && diverges(number, measure)) {
    slope.remark = "it grows without bounds towards a change point, which there is with no other value";
  }
  return slope;
}

}  // namespace higherpair

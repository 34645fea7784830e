#include "path_results.hpp"

#include "front/check/check_parts.hpp"
#include "front/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "sampled_columns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr std::size_t kMostTies = 6;

}  // namespace

double rounding_of(const PathColumns& columns, std::size_t column) {
  const Dimension& of = columns.dimension(column);
  if (of.force != 0 || of.mass != 0) {
    return 0;
  }
  const double size = columns.start().plan().size;
  return from_si(of, columns.units())
      .apply(kResultRounding * std::pow(size, of.length) * std::pow(columns.rate(), -of.time));
}

// One extreme of a column: the largest value of sign times the column.
struct PathResults::Extreme {
  double value = -kInf;  // of sign times the column
  PathPlace where;
  std::vector<ExtremePlace> places;
  std::optional<double> rival;  // as value
  std::optional<PathPlace> rival_where;
  bool jumps = false;
  bool grows = false;
  std::optional<PathPlace> grows_at;  // elsewhere, beyond `value`
  double limit = -kInf;               // what sign times the column tends to there
};

PathResults::PathResults(Analysis& analysis, PathColumns& columns, std::span<const Measure> measures,
                         bool ties)
    : columns_(columns), path_(columns.path().path) {
  take_rows(analysis, measures);
  if (!is_stopped(columns.start())) take_extremes(measures, ties);
}

void PathResults::take_rows(Analysis& analysis, std::span<const Measure> measures) {
  MeasureSet set({measures.begin(), measures.end()}, analysis.columns());
  low_.assign(analysis.columns().size(), kInf);
  high_.assign(analysis.columns().size(), -kInf);
  Row row;
  std::int64_t first = -1, last = -1;
  std::vector<std::int64_t> at(measures.size(), 0);
  std::vector<double> off(measures.size(), kInf);
  while (analysis.next(row)) {
    set.add(row);
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      if (std::isnan(row.values[i])) continue;
      low_[i] = std::min(low_[i], row.values[i]);
      high_[i] = std::max(high_[i], row.values[i]);
    }
    for (std::size_t m = 0; m < measures.size(); ++m) {
      const double distance = std::abs(row.values[set.where_slot()] - measures[m].at);
      if (distance < off[m]) {
        off[m] = distance;
        at[m] = row.number;
      }
    }
    first = first < 0 ? row.number : first;
    last = row.number;
  }
  for (std::size_t m = 0; m < measures.size(); ++m) {
    PathResult& result = results_.emplace_back();
    result.column = column_slot(analysis.columns(), measures[m].column);
    result.value = set.value(m).value;
    result.rounding = rounding_of(columns_, result.column);
    if (measures[m].of == MeasureKind::kFirst && first >= 0) result.where = columns_.place_of_row(first);
    if (measures[m].of == MeasureKind::kLast && last >= 0) result.where = columns_.place_of_row(last);
    if (measures[m].of == MeasureKind::kAt && last >= 0) result.where = columns_.place_of_row(at[m]);
    if (result.where) result.parts = {{{*result.where, 1}}};
  }
}

void PathResults::take_extremes(std::span<const Measure> measures, bool ties) {
  const std::size_t count = columns_.columns().size();
  PathQuantities quantities;
  quantities.sought.resize(count);
  bool any = false;
  for (std::size_t m = 0; m < measures.size(); ++m) {
    if (!is_extreme(measures[m].of) || std::isnan(results_[m].value)) continue;
    any = true;
    Sought& sought = quantities.sought[results_[m].column];
    sought.greatest = sought.greatest || measures[m].of != MeasureKind::kMin;
    sought.least = sought.least || measures[m].of != MeasureKind::kMax;
    sought.noise = rounding_of(columns_, results_[m].column);
  }
  if (!any) {
    return;
  }
  end_ = cut_to_examined(columns_.start(), path_);
  std::vector<double> values;
  quantities.values = [&](const Run& run, double at, std::span<double> out) {
    columns_.values(run, columns_.place(at), values);
    std::copy(values.begin(), values.end(), out.begin());
  };
  const std::vector<double> breaks = known_breaks(
      {columns_.data().profile, columns_.drivers().schedule(), columns_.start(), nullptr}, path_);
  const auto ranges = path_extremes(columns_.start(), path_, {quantities}, breaks);
  if (is_stopped(columns_.start())) {
    return;
  }
  std::optional<SampledColumns> sampled;
  if (ties) sampled.emplace(columns_, path_);
  for (std::size_t m = 0; m < measures.size(); ++m) {
    if (!is_extreme(measures[m].of) || std::isnan(results_[m].value)) continue;
    PathResult result =
        extreme_result(measures[m], results_[m].column, ranges.front(), sampled ? &*sampled : nullptr);
    if (!std::isfinite(result.value)) {  // only rows have a value, at singular positions
      result = PathResult();
      result.column = results_[m].column;
    }
    const double spread = high_[result.column] - low_[result.column];
    result.rounding = rounding_of(columns_, result.column);
    result.constant = path_.knots.size() > 1 &&
                      spread <= std::max(result.rounding, kResultRounding * std::abs(high_[result.column]));
    results_[m] = std::move(result);
  }
}

PathResult PathResults::extreme_result(const Measure& measure, std::size_t column,
                                       const std::vector<PathRange>& ranges, SampledColumns* sampled) {
  PathResult result;
  result.column = column;
  const PathRange& range = ranges[column];
  const auto take = [&](const Extreme& extreme) {
    result.parts.push_back(extreme.places);
    result.jumps = result.jumps || extreme.jumps;
    result.grows = result.grows || extreme.grows;
    if (extreme.grows_at) result.grows_at = extreme.grows_at;
  };
  std::optional<Extreme> high, low;
  if (measure.of != MeasureKind::kMin) high = extreme(column, 1, range.greatest, sampled);
  if (measure.of != MeasureKind::kMax) low = extreme(column, -1, range.least, sampled);
  if (measure.of == MeasureKind::kRange) {
    take(*high);
    take(*low);
    result.value = high->value + low->value;
    return result;
  }
  if (high && low) {  // the larger absolute value; the other sign is a rival
    if (low->value > high->value) std::swap(high, low);
    result.grows_with_other_sign = (low->grows && low->value > 0) || low->limit > high->value;
    const double same = kSameResult * (high->value + std::abs(low->value));
    if (low->value >= high->value - same) {
      high->places.insert(high->places.end(), low->places.begin(), low->places.end());
    } else if (!low->places.empty() && (!high->rival || low->value > *high->rival)) {
      high->rival = low->value;
      high->rival_where = low->where;
    }
  }
  Extreme& best = high ? *high : *low;
  result.factor = measure.of == MeasureKind::kMin ? -1 : 1;
  take(best);
  result.value = result.factor * best.value;
  if (!best.places.empty()) result.where = best.where;
  if (best.rival) {
    result.rival = result.factor * *best.rival;
    result.rival_where = best.rival_where;
  }
  return result;
}

PathResults::Extreme PathResults::extreme(std::size_t column, double sign,
                                          const std::optional<PathExtreme>& found, SampledColumns* sampled) {
  Extreme extreme;
  if (!found) {
    return extreme;
  }
  extreme.value = sign * found->value;
  extreme.where = columns_.place(found->at);
  extreme.places = {{extreme.where, sign}};
  extreme.grows = found->grows;
  if (found->growth) {
    extreme.grows_at = columns_.place(found->growth->at);
    extreme.limit = sign * found->growth->limit;
  }
  const double spread = high_[column] - low_[column];
  if (sampled == nullptr) {
    return extreme;
  }
  extreme.jumps = jumps_at(column, *found, spread);
  const double noise = rounding_of(columns_, column);
  const double same = std::max(kSameResult * spread, noise);
  const double worth = std::abs(extreme.value) + spread;  // keep every rival, however small
  const double rounding = std::max(noise, kResultRounding * std::abs(extreme.value));
  int number = 0;
  for (const SampledColumns::Stretch& stretch : sampled->stretches(column, sign, extreme.value, rounding)) {
    if (found->at >= stretch.from && found->at <= stretch.to) extreme.places.erase(extreme.places.begin());
    ++number;
    for (const double at : stretch.places) extreme.places.push_back({columns_.place(at), sign, number});
  }
  std::size_t ties = 1;
  for (const Peak& peak :
       sampled->others(column, sign, found->at, extreme.value - worth, extreme.value - rounding, noise)) {
    if (peak.value >= extreme.value - same) {
      if (ties++ < kMostTies) extreme.places.push_back({columns_.place(peak.at), sign});
    } else if (!extreme.rival || peak.value > *extreme.rival) {
      extreme.rival = peak.value;
      extreme.rival_where = columns_.place(peak.at);
    }
  }
  return extreme;
}

// Whether the column jumps or has a kink at an extreme. At the ends of the path the place is fixed; anywhere
// else a smooth column is level there.
bool PathResults::jumps_at(std::size_t column, const PathExtreme& found, double spread) {
  const std::vector<double>& knots = path_.knots;
  const double beside = kBesideExtreme * (knots.back() - knots.front());
  const bool end = found.at - knots.front() <= beside || knots.back() - found.at <= beside;
  if (end || knots.size() == 1) {
    return false;
  }
  const double fall = std::max(
      {kSmoothFall * spread, rounding_of(columns_, column), kResultRounding * std::abs(found.value)});
  PathWalk walk(columns_);
  std::vector<double> values;
  for (const double at : {found.at - beside, found.at, found.at + beside}) {
    const PathPlace place = columns_.place(at);
    columns_.values(walk.go_to(place), place, values);
    if (!(std::abs(values[column] - found.value) <= fall)) return true;
  }
  return false;
}

}  // namespace higherpair

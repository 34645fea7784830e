#include "path_results.hpp"

#include "front/check/check_parts.hpp"
#include "front/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/peaks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr int kSamples = 720;   // of a path, among which other extremes are sought
constexpr int kMarkEvery = 24;  // samples between states that are kept to continue from
constexpr std::size_t kMostTies = 6;
constexpr std::size_t kMostRefined = 12;
constexpr std::size_t kMostFlat = 48;   // places on a stretch on which a column is constant
constexpr int kEdgeHalvings = 40;       // between two samples, to find where such a stretch ends
constexpr double kEdgeFalls = 8;        // factor between what the column has fallen by at three places beyond
constexpr double kLeastEdgeBend = 0.2;  // the end stays there if it falls with a higher power of the distance

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

// All columns at equally spaced places of the path, to find where else they are large.
class PathResults::Sampled {
public:
  Sampled(PathColumns& columns, const DriverPath& path) : columns_(columns), path_(path) {
    PathWalk walk(columns);
    const std::vector<double>& knots = path.knots;
    std::vector<double> values;
    for (int k = 0; k <= kSamples && !is_stopped(columns.start()); ++k) {
      at_.push_back(std::lerp(knots.front(), knots.back(), static_cast<double>(k) / kSamples));
      const PathPlace place = columns.place(at_.back());
      const Run& run = walk.go_to(place);
      if (k % kMarkEvery == 0) marks_.push_back(walk);
      const bool there = run.row.status != RowStatus::kNotAssemblable;
      columns.values(run, place, values);
      if (!there) std::fill(values.begin(), values.end(), kNoValue);
      values_.push_back(values);
      assembled_.push_back(there);
      if (knots.size() == 1) break;
    }
  }

  // A stretch of the path on which a column keeps to its extreme.
  struct Stretch {
    double from = 0, to = 0;     // all of it, to within `noise`
    std::vector<double> places;  // without what is only nearly at the extreme, at its ends
  };

  // Stretches on which sign times a column is `value` to within `noise`.
  [[nodiscard]] std::vector<Stretch> stretches(std::size_t column, double sign, double value,
                                               double noise) const {
    std::vector<std::size_t> samples;
    for (std::size_t k = 0; k < values_.size(); ++k) {
      if (is_flat(k, column, sign, value - noise)) samples.push_back(k);
    }
    const std::size_t stride = samples.size() / kMostFlat + 1;
    std::vector<Stretch> found;
    for (std::size_t begin = 0, end = 0; begin < samples.size(); begin = end) {
      while (end < samples.size() && samples[end] - samples[begin] == end - begin) ++end;
      const std::size_t first = samples[begin], last = samples[end - 1];
      const Edge low =
          first > 0 ? edge(column, sign, value, noise, first, first - 1) : Edge{at_[first], at_[first]};
      const Edge high = last + 1 < values_.size() ? edge(column, sign, value, noise, last, last + 1)
                                                  : Edge{at_[last], at_[last]};
      Stretch stretch{low.outer, high.outer, {low.at}};
      for (std::size_t i = begin; i < end; ++i) {
        const double at = at_[samples[i]];
        const bool wanted = i == begin || i + 1 == end || (i - begin) % stride == 0;
        if (wanted && at > low.at && at < high.at) stretch.places.push_back(at);
      }
      if (high.at > low.at) stretch.places.push_back(high.at);
      found.push_back(std::move(stretch));
    }
    return found;
  }

  // Local maxima of sign times a column away from a place, the largest first.
  // \param flat  values from here on are not sought where they are those of a whole stretch
  [[nodiscard]] std::vector<Peak> others(std::size_t column, double sign, double at, double least,
                                         double flat, double noise) {
    std::vector<std::size_t> candidates;
    const auto level = [&](std::size_t k) { return sign * values_[k][column]; };
    for (std::size_t k = 0; k < values_.size(); ++k) {
      if (is_flat(k, column, sign, flat)) continue;
      const std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, values_.size() - 1);
      const bool peak = std::isfinite(level(k)) && !(level(before) > level(k)) && !(level(after) > level(k));
      if (!peak || (at >= at_[before] && at <= at_[after])) continue;
      const double open = std::max(level(k) - level(before), level(k) - level(after));
      if (level(k) + (std::isfinite(open) ? open : kInf) >= least) candidates.push_back(k);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](std::size_t a, std::size_t b) { return level(a) > level(b); });
    // The largest ones, and of the others, which may be a lower plateau, some spread over all of them.
    const std::size_t stride = std::max<std::size_t>(1, candidates.size() / kMostRefined);
    std::vector<Peak> found;
    for (std::size_t i = 0; i < candidates.size(); i += i < kMostRefined ? 1 : stride) {
      found.push_back(refined(column, sign, candidates[i], noise));
    }
    return found;
  }

private:
  // Whether a sample and one beside it are at least as large as `least`.
  [[nodiscard]] bool is_flat(std::size_t k, std::size_t column, double sign, double least) const {
    const auto high = [&](std::size_t i) { return i < values_.size() && sign * values_[i][column] >= least; };
    return high(k) && (high(k + 1) || (k > 0 && high(k - 1)));
  }

  // An end of a stretch, and how far a column is at its extreme there to within noise.
  struct Edge {
    double at = 0;
    double outer = 0;
  };

  // The end of a stretch between a sample on it and one beside it. A column that leaves its extreme as a
  // power of the distance has fallen by noise, by 8 and by 64 times as much at places in geometric
  // progression from the end.
  [[nodiscard]] Edge edge(std::size_t column, double sign, double value, double noise, std::size_t inside,
                          std::size_t outside) const {
    if (!assembled_[outside]) {
      return {at_[inside], at_[inside]};
    }
    std::array<double, 3> at{};
    for (std::size_t i = 0; i < at.size(); ++i) {
      at[i] = fallen_by(column, sign, value, noise * std::pow(kEdgeFalls, i), inside, outside);
    }
    const double step = at[1] - at[0], bend = (at[2] - at[1]) - step;
    const double beyond = step != 0 && bend / step > kLeastEdgeBend ? step * step / bend : 0;
    const double end = at[0] - beyond;
    return {std::lerp(end, at_[inside], kInsideEdge), at[0]};
  }

  // The last place, from a sample towards one beside it, at which a column has fallen by no more than `fall`.
  [[nodiscard]] double fallen_by(std::size_t column, double sign, double value, double fall,
                                 std::size_t inside, std::size_t outside) const {
    double in = at_[inside], out = at_[outside];
    std::vector<DriverMotion> drivers;
    std::vector<double> values;
    PathWalk walk = marks_[std::min(inside, outside) / kMarkEvery];
    Run run = walk.go_to(columns_.place(at_[std::min(inside, outside)]));
    for (int i = 0; i < kEdgeHalvings; ++i) {
      const double middle = (in + out) / 2;
      path_.motion(middle, drivers);
      move_to(run, drivers);
      columns_.values(run, columns_.place(middle), values);
      (sign * values[column] >= value - fall ? in : out) = middle;
    }
    return in;
  }

  [[nodiscard]] Peak refined(std::size_t column, double sign, std::size_t k, double noise) {
    const std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, at_.size() - 1);
    Peak peak{at_[k], sign * values_[k][column]};
    if (!assembled_[before] || !assembled_[after]) {
      return peak;  // next to a limit: every place beyond it would be a search for where the motion goes on
    }
    const double from = at_[before], to = at_[after];
    PathWalk walk = marks_[before / kMarkEvery];
    Run run = walk.go_to(columns_.place(from));
    std::vector<DriverMotion> drivers;
    std::vector<double> values;
    PeakLimits limits;
    limits.shortest = kResultRounding * (at_.back() - at_.front());
    limits.noise = std::max(noise, kResultRounding * std::abs(peak.value));
    raise(
        [&](double at) {
          path_.motion(at, drivers);
          move_to(run, drivers);
          columns_.values(run, columns_.place(at), values);
          return run.row.status == RowStatus::kNotAssemblable ? kNoValue : sign * values[column];
        },
        from, to, limits, peak);
    return peak;
  }

  PathColumns& columns_;
  const DriverPath& path_;
  std::vector<double> at_;
  std::vector<std::vector<double>> values_;
  std::vector<bool> assembled_;
  std::vector<PathWalk> marks_;
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
  std::optional<Sampled> sampled;
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
                                       const std::vector<PathRange>& ranges, Sampled* sampled) {
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
                                          const std::optional<PathExtreme>& found, Sampled* sampled) {
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
  for (const Sampled::Stretch& stretch : sampled->stretches(column, sign, extreme.value, rounding)) {
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

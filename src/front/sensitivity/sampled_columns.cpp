#include "sampled_columns.hpp"

#include "front/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr int kSamples = 720;   // of a path, among which other extremes are sought
constexpr int kMarkEvery = 24;  // samples between states that are kept to continue from
constexpr std::size_t kMostRefined = 12;
constexpr std::size_t kMostFlat = 48;   // places on a stretch on which a column is constant
constexpr int kEdgeHalvings = 40;       // between two samples, to find where such a stretch ends
constexpr double kEdgeFalls = 8;        // factor between what the column has fallen by at three places beyond
constexpr double kLeastEdgeBend = 0.2;  // the end stays there if it falls with a higher power of the distance

}  // namespace

SampledColumns::SampledColumns(PathColumns& columns, const DriverPath& path)
    : columns_(columns), path_(path) {
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

// An end of a stretch, and how far a column is at its extreme there to within noise.
struct SampledColumns::Edge {
  double at = 0;
  double outer = 0;
};

std::vector<SampledColumns::Stretch> SampledColumns::stretches(std::size_t column, double sign, double value,
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

std::vector<Peak> SampledColumns::others(std::size_t column, double sign, double at, double least,
                                         double flat, double noise) const {
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

// Whether a sample and one beside it are at least as large as `least`.
bool SampledColumns::is_flat(std::size_t k, std::size_t column, double sign, double least) const {
  const auto high = [&](std::size_t i) { return i < values_.size() && sign * values_[i][column] >= least; };
  return high(k) && (high(k + 1) || (k > 0 && high(k - 1)));
}

// The end of a stretch between a sample on it and one beside it. A column that leaves its extreme as a
// power of the distance has fallen by noise, by 8 and by 64 times as much at places in geometric
// progression from the end.
SampledColumns::Edge SampledColumns::edge(std::size_t column, double sign, double value, double noise,
                                          std::size_t inside, std::size_t outside) const {
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
double SampledColumns::fallen_by(std::size_t column, double sign, double value, double fall,
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

Peak SampledColumns::refined(std::size_t column, double sign, std::size_t k, double noise) const {
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

}  // namespace higherpair

#include "worst_place.hpp"

#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace higherpair {
namespace {

// Samples between two places. Of a law with many, such as a table with rough values, each interval is small
// against all that a cam or its follower can do.
constexpr std::size_t kFewPlaces = 100;
constexpr std::size_t kParts = 12, kPartsOfMany = 2;

Lift lift_at(const MotionLaw& law, double x, LawSide side) {
  std::array<double, 3> c{};
  law.expand(x, side, c);
  return {c[0], c[1], 2 * c[2]};
}

// Where one of the first three derivatives is 0: there the one before it turns round.
std::vector<double> turning_places(const MotionLaw& law, double from, double to) {
  std::vector<double> found;
  for (const int k : {1, 2, 3}) {
    const std::vector<double> zeros = law.zeros(k, from, to);
    found.insert(found.end(), zeros.begin(), zeros.end());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

LawSearch::LawSearch(const MotionLaw& law, double from, double to) {
  const std::vector<double> turning = turning_places(law, from, to);
  const double apart = kShortestLawInterval * (to - from);
  std::vector<double> ends = law.breaks(from, to);
  ends.push_back(to);
  places_.push_back(from);
  auto next = turning.begin();
  for (const double end : ends) {
    for (; next != turning.end() && *next < end + apart; ++next) {
      if (*next > places_.back() + apart && *next < end - apart) {
        places_.push_back(*next);
      }
    }
    places_.push_back(end);
  }
  parts_ = places_.size() <= kFewPlaces ? kParts : kPartsOfMany;
}

LawSearch::Samples LawSearch::sampled(std::size_t interval, const LawFunction& f) const {
  const double from = places_[interval], to = places_[interval + 1];
  Samples samples;
  for (std::size_t k = 0; k <= parts_; ++k) {
    const double x =
        k == parts_ ? to : std::lerp(from, to, static_cast<double>(k) / static_cast<double>(parts_));
    samples.at.push_back(x);
    samples.values.push_back(f(x, k == parts_ ? LawSide::kBefore : LawSide::kAfter));
  }
  return samples;
}

PeakLimits LawSearch::limits() const {
  PeakLimits limits;
  limits.shortest = kJumpWidth * (places_.back() - places_.front());
  return limits;
}

std::optional<Peak> LawSearch::largest(const LawFunction& f) const {
  PeakFinder finder;
  for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
    const auto [at, values] = sampled(i, f);
    finder.add(at, values, at.front(), at.back());
  }
  return finder.largest([&](double x) { return f(x, LawSide::kAfter); }, limits());
}

std::optional<double> LawSearch::first_above(double level, const LawFunction& f) const {
  const auto inside = [&](double x) { return f(x, LawSide::kAfter); };
  PeakLimits above = limits();
  above.known = level;
  const auto is_above = [&](double value) { return !(value < level); };
  std::optional<double> first;
  for (std::size_t i = 0; i + 1 < places_.size() && !first; ++i) {
    const auto [at, values] = sampled(i, f);
    // Whatever is found, there may be another one among the samples before it.
    for (std::size_t count = at.size(); count > 0;) {
      const std::span<const double> x(at.data(), count), y(values.data(), count);
      PeakFinder finder;
      finder.add(x, y, x.front(), x.back());
      const auto peak = finder.largest(inside, above);
      const auto sample = std::find_if(y.begin(), y.end(), is_above);
      Peak high{kInf, level};
      if (sample != y.end()) {
        high = {x[static_cast<std::size_t>(sample - y.begin())], *sample};
      }
      if (peak && is_above(peak->value) && peak->at < high.at) {
        high = *peak;
      }
      if (high.at == kInf) {
        break;
      }
      count = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), high.at) - x.begin());
      if (count == 0) {
        return high.at;
      }
      const double low = x[count - 1];
      const auto root = root_between([&](double t) { return inside(low + t) - level; }, y[count - 1] - level,
                                     high.at - low, high.value - level);
      first = root ? low + *root : high.at;
    }
  }
  return first;
}

Worst worst_of(const MotionLaw& law, const LawSearch& search, const std::function<double(const Lift&)>& f) {
  const auto at_place = [&](double x, LawSide side) { return f(lift_at(law, x, side)); };
  const Peak peak = search.largest(at_place).value_or(Peak{law.begin(), -kInf});
  const Lift before = lift_at(law, peak.at, LawSide::kBefore), after = lift_at(law, peak.at, LawSide::kAfter);
  return {peak, f(before) > f(after) ? before : after};
}

}  // namespace higherpair

#include "worst_place.hpp"

#include "higherpair/numeric/special_values.hpp"
#include "tolerances.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace higherpair {
namespace {

constexpr std::size_t kManyPieces = 100;  // a law with more pieces needs no samples within each

Lift lift_at(const MotionLaw& law, double x, LawSide side) {
  std::array<double, 3> c{};
  law.expand(x, side, c);
  return {c[0], c[1], 2 * c[2]};
}

}  // namespace

Worst worst_of(const MotionLaw& law, const std::function<double(const Lift&)>& f) {
  std::vector<double> ends{law.begin()};
  for (const double x : law.breaks(law.begin(), law.end())) {
    ends.push_back(x);
  }
  ends.push_back(law.end());
  const std::size_t parts = ends.size() > kManyPieces ? 1 : 48;
  PeakFinder finder;
  std::vector<double> at(parts + 1), values(parts + 1);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    for (std::size_t k = 0; k <= parts; ++k) {
      at[k] = k == parts
                  ? ends[i + 1]
                  : std::lerp(ends[i], ends[i + 1], static_cast<double>(k) / static_cast<double>(parts));
      values[k] = f(lift_at(law, at[k], k == parts ? LawSide::kBefore : LawSide::kAfter));
    }
    finder.add(at, values, ends[i], ends[i + 1]);
  }
  const auto inside = [&](double x) { return f(lift_at(law, x, LawSide::kAfter)); };
  PeakLimits shortest;
  shortest.shortest = kJumpWidth * (law.end() - law.begin());
  const Peak peak = finder.largest(inside, shortest).value_or(Peak{law.begin(), -kInf});
  const Lift before = lift_at(law, peak.at, LawSide::kBefore), after = lift_at(law, peak.at, LawSide::kAfter);
  return {peak, f(before) > f(after) ? before : after};
}

}  // namespace higherpair

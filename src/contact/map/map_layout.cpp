#include "map_layout.hpp"

#include "higherpair/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kFewest = 9;  // fewest points of a branch, however short it is

}  // namespace

std::vector<SampleTarget> sample_targets(const MapBranch& branch, const MapRange& range, bool cyclic,
                                         double size) {
  const double width = cyclic ? kTurn : range.end - range.start;
  const double spacing = width / static_cast<double>(range.samples - 1);
  const double unit = cyclic ? 1 : size;
  const auto margin = [&](const MapEnd& end) {
    const bool included = end.type == MapEndType::kClosed || end.type == MapEndType::kRange;
    return std::min((included ? -kMapEndMargin : kMapEndMargin) * unit,
                    (branch.end.u - branch.begin.u) / 100);
  };
  const double low = branch.begin.u + margin(branch.begin);
  const double high = branch.end.u - margin(branch.end);
  const double a = ((spacing > 0 ? low : high) - range.start) / spacing;
  const double b = ((spacing > 0 ? high : low) - range.start) / spacing;
  std::vector<SampleTarget> targets;
  const auto last = static_cast<std::int64_t>(std::floor(b));
  for (auto k = static_cast<std::int64_t>(std::ceil(a)); k <= last && !is_stopped(range); ++k) {
    const double u = range.start + static_cast<double>(k) * spacing;
    targets.push_back({std::clamp(u, branch.begin.u, branch.end.u), k});
  }
  const bool whole = branch.begin.type == MapEndType::kClosed || branch.begin.type == MapEndType::kRange;
  if (targets.size() < kFewest && !whole) {
    targets.clear();
    for (int i = 1; i < kFewest; ++i) {
      const double share = (1 - std::cos(kPi * i / kFewest)) / 2;
      targets.push_back({low + share * (high - low), std::nullopt});
    }
  }
  if (!targets.empty() && targets.back().u < targets.front().u) {
    std::reverse(targets.begin(), targets.end());
  }
  return targets;
}

double turns_into_range(const MapBranch& branch, double start) {
  const double turns = std::ceil((start - branch.begin.u) / kTurn);
  const bool earlier = branch.end.u + (turns - 1) * kTurn >= start;
  return (earlier ? turns - 1 : turns) * kTurn;
}

double choose_turn(MapBranch& branch, double start) {
  const auto nearest = std::min_element(
      branch.points.begin(), branch.points.end(),
      [&](const MapPoint& a, const MapPoint& b) { return std::abs(a.u - start) < std::abs(b.u - start); });
  const double turn = principal_angle(nearest->q) - nearest->q;
  branch.begin.q += turn;
  branch.end.q += turn;
  for (auto* points : {&branch.points, &branch.extremes}) {
    for (MapPoint& point : *points) {
      point.q += turn;
    }
  }
  return turn;
}

void join_branches(std::vector<MapBranch>& branches, std::vector<MapEvent>& events) {
  const auto side_of = [](const MapBranch& branch, const MapEnd& end) { return &end == &branch.begin; };
  for (std::size_t i = 0; i < branches.size(); ++i) {
    for (const MapEnd* end : {&branches[i].begin, &branches[i].end}) {
      if (end->event >= 0) {
        events[end->event].branches.push_back(static_cast<int>(i));
      }
    }
  }
  for (MapBranch& branch : branches) {
    for (MapEnd* end : {&branch.begin, &branch.end}) {
      for (std::size_t i = 0; end->event >= 0 && i < branches.size(); ++i) {
        for (const MapEnd* other : {&branches[i].begin, &branches[i].end}) {
          if (other != end && other->event == end->event &&
              side_of(branches[i], *other) == side_of(branch, *end)) {
            end->other = static_cast<int>(i);
          }
        }
      }
    }
  }
}

}  // namespace higherpair

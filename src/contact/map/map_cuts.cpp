#include "map_cuts.hpp"

#include "higherpair/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

class CutFinder {
public:
  CutFinder(const ContactPair& pair, const MapRange& range) : pair_(pair) {
    map_.cyclic = pair.motion1.turns;
    map_.start = map_.cyclic ? range.start : std::min(range.start, range.end);
    map_.end = map_.cyclic ? range.start + kTurn : std::max(range.start, range.end);
    map_.size = size_of_pair(pair);
    unit1_ = map_.cyclic ? 1 : map_.size;
  }

  [[nodiscard]] MapCuts run() {
    map_.status = MapStatus::kOk;
    add_events();
    add_cuts();
    add_intervals();
    return map_;
  }

private:
  // Shifts u into the range; false if it is outside.
  [[nodiscard]] bool bring_in(double& u) const {
    if (!map_.cyclic) {
      return u > map_.start && u < map_.end;
    }
    u -= kTurn * std::floor((u - map_.start) / kTurn);
    if (u - map_.start > kTurn - kCrossingResolution) {
      u -= kTurn;  // so that positions about the start are not separated by rounding
    }
    return true;
  }

  void add_events() {
    CriticalPositions folds = find_folds(pair_);
    if (folds.everywhere) {
      map_.status = MapStatus::kLimitEverywhere;
      return;
    }
    const auto conforming = find_conforming(pair_);
    folds.found.insert(folds.found.end(), conforming.begin(), conforming.end());
    for (CriticalPosition& at : folds.found) {
      const bool known = std::any_of(map_.events.begin(), map_.events.end(),
                                     [&](const MapEvent& event) { return is_same(event.at, at); });
      if (bring_in(at.u) && !known) {
        map_.events.push_back({at, {}});
      }
    }
    std::sort(map_.events.begin(), map_.events.end(),
              [](const MapEvent& a, const MapEvent& b) { return a.at.u < b.at.u; });
  }

  [[nodiscard]] bool is_same(const CriticalPosition& a, CriticalPosition b) const {
    if (!bring_in(b.u)) {
      return false;
    }
    return std::abs(a.u - b.u) <= kCutResolution * unit1_ && a.opposed == b.opposed &&
           coordinate_distance(pair_.motion2, map_.size, a.q, b.q) <= kCutResolution &&
           (a.n_W - b.n_W).norm() <= kSameEventNormal;
  }

  [[nodiscard]] CriticalType type_of(int event) const { return map_.events[event].at.type; }

  void add_cuts() {
    struct Place {
      double u;
      int event;
    };
    std::vector<Place> places;
    for (std::size_t i = 0; i < map_.events.size(); ++i) {
      places.push_back({map_.events[i].at.u, static_cast<int>(i)});
    }
    for (double u : runaway_positions(pair_)) {
      if (bring_in(u)) {
        places.push_back({u, -1});
      }
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.u < b.u; });
    for (const Place& place : places) {
      const bool crossing = place.event >= 0 && type_of(place.event) == CriticalType::kCrossing;
      const bool near_crossing = crossing || (!map_.cuts.empty() && map_.cuts.back().crossing);
      const double resolution = (near_crossing ? kCrossingResolution : kCutResolution) * unit1_;
      if (map_.cuts.empty() || place.u - map_.cuts.back().high > resolution) {
        map_.cuts.push_back({place.u, place.u, {}});
      }
      map_.cuts.back().high = place.u;
      map_.cuts.back().runaway = map_.cuts.back().runaway || place.event < 0;
      if (place.event >= 0) {
        map_.cuts.back().events.push_back(place.event);
        map_.cuts.back().crossing = map_.cuts.back().crossing || crossing;
      }
    }
  }

  void add_intervals() {
    const auto add = [&](double low, bool crossing_low, double high, bool crossing_high) {
      map_.intervals.push_back({low, high, low + kOffMiddle * (high - low), crossing_low, crossing_high});
    };
    if (map_.cuts.empty()) {
      add(map_.start, false, map_.end, false);
      return;
    }
    const MapCut& first = map_.cuts.front();
    const MapCut& last = map_.cuts.back();
    if (!map_.cyclic) {
      add(map_.start, false, first.low, first.crossing);
    }
    for (std::size_t i = 0; i + 1 < map_.cuts.size(); ++i) {
      add(map_.cuts[i].high, map_.cuts[i].crossing, map_.cuts[i + 1].low, map_.cuts[i + 1].crossing);
    }
    if (map_.cyclic) {
      add(last.high, last.crossing, first.low + kTurn, first.crossing);
    } else {
      add(last.high, last.crossing, map_.end, false);
    }
  }

  const ContactPair& pair_;
  double unit1_ = 1;
  MapCuts map_;
};

}  // namespace

const MapCut* MapCuts::cut_beside(int interval, bool forward) const {
  if (cuts.empty()) {
    return nullptr;
  }
  const int n = static_cast<int>(cuts.size());
  const int k = cyclic ? (interval + (forward ? 1 : 0)) % n : interval - (forward ? 0 : 1);
  return k >= 0 && k < n ? &cuts[k] : nullptr;
}

MapCuts cuts_of(const ContactPair& pair, const MapRange& range) {
  return CutFinder(pair, range).run();
}

}  // namespace higherpair

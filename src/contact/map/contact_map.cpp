#include "higherpair/contact/contact_map.hpp"

#include "boundary_map.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "map_branches.hpp"
#include "map_network.hpp"
#include "map_points.hpp"

#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// The point between two points of `branch` at which another opposed branch crosses it: there the bodies touch
// twice.
std::optional<MapPoint> crossing(const ContactMap& map, int branch, const MapPoint& from,
                                 const MapPoint& to) {
  for (std::size_t i = 0; i < map.branches.size(); ++i) {
    const int other = static_cast<int>(i);
    if (other == branch || !map.branches[i].opposed) {
      continue;
    }
    const double turn = map.pair.motion1.turns ? kTurn : 0;
    for (const double shift : {0.0, turn, -turn}) {
      const auto distance = [&](double u) {
        const auto mine = point_at(map, branch, u);
        const auto its = point_at(map, other, u + shift);
        return mine && its ? gap_of_q(map, mine->q, its->q) : kNoValue;
      };
      const double a = distance(from.u);
      const double b = distance(to.u);
      // The sign changes also where angles wrap around.
      if (map.pair.motion2.turns && std::abs(a - b) > 3) {
        continue;
      }
      const auto root = [&](double x) { return distance(from.u + x); };
      if (const auto x = root_between(root, a, to.u - from.u, b)) {
        return point_at(map, branch, from.u + *x);
      }
    }
  }
  return std::nullopt;
}

// Where `free` changes between two points, by bisection: as precise as the tolerance of the overlap allows.
std::optional<MapPoint> bisected(const ContactMap& map, int branch, const MapPoint& from,
                                 const MapPoint& to) {
  double low = from.u;
  double high = to.u;
  std::optional<MapPoint> at;
  for (int i = 0; i < 60 && high - low > kBisectedCoordinate * (std::abs(low) + std::abs(high)); ++i) {
    const auto middle = point_at(map, branch, low + (high - low) / 2);
    if (!middle) {
      return at;
    }
    at = middle;
    (middle->free == from.free ? low : high) = middle->u;
  }
  return at;
}

void add_free_changes(ContactMap& map) {
  for (std::size_t b = 0; b < map.branches.size(); ++b) {
    std::vector<MapPoint> changes;
    const std::vector<MapPoint>& points = map.branches[b].points;
    for (std::size_t i = 0; i + 1 < points.size() && !is_stopped(map.range); ++i) {
      if (points[i].free == points[i + 1].free) {
        continue;
      }
      auto at = crossing(map, static_cast<int>(b), points[i], points[i + 1]);
      if (!at) {
        at = bisected(map, static_cast<int>(b), points[i], points[i + 1]);
      }
      if (at) {
        at->free = true;
        changes.push_back(*at);
      }
    }
    map.branches[b].free_changes = std::move(changes);
  }
}

// The map; nothing of it is kept if it was stopped.
ContactMap finished(ContactMap map) {
  if (is_stopped(map.range)) {
    map.status = MapStatus::kStopped;
    map.complete = false;
    map.branches.clear();
    map.events.clear();
  }
  return map;
}

}  // namespace

ContactMap map_contacts(const ContactPair& pair, const MapRange& range) {
  ContactMap map;
  map.pair = pair;
  map.size = size_of_pair(pair);
  map.range = range;
  if (!is_algebraic(pair)) {
    map.status = MapStatus::kNotAlgebraic;
    return map;
  }
  MapNetwork network = build_network(pair, range);
  map.status = network.status;
  if (map.status == MapStatus::kOk) {
    map.branches = branches_of(pair, range, network);
    map.events = std::move(network.events);
    add_free_changes(map);
  }
  map.complete = network.complete;
  return finished(std::move(map));
}

ContactMap map_contacts(const BoundaryPair& pair, const MapRange& range,
                        const std::array<bool, 2>& unbounded) {
  ContactMap map = map_boundaries(pair, range, unbounded);
  if (map.status == MapStatus::kOk) {
    add_free_changes(map);
  }
  return finished(std::move(map));
}

std::string_view name_of(MapEndType type) {
  switch (type) {
    case MapEndType::kFold:
      return "fold";
    case MapEndType::kConforming:
      return "conforming";
    case MapEndType::kInfinity:
      return "infinity";
    case MapEndType::kEnd:
      return "end";
    case MapEndType::kRange:
      return "range";
    case MapEndType::kClosed:
      return "closed";
    case MapEndType::kLost:
      break;
  }
  return "lost";
}

std::string_view describe(MapStatus status) {
  switch (status) {
    case MapStatus::kOk:
      return "every contact is on the map";
    case MapStatus::kNoPair:
      return describe(ContactsStatus::kNoPair);
    case MapStatus::kTouchesEverywhere:
      return describe(ContactsStatus::kTouchesEverywhere);
    case MapStatus::kTouchesNowhere:
      return describe(ContactsStatus::kTouchesNowhere);
    case MapStatus::kTangentAtInfinity:
      return describe(ContactsStatus::kTangentAtInfinity);
    case MapStatus::kNotAlgebraic:
      return "a curve that is given by its support function has no map";
    case MapStatus::kOnlyRelative:
      return "both bodies turn about one pivot, or slide in one direction: only their relative position "
             "counts";
    case MapStatus::kTooManyParts:
      return "the curves have too many parts for a map, more than 10,000 pairs: give each body a curve of "
             "those "
             "alone that may touch, of gears one flank (type = \"involute\", as in the profile "
             "involute_pair)";
    case MapStatus::kStopped:
      return "the map was stopped";
    case MapStatus::kLimitEverywhere:
      break;
  }
  return "the follower is at a limit position whatever the driver's position";
}

}  // namespace higherpair

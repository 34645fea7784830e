#include "higherpair/contact/contact_map.hpp"

#include "boundary_map.hpp"
#include "boundary_trace.hpp"
#include "higherpair/geometry/roots.hpp"
#include "map_branches.hpp"
#include "map_network.hpp"
#include "map_points.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace higherpair {
namespace {

// a - b of two follower coordinates, up to whole turns.
double gap_of_q(const ContactMap& map, double a, double b) {
  return map.pair.motion2.turns ? nearest_turn(a - b, 0) : a - b;
}

// A point of a branch of boundaries. Whether it is free is looked for where the points next to it differ.
std::optional<MapPoint> traced_point(const ContactMap& map, int index,
                                     std::vector<MapPoint>::const_iterator above, double u) {
  const auto i = static_cast<std::size_t>(index);
  const MapBranch& branch = map.branches[i];
  const auto at = map.trace->at(map.trace->paths[i], u);
  if (!at) {
    return std::nullopt;
  }
  MapPoint point;
  static_cast<TangentPosition&>(point) = *at;
  const MapPoint& after = above == branch.points.end() ? branch.points.back() : *above;
  const MapPoint& before = above == branch.points.begin() ? branch.points.front() : *(above - 1);
  point.free = before.free == after.free ? before.free : map.trace->is_free(branch.opposed, *at);
  return point;
}

// The other opposed branch that crosses `branch` between two of its points, and where: there the bodies touch
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
        return mine && its ? gap_of_q(map, mine->q, its->q) : std::numeric_limits<double>::quiet_NaN();
      };
      const double a = distance(from.u);
      const double b = distance(to.u);
      // Where angles go round the sign changes as well.
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

// Whether an end of the branch lies at `from`, or a place where branches cross at it or before `to`.
bool is_singular(const ContactMap& map, const MapBranch& branch, double from, double to) {
  if ((from == branch.begin.u && branch.begin.event >= 0) ||
      (from == branch.end.u && branch.end.event >= 0)) {
    return true;
  }
  return std::any_of(map.events.begin(), map.events.end(), [&](const MapEvent& event) {
    const double u = map.pair.motion1.turns ? nearest_turn(event.at.u, from) : event.at.u;
    const double margin = map.pair.motion1.turns ? kNearMapCrossing : kNearMapCrossing * map.size;
    return event.at.type == CriticalType::kCrossing &&
           (std::abs(u - from) < margin || (u - from) * (u - to) < 0);
  });
}

// Where `free` changes between two points, by bisection: as good as the tolerance of the overlap allows.
std::optional<MapPoint> bisected(const ContactMap& map, int branch, const MapPoint& from,
                                 const MapPoint& to) {
  double low = from.u;
  double high = to.u;
  std::optional<MapPoint> at;
  for (int i = 0; i < 60 && high - low > 1e-13 * (std::abs(low) + std::abs(high)); ++i) {
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

// What is left of a map that was stopped.
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
  map.complete = network.complete;
  if (map.status == MapStatus::kOk) {
    map.branches = branches_of(pair, range, network);
    map.events = std::move(network.events);
    add_free_changes(map);
  }
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

std::optional<MapPoint> point_at(const ContactMap& map, int index, double u) {
  const MapBranch& branch = map.branches[static_cast<std::size_t>(index)];
  if (u < branch.begin.u || u > branch.end.u || branch.points.empty()) {
    return std::nullopt;
  }
  const auto above = std::lower_bound(branch.points.begin(), branch.points.end(), u,
                                      [](const MapPoint& point, double value) { return point.u < value; });
  if (above != branch.points.end() && above->u == u) {
    return *above;
  }
  if (map.trace) {
    return traced_point(map, index, above, u);
  }
  // From a point next to it, the nearest first; not from where the contact is singular, nor past it.
  std::vector<const MapPoint*> starts;
  const auto first = above - std::min<std::ptrdiff_t>(2, above - branch.points.begin());
  const auto last = above + std::min<std::ptrdiff_t>(2, branch.points.end() - above);
  for (auto point = first; point != last; ++point) {
    starts.push_back(&*point);
  }
  std::sort(starts.begin(), starts.end(),
            [&](const MapPoint* a, const MapPoint* b) { return std::abs(a->u - u) < std::abs(b->u - u); });
  for (const MapPoint* start : starts) {
    if (is_singular(map, branch, start->u, u)) {
      continue;
    }
    if (auto point = followed(map.pair, map.range, branch, *start, u)) {
      return point;
    }
  }
  return std::nullopt;
}

std::vector<MapContact> contacts_at(const ContactMap& map, double u) {
  std::vector<MapContact> contacts;
  for (std::size_t i = 0; i < map.branches.size(); ++i) {
    const MapBranch& branch = map.branches[i];
    const bool turns = map.pair.motion1.turns;
    double at = turns ? u + kTurn * std::ceil((branch.begin.u - u) / kTurn) : u;
    do {
      const bool again = branch.turns > 0 && at >= branch.end.u;
      const auto point = again ? std::nullopt : point_at(map, static_cast<int>(i), at);
      if (point) {
        contacts.push_back({static_cast<int>(i), *point});
      }
      at += kTurn;
    } while (turns && at <= branch.end.u);
  }
  return contacts;
}

std::optional<int> branch_of(const ContactMap& map, double u, double q, const Vector2d& n_W) {
  for (const MapContact& contact : contacts_at(map, u)) {
    if (difference_of_q(map.pair, map.size, contact.point.q, q) <= kSameMapContact &&
        (contact.point.n_W - n_W).norm() <= kSameMapContact) {
      return contact.branch;
    }
  }
  return std::nullopt;
}

std::optional<Neighbour> neighbour_at(const ContactMap& map, int branch, double u) {
  const auto own = point_at(map, branch, u);
  std::optional<Neighbour> nearest;
  if (!own) {
    return nearest;
  }
  for (const MapContact& contact : contacts_at(map, u)) {
    const double distance = std::abs(gap_of_q(map, contact.point.q, own->q));
    if (contact.branch != branch && map.branches[static_cast<std::size_t>(contact.branch)].opposed &&
        (!nearest || distance < nearest->distance)) {
      nearest = Neighbour{contact.branch, u, distance};
    }
  }
  return nearest;
}

std::optional<Neighbour> nearest_neighbour(const ContactMap& map, int index) {
  const MapBranch& branch = map.branches[static_cast<std::size_t>(index)];
  for (const MapEnd& end : {branch.begin, branch.end}) {
    if (end.other >= 0) {
      return Neighbour{end.other, end.u, 0};
    }
  }
  std::optional<Neighbour> nearest;
  for (const MapPoint& point : branch.points) {
    if (is_stopped(map.range)) {
      return std::nullopt;
    }
    const auto here = neighbour_at(map, index, point.u);
    if (here && (!nearest || here->distance < nearest->distance)) {
      nearest = here;
    }
  }
  return nearest;
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
  return "the follower stands at a limit position wherever the driver stands";
}

}  // namespace higherpair

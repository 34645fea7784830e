#include "boundary_trace.hpp"
#include "higherpair/contact/contact_map.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "map_network.hpp"
#include "map_points.hpp"

#include <algorithm>
#include <cmath>

// Queries of a finished map.

namespace higherpair {
namespace {

// A point of a branch of boundaries. Whether it is free is worked out only if its neighbours differ in that.
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

// Whether the branch ends at an event at `from`, or branches cross near it or between it and `to`.
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

}  // namespace

std::optional<MapPoint> point_at(const ContactMap& map, int index, double u) {
  const MapBranch& branch = map.branches[index];
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
  // Followed from a neighbouring point, the nearest first; not from a singular contact, nor past one.
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
    if (coordinate_distance(map.pair.motion2, map.size, contact.point.q, q) <= kSameMapContact &&
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
    if (contact.branch != branch && map.branches[contact.branch].opposed &&
        (!nearest || distance < nearest->distance)) {
      nearest = Neighbour{contact.branch, u, distance};
    }
  }
  return nearest;
}

std::optional<Neighbour> nearest_neighbour(const ContactMap& map, int index) {
  const MapBranch& branch = map.branches[index];
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

}  // namespace higherpair

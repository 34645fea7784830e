#include "map_network.hpp"

#include "map_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kResolution = 1e-10;  // of a radian, of the size: cuts nearer than that are one
constexpr double kCrossing = 1e-7;     // the same where branches cross: rounding makes two folds of it
constexpr double kSameContact = 1e-6;
// Where in its interval the list is made: off the middle, which symmetry may make special.
constexpr double kPlace = 0.4713;
// How near to a cut, in radians or sizes, it is looked where a branch ends: nearer until one end is nearest.
constexpr std::array kNearEnd{1e-3, 1e-5, 1e-7, 1e-9, 1e-11};
constexpr double kAtEnd = 0.02;   // from it in q and n: near enough to be sure
constexpr double kSameEnd = 0.3;  // and to be accepted at all
constexpr double kTurn = 2 * kPi;

MapStatus status_of(ContactsStatus status) {
  switch (status) {
    case ContactsStatus::kComplete:
      return MapStatus::kOk;
    case ContactsStatus::kTouchesEverywhere:
      return MapStatus::kTouchesEverywhere;
    case ContactsStatus::kTouchesNowhere:
      return MapStatus::kTouchesNowhere;
    case ContactsStatus::kTangentAtInfinity:
      return MapStatus::kTangentAtInfinity;
    case ContactsStatus::kNoPair:
      break;
  }
  return MapStatus::kNoPair;
}

double size_of(const ContactPair& pair) {
  return (pair.curve1.vertex_B - pair.motion1.p_BO).norm() +
         (pair.curve2.vertex_B - pair.motion2.p_BO).norm() + (pair.motion1.p_WO - pair.motion2.p_WO).norm() +
         std::min(pair.curve1.semi_latus, pair.curve2.semi_latus) + std::numeric_limits<double>::min();
}

// A place at which branches may begin and end.
struct Cut {
  double low = 0, high = 0;  // of the critical positions that it stands for
  std::vector<int> events;
  bool runaway = false;   // contacts may run off to infinity here
  bool crossing = false;  // branches may cross here
};

class NetworkBuilder {
public:
  NetworkBuilder(const ContactPair& pair, const MapRange& range)
      : pair_(pair), other_(with_other_side(pair)) {
    network_.cyclic = pair.motion1.turns;
    network_.start = network_.cyclic ? range.start : std::min(range.start, range.end);
    network_.end = network_.cyclic ? range.start + kTurn : std::max(range.start, range.end);
    network_.size = size_of(pair);
    unit1_ = network_.cyclic ? 1 : network_.size;
  }

  [[nodiscard]] MapNetwork run() {
    network_.status = MapStatus::kOk;
    add_events();
    add_cuts();
    add_intervals();
    for (std::size_t i = 0; i < network_.intervals.size() && network_.status == MapStatus::kOk; ++i) {
      list(static_cast<int>(i));
    }
    if (network_.status != MapStatus::kOk) {
      return network_;
    }
    link();
    find_ends();
    check_events();
    return network_;
  }

private:
  // Into the range; false outside of it.
  [[nodiscard]] bool bring_in(double& u) const {
    if (!network_.cyclic) {
      return u > network_.start && u < network_.end;
    }
    u -= kTurn * std::floor((u - network_.start) / kTurn);
    if (u - network_.start > kTurn - kCrossing) {
      u -= kTurn;  // so that what belongs together stays together
    }
    return true;
  }

  void add_events() {
    CriticalPositions folds = find_folds(pair_);
    if (folds.everywhere) {
      network_.status = MapStatus::kLimitEverywhere;
      return;
    }
    const auto conforming = find_conforming(pair_);
    folds.found.insert(folds.found.end(), conforming.begin(), conforming.end());
    for (CriticalPosition& at : folds.found) {
      const bool known = std::any_of(network_.events.begin(), network_.events.end(),
                                     [&](const MapEvent& event) { return is_same(event.at, at); });
      if (bring_in(at.u) && !known) {
        network_.events.push_back({at, {}});
      }
    }
    std::sort(network_.events.begin(), network_.events.end(),
              [](const MapEvent& a, const MapEvent& b) { return a.at.u < b.at.u; });
  }

  [[nodiscard]] bool is_same(const CriticalPosition& a, CriticalPosition b) const {
    if (!bring_in(b.u)) {
      return false;
    }
    return std::abs(a.u - b.u) <= kResolution * unit1_ && a.opposed == b.opposed &&
           difference_of_q(pair_, network_.size, a.q, b.q) <= kResolution &&
           (a.n_W - b.n_W).norm() <= kSameContact;
  }

  [[nodiscard]] CriticalType type_of(int event) const {
    return network_.events[static_cast<std::size_t>(event)].at.type;
  }

  void add_cuts() {
    struct Place {
      double u;
      int event;
    };
    std::vector<Place> places;
    for (std::size_t i = 0; i < network_.events.size(); ++i) {
      places.push_back({network_.events[i].at.u, static_cast<int>(i)});
    }
    for (double u : runaway_positions(pair_)) {
      if (bring_in(u)) {
        places.push_back({u, -1});
      }
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.u < b.u; });
    for (const Place& place : places) {
      const bool crossing = place.event >= 0 && type_of(place.event) == CriticalType::kCrossing;
      const bool near_crossing = crossing || (!cuts_.empty() && cuts_.back().crossing);
      const double resolution = (near_crossing ? kCrossing : kResolution) * unit1_;
      if (cuts_.empty() || place.u - cuts_.back().high > resolution) {
        cuts_.push_back({place.u, place.u, {}});
      }
      cuts_.back().high = place.u;
      cuts_.back().runaway = cuts_.back().runaway || place.event < 0;
      if (place.event >= 0) {
        cuts_.back().events.push_back(place.event);
        cuts_.back().crossing = cuts_.back().crossing || crossing;
      }
    }
  }

  void add_intervals() {
    const auto add = [&](double low, bool crossing_low, double high, bool crossing_high) {
      network_.intervals.push_back({low, high, low + kPlace * (high - low), crossing_low, crossing_high});
    };
    if (cuts_.empty()) {
      add(network_.start, false, network_.end, false);
      return;
    }
    const Cut& first = cuts_.front();
    const Cut& last = cuts_.back();
    if (!network_.cyclic) {
      add(network_.start, false, first.low, first.crossing);
    }
    for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
      add(cuts_[i].high, cuts_[i].crossing, cuts_[i + 1].low, cuts_[i + 1].crossing);
    }
    if (network_.cyclic) {
      add(last.high, last.crossing, first.low + kTurn, first.crossing);
    } else {
      add(last.high, last.crossing, network_.end, false);
    }
  }

  // The cut at one side of an interval; none at the ends of the range and where there is no cut at all.
  [[nodiscard]] const Cut* cut_beside(int interval, bool forward) const {
    if (cuts_.empty()) {
      return nullptr;
    }
    const int n = static_cast<int>(cuts_.size());
    const int k = network_.cyclic ? (interval + (forward ? 1 : 0)) % n : interval - (forward ? 0 : 1);
    return k >= 0 && k < n ? &cuts_[static_cast<std::size_t>(k)] : nullptr;
  }

  void list(int interval) {
    const double u = network_.intervals[static_cast<std::size_t>(interval)].middle;
    const CurveContacts found = find_curve_contacts(pair_, u);
    network_.status = status_of(found.status);
    for (const CurveContact& contact : found.contacts) {
      if (contact.coincident) {
        continue;
      }
      const ContactPair& pair = contact.opposed ? pair_ : other_;
      const double gap_q = contact.n_W.dot(velocity_per_q(pair.motion2, contact.p_W));
      const int branch = gap_q > 0 ? 1 : -1;
      const ContactResult result = solve_contact(pair, u, contact.q, contact.n_W, branch);
      if (result.status != ContactStatus::kOk) {
        network_.complete = false;
        continue;
      }
      MapNode node;
      node.interval = interval;
      node.opposed = contact.opposed;
      node.track = start_track(pair, result.at, branch);
      network_.nodes.push_back(node);
    }
  }

  // The node of an interval that a followed contact has come to.
  [[nodiscard]] int node_at(int interval, bool opposed, const ContactPosition& at) const {
    for (std::size_t i = 0; i < network_.nodes.size(); ++i) {
      const MapNode& node = network_.nodes[i];
      const ContactPosition& there = node.track.at;
      if (node.interval == interval && node.opposed == opposed &&
          difference_of_q(pair_, network_.size, there.q, at.q) <= kSameContact &&
          (there.n_W - at.n_W).norm() <= kSameContact) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  // The node in the neighbouring interval to which a contact leads.
  [[nodiscard]] NodeSide neighbour(const MapNode& node, bool forward) const {
    NodeSide side;
    const int n = static_cast<int>(network_.intervals.size());
    const int next = node.interval + (forward ? 1 : -1);
    if (!network_.cyclic && (next < 0 || next >= n)) {
      return side;
    }
    const int wrapped = (next + n) % n;
    const double turn = next == wrapped ? 0 : (forward ? kTurn : -kTurn);
    ContactTrack track = node.track;
    const double u = network_.intervals[static_cast<std::size_t>(wrapped)].middle + turn;
    const Cut* cut = cut_beside(node.interval, forward);
    if (!walk_to(track, u, cut != nullptr && cut->crossing)) {
      return side;
    }
    side.node = node_at(wrapped, node.opposed, track.at);
    if (side.node >= 0 && pair_.motion2.turns) {
      const double there = network_.nodes[static_cast<std::size_t>(side.node)].track.at.q;
      side.turn = nearest_turn(0, track.at.q - there);
    }
    return side;
  }

  // Only neighbours that lead to each other are one branch.
  void link() {
    std::vector<NodeSide> forward;
    std::vector<NodeSide> backward;
    for (const MapNode& node : network_.nodes) {
      forward.push_back(neighbour(node, true));
      backward.push_back(neighbour(node, false));
    }
    for (std::size_t i = 0; i < forward.size(); ++i) {
      const int next = forward[i].node;
      if (next >= 0 && backward[static_cast<std::size_t>(next)].node == static_cast<int>(i)) {
        network_.nodes[i].behind = forward[i];
        network_.nodes[static_cast<std::size_t>(next)].before = backward[static_cast<std::size_t>(next)];
      }
    }
  }

  void find_ends() {
    for (MapNode& node : network_.nodes) {
      for (const bool forward : {false, true}) {
        NodeSide& side = forward ? node.behind : node.before;
        if (side.node < 0) {
          find_end(node, forward, side);
        }
      }
    }
  }

  void find_end(const MapNode& node, bool forward, NodeSide& side) {
    const Cut* cut = cut_beside(node.interval, forward);
    if (cut == nullptr) {
      side.type = network_.cyclic ? MapEndType::kLost : MapEndType::kRange;
      side.u = forward ? network_.end : network_.start;
      network_.complete = network_.complete && !network_.cyclic;
      return;
    }
    // The cut as seen from the node, which may be a turn away.
    const double middle = network_.intervals[static_cast<std::size_t>(node.interval)].middle;
    const double u = forward ? cut->low : cut->high;
    const double turn = forward && u < middle ? kTurn : 0;
    side.u = u + turn;
    side.event = event_at(*cut, node, side.u);
    if (side.event >= 0) {
      const CriticalPosition& event = network_.events[static_cast<std::size_t>(side.event)].at;
      side.u = event.u + turn;
      side.type = event.type == CriticalType::kConforming ? MapEndType::kConforming : MapEndType::kFold;
    } else {
      side.type = cut->runaway ? MapEndType::kInfinity : MapEndType::kLost;
      network_.complete = network_.complete && cut->runaway;
    }
  }

  // The event of a cut that a node's contact comes to; -1: none.
  [[nodiscard]] int event_at(const Cut& cut, const MapNode& node, double u) const {
    ContactTrack track = node.track;
    const double way = u - track.at.u;
    int nearest = -1;
    for (const double margin : kNearEnd) {
      const double left = std::min(margin * unit1_, std::abs(way) / 4);
      const bool held = walk_to(track, u - std::copysign(left, way), false);
      double best = INFINITY;
      double second = INFINITY;
      for (const int index : cut.events) {
        const CriticalPosition& event = network_.events[static_cast<std::size_t>(index)].at;
        const double distance =
            difference_of_q(pair_, network_.size, track.at.q, event.q) + (track.at.n_W - event.n_W).norm();
        if (event.opposed != node.opposed || distance >= second) {
          continue;
        }
        second = std::min(best, distance);
        if (distance < best) {
          second = best;
          best = distance;
          nearest = index;
        }
      }
      if (best < kAtEnd && 4 * best < second) {
        return nearest;
      }
      if (!held || margin == kNearEnd.back()) {
        return best < kSameEnd ? nearest : -1;
      }
    }
    return -1;
  }

  // Two branches merge at a fold or cusp, or none that can be told apart; more may meet at a crossing. A fold
  // and a cusp that cannot be told apart have one each.
  void check_events() {
    std::vector<int> ends(network_.events.size(), 0);
    for (const MapNode& node : network_.nodes) {
      for (const NodeSide& side : {node.before, node.behind}) {
        if (side.node < 0 && side.event >= 0) {
          ++ends[static_cast<std::size_t>(side.event)];
        }
      }
    }
    for (const Cut& cut : cuts_) {
      int sum = 0;
      for (const int event : cut.events) {
        const int here = ends[static_cast<std::size_t>(event)];
        sum += here;
        network_.complete = network_.complete && (cut.crossing || here <= 2);
      }
      network_.complete = network_.complete && sum % 2 == 0;
    }
  }

  const ContactPair& pair_;
  ContactPair other_;
  double unit1_ = 1;
  std::vector<Cut> cuts_;
  MapNetwork network_;
};

}  // namespace

double difference_of_q(const ContactPair& pair, double size, double a, double b) {
  return std::abs(pair.motion2.turns ? nearest_turn(a - b, 0) : (a - b) / size);
}

MapNetwork build_network(const ContactPair& pair, const MapRange& range) {
  return NetworkBuilder(pair, range).run();
}

}  // namespace higherpair

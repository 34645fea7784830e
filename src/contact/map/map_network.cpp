#include "map_network.hpp"

#include "contact/touch/inner_step.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

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
    case ContactsStatus::kUndecided:
    case ContactsStatus::kNoPair:
      break;
  }
  return MapStatus::kNoPair;
}

class NetworkBuilder {
public:
  NetworkBuilder(const ContactPair& pair, const MapRange& range)
      : pair_(pair), other_(with_other_side(pair)), range_(range) {
    static_cast<MapCuts&>(network_) = cuts_of(pair, range);
    unit1_ = network_.cyclic ? 1 : network_.size;
  }

  [[nodiscard]] MapNetwork run() {
    for (std::size_t i = 0; i < network_.intervals.size() && network_.status == MapStatus::kOk; ++i) {
      if (is_stopped(range_)) {
        network_.status = MapStatus::kStopped;
        return network_;
      }
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
  void list(int interval) {
    const double u = network_.intervals[interval].middle;
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

  // The node of an interval at which a followed contact has arrived; -1: none.
  [[nodiscard]] int node_at(int interval, bool opposed, const ContactPosition& at) const {
    for (std::size_t i = 0; i < network_.nodes.size(); ++i) {
      const MapNode& node = network_.nodes[i];
      const ContactPosition& there = node.track.at;
      if (node.interval == interval && node.opposed == opposed &&
          coordinate_distance(pair_.motion2, network_.size, there.q, at.q) <= kSameMapContact &&
          (there.n_W - at.n_W).norm() <= kSameMapContact) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  // The node in the neighbouring interval that a contact leads to.
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
    const double u = network_.intervals[wrapped].middle + turn;
    const MapCut* cut = network_.cut_beside(node.interval, forward);
    if (!walk_to(track, u, cut != nullptr && cut->crossing)) {
      return side;
    }
    side.node = node_at(wrapped, node.opposed, track.at);
    if (side.node >= 0 && pair_.motion2.turns) {
      const double there = network_.nodes[side.node].track.at.q;
      side.turn = nearest_turn(0, track.at.q - there);
    }
    return side;
  }

  // Only nodes that lead to each other are on one branch.
  void link() {
    std::vector<NodeSide> forward;
    std::vector<NodeSide> backward;
    for (const MapNode& node : network_.nodes) {
      forward.push_back(neighbour(node, true));
      backward.push_back(neighbour(node, false));
    }
    for (std::size_t i = 0; i < forward.size(); ++i) {
      const int next = forward[i].node;
      if (next >= 0 && backward[next].node == static_cast<int>(i)) {
        network_.nodes[i].behind = forward[i];
        network_.nodes[next].before = backward[next];
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
    const MapCut* cut = network_.cut_beside(node.interval, forward);
    if (cut == nullptr) {
      side.type = network_.cyclic ? MapEndType::kLost : MapEndType::kRange;
      side.u = forward ? network_.end : network_.start;
      network_.complete = network_.complete && !network_.cyclic;
      return;
    }
    // The cut's position next to the node, which may be a turn away.
    const double middle = network_.intervals[node.interval].middle;
    const double u = forward ? cut->low : cut->high;
    const double turn = forward && u < middle ? kTurn : 0;
    side.u = u + turn;
    side.event = event_at(*cut, node, side.u);
    if (side.event >= 0) {
      const CriticalPosition& event = network_.events[side.event].at;
      side.u = event.u + turn;
      side.type = event.type == CriticalType::kConforming ? MapEndType::kConforming : MapEndType::kFold;
    } else {
      side.type = cut->runaway ? MapEndType::kInfinity : MapEndType::kLost;
      network_.complete = network_.complete && cut->runaway;
    }
  }

  // The event of a cut at which a node's contact ends; -1: none.
  [[nodiscard]] int event_at(const MapCut& cut, const MapNode& node, double u) const {
    ContactTrack track = node.track;
    const double du = u - track.at.u;
    int nearest = -1;
    for (const double margin : kNearEnd) {
      const double left = std::min(margin * unit1_, std::abs(du) / 4);
      const bool held = walk_to(track, u - std::copysign(left, du));
      double best = kInf;
      double second = kInf;
      for (const int index : cut.events) {
        const CriticalPosition& event = network_.events[index].at;
        const double distance = coordinate_distance(pair_.motion2, network_.size, track.at.q, event.q) +
                                (track.at.n_W - event.n_W).norm();
        if (event.opposed != node.opposed) {
          continue;
        }
        if (distance < best) {
          second = best;
          best = distance;
          nearest = index;
        } else {
          second = std::min(second, distance);
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

  // Two branches merge at a fold or cusp, or none if they are too close to be resolved; more may meet at a
  // crossing. A fold and a cusp that are too close to be resolved have one branch each.
  void check_events() {
    std::vector<int> ends(network_.events.size(), 0);
    for (const MapNode& node : network_.nodes) {
      for (const NodeSide& side : {node.before, node.behind}) {
        if (side.node < 0 && side.event >= 0) {
          ++ends[side.event];
        }
      }
    }
    for (const MapCut& cut : network_.cuts) {
      int sum = 0;
      for (const int event : cut.events) {
        const int here = ends[event];
        sum += here;
        network_.complete = network_.complete && (cut.crossing || here <= 2);
      }
      network_.complete = network_.complete && sum % 2 == 0;
    }
  }

  const ContactPair& pair_;
  ContactPair other_;
  const MapRange& range_;
  double unit1_ = 1;
  MapNetwork network_;
};

}  // namespace

MapNetwork build_network(const ContactPair& pair, const MapRange& range) {
  return NetworkBuilder(pair, range).run();
}

}  // namespace higherpair

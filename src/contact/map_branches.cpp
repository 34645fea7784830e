#include "map_branches.hpp"

#include "higherpair/contact/events.hpp"
#include "limit.hpp"
#include "map_points.hpp"
#include "map_walk.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace higherpair {
namespace {

constexpr int kFewest = 9;  // points within a branch, however short it is

bool is_finite(MapEndType type) {
  return type == MapEndType::kFold || type == MapEndType::kConforming;
}

// A driver coordinate at which a branch gets a point.
struct Target {
  double u = 0;
  std::optional<std::int64_t> sample;
};

class BranchSampler {
public:
  BranchSampler(const ContactPair& pair, const MapRange& range, MapNetwork& network)
      : pair_(pair), range_(range), network_(network), taken_(network.nodes.size(), false) {
    const double way = network.cyclic ? kTurn : range.end - range.start;
    spacing_ = way / static_cast<double>(range.samples - 1);
  }

  [[nodiscard]] std::vector<MapBranch> run() {
    std::vector<MapBranch> branches;
    const int intervals = static_cast<int>(network_.intervals.size());
    for (const bool closed : {false, true}) {
      for (std::size_t i = 0; i < network_.nodes.size(); ++i) {
        // A closed one from the last interval, which holds the start of the range.
        const bool first = closed ? node(static_cast<int>(i)).interval + 1 == intervals
                                  : node(static_cast<int>(i)).before.node < 0;
        if (!taken_[i] && first) {
          branches.push_back(branch_from(static_cast<int>(i)));
        }
      }
    }
    std::sort(branches.begin(), branches.end(), [](const MapBranch& a, const MapBranch& b) {
      return a.begin.u != b.begin.u ? a.begin.u < b.begin.u : a.points.front().q < b.points.front().q;
    });
    join(branches);
    return branches;
  }

private:
  [[nodiscard]] const MapNode& node(int i) const { return network_.nodes[static_cast<std::size_t>(i)]; }

  // A node on a branch, and the whole turns that make its coordinates continuous along it.
  struct Link {
    int node = 0;
    double u_turn = 0;
    double q_turn = 0;
  };

  // From `first` to the end of its branch, or until it is back; then `first` once more.
  std::vector<Link> chain_from(int first) {
    std::vector<Link> chain{{first, 0, 0}};
    for (;;) {
      const Link at = chain.back();
      taken_[static_cast<std::size_t>(at.node)] = true;
      const NodeSide& side = node(at.node).behind;
      if (side.node < 0) {
        return chain;
      }
      const bool wraps = node(side.node).interval <= node(at.node).interval;
      chain.push_back({side.node, at.u_turn + (wraps ? kTurn : 0), at.q_turn + side.turn});
      if (side.node == first) {
        return chain;
      }
    }
  }

  MapBranch branch_from(int first) {
    MapBranch branch;
    branch.opposed = node(first).opposed;
    std::vector<Link> chain = chain_from(first);
    const Link& last = chain.back();
    if (chain.size() > 1 && last.node == first) {
      branch.turns = static_cast<int>(std::lround(last.u_turn / kTurn));
      branch.begin = {MapEndType::kClosed, range_.start};
      branch.end = {MapEndType::kClosed, range_.start + branch.turns * kTurn};
      // So that the first interval holds the start.
      const MapInterval& interval = interval_of(chain.front());
      shift(chain, interval.low > range_.start ? -kTurn : 0);
    } else {
      const NodeSide& before = node(first).before;
      const NodeSide& behind = node(last.node).behind;
      branch.begin = {before.type, before.u, 0, before.event};
      branch.end = {behind.type, behind.u + last.u_turn, 0, behind.event};
      const double turn = whole_turns(branch);
      branch.begin.u += turn;
      branch.end.u += turn;
      shift(chain, turn);
    }
    sample(branch, chain);
    return branch;
  }

  static void shift(std::vector<Link>& chain, double turn) {
    for (Link& link : chain) {
      link.u_turn += turn;
    }
  }

  // Whole turns of the driver after which a branch holds the start of the range or begins within it.
  [[nodiscard]] double whole_turns(const MapBranch& branch) const {
    if (!network_.cyclic) {
      return 0;
    }
    const double turns = std::ceil((range_.start - branch.begin.u) / kTurn);
    const bool earlier = branch.end.u + (turns - 1) * kTurn >= range_.start;
    return (earlier ? turns - 1 : turns) * kTurn;
  }

  [[nodiscard]] const MapInterval& interval_of(const Link& link) const {
    return network_.intervals[static_cast<std::size_t>(node(link.node).interval)];
  }

  // A sample within the branch, its ends only where they belong to it.
  [[nodiscard]] std::vector<Target> targets_of(const MapBranch& branch) const {
    const double unit = network_.cyclic ? 1 : network_.size;
    const auto margin = [&](const MapEnd& end) {
      const bool included = end.type == MapEndType::kClosed || end.type == MapEndType::kRange;
      return std::min((included ? -kMapEndMargin : kMapEndMargin) * unit,
                      (branch.end.u - branch.begin.u) / 100);
    };
    const double low = branch.begin.u + margin(branch.begin);
    const double high = branch.end.u - margin(branch.end);
    const double a = ((spacing_ > 0 ? low : high) - range_.start) / spacing_;
    const double b = ((spacing_ > 0 ? high : low) - range_.start) / spacing_;
    std::vector<Target> targets;
    const auto last = static_cast<std::int64_t>(std::floor(b));
    for (auto k = static_cast<std::int64_t>(std::ceil(a)); k <= last; ++k) {
      const double u = range_.start + static_cast<double>(k) * spacing_;
      targets.push_back({std::clamp(u, branch.begin.u, branch.end.u), k});
    }
    // A branch between two samples, or hardly more, gets points of its own.
    const bool whole = branch.begin.type == MapEndType::kClosed || branch.begin.type == MapEndType::kRange;
    if (targets.size() < kFewest && !whole) {
      targets.clear();
      for (int i = 1; i < kFewest; ++i) {
        const double share = (1 - std::cos(kPi * i / kFewest)) / 2;
        targets.push_back({low + share * (high - low), std::nullopt});
      }
    }
    std::sort(targets.begin(), targets.end(), [](const Target& l, const Target& r) { return l.u < r.u; });
    return targets;
  }

  // Each interval's targets are reached from its own node; where branches cross at its side, those next to it
  // are interpolated.
  void sample(MapBranch& branch, const std::vector<Link>& chain) {
    const std::vector<Target> targets = targets_of(branch);
    auto next = targets.begin();
    const auto index = [&](auto at) { return static_cast<std::size_t>(at - targets.begin()); };
    std::vector<ContactTrack> tracks;
    std::optional<ContactPosition> before;  // at the end of the last interval
    for (const Link& link : chain) {
      const MapInterval& interval = interval_of(link);
      const double margin = std::min(kNearMapCrossing * (network_.cyclic ? 1 : network_.size),
                                     (interval.high - interval.low) / 8);
      const double low = interval.low + link.u_turn + (interval.crossing_low ? margin : 0);
      const double high = interval.high + link.u_turn - (interval.crossing_high ? margin : 0);
      ContactTrack middle = node(link.node).track;
      middle.at.u += link.u_turn;
      middle.at.q += link.q_turn;
      if (const auto behind = before ? held_at(middle, low) : std::nullopt) {
        for (; next != targets.end() && next->u < low; ++next) {
          add_point(branch, between(branch, *before, *behind, next->u), *next);
        }
      }
      next = std::find_if(next, targets.end(), [&](const Target& target) { return target.u >= low; });
      const bool last = &link == &chain.back();
      const auto stop = std::find_if(next, targets.end(), [&](const Target& target) {
        return last ? target.u > high : target.u >= high;
      });
      reach(branch, middle, std::span(targets).subspan(index(next), index(stop) - index(next)), tracks);
      next = stop;
      before = interval.crossing_high ? held_at(middle, high) : std::nullopt;
    }
    add_extremes(branch, tracks);
    add_ends(branch, node(chain.front().node).track);
    choose_turn(branch);
  }

  static std::optional<ContactPosition> held_at(ContactTrack track, double u) {
    return walk_to(track, u, false) ? std::optional(track.at) : std::nullopt;
  }

  static void add_point(MapBranch& branch, MapPoint point, const Target& target) {
    point.sample = target.sample;
    branch.points.push_back(point);
  }

  // The targets of one interval, from its middle downwards and upwards.
  void reach(MapBranch& branch, const ContactTrack& middle, std::span<const Target> targets,
             std::vector<ContactTrack>& tracks) const {
    const auto split = std::partition_point(targets.begin(), targets.end(),
                                            [&](const Target& t) { return t.u < middle.at.u; });
    std::vector<std::pair<ContactTrack, Target>> found;
    ContactTrack track = middle;
    for (auto target = split; target != targets.begin();) {
      --target;
      if (!walk_to(track, target->u, false)) {
        break;
      }
      found.emplace_back(track, *target);
    }
    std::reverse(found.begin(), found.end());
    track = middle;
    for (auto target = split; target != targets.end(); ++target) {
      if (!walk_to(track, target->u, false)) {
        break;
      }
      found.emplace_back(track, *target);
    }
    for (const auto& [at, target] : found) {
      add_point(branch, point_of(pair_, range_, branch.opposed, at.at), target);
      tracks.push_back(at);
    }
  }

  // By the cubic through two contacts and their slopes.
  [[nodiscard]] MapPoint between(const MapBranch& branch, const ContactPosition& a, const ContactPosition& b,
                                 double u) const {
    const double h = b.u - a.u;
    const double s = (u - a.u) / h;
    const double bend = s * (1 - s) * h;
    ContactPosition at = a;
    at.u = u;
    at.q = a.q + s * s * (3 - 2 * s) * (b.q - a.q) + bend * ((1 - s) * a.dq - s * b.dq);
    const double turned = angle_between(a.n_W, b.n_W);
    const double phi = s * s * (3 - 2 * s) * turned + bend * ((1 - s) * a.dphi - s * b.dphi);
    at.n_W = Rotation<double>::from_angle(phi) * a.n_W;
    const bool placed = place_points(branch.opposed ? pair_ : with_other_side(pair_), at);
    return point_of(pair_, range_, branch.opposed, placed ? at : a);
  }

  void add_extremes(MapBranch& branch, const std::vector<ContactTrack>& tracks) const {
    for (std::size_t i = 0; i + 1 < tracks.size(); ++i) {
      const double fastest = std::max(std::abs(tracks[i].at.dq), std::abs(tracks[i + 1].at.dq));
      const double unit = unit_of(pair_.motion2, tracks[i]) / unit_of(pair_.motion1, tracks[i]);
      // A follower at rest moves by rounding.
      if (tracks[i].at.dq * tracks[i + 1].at.dq < 0 && fastest > kSlowestMotion * unit) {
        const bool smooth = tracks[i].branch == tracks[i + 1].branch;
        if (const auto at = smooth ? stroke_end(tracks[i], tracks[i + 1].at.u) : std::nullopt) {
          branch.extremes.push_back(point_of(pair_, range_, branch.opposed, *at));
        }
      }
    }
  }

  void add_ends(MapBranch& branch, const ContactTrack& middle) const {
    const MapPoint inner = point_of(pair_, range_, branch.opposed, middle.at);
    const MapPoint first = branch.points.empty() ? inner : branch.points.front();
    const MapPoint last = branch.points.empty() ? inner : branch.points.back();
    branch.begin.q = first.q;
    branch.end.q = last.q;
    if (is_finite(branch.begin.type)) {
      branch.points.insert(branch.points.begin(), end_point(branch, branch.begin, first));
      branch.begin.q = branch.points.front().q;
    }
    if (is_finite(branch.end.type)) {
      branch.points.push_back(end_point(branch, branch.end, last));
      branch.end.q = branch.points.back().q;
    }
  }

  // The critical position at an end, continuous with the point next to it.
  [[nodiscard]] MapPoint end_point(const MapBranch& branch, const MapEnd& end, const MapPoint& near) const {
    const CriticalPosition& event = network_.events[static_cast<std::size_t>(end.event)].at;
    ContactPosition at;
    at.u = end.u;
    at.q = pair_.motion2.turns ? nearest_turn(event.q, near.q) : event.q;
    at.n_W = event.n_W;
    const bool placed = place_points(branch.opposed ? pair_ : with_other_side(pair_), at);
    MapPoint point = placed ? point_of(pair_, range_, branch.opposed, at) : near;
    static_cast<TangentPosition&>(point) = {at.u, at.q, event.p_W, event.n_W};
    point.sample.reset();
    return point;
  }

  // q in (-π, π] at the point nearest to the start.
  void choose_turn(MapBranch& branch) const {
    if (!pair_.motion2.turns || branch.points.empty()) {
      return;
    }
    const auto nearest = std::min_element(
        branch.points.begin(), branch.points.end(), [&](const MapPoint& a, const MapPoint& b) {
          return std::abs(a.u - range_.start) < std::abs(b.u - range_.start);
        });
    const double turn = nearest_turn(nearest->q, 0) - nearest->q;
    branch.begin.q += turn;
    branch.end.q += turn;
    for (auto* points : {&branch.points, &branch.extremes}) {
      for (MapPoint& point : *points) {
        point.q += turn;
      }
    }
  }

  void join(std::vector<MapBranch>& branches) const {
    const auto side_of = [](const MapBranch& branch, const MapEnd& end) { return &end == &branch.begin; };
    for (std::size_t i = 0; i < branches.size(); ++i) {
      for (const MapEnd* end : {&branches[i].begin, &branches[i].end}) {
        if (end->event >= 0) {
          network_.events[static_cast<std::size_t>(end->event)].branches.push_back(static_cast<int>(i));
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

  const ContactPair& pair_;
  const MapRange& range_;
  MapNetwork& network_;
  std::vector<bool> taken_;
  double spacing_ = 0;
};

}  // namespace

std::vector<MapBranch> branches_of(const ContactPair& pair, const MapRange& range, MapNetwork& network) {
  return BranchSampler(pair, range, network).run();
}

}  // namespace higherpair

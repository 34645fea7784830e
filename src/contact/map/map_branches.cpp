#include "map_branches.hpp"

#include "contact/touch/inner_step.hpp"
#include "contact/touch/place_points.hpp"
#include "contact/touch/stroke_end.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/hermite.hpp"
#include "map_layout.hpp"
#include "map_points.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

namespace higherpair {
namespace {

bool is_finite(MapEndType type) {
  return type == MapEndType::kFold || type == MapEndType::kConforming;
}

class BranchSampler {
public:
  BranchSampler(const ContactPair& pair, const MapRange& range, MapNetwork& network)
      : pair_(pair), range_(range), network_(network), taken_(network.nodes.size(), false) {}

  [[nodiscard]] std::vector<MapBranch> run() {
    std::vector<MapBranch> branches;
    const int intervals = static_cast<int>(network_.intervals.size());
    for (const bool closed : {false, true}) {
      for (std::size_t i = 0; i < network_.nodes.size() && !is_stopped(range_); ++i) {
        // A closed branch begins in the last interval, which contains the start of the range.
        const bool first = closed ? node(static_cast<int>(i)).interval + 1 == intervals
                                  : node(static_cast<int>(i)).before.node < 0;
        if (!taken_[i] && first) {
          branches.push_back(branch_from(static_cast<int>(i)));
        }
      }
    }
    if (is_stopped(range_)) {
      return {};
    }
    std::sort(branches.begin(), branches.end(), [](const MapBranch& a, const MapBranch& b) {
      return a.begin.u != b.begin.u ? a.begin.u < b.begin.u : a.points.front().q < b.points.front().q;
    });
    join_branches(branches, network_.events);
    return branches;
  }

private:
  [[nodiscard]] const MapNode& node(int i) const { return network_.nodes[i]; }

  // A node on a branch, and the whole turns that make its coordinates continuous along it.
  struct Link {
    int node = 0;
    double u_turn = 0;
    double q_turn = 0;
  };

  // From `first` to the end of its branch; a closed branch ends with `first` once more.
  std::vector<Link> chain_from(int first) {
    std::vector<Link> chain{{first, 0, 0}};
    for (;;) {
      const Link at = chain.back();
      taken_[at.node] = true;
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
      // Shifted so that the first interval contains the start.
      const MapInterval& interval = interval_of(chain.front());
      shift(chain, interval.low > range_.start ? -kTurn : 0);
    } else {
      const NodeSide& before = node(first).before;
      const NodeSide& behind = node(last.node).behind;
      branch.begin = {before.type, before.u, 0, before.event};
      branch.end = {behind.type, behind.u + last.u_turn, 0, behind.event};
      const double turn = network_.cyclic ? turns_into_range(branch, range_.start) : 0;
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

  [[nodiscard]] const MapInterval& interval_of(const Link& link) const {
    return network_.intervals[node(link.node).interval];
  }

  // The targets in each interval are reached from its own node; next to a crossing of branches at its side,
  // they are interpolated.
  void sample(MapBranch& branch, const std::vector<Link>& chain) {
    const std::vector<SampleTarget> targets = sample_targets(branch, range_, network_.cyclic, network_.size);
    auto next = targets.begin();
    const auto index = [&](auto at) { return static_cast<std::size_t>(at - targets.begin()); };
    std::vector<ContactTrack> tracks;
    std::optional<ContactPosition> before;  // at the end of the previous interval
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
      next = std::find_if(next, targets.end(), [&](const SampleTarget& target) { return target.u >= low; });
      const bool last = &link == &chain.back();
      const auto stop = std::find_if(next, targets.end(), [&](const SampleTarget& target) {
        return last ? target.u > high : target.u >= high;
      });
      reach(branch, middle, std::span(targets).subspan(index(next), index(stop) - index(next)), tracks);
      next = stop;
      before = interval.crossing_high && !last ? held_at(middle, high) : std::nullopt;
    }
    add_extremes(branch, tracks);
    add_ends(branch, node(chain.front().node).track);
    if (pair_.motion2.turns && !branch.points.empty()) {
      choose_turn(branch, range_.start);
    }
  }

  // Follows a contact to u; where that fails, points of the map are missing.
  [[nodiscard]] bool reaches(ContactTrack& track, double u) {
    const bool reached = walk_to(track, u);
    network_.complete = network_.complete && reached;
    return reached;
  }

  std::optional<ContactPosition> held_at(ContactTrack track, double u) {
    return reaches(track, u) ? std::optional(track.at) : std::nullopt;
  }

  static void add_point(MapBranch& branch, MapPoint point, const SampleTarget& target) {
    point.sample = target.sample;
    branch.points.push_back(point);
  }

  // The targets of one interval, from its middle downwards and upwards.
  void reach(MapBranch& branch, const ContactTrack& middle, std::span<const SampleTarget> targets,
             std::vector<ContactTrack>& tracks) {
    const auto split = std::partition_point(targets.begin(), targets.end(),
                                            [&](const SampleTarget& t) { return t.u < middle.at.u; });
    std::vector<std::pair<ContactTrack, SampleTarget>> found;
    const auto follow = [&](auto target, auto end) {
      ContactTrack track = middle;
      for (; target != end && !is_stopped(range_) && reaches(track, target->u); ++target) {
        found.emplace_back(track, *target);
      }
    };
    follow(std::make_reverse_iterator(split), targets.rend());
    std::reverse(found.begin(), found.end());
    follow(split, targets.end());
    for (const auto& [at, target] : found) {
      if (is_stopped(range_)) {
        return;
      }
      add_point(branch, point_of(pair_, range_, branch.opposed, at.at), target);
      tracks.push_back(at);
    }
  }

  // By the cubic with the positions and slopes of two contacts.
  [[nodiscard]] MapPoint between(const MapBranch& branch, const ContactPosition& a, const ContactPosition& b,
                                 double u) const {
    const double h = b.u - a.u;
    const double s = (u - a.u) / h;
    ContactPosition at = a;
    at.u = u;
    at.q = a.q + HermiteCubic{0, h * a.dq, b.q - a.q, h * b.dq}(s);
    const HermiteCubic phi{0, h * a.dphi, angle_between(a.n_W, b.n_W), h * b.dphi};
    at.n_W = Rotation<double>::from_angle(phi(s)) * a.n_W;
    const bool placed = place_points(branch.opposed ? pair_ : with_other_side(pair_), at);
    return point_of(pair_, range_, branch.opposed, placed ? at : a);
  }

  void add_extremes(MapBranch& branch, const std::vector<ContactTrack>& tracks) {
    for (std::size_t i = 0; i + 1 < tracks.size(); ++i) {
      const double fastest = std::max(std::abs(tracks[i].at.dq), std::abs(tracks[i + 1].at.dq));
      const double unit = unit_of(pair_.motion2, tracks[i]) / unit_of(pair_.motion1, tracks[i]);
      // Rates of a follower at rest are rounding.
      const bool turns_back = tracks[i].at.dq * tracks[i + 1].at.dq < 0 && fastest > kSlowestMotion * unit;
      if (turns_back && tracks[i].branch == tracks[i + 1].branch) {
        const auto at = stroke_end(tracks[i], tracks[i + 1].at.u);
        network_.complete = network_.complete && at;
        if (at) {
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
    const CriticalPosition& event = network_.events[end.event].at;
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

  const ContactPair& pair_;
  const MapRange& range_;
  MapNetwork& network_;
  std::vector<bool> taken_;
};

}  // namespace

std::vector<MapBranch> branches_of(const ContactPair& pair, const MapRange& range, MapNetwork& network) {
  return BranchSampler(pair, range, network).run();
}

}  // namespace higherpair

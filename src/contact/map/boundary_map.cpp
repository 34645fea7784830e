#include "boundary_map.hpp"

#include "boundary_cuts.hpp"
#include "boundary_trace.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "map_layout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

// Maps of boundaries: the curves of their tangencies, cut into branches and shifted into the range.

namespace higherpair {
namespace {

constexpr std::size_t kMostParts = 10000;  // pairs of spans; two whole gears have more

class BoundaryMapper {
public:
  BoundaryMapper(const BoundaryPair& pair, const MapRange& range, const std::array<bool, 2>& unbounded)
      : range_(range), unbounded_(unbounded), trace_(std::make_shared<BoundaryTrace>(pair)) {
    map_.pair.motion1 = pair.motion1;
    map_.pair.motion2 = pair.motion2;
    map_.range = range;
    map_.size = trace_->sheet(true).size();
    cyclic_ = pair.motion1.turns;
    unit1_ = cyclic_ ? 1 : map_.size;
    unit2_ = pair.motion2.turns ? 1 : map_.size;
  }

  [[nodiscard]] ContactMap run() {
    const TangencySheet& sheet = trace_->sheet(true);
    const BoundaryPair& pair = sheet.pair();
    if (!sheet.is_regular()) {
      return ended(MapStatus::kOnlyRelative);
    }
    if (pair.boundary1->spans().size() * pair.boundary2->spans().size() > kMostParts) {
      return ended(MapStatus::kTooManyParts);
    }
    BoundaryCuts cuts = cut_curves(*trace_, map_.pair, unbounded_, range_);
    if (is_stopped(range_)) {
      return ended(MapStatus::kStopped);
    }
    map_.complete = cuts.complete;
    map_.events = std::move(cuts.events);
    drafts_ = std::move(cuts.drafts);
    if (cuts.idle && drafts_.empty()) {
      return ended(MapStatus::kTouchesNowhere);
    }
    sort_events();
    for (BranchDraft& draft : drafts_) {
      if (is_stopped(range_)) {
        return ended(MapStatus::kStopped);
      }
      finish(draft);
    }
    std::sort(drafts_.begin(), drafts_.end(), [](const BranchDraft& a, const BranchDraft& b) {
      const MapBranch &one = a.branch, &two = b.branch;
      return one.begin.u != two.begin.u ? one.begin.u < two.begin.u
                                        : one.points.front().q < two.points.front().q;
    });
    for (BranchDraft& draft : drafts_) {
      map_.branches.push_back(std::move(draft.branch));
      trace_->paths.push_back(std::move(draft.path));
    }
    join_branches(map_.branches, map_.events);
    map_.trace = trace_;
    return ended(MapStatus::kOk);
  }

private:
  [[nodiscard]] ContactMap ended(MapStatus status) {
    map_.status = status;
    return std::move(map_);
  }

  // Shifts the events into the range and sorts them by rising u.
  void sort_events() {
    std::vector<int> order(map_.events.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      order[i] = static_cast<int>(i);
      double& u = map_.events[i].at.u;
      if (cyclic_) {
        u -= kTurn * std::floor((u - range_.start) / kTurn);
        u -= u - range_.start > kTurn - kAtRangeStart ? kTurn : 0;
      }
      double& q = map_.events[i].at.q;
      q = map_.pair.motion2.turns ? principal_angle(q) : q;
    }
    if (!cyclic_) {
      std::erase_if(order, [&](int i) {
        const double u = map_.events[i].at.u;
        return u <= low() || u >= high();
      });
    }
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return map_.events[a].at.u < map_.events[b].at.u; });
    std::vector<int> place(map_.events.size(), -1);
    std::vector<MapEvent> sorted;
    for (const int i : order) {
      place[i] = static_cast<int>(sorted.size());
      sorted.push_back(map_.events[i]);
    }
    for (BranchDraft& draft : drafts_) {
      for (MapEnd* end : {&draft.branch.begin, &draft.branch.end}) {
        end->event = end->event < 0 ? -1 : place[end->event];
      }
    }
    map_.events = std::move(sorted);
    drop_outside();
  }

  [[nodiscard]] double low() const { return std::min(range_.start, range_.end); }
  [[nodiscard]] double high() const { return std::max(range_.start, range_.end); }

  // Drops branches of no length, and those outside of a sliding driver's range.
  void drop_outside() {
    const auto is_outside = [&](const BranchDraft& draft) {
      const MapBranch& branch = draft.branch;
      return (!cyclic_ && (branch.end.u <= low() || branch.begin.u >= high())) ||
             (branch.end.u == branch.begin.u && branch.begin.type != MapEndType::kClosed);
    };
    std::erase_if(drafts_, is_outside);
  }

  void finish(BranchDraft& draft) {
    MapBranch& branch = draft.branch;
    TracePath& path = draft.path;
    if (!cyclic_) {
      for (MapEnd* end : {&branch.begin, &branch.end}) {
        if (end->u < low() || end->u > high()) {
          end->type = MapEndType::kRange;
          end->u = std::clamp(end->u, low(), high());
        }
      }
    } else if (branch.turns > 0) {
      branch.begin.u = range_.start;
      branch.end.u = range_.start + path.turn_u;
    } else {
      path.shift_u = turns_into_range(branch, range_.start);
      branch.begin.u += path.shift_u;
      branch.end.u += path.shift_u;
    }
    add_points(draft);
    add_extremes(draft);
    if (map_.pair.motion2.turns) {
      path.shift_q += choose_turn(branch, range_.start);
    }
  }

  [[nodiscard]] MapPoint point_of(bool opposed, const SheetPoint& at) const {
    MapPoint point;
    static_cast<TangentPosition&>(point) = at;
    point.free = trace_->is_free(opposed, at);
    return point;
  }

  void add_points(BranchDraft& draft) {
    MapBranch& branch = draft.branch;
    const auto add = [&](double u, std::optional<std::int64_t> sample) {
      if (const auto at = trace_->at(draft.path, u)) {
        branch.points.push_back(point_of(branch.opposed, *at));
        branch.points.back().sample = sample;
      } else {
        map_.complete = false;
      }
    };
    const auto has_point = [](const MapEnd& end) {
      return end.type != MapEndType::kClosed && end.type != MapEndType::kRange;
    };
    if (has_point(branch.begin)) {
      add(branch.begin.u, std::nullopt);
    }
    for (const SampleTarget& target : sample_targets(branch, range_, cyclic_, map_.size)) {
      if (is_stopped(range_)) {
        break;
      }
      add(target.u, target.sample);
    }
    if (has_point(branch.end)) {
      add(branch.end.u, std::nullopt);
    }
    if (branch.points.empty()) {
      const TraceLeg& leg = draft.path.legs.front();
      MapPoint point;
      point.u = leg.u_a + draft.path.shift_u;
      point.q = leg.q_a;
      branch.points.push_back(point);
    }
    branch.begin.q = branch.points.front().q;
    branch.end.q = branch.points.back().q;
  }

  // dq/du = gap_u/gap_q changes its sign: at a zero, or over a dwell.
  void add_extremes(BranchDraft& draft) {
    const TracePath& path = draft.path;
    const double unit = unit2_ / unit1_;
    const auto moves = [&](const SheetPoint& at) {
      return std::abs(at.gap_u) > kSlowestOnBoundaries * unit * std::abs(at.gap_q);
    };
    double before = 0;
    const TraceLeg* resting = nullptr;  // a dwell's last leg since then; an instant of rest does not count
    const TraceLeg* turning = nullptr;
    for (int round = path.turn_u > 0 ? 0 : 1; round < 2; ++round) {
      for (const TraceLeg& leg : path.legs) {
        const auto a = trace_->at(path, leg, leg.share_a);
        const auto b = trace_->at(path, leg, leg.share_b);
        if (!a || !b) {
          continue;
        }
        turning = a->gap_u * b->gap_u <= 0 ? &leg : turning;
        if (!moves(*a) && !moves(*b) && leg.u_b - leg.u_a > kShortestRest * unit1_) {
          resting = &leg;
        }
        if (!moves(*b)) {
          continue;
        }
        if (round == 1 && before * b->gap_u < 0) {
          add_extreme(draft,
                      resting != nullptr   ? *resting
                      : turning != nullptr ? *turning
                                           : leg,
                      resting != nullptr);
        }
        before = b->gap_u;
        resting = turning = nullptr;
      }
    }
    std::sort(draft.branch.extremes.begin(), draft.branch.extremes.end(),
              [](const MapPoint& one, const MapPoint& two) { return one.u < two.u; });
  }

  // Adds the point where the follower turns back on a leg, or the end of a leg along which it rests.
  void add_extreme(BranchDraft& draft, const TraceLeg& leg, bool rests) {
    double share = leg.share_b;
    if (!rests) {
      const auto gap_u = [&](double x) {
        const auto there = trace_->at(draft.path, leg, leg.share_a + x);
        return there ? there->gap_u : kNoValue;
      };
      const double length = leg.share_b - leg.share_a;
      share = leg.share_a + root_between(gap_u, gap_u(0), length, gap_u(length)).value_or(0);
    }
    auto at = trace_->at(draft.path, leg, share);
    if (!at) {
      return;
    }
    if (draft.path.turn_u > 0) {
      const double round = std::ceil((range_.start - kAtRangeStart - at->u) / draft.path.turn_u);
      at->u += round * draft.path.turn_u;
      at->q += round * draft.path.turn_q;
    }
    if (cyclic_ || (at->u >= low() && at->u <= high())) {
      draft.branch.extremes.push_back(point_of(draft.branch.opposed, *at));
    }
  }

  MapRange range_;
  std::array<bool, 2> unbounded_;
  std::shared_ptr<BoundaryTrace> trace_;
  ContactMap map_;
  std::vector<BranchDraft> drafts_;
  bool cyclic_ = true;
  double unit1_ = 1, unit2_ = 1;
};

}  // namespace

ContactMap map_boundaries(const BoundaryPair& pair, const MapRange& range,
                          const std::array<bool, 2>& unbounded) {
  return BoundaryMapper(pair, range, unbounded).run();
}

}  // namespace higherpair

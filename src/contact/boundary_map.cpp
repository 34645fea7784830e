#include "boundary_map.hpp"

#include "boundary_trace.hpp"
#include "higherpair/geometry/roots.hpp"
#include "map_layout.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

// Maps of boundaries: the curves of their tangencies, cut into branches.

namespace higherpair {
namespace {

constexpr double kAtStart = 1e-7;    // [rad]: an event so little below the start of the range belongs to it
constexpr double kNoMotion = 1e-11;  // of the follower's unit for one of the driver: it stands still
constexpr double kRest = 1e-4;       // of the driver's unit: a shorter rest is none
constexpr double kBackwards = 1e-8;  // [rad, of the size]: by which u may fall along a branch, by rounding

int sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

// A part of a step between changes of sign, in the order of its curve.
struct Bit {
  SheetStep step;
  double from = 0, to = 1;  // shares
  SheetPoint at_from, at_to;
  int gap_q = 0, bend = 0;  // signs between them; bend 0: u stands still

  [[nodiscard]] int sense() const { return gap_q * bend; }
};

constexpr std::size_t kMostParts = 10000;  // pairs of spans: of two whole gears there are more

// A branch before its coordinates are brought into the range.
struct Draft {
  MapBranch branch;
  TracePath path;
};

class BoundaryMapper {
public:
  BoundaryMapper(const BoundaryPair& pair, const MapRange& range, const std::array<bool, 2>& unbounded)
      : range_(range), unbounded_(unbounded), trace_(std::make_shared<BoundaryTrace>(pair)) {
    map_.pair.motion1 = pair.motion1;
    map_.pair.motion2 = pair.motion2;
    map_.range = range;
    map_.size = trace_->sheet(true).size();
    too_many_parts_ = pair.boundary1->spans().size() * pair.boundary2->spans().size() > kMostParts;
    cyclic_ = pair.motion1.turns;
    unit1_ = cyclic_ ? 1 : map_.size;
    unit2_ = pair.motion2.turns ? 1 : map_.size;
  }

  [[nodiscard]] ContactMap run() {
    if (!trace_->sheet(true).is_regular()) {
      map_.status = MapStatus::kOnlyRelative;
      return map_;
    }
    if (too_many_parts_) {
      map_.status = MapStatus::kTooManyParts;
      return map_;
    }
    map_.status = MapStatus::kOk;
    for (const bool opposed : {true, false}) {
      const SheetCurves found = sheet_curves(trace_->sheet(opposed), range_);
      map_.complete = map_.complete && found.complete;
      for (const SheetCurve& curve : found.curves) {
        cut(curve, opposed);
      }
    }
    if (is_stopped(range_)) {
      map_.status = MapStatus::kStopped;
      return map_;
    }
    if (idle_ && drafts_.empty()) {
      map_.status = MapStatus::kTouchesNowhere;
      return map_;
    }
    sort_events();
    for (Draft& draft : drafts_) {
      if (is_stopped(range_)) {
        map_.status = MapStatus::kStopped;
        return map_;
      }
      finish(draft);
    }
    std::sort(drafts_.begin(), drafts_.end(), [](const Draft& a, const Draft& b) {
      const MapBranch &one = a.branch, &two = b.branch;
      return one.begin.u != two.begin.u ? one.begin.u < two.begin.u
                                        : one.points.front().q < two.points.front().q;
    });
    for (Draft& draft : drafts_) {
      map_.branches.push_back(std::move(draft.branch));
      trace_->paths.push_back(std::move(draft.path));
    }
    join_branches(map_.branches, map_.events);
    map_.trace = trace_;
    return map_;
  }

private:
  // The bits of a step: between the zeros of ∂gap/∂q and of κ1 + κ2.
  void add_bits(const TangencySheet& sheet, const SheetStep& step, std::vector<Bit>& bits) {
    const auto first = place_on(sheet, step, 0);
    const auto last = place_on(sheet, step, 1);
    if (!first || !last) {
      map_.complete = false;
      return;
    }
    if (step.from1.t == step.to1.t && step.from2.t == step.to2.t) {
      return;
    }
    std::vector<double> shares{0};
    for (double SheetPoint::*of : {&SheetPoint::gap_q, &SheetPoint::bend}) {
      const auto value = [&](double share) {
        const auto place = place_on(sheet, step, share);
        return place ? place->at.*of : NAN;
      };
      if (const double a = first->at.*of, b = last->at.*of; a * b < 0) {
        shares.push_back(root_between(value, a, 1, b).value_or(0));
      }
    }
    shares.push_back(1);
    std::sort(shares.begin(), shares.end());
    for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
      if (shares[i] == shares[i + 1]) {
        continue;
      }
      const auto from = place_on(sheet, step, shares[i]);
      const auto middle = place_on(sheet, step, (shares[i] + shares[i + 1]) / 2);
      const auto to = place_on(sheet, step, shares[i + 1]);
      if (!from || !middle || !to) {
        map_.complete = false;
        continue;
      }
      bits.push_back({step, shares[i], shares[i + 1], from->at, to->at, sign_of(middle->at.gap_q),
                      sign_of(middle->at.bend)});
    }
  }

  void cut(const SheetCurve& curve, bool opposed) {
    const TangencySheet& sheet = trace_->sheet(opposed);
    std::vector<Bit> bits;
    for (const SheetStep& step : curve.steps) {
      if (is_stopped(range_)) {
        return;
      }
      add_bits(sheet, step, bits);
    }
    // Where faces or corners meet u stands still: they belong to no branch.
    std::vector<Bit> moving;
    std::copy_if(bits.begin(), bits.end(), std::back_inserter(moving),
                 [](const Bit& bit) { return bit.sense() != 0; });
    if (moving.empty()) {
      return;
    }
    if (std::all_of(moving.begin(), moving.end(), [&](const Bit& bit) {
          return std::max(std::abs(bit.at_from.gap_q), std::abs(bit.at_to.gap_q)) <= kNoMotion * unit2_;
        })) {
      idle_ = true;
      return;
    }
    if (curve.closed) {
      const auto turn = std::adjacent_find(moving.begin(), moving.end(),
                                           [](const Bit& a, const Bit& b) { return a.sense() != b.sense(); });
      if (turn != moving.end()) {
        std::rotate(moving.begin(), turn + 1, moving.end());
      }
    }
    unwrap(moving);
    std::vector<Draft> drafts = parts_of(moving, opposed);
    set_ends(curve, moving, drafts);
    for (Draft& draft : drafts) {
      drafts_.push_back(std::move(draft));
    }
  }

  // Angles continuous along the curve.
  void unwrap(std::vector<Bit>& bits) const {
    SheetPoint last = bits.front().at_from;
    for (Bit& bit : bits) {
      for (SheetPoint* at : {&bit.at_from, &bit.at_to}) {
        at->u = cyclic_ ? nearest_turn(at->u, last.u) : at->u;
        at->q = map_.pair.motion2.turns ? nearest_turn(at->q, last.q) : at->q;
        last = *at;
      }
    }
  }

  // One draft for each run of bits of one sense, in their order.
  [[nodiscard]] std::vector<Draft> parts_of(const std::vector<Bit>& bits, bool opposed) {
    std::vector<Draft> drafts;
    for (std::size_t i = 0; i < bits.size(); ++i) {
      const Bit& bit = bits[i];
      if (i == 0 || bit.sense() != bits[i - 1].sense()) {
        drafts.emplace_back();
        drafts.back().branch.opposed = opposed;
        drafts.back().path.opposed = opposed;
      }
      const bool rises = bit.at_to.u >= bit.at_from.u;
      drafts.back().path.legs.push_back(
          {bit.step, bit.from, bit.to, bit.at_from.u, bit.at_to.u, bit.at_from.q, bit.at_to.q});
      if (!rises) {
        TraceLeg& leg = drafts.back().path.legs.back();
        std::swap(leg.share_a, leg.share_b);
        std::swap(leg.u_a, leg.u_b);
        std::swap(leg.q_a, leg.q_b);
      }
    }
    return drafts;
  }

  // Orders the legs of the drafts of a curve, and says where and why they begin and end.
  void set_ends(const SheetCurve& curve, const std::vector<Bit>& bits, std::vector<Draft>& drafts) {
    const std::size_t count = drafts.size();
    const bool closed = curve.closed && count == 1;
    std::size_t first = 0;
    const int event_at_begin = curve.closed && count > 1 ? add_event(bits.back(), bits.front(), drafts) : -1;
    int before = event_at_begin;
    for (std::size_t k = 0; k < count; ++k) {
      Draft& draft = drafts[k];
      const std::size_t last = first + draft.path.legs.size() - 1;
      const bool at_last = k + 1 == count;
      const int behind = !at_last ? add_event(bits[last], bits[last + 1], drafts) : event_at_begin;
      MapEnd begin = end_of(before, bits[first].at_from, curve.ends_at_begin);
      MapEnd end = end_of(behind, bits[last].at_to, curve.ends_at_end);
      if (closed) {
        close(draft, bits);
        begin.type = end.type = MapEndType::kClosed;
      }
      if (begin.u > end.u) {
        std::reverse(draft.path.legs.begin(), draft.path.legs.end());
        std::swap(begin, end);
      }
      draft.branch.begin = begin;
      draft.branch.end = end;
      check_order(draft.path);
      before = behind;
      first = last + 1;
    }
  }

  [[nodiscard]] MapEnd end_of(int event, const SheetPoint& at, int boundary) const {
    MapEnd end;
    end.u = at.u;
    end.q = at.q;
    end.event = event;
    if (event >= 0) {
      end.type = map_.events[static_cast<std::size_t>(event)].at.type == CriticalType::kFold
                     ? MapEndType::kFold
                     : MapEndType::kConforming;
    } else if (boundary > 0) {
      end.type =
          unbounded_[static_cast<std::size_t>(boundary - 1)] ? MapEndType::kInfinity : MapEndType::kEnd;
    }
    return end;
  }

  int add_event(const Bit& before, const Bit& behind, const std::vector<Draft>& drafts) {
    MapEvent event;
    static_cast<TangentPosition&>(event.at) = before.at_to;
    event.at.type = before.gap_q != behind.gap_q ? CriticalType::kFold : CriticalType::kConforming;
    event.at.opposed = drafts.front().branch.opposed;
    map_.events.push_back(event);
    return static_cast<int>(map_.events.size()) - 1;
  }

  void close(Draft& draft, const std::vector<Bit>& bits) {
    double turn_u = bits.back().at_to.u - bits.front().at_from.u;
    double turn_q = bits.back().at_to.q - bits.front().at_from.q;
    if (turn_u < 0) {
      turn_u = -turn_u;
      turn_q = -turn_q;
    }
    draft.branch.turns = static_cast<int>(std::lround(turn_u / kTurn));
    draft.path.turn_u = draft.branch.turns * kTurn;
    draft.path.turn_q = map_.pair.motion2.turns ? kTurn * std::round(turn_q / kTurn) : 0;
    map_.complete = map_.complete && draft.branch.turns > 0;
  }

  void check_order(const TracePath& path) {
    for (std::size_t i = 1; i < path.legs.size(); ++i) {
      map_.complete = map_.complete && path.legs[i].u_a >= path.legs[i - 1].u_b - kBackwards * unit1_;
    }
  }

  // By rising u, within the range.
  void sort_events() {
    std::vector<int> order(map_.events.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      order[i] = static_cast<int>(i);
      double& u = map_.events[i].at.u;
      if (cyclic_) {
        u -= kTurn * std::floor((u - range_.start) / kTurn);
        u -= u - range_.start > kTurn - kAtStart ? kTurn : 0;
      }
      double& q = map_.events[i].at.q;
      q = map_.pair.motion2.turns ? nearest_turn(q, 0) : q;
    }
    if (!cyclic_) {
      order.erase(std::remove_if(order.begin(), order.end(),
                                 [&](int i) {
                                   const double u = map_.events[static_cast<std::size_t>(i)].at.u;
                                   return u <= low() || u >= high();
                                 }),
                  order.end());
    }
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      return map_.events[static_cast<std::size_t>(a)].at.u < map_.events[static_cast<std::size_t>(b)].at.u;
    });
    std::vector<int> place(map_.events.size(), -1);
    std::vector<MapEvent> sorted;
    for (const int i : order) {
      place[static_cast<std::size_t>(i)] = static_cast<int>(sorted.size());
      sorted.push_back(map_.events[static_cast<std::size_t>(i)]);
    }
    for (Draft& draft : drafts_) {
      for (MapEnd* end : {&draft.branch.begin, &draft.branch.end}) {
        end->event = end->event < 0 ? -1 : place[static_cast<std::size_t>(end->event)];
      }
    }
    map_.events = std::move(sorted);
    drop_outside();
  }

  [[nodiscard]] double low() const { return std::min(range_.start, range_.end); }
  [[nodiscard]] double high() const { return std::max(range_.start, range_.end); }

  // Of a sliding driver: what lies beside the range.
  void drop_outside() {
    const auto is_outside = [&](const Draft& draft) {
      const MapBranch& branch = draft.branch;
      return (!cyclic_ && (branch.end.u <= low() || branch.begin.u >= high())) ||
             (branch.end.u == branch.begin.u && branch.begin.type != MapEndType::kClosed);
    };
    drafts_.erase(std::remove_if(drafts_.begin(), drafts_.end(), is_outside), drafts_.end());
  }

  void finish(Draft& draft) {
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

  void add_points(Draft& draft) {
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

  // dq/du = gap_u/gap_q changes its sign: at a zero, or over a stretch along which the follower stands still.
  void add_extremes(Draft& draft) {
    const TracePath& path = draft.path;
    const double unit = unit2_ / unit1_;
    const auto moves = [&](const SheetPoint& at) {
      return std::abs(at.gap_u) > kNoMotion * unit * std::abs(at.gap_q);
    };
    double before = 0;
    const TraceLeg* resting = nullptr;  // since then, and no mere touch of rest
    const TraceLeg* turning = nullptr;
    for (int round = path.turn_u > 0 ? 0 : 1; round < 2; ++round) {
      for (const TraceLeg& leg : path.legs) {
        const auto a = trace_->at(path, leg, leg.share_a);
        const auto b = trace_->at(path, leg, leg.share_b);
        if (!a || !b) {
          continue;
        }
        turning = a->gap_u * b->gap_u <= 0 ? &leg : turning;
        if (!moves(*a) && !moves(*b) && leg.u_b - leg.u_a > kRest * unit1_) {
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

  // Where the follower turns back on a leg, or behind one along which it rests.
  void add_extreme(Draft& draft, const TraceLeg& leg, bool rests) {
    double share = leg.share_b;
    if (!rests) {
      const auto gap_u = [&](double x) {
        const auto there = trace_->at(draft.path, leg, leg.share_a + x);
        return there ? there->gap_u : NAN;
      };
      const double way = leg.share_b - leg.share_a;
      share = leg.share_a + root_between(gap_u, gap_u(0), way, gap_u(way)).value_or(0);
    }
    auto at = trace_->at(draft.path, leg, share);
    if (!at) {
      return;
    }
    if (draft.path.turn_u > 0) {
      const double round = std::ceil((range_.start - kAtStart - at->u) / draft.path.turn_u);
      at->u += round * draft.path.turn_u;
      at->q += round * draft.path.turn_q;
    }
    if (cyclic_ || (at->u >= low() && at->u <= high())) {
      draft.branch.extremes.push_back(point_of(draft.branch.opposed, *at));
    }
  }

  MapRange range_;
  std::array<bool, 2> unbounded_;
  bool too_many_parts_ = false;
  std::shared_ptr<BoundaryTrace> trace_;
  ContactMap map_;
  std::vector<Draft> drafts_;
  bool cyclic_ = true;
  bool idle_ = false;  // a curve on which the follower does not move the bodies' distance
  double unit1_ = 1, unit2_ = 1;
};

}  // namespace

ContactMap map_boundaries(const BoundaryPair& pair, const MapRange& range,
                          const std::array<bool, 2>& unbounded) {
  return BoundaryMapper(pair, range, unbounded).run();
}

}  // namespace higherpair

#include "boundary_cuts.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace higherpair {
namespace {

int sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

// A part of a step between changes of sign, in the direction of its curve.
struct MonotonicPart {
  SheetStep step;
  double from = 0, to = 1;  // fractions of the step
  SheetPoint at_from, at_to;
  // Signs between the ends; curvature_sum 0: u does not change.
  int gap_q = 0, curvature_sum = 0;

  [[nodiscard]] int sense() const { return gap_q * curvature_sum; }
};

class CurveCutter {
public:
  CurveCutter(const BoundaryTrace& trace, const ContactPair& motions, const std::array<bool, 2>& unbounded,
              const MapRange& range)
      : trace_(trace),
        motions_(motions),
        unbounded_(unbounded),
        range_(range),
        cyclic_(motions.motion1.turns) {
    const double size = trace.sheet(true).size();
    unit1_ = cyclic_ ? 1 : size;
    slowest_ = kSlowestOnBoundaries * (motions.motion2.turns ? size : 1);
  }

  [[nodiscard]] BoundaryCuts run() {
    for (const bool opposed : {true, false}) {
      const SheetCurves found = sheet_curves(trace_.sheet(opposed), range_);
      cuts_.complete = cuts_.complete && found.complete;
      for (const SheetCurve& curve : found.curves) {
        cut(curve, opposed);
      }
    }
    return std::move(cuts_);
  }

private:
  // Cuts a step into parts at the zeros of ∂gap/∂q and of κ1 + κ2.
  void add_parts(const TangencySheet& sheet, const SheetStep& step, std::vector<MonotonicPart>& parts) {
    const auto first = place_on(sheet, step, 0);
    const auto last = place_on(sheet, step, 1);
    if (!first || !last) {
      cuts_.complete = false;
      return;
    }
    if (step.from1.t == step.to1.t && step.from2.t == step.to2.t) {
      return;
    }
    std::vector<double> shares{0};
    for (double SheetPoint::*of : {&SheetPoint::gap_q, &SheetPoint::curvature_sum}) {
      const auto value = [&](double share) {
        const auto place = place_on(sheet, step, share);
        return place ? place->at.*of : kNoValue;
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
        cuts_.complete = false;
        continue;
      }
      parts.push_back({step, shares[i], shares[i + 1], from->at, to->at, sign_of(middle->at.gap_q),
                       sign_of(middle->at.curvature_sum)});
    }
  }

  void cut(const SheetCurve& curve, bool opposed) {
    const TangencySheet& sheet = trace_.sheet(opposed);
    std::vector<MonotonicPart> parts;
    for (const SheetStep& step : curve.steps) {
      if (is_stopped(range_)) {
        return;
      }
      add_parts(sheet, step, parts);
    }
    // Where two faces or two corners meet, u does not change: such parts belong to no branch.
    std::vector<MonotonicPart> moving;
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(moving),
                 [](const MonotonicPart& part) { return part.sense() != 0; });
    if (moving.empty()) {
      return;
    }
    if (std::all_of(moving.begin(), moving.end(), [&](const MonotonicPart& part) {
          return std::max(std::abs(part.at_from.gap_q), std::abs(part.at_to.gap_q)) <= slowest_;
        })) {
      cuts_.idle = true;
      return;
    }
    if (curve.closed) {
      const auto turn = std::adjacent_find(
          moving.begin(), moving.end(),
          [](const MonotonicPart& a, const MonotonicPart& b) { return a.sense() != b.sense(); });
      if (turn != moving.end()) {
        std::rotate(moving.begin(), turn + 1, moving.end());
      }
    }
    unwrap(moving);
    std::vector<BranchDraft> drafts = parts_of(moving, opposed);
    set_ends(curve, moving, drafts);
    for (BranchDraft& draft : drafts) {
      cuts_.drafts.push_back(std::move(draft));
    }
  }

  // Makes angles continuous along the curve.
  void unwrap(std::vector<MonotonicPart>& parts) const {
    SheetPoint last = parts.front().at_from;
    for (MonotonicPart& part : parts) {
      for (SheetPoint* at : {&part.at_from, &part.at_to}) {
        at->u = cyclic_ ? nearest_turn(at->u, last.u) : at->u;
        at->q = motions_.motion2.turns ? nearest_turn(at->q, last.q) : at->q;
        last = *at;
      }
    }
  }

  // One draft for each run of parts of the same sense, in order.
  [[nodiscard]] std::vector<BranchDraft> parts_of(const std::vector<MonotonicPart>& parts, bool opposed) {
    std::vector<BranchDraft> drafts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const MonotonicPart& part = parts[i];
      if (i == 0 || part.sense() != parts[i - 1].sense()) {
        drafts.emplace_back();
        drafts.back().branch.opposed = opposed;
        drafts.back().path.opposed = opposed;
      }
      const bool rises = part.at_to.u >= part.at_from.u;
      drafts.back().path.legs.push_back(
          {part.step, part.from, part.to, part.at_from.u, part.at_to.u, part.at_from.q, part.at_to.q});
      if (!rises) {
        TraceLeg& leg = drafts.back().path.legs.back();
        std::swap(leg.share_a, leg.share_b);
        std::swap(leg.u_a, leg.u_b);
        std::swap(leg.q_a, leg.q_b);
      }
    }
    return drafts;
  }

  // Orders the legs of the drafts of a curve, and sets where and why they begin and end.
  void set_ends(const SheetCurve& curve, const std::vector<MonotonicPart>& parts,
                std::vector<BranchDraft>& drafts) {
    const std::size_t count = drafts.size();
    const bool opposed = drafts.front().branch.opposed;
    const bool closed = curve.closed && count == 1;
    std::size_t first = 0;
    const int event_at_begin =
        curve.closed && count > 1 ? add_event(parts.back(), parts.front(), opposed) : -1;
    int before = event_at_begin;
    for (std::size_t k = 0; k < count; ++k) {
      BranchDraft& draft = drafts[k];
      const std::size_t last = first + draft.path.legs.size() - 1;
      const bool at_last = k + 1 == count;
      const int behind = !at_last ? add_event(parts[last], parts[last + 1], opposed) : event_at_begin;
      MapEnd begin = end_of(before, parts[first].at_from, curve.ends_at_begin);
      MapEnd end = end_of(behind, parts[last].at_to, curve.ends_at_end);
      if (closed) {
        close(draft, parts);
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
      end.type =
          cuts_.events[event].at.type == CriticalType::kFold ? MapEndType::kFold : MapEndType::kConforming;
    } else if (boundary > 0) {
      end.type = unbounded_[boundary - 1] ? MapEndType::kInfinity : MapEndType::kEnd;
    }
    return end;
  }

  int add_event(const MonotonicPart& before, const MonotonicPart& behind, bool opposed) {
    MapEvent event;
    static_cast<TangentPosition&>(event.at) = before.at_to;
    event.at.type = before.gap_q != behind.gap_q ? CriticalType::kFold : CriticalType::kConforming;
    event.at.opposed = opposed;
    cuts_.events.push_back(event);
    return static_cast<int>(cuts_.events.size()) - 1;
  }

  void close(BranchDraft& draft, const std::vector<MonotonicPart>& parts) {
    double turn_u = parts.back().at_to.u - parts.front().at_from.u;
    double turn_q = parts.back().at_to.q - parts.front().at_from.q;
    if (turn_u < 0) {
      turn_u = -turn_u;
      turn_q = -turn_q;
    }
    draft.branch.turns = static_cast<int>(std::lround(turn_u / kTurn));
    draft.path.turn_u = draft.branch.turns * kTurn;
    draft.path.turn_q = motions_.motion2.turns ? kTurn * std::round(turn_q / kTurn) : 0;
    cuts_.complete = cuts_.complete && draft.branch.turns > 0;
  }

  void check_order(const TracePath& path) {
    for (std::size_t i = 1; i < path.legs.size(); ++i) {
      cuts_.complete = cuts_.complete && path.legs[i].u_a >= path.legs[i - 1].u_b - kBackwards * unit1_;
    }
  }

  const BoundaryTrace& trace_;
  const ContactPair& motions_;
  const std::array<bool, 2>& unbounded_;
  const MapRange& range_;
  bool cyclic_;
  double unit1_ = 1;
  double slowest_ = 0;  // of the gap, per unit of the follower [m/rad, or 1]
  BoundaryCuts cuts_;
};

}  // namespace

BoundaryCuts cut_curves(const BoundaryTrace& trace, const ContactPair& motions,
                        const std::array<bool, 2>& unbounded, const MapRange& range) {
  return CurveCutter(trace, motions, unbounded, range).run();
}

}  // namespace higherpair

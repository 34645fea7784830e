#include "meetings.hpp"

#include "analysis/follow/step.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/numeric/hermite.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "outlines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace higherpair {
namespace {

constexpr int kStepHalvings = 4;      // halvings of a step in which a place could not be followed
constexpr int kHalvingsToTouch = 40;  // the same if the bodies overlap at its end

// A place with its gap and the rate of the gap.
struct Seen {
  NearPlace place;
  double gap = 0;
  double rate = 0;  // per unit of the path
};

double gap_rate(const Pairing& at, const CommonNormal& normal) {
  return normal.n_W.dot(motion_at_place(at.body2, normal.p2_W).v_W -
                        motion_at_place(at.body1, normal.p1_W).v_W);
}

template <class Outlines>
class Search {
public:
  /// \param size  at the contact [m]
  Search(Run& run, const Path& path, std::size_t contact, double s, double size, const Outlines& outlines)
      : run_(run),
        path_(path),
        s_(s),
        contact_(run.mechanism().contacts[contact]),
        index_(contact),
        outlines_(outlines),
        depth_(kOverlapDepth * size) {}

  [[nodiscard]] ContactMeeting all(double h) {
    found_.first = between(pairing(run_.at.state, 0), pairing(run_.work.trial, h), 0);
    aside_.reset();
    return std::move(found_);
  }

private:
  struct Verdict {
    bool followed = true;
    std::optional<Meeting> meeting;
  };

  [[nodiscard]] Pairing pairing(const State& state, double x) const {
    const ContactMotion& motion = state.contacts[index_];
    return {x, state.bodies[contact_.first.body], state.bodies[contact_.second.body],
            motion.touches ? std::optional(motion.at) : std::nullopt};
  }

  [[nodiscard]] std::optional<Pairing> pairing_at(double x) {
    if (!aside_) {
      aside_.emplace(run_.work.trial);
    }
    return solve_at(run_, path_, s_, x) ? std::optional(pairing(run_.work.trial, x)) : std::nullopt;
  }

  // Upper bound of how far any point of the smaller body moves against the other body from a to b.
  [[nodiscard]] double reach_between(const Pairing& a, const Pairing& b) const {
    const double speed = std::max(outlines_.smaller().speed(a), outlines_.smaller().speed(b));
    return kFartherThanByRates * speed * std::abs(b.x - a.x) + 2 * depth_;
  }

  [[nodiscard]] bool is_own(const Pairing& at, const NearPlace& place) const {
    return at.own && is_place_of(*at.own, place, outlines_.size());
  }

  [[nodiscard]] Seen seen(const Pairing& at, const NearPlace& place) const {
    return {place, place.at.gap(), gap_rate(at, place.at)};
  }

  // The same place at another position; none if the gap there does not agree with the rates.
  [[nodiscard]] std::optional<Seen> followed(const Pairing& from, const Seen& place,
                                             const Pairing& to) const {
    const auto moved = outlines_.moved(to, place.place);
    if (!moved || is_own(to, *moved)) {
      return std::nullopt;
    }
    const Seen there = seen(to, *moved);
    const double h = to.x - from.x;
    const double mismatch = std::abs(there.gap - place.gap - h / 2 * (place.rate + there.rate));
    const double change = std::abs(h) * (std::abs(place.rate) + std::abs(there.rate));
    return mismatch <= kGapAgrees * change + depth_ ? std::optional(there) : std::nullopt;
  }

  template <class F>
  [[nodiscard]] std::optional<double> root(const F& of, const Pairing& a, double at_a, double b, double at_b,
                                           const Seen& near) {
    const auto value = [&](double x) {
      const auto at = pairing_at(a.x + x);
      const auto moved = at ? outlines_.moved(*at, near.place) : std::nullopt;
      return moved ? of(seen(*at, *moved)) : kNoValue;
    };
    const auto x = root_between(value, at_a, b - a.x, at_b);
    return x ? std::optional(a.x + *x) : std::nullopt;
  }

  // Where the gap of a place, which is `a` and later `b`, falls to 0.
  [[nodiscard]] Verdict touch(const Pairing& from, const Seen& a, const Pairing& to, const Seen& b) {
    const auto gap = [](const Seen& at) { return at.gap; };
    const auto rate = [](const Seen& at) { return at.rate; };
    const double h = to.x - from.x;
    const auto met = [&](std::optional<double> x, double at) {
      return x ? Verdict{true, Meeting{index_, *x, at, near_at(*x, b.place)}} : Verdict{false, std::nullopt};
    };
    if (contact_.both_sides) {  // a middle line is met from either side
      const bool arrives = std::abs(b.gap) <= depth_;
      if (std::abs(a.gap) <= depth_ || (!arrives && a.gap * b.gap > 0)) {
        return {};
      }
      const auto x = arrives ? std::optional(to.x) : root(gap, from, a.gap, to.x, b.gap, b);
      return met(x, x.value_or(0));
    }
    if (a.gap < -depth_) {
      return {};
    }
    if (b.gap < -depth_) {
      if (a.gap > depth_) {
        const auto x = root(gap, from, a.gap, to.x, b.gap, b);
        return met(x, x.value_or(0));
      }
      if (a.rate * h <= 0) {
        const double before = a.rate == 0 ? 0 : -a.gap / a.rate;
        return met(from.x, from.x + (std::abs(before) <= std::abs(h) ? before : 0));
      }
      const auto top = root(rate, from, a.rate, to.x, b.rate, b);
      const auto highest = top ? pairing_at(*top) : std::nullopt;
      const auto there = highest ? followed(to, b, *highest) : std::nullopt;
      if (!there || there->gap <= 0) {
        return met(from.x, from.x);
      }
      const auto x = root(gap, *highest, there->gap, to.x, b.gap, b);
      return met(x, x.value_or(0));
    }
    if (!(a.rate * h < 0 && b.rate * h > 0)) {
      return {};
    }
    const HermiteCubic dip{a.gap, h * a.rate, b.gap, h * b.rate};
    if (dip(dip.lowest_at()) > kWorthALook * std::min(a.gap, b.gap)) {
      return {};
    }
    const auto bottom = root(rate, from, a.rate, to.x, b.rate, b);
    const auto lowest = bottom ? pairing_at(*bottom) : std::nullopt;
    const auto there = lowest ? outlines_.moved(*lowest, b.place) : std::nullopt;
    if (!there) {
      return {false, std::nullopt};
    }
    return there->at.gap() < -depth_ ? touch(from, a, *lowest, seen(*lowest, *there)) : Verdict{};
  }

  [[nodiscard]] NearPlace near_at(double x, const NearPlace& near) {
    const auto at = pairing_at(x);
    return at ? outlines_.moved(*at, near).value_or(near) : near;
  }

  [[nodiscard]] std::vector<Seen> places_at(const Pairing& at, double reach) const {
    std::vector<Seen> found;
    for (const NearPlace& place : outlines_.near(at, reach)) {
      const bool counts = !contact_.both_sides || place.end == 0;  // the end of a middle line is no wall
      if (counts && !is_own(at, place) && !outlines_.leaves_corners(place)) {
        found.push_back(seen(at, place));
      }
    }
    if (outlines_.overlap_far_out(at)) {
      NearPlace far_end;
      far_end.end = 1;
      found.push_back({far_end, -kInf, 0});
    }
    return found;
  }

  // Whether a gap would fall to 0 within h at its present rate.
  [[nodiscard]] bool may_close(const Seen& place, double h) const {
    const double change = place.rate * h;
    return contact_.both_sides ? std::abs(place.gap) < std::abs(change) : place.gap < -change;
  }

  [[nodiscard]] std::vector<NearPlace> touching(const std::vector<Seen>& places) const {
    std::vector<NearPlace> found;
    for (const Seen& place : places) {
      if (std::abs(place.gap) <= depth_ && is_smooth_touch(place.place)) {
        found.push_back(place.place);
      }
    }
    return found;
  }

  [[nodiscard]] std::optional<Meeting> between(const Pairing& a, const Pairing& b, int halvings) {
    const double reach = reach_between(a, b);
    const double h = b.x - a.x;
    std::optional<Meeting> first;
    bool lost = false;           // a place that may have touched could not be followed
    std::optional<Seen> inside;  // a place that could not be followed and at which the bodies overlap at b
    const auto take = [&](const Verdict& verdict) {
      if (verdict.meeting && (!first || std::abs(verdict.meeting->x) < std::abs(first->x))) {
        first = verdict.meeting;
      }
      lost = lost || !verdict.followed;
    };
    const std::vector<Seen> at_a = places_at(a, reach), at_b = places_at(b, reach);
    if (halvings == 0 && contact_.by_boundary) {
      found_.sharing_before = touching(at_a);
      found_.sharing_after = touching(at_b);
    }
    for (const Seen& place : at_b) {
      if (const auto before = followed(b, place, a)) {
        take(touch(a, *before, b, place));
      } else if (place.gap < -depth_ && !contact_.both_sides) {
        inside = place;
      } else {
        lost = lost || may_close(place, -h);
      }
    }
    for (const Seen& place : at_a) {
      if (const auto after = followed(a, place, b)) {
        take(touch(a, place, b, *after));
      } else {
        lost = lost || (std::abs(place.gap) > depth_ && may_close(place, h));
      }
    }
    const auto found = first || !inside ? first : Meeting{index_, b.x, b.x, inside->place};
    const int most = inside ? kHalvingsToTouch : lost ? kStepHalvings : 0;
    return halvings < most ? split(a, b, halvings + 1, found) : found;
  }

  // The first in both halves; what has been found already if there is no position in the middle.
  [[nodiscard]] std::optional<Meeting> split(const Pairing& a, const Pairing& b, int halvings,
                                             const std::optional<Meeting>& found) {
    const auto middle = pairing_at((a.x + b.x) / 2);
    if (!middle) {
      return found;
    }
    const auto first = between(a, *middle, halvings);
    return first ? first : between(*middle, b, halvings);
  }

  Run& run_;
  const Path& path_;
  double s_;
  const Contact& contact_;
  std::size_t index_;
  const Outlines& outlines_;
  double depth_;  // a smaller depth is a touch
  ContactMeeting found_;
  std::optional<StateAside> aside_;  // set once run.work.trial is used for other positions
};

}  // namespace

double size_at_contact(const Run& run, const State& state, std::size_t contact) {
  const Contact& pair = run.mechanism().contacts[contact];
  const ContactMotion& motion = state.contacts[contact];
  double size = run.plan().size;
  if (motion.touches && !pair.by_boundary) {
    for (const CurveRef& ref : {pair.first, pair.second}) {
      const Vector2d anchor_W = state.bodies[ref.body].X_WB * anchor(curve_of(run.mechanism(), ref));
      size = std::max(size, (motion.at.p_W() - anchor_W).norm());
    }
  }
  return size;
}

bool is_place_of(const CommonNormal& contact, const NearPlace& place, double size) {
  return (contact.p1_W - place.at.p1_W).norm() + (contact.p2_W - place.at.p2_W).norm() <=
             kSameMeeting * size &&
         (contact.n_W - place.at.n_W).norm() <= kSameMeetingNormal;
}

bool is_smooth_touch(const NearPlace& place) {
  return place.end == 0 && place.at.rho1 != 0 && place.at.rho2 != 0;
}

ContactMeeting meeting_within(Run& run, const Path& path, std::size_t contact, double s, double h) {
  const Contact& pair = run.mechanism().contacts[contact];
  const double size = size_at_contact(run, run.at.state, contact);
  if (pair.by_boundary) {
    const BoundaryOutlines outlines(run.mechanism(), pair, run.at.state.contacts[contact]);
    return Search(run, path, contact, s, size, outlines).all(h);
  }
  const CurveOutlines outlines(run.mechanism(), pair, size);
  return Search(run, path, contact, s, size, outlines).all(h);
}

}  // namespace higherpair

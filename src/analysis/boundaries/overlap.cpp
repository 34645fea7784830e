#include "overlap.hpp"

#include "analysis/groups/group_kinds.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "other_place.hpp"
#include "span_ends.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// The equivalent linkage describes one contact. If a body is concave the two may touch a second time, and
// from there on the motion found is wrong: either the motion goes on with the contact that keeps the bodies
// apart, or the rows are marked. For conics the separation is checked after every accepted step
// (contact/separation.hpp); boundaries are searched for meetings before a step is taken (meetings.hpp), since
// a step may lead to a deep overlap.

// Two convex bodies cannot overlap, nor can a body that is everywhere more curved than the ring it is in.
bool may_overlap(const Curve& a, const Curve& b) {
  const Bounds rho_a = radius_bounds(a);
  const Bounds rho_b = radius_bounds(b);
  return (rho_a.low < 0 || rho_b.low < 0) && !(rho_a.high + rho_b.high <= 0);
}

Separation separation_in(const Run& run, const Contact& contact, const State& state) {
  return separation(curve_of(run.mechanism(), contact.first), state.bodies[contact.first.body].X_WB,
                    curve_of(run.mechanism(), contact.second), state.bodies[contact.second.body].X_WB,
                    kOverlapPrecision * run.plan().size);
}

// Depth of the overlap of the two bodies of a contact, at any place [m].
double overlap_in(const Run& run, const Contact& contact, const State& state) {
  if (!contact.by_boundary) {
    return -separation_in(run, contact, state).gap;
  }
  return deepest_penetration(boundary_of(run.mechanism(), contact.first),
                             state.bodies[contact.first.body].X_WB,
                             boundary_of(run.mechanism(), contact.second),
                             state.bodies[contact.second.body].X_WB, kOverlapOfBoundaries * run.plan().size);
}

// Where the gap at the common normal `n_W` closes, between run.at.state and run.work.trial, which is `h`
// beyond it and where the bodies overlap along `n_W`. If the normal cannot be followed back that far, the
// interval is halved until it can.
double closing_between(Run& run, const Path& path, const Contact& contact, double s, double h, Vector2d n_W) {
  constexpr int kMostHalvings = 40;
  const StateAside aside(run.work.trial);
  const auto gap_in = [&](const State& state) {
    ContactMotion at;
    at.at.n_W = n_W;
    return place_contact(run.mechanism(), contact, state.bodies, at) ? at.at.gap() : kNoValue;
  };
  const auto gap = [&](double x) { return solve_at(run, path, s, x) ? gap_in(run.work.trial) : kNoValue; };
  // The bodies may touch already at run.at.state, for instance in a row.
  if (std::abs(gap_in(run.at.state)) <= kOverlapDepth * run.plan().size) {
    return 0;
  }
  double apart = 0, within = h;
  for (int i = 0; i < kMostHalvings; ++i) {
    const double before = gap(apart), after = gap(within);
    if (before * after < 0) {
      const auto from_apart = [&](double x) { return gap(apart + x); };
      if (const auto root = root_between(from_apart, before, within - apart, after)) {
        return apart + *root;
      }
    }
    const double middle = (apart + within) / 2;
    if (!solve_at(run, path, s, middle)) {
      break;
    }
    const Separation here = separation_in(run, contact, run.work.trial);
    const bool overlaps = here.gap < -kOverlapDepth * run.plan().size;
    (overlaps ? within : apart) = middle;
    n_W = overlaps ? here.n_W : n_W;
  }
  return within;
}

// The group of a tracked pair that has this contact, if any.
std::optional<std::size_t> tracked_group(const Run& run, int contact) {
  const auto g = group_with_contact(run.plan(), contact);
  return g && std::holds_alternative<ContactTrack>(run.work.trial.tracks[*g]) ? g : std::nullopt;
}

// The follower's rates with the first and the second contact where the second appears, x beyond run.at.state.
RateJump rates_at(Run& run, const Path& path, std::size_t g, double s, double x, const ContactTrack& next) {
  const auto& tracked = std::get<TrackedPair>(run.plan().groups[g].kind);
  const auto position = [&](const State& state) { return std::get<ContactTrack>(state.tracks[g]).at; };
  RateJump rates{position(run.work.trial).dq, next.at.dq};
  if (const auto at = with_trial<ContactPosition>(run, path, s, x, position)) {
    ContactTrack back = next;
    rates.before = at->dq;
    rates.after = walk_to(back, at->u) ? back.at.dq : next.at.dq;
  }
  path.motions(s, run.work.motions);
  const double u_dot = tracked.driver_sign * run.work.motions[tracked.driver].velocity;
  return {rates.before * u_dot, rates.after * u_dot};
}

// Goes over to the contact that keeps the bodies apart, which appears x beyond run.at.state, and places again
// what depends on the follower.
std::optional<RateJump> jump(Run& run, const Path& path, std::size_t g, double s, double h, double x) {
  const auto& tracked = std::get<TrackedPair>(run.plan().groups[g].kind);
  const auto& track = std::get<ContactTrack>(run.work.trial.tracks[g]);
  const FindResult found = find_nearest_contact(tracked.pair, track.at.u, track.at.q);
  if (found.status != FindStatus::kFound || found.branch == 0) {
    return std::nullopt;
  }
  ContactTrack next = start_track(tracked.pair, found.at, found.branch);
  next.phi = nearest_turn(next.phi, track.phi);
  const RateJump change = rates_at(run, path, g, s, x, next);
  State over = run.work.trial;
  over.tracks[g] = next;
  const bool goes_on = change_trial(run, [&] { return solve_from(run, over, path, s + h, 0); });
  return goes_on ? std::optional(change) : std::nullopt;
}

void report_overlap(Run& run, std::size_t contact, const Path& path, double s) {
  report_contact(run, EventType::kOverlap, path, s, contact,
                 "the two bodies begin to overlap elsewhere on their boundaries");
}

void report_second_contact(Run& run, std::size_t contact, const Path& path, double s,
                           const CarriedBody& follower, const RateJump& change) {
  OverlapWatch& watch = run.at.watches[contact];
  watch.overlaps = false;
  watch.interrupted = true;
  RunEvent& event =
      report_contact(run, EventType::kSecondContact, path, s, contact,
                     "a second contact of the same two bodies appears and the motion goes on with it");
  add_rate_jump(run, path, follower, change, event);
}

}  // namespace

std::vector<OverlapWatch> watched_contacts(const Mechanism& mechanism) {
  std::vector<OverlapWatch> watched;
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    const Contact& contact = mechanism.contacts[i];
    if (contact.by_boundary) {
      const bool convex = boundary_of(mechanism, contact.first).is_convex() &&
                          boundary_of(mechanism, contact.second).is_convex();
      watched.push_back({!convex && !contact.both_sides, false, false});
      continue;
    }
    watched.push_back(
        {may_overlap(curve_of(mechanism, contact.first), curve_of(mechanism, contact.second)), false, false});
  }
  return watched;
}

void renew_overlaps(Run& run) {
  for (std::size_t i = 0; i < run.at.watches.size(); ++i) {
    OverlapWatch& watch = run.at.watches[i];
    watch.overlaps =
        watch.needed && run.at.state.contacts[i].touches &&
        overlap_in(run, run.mechanism().contacts[i], run.at.state) > kOverlapDepth * run.plan().size;
  }
}

bool find_overlaps(Run& run) {
  const double touching = kOverlapDepth * run.plan().size;
  bool changes = false;
  for (std::size_t i = 0; i < run.at.watches.size(); ++i) {
    const OverlapWatch& watch = run.at.watches[i];
    const Contact& contact = run.mechanism().contacts[i];
    StepOverlap& found = run.work.overlaps[i];
    // An open contact is checked while its bodies overlap.
    if (run.work.trial.contacts[i].touches ? !watch.needed : !watch.overlaps) {
      found.overlaps = watch.overlaps;
    } else if (contact.by_boundary) {
      found.overlaps = watch.overlaps && overlap_in(run, contact, run.work.trial) > touching;
    } else {
      const Separation here = separation_in(run, contact, run.work.trial);
      found = {here.gap < -touching, here.n_W};
    }
    changes = changes || found.overlaps != watch.overlaps;
  }
  return changes;
}

std::optional<double> second_contact_within(Run& run, const Path& path, double s, double h) {
  std::optional<double> first;
  for (std::size_t i = 0; i < run.at.watches.size(); ++i) {
    const bool begins = run.work.overlaps[i].overlaps && !run.at.watches[i].overlaps;
    const Contact& contact = run.mechanism().contacts[i];
    if (begins && contact.jump && tracked_group(run, static_cast<int>(i))) {
      const double x = closing_between(run, path, contact, s, h, run.work.overlaps[i].n_W);
      if (!first || std::abs(x) < std::abs(*first)) first = x;
    }
  }
  return first;
}

bool watch_overlaps(Run& run, const Path& path, double s, double h) {
  bool gone_over = false;
  for (std::size_t i = 0; i < run.at.watches.size(); ++i) {
    OverlapWatch& watch = run.at.watches[i];
    const StepOverlap found = run.work.overlaps[i];
    const Contact& contact = run.mechanism().contacts[i];
    const bool begins = found.overlaps && !watch.overlaps;
    watch.overlaps = found.overlaps;
    if (!begins || contact.by_boundary) {
      continue;
    }
    const double x = closing_between(run, path, contact, s, h, found.n_W);
    const auto g = contact.jump ? tracked_group(run, static_cast<int>(i)) : std::nullopt;
    const auto change = g ? jump(run, path, *g, s, h, x) : std::nullopt;
    if (change) {
      const auto& tracked = std::get<TrackedPair>(run.plan().groups[*g].kind);
      report_second_contact(run, i, path, s + x, tracked.follower, *change);
    } else {
      report_overlap(run, i, path, s + x);
    }
    gone_over = gone_over || change.has_value();
  }
  return gone_over;
}

Meetings meetings_elsewhere(Run& run, const Path& path, double s, double h) {
  Meetings all;
  for (std::size_t i = 0; i < run.at.watches.size(); ++i) {
    const OverlapWatch& watch = run.at.watches[i];
    if (!watch.needed || watch.overlaps || !run.mechanism().contacts[i].by_boundary ||
        !run.at.state.contacts[i].touches) {
      continue;
    }
    ContactMeeting found = meeting_within(run, path, i, s, h);
    if (found.first && (!all.first || std::abs(found.first->x) < std::abs(all.first->x))) {
      all.first = found.first;
    }
    if (!found.sharing_before.empty() || !found.sharing_after.empty()) {
      all.sharing.push_back({i, std::move(found.sharing_before), std::move(found.sharing_after)});
    }
  }
  return all;
}

void go_over_to(Run& run, const Path& path, double s, const Meeting& meeting, bool may_go_over) {
  const std::size_t i = meeting.contact;
  const bool at_end = meeting.place.end != 0;
  const auto g = may_go_over && !at_end && run.mechanism().contacts[i].jump
                     ? touching_group(run, static_cast<int>(i))
                     : std::nullopt;
  const auto before = run.at.state.contacts[i].place;
  const auto change = g ? go_on_at(run, path, *g, s, meeting.place) : std::nullopt;
  run.at.watches[i].overlaps = true;
  const double there = s + (meeting.at - meeting.x);
  if (!change) {
    report_overlap(run, i, path, there);
    return;
  }
  const CarriedBody& follower = touching_of(run, *g).follower;
  if (jump_size(run, path, follower, *change) <= kSameRates) {
    report_change_of_place(run, path, s, i);
  } else {
    report_second_contact(run, i, path, there, follower, *change);
  }
  note_edge(run, path, s, i, before);
}

}  // namespace higherpair

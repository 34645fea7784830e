#include "overlap.hpp"

#include "analysis/groups/group_kinds.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "other_place.hpp"
#include "span_ends.hpp"

#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// The equivalent linkage describes one contact. If a body is concave the two may touch a second time, and
// from there on the motion found is wrong: either the motion goes on with the contact that keeps the bodies
// apart, or the rows are marked. A step is searched for meetings (meetings.hpp) before it is taken, since it
// may lead to a deep overlap.

// Two convex bodies cannot overlap, nor can a body that is everywhere more curved than the ring it is in.
bool may_overlap(const Curve& a, const Curve& b) {
  const Bounds rho_a = radius_bounds(a);
  const Bounds rho_b = radius_bounds(b);
  return (rho_a.low < 0 || rho_b.low < 0) && !(rho_a.high + rho_b.high <= 0);
}

// Whether the two bodies of a contact overlap in run.at.state, at any place.
bool bodies_overlap(const Run& run, std::size_t i) {
  const Contact& contact = run.mechanism().contacts[i];
  const State& state = run.at.state;
  const double size = size_at_contact(run, state, i);
  const Pose<double>& X_W1 = state.bodies[contact.first.body].X_WB;
  const Pose<double>& X_W2 = state.bodies[contact.second.body].X_WB;
  const double depth =
      contact.by_boundary
          ? deepest_penetration(boundary_of(run.mechanism(), contact.first), X_W1,
                                boundary_of(run.mechanism(), contact.second), X_W2,
                                kOverlapOfBoundaries * size)
          : -separation(curve_of(run.mechanism(), contact.first), X_W1,
                        curve_of(run.mechanism(), contact.second), X_W2, kOverlapPrecision * size)
                 .gap;
  return depth > kOverlapDepth * size;
}

void report_overlap(Run& run, std::size_t contact, const Path& path, double s) {
  report_contact(run, EventType::kOverlap, path, s, contact,
                 "the two bodies begin to overlap elsewhere on their boundaries");
}

void report_second_contact(Run& run, std::size_t contact, const Path& path, double s,
                           const CarriedBody& follower, const RateJump& change) {
  run.at.watches[contact].interrupt();
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
    watch.overlaps = watch.needed && run.at.state.contacts[i].touches && bodies_overlap(run, i);
  }
}

void end_overlaps(Run& run) {
  for (std::size_t i = 0; i < run.at.watches.size(); ++i) {
    OverlapWatch& watch = run.at.watches[i];
    watch.overlaps = watch.overlaps && bodies_overlap(run, i);
  }
}

Meetings meetings_elsewhere(Run& run, const Path& path, double s, double h) {
  Meetings all;
  for (std::size_t i = 0; i < run.at.watches.size(); ++i) {
    const OverlapWatch& watch = run.at.watches[i];
    if (!watch.needed || watch.overlaps || !run.at.state.contacts[i].touches) {
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
  const Contact& contact = run.mechanism().contacts[i];
  const auto g =
      may_go_over && !at_end && contact.jump ? group_of_placing(run, static_cast<int>(i)) : std::nullopt;
  const auto before = run.at.state.contacts[i].place;
  const auto change = g ? go_on_at(run, path, *g, s, meeting.place) : std::nullopt;
  run.at.watches[i].overlaps = true;
  const double there = s + (meeting.at - meeting.x);
  if (!change) {
    report_overlap(run, i, path, there);
    return;
  }
  const CarriedBody& follower = *placing_contact(run.plan().groups[*g])->follower;
  if (contact.by_boundary && jump_size(run, path, follower, *change) <= kSameRates) {
    report_change_of_place(run, path, s, i);
  } else {
    report_second_contact(run, i, path, there, follower, *change);
  }
  if (contact.by_boundary) {
    note_edge(run, path, s, i, before);
  }
}

}  // namespace higherpair

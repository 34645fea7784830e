#include "flat_contacts.hpp"

#include "analysis/follow/step.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "other_place.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// The end of a flat span ahead of a place.
struct FlatEnd {
  double distance = 0;
  std::optional<BoundaryPlace> behind;  // none if the curve ends there or has a concave corner
};

FlatEnd flat_end(const Boundary& boundary, const BoundaryPlace& from, bool forward) {
  const double distance = distance_along(boundary, from, end_of(boundary, from.span, forward).t);
  const auto end = end_ahead(boundary, from, forward);
  const bool passable = end && !is_flat(boundary, end->behind);
  return {std::abs(distance), passable ? std::optional(end->behind) : std::nullopt};
}

// Where the contact is after the passage.
struct OtherEnd {
  BoundaryPlace own, other;  // places of the passage's boundary and of the other one
  JointPassage rests;        // the joint at which it is, as passed
};

// None where the flat part that ends first does so in an end of the curve or in a notch.
std::optional<OtherEnd> other_end(const Boundary& own, const Boundary& other, const JointPassage& passage,
                                  const BoundaryPlace& from) {
  const bool forward = passage.after.t == range_of(own, passage.after.span).low;
  const FlatEnd end_of_own = flat_end(own, passage.after, forward);
  const FlatEnd end_of_other = flat_end(other, from, !forward);  // t of the two runs in opposite senses
  const bool own_first = !(end_of_other.distance < end_of_own.distance);
  const FlatEnd& first = own_first ? end_of_own : end_of_other;
  if (!first.behind) {
    return std::nullopt;
  }
  const double along = forward ? first.distance : -first.distance;
  OtherEnd end{{}, {}, passage};
  if (own_first) {
    end.own = *first.behind;
    end.other = other.advance(from, -along, 0).place;
    end.rests.before = passage.after;
  } else {
    end.own = own.advance(passage.after, along, 0).place;
    end.other = *first.behind;
    end.rests.side = 1 - passage.side;
    end.rests.before = from;
  }
  return end;
}

// \param over  the state after the passage
void report_passage(Run& run, const Path& path, double s, std::size_t contact, const State& over) {
  RunEvent& event = report_contact(
      run, EventType::kSecondContact, path, s, contact,
      "two flat parts lie on each other and the motion goes on with the contact at the other end");
  if (const auto g = group_of_placing(run, static_cast<int>(contact))) {
    const TouchingBody& touching = touching_of(run, *g);
    add_rate_jump(run, path, touching.follower,
                  {follower_rate(run.at.state, touching.follower), follower_rate(over, touching.follower)},
                  event);
  }
}

}  // namespace

std::optional<JointPassage> go_over_flat(Run& run, const Path& path, double s, const JointPassage& passage) {
  const std::size_t opposite = 1 - passage.side;
  State over = run.at.state;
  ContactMotion& motion = over.contacts[passage.contact];
  const auto end = other_end(boundary_at(run, passage.contact, passage.side),
                             boundary_at(run, passage.contact, opposite), passage, motion.place[opposite]);
  if (!end) {
    return std::nullopt;
  }
  // The normal does not change. The contact is set rather than searched for: rounding would decide at which
  // end a search arrives.
  set_point_of(run, passage.contact, passage.side, end->own, over);
  set_point_of(run, passage.contact, opposite, end->other, over);
  set_rates_on(run, path, s, over);
  report_passage(run, path, s, passage.contact, over);
  run.at.watches[passage.contact].interrupted = true;
  const std::array<BoundaryPlace, 2> before = run.at.state.contacts[passage.contact].place;
  run.at.state = std::move(over);
  note_edge(run, path, s, passage.contact, before);
  return end->rests;
}

}  // namespace higherpair

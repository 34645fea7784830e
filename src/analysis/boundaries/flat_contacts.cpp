#include "flat_contacts.hpp"

#include "analysis/follow/step.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "other_place.hpp"

#include <utility>

namespace higherpair {
namespace {

// The end of the other body's flat span if it comes before that of the own one.
std::optional<SpanEnd> end_of_other(const Boundary& other, const BoundaryPlace& place, bool forward,
                                    double length) {
  const auto end = end_ahead(other, place, forward);
  return end && end->distance < length && !is_flat(other, end->behind) ? end : std::nullopt;
}

}  // namespace

bool lies_flat_behind(const Run& run, const JointPassage& passage) {
  const Boundary& own = boundary_at(run, passage.contact, passage.side);
  const Boundary& other = boundary_at(run, passage.contact, 1 - passage.side);
  return is_flat(own, passage.after) &&
         is_flat(other, run.at.state.contacts[passage.contact].place[1 - passage.side]);
}

std::optional<JointPassage> go_over_flat(Run& run, const Path& path, double s, const JointPassage& passage) {
  const Contact& contact = run.mechanism().contacts[passage.contact];
  const Boundary& own = boundary_at(run, passage.contact, passage.side);
  const Boundary& other = boundary_at(run, passage.contact, 1 - passage.side);
  const bool forward = passage.after.t == range_of(own, passage.after.span).low;
  const auto end_of_own = end_ahead(own, passage.after, forward);
  if (!end_of_own || is_flat(own, end_of_own->behind)) {
    return std::nullopt;
  }
  State over = run.at.state;
  ContactMotion& motion = over.contacts[passage.contact];
  const BoundaryPlace from = motion.place[1 - passage.side];
  JointPassage rests = passage;
  rests.before = passage.after;
  const double length = end_of_own->distance;  // t of the two curves runs in opposite senses
  BoundaryPlace place = end_of_own->behind;
  BoundaryPlace opposite = other.advance(from, forward ? -length : length, 0).place;
  if (const auto end = end_of_other(other, from, !forward, length)) {
    place = own.advance(passage.after, forward ? end->distance : -end->distance, 0).place;
    opposite = end->behind;
    rests.side = 1 - passage.side;
    rests.before = from;
  }
  // The normal does not change. The contact is set rather than searched for: rounding would decide at which
  // end a search arrives.
  const auto set = [&](std::size_t side, const Boundary& boundary, const BoundaryPlace& at) {
    const BodyMotion& body = over.bodies[ref_of(contact, side).body];
    (side == 0 ? motion.at.p1_W : motion.at.p2_W) = body.X_WB * boundary.at(at).p_B;
    JointPassage there = passage;
    there.side = side;
    set_place_of(run, there, at, over);
  };
  set(passage.side, own, place);
  set(1 - passage.side, other, opposite);
  path.motions(s, run.work.motions);
  set_rates(run, run.work.motions, over);
  RunEvent& event = report_contact(
      run, EventType::kSecondContact, path, s, passage.contact,
      "two flat parts lie on each other and the motion goes on with the contact at the other end");
  if (const auto g = group_of_placing(run, static_cast<int>(passage.contact))) {
    const TouchingBody& touching = touching_of(run, *g);
    add_rate_jump(run, path, touching.follower,
                  {follower_rate(run.at.state, touching.follower), follower_rate(over, touching.follower)},
                  event);
  }
  run.at.watches[passage.contact].interrupted = true;
  std::swap(run.at.state, over);
  note_edge(run, path, s, passage.contact, over.contacts[passage.contact].place);
  return rests;
}

}  // namespace higherpair

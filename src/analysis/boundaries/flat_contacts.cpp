#include "flat_contacts.hpp"

#include "analysis/follow/step.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "other_place.hpp"

#include <array>
#include <utility>

namespace higherpair {
namespace {

// The end of the other body's flat span if it comes before that of the own one.
std::optional<SpanEnd> end_of_other(const Boundary& other, const BoundaryPlace& place, bool forward,
                                    double length) {
  const auto end = end_ahead(other, place, forward);
  return end && end->distance < length && !is_flat(other, end->behind) ? end : std::nullopt;
}

// Where the contact is after the passage.
struct OtherEnd {
  BoundaryPlace own, other;  // places of the passage's boundary and of the other one
  JointPassage rests;        // the joint at which it is, as passed
};

// None where the own flat part ends first, in an end of the curve or in a notch.
std::optional<OtherEnd> other_end(const Boundary& own, const Boundary& other, const JointPassage& passage,
                                  const BoundaryPlace& from) {
  const bool forward = passage.after.t == range_of(own, passage.after.span).low;
  const auto end_of_own = end_ahead(own, passage.after, forward);
  if (!end_of_own) {
    return std::nullopt;
  }
  OtherEnd end{end_of_own->behind, {}, passage};
  const double length = end_of_own->distance;  // t of the two curves runs in opposite senses
  if (const auto first = end_of_other(other, from, !forward, length)) {
    end.own = own.advance(passage.after, forward ? first->distance : -first->distance, 0).place;
    end.other = first->behind;
    end.rests.side = 1 - passage.side;
    end.rests.before = from;
  } else if (is_flat(own, end_of_own->behind)) {
    return std::nullopt;
  } else {
    end.other = other.advance(from, forward ? -length : length, 0).place;
    end.rests.before = passage.after;
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
  path.motions(s, run.work.motions);
  set_rates(run, run.work.motions, over);
  report_passage(run, path, s, passage.contact, over);
  run.at.watches[passage.contact].interrupted = true;
  const std::array<BoundaryPlace, 2> before = run.at.state.contacts[passage.contact].place;
  run.at.state = std::move(over);
  note_edge(run, path, s, passage.contact, before);
  return end->rests;
}

}  // namespace higherpair

#include "flat_contacts.hpp"

#include "group_kinds.hpp"
#include "step.hpp"

#include <cmath>

#include <fmt/format.h>

namespace higherpair {
namespace {

bool is_flat(const Boundary& boundary, const BoundaryPlace& place) {
  return !boundary.is_corner(place) && boundary.at(place).kappa == 0;
}

// The body that a contact places.
const TouchingBody* touching_body(const Run& run, std::size_t contact) {
  for (const Group& group : run.plan().groups) {
    const auto* touching = std::get_if<TouchingBody>(&group.kind);
    if (touching != nullptr && touching->contact == static_cast<int>(contact)) {
      return touching;
    }
  }
  return nullptr;
}

// The place behind the flat span that a passage leads onto.
std::optional<BoundaryPlace> place_behind(const Boundary& boundary, const JointPassage& passage) {
  const int span = passage.after.span;
  const Bounds range = boundary.spans()[static_cast<std::size_t>(span)]->range();
  const bool forward = passage.after.t == range.low;
  const int next = boundary.next_span(span, forward);
  const SpanJoint joint = boundary.joint_after(forward ? span : next);
  if (joint == SpanJoint::kEnd || joint == SpanJoint::kNotch) {
    return std::nullopt;
  }
  const Bounds behind = boundary.spans()[static_cast<std::size_t>(next)]->range();
  return BoundaryPlace{next, forward ? behind.low : behind.high};
}

}  // namespace

bool lies_flat_behind(const Run& run, const JointPassage& passage) {
  const Contact& contact = run.mechanism().contacts[passage.contact];
  const Boundary& own = boundary_of(run.mechanism(), ref_of(contact, passage.side));
  const Boundary& other = boundary_of(run.mechanism(), ref_of(contact, 1 - passage.side));
  return is_flat(own, passage.after) &&
         is_flat(other, run.at.state.contacts[passage.contact].place[1 - passage.side]);
}

bool go_over_flat(Run& run, const Path& path, double s, const JointPassage& passage) {
  const Contact& contact = run.mechanism().contacts[passage.contact];
  const Boundary& own = boundary_of(run.mechanism(), ref_of(contact, passage.side));
  const Boundary& other = boundary_of(run.mechanism(), ref_of(contact, 1 - passage.side));
  const auto behind = place_behind(own, passage);
  if (!behind || is_flat(own, *behind)) {
    return false;
  }
  State over = run.at.state;
  ContactMotion& motion = over.contacts[passage.contact];
  // Along t of the other curve, which runs against t of this one.
  const Vector2d along = own.at(*behind).p_B - own.at(passage.before).p_B;
  const double way = along.dot(perp(own.at(passage.after).n_B));
  motion.place[passage.side] = *behind;
  motion.place[1 - passage.side] = other.advance(motion.place[1 - passage.side], -way, 0).place;
  if (!is_flat(other, motion.place[1 - passage.side])) {
    const double phi = motion.phi;
    if (!place_contact(run.mechanism(), contact, over.bodies, motion)) {
      return false;
    }
    motion.phi = nearest_turn(motion.phi, phi);
  } else {
    // The normal stays. No search: rounding would decide to which end it leads.
    const auto point = [&](const Boundary& boundary, std::size_t side) {
      const BodyMotion& body = over.bodies[static_cast<std::size_t>(ref_of(contact, side).body)];
      return Vector2d(body.X_WB * boundary.at(motion.place[side]).p_B);
    };
    (passage.side == 0 ? motion.at.p1_W : motion.at.p2_W) = point(own, passage.side);
    (passage.side == 0 ? motion.at.p2_W : motion.at.p1_W) = point(other, 1 - passage.side);
  }
  set_place_of(run, passage, *behind, over);
  path.motions(s, run.work.motions);
  set_rates(run, run.work.motions, over);
  RunEvent event = event_at(EventType::kSecondContact, path, s, "");
  event.contact = static_cast<int>(passage.contact);
  event.cause = "two flat parts lie on each other and the motion goes on with the contact at the other end";
  if (const TouchingBody* touching = touching_body(run, passage.contact)) {
    event.cause += fmt::format(
        "; the follower's rate for a unit rate of the driver jumps from {:.6g} to {:.6g} (SI units)",
        follower_rate(run.at.state, *touching), follower_rate(over, *touching));
  }
  run.at.watches[passage.contact].jumped = true;
  std::swap(run.at.state, over);
  run.events.push_back(std::move(event));
  return true;
}

}  // namespace higherpair

#include "row_history.hpp"

#include "front/tolerances.hpp"
#include "higherpair/contact/details.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

ContactDetails details_in(const Run& run, const Contact& contact, const ContactMotion& motion) {
  const auto side = [&](const CurveRef& ref) {
    return ContactBody{curve_of(run.mechanism(), ref), run.row.bodies[ref.body]};
  };
  return details_of(side(contact.first), side(contact.second), motion.at, motion.phi);
}

// The motion was lost on the path, or a contact has begun or ceased to touch.
bool interrupts(const RunEvent& event) {
  return loses_motion(event.type) || event.type == EventType::kEngage || event.type == EventType::kRelease;
}

}  // namespace

void RowHistory::note(const Run& run) {
  const auto& contacts = run.mechanism().contacts;
  if (arcs_.size() != contacts.size()) {
    arcs_.assign(contacts.size(), {});
  }
  const bool assembled = run.row.status != RowStatus::kNotAssemblable;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    Arcs& arcs = arcs_[i];
    arcs.broken = arcs.broken || !assembled;
    const ContactMotion& motion = run.row.contacts[i];
    if (!arcs.start && !arcs.broken && motion.touches && run.row.arcs_hold[i]) {
      arcs.start = arc_point(run, i, details_in(run, contacts[i], motion));
    }
  }
}

const ArcPoint* RowHistory::start_of(const Run& run, std::size_t contact) const {
  const Arcs& arcs = arcs_[contact];
  return !arcs.broken && arcs.start && run.row.arcs_hold[contact] ? &*arcs.start : nullptr;
}

bool RowHistory::may_change_by(const Run& run) const {
  const bool open = std::any_of(arcs_.begin(), arcs_.end(), [](const Arcs& arcs) { return !arcs.broken; });
  return open && (!run.at.on_branch || std::any_of(run.events.begin(), run.events.end(), interrupts));
}

bool RowHistory::is_like(const RowHistory& other, double size) const {
  const auto alike = [&](const Arcs& a, const Arcs& b) {
    if (a.broken != b.broken || a.start.has_value() != b.start.has_value()) {
      return false;
    }
    const auto same = [&](std::size_t side) {
      return std::abs(a.start->arcs[side] - b.start->arcs[side]) <= kSameRowArc * size &&
             std::abs(a.start->normal_angle[side] - b.start->normal_angle[side]) <= kSameRowArc &&
             a.start->place[side].span == b.start->place[side].span;
    };
    return a.broken || !a.start || (same(0) && same(1));
  };
  return std::equal(arcs_.begin(), arcs_.end(), other.arcs_.begin(), other.arcs_.end(), alike);
}

}  // namespace higherpair

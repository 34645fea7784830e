#include "row_history.hpp"

#include "higherpair/contact/details.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "tolerances.hpp"

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
  return event.type == EventType::kLimitPosition || event.type == EventType::kEnd ||
         event.type == EventType::kEngage || event.type == EventType::kRelease;
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
    arcs.broken = arcs.broken || !assembled || contacts[i].by_boundary;
    const ContactMotion& motion = run.row.contacts[i];
    if (!arcs.start && !arcs.broken && motion.touches && run.row.arcs_hold[i]) {
      const ContactDetails details = details_in(run, contacts[i], motion);
      arcs.start = {details.side1.arc, details.side2.arc};
    }
  }
}

std::optional<std::array<double, 2>> RowHistory::ways(const Run& run, std::size_t contact,
                                                      const std::array<double, 2>& arcs) const {
  const Arcs& from = arcs_[contact];
  if (from.broken || !from.start || !run.row.arcs_hold[contact]) {
    return std::nullopt;
  }
  return std::array{arcs[0] - (*from.start)[0], arcs[1] - (*from.start)[1]};
}

bool RowHistory::may_change_by(const Run& run) const {
  const bool open = std::any_of(arcs_.begin(), arcs_.end(), [](const Arcs& arcs) { return !arcs.broken; });
  return open && (!run.at.held || std::any_of(run.events.begin(), run.events.end(), interrupts));
}

bool RowHistory::is_like(const RowHistory& other, double size) const {
  const auto alike = [&](const Arcs& a, const Arcs& b) {
    if (a.broken != b.broken || a.start.has_value() != b.start.has_value()) {
      return false;
    }
    return a.broken || !a.start ||
           (std::abs((*a.start)[0] - (*b.start)[0]) <= kSameRowArc * size &&
            std::abs((*a.start)[1] - (*b.start)[1]) <= kSameRowArc * size);
  };
  return std::equal(arcs_.begin(), arcs_.end(), other.arcs_.begin(), other.arcs_.end(), alike);
}

}  // namespace higherpair

#include "contact_arcs.hpp"

#include "higherpair/mechanism/joint_motion.hpp"

namespace higherpair {

ArcPoint arc_point(const Run& run, std::size_t contact, const ContactDetails& details) {
  const Contact& own = run.mechanism().contacts[contact];
  const ContactMotion& motion = run.row.contacts[contact];
  return {{details.side1.arc, details.side2.arc},
          motion.place,
          {motion.phi - run.row.bodies[own.first.body].theta,
           motion.phi + kPi - run.row.bodies[own.second.body].theta}};
}

ContactArcs::ContactArcs(const Mechanism& mechanism, const Contact& contact) {
  if (contact.by_boundary) {
    boundaries_ = {described_curve(mechanism, contact.first).boundary,
                   described_curve(mechanism, contact.second).boundary};
  }
}

std::array<double, 2> ContactArcs::between(const ArcPoint& from, const ArcPoint& to) const {
  if (boundaries_[0] == nullptr) {
    return {to.arcs[0] - from.arcs[0], to.arcs[1] - from.arcs[1]};
  }
  std::call_once(once_, [&] {
    for (const std::size_t side : {0U, 1U}) {
      lengths_[side].emplace(boundaries_[side]);
    }
  });
  const auto arc_on = [&](std::size_t side) {
    return lengths_[side]->at(to.place[side], to.normal_angle[side]) -
           lengths_[side]->at(from.place[side], from.normal_angle[side]);
  };
  return {arc_on(0), -arc_on(1)};  // the tangents of the two bodies are opposed
}

}  // namespace higherpair

#include "higherpair/mechanism/plan_text.hpp"

#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"

#include <fmt/core.h>

namespace higherpair {
namespace {

class Words {
public:
  Words(const Mechanism& mechanism, const Group& group) : mechanism_(mechanism), group_(group) {}

  std::string operator()(const DrivenBody& driven) const {
    return "driven at " + driven_joint(mechanism_, static_cast<std::size_t>(driven.driver)).name;
  }
  std::string operator()(const RrrDyad&) const { return "dyad RRR, two links between pins"; }
  std::string operator()(const RrpDyad& dyad) const {
    return dyad.slider ? "dyad RRP, a link from a pin to a slider"
                       : "dyad RRP, a link from a pin whose other end runs in a slot";
  }
  std::string operator()(const RprDyad& dyad) const {
    return dyad.slider ? "dyad RPR, a pinned guide with a pinned slider"
                       : "dyad RPR, a pinned link whose slot runs over a pin";
  }
  std::string operator()(const SlideDyad& dyad) const {
    return dyad.pin ? "dyad RPP, a pinned body that slides on a sliding one"
                    : "dyad PRP, two sliders with a pin between them";
  }
  std::string operator()(const TrackedPair& tracked) const {
    return fmt::format("follower, touches {} at {}, by osculating circles",
                       other_body(tracked.contact, tracked.follower.body), contact_name(tracked.contact));
  }
  std::string operator()(const TouchingBody& touching) const {
    const bool along = mechanism_.contacts[touching.contact].by_boundary;
    return fmt::format("touches {} at {}, by {}", other_body(touching.contact, touching.follower.body),
                       contact_name(touching.contact),
                       along ? "Newton's method along both curves" : "osculating circles");
  }
  std::string operator()(const IdleBody&) const {
    return "idle on its pin: nothing sets its turning, it keeps the angle of its pose";
  }
  std::string operator()(const GearedBody& geared) const {
    return "on its pin, turned by " + mechanism_.joints[geared.gears].name;
  }
  std::string operator()(const CoupledBodies&) const {
    std::string text = "coupled bodies, solved together by Newton's method";
    for (const int contact : group_.contacts) {
      text += ", touching at " + contact_name(contact);
    }
    return text;
  }

private:
  [[nodiscard]] const std::string& contact_name(int contact) const {
    return mechanism_.contacts[contact].name;
  }
  [[nodiscard]] const std::string& other_body(int index, int body) const {
    return mechanism_.bodies[end_off(mechanism_.contacts[index], body).body].name;
  }

  const Mechanism& mechanism_;
  const Group& group_;
};

}  // namespace

std::string describe(const Mechanism& mechanism, const Group& group) {
  return names_of(mechanism.bodies, group.bodies) + ": " + std::visit(Words(mechanism, group), group.kind);
}

}  // namespace higherpair

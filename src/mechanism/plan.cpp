#include "higherpair/mechanism/plan.hpp"

#include "higherpair/mechanism/analyse_mobility.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "higherpair/mechanism/redimension.hpp"
#include "higherpair/numeric/contains.hpp"
#include "idle_turning.hpp"
#include "recognise.hpp"
#include "structural_conditions.hpp"
#include "structure.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>

#include <fmt/core.h>

namespace higherpair {
namespace {

std::string names_of(const Mechanism& mechanism, const std::vector<LooseBody>& loose) {
  std::string names;
  for (const LooseBody& body : loose) {
    names += (names.empty() ? "" : ", ") + mechanism.bodies[body.body].name +
             (body.turning_only ? " (its turning)" : "");
  }
  return names;
}

// Explains why too few coordinates are determined. The rank explains more than the matching: which joints
// could be driven, and what the count misses.
std::string too_loose(const Mechanism& mechanism, const std::vector<LooseBody>& loose) {
  const Mobility mobility = analyse_mobility(mechanism);
  if (const auto objection = driver_objection(mechanism, mobility)) {
    return *objection;
  }
  const auto drivers = mechanism.drivers.size();
  return "the mechanism has more freedom than drivers: by the count " + formula_text(mobility.count) +
         ", drivers " + std::to_string(drivers) + "; not placed: " + names_of(mechanism, loose) +
         "; add a driver, joint or contact that sets " + (loose.size() == 1 ? "it" : "them");
}

// Sets what depends on the dimensions, but for the size: the groups, one for each set.
void fill_in(Plan& plan, const Mechanism& mechanism, const std::vector<BodySet>& sets) {
  for (const BodySet& set : sets) {
    plan.groups.push_back(recognise(mechanism, set, plan.groups));
  }
  plan.couples = std::any_of(plan.groups.begin(), plan.groups.end(),
                             [](const Group& group) { return traits_of(group).coupled; });
  for (Group& group : plan.groups) {
    std::copy_if(group.joints.begin(), group.joints.end(), std::back_inserter(group.ended_joints),
                 [&](int index) {
                   const Joint& joint = mechanism.joints[index];
                   return joint.from || joint.to;
                 });
  }
}

// A contact that may part needs a joint that holds its body while it is open.
std::optional<std::string> cannot_part(const Mechanism& mechanism, const Plan& plan) {
  for (const Group& group : plan.groups) {
    for (const int index : group.contacts) {
      const Contact& contact = mechanism.contacts[index];
      if (contact.keep == Keep::kGap && !std::holds_alternative<TouchingBody>(group.kind)) {
        return fmt::format(
            "contacts.{}: with keep = \"gap\" one of the two bodies must be on a revolute or prismatic "
            "joint, which holds it while they are apart, and be moved by this contact alone",
            contact.name);
      }
    }
  }
  return std::nullopt;
}

std::vector<int> common(const std::vector<int>& some, const std::vector<int>& others) {
  std::vector<int> both;
  std::copy_if(some.begin(), some.end(), std::back_inserter(both),
               [&](int one) { return contains(others, one); });
  return both;
}

}  // namespace

tl::expected<Plan, std::string> make_plan(const Mechanism& mechanism) {
  const Structure structure = analyse_structure(mechanism);
  Plan plan;
  plan.size = size_of(mechanism);
  std::vector<LooseBody> missing;
  for (const LooseBody& loose : structure.loose) {
    if (loose.turning_only && turns_idly({mechanism, plan.size}, loose.body)) {
      plan.idle_bodies.push_back(loose.body);
    } else {
      missing.push_back(loose);
    }
  }
  if (!missing.empty()) {
    return tl::unexpected(too_loose(mechanism, missing));
  }
  plan.surplus = structure.surplus;
  plan.coincidences = coincidences_of(mechanism);
  plan.phase_bodies = phase_bodies(mechanism);
  fill_in(plan, mechanism, structure.sets);
  if (auto objection = cannot_part(mechanism, plan)) {
    return tl::unexpected(*std::move(objection));
  }
  return plan;
}

CarriedBody carried_body(const Mechanism& mechanism, const Joint& joint, int body) {
  const bool carrier_first = joint.second.body == body;
  CarriedBody carried;
  carried.body = body;
  carried.carrier = end_off(joint, body).body;
  OneFreedom& freedom = carried.freedom;
  freedom.turns = joint.type == JointType::kRevolute;
  freedom.p_WO = point_of(mechanism, end_off(joint, body));
  freedom.p_BO = point_on(mechanism, joint, body);
  if (freedom.turns) {
    carried.sign = carrier_first ? 1 : -1;
    return carried;
  }
  freedom.theta = carrier_first ? joint.relative_angle : -joint.relative_angle;
  freedom.R_WB = Rotation<double>::from_angle(freedom.theta);
  // The line belongs to the joint's first body; if that one is carried, the carrier's point moves along it
  // the opposite way.
  freedom.direction_W = carrier_first ? joint.direction_A : Vector2d(-(freedom.R_WB * joint.direction_A));
  return carried;
}

// If a body is on several joints to ground, like a valve in two guides, it moves alike on each.
std::optional<OneFreedom> grounded_freedom(const Mechanism& mechanism, int body) {
  const auto joint = std::find_if(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& each) {
    return is_grounded(each) && joins(each, kGround, body);
  });
  if (joint == mechanism.joints.end()) {
    return std::nullopt;
  }
  OneFreedom freedom = carried_body(mechanism, *joint, body).freedom;
  if (joint->first.body == body) {
    freedom.direction_W = -freedom.direction_W;
  }
  return freedom;
}

std::vector<int> idle_bodies_of(const Plan& plan, const Group& group) {
  return common(plan.idle_bodies, group.bodies);
}

std::vector<int> phase_bodies_of(const Plan& plan, const Group& group) {
  return common(plan.phase_bodies, group.bodies);
}

std::optional<std::size_t> group_with_contact(const Plan& plan, int contact) {
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    const std::vector<int>& contacts = plan.groups[g].contacts;
    if (contains(contacts, contact)) {
      return g;
    }
  }
  return std::nullopt;
}

bool can_be_redimensioned(const Plan& plan, const Mechanism& mechanism) {
  return plan.coincidences == coincidences_of(mechanism);
}

Plan redimensioned(const Plan& plan, const Mechanism& mechanism) {
  Plan other;
  other.idle_bodies = plan.idle_bodies;
  other.phase_bodies = plan.phase_bodies;
  other.surplus = plan.surplus;
  other.coincidences = plan.coincidences;
  other.size = size_of(mechanism);
  fill_in(other, mechanism, {plan.groups.begin(), plan.groups.end()});
  return other;
}

tl::expected<Plan, std::string> plan_like(const Plan& plan, const Mechanism& mechanism) {
  return can_be_redimensioned(plan, mechanism) ? redimensioned(plan, mechanism) : make_plan(mechanism);
}

void redimension_groups(Plan& plan, const Mechanism& mechanism) {
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    Group& group = plan.groups[g];
    group.kind = kind_of(mechanism, group, std::span(plan.groups).first(g));
  }
}

}  // namespace higherpair

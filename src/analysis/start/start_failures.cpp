#include "start_failures.hpp"

#include "analysis/follow/joint_ends.hpp"
#include "analysis/follow/step.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "higherpair/analysis/branch_run.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "higherpair/mechanism/plan_text.hpp"

#include <cmath>
#include <vector>

#include <fmt/core.h>

namespace higherpair {

std::string why_no_contact(FindStatus status, const Contact& contact) {
  const std::string name = "contacts." + contact.name + ": ";
  switch (status) {
    case FindStatus::kOverlapAtStart:
      return name +
             "the two bodies overlap at the first driver position with the follower in its pose; move the "
             "pose away from the driver, or use approach = \"nearest\"";
    case FindStatus::kUnbounded:
      return name + "neither body is bounded, so that no safe step towards the contact exists";
    case FindStatus::kNoContact:
    case FindStatus::kFound:
      break;
  }
  return name +
         (contact.approach == Approach::kNearest
              ? "the two bodies do not touch, or only where they overlap as well, whatever the follower's "
                "position, at the first driver position; change that position or the pose of the follower"
              : "the two bodies do not touch at the first driver position, however far the follower is "
                "moved that way from its pose; change its approach or pose, or that position");
}

std::string why_unplaced(const Run& run, const State& state, std::size_t g) {
  const Group& group = run.plan().groups[g];
  // Links that cannot reach each other have not been placed where their joints would be.
  const bool reaches = closure_gap(group, state.bodies).value_or(0) <= 0;
  const auto end = reaches ? joint_beyond_end(model_of(run), g, state) : std::nullopt;
  if (end) {
    return fmt::format(
        "joint {} would be beyond the end of its line, `{}`, at the first driver position; change "
        "that position, the dimensions or that end",
        run.mechanism().joints[end->joint].name, end->upper ? "to" : "from");
  }
  if (const auto* dyad = std::get_if<RrrDyad>(&group.kind)) {
    const double distance = (place_of(state, dyad->A) - place_of(state, dyad->B)).norm();
    const double reach = dyad->length_a + dyad->length_b;
    const bool far = distance > reach;
    const double limit = far ? reach : std::abs(dyad->length_a - dyad->length_b);
    return fmt::format(
        "bodies {} cannot be put together at the first driver position: their outer pins are {:.6g} times as "
        "far apart as the two links {}; change that position or the lengths",
        names_of(run.mechanism().bodies, group.bodies), distance / limit,
        far ? "reach together" : "differ in length");
  }
  const std::vector<int> phased = phase_bodies_of(run.plan(), group);
  const int surplus = run.plan().surplus;
  const std::string too_many =
      surplus == 0
          ? ""
          : fmt::format(
                "; joints, contacts and drivers make {} condition{} more than the bodies can meet, unless "
                "the dimensions are special: one of them may be too many (`higherpair mobility` counts)",
                surplus, surplus == 1 ? "" : "s");
  return fmt::format(
      "bodies {} cannot be put together at the first driver position near their poses, or branches cross "
      "there{}; give them the poses they have there (others may lead elsewhere), or change that position "
      "or the dimensions{}",
      names_of(run.mechanism().bodies, group.bodies),
      phased.empty() ? ""
                     : fmt::format(" ({}, turned by rolling alone, with the angle of the pose)",
                                   names_of(run.mechanism().bodies, phased)),
      too_many);
}

}  // namespace higherpair

#include "other_place.hpp"

#include "analysis/follow/step.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "analysis/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {

double jump_size(const Run& run, const Path& path, const CarriedBody& follower, const RateJump& jump) {
  return std::abs(jump.after - jump.before) * unit_of(run, path) /
         (follower.freedom.turns ? 1 : run.plan().size);
}

void add_rate_jump(const Run& run, const Path& path, const CarriedBody& follower, const RateJump& jump,
                   RunEvent& event) {
  if (jump_size(run, path, follower, jump) <= kNoJump) {
    event.cause += ", without a jump of velocity";
    return;
  }
  set_jump(event, path,
           {.of = "the rate of " + run.mechanism().bodies[follower.body].name,
            .turns = follower.freedom.turns,
            .before = jump.before,
            .after = jump.after});
}

std::optional<std::size_t> touching_group(const Run& run, int contact) {
  const auto g = group_with_contact(run.plan(), contact);
  const bool touching = g && std::holds_alternative<TouchingBody>(run.plan().groups[*g].kind) &&
                        run.mechanism().contacts[contact].by_boundary;
  return touching ? g : std::nullopt;
}

std::optional<RateJump> go_on_at(Run& run, const Path& path, std::size_t g, double s,
                                 const NearPlace& place) {
  const TouchingBody& touching = touching_of(run, g);
  const auto i = static_cast<std::size_t>(touching.contact);
  State over = run.at.state;
  ContactMotion& motion = over.contacts[i];
  const double phi = motion.phi;
  motion.place = {place.place1, place.place2};
  motion.at = place.at;
  // Just before the bodies reach a place that begins at a corner there is no common normal yet.
  (void)place_contact(run.mechanism(), run.mechanism().contacts[i], over.bodies, motion);
  motion.phi = nearest_turn(angle_of(motion.at.n_W), phi);
  const int mode = touching_sine(model_of(run), touching, over) < 0 ? -1 : 1;
  if (mode != over.groups[g].mode) {
    return std::nullopt;
  }
  const double before = follower_rate(run.at.state, touching);
  if (!settle(run, path, s, over)) {
    return std::nullopt;
  }
  return RateJump{before, follower_rate(run.at.state, touching)};
}

}  // namespace higherpair

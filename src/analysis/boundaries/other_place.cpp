#include "other_place.hpp"

#include "analysis/follow/step.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/mechanism/group_traits.hpp"

#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// Puts a contact on another place at which the bodies touch; false where they are on different sides of the
// two places.
bool put_on(const Run& run, const TouchingBody& touching, std::size_t g, const NearPlace& place,
            State& state) {
  const auto i = static_cast<std::size_t>(touching.contact);
  ContactMotion& motion = state.contacts[i];
  const double phi = motion.phi;
  motion.place = {place.place1, place.place2};
  motion.at = place.at;
  // Just before the bodies reach a place that begins at a corner there is no common normal yet.
  (void)place_contact(run.mechanism(), run.mechanism().contacts[i], state.bodies, motion);
  motion.phi = nearest_turn(angle_of(motion.at.n_W), phi);
  const int mode = touching_sine(model_of(run), touching, state) < 0 ? -1 : 1;
  return mode == state.groups[g].mode;
}

bool put_on(const TrackedPair& tracked, std::size_t g, const NearPlace& place, State& state) {
  auto& track = std::get<ContactTrack>(state.tracks[g]);
  const Vector2d n_W = (tracked.driver_is_first ? 1 : -1) * place.at.n_W;
  const ContactResult found = solve_contact(tracked.pair, track.at.u, track.at.q, n_W, track.branch);
  if (found.status != ContactStatus::kOk) {
    return false;
  }
  const double phi = track.phi;
  track = start_track(tracked.pair, found.at, track.branch);
  track.phi = nearest_turn(track.phi, phi);
  return true;
}

}  // namespace

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

std::optional<std::size_t> group_of_placing(const Run& run, int contact) {
  const auto g = group_with_contact(run.plan(), contact);
  if (!g || !placing_contact(run.plan().groups[*g])) {
    return std::nullopt;
  }
  const bool places = std::holds_alternative<TouchingBody>(run.plan().groups[*g].kind) ||
                      std::holds_alternative<ContactTrack>(run.at.state.tracks[*g]);
  return places ? g : std::nullopt;
}

std::optional<RateJump> go_on_at(Run& run, const Path& path, std::size_t g, double s,
                                 const NearPlace& place) {
  const Group& group = run.plan().groups[g];
  const auto* touching = std::get_if<TouchingBody>(&group.kind);
  State over = run.at.state;
  if (!(touching != nullptr ? put_on(run, *touching, g, place, over)
                            : put_on(std::get<TrackedPair>(group.kind), g, place, over))) {
    return std::nullopt;
  }
  const CarriedBody& follower = *placing_contact(group)->follower;
  const double before = follower_rate(run.at.state, follower);
  if (!settle(run, path, s, over)) {
    return std::nullopt;
  }
  return RateJump{before, follower_rate(run.at.state, follower)};
}

}  // namespace higherpair

#pragma once

#include "analysis/follow/path_events.hpp"
#include "higherpair/contact/near_places.hpp"

#include <optional>

// Continues the contact of two bodies at another place of them.

namespace higherpair {

/// Jump of a follower's rate, per unit of the path.
struct RateJump {
  double before = 0;
  double after = 0;
};

/// Adds to an event on the path that the follower's rate jumps, or that it does not.
void add_rate_jump(const Run& run, const Path& path, const CarriedBody& follower, const RateJump& jump,
                   RunEvent& event);

/// The difference of the rates for one unit of the drivers; that of a sliding follower as a fraction of the
/// size.
[[nodiscard]] double jump_size(const Run& run, const Path& path, const CarriedBody& follower,
                               const RateJump& jump);

/// The group whose body is placed by this contact, if it is one that may go on at another place: not if it
/// rolls, or dwells.
[[nodiscard]] std::optional<std::size_t> group_of_placing(const Run& run, int contact);

/// \pre the group is a TouchingBody
[[nodiscard]] inline const TouchingBody& touching_of(const Run& run, std::size_t g) {
  return std::get<TouchingBody>(run.plan().groups[g].kind);
}

/// Continues run.at.state, which is at s, with the contact that places the body of group g at another place
/// where the two bodies touch too. Returns none and changes nothing if the bodies are on different sides at
/// the two places: neither contact could then be kept.
[[nodiscard]] std::optional<RateJump> go_on_at(Run& run, const Path& path, std::size_t g, double s,
                                               const NearPlace& place);

}  // namespace higherpair

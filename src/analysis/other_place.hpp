#pragma once

#include "higherpair/contact/near_places.hpp"
#include "straight_path.hpp"

#include <optional>
#include <string>

// A contact of boundaries that goes on at another place of its two bodies.

namespace higherpair {

/// How the rate of a follower jumps, for a unit rate of the driver.
struct RateJump {
  double before = 0;
  double after = 0;
};

/// "from ... to ... (SI units)"; what is rounding beside the other is 0.
[[nodiscard]] std::string from_to_text(double before, double after);

/// ", without a jump of velocity", or from what to what.
[[nodiscard]] std::string rate_jump_text(const Run& run, const TouchingBody& touching, const RateJump& jump);

/// By how much the rates differ, of a sliding follower as a share of the size.
[[nodiscard]] double jump_size(const Run& run, const TouchingBody& touching, const RateJump& jump);

/// The group of a contact by_boundary that a body is placed by.
[[nodiscard]] std::optional<std::size_t> touching_group(const Run& run, int contact);

/// Lets run.at.state, which is at s, go on with the contact of group g at another place, where the two
/// bodies touch too. None, and nothing done, where the bodies are on different sides at the two places:
/// neither could be kept.
[[nodiscard]] std::optional<RateJump> go_on_at(Run& run, const Path& path, std::size_t g, double s,
                                               const NearPlace& place);

}  // namespace higherpair

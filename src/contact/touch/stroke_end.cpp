#include "stroke_end.hpp"

#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <cmath>

namespace higherpair {

std::optional<ContactPosition> stroke_end(const ContactTrack& start, double u) {
  ContactTrack track = start;
  const double h = u - start.at.u;
  const auto rate_at = [&](double x) { return walk_to(track, start.at.u + x) ? track.at.dq : kNoValue; };
  const auto x = root_between(rate_at, start.at.dq, h, rate_at(h));
  return x && std::isfinite(rate_at(*x)) ? std::optional(track.at) : std::nullopt;
}

}  // namespace higherpair

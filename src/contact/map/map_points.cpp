#include "map_points.hpp"

#include "contact/touch/inner_step.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/contact/tolerances.hpp"

#include <cmath>

namespace higherpair {
namespace {

// Whether the interiors of the bodies are disjoint; those of two convex bodies are separated by the common
// tangent.
bool is_free(const ContactPair& pair, bool opposed, const ContactPosition& at, double tolerance) {
  if (!opposed) {
    return false;
  }
  if (const auto always = always_free(pair.curve1, pair.curve2)) {
    return *always;
  }
  const double radii = std::abs(at.rho1) + std::abs(at.rho2);
  // One is convex, the other concave: κ1 + κ2 >= 0 iff (ρ1 + ρ2) ρ1 ρ2 >= 0.
  if ((at.rho1 + at.rho2) * at.rho1 * at.rho2 < -kFineGap * radii * radii * radii) {
    return false;
  }
  const Separation apart = separation(pair.curve1, pose_at(pair.motion1, at.u), pair.curve2,
                                      pose_at(pair.motion2, at.q), tolerance / 100);
  return apart.gap >= -tolerance;
}

std::optional<ContactTrack> track_of(const ContactPair& pair, const MapBranch& branch, const MapPoint& from) {
  const ContactPair facing = branch.opposed ? pair : with_other_side(pair);
  const int sense = from.n_W.dot(velocity_per_q(pair.motion2, from.p_W)) > 0 ? 1 : -1;
  const ContactResult result = solve_contact(facing, from.u, from.q, from.n_W, sense);
  if (result.status != ContactStatus::kOk) {
    return std::nullopt;
  }
  return start_track(facing, result.at, sense);
}

}  // namespace

MapPoint point_of(const ContactPair& pair, const MapRange& range, bool opposed, const ContactPosition& at) {
  MapPoint point;
  static_cast<TangentPosition&>(point) = {at.u, at.q, at.p1_W, at.n_W};
  point.free = is_free(pair, opposed, at, range.tolerance * size_of_pair(pair));
  return point;
}

std::optional<MapPoint> followed(const ContactPair& pair, const MapRange& range, const MapBranch& branch,
                                 const MapPoint& from, double u) {
  auto track = track_of(pair, branch, from);
  if (!track || !walk_to(*track, u)) {
    return std::nullopt;
  }
  return point_of(pair, range, branch.opposed, track->at);
}

}  // namespace higherpair

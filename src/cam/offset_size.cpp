#include "follower_shape.hpp"
#include "higherpair/cam/sizing.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "tolerances.hpp"
#include "worst_place.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

// The smallest cam under a sliding follower whose guide may be beside the cam's pivot.

namespace higherpair {
namespace {

// d >= slope e + level, a half plane.
struct HalfPlane {
  double slope = 0, level = 0;
};

// The point (e, d) common to all half planes that is closest to the origin: on one border, or where two meet.
Vector2d nearest_point(const std::vector<HalfPlane>& planes) {
  Vector2d best(0, 0);
  double least = kInf;
  const auto consider = [&](double e) {
    double d = 0;
    for (const HalfPlane& plane : planes) {
      d = std::max(d, plane.slope * e + plane.level);
    }
    if (std::hypot(e, d) < least) {
      least = std::hypot(e, d);
      best = {e, d};
    }
  };
  for (std::size_t i = 0; i < planes.size(); ++i) {
    consider(-planes[i].slope * planes[i].level / (1 + planes[i].slope * planes[i].slope));
    for (std::size_t j = 0; j < i; ++j) {
      if (planes[i].slope != planes[j].slope) {
        consider((planes[j].level - planes[i].level) / (planes[i].slope - planes[j].slope));
      }
    }
  }
  return best;
}

}  // namespace

std::optional<OffsetSize> smallest_with_offset(const FlankOrigin& cam, const PressureLimits& limits) {
  const auto round = round_of(cam);
  if (!round || !cam.motion.cam.turns || cam.motion.follower.turns) {
    return std::nullopt;
  }
  const SizeRange sizes = sizes_of_round(cam, *round);
  const double rise = sizes.sense;  // sign of the change of height with the law
  const double out = std::tan(limits.out), back = std::tan(limits.back);
  const double turn = cam.motion.follower_sign * cam.motion.cam_sign;
  const LawSearch search(cam.motion.law);
  std::vector<HalfPlane> planes;
  Vector2d point(0, 0);
  for (int i = 0; i < kMostSizeExchanges; ++i) {
    const auto asks = [&](const Lift& lift) {
      const double steepest = returns(lift, rise, limits.sense) ? back : out;
      return std::abs(turn * lift.v - point.x()) / steepest - rise * lift.s;
    };
    const Worst worst = worst_of(cam.motion.law, search, asks);
    if (!(worst.peak.value - point.y() > kSameCamSize * (point.norm() + std::abs(worst.peak.value)))) {
      break;
    }
    const double steepest = returns(worst.lift, rise, limits.sense) ? back : out;
    const double side = turn * worst.lift.v < point.x() ? -1 : 1;
    planes.push_back({-side / steepest, side * turn * worst.lift.v / steepest - rise * worst.lift.s});
    point = nearest_point(planes);
  }
  return OffsetSize{point.norm(), point.x(), point.y()};
}

}  // namespace higherpair

#include "higherpair/cam/sizing.hpp"

#include "follower_shape.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/geometry/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace higherpair {
namespace {

constexpr int kMostExchanges = 60;
constexpr double kNoCam = 1e12;  // value of a condition where the cam has shrunk to a point

struct SizeAt {
  double y = 0;
  double at = 0;
};

// The smallest size from y on at which a condition g(y) <= 0 of one place holds.
std::optional<double> size_above(const std::function<double(double)>& g, double y, const SizeRange& sizes) {
  const bool bounded = std::isfinite(sizes.most);
  double step = bounded ? sizes.most / 64 : sizes.step;
  if (g(y) <= 0) {
    return y;
  }
  for (double low = y, at_low = g(y); low < sizes.most && step < 1e12 * sizes.step; step *= bounded ? 1 : 2) {
    const double high = std::min(low + step, sizes.most);
    const double at_high = g(high);
    if (at_high <= 0) {
      const auto root = root_between([&](double t) { return g(low + t); }, at_low, high - low, at_high);
      return root ? std::optional(low + *root) : std::nullopt;
    }
    low = high;
    at_low = at_high;
  }
  return std::nullopt;
}

// The smallest size at which a condition holds over the whole law.
std::optional<SizeAt> smallest_size(const MotionLaw& law, const SizeRange& sizes,
                                    const std::function<double(const Lift&, double y)>& condition) {
  SizeAt size{0, law.begin()};
  const LawSearch search(law);
  for (int i = 0; i < kMostExchanges; ++i) {
    const auto checked = [&](const Lift& lift, double y) {
      const double value = condition(lift, y);
      return std::isfinite(value) ? value : kNoCam;
    };
    const Worst worst = worst_of(law, search, [&](const Lift& lift) { return checked(lift, size.y); });
    if (!(worst.peak.value > 0)) {
      return size;
    }
    const auto next = size_above([&](double y) { return checked(worst.lift, y); }, size.y, sizes);
    if (!next) {
      return std::nullopt;
    }
    const bool settled = *next - size.y <= kSameCamSize * *next;
    size = {*next, worst.peak.at};
    if (settled) {
      return size;
    }
  }
  return size;
}

bool is_sized(const FlankOrigin& cam) {
  return cam.motion.cam.turns && (is_line(cam.curve) || round_of(cam));
}

CamSize size_at(const FlankOrigin& cam, double rest, double at) {
  if (is_line(cam.curve)) {
    const double height = std::abs(face_at(cam, {}, rest).height);
    return {rest, height, height, at};
  }
  const Round round = *round_of(cam);
  const double radius = centre_at(cam, round, {}, rest).from_cam.norm();
  return {rest, radius, cam.outer ? radius + round.radius : radius - round.radius, at};
}

std::optional<CamSize> sized(const FlankOrigin& cam, const SizeRange& sizes,
                             const std::optional<SizeAt>& size) {
  return size ? std::optional(size_at(cam, sizes.rest(size->y), size->at)) : std::nullopt;
}

// Whether the follower moves back towards the cam's pivot.
bool returns(const Lift& lift, double away, double sense) {
  return away * lift.v * sense < 0;
}

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

std::optional<CamSize> size_of(const FlankOrigin& cam) {
  return is_sized(cam) ? std::optional(size_at(cam, cam.motion.follower_rest, 0)) : std::nullopt;
}

std::optional<CamPlace> largest_center_pressure(const FlankOrigin& cam) {
  const auto round = round_of(cam);
  if (!round) {
    return std::nullopt;
  }
  const MotionLaw& law = cam.motion.law;
  const Worst worst = worst_of(law, LawSearch(law), [&](const Lift& lift) {
    const Inclination normal = inclination_of(centre_at(cam, *round, lift, cam.motion.follower_rest));
    return std::atan2(std::abs(normal.along), std::abs(normal.across));
  });
  return CamPlace{worst.peak.value, worst.peak.at};
}

std::optional<PitchCurvature> pitch_curvature(const FlankOrigin& cam) {
  const auto round = round_of(cam);
  if (!round) {
    return std::nullopt;
  }
  const MotionLaw& law = cam.motion.law;
  const LawSearch search(law);
  const auto extreme = [&](double sign) {
    const Worst worst = worst_of(law, search, [&](const Lift& lift) {
      return sign * pitch_curvature_at(cam, centre_at(cam, *round, lift, cam.motion.follower_rest));
    });
    return CamPlace{sign * worst.peak.value, worst.peak.at};
  };
  return PitchCurvature{extreme(1), extreme(-1)};
}

std::optional<CamSize> smallest_for_pressure(const FlankOrigin& cam, const PressureLimits& limits) {
  const auto round = round_of(cam);
  if (!round || !cam.motion.cam.turns) {
    return std::nullopt;
  }
  const SizeRange sizes = sizes_of_round(cam, *round);
  const double out = std::tan(limits.out), back = std::tan(limits.back);
  return sized(cam, sizes, smallest_size(cam.motion.law, sizes, [&](const Lift& lift, double y) {
                 const Inclination normal = inclination_of(centre_at(cam, *round, lift, sizes.rest(y)));
                 const double steepest = returns(lift, sizes.sense, limits.sense) ? back : out;
                 return std::abs(normal.along) - steepest * std::abs(normal.across);
               }));
}

std::optional<CamSize> smallest_for_radius(const FlankOrigin& cam, const RadiusLimits& limits) {
  if (!is_sized(cam)) {
    return std::nullopt;
  }
  const MotionLaw& law = cam.motion.law;
  if (is_line(cam.curve)) {
    const SizeRange sizes = sizes_of_flat(cam);
    return sized(cam, sizes, smallest_size(law, sizes, [&](const Lift& lift, double y) {
                   return limits.convex - face_at(cam, lift, sizes.rest(y)).radius;
                 }));
  }
  const Round round = *round_of(cam);
  const SizeRange sizes = sizes_of_round(cam, round);
  const double convex = limits.convex + round.radius, concave = limits.concave - round.radius;
  const double most = convex > 0 ? 1 / convex : kInf, least = concave > 0 ? -1 / concave : -kInf;
  return sized(cam, sizes, smallest_size(law, sizes, [&](const Lift& lift, double y) {
                 const double curvature = pitch_curvature_at(cam, centre_at(cam, round, lift, sizes.rest(y)));
                 return std::max(curvature - most, least - curvature);
               }));
}

std::optional<CamPlace> largest_follower(const FlankOrigin& cam, double convex) {
  const auto curvature = pitch_curvature(cam);
  if (!curvature || !(curvature->greatest.value > 0)) {
    return std::nullopt;
  }
  return CamPlace{1 / curvature->greatest.value - convex, curvature->greatest.at};
}

namespace {

// Of trials in order, the first that succeeds, moved back towards the one before it as far as it can be.
std::optional<double> first_success(const std::vector<double>& trials,
                                    const std::function<bool(double)>& succeeds) {
  const auto found = std::find_if(trials.begin(), trials.end(), succeeds);
  if (found == trials.end()) {
    return std::nullopt;
  }
  double good = *found;
  double bad = found == trials.begin() ? good : *(found - 1);
  while (std::abs(good - bad) > kTriedSize * std::abs(good)) {
    const double middle = (good + bad) / 2;
    (succeeds(middle) ? good : bad) = middle;
  }
  return good;
}

SizeRange sizes_of(const FlankOrigin& cam) {
  return is_line(cam.curve) ? sizes_of_flat(cam) : sizes_of_round(cam, *round_of(cam));
}

// Each twice as far from the first as the one before; where the size is bounded, at equal distances.
std::vector<double> sizes_to_try(const SizeRange& sizes, double from_rest) {
  const double from = sizes.sense * (from_rest - sizes.origin);
  std::vector<double> all{from + kJustBeyondSize * std::abs(from)};
  for (int k = 0; k < kMostSizeTrials; ++k) {
    all.push_back(std::isfinite(sizes.most) ? std::lerp(from, sizes.most, (k + 1.0) / kMostSizeTrials)
                                            : from + std::ldexp(sizes.step, k));
  }
  return all;
}

std::vector<double> radii_to_try(double from) {
  std::vector<double> all{from * (1 - kJustBeyondSize)};
  for (int k = 1; k <= kMostSizeTrials; ++k) {
    all.push_back(std::ldexp(from, -k));
  }
  return all;
}

}  // namespace

std::optional<CamSize> smallest_that_can_be_cut(const FlankOrigin& cam, const CamSize& from,
                                                const FlankTest& can_be_cut) {
  const SizeRange sizes = sizes_of(cam);
  const std::vector<double> trials = sizes_to_try(sizes, from.rest);
  const auto y = first_success(trials, [&](double tried) {
    FlankOrigin other = cam;
    other.motion.follower_rest = sizes.rest(tried);
    return can_be_cut(other);
  });
  if (!y || *y == trials.front()) {
    return y ? std::optional(from) : std::nullopt;
  }
  return size_at(cam, sizes.rest(*y), 0);
}

std::optional<double> largest_that_can_be_cut(const FlankOrigin& cam, double from_radius,
                                              const FlankTest& can_be_cut) {
  const std::vector<double> trials = radii_to_try(from_radius);
  const auto radius = first_success(trials, [&](double tried) {
    FlankOrigin other = cam;
    const auto curve = make_circle(round_of(cam)->centre_B, tried);
    other.curve = curve.value_or(cam.curve);
    return curve && can_be_cut(other);
  });
  return radius && *radius == trials.front() ? from_radius : radius;
}

CamSize largest_tried(const FlankOrigin& cam, const CamSize& from) {
  const SizeRange sizes = sizes_of(cam);
  return size_at(cam, sizes.rest(sizes_to_try(sizes, from.rest).back()), 0);
}

double smallest_radius_tried(double from_radius) {
  return radii_to_try(from_radius).back();
}

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
  for (int i = 0; i < kMostExchanges; ++i) {
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

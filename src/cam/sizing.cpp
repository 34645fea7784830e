#include "higherpair/cam/sizing.hpp"

#include "follower_shape.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace higherpair {
namespace {

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
  for (double low = y, at_low = g(y); low < sizes.most && step < kLargestSizeStep * sizes.step;
       step *= bounded ? 1 : 2) {
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
  for (int i = 0; i < kMostSizeExchanges; ++i) {
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

std::optional<CamSize> sized(const FlankOrigin& cam, const SizeRange& sizes,
                             const std::optional<SizeAt>& size) {
  return size ? std::optional(size_at(cam, sizes.rest(size->y), size->at)) : std::nullopt;
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
    const Inclination normal = inclination_of(center_at(cam, *round, lift, cam.motion.follower_rest));
    return std::atan2(std::abs(normal.along), std::abs(normal.across));
  });
  return CamPlace{worst.peak.value, worst.peak.at};
}

std::optional<CamPlace> largest_pitch_curvature(const FlankOrigin& cam) {
  const auto round = round_of(cam);
  if (!round) {
    return std::nullopt;
  }
  const MotionLaw& law = cam.motion.law;
  const Worst worst = worst_of(law, LawSearch(law), [&](const Lift& lift) {
    return pitch_curvature_at(cam, center_at(cam, *round, lift, cam.motion.follower_rest));
  });
  return CamPlace{worst.peak.value, worst.peak.at};
}

std::optional<CamSize> smallest_for_pressure(const FlankOrigin& cam, const PressureLimits& limits) {
  const auto round = round_of(cam);
  if (!round || !cam.motion.cam.turns) {
    return std::nullopt;
  }
  const SizeRange sizes = sizes_of_round(cam, *round);
  const double out = std::tan(limits.out), back = std::tan(limits.back);
  return sized(cam, sizes, smallest_size(cam.motion.law, sizes, [&](const Lift& lift, double y) {
                 const Inclination normal = inclination_of(center_at(cam, *round, lift, sizes.rest(y)));
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
                 const double curvature = pitch_curvature_at(cam, center_at(cam, round, lift, sizes.rest(y)));
                 return std::max(curvature - most, least - curvature);
               }));
}

std::optional<CamPlace> largest_follower(const FlankOrigin& cam, double convex) {
  const auto curvature = largest_pitch_curvature(cam);
  if (!curvature || !(curvature->value > 0)) {
    return std::nullopt;
  }
  return CamPlace{1 / curvature->value - convex, curvature->at};
}

}  // namespace higherpair

#include "follower_shape.hpp"
#include "higherpair/cam/sizing.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

// Sizes of a cam or its follower at which the flank can be cut, found by trial.

namespace higherpair {
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
    const auto curve = make_circle(round_of(cam)->center_B, tried);
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

}  // namespace higherpair

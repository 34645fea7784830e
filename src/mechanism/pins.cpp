#include "higherpair/mechanism/pins.hpp"

#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "higherpair/numeric/contains.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace higherpair {
namespace {

bool is_same(const BodyPoint& a, const BodyPoint& b) {
  return a.body == b.body && (a.p_B - b.p_B).norm() <= kSameBodyPoint * (a.p_B.norm() + b.p_B.norm());
}

std::optional<std::size_t> pin_with(const std::vector<Pin>& pins, const BodyPoint& point) {
  for (std::size_t i = 0; i < pins.size(); ++i) {
    const auto same = [&](const BodyPoint& end) { return is_same(end, point); };
    if (std::any_of(pins[i].ends.begin(), pins[i].ends.end(), same)) {
      return i;
    }
  }
  return std::nullopt;
}

void add_end(Pin& pin, const BodyPoint& point) {
  const auto same = [&](const BodyPoint& end) { return is_same(end, point); };
  if (std::none_of(pin.ends.begin(), pin.ends.end(), same)) {
    pin.ends.push_back(point);
  }
}

void merge(std::vector<Pin>& pins, std::size_t into, std::size_t from) {
  for (const BodyPoint& end : pins[from].ends) {
    add_end(pins[into], end);
  }
  pins[into].joints.insert(pins[into].joints.end(), pins[from].joints.begin(), pins[from].joints.end());
  pins.erase(pins.begin() + static_cast<std::ptrdiff_t>(from));
}

// The bodies pinned to a wheel at its centre, without the wheel itself; empty if nothing is pinned there.
std::vector<int> bodies_at(const std::vector<Pin>& pins, const Mechanism& mechanism, const PointRef& wheel) {
  const auto pin = pin_with(pins, {wheel.body, point_of(mechanism, wheel)});
  std::vector<int> bodies;
  for (const BodyPoint& end : pin ? pins[*pin].ends : std::vector<BodyPoint>{}) {
    if (end.body != wheel.body) bodies.push_back(end.body);
  }
  return bodies;
}

}  // namespace

std::vector<Pin> find_pins(const Mechanism& mechanism) {
  std::vector<Pin> pins;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (joint.type != JointType::kRevolute) {
      continue;
    }
    const BodyPoint first{joint.first.body, point_of(mechanism, joint.first)};
    const BodyPoint second{joint.second.body, point_of(mechanism, joint.second)};
    const auto of_first = pin_with(pins, first);
    const auto of_second = pin_with(pins, second);
    std::size_t at = of_first.value_or(of_second.value_or(pins.size()));
    if (at == pins.size()) {
      pins.emplace_back();
    }
    if (of_first && of_second && *of_first != *of_second) {
      at = std::min(*of_first, *of_second);
      merge(pins, at, std::max(*of_first, *of_second));
    }
    add_end(pins[at], first);
    add_end(pins[at], second);
    pins[at].joints.push_back(static_cast<int>(i));
  }
  for (Pin& pin : pins) {
    std::sort(pin.joints.begin(), pin.joints.end());
    std::sort(pin.ends.begin(), pin.ends.end(),
              [](const BodyPoint& a, const BodyPoint& b) { return a.body < b.body; });
  }
  return pins;
}

std::vector<int> carriers_of(const Mechanism& mechanism, const Joint& wheels, const std::vector<Pin>& pins) {
  const std::vector<int> first = bodies_at(pins, mechanism, wheels.first);
  std::vector<int> common;
  for (const int body : bodies_at(pins, mechanism, wheels.second)) {
    if (contains(first, body)) common.push_back(body);
  }
  return common;
}

}  // namespace higherpair

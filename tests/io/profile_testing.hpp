#pragma once

#include "higherpair/io/profile_reader.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair::testing {

using Overrides = std::vector<std::string>;

/// The profile in `text`. Any mistake in it fails the test, and an empty profile is returned.
inline Profile read(const std::string& text, const Overrides& overrides = {}) {
  auto profile = read_profile_text(text, "test.toml", overrides);
  if (!profile) {
    for (const Diagnostic& diagnostic : profile.error()) ADD_FAILURE() << to_string(diagnostic);
    return {};
  }
  return *profile;
}

/// The messages about `text`, as the user sees them; none for a correct profile.
inline std::vector<std::string> messages(const std::string& text, const Overrides& overrides = {}) {
  std::vector<std::string> lines;
  const auto profile = read_profile_text(text, "test.toml", overrides);
  if (!profile) {
    for (const Diagnostic& diagnostic : profile.error()) lines.push_back(to_string(diagnostic));
  }
  return lines;
}

/// `text` with the first occurrence of `old` replaced; there must be one.
inline std::string replaced(std::string text, const std::string& old, const std::string& with) {
  return text.replace(text.find(old), old.size(), with);
}

/// The example of the format's description: a disc cam and an oscillating follower, with every kind of table.
inline constexpr const char* kCamProfile = R"(format  = 1
title   = "Eccentric disc cam, oscillating disc follower"
gravity = [0, -9810]

[units]
length = "mm"
angle  = "deg"
mass   = "kg"
time   = "s"
force  = "N"

[bodies.ground]
points.O1 = [0, 0]
points.O2 = [80, 0]

[bodies.cam]
pose        = { x = 0, y = 0, angle = 0 }
points.O    = [0, 0]
curves.disc = { type = "circle", center = [10, 0], radius = 20 }

[bodies.follower]
pose          = { x = 80, y = 0, angle = -35 }
points.O      = [0, 0]
points.E      = [-60, 25]
curves.roller = { type = "circle", center = [-60, 0], radius = 15 }
mass           = 0.4
center_of_mass = [-30, 0]
inertia        = "2.1e-4 kg m^2"

[joints.cam_pivot]
type    = "revolute"
between = ["ground.O1", "cam.O"]

[joints.follower_pivot]
type    = "revolute"
between = ["ground.O2", "follower.O"]

[contacts.touch]
between  = ["cam.disc", "follower.roller"]
rolling  = false
approach = "nearest"

[driver]
joint        = "cam_pivot"
start        = 0
end          = 360
samples      = 361
velocity     = 60
acceleration = 0
duration     = 6
time_step    = 0.01

[loads]
push = { body = "follower", point = "E", force = [0, -12], frame = "ground" }
twist = { body = "follower", torque = 40 }

[springs]
s1 = { between = ["ground.O1", "follower.E"], stiffness = 1.5, free_length = 40, damping = 0 }
s2 = { joint = "follower_pivot", stiffness = 30, free_angle = 0, damping = 0 }

[extra]
anything = { goes = ["here", 1, true] }
)";

/// The smallest valid profile: a driven crank of 31 mm on ground. `above` is put before it, `more` after it.
inline std::string crank_profile(const std::string& more = "", const std::string& above = "") {
  return above + R"([bodies.ground]
points.A = [0, 0]
points.B = [127, 0]
[bodies.crank]
points.A = [0, 0]
points.P = [31, 0]
[joints.pivot]
type = "revolute"
between = ["ground.A", "crank.A"]
[driver]
joint = "pivot"
)" + more;
}

/// The crank and a slider on ground, along the line through B in the given direction; the slider is driven.
inline std::string slider_profile(const std::string& more = "", const std::string& direction = "[1, 0]") {
  return R"([bodies.ground]
points.A = [0, 0]
points.B = [127, 0]
[bodies.slider]
pose = { x = 140, y = 0 }
points.S = [1.5, 0]
[joints.slide]
type = "prismatic"
between = ["ground.B", "slider.S"]
direction = )" +
         direction + "\n[driver]\njoint = \"slide\"\n" + more;
}

}  // namespace higherpair::testing

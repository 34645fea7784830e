#pragma once

#include "front/cam_profile.hpp"
#include "geometry/geometry_testing.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/core.h>

// Builds profiles of cams under sliding followers from a few lines, and gives their motions and events.

namespace higherpair::testing {

/// Lines of a profile in which a body `cam` turns on a joint `pivot` at ground's origin, and a body
/// `follower` slides on a joint `guide` through it.
struct SlidingCam {
  std::string cam;       ///< its curves
  std::string follower;  ///< pose, curves, mass
  std::string guide = "direction = [0, 1]";
  std::string contact;  ///< `between` and other keys of the contact `touch`
  std::string driver;   ///< keys beside `joint`, and tables after it
};

inline std::string profile_of(const SlidingCam& parts) {
  return fmt::format(R"([bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
{}
[bodies.follower]
points.P = [0, 0]
{}
[joints.pivot]
type = "revolute"
between = ["ground.O", "cam.O"]
[joints.guide]
type = "prismatic"
between = ["ground.O", "follower.P"]
{}
[contacts.touch]
{}
[driver]
joint = "pivot"
{}
)",
                     parts.cam, parts.follower, parts.guide, parts.contact, parts.driver);
}

inline Motion motion_of(const Model& model, const RunSettings& settings = {}) {
  auto motion = model.run(settings);
  if (!motion) {
    throw std::runtime_error(to_string(motion.error()));
  }
  return *std::move(motion);
}

inline Motion motion_of(const Model& model, int samples) {
  RunSettings settings;
  settings.samples = samples;
  return motion_of(model, settings);
}

inline std::vector<Event> events_of(const Motion& motion, EventType type) {
  std::vector<Event> found;
  for (const Event& event : motion.events()) {
    if (event.type == type) {
      found.push_back(event);
    }
  }
  return found;
}

}  // namespace higherpair::testing

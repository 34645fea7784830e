#pragma once

#include "higherpair/higherpair.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace higherpair::testing {

/// An eccentric disc that lifts a flat-faced follower: y = 30 + 10 sin θ [mm].
inline constexpr const char* kCam = R"(
[bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
curves.disc = { type = "circle", center = [10, 0], radius = 30 }
[bodies.follower]
pose = { x = 0, y = 30 }
points.P = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = [0, -1] }
[joints]
O     = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.O", "follower.P"], direction = [0, 1] }
[contacts.touch]
between = ["cam.disc", "follower.face"]
[driver]
joint = "O"
)";

inline Model model_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  auto model = Model::from_text(text, "test.toml", overrides);
  if (!model) {
    throw std::runtime_error(to_string(model.error()));
  }
  return *std::move(model);
}

/// A profile of the folder profiles/.
inline Model shipped_model(const std::string& name, const std::vector<std::string>& overrides = {}) {
  auto model = Model::open(HIGHERPAIR_SOURCE_DIR "/profiles/" + name + ".toml", overrides);
  if (!model) {
    throw std::runtime_error(to_string(model.error()));
  }
  return *std::move(model);
}

/// The whole motion as text that shows every bit.
inline std::string text_of(const Motion& motion) {
  std::string text;
  for (const Column& column : motion.columns()) {
    const auto values = motion.column(column.name).values;
    text += column.name;
    text.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  for (const Event& event : motion.events()) {
    text += std::string(name_of(event.type)) + event.item + event.cause;
    text.append(reinterpret_cast<const char*>(&event.driver), sizeof event.driver);
  }
  return text;
}

}  // namespace higherpair::testing

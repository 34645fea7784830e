#pragma once

#include "higherpair/drawing/scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace higherpair {

/// A unit of a picture: its name as tables have it, and what it is in SI units.
struct PictureUnit {
  std::string name;
  double si = 1;
};

struct DrawSettings {
  std::vector<Role> layers;        ///< empty: all but motion, forces and instant centres
  double width = 900;              ///< of the picture, or of each picture of a strip [px]
  double most_height = 1000;       ///< without scales: what would be higher is drawn narrower [px]
  bool strip = false;              ///< several scenes side by side, not one over the other
  PictureUnit length{"mm", 1e-3};  ///< of `data-scale` and the scale bar
  PictureUnit velocity{"mm/s", 1e-3};
  PictureUnit acceleration{"mm/s^2", 1e-3};
  PictureUnit force{"N", 1};
  PictureUnit torque{"N*m", 1};
  std::string title;  ///< for screen readers
};

/// The layers of a picture where none are named.
[[nodiscard]] std::vector<Role> default_layers();

/// A picture of a mechanism as SVG. The last scene is drawn whole, those before it as ghosts, or all side by
/// side; below them the scales of lengths and arrows. Every element carries data-role and data-name; the top
/// element data-scale (px per unit of length) and data-origin (px of ground's origin), y up.
/// \pre  at least one scene, all of one SceneMaker
[[nodiscard]] std::string draw_svg(std::span<const Scene> scenes, const DrawSettings& settings);

}  // namespace higherpair

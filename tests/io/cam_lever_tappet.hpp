#pragma once

namespace higherpair::testing {

/// An elliptic cam turns a lever through a roller, and an ellipse on the lever lifts a flat tappet.
inline constexpr const char* kCamLeverTappet = R"(
[bodies.ground]
points = { O = [0, 0], P = [80, 0], Q = [80, 100] }
[bodies.cam]
points.O = [0, 0]
curves.edge = { type = "ellipse", center = [5, 3], semi_axes = [30, 20] }
[bodies.lever]
pose = { x = 80, y = 0 }
points.P = [0, 0]
curves.roller = { type = "circle", center = [-60, 45], radius = 12 }
curves.top = { type = "ellipse", center = [-20, 60], semi_axes = [25, 15] }
[bodies.tappet]
pose = { x = 80, y = 100 }
points.T = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = [0, -1] }
[joints]
cam_pivot   = { type = "revolute", between = ["ground.O", "cam.O"] }
lever_pivot = { type = "revolute", between = ["ground.P", "lever.P"] }
guide       = { type = "prismatic", between = ["ground.Q", "tappet.T"], direction = [0, 1] }
[contacts]
lower = { between = ["cam.edge", "lever.roller"] }
upper = { between = ["lever.top", "tappet.face"] }
[driver]
joint = "cam_pivot"
)";

}  // namespace higherpair::testing

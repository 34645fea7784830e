#pragma once

namespace higherpair::testing {

/// Equal eccentric discs in contact move like the cranks of a parallelogram, so that branches cross at 0° and
/// 180°. Driver and follower start upright.
inline constexpr const char* kEqualDiscs = R"(
[bodies.ground]
points = { O = [0, 0], Q = [35, 0] }
[bodies.cam]
points.O = [0, 0]
curves.edge = { type = "circle", center = [10, 0], radius = 20 }
[bodies.follower]
pose = { x = 35, angle = 90 }
points.Q = [0, 0]
curves.edge = { type = "circle", center = [10, 0], radius = 15 }
[joints]
cam_pivot      = { type = "revolute", between = ["ground.O", "cam.O"] }
follower_pivot = { type = "revolute", between = ["ground.Q", "follower.Q"] }
[contacts]
touch = { between = ["cam.edge", "follower.edge"] }
[driver]
joint = "cam_pivot"
start = 90
)";

}  // namespace higherpair::testing

#pragma once

namespace higherpair::testing {

/// A slider-crank of crank 30, rod 100 and offset 12 [mm].
inline constexpr const char* kSlider = R"(
[bodies.ground]
points.O = [0, 0]
points.rail = [0, 12]
[bodies.crank]
points = { O = [0, 0], A = [30, 0] }
[bodies.rod]
pose   = { x = 30, y = 0, angle = 7 }
points = { A = [0, 0], B = [100, 0] }
[bodies.slider]
pose     = { x = 129, y = 12 }
points.B = [0, 0]
[joints]
o = { type = "revolute", between = ["ground.O", "crank.O"] }
a = { type = "revolute", between = ["crank.A", "rod.A"] }
b = { type = "revolute", between = ["rod.B", "slider.B"] }
s = { type = "prismatic", between = ["ground.rail", "slider.B"], direction = [1, 0] }
[driver]
joint   = "o"
start   = 0
end     = 360
samples = 7
velocity = "2 rad/s"
)";

}  // namespace higherpair::testing

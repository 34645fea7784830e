// Motions that start where a contact hardly constrains its follower.
#include "cam_profile.hpp"
#include "sliding_cam.hpp"

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::model_of;
using testing::motion_of;

// An arm in line with the centres where its law is at rest: the pressure angle is 90 degrees.
constexpr const char* kArmInLine = R"(
[bodies.ground]
points = { O = [0, 0], Q = [70, 0] }
[bodies.cam]
points.O = [0, 0]
curves.flank = { type = "cam", law = "lift", contact = "touch" }
[bodies.follower]
pose = { x = 70, y = 0 }
points.P = [0, 0]
curves.roller = { type = "circle", center = [-50, 0], radius = 6 }
[joints]
O = { type = "revolute", between = ["ground.O", "cam.O"] }
Q = { type = "revolute", between = ["ground.Q", "follower.P"] }
[contacts.touch]
between = ["cam.flank", "follower.roller"]
[driver]
joint = "O"
[laws.lift]
points = [[0, 0], [60, 2], [120, 9], [180, 12], [240, 9], [300, 2], [360, 0]]
)";

// Near such a start rounding makes and breaks contacts by the thousand.
TEST(SingularStart, IsLeftForRowsThatAreTheSameHoweverManyThereAre) {
  const Model model = model_of(kArmInLine);
  const Motion few = motion_of(model, 8);
  const Motion many = motion_of(model, 15);
  const auto angle = few.column("follower.angle");
  const auto same = many.column("follower.angle");
  for (std::size_t k = 1; k < 7; ++k) {
    ASSERT_EQ(few.statuses()[k], RowStatus::kOk) << k;
    ASSERT_EQ(many.statuses()[2 * k], RowStatus::kOk) << k;
    EXPECT_NEAR(angle[k], same[2 * k], 1e-9) << k;
  }
}

}  // namespace
}  // namespace higherpair

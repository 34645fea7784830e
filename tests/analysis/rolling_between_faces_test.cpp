#include "geometry/geometry_testing.hpp"
#include "run_testing.hpp"
#include "support/texts.hpp"

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::RunTable;

// A planet between a driven sun and a fixed ring, without an arm to carry it: both contacts keep it at the
// same distance from the centre, so that one condition is redundant.
constexpr const char* kPlanet = R"(
[bodies.ground]
points.O = [0, 0]
curves.ring = { type = "circle", center = [0, 0], radius = 60, side = "outside" }
[bodies.sun]
points.O = [0, 0]
curves.rim = { type = "circle", center = [0, 0], radius = 20 }
[bodies.planet]
pose = { x = 40, y = 0, angle = 15 }
points.A = [0, 0]
curves.rim = { type = "circle", center = [0, 0], radius = 20 }
[joints]
main = { type = "revolute", between = ["ground.O", "sun.O"] }
[contacts]
outer = { between = ["planet.rim", "ground.ring"], rolling = true }
inner = { between = ["sun.rim", "planet.rim"], rolling = true }
[driver]
joint = "main"
velocity = 100
samples = 13
)";

TEST(PlanetBetweenFaces, GoesRoundWithAQuarterOfTheSunsSpeed) {
  for (const char* pose :
       {"bodies.planet.pose.x=40", "bodies.planet.pose.x=40.001", "bodies.planet.pose.x=41",
        "bodies.planet.pose.x=39.9", "bodies.planet.pose.y=0.00001", "bodies.planet.pose.y=3"}) {
    SCOPED_TRACE(pose);
    const RunTable motion = testing::analyze(testing::profile_of(kPlanet, {pose}));
    ASSERT_EQ(motion.count(RowStatus::kOk), 13U) << motion.failure();
    const double start = std::arg(motion.vector(0, "planet.A."));
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double turned = motion.radians(k, "driver") / 4;
      EXPECT_AT_MOST(std::abs(motion.vector(k, "planet.A.") - std::polar(40.0, start + turned)), 1e-11);
      EXPECT_AT_MOST(
          std::abs(motion.radians(k, "planet.angle") - motion.radians(0, "planet.angle") + 2 * turned),
          1e-12);
      EXPECT_NEAR(motion.value(k, "planet.omega"), -50, 1e-10);
      EXPECT_NEAR(motion.value(k, "planet.alpha"), 0, 1e-9);
    }
  }
}

TEST(PlanetBetweenTwoFaces, ThatSlipsOnOneOfThemIsNotHeld) {
  for (const char* slipping : {"contacts.outer.rolling=false", "contacts.inner.rolling=false"}) {
    EXPECT_TRUE(contains(testing::analyze(testing::profile_of(kPlanet, {slipping})).failure(),
                         "2 drivers needed, 1 given"))
        << slipping;
  }
}

TEST(PlanetBetweenTwoFaces, ThatSlipsOnBothIsNotHeldHoweverItIsTurned) {
  for (const char* angle : {"0", "15", "33", "77", "-120"}) {
    const auto profile =
        testing::profile_of(kPlanet, {"contacts.outer.rolling=false", "contacts.inner.rolling=false",
                                      std::string("bodies.planet.pose.angle=") + angle});
    EXPECT_TRUE(contains(testing::analyze(profile).failure(), "wrong mobility for its drivers")) << angle;
  }
}

}  // namespace
}  // namespace higherpair

// Andrews' squeezing mechanism against published numbers: positions, rates, driving torque and the forces in
// the pins of a mechanism of seven bodies with a spring. The initial values are those of Hairer and Wanner,
// Solving Ordinary Differential Equations II, section VI.9; those after 0.03 s are of the Test Set for
// Initial Value Problem Solvers (Mazzia and Magherini, problem `andrews`), integrated numerically.
#include "front/cam_profile.hpp"

#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

struct PublishedValue {
  const char* column;
  double value;  // in rad, N and N m
};

struct PublishedState {
  double crank, velocity, acceleration;
  std::vector<PublishedValue> positions, velocities, accelerations, efforts;
};

// Without a torque on it the crank would not move in this way.
constexpr PublishedValue kAndrewsTorque{"driver.effort", 0.033};

const PublishedState kAndrewsStart{-0.0617138900142764496358948458001,
                                   0,
                                   14222.4439199541138705911625887,
                                   {{"F.position", 0},
                                    {"B.position", 0.455279819163070380255912382449},
                                    {"G.position", 0.222668390165885884674473185609},
                                    {"A5.position", 0.487364979543842550225598953530},
                                    {"H.position", -0.222668390165885884674473185609},
                                    {"A7.position", 1.23054744454982119249735015568}},
                                   {},
                                   {{"F.acceleration", -10666.8329399655854029433719415},
                                    {"B.acceleration", 0},
                                    {"G.acceleration", 0},
                                    {"A5.acceleration", 0},
                                    {"H.acceleration", 0},
                                    {"A7.acceleration", 0}},
                                   {{"E3.fx", 98.5668703962410896057654982170},
                                    {"E3.fy", -6.12268834425566265503114393122},
                                    {"E4.fx", 0},
                                    {"E4.fy", 0},
                                    {"E6.fx", 0},
                                    {"E6.fy", 0},
                                    kAndrewsTorque}};

// Two and a half turns later.
const PublishedState kAndrewsLater{15.81077119629904,
                                   1139.920302151208,
                                   -24631.76316945196,
                                   {{"F.position", -15.75637105984298},
                                    {"B.position", 0.04082224013073101},
                                    {"G.position", -0.5347301163226948},
                                    {"A5.position", 0.5244099658805304},
                                    {"H.position", 0.5347301163226948},
                                    {"A7.position", 1.048080741042263}},
                                   {{"F.velocity", -1424.379294994111},
                                    {"B.velocity", 11.03291221937134},
                                    {"G.velocity", 19.29337464421385},
                                    {"A5.velocity", 0.5735699284790808},
                                    {"H.velocity", -19.29337464421385},
                                    {"A7.velocity", 0.3231791658026955}},
                                   {{"F.acceleration", 51850.37701610329},
                                    {"B.acceleration", 324102.5686413781},
                                    {"G.acceleration", 566749.3645176213},
                                    {"A5.acceleration", 16743.62929479361},
                                    {"H.acceleration", -566749.3645176222},
                                    {"A7.acceleration", 9826.520791458422}},
                                   {{"E3.fx", 199.1753333731910},
                                    {"E3.fy", -29.75531228015052},
                                    {"E4.fx", 23.06654119098399},
                                    {"E4.fy", 31.45271365475927},
                                    {"E6.fx", 22.64249232082739},
                                    {"E6.fy", 11.61740700019673},
                                    kAndrewsTorque}};

Motion andrews_motion(const PublishedState& instant) {
  const std::vector<std::string> overrides = {
      fmt::format("driver.positions=[\"{} rad\", \"{} rad\"]", kAndrewsStart.crank, instant.crank),
      fmt::format("driver.velocity=\"{} rad/s\"", instant.velocity),
      fmt::format("driver.acceleration=\"{} rad/s^2\"", instant.acceleration)};
  RunSettings settings;
  settings.forces = true;
  settings.units = kSiUnits;
  return testing::shipped_model("squeezing_mechanism", overrides).run(settings).value();
}

void expect_published(const Motion& motion, const std::vector<PublishedValue>& published, double tolerance) {
  for (const PublishedValue& one : published) {
    EXPECT_NEAR(motion.column(one.column)[motion.size() - 1], one.value, tolerance) << one.column;
  }
}

TEST(SqueezingMechanism, StartsAsPublished) {
  const Motion motion = andrews_motion(kAndrewsStart);
  EXPECT_TRUE(motion.good());
  expect_published(motion, kAndrewsStart.positions, 2e-15);
  expect_published(motion, kAndrewsStart.accelerations, 1e-11);
  expect_published(motion, kAndrewsStart.efforts, 1e-12);
}

// The published velocities satisfy the equations of the loops to 1e-8 of what they are only, the
// accelerations and forces to 1e-6: they come from steps in time. The positions have all their digits.
TEST(SqueezingMechanism, IsAfterTwoAndAHalfTurnsWherePublished) {
  const Motion motion = andrews_motion(kAndrewsLater);
  EXPECT_TRUE(motion.good());
  expect_published(motion, kAndrewsLater.positions, 5e-15);
  expect_published(motion, kAndrewsLater.velocities, 4e-8);
  expect_published(motion, kAndrewsLater.accelerations, 0.1);
  expect_published(motion, kAndrewsLater.efforts, 2e-5);
  expect_published(motion, {kAndrewsTorque}, 3e-9);
}

}  // namespace
}  // namespace higherpair

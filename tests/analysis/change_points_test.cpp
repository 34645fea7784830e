// What rows next to a change point have beyond accelerations, and starts there: against closed forms of
// parallelogram, antiparallelogram and kite.
#include "equal_discs.hpp"
#include "higherpair/analysis/derivatives.hpp"
#include "higherpair/analysis/jerk.hpp"
#include "higherpair/analysis/sensitivity.hpp"
#include "higherpair/mechanism/numbers.hpp"
#include "io/profile_testing.hpp"
#include "run_testing.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::Complex;

constexpr double kFrame = 0.37;
constexpr double kCrank = 0.13;
constexpr std::array kDistances = {1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6, 1e-7};

// A linkage on a frame of 0.37 m with a crank of 0.13 m, in the pose in which its rocker has an angle. The
// crank is at π + `driver`, where parallelogram, antiparallelogram and kite have a change point.
struct Linkage {
  double rod = kFrame, rocker = kCrank;

  [[nodiscard]] Profile posed(double driver, double rocker_angle) const {
    const Complex A = std::polar(kCrank, kPi + driver), B = kFrame + std::polar(rocker, rocker_angle);
    return testing::read(fmt::format(R"(units = {{ length = "m", angle = "rad" }}
[bodies.ground]
points = {{ O = [0, 0], Q = [{0}, 0] }}
[bodies.crank]
pose = {{ angle = {1} }}
points = {{ O = [0, 0], A = [{2}, 0] }}
[bodies.rod]
pose = {{ x = {3}, y = {4}, angle = {5} }}
points = {{ A = [0, 0], B = [{6}, 0] }}
[bodies.rocker]
pose = {{ x = {0}, angle = {7} }}
points = {{ Q = [0, 0], B = [{8}, 0] }}
[joints]
o = {{ type = "revolute", between = ["ground.O", "crank.O"] }}
a = {{ type = "revolute", between = ["crank.A", "rod.A"] }}
b = {{ type = "revolute", between = ["rod.B", "rocker.B"] }}
q = {{ type = "revolute", between = ["ground.Q", "rocker.Q"] }}
[driver]
joint = "o"
)",
                                     kFrame, kPi + driver, kCrank, A.real(), A.imag(), std::arg(B - A), rod,
                                     rocker_angle, rocker));
  }
};

constexpr Linkage kParallelogram{};
constexpr Linkage kKite{kCrank, kFrame};
constexpr int kRocker = 3;

// Of the antiparallelogram, tan((rocker - π)/2) = -k tan(driver/2) with k = (frame - crank)/(frame + crank).
double crossed_rocker(double driver) {
  return kPi - 2 * std::atan((kFrame - kCrank) / (kFrame + kCrank) * std::tan(driver / 2));
}

// The k-th derivative of Σ ratio^n cos(n driver) from n = 1.
double cosines(double ratio, double driver, int k) {
  double sum = 0, power = ratio;
  for (int n = 1; n < 200; ++n) {
    sum += power * std::pow(n, k) * std::cos(n * driver + k * kPi / 2);
    power *= ratio;
  }
  return sum;
}

// The k-th derivative of the rocker's angle by the crank's: that angle's rate is a Poisson kernel.
double crossed_rate(double driver, int k) {
  const double ratio = -kCrank / kFrame;
  return (k == 1 ? -1 : 0) - 2 * cosines(ratio, driver, k - 1);
}

// The kite is symmetric about the line from the crank's pin to the rocker's pivot.
double kite_rocker(double driver) {
  return 2 * std::arg(std::polar(kCrank, kPi + driver) - kFrame) - kPi;
}
double kite_rate(double driver, int k) {
  return -2 * cosines(-kCrank / kFrame, driver, k - 1);
}

Run started(const Profile& profile, double driver) {
  auto run = start_run(profile.mechanism, {kPi + driver});
  EXPECT_TRUE(run) << (run ? "" : run.error().reason);
  return *std::move(run);
}

// Calls f with a run at rows on both sides of the change point, and the driver's motion there.
template <class F>
void for_each_row(Run run, double velocity, double acceleration, F f) {
  for (const double side : {-1.0, 1.0}) {
    for (std::size_t i = 0; i < kDistances.size(); ++i) {
      const double driver = side * kDistances[side < 0 ? i : kDistances.size() - 1 - i];
      SCOPED_TRACE(driver);
      const std::vector<DriverMotion> motions{{kPi + driver, velocity, acceleration}};
      move_to(run, motions);
      ASSERT_EQ(run.row.status, RowStatus::kOk);
      f(run, motions, driver);
    }
  }
}

// Derivatives by time are those by the crank's angle for a unit velocity.
template <class F>
void expect_derivatives(const Run& run, F rate) {
  for_each_row(run, 1, 0, [&](const Run& at, const std::vector<DriverMotion>& motions, double driver) {
    const auto bodies = derivatives_of(at, motions, 6);
    ASSERT_TRUE(bodies);
    for (int k = 3; k <= 6; ++k) {
      const double expected = rate(driver, k);
      EXPECT_NEAR((*bodies)[kRocker].theta[k], expected, 1e-7 * std::max(std::abs(expected), 0.1)) << k;
    }
    const auto jerk = jerks_of(at).bodies[kRocker];
    ASSERT_TRUE(jerk);
    EXPECT_NEAR(jerk->angular, rate(driver, 3), 1e-9);
  });
}

TEST(NextToChangePoints, HigherDerivativesOfAParallelogramAreThoseOfItsCrank) {
  expect_derivatives(started(kParallelogram.posed(-0.3, kPi - 0.3), -0.3), [](double, int) { return 0.0; });
}

TEST(NextToChangePoints, HigherDerivativesOfAnAntiparallelogramAreThoseOfItsClosedForm) {
  expect_derivatives(started(kParallelogram.posed(-0.3, crossed_rocker(-0.3)), -0.3), crossed_rate);
}

TEST(NextToChangePoints, HigherDerivativesOfAKiteAreThoseOfItsClosedForm) {
  expect_derivatives(started(kKite.posed(-0.3, kite_rocker(-0.3)), -0.3), kite_rate);
}

// With the crank at velocity v and acceleration a the jerk is f''' v³ + 3 f'' v a; at rest all depends on a.
TEST(NextToChangePoints, HigherDerivativesFollowTheDriversMotion) {
  const higherpair::Run run = started(kKite.posed(-0.3, kite_rocker(-0.3)), -0.3);
  for (const double v : {0.0, -1.7}) {
    const double a = 2.3;
    for_each_row(
        run, v, a, [&](const higherpair::Run& at, const std::vector<DriverMotion>& motions, double driver) {
          const auto bodies = derivatives_of(at, motions, 4);
          ASSERT_TRUE(bodies);
          const double f2 = kite_rate(driver, 2), f3 = kite_rate(driver, 3), f4 = kite_rate(driver, 4);
          EXPECT_NEAR((*bodies)[kRocker].theta[3], f3 * v * v * v + 3 * f2 * v * a, 1e-7);
          EXPECT_NEAR((*bodies)[kRocker].theta[4], f4 * std::pow(v, 4) + 6 * f3 * v * v * a + 3 * f2 * a * a,
                      1e-7);
        });
  }
}

// Discs with equal eccentricities turn like the cranks of a parallelogram.
TEST(NextToChangePoints, JerksOfContactsAreRight) {
  const Profile profile = testing::read(testing::kEqualDiscs);
  auto run = start_run(profile.mechanism, {kPi / 2});
  ASSERT_TRUE(run);
  for (const double distance : kDistances) {
    SCOPED_TRACE(distance);
    move_to(*run, {{kPi - distance, 3, 0}});
    ASSERT_EQ(run->row.status, RowStatus::kOk);
    for (const auto& jerks : {jerks_of(*run).bodies, jerks_of(*run).linkage, true_jerks_of(*run)}) {
      ASSERT_TRUE(jerks[2]);
      EXPECT_NEAR(jerks[2]->angular, 0, 1e-7);
    }
  }
}

// Where a frame is too long by less than shows in the residual, the derivatives next to where the branches
// nearly cross are nothing but that error, divided by a power of the distance.
TEST(NextToChangePoints, HigherDerivativesAreLeftOutWhereRoundingDecidesThem) {
  Profile profile = kParallelogram.posed(-0.3, crossed_rocker(-0.3));
  profile.mechanism.bodies[0].points[1].p_B.x() += 1e-11;
  auto run = started(profile, -0.3);
  for (const double distance : {0.3, 0.2, 3e-3, 1e-3}) {
    const std::vector<DriverMotion> motions{{kPi - distance, 1, 0}};
    move_to(run, motions);
    ASSERT_EQ(run.row.status, RowStatus::kOk);
    EXPECT_EQ(derivatives_of(run, motions, 6).has_value(), distance > 0.1) << distance;
    EXPECT_EQ(jerks_of(run).bodies[kRocker].has_value(), distance > 0.1) << distance;
  }
}

// At a limit derivatives grow without bounds, as half-integer powers of the distance.
TEST(NextToLimits, HigherDerivativesAreThoseOfARoot) {
  const Linkage linkage{0.25, 0.08};  // the crank cannot turn fully
  const double limit = std::acos((kFrame * kFrame + kCrank * kCrank - 0.33 * 0.33) / (2 * kFrame * kCrank));
  const Profile profile = linkage.posed(limit - 0.2 - kPi, kPi);
  auto run = start_run(profile.mechanism, {limit - 0.2});
  ASSERT_TRUE(run) << run.error().reason;
  std::array<double, 2> jerk{}, sixth{};
  for (const std::size_t i : {0, 1}) {
    const std::vector<DriverMotion> motions{{limit - (i == 0 ? 4e-6 : 1e-6), 1, 0}};
    move_to(*run, motions);
    ASSERT_EQ(run->row.status, RowStatus::kOk);
    const auto bodies = derivatives_of(*run, motions, 6);
    ASSERT_TRUE(bodies);
    jerk[i] = (*bodies)[kRocker].theta[3];
    sixth[i] = (*bodies)[kRocker].theta[6];
  }
  EXPECT_NEAR(jerk[1] / jerk[0], std::pow(4, 2.5), 1e-2);
  EXPECT_NEAR(sixth[1] / sixth[0], std::pow(4, 5.5), 1);
}

// The derivative of a mechanism's numbers by the lengths of some bodies, with which their second points move.
Mechanism by_lengths(const Mechanism& mechanism, const std::vector<std::size_t>& bodies) {
  Mechanism derivative = mechanism;
  for_each_number(derivative, [](double& number) { number = 0; });
  for (const std::size_t body : bodies) {
    derivative.bodies[body].points[1].p_B.x() = 1;
  }
  return derivative;
}

TEST(NextToChangePoints, DerivativesByWhatKeepsThemAreRight) {
  const higherpair::Run start = started(kParallelogram.posed(-0.3, kPi - 0.3), -0.3);
  const auto by = Sensitivity::at_start(start, {by_lengths(start.mechanism(), {1, kRocker})}, {0});
  ASSERT_TRUE(by);
  for_each_row(start, 1, 0.5,
               [&](const higherpair::Run& at, const std::vector<DriverMotion>& motions, double driver) {
                 const auto of_row = by->of_row(at, motions, {{}});
                 ASSERT_TRUE(of_row);
                 // The rod's origin is the crank's pin.
                 const Complex u = std::polar(1.0, kPi + driver);
                 EXPECT_NEAR(of_row->bodies[2].X_WB.p_WB.x(), u.real(), 1e-10);
                 EXPECT_NEAR(of_row->bodies[2].v_WB.y(), u.real(), 1e-9);
                 EXPECT_NEAR(of_row->bodies[2].a_WB.y(), -u.imag() + 0.5 * u.real(), 1e-8);
                 EXPECT_NEAR(of_row->bodies[kRocker].theta, 0, 1e-10);
                 EXPECT_NEAR(of_row->bodies[kRocker].omega, 0, 1e-9);
                 EXPECT_NEAR(of_row->bodies[kRocker].alpha, 0, 1e-8);
               });
}

TEST(NextToChangePoints, DerivativesOfRowsThatMeetNoneAreTheSameWithoutLookingForThem) {
  const higherpair::Run start = started(kParallelogram.posed(-0.3, kPi - 0.3), -0.3);
  const auto by = Sensitivity::at_start(start, {by_lengths(start.mechanism(), {1, kRocker})}, {0});
  ASSERT_TRUE(by);
  int meet = 0, miss = 0;
  for_each_row(start, 1, 0.5,
               [&](const higherpair::Run& at, const std::vector<DriverMotion>& motions, double /*driver*/) {
                 if (meets_change_point(at, motions)) {
                   ++meet;
                   return;
                 }
                 ++miss;
                 const auto all = by->of_row(at, motions, {{}});
                 const auto regular = by->of_row(at, motions, {{}}, RatesAsked::kRegular);
                 ASSERT_TRUE(all && regular);
                 for (std::size_t body = 1; body < all->bodies.size(); ++body) {
                   EXPECT_EQ(regular->bodies[body].theta, all->bodies[body].theta);
                   EXPECT_EQ(regular->bodies[body].omega, all->bodies[body].omega);
                   EXPECT_EQ(regular->bodies[body].alpha, all->bodies[body].alpha);
                 }
               });
  EXPECT_GT(meet, 0);
  EXPECT_GT(miss, 0);
}

// By the crank's length alone the rocker's angle has the derivative -cot(crank's angle)/(rocker's length).
TEST(NextToChangePoints, DerivativesByWhatDoesAwayWithThemAreSaidToDiverge) {
  const higherpair::Run start = started(kParallelogram.posed(-0.3, kPi - 0.3), -0.3);
  const auto by = Sensitivity::at_start(start, {by_lengths(start.mechanism(), {1})}, {0});
  ASSERT_TRUE(by);
  for_each_row(start, 1, 0.5,
               [&](const higherpair::Run& at, const std::vector<DriverMotion>& motions, double driver) {
                 const auto of_row = by->of_row(at, motions, {{}});
                 if (std::abs(driver) < 1e-3) {
                   ASSERT_FALSE(of_row);
                   EXPECT_EQ(of_row.error(), NoSensitivity::kDiverges);
                 } else if (std::abs(driver) > 1e-3) {
                   ASSERT_TRUE(of_row);
                   const double cot = 1 / std::tan(driver), rise = 1 + cot * cot;
                   const BodyMotion& rocker = of_row->bodies[kRocker];
                   EXPECT_NEAR(rocker.theta * kCrank / cot, -1, 1e-8);
                   EXPECT_NEAR(rocker.omega * kCrank / rise, 1, 1e-8);
                   EXPECT_NEAR(rocker.alpha * kCrank / (rise * (0.5 - 2 * cot)), 1, 1e-7);
                 }
               });
}

TEST(StartsNextToChangePoints, AreOnTheBranchOfPosesThatAreExactEnough) {
  for (const double distance : {1e-3, 1e-5, 1e-6, 1e-7, 3e-8}) {
    SCOPED_TRACE(distance);
    for (const bool crossed : {false, true}) {
      higherpair::Run run = started(
          kParallelogram.posed(-distance, crossed ? crossed_rocker(-distance) : kPi - distance), -distance);
      for (const double driver : {-distance, 0.4}) {
        move_to(run, {{kPi + driver, 1, 0.5}});
        ASSERT_EQ(run.row.status, RowStatus::kOk);
        const double rate = crossed ? crossed_rate(driver, 1) : 1;
        EXPECT_NEAR(run.row.bodies[kRocker].omega, rate, 1e-8);
        EXPECT_NEAR(run.row.bodies[kRocker].alpha, 0.5 * rate + (crossed ? crossed_rate(driver, 2) : 0),
                    1e-6);
      }
    }
  }
}

// All bodies together turn as fast on both; those of the parallelogram without acceleration.
TEST(StartsNextToChangePoints, AreOnTheSmootherBranchWherePosesCannotTell) {
  for (const double distance : {1e-8, 0.0}) {
    const double halfway = (kPi - distance + crossed_rocker(-distance)) / 2;
    higherpair::Run run = started(kParallelogram.posed(-distance, halfway), -distance);
    move_to(run, {{kPi + 0.4, 1, 0}});
    EXPECT_NEAR(run.row.bodies[kRocker].omega, 1, 1e-12);
  }
}

// Three wheels on one rod: more conditions than coordinates. Near the change point there are positions that
// meet them to 1e-10 of the size and are no positions of the mechanism.
TEST(StartsNextToChangePoints, OfMechanismsWithMoreMembersThanTheyTakeNeedNoExactPoses) {
  constexpr const char* kWheels = R"(units = {{ length = "m", angle = "rad" }}
[bodies.ground]
points = {{ P0 = [0, 0], P1 = [0.48, 0], P2 = [1.77, 0] }}
[bodies.w0]
pose = {{ angle = {0} }}
points = {{ O = [0, 0], A = [1.45, 0] }}
[bodies.w1]
pose = {{ x = 0.48, angle = -0.00123 }}
points = {{ O = [0, 0], A = [1.45, 0] }}
[bodies.w2]
pose = {{ x = 1.77, angle = 0.00132 }}
points = {{ O = [0, 0], A = [1.45, 0] }}
[bodies.rod]
pose = {{ x = 1.45 }}
points = {{ B0 = [0, 0], B1 = [0.48, 0], B2 = [1.77, 0] }}
[joints]
p0 = {{ type = "revolute", between = ["ground.P0", "w0.O"] }}
a0 = {{ type = "revolute", between = ["w0.A", "rod.B0"] }}
p1 = {{ type = "revolute", between = ["ground.P1", "w1.O"] }}
a1 = {{ type = "revolute", between = ["w1.A", "rod.B1"] }}
p2 = {{ type = "revolute", between = ["ground.P2", "w2.O"] }}
a2 = {{ type = "revolute", between = ["w2.A", "rod.B2"] }}
[driver]
joint = "p0"
)";
  for (const double distance : {1e-3, 1e-4, 1e-5, 3e-6, 1e-6, -1e-5}) {
    SCOPED_TRACE(distance);
    const Profile profile = testing::read(fmt::format(kWheels, distance));
    auto run = start_run(profile.mechanism, {distance});
    ASSERT_TRUE(run) << run.error().reason;
    for (const double driver : {distance, 0.1, 1.0}) {
      move_to(*run, {{driver, 1, 0}});
      ASSERT_EQ(run->row.status, RowStatus::kOk);
      for (const int wheel : {2, 3}) {
        EXPECT_NEAR(run->row.bodies[wheel].theta, driver, 1e-9);
        EXPECT_NEAR(run->row.bodies[wheel].omega, 1, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace higherpair

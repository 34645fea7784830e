// Bodies that are solved together continue beyond a limit, on the branch of the same sense.
#include "driven_four_bar.hpp"
#include "io/profile_testing.hpp"
#include "run_testing.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::analyze_text;
using testing::Complex;
using testing::crank_angle;
using testing::FourBar;
using testing::replaced;
using testing::RunTable;

constexpr FourBar kUsual = {20, 50, 60, 40};

// A four-bar that is driven at the pin between crank and coupler: no body can be placed before the others.
constexpr const char* kDrivenAtTheCoupler = R"(
[units]
length = "mm"
angle = "deg"
[bodies.ground]
points.O = [0, 0]
points.C = [20, 0]
[bodies.crank]
points.O = [0, 0]
points.A = [50, 0]
[bodies.coupler]
points.A = [0, 0]
points.B = [60, 0]
[bodies.rocker]
pose = { x = 20, y = 0, angle = 60 }
points.C = [0, 0]
points.B = [40, 0]
[joints]
a = { type = "revolute", between = ["ground.O", "crank.O"] }
b = { type = "revolute", between = ["crank.A", "coupler.A"] }
c = { type = "revolute", between = ["coupler.B", "rocker.B"] }
d = { type = "revolute", between = ["ground.C", "rocker.C"] }
[driver]
joint = "b"
start = -145
end = 575
)";

// The same with discs of 15 and 25 in contact, which keep their centres 40 apart.
std::string with_discs() {
  std::string text = replaced(kDrivenAtTheCoupler, R"([bodies.rocker]
pose = { x = 20, y = 0, angle = 60 }
points.C = [0, 0]
points.B = [40, 0]
)",
                              "");
  text = replaced(text, "points.C = [20, 0]",
                  R"(curves.disc = { type = "circle", center = [20, 0], radius = 15 })");
  text = replaced(text, "points.B = [60, 0]",
                  R"(curves.disc = { type = "circle", center = [60, 0], radius = 25 })");
  text = replaced(text, R"(c = { type = "revolute", between = ["coupler.B", "rocker.B"] }
d = { type = "revolute", between = ["ground.C", "rocker.C"] }
)",
                  R"([contacts]
touch = { between = ["ground.disc", "coupler.disc"] }
)");
  return text;
}

// Driver positions at which the distance of B from O is the sum or the difference of frame and rocker.
std::vector<double> limits_between(const FourBar& bar, double from, double to) {
  const auto at = [&](double reach) {
    return std::acos((reach * reach - bar.crank * bar.crank - bar.coupler * bar.coupler) /
                     (2 * bar.crank * bar.coupler));
  };
  std::vector<double> limits;
  for (const double limit : {at(bar.rocker + bar.frame), at(bar.rocker - bar.frame)}) {
    for (const double sense : {-1.0, 1.0}) {
      for (double u = sense * limit - 4 * kPi; u < to; u += 2 * kPi) {
        if (u > from) limits.push_back(u);
      }
    }
  }
  std::sort(limits.begin(), limits.end());
  return limits;
}

double off_a_turn(double angle) {
  return std::abs(std::remainder(angle, 2 * kPi));
}

double sigma_of(const FourBar& bar, const RunTable& motion, std::size_t row) {
  const double driver = motion.radians(row, "driver"), angle = motion.radians(row, "crank.angle");
  const auto off = [&](double sigma) { return off_a_turn(*crank_angle(bar, driver, sigma) - angle); };
  return off(1) < off(-1) ? 1 : -1;
}

void expect_the_same_branch(const RunTable& motion, const FourBar& bar = kUsual) {
  ASSERT_EQ(motion.failure(), "");
  const double sigma = sigma_of(bar, motion, 0);
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double u = motion.radians(k, "driver");
    const std::optional<double> angle = crank_angle(bar, u, sigma);
    const bool at_limit =
        crank_angle(bar, u - 1e-9, 1).has_value() != crank_angle(bar, u + 1e-9, 1).has_value();
    if (at_limit) continue;
    ASSERT_EQ(motion.status(k), angle ? RowStatus::kOk : RowStatus::kNotAssemblable) << u;
    if (angle) {
      EXPECT_NEAR(off_a_turn(*angle - motion.radians(k, "crank.angle")), 0, 1e-12) << u;
    }
  }
  const std::vector<double> limits =
      limits_between(bar, motion.radians(0, "driver"), motion.radians(motion.size() - 1, "driver"));
  ASSERT_EQ(motion.events().size(), limits.size());
  for (std::size_t i = 0; i < limits.size(); ++i) {
    EXPECT_EQ(motion.events()[i].type, EventType::kLimitPosition);
    EXPECT_NEAR(motion.events()[i].driver, limits[i], 1e-13 * (1 + std::abs(limits[i])));
  }
}

TEST(CoupledBeyondLimits, AFourBarDrivenAtItsCouplerGoesOnInTheSameAssembly) {
  for (const int rows : {9, 61, 721}) {
    for (const double crank : {-60, 100}) {
      SCOPED_TRACE(fmt::format("{} rows, crank near {} degrees", rows, crank));
      expect_the_same_branch(analyze_text(
          kDrivenAtTheCoupler,
          {fmt::format("driver.samples={}", rows), fmt::format("bodies.crank.pose.angle={}", crank)}));
    }
  }
}

TEST(CoupledBeyondLimits, DiscsThatTouchGoOnAsTheLinkBetweenTheirCentres) {
  for (const int rows : {9, 61, 721}) {
    SCOPED_TRACE(rows);
    expect_the_same_branch(analyze_text(with_discs(), {fmt::format("driver.samples={}", rows)}));
  }
}

// The gap from 120 to 240 degrees is a whole multiple of the step with which the branch is looked for.
TEST(CoupledBeyondLimits, AStretchMayBeginWhereItIsLookedFor) {
  const FourBar bar{20, 50, 50, 30};
  for (const int rows : {9, 61, 541}) {
    SCOPED_TRACE(rows);
    expect_the_same_branch(
        analyze_text(
            kDrivenAtTheCoupler,
            {"driver.start=150", "driver.end=690", fmt::format("driver.samples={}", rows),
             "bodies.coupler.points.B.0=50", "bodies.rocker.points.B.0=30", "bodies.crank.pose.angle=-60"}),
        bar);
  }
}

TEST(CoupledBeyondLimits, ARowMayBeAtTheBeginOfAStretch) {
  const double limit = limits_between(kUsual, 0, kPi)[0] * (180 / kPi);
  for (const double beyond : {0.0, 1e-9, 1e-8, 1e-7, 1e-5}) {
    SCOPED_TRACE(beyond);
    const RunTable motion =
        analyze_text(kDrivenAtTheCoupler, {fmt::format("driver.positions=[-145,0,{}]", limit + beyond)});
    ASSERT_EQ(motion.failure(), "");
    EXPECT_EQ(motion.status(2), beyond > 0 ? RowStatus::kOk : RowStatus::kSingular);
    ASSERT_EQ(motion.events().size(), 2U);
    EXPECT_NEAR(motion.events()[1].driver, limit * (kPi / 180), 1e-12);
    if (beyond > 1e-6) {
      EXPECT_EQ(sigma_of(kUsual, motion, 2), sigma_of(kUsual, motion, 0));
    }
  }
}

// The same mechanism 3 m from the origin, with its bodies described in ground's frame.
TEST(CoupledBeyondLimits, BodiesMayBeFarFromTheOriginsOfTheirFrames) {
  const RunTable near =
      analyze_text(kDrivenAtTheCoupler, {"driver.samples=61", "bodies.crank.pose.angle=-60"});
  const auto place = [&](const char* name) {
    const Complex p = near.vector(0, name) + Complex(3000, -2000);
    return fmt::format("[{}, {}]", p.real(), p.imag());
  };
  const std::string O = "[3000, -2000]", C = "[3020, -2000]", A = place("crank.A."), B = place("coupler.B.");
  const RunTable far = analyze_text(
      kDrivenAtTheCoupler,
      {"driver.samples=61", "bodies.ground.points={O=" + O + ",C=" + C + "}",
       "bodies.crank.points={O=" + O + ",A=" + A + "}", "bodies.coupler.points={A=" + A + ",B=" + B + "}",
       "bodies.rocker.points={C=" + C + ",B=" + B + "}", "bodies.rocker.pose={x=0,y=0,angle=0}",
       "driver.start=0", "driver.end=720"});
  ASSERT_EQ(far.failure(), "");
  for (std::size_t k = 0; k < near.size(); ++k) {
    ASSERT_EQ(far.status(k), near.status(k)) << k;
    if (near.status(k) == RowStatus::kOk) {
      EXPECT_NEAR(std::abs(far.vector(k, "crank.A.") - near.vector(k, "crank.A.") - Complex(3000, -2000)), 0,
                  1e-9);
    }
  }
}

// A slider-crank of 20 and 60 that is driven at the pin of its crank; the slide ends at 50 from O.
TEST(CoupledBeyondLimits, AJointsEndIsWhereStretchesEndAndBegin) {
  constexpr const char* kDrivenAtThePin = R"(
[bodies.ground]
points.O = [0, 0]
[bodies.crank]
pose = { angle = 60 }
points = { O = [0, 0], A = [20, 0] }
[bodies.rod]
pose = { x = 10, y = 17.3, angle = -16.8 }
points = { A = [0, 0], B = [60, 0] }
[bodies.piston]
pose = { x = 67.4 }
points.B = [0, 0]
[joints]
a = { type = "revolute", between = ["ground.O", "crank.O"] }
b = { type = "revolute", between = ["crank.A", "rod.A"] }
c = { type = "revolute", between = ["rod.B", "piston.B"] }
d = { type = "prismatic", between = ["ground.O", "piston.B"], direction = [1, 0], from = 50 }
[driver]
joint = "b"
start = -77
end = 643
)";
  const double end = std::acos((50.0 * 50 - 20 * 20 - 60 * 60) / (2 * 20 * 60));
  for (const int rows : {19, 73}) {
    SCOPED_TRACE(rows);
    const RunTable motion = analyze_text(kDrivenAtThePin, {fmt::format("driver.samples={}", rows)});
    ASSERT_EQ(motion.failure(), "");
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double u = motion.radians(k, "driver");
      const double reach = std::abs(20.0 + 60.0 * std::polar(1.0, u));
      ASSERT_EQ(motion.status(k), reach > 50 ? RowStatus::kOk : RowStatus::kNotAssemblable) << u;
      if (reach > 50) {
        EXPECT_NEAR(motion.value(k, "piston.x"), reach, 1e-11);
      }
    }
    std::vector<double> ends;
    for (const RunEvent& event : motion.events()) {
      if (event.type == EventType::kEnd) ends.push_back(event.driver);
    }
    ASSERT_EQ(ends.size(), 4U);
    for (const double at : ends) EXPECT_NEAR(off_a_turn(at), end, 1e-11);
  }
}

// With two more rockers, parallel to the first, there are more conditions than coordinates: no sign tells the
// assemblies apart, and none is taken for the one that was lost.
TEST(CoupledBeyondLimits, WithConditionsInSurplusNothingIsTakenUp) {
  constexpr const char* kThreeRockers = R"(
[bodies.ground]
points = { O = [0, 0], C = [20, 0], C2 = [30, 0], C3 = [45, 0] }
[bodies.crank]
pose = { angle = -2 }
points = { O = [0, 0], A = [50, 0] }
[bodies.coupler]
pose = { x = 50, y = -1.8, angle = -147 }
points = { A = [0, 0], B = [60, 0] }
[bodies.rocker]
pose = { x = 20, angle = -120.6 }
points = { C = [0, 0], B = [40, 0] }
[bodies.rocker2]
pose = { x = 30, angle = -120.6 }
points = { C = [0, 0], B = [40, 0] }
[bodies.rocker3]
pose = { x = 45, angle = -120.6 }
points = { C = [0, 0], B = [40, 0] }
[bodies.plate]
pose = { x = -0.4, y = -34.4 }
points = { B = [0, 0], B2 = [10, 0], B3 = [25, 0] }
[joints]
a = { type = "revolute", between = ["ground.O", "crank.O"] }
b = { type = "revolute", between = ["crank.A", "coupler.A"] }
c = { type = "revolute", between = ["coupler.B", "plate.B"] }
c1 = { type = "revolute", between = ["rocker.B", "plate.B"] }
c2 = { type = "revolute", between = ["rocker2.B", "plate.B2"] }
c3 = { type = "revolute", between = ["rocker3.B", "plate.B3"] }
d1 = { type = "revolute", between = ["ground.C", "rocker.C"] }
d2 = { type = "revolute", between = ["ground.C2", "rocker2.C"] }
d3 = { type = "revolute", between = ["ground.C3", "rocker3.C"] }
[driver]
joint = "b"
start = -145
end = 215
)";
  const RunTable motion = analyze_text(kThreeRockers);
  ASSERT_EQ(motion.failure(), "");
  const double limit = limits_between(kUsual, -kPi, 0).back();
  EXPECT_GT(motion.count(RowStatus::kOk), 10U);
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const bool before = motion.radians(k, "driver") < limit;
    EXPECT_EQ(motion.status(k), before ? RowStatus::kOk : RowStatus::kNotAssemblable) << k;
  }
}

}  // namespace
}  // namespace higherpair

// Bodies that are solved together go on beyond a limit, on the branch of the same sense.
#include "io/profile_testing.hpp"
#include "run_testing.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::analyze_text;
using testing::Complex;
using testing::replaced;
using testing::RunTable;

constexpr double kFrame = 20, kCrank = 50, kCoupler = 60, kRocker = 40;  // mm

// A four-bar that is driven at the pin of crank and coupler: no body can be placed before the others.
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

// The same, but discs of 15 and 25 that touch keep their centres 40 apart.
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

// Seen from the crank the end B of the coupler is on a circle about A, and the frame's pin C on one about O:
// the angle from the frame to the crank in either assembly, σ = ±1, where there is one.
std::optional<double> crank_angle(double driver, double sigma) {
  const Complex B = kCrank + kCoupler * std::polar(1.0, driver);
  const double cosine = (std::norm(B) + kFrame * kFrame - kRocker * kRocker) / (2 * kFrame * std::abs(B));
  if (std::abs(cosine) > 1) return std::nullopt;
  return -(std::arg(B) + sigma * std::acos(cosine));
}

// Drivers at which B is as far from O as frame and rocker in one line reach, or as near.
std::vector<double> limits_between(double from, double to) {
  const auto at = [](double reach) {
    return std::acos((reach * reach - kCrank * kCrank - kCoupler * kCoupler) / (2 * kCrank * kCoupler));
  };
  std::vector<double> limits;
  for (const double limit : {at(kRocker + kFrame), at(kRocker - kFrame)}) {
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

void expect_the_same_branch(const RunTable& motion) {
  ASSERT_EQ(motion.failure(), "");
  const auto first = [&](double sigma) {
    return off_a_turn(*crank_angle(motion.radians(0, "driver"), sigma) - motion.radians(0, "crank.angle"));
  };
  const double sigma = first(1) < first(-1) ? 1 : -1;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double u = motion.radians(k, "driver");
    const std::optional<double> angle = crank_angle(u, sigma);
    ASSERT_EQ(motion.status(k), angle ? RowStatus::kOk : RowStatus::kNotAssemblable) << u;
    if (angle) {
      EXPECT_NEAR(off_a_turn(*angle - motion.radians(k, "crank.angle")), 0, 1e-12) << u;
    }
  }
  const std::vector<double> limits =
      limits_between(motion.radians(0, "driver"), motion.radians(motion.size() - 1, "driver"));
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

}  // namespace
}  // namespace higherpair

// Higher derivatives from the conditions differentiated k times, compared with closed forms, with the jerk
// that is computed by other means, and with differences of the next lower derivative.
#include "higherpair/analysis/derivatives.hpp"

#include "analysis/run_testing.hpp"
#include "higherpair/analysis/jerk.hpp"
#include "io/profile_testing.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::shipped;

Run started(const Profile& profile) {
  std::vector<double> drivers;
  for (const DriverProgram& program : profile.programs) {
    const Joint& joint = profile.mechanism.joints[profile.mechanism.drivers[drivers.size()].joint];
    const Dimension dimension = has_angle(joint.type) ? dimension::kAngle : dimension::kLength;
    drivers.push_back(to_si(dimension, profile.units).apply(program.start));
  }
  auto run = start_run(profile.mechanism, drivers);
  EXPECT_TRUE(run) << run.error().reason;
  return *std::move(run);
}

std::size_t body_index(const Run& run, const std::string& name) {
  std::size_t i = 0;
  while (run.mechanism().bodies.at(i).name != name) {
    ++i;
  }
  return i;
}

// A cam that turns about the origin and lifts a flat-faced follower, which starts at a height.
Profile flat_follower_on(const std::string& curve, int height, const std::string& units = "") {
  return testing::read(fmt::format(R"({}[bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O   = [0, 0]
curves.cam = {}
[bodies.follower]
pose        = {{ y = {} }}
points.P    = [0, 0]
curves.face = {{ type = "line", point = [0, 0], normal = [0, -1] }}
[joints]
cam_pivot = {{ type = "revolute", between = ["ground.O", "cam.O"] }}
guide = {{ type = "prismatic", between = ["ground.O", "follower.P"], direction = [0, 1] }}
[contacts.touch]
between = ["cam.cam", "follower.face"]
[driver]
joint = "cam_pivot"
)",
                                   units, curve, height));
}

// A sinusoidal lift at a constant rate: y = 30 + 10 sin(u) mm.
TEST(Derivatives, OfAFlatFollowerOnAnEccentricDiscAreThoseOfASine) {
  const Profile profile = flat_follower_on(R"({ type = "circle", center = [10, 0], radius = 30 })", 30);

  auto run = started(profile);
  const double w = 3;
  for (const double u : {0.2, 1.9, 4.4}) {
    const std::vector<DriverMotion> drivers{{u, w, 0}};
    move_to(run, drivers);
    const auto bodies = derivatives_of(run, drivers, 6);
    ASSERT_TRUE(bodies);
    const BodyDerivatives& follower = bodies->at(body_index(run, "follower"));
    for (int k = 1; k <= 6; ++k) {
      const double expected = 0.01 * std::pow(w, k) * std::sin(u + k * kPi / 2);
      EXPECT_NEAR(follower.p_WB[k].y(), expected, 1e-15 * std::pow(w, k));
      EXPECT_NEAR(follower.theta[k], 0, 1e-13);
    }
  }
}

// The ellipse 2 x 1 about its centre under a flat follower: s = sqrt(4 sin^2 u + cos^2 u). Its derivatives
// from a power series, by hand: s^2 = g gives s s_k = (g_k - sum of products)/2.
TEST(Derivatives, OfAFlatFollowerOnAnEllipseAreThoseOfItsSupport) {
  const Profile profile = flat_follower_on(R"({ type = "ellipse", center = [0, 0], semi_axes = [2, 1] })", 1,
                                           "units = { length = \"m\", angle = \"rad\" }\n");

  auto run = started(profile);
  for (const double u : {kPi / 12, 1.0, 2.6}) {
    const std::vector<DriverMotion> drivers{{u, 1, 0}};
    move_to(run, drivers);
    const auto bodies = derivatives_of(run, drivers, 6);
    ASSERT_TRUE(bodies);
    // g = 5/2 - 3/2 cos 2u.
    std::array<double, 7> g{}, s{};
    double factorial = 1;
    for (std::size_t k = 0; k < g.size(); ++k) {
      factorial *= k == 0 ? 1 : static_cast<double>(k);
      const auto order = static_cast<double>(k);
      g[k] = ((k == 0 ? 2.5 : 0) - 1.5 * std::pow(2, order) * std::cos(2 * u + order * kPi / 2)) / factorial;
      double sum = g[k];
      for (std::size_t i = 1; i < k; ++i) {
        sum -= s[i] * s[k - i];
      }
      s[k] = k == 0 ? std::sqrt(g[0]) : sum / (2 * s[0]);
      EXPECT_NEAR(bodies->at(2).p_WB[k].y(), s[k] * factorial, 1e-12 * (1 + std::abs(s[k] * factorial)));
    }
  }
  // The jerk at 15 degrees.
  const std::vector<DriverMotion> drivers{{kPi / 12, 1, 0}};
  move_to(run, drivers);
  EXPECT_NEAR(derivatives_of(run, drivers, 3)->at(2).p_WB[3].y(), -6.378404883307, 1e-12);
}

// Position, velocity and acceleration as the run has them, and the jerk as --jerk gives it, in all shipped
// profiles: two derivations that share nothing but the mechanism.
TEST(Derivatives, AgreeWithTheRowAndItsJerk) {
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(HIGHERPAIR_SOURCE_DIR "/profiles")) {
    if (entry.path().extension() != ".toml") {
      continue;
    }
    const Profile profile = shipped(entry.path().stem().string());
    auto run = started(profile);
    std::vector<DriverMotion> drivers;
    for (const double start : run.at.inputs) {
      drivers.push_back({start + 0.021, 1.3, -0.7});
    }
    move_to(run, drivers);
    if (run.row.status != RowStatus::kOk) {
      continue;
    }
    const auto bodies = derivatives_of(run, drivers, 3);
    ASSERT_TRUE(bodies) << entry.path();
    const JerkRow jerks = jerks_of(run);
    for (std::size_t i = 1; i < bodies->size(); ++i) {
      const BodyDerivatives& body = (*bodies)[i];
      const BodyMotion& row = run.row.bodies[i];
      const double size = run.plan().size;
      const double scale = 1 + std::abs(body.theta[2]) + std::abs(body.theta[3]) + body.p_WB[3].norm() / size;
      EXPECT_NEAR((body.p_WB[1] - row.v_WB).norm(), 0, 1e-11 * size * scale) << entry.path();
      EXPECT_NEAR(body.theta[1], row.omega, 1e-11 * scale) << entry.path();
      EXPECT_NEAR((body.p_WB[2] - row.a_WB).norm(), 0, 1e-10 * size * scale) << entry.path();
      EXPECT_NEAR(body.theta[2], row.alpha, 1e-10 * scale) << entry.path();
      ASSERT_TRUE(jerks.bodies[i]) << entry.path();
      EXPECT_NEAR((body.p_WB[3] - jerks.bodies[i]->j_WB).norm(), 0, 1e-9 * size * scale) << entry.path();
      EXPECT_NEAR(body.theta[3], jerks.bodies[i]->angular, 1e-9 * scale) << entry.path();
      ++compared;
    }
  }
  EXPECT_GT(compared, 60);
}

// A cam made from a law gives its follower the law, a cycloid over 120 degrees:
// s = h (x/b - sin(2 pi x/b)/(2 pi)).
TEST(Derivatives, OfAFollowerOfALawAreThoseOfTheLaw) {
  auto run = started(shipped("law_cam_roller"));
  const double h = 0.02, b = 2 * kPi / 3, w = 2 * kPi / b;
  for (const double u : {0.1, 0.58, 1.2, 1.9}) {
    const std::vector<DriverMotion> drivers{{u, 1, 0}};
    move_to(run, drivers);
    const auto bodies = derivatives_of(run, drivers, 6);
    ASSERT_TRUE(bodies);
    const BodyDerivatives& follower = bodies->at(body_index(run, "follower"));
    for (int k = 2; k <= 6; ++k) {
      const double expected = -h / b * std::pow(w, k - 1) * std::cos(w * u + (k - 1) * kPi / 2);
      EXPECT_NEAR(follower.p_WB[k].y(), expected, 1e-10 * h * std::pow(w, k)) << u << " " << k;
    }
  }
}

// Involute flanks turn the wheel at a constant ratio.
TEST(Derivatives, OfAWheelOnInvolutesAreThoseOfAConstantRatio) {
  auto run = started(shipped("gear_teeth"));
  const std::vector<DriverMotion> drivers{{0.09, 1, 0}};
  move_to(run, drivers);
  const auto bodies = derivatives_of(run, drivers, 6);
  ASSERT_TRUE(bodies);
  const BodyDerivatives& wheel = bodies->at(body_index(run, "wheel"));
  EXPECT_NEAR(wheel.theta[1], -0.5, 1e-14);
  for (std::size_t k = 2; k <= 6; ++k) {
    EXPECT_NEAR(wheel.theta[k], 0, 1e-8) << k;
  }
}

// The (k+1)th derivative against central differences of the kth along the motion.
void expect_rates_of_those_below(Run& run, double at_start, double tolerance) {
  const double h = 1e-3;
  const auto at = [&](double u) {
    const std::vector<DriverMotion> drivers{{u, 1, 0}};
    move_to(run, drivers);
    EXPECT_EQ(run.row.status, RowStatus::kOk);
    return derivatives_of(run, drivers, 6).value();
  };
  const auto before2 = at(at_start - 2 * h), before = at(at_start - h), here = at(at_start);
  const auto after = at(at_start + h), after2 = at(at_start + 2 * h);
  const auto expect_rate = [&](const auto& quantity) {
    double largest = 1;
    for (std::size_t k = 0; k <= 6; ++k) {
      largest = std::max(largest, std::abs(quantity(here, k)));
    }
    for (std::size_t k = 2; k < 6; ++k) {
      const double rate =
          (8 * (quantity(after, k) - quantity(before, k)) - (quantity(after2, k) - quantity(before2, k))) /
          (12 * h);
      EXPECT_NEAR(quantity(here, k + 1), rate, tolerance * largest) << k;
    }
  };
  for (std::size_t body = 1; body < here.size(); ++body) {
    expect_rate([&](const auto& bodies, std::size_t k) { return bodies[body].theta[k]; });
    expect_rate(
        [&](const auto& bodies, std::size_t k) { return bodies[body].p_WB[k].y() / run.plan().size; });
  }
}

TEST(Derivatives, AreTheRatesOfThoseBelow) {
  for (const char* name : {"ellipse_cam_roller", "watt_sixbar", "rolling_ellipses", "cam_chain", "spline_cam",
                           "law_cam_flat", "groove_cam", "valve_train", "four_arc_cam"}) {
    SCOPED_TRACE(name);
    auto run = started(shipped(name));
    expect_rates_of_those_below(run, run.at.inputs.front() + 0.4, 1e-6);
  }
}

TEST(Derivatives, AreTheRatesOfThoseBelowOnOffsetsOfASpline) {
  const std::string rest = R"(
[bodies.follower]
pose = { x = 0, y = 60 }
points.P = [0, 0]
curves.roller = { type = "circle", center = [0, 0], radius = 4 }
[joints]
pivot = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.O", "follower.P"], direction = [0.1, 1] }
[contacts.touch]
between = ["cam.outline", "follower.roller"]
approach = "-"
[driver]
joint = "pivot"
)";
  const std::string start = R"([bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
)";
  const std::string points =
      "points = [[40, 0], [30, 21], [21, 34], [0, 31], [-19, 33], [-31, 20], [-38, 0], [-29, -20], [-20, "
      "-34], "
      "[0, -30], [21, -33], [29, -21]], closed = true";
  const std::string spline = "curves.spline = { type = \"spline\", " + points + " }\n";
  for (const std::string& outline :
       {spline + "curves.outline = { type = \"offset\", of = \"spline\", by = 3 }",
        spline + "curves.outline = { type = \"offset\", of = \"spline\", by = -3 }"}) {
    SCOPED_TRACE(outline);
    auto run = started(testing::read(start + outline + rest));
    for (const double u : {0.15, 0.7, 1.31, 2.9}) {
      expect_rates_of_those_below(run, u, 1e-5);
    }
  }
}

TEST(Derivatives, OfAPointAreThoseOfACircle) {
  auto run = started(shipped("four_bar"));
  const std::vector<DriverMotion> drivers{{0.7, 2, 0}};
  move_to(run, drivers);
  const auto bodies = derivatives_of(run, drivers, 6).value();
  const std::size_t crank = body_index(run, "crank");
  const double angle = bodies[crank].theta[0];
  for (int k = 0; k <= 6; ++k) {
    const Vector2d point = point_derivative(bodies[crank], {0.02, 0}, k);
    const Vector2d expected = 0.02 * std::pow(2, k) * unit_vector(angle + k * kPi / 2);
    EXPECT_NEAR((point - expected).norm(), 0, 1e-14 * std::pow(2, k));
  }
}

TEST(Derivatives, AreNotDefinedWhereTheMechanismIsSingular) {
  // A parallelogram with all links in line.
  auto run = started(shipped("parallelogram"));
  const std::vector<DriverMotion> drivers{{0, 1, 0}};
  move_to(run, drivers);
  const auto here = derivatives_of(run, drivers, 3);
  move_to(run, {{0.5, 1, 0}});
  EXPECT_FALSE(here);
  EXPECT_TRUE(derivatives_of(run, {{0.5, 1, 0}}, 3));
}

}  // namespace
}  // namespace higherpair

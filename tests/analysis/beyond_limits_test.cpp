// Where a motion ends, and where it continues beyond that, does not depend on the spacing of the rows.
#include "coupled_cranks.hpp"
#include "io/profile_testing.hpp"
#include "run_testing.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::analyze_text;
using testing::replaced;
using testing::RunTable;

// A slide carries an arm of 6 along a line 1 off the middle of a ring of 10, which the tip of the arm touches
// from within: possible while the pivot is at least 4 from the middle.
constexpr const char* kArmInARing = R"(
[bodies.ground]
points.O = [0, 1]
curves.ring = { type = "circle", center = [0, 0], radius = 10, side = "outside" }
[bodies.cart]
pose = { x = -8, y = 1 }
points.O = [0, 0]
[bodies.arm]
pose = { x = -8, y = 1, angle = 100 }
points.O = [0, 0]
curves.tip = { type = "point", at = [6, 0] }
[joints]
slide = { type = "prismatic", between = ["ground.O", "cart.O"], direction = 0 }
pivot = { type = "revolute", between = ["cart.O", "arm.O"] }
[contacts]
touch = { between = ["ground.ring", "arm.tip"] }
[driver]
joint = "slide"
start = -8
end = 8
)";

std::vector<double> limits_of(const RunTable& motion) {
  std::vector<double> found;
  for (const RunEvent& event : motion.events()) {
    EXPECT_EQ(event.type, EventType::kLimitPosition);
    found.push_back(event.driver);
  }
  return found;
}

// NaN where there is none or more than one.
double only_limit_of(const RunTable& motion) {
  std::vector<double> found;
  for (const RunEvent& event : motion.events()) {
    if (event.type == EventType::kLimitPosition) found.push_back(event.driver);
  }
  return found.size() == 1 ? found[0] : std::nan("");
}

TEST(BeyondLimits, AContactIsFoundAgainFromAnyRow) {
  for (const int rows : {9, 17, 65, 641}) {
    SCOPED_TRACE(rows);
    const RunTable motion = analyze_text(kArmInARing, {fmt::format("driver.samples={}", rows)});
    ASSERT_EQ(motion.failure(), "");
    const std::vector<double> limits = limits_of(motion);
    ASSERT_EQ(limits.size(), 2U);
    EXPECT_NEAR(limits[0], -std::sqrt(15) / 1000, 1e-12);
    EXPECT_NEAR(limits[1], std::sqrt(15) / 1000, 1e-12);
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double u = motion.value(k, "driver");
      const bool reaches = std::abs(u) > std::sqrt(15);
      EXPECT_EQ(motion.status(k), reaches ? RowStatus::kOk : RowStatus::kNotAssemblable) << u;
      if (reaches) {
        const double angle = motion.radians(k, "arm.angle");
        EXPECT_NEAR(std::hypot(u + 6 * std::cos(angle), 1 + 6 * std::sin(angle)), 10, 1e-11);
      }
    }
  }
}

// Two cranks of 30 mm, each driven, the second three times as fast and backwards. Two links of 45.5 mm can
// join their tips in three stretches of the turn, the shortest of which is half a degree long.
constexpr const char* kDrivenCranks = R"(
[bodies.ground]
points = { O1 = [0, 0], O2 = [100, 0] }
[bodies.left]
pose.angle = 0
points = { O = [0, 0], A = [30, 0] }
[bodies.right]
pose = { x = 100, angle = 200 }
points = { O = [0, 0], B = [30, 0] }
[bodies.left_link]
pose = { x = 30, angle = 40 }
points = { A = [0, 0], T = [45.5575, 0] }
[bodies.right_link]
pose = { x = 72, y = -10, angle = 140 }
points = { B = [0, 0], T = [45.5575, 0] }
[joints]
o1 = { type = "revolute", between = ["ground.O1", "left.O"] }
o2 = { type = "revolute", between = ["ground.O2", "right.O"] }
a = { type = "revolute", between = ["left.A", "left_link.A"] }
b = { type = "revolute", between = ["right.B", "right_link.B"] }
t = { type = "revolute", between = ["left_link.T", "right_link.T"] }
[drivers.left]
joint = "o1"
start = 0
end = 360
[drivers.right]
joint = "o2"
start = 200
end = -880
)";

// An oval in a ring with little play: beyond the gap it is free of overlap from 105.85 degrees on. Its
// contact can be followed back further, with an overlap elsewhere, but cannot be placed there.
TEST(BeyondLimits, BodiesThatOverlapElsewhereAreTakenUpWhereTheyComeApart) {
  const std::vector<std::string> near_conforming = {"bodies.cam.curves.oval.semi_axes=[31,12]",
                                                    "bodies.ring.curves.hole.radius=32"};
  const auto with = [&](std::vector<std::string> settings) {
    settings.insert(settings.end(), near_conforming.begin(), near_conforming.end());
    return testing::analyze(testing::shipped("oval_in_ring", settings));
  };
  const RunTable backwards =
      with({"driver.start=108", "driver.end=104", "bodies.ring.pose.angle=5.95", "driver.samples=2"});
  ASSERT_EQ(backwards.events().size(), 1U);
  EXPECT_EQ(backwards.events()[0].type, EventType::kOverlap);
  const double apart = backwards.events()[0].driver;
  for (const int rows : {2, 7, 13, 61, 361, 1801}) {
    SCOPED_TRACE(rows);
    const RunTable motion = with({fmt::format("driver.samples={}", rows)});
    std::vector<double> limits;
    for (const RunEvent& event : motion.events()) {
      if (event.type == EventType::kLimitPosition) limits.push_back(event.driver);
    }
    ASSERT_EQ(limits.size(), 3U);
    EXPECT_NEAR(limits[1], apart, 1e-12);
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double u = motion.radians(k, "driver");
      const bool apart_again = u > limits[1] && u < limits[2];
      EXPECT_EQ(motion.status(k) == RowStatus::kNotAssemblable, u > limits[0] && !apart_again) << u;
    }
  }
}

// An arm too short to follow the cam all round. Whether its roller slips or rolls, the arm moves alike; a
// small roller that rolls turns some hundred times.
TEST(BeyondLimits, ASmallRollerThatRollsIsFoundAgain) {
  for (const double radius : {3.0, 2.0, 0.7, 0.2}) {
    for (const int rows : {7, 61}) {
      SCOPED_TRACE(fmt::format("radius {}, {} rows", radius, rows));
      const auto limits_if = [&](bool rolling) {
        const RunTable motion = testing::analyze(testing::shipped(
            "roller_body", {fmt::format("contacts.touch.rolling={}", rolling), "bodies.arm.points.P=[-55,0]",
                            "bodies.roller.pose={x=34.95,y=31.55}",
                            fmt::format("bodies.roller.curves.rim.radius={}", radius), "driver.end=720",
                            fmt::format("driver.samples={}", rows)}));
        std::vector<double> limits;
        for (const RunEvent& event : motion.events()) {
          if (event.type == EventType::kLimitPosition) limits.push_back(event.driver);
        }
        return limits;
      };
      const std::vector<double> rolling = limits_if(true);
      EXPECT_EQ(rolling.size(), 4U);
      EXPECT_THAT(rolling, ::testing::Pointwise(::testing::DoubleNear(1e-12), limits_if(false)));
    }
  }
}

TEST(BeyondLimits, StretchesOfSeveralDriversAreThoseOfTheirLine) {
  const std::vector<double> limits = testing::CoupledCranks{200 * kPi / 180, 91.115}.limits(0);
  ASSERT_EQ(limits.size(), 6U);
  for (const int rows : {7, 61, 601}) {
    SCOPED_TRACE(rows);
    const std::string left = fmt::format("drivers.left.samples={}", rows);
    const std::string right = fmt::format("drivers.right.samples={}", rows);
    const RunTable motion = analyze_text(kDrivenCranks, {left, right});
    ASSERT_EQ(motion.failure(), "");
    const std::vector<double> found = limits_of(motion);
    ASSERT_EQ(found.size(), limits.size());
    for (std::size_t k = 0; k < limits.size(); ++k) {
      EXPECT_NEAR(found[k], limits[k], 1e-11);
    }
  }
}

// The face of a blade passes through the blade's pivot. The pivot slides until it is on an asymptote of the
// hyperbola that the face touches: at x = -30.
constexpr const char* kBladeOnAHyperbola = R"(
[bodies.ground]
points.O = [0, 20]
curves.branch = { type = "hyperbola", center = [0, 0], semi_axes = [30, 20] }
[bodies.cart]
pose.y = 20
points.O = [0, 0]
[bodies.blade]
pose = { y = 20, angle = -60 }
points.O = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = 90 }
[joints]
slide = { type = "prismatic", between = ["ground.O", "cart.O"], direction = 0 }
pivot = { type = "revolute", between = ["cart.O", "blade.O"] }
[contacts]
touch = { between = ["ground.branch", "blade.face"] }
[driver]
joint = "slide"
start = 0
end = -60
)";

TEST(BeyondLimits, AContactRunsOffWhereAsymptotesCoincide) {
  for (const int rows : {7, 8, 13, 61, 62, 601}) {
    SCOPED_TRACE(rows);
    const RunTable motion = analyze_text(kBladeOnAHyperbola, {fmt::format("driver.samples={}", rows)});
    ASSERT_EQ(motion.failure(), "");
    const std::vector<double> limits = limits_of(motion);
    ASSERT_EQ(limits.size(), 1U);
    EXPECT_NEAR(limits[0], -0.03, 1e-14);
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const bool touches = motion.value(k, "driver") > -30 + 1e-6;
      EXPECT_EQ(motion.status(k), touches ? RowStatus::kOk : RowStatus::kNotAssemblable);
    }
  }
}

// A second blade, 0.05 ahead of the first, runs off to infinity before it.
TEST(BeyondLimits, OfTwoContactsFarOutTheFirstToRunOffEndsTheMotion) {
  const std::string one = replaced(kBladeOnAHyperbola, "[joints]", R"([bodies.second]
pose = { x = -0.05, y = 20, angle = -60 }
points.O = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = 90 }
[joints]
second = { type = "revolute", between = ["cart.Q", "second.O"] })");
  const std::string profile = replaced(one, "[contacts]", R"([contacts]
ahead = { between = ["ground.branch", "second.face"] })");
  for (const int rows : {2, 7, 61, 241}) {
    SCOPED_TRACE(rows);
    const RunTable motion =
        analyze_text(profile, {"bodies.cart.points.Q=[-0.05, 0]", fmt::format("driver.samples={}", rows)});
    ASSERT_EQ(motion.failure(), "");
    const std::vector<double> limits = limits_of(motion);
    ASSERT_EQ(limits.size(), 1U);
    EXPECT_NEAR(limits[0], -0.02995, 1e-14);
  }
}

// The blade of another driver stays far out while a piston comes to the end of its guide. After ten million
// turns the driver is known to 5e-7 degrees: a stretch shorter than that is not divided any further.
TEST(BeyondLimits, StretchesAreDividedAsFarAsTheDriverIsResolved) {
  const auto rows_from = [](double start) {
    return testing::analyze(testing::shipped(
        "sixbar_slider", {"bodies.ground.points.F=[23.5739, 0]", "bodies.ground.points.rail=[0, 36.3659]",
                          "bodies.link3.points.B=[12.2879, 0]", "bodies.link5.points.G=[39.8139, 0]",
                          fmt::format("driver.start={}", start), fmt::format("driver.end={}", start + 360),
                          "driver.samples=37"}));
  };
  const RunTable near = rows_from(0), far = rows_from(3.6e9);
  ASSERT_EQ(near.size(), far.size());
  EXPECT_EQ(near.count(RowStatus::kNotAssemblable), 14);
  for (std::size_t row = 0; row < near.size(); ++row) {
    EXPECT_EQ(near.status(row), far.status(row)) << row;
  }
}

TEST(BeyondLimits, AContactThatRestsFarOutEndsNothing) {
  std::string profile = replaced(kBladeOnAHyperbola, "[joints]", R"([bodies.crank]
pose = { y = -40, angle = 90 }
points = { A = [0, 0], C = [10, 0] }
[bodies.rod]
pose = { y = -30, angle = -36.87 }
points = { C = [0, 0], D = [50, 0] }
[bodies.piston]
pose = { x = 40, y = -60 }
points.D = [0, 0]
[joints]
a = { type = "revolute", between = ["ground.A", "crank.A"] }
c = { type = "revolute", between = ["crank.C", "rod.C"] }
d = { type = "revolute", between = ["rod.D", "piston.D"] }
g = { type = "prismatic", between = ["ground.B", "piston.D"], direction = 0, to = 45 })");
  profile.replace(profile.find("[driver]"), std::string::npos, R"([drivers.one]
joint = "slide"
start = -29.99
end = -29.99
[drivers.two]
joint = "a"
start = 90
end = -60
)");
  const RunTable motion = analyze_text(
      profile, {"bodies.ground.points.A=[0, -40]", "bodies.ground.points.B=[0, -60]",
                "bodies.cart.pose.x=-29.99", "bodies.blade.pose.x=-29.99", "bodies.blade.pose.angle=-56.3"});
  ASSERT_EQ(motion.failure(), "");
  const auto& events = motion.events();
  const auto end = std::find_if(events.begin(), events.end(),
                                [](const RunEvent& event) { return event.type == EventType::kEnd; });
  ASSERT_NE(end, events.end());
  EXPECT_NEAR(end->driver, -0.02999, 1e-15);
  for (const RunEvent& event : events) EXPECT_NE(event.type, EventType::kLimitPosition);
}

// A parabola rolls on a face until its axis is parallel to the face, at 90 degrees.
constexpr const char* kRollingParabola = R"(
[bodies.ground]
points.O = [0, 50]
curves.floor = { type = "line", point = [0, 0], normal = 90 }
[bodies.cart]
pose.y = 50
points = { O = [0, 0], A = [0, 0] }
[bodies.arm]
pose.y = 50
points.A = [0, 0]
[bodies.bowl]
points.B = [0, 0]
curves.bowl = { type = "parabola", vertex = [0, 0], focal_length = 10, rotation = 90 }
[joints]
slide = { type = "prismatic", between = ["ground.O", "cart.O"], direction = 0 }
turn = { type = "revolute", between = ["cart.A", "arm.A"] }
lift = { type = "prismatic", between = ["arm.A", "bowl.B"], direction = 90 }
[contacts]
roll = { between = ["ground.floor", "bowl.bowl"], rolling = true }
[driver]
joint = "turn"
start = 0
end = 120
)";

TEST(BeyondLimits, ArcsKeepTheirDigitsFarOut) {
  for (const int rows : {7, 61, 601}) {
    SCOPED_TRACE(rows);
    const RunTable motion = analyze_text(kRollingParabola, {fmt::format("driver.samples={}", rows)});
    ASSERT_EQ(motion.failure(), "");
    EXPECT_NEAR(only_limit_of(motion), kPi / 2, 1e-10);
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double u = motion.value(k, "driver");
      EXPECT_EQ(motion.status(k), u < 90 - 1e-9 ? RowStatus::kOk : RowStatus::kNotAssemblable) << u;
    }
  }
}

// With its angle driven, a hyperbola approaches its asymptote like the square root of what is left.
TEST(BeyondLimits, AHyperbolaRollsUntilItsAsymptoteLiesOnTheFloor) {
  const std::string profile =
      replaced(kRollingParabola, R"(type = "parabola", vertex = [0, 0], focal_length = 10)",
               R"(type = "hyperbola", center = [0, 0], semi_axes = [30, 20])");
  for (const int rows : {2, 7, 61, 241, 601}) {
    SCOPED_TRACE(rows);
    const RunTable motion = analyze_text(
        profile, {"bodies.bowl.pose.y=-30", "driver.end=80", fmt::format("driver.samples={}", rows)});
    ASSERT_EQ(motion.failure(), "");
    EXPECT_NEAR(only_limit_of(motion), std::atan(1.5), 1e-12);
  }
}

// A hyperbola turns about O, 60 from its middle. The face of a blade rolls on it. The blade's pin, which is
// 40 from the first contact point, is on a slide through O.
constexpr const char* kRollingBlade = R"(
[bodies.ground]
points.O = [0, 0]
[bodies.cam]
pose = { x = 57.470, y = -17.241, angle = 73.3 }
points.O = [0, 60]
curves.branch = { type = "hyperbola", center = [0, 0], semi_axes = [30, 20] }
[bodies.slider]
pose = { x = 104.403065089105502 }
points.P = [0, 0]
[bodies.blade]
pose = { x = 104.403065089105502, angle = -16.6992442339936065 }
points.P = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = 90 }
[joints]
turn = { type = "revolute", between = ["ground.O", "cam.O"] }
slide = { type = "prismatic", between = ["ground.O", "slider.P"], direction = 0 }
pin = { type = "revolute", between = ["slider.P", "blade.P"] }
[contacts]
roll = { between = ["cam.branch", "blade.face"], rolling = true }
[driver]
joint = "turn"
start = 73.3007557660063935
end = 130
)";

// The same mechanism in the frame of the hyperbola, by the parameter t of its contact point (30 cosh t, 20
// sinh t).
struct RollingBlade {
  double a = 30, b = 20, c = std::hypot(a, b);

  // Length of the asymptote up to its point c exp(t) / 2, less that of the hyperbola from its vertex.
  [[nodiscard]] double arc_saved(double end) const {
    const auto slower = [&](double t) {
      const double on_asymptote = c * std::exp(t) / 2;
      const double on_curve = std::hypot(a * std::sinh(t), b * std::cosh(t));
      // The difference of the squares, with the large terms cancelled analytically.
      const double squares = (a * a - b * b) / 2 - c * c * std::exp(-2 * t) / 4;
      return squares / (on_asymptote + on_curve);
    };
    constexpr int kIntervals = 4000;  // Simpson's rule
    const double step = end / kIntervals;
    double sum = slower(0) + slower(end);
    for (int i = 1; i < kIntervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * slower(i * step);
    return c / 2 + sum * step / 3;
  }

  [[nodiscard]] Vector2d tangent(double t) const { return Vector2d(a * std::tanh(t), b) / width(t); }

  // Vector from O to the pin.
  [[nodiscard]] Vector2d arm(double t) const {
    // (c tangent - (a, b)) exp(t) / 2, from small terms only.
    const double narrower = std::pow(a / std::cosh(t), 2) / (c + width(t));  // c - width
    const Vector2d turned((narrower - 2 * c * std::exp(-2 * t) / (1 + std::exp(-2 * t))) * a, narrower * b);
    return Vector2d(a, -b) * std::exp(-t) / 2 - turned * (std::exp(t) / (2 * width(t))) +
           (arc_saved(t) - 40) * tangent(t) - Vector2d(0, 60);
  }

private:
  [[nodiscard]] double width(double t) const { return std::hypot(a * std::tanh(t), b); }
};

TEST(BeyondLimits, RollingEndsWhereTheFaceLiesOnTheAsymptote) {
  const double end = -angle_of(RollingBlade().arm(40));
  for (const int rows : {7, 13, 61, 241, 601}) {
    SCOPED_TRACE(rows);
    const RunTable motion = analyze_text(kRollingBlade, {fmt::format("driver.samples={}", rows)});
    ASSERT_EQ(motion.failure(), "");
    EXPECT_NEAR(only_limit_of(motion), end, 1e-10);
  }
}

// The face turns about the contact point, so that its pin moves at right angles to it, however far away that
// is.
TEST(BeyondLimits, SpeedsOfRollingBodiesKeepTheirDigitsFarOut) {
  const RollingBlade blade;
  for (const double t : {2.0, 6.0, 9.0}) {
    SCOPED_TRACE(t);
    const Vector2d arm = blade.arm(t);
    const RunTable motion = analyze_text(
        kRollingBlade,
        {fmt::format("driver.positions=[73.3007557660063935, {:.17g}]", -angle_of(arm) * 180 / kPi)});
    ASSERT_EQ(motion.failure(), "");
    ASSERT_EQ(motion.status(1), RowStatus::kOk);
    const Vector2d normal = perp(blade.tangent(t));
    const double omega = motion.value(1, "driver.velocity") * kPi / 180;
    const double speed = -omega * arm.norm() * normal.dot(arm) / cross(arm, normal);
    EXPECT_NEAR(motion.value(1, "slider.vx") / speed, 1, 1e-10);
  }
}

// A hyperbola rolls on its mirror image, from vertex to vertex: it remains the mirror image in the tangent
// N·x = h at the angle ψ, with h² = a² cos²ψ - b² sin²ψ, and its pin remains that of Q. As functions of h,
// which falls to 0 where the asymptotes coincide, all quantities are smooth.
TEST(BeyondLimits, AccelerationsOfTwoOpenCurvesKeepTheirDigitsFarOut) {
  const std::string turned =
      replaced(kRollingBlade, "angle = -16.6992442339936065", "angle = 73.3007557660063935");
  const std::string profile =
      replaced(turned, R"(type = "line", point = [0, 0], normal = 90)",
               R"(type = "hyperbola", center = [30, 40], semi_axes = [30, 20], rotation = 180)");
  const double a = 30, b = 20, cc = a * a + b * b;
  const Vector2d Q(30, -40);
  for (const double h : {10.0, 0.1, 0.01}) {
    SCOPED_TRACE(h);
    const double cosine = std::sqrt((h * h + b * b) / cc), sine = -std::sqrt((a * a - h * h) / cc);
    const Vector2d N(cosine, sine), T = perp(N);
    const double psi_h = -h / (cc * sine * cosine);
    const double psi_hh = -1 / (cc * sine * cosine) +
                          h * (cosine * cosine - sine * sine) / (cc * std::pow(sine * cosine, 2)) * psi_h;
    const double M = N.dot(Q) - h, M_h = psi_h * T.dot(Q) - 1,
                 M_hh = psi_hh * T.dot(Q) - psi_h * psi_h * N.dot(Q);
    const Vector2d arm = Q - 2 * M * N - Vector2d(0, 60);
    const Vector2d arm_h = -2 * (M_h * N + M * psi_h * T);
    const Vector2d arm_hh = -2 * (M_hh * N + 2 * M_h * psi_h * T + M * (psi_hh * T - psi_h * psi_h * N));
    const double r = arm.norm(), r_h = arm.dot(arm_h) / r;
    const double r_hh = (arm_h.squaredNorm() + arm.dot(arm_hh) - r_h * r_h) / r;
    const double beta_h = cross(arm, arm_h) / (r * r);
    const double beta_hh = (cross(arm, arm_hh) - 2 * r * r_h * beta_h) / (r * r);
    const RunTable motion = analyze_text(
        profile,
        {"driver.velocity=57.29577951308232",
         fmt::format("driver.positions=[73.3007557660063935, {:.17g}]", -angle_of(arm) * 180 / kPi)});
    ASSERT_EQ(motion.failure(), "");
    ASSERT_EQ(motion.status(1), RowStatus::kOk);
    EXPECT_NEAR(motion.value(1, "slider.x"), r, 1e-9);
    EXPECT_NEAR(motion.value(1, "slider.vx"), -r_h / beta_h, 1e-8 * r);
    EXPECT_NEAR(motion.value(1, "slider.ax"), (r_hh - r_h / beta_h * beta_hh) / (beta_h * beta_h), 1e-7 * r);
  }
}

// Two cranks whose links meet in a tool; the left one is held.
constexpr const char* kHeldFiveBar = R"(
[bodies.ground]
points.O1 = [0, 0]
points.O2 = [120, 0]
[bodies.left_crank]
pose     = { x = 0, y = 0, angle = 90 }
points.O = [0, 0]
points.A = [80, 0]
[bodies.right_crank]
pose     = { x = 120, y = 0, angle = 70 }
points.O = [0, 0]
points.B = [80, 0]
[bodies.left_link]
pose     = { x = 0, y = 80, angle = 20 }
points.A = [0, 0]
points.T = [110, 0]
[bodies.right_link]
pose     = { x = 147, y = 75, angle = 140 }
points.B = [0, 0]
points.T = [110, 0]
[joints]
left_pivot  = { type = "revolute", between = ["ground.O1", "left_crank.O"] }
right_pivot = { type = "revolute", between = ["ground.O2", "right_crank.O"] }
A = { type = "revolute", between = ["left_crank.A", "left_link.A"] }
B = { type = "revolute", between = ["right_crank.B", "right_link.B"] }
T = { type = "revolute", between = ["left_link.T", "right_link.T"] }
)";
constexpr const char* kHeld = R"([drivers.left]
joint = "left_pivot"
start = 90
end = 90
samples = 181
)";
constexpr const char* kSwung = R"([drivers.right]
joint = "right_pivot"
start = 70
end = -300
samples = 181
)";

// At a limit the links are in line: |A - B| = 220 with A = (0, 80).
TEST(BeyondLimits, AreTheSameWhicheverDriverIsNamedFirst) {
  const RunTable held_first = analyze_text(std::string(kHeldFiveBar) + kHeld + kSwung);
  const RunTable swung_first = analyze_text(std::string(kHeldFiveBar) + kSwung + kHeld);
  const std::vector<double> limits = limits_of(swung_first);
  ASSERT_EQ(limits.size(), 2U);
  ASSERT_EQ(limits_of(held_first).size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const double swung = limits[i];
    EXPECT_NEAR(std::hypot(0.12 + 0.08 * std::cos(swung), 0.08 * std::sin(swung) - 0.08), 0.22, 1e-12);
    EXPECT_NEAR(held_first.events()[i].driver, kPi / 2, 1e-15);
    EXPECT_THAT(held_first.events()[i].cause,
                ::testing::EndsWith(fmt::format("; with driver.right = {:.10g} deg", swung * 180 / kPi)));
    EXPECT_THAT(swung_first.events()[i].cause, ::testing::EndsWith("; with driver.left = 90 deg"));
  }
}

// A crank and a slide carry the ends of a dyad of 3 and 3. Whether the drivers have come back from the limit
// that the first step leads to must not depend on what a turn counts against a slide.
TEST(BeyondLimits, OfATurnAndASlideAreTheSameInAnyUnitOfLength) {
  constexpr const char* kCrankAndSlide = R"(
[units]
length = "{}"
[bodies.ground]
points.O = [0, 0]
[bodies.crank]
points.O = [0, 0]
points.A = [2, 0]
[bodies.cart]
pose = {{ x = 5, y = 0 }}
points.P = [0, 0]
[bodies.one]
pose = {{ x = 2, y = 0, angle = 40 }}
points.A = [0, 0]
points.C = [3, 0]
[bodies.other]
pose = {{ x = 5, y = 0, angle = 140 }}
points.P = [0, 0]
points.C = [3, 0]
[joints]
o = {{ type = "revolute", between = ["ground.O", "crank.O"] }}
s = {{ type = "prismatic", between = ["ground.O", "cart.P"], direction = [1, 0] }}
a = {{ type = "revolute", between = ["crank.A", "one.A"] }}
p = {{ type = "revolute", between = ["cart.P", "other.P"] }}
c = {{ type = "revolute", between = ["one.C", "other.C"] }}
[drivers.crank]
joint = "o"
positions = {}
[drivers.cart]
joint = "s"
positions = {}
)";
  const std::vector<std::pair<const char*, const char*>> paths = {{"[0, 6, 12]", "[5, 9, 6]"},
                                                                  {"[0, 6, 3]", "[5, 9, 20]"}};
  for (const auto& [crank, cart] : paths) {
    std::vector<double> in_millimetres;
    for (const char* unit : {"mm", "m", "km"}) {
      SCOPED_TRACE(unit);
      const std::vector<double> limits =
          limits_of(analyze_text(fmt::format(kCrankAndSlide, unit, crank, cart)));
      if (in_millimetres.empty()) in_millimetres = limits;
      ASSERT_EQ(limits.size(), in_millimetres.size());
      for (std::size_t i = 0; i < limits.size(); ++i) {
        EXPECT_NEAR(limits[i], in_millimetres[i], 1e-13);
      }
    }
    EXPECT_FALSE(in_millimetres.empty());
  }
}

// Two drivers move the end of an arm into the hole of its reach, |80 - 40| mm about its pivot, round in it
// and out again. It comes out on the way from the row before, not on a line from where it went in.
TEST(BeyondLimits, TwoDriversAreFollowedFromRowToRow) {
  const RunTable motion = analyze_text(R"(
[bodies.ground]
points.O = [0, 0]
[bodies.across]
points.O = [0, 0]
[bodies.up]
pose = { x = 60 }
points.O = [0, 0]
[bodies.upper]
pose = { angle = 28.955 }
points.O = [0, 0]
points.E = [80, 0]
[bodies.lower]
pose = { x = 70, y = 38.73, angle = -104.48 }
points.E = [0, 0]
points.P = [40, 0]
[joints]
x = { type = "prismatic", between = ["ground.O", "across.O"], direction = [1, 0] }
y = { type = "prismatic", between = ["across.O", "up.O"], direction = [0, 1] }
shoulder = { type = "revolute", between = ["ground.O", "upper.O"] }
elbow = { type = "revolute", between = ["upper.E", "lower.E"] }
hand = { type = "revolute", between = ["lower.P", "up.O"] }
[drivers.x]
joint = "x"
positions = [60, 20, 0, 0]
[drivers.y]
joint = "y"
positions = [0, 0, 20, 60]
)");
  ASSERT_EQ(motion.failure(), "");
  ASSERT_EQ(motion.size(), 4U);
  EXPECT_EQ(motion.status(1), RowStatus::kNotAssemblable);
  EXPECT_EQ(motion.status(2), RowStatus::kNotAssemblable);
  EXPECT_EQ(motion.status(3), RowStatus::kOk);
  ASSERT_EQ(motion.events().size(), 2U);
  EXPECT_NEAR(motion.events()[0].driver, 0.04, 1e-12);
  EXPECT_NEAR(motion.events()[1].driver, 0, 1e-12);
}

}  // namespace
}  // namespace higherpair

// Where a motion ends, and where it goes on behind that, is the same however far apart the rows are.
#include "coupled_cranks.hpp"
#include "run_testing.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::analyze_text;
using testing::RunTable;

// A slide carries an arm of 6 on a line 1 off the middle of a ring of 10, which the arm's tip touches from
// within: it can while the pivot is 4 from the middle, or farther.
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

// Two cranks of 30 mm, each driven, the second three times as fast and backwards: two links of 45.5 mm reach
// between their tips in three stretches of the turn, the shortest of which is half a degree long.
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

// The face of a blade goes through its pivot, which slides to where it is on an asymptote of the hyperbola
// that the face touches: at x = -30.
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

// A parabola rolls on a face until its axis lies along it, at 90 degrees.
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
    const auto limit =
        std::find_if(motion.events().begin(), motion.events().end(),
                     [](const RunEvent& event) { return event.type == EventType::kLimitPosition; });
    ASSERT_NE(limit, motion.events().end());
    EXPECT_NEAR(limit->driver, kPi / 2, 1e-10);
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double u = motion.value(k, "driver");
      EXPECT_EQ(motion.status(k), u < 90 - 1e-9 ? RowStatus::kOk : RowStatus::kNotAssemblable) << u;
    }
  }
}

// A hyperbola turns about O, 60 from its middle. On it rolls the face of a blade, whose pin, 40 from where it
// touches at first, is on a slide through O.
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

// That mechanism, in the frame of the hyperbola, by the parameter t of its point (30 cosh t, 20 sinh t) at
// which the face touches.
struct RollingBlade {
  double a = 30, b = 20, c = std::hypot(a, b);

  // How much longer the asymptote is up to its point c exp(t) / 2 than the hyperbola from its vertex on.
  [[nodiscard]] double arc_saved(double end) const {
    const auto slower = [&](double t) {
      const double on_asymptote = c * std::exp(t) / 2;
      const double on_curve = std::hypot(a * std::sinh(t), b * std::cosh(t));
      // The difference of their squares, without what is large.
      const double squares = (a * a - b * b) / 2 - c * c * std::exp(-2 * t) / 4;
      return squares / (on_asymptote + on_curve);
    };
    constexpr int kIntervals = 4000;  // Simpson's rule
    const double step = end / kIntervals;
    double sum = slower(0) + slower(end);
    for (int i = 1; i < kIntervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * slower(i * step);
    return c / 2 + sum * step / 3;
  }

  [[nodiscard]] Vector2d tangent(double t) const {
    return Vector2d(a * std::tanh(t), b) / std::hypot(a * std::tanh(t), b);
  }

  // The pin, seen from O.
  [[nodiscard]] Vector2d arm(double t) const {
    const Vector2d u = tangent(t);
    const Vector2d off_asymptote =
        Vector2d(a, -b) * std::exp(-t) / 2 - (c * u - Vector2d(a, b)) * std::exp(t) / 2;
    return off_asymptote + (arc_saved(t) - 40) * u - Vector2d(0, 60);
  }
};

TEST(BeyondLimits, RollingEndsWhereTheFaceLiesOnTheAsymptote) {
  const double end = -angle_of(RollingBlade().arm(40));
  for (const int rows : {7, 13, 61, 241, 601}) {
    SCOPED_TRACE(rows);
    const RunTable motion = analyze_text(kRollingBlade, {fmt::format("driver.samples={}", rows)});
    ASSERT_EQ(motion.failure(), "");
    const auto limit =
        std::find_if(motion.events().begin(), motion.events().end(),
                     [](const RunEvent& event) { return event.type == EventType::kLimitPosition; });
    ASSERT_NE(limit, motion.events().end());
    EXPECT_NEAR(limit->driver, end, 1e-10);
  }
}

// The face turns about where it touches, so that its pin goes at right angles to it, however far that is.
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

}  // namespace
}  // namespace higherpair

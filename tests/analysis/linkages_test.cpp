// The shipped linkages against closed forms that the program does not use.
#include "analysis/run_testing.hpp"
#include "higherpair/analysis/run.hpp"
#include "linkage/linkage_testing.hpp"

#include <fmt/core.h>

namespace higherpair {
namespace {

using namespace higherpair::testing;

constexpr Complex kI{0, 1};

double dot(Complex a, Complex b) {
  return (std::conj(a) * b).real();
}

/// A point's position with its first and second derivative by time.
struct Path3 {
  Complex p, v, a;
};

Path3 operator*(Complex factor, const Path3& path) {
  return {factor * path.p, factor * path.v, factor * path.a};
}

Path3 operator+(const Path3& a, const Path3& b) {
  return {a.p + b.p, a.v + b.v, a.a + b.a};
}

Path3 turning(Complex center, double radius, double theta, double omega, double alpha) {
  const Complex r = radius * direction(theta);
  return {center + r, kI * omega * r, (kI * alpha - omega * omega) * r};
}

/// Velocity and acceleration of a point at fixed distances from two moving ones: (p - A)·(v - v_A) = 0, (p -
/// A)·(a - a_A) = -|v - v_A|², and the same for B.
Path3 held_by(Complex p, const Path3& A, const Path3& B) {
  const Complex r = p - A.p, s = p - B.p;
  const auto solve = [&](double along_r, double along_s) {
    const double det = (std::conj(r) * s).imag();
    return kI * (s * along_r - r * along_s) / -det;
  };
  const Complex v = solve(dot(r, A.v), dot(s, B.v));
  const Complex a = solve(dot(r, A.a) - std::norm(v - A.v), dot(s, B.a) - std::norm(v - B.v));
  return {p, v, a};
}

/// Errors of a point's columns, relative to its own speed and acceleration.
void compare_point(const RunTable& motion, std::size_t row, const std::string& name, const Path3& expected,
                   double size, Worst& worst) {
  worst.see(std::abs(motion.vector(row, name + ".") - expected.p) / size);
  worst.see(std::abs(motion.vector(row, name + ".v") - expected.v) / (size + std::abs(expected.v)));
  worst.see(std::abs(motion.vector(row, name + ".a") - expected.a) / (size + std::abs(expected.a)));
}

// A, P and O4 lie on a circle about B: O4P is perpendicular to O4A (Thales), and |AP| = 5.
Path3 hoeckens_point(const Path3& A) {
  const Path3 w = A + Path3{-2, 0, 0};
  const double q = std::norm(w.p), q1 = 2 * dot(w.p, w.v), q2 = 2 * (std::norm(w.v) + dot(w.p, w.a));
  const double g1 = -25 * q1 / (q * q), g2 = -25 * q2 / (q * q) + 50 * q1 * q1 / (q * q * q);
  const double f = std::sqrt(25 / q - 1), f1 = g1 / (2 * f), f2 = g2 / (2 * f) - f1 * f1 / f;
  return -kI * Path3{w.p * f, w.v * f + w.p * f1, w.a * f + 2.0 * w.v * f1 + w.p * f2} + Path3{2, 0, 0};
}

TEST(StraightLineLinkage, TracesTheCurvesOfItsCouplerOverATurn) {
  const RunTable motion = analyze(shipped("straight_line"));
  expect_all_ok(motion);
  Worst worst;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Path3 A = turning(0, 1, (180 + static_cast<double>(i)) * kDegree, 2 * kPi, 0);
    const Path3 P = hoeckens_point(A);
    const Path3 along = 0.2 * (P + Complex(-1) * A);
    compare_point(motion, i, "coupler.P", P, 5, worst);
    compare_point(motion, i, "coupler.B", 0.5 * (A + P), 5, worst);
    compare_point(motion, i, "coupler.Q", A + Complex(1.25, 0.8) * along, 5, worst);
    compare_point(motion, i, "coupler.R", A + Complex(1.25, -1.6) * along, 5, worst);
  }
  EXPECT_AT_MOST(worst.value(), 1e-13);
  // The curve is closed.
  EXPECT_AT_MOST(std::abs(motion.vector(360, "coupler.P.") - motion.vector(0, "coupler.P.")), 1e-13);
}

TEST(ScotchYoke, IsAPureHarmonicForEveryDirectionOfItsSlot) {
  for (const double slot : {90.0, 60.0, 141.5}) {
    const RunTable motion = analyze(shipped("scotch_yoke", {fmt::format("joints.slot.direction={}", slot)}));
    expect_all_ok(motion);
    const double cotangent = 1 / std::tan(slot * kDegree);
    const double omega = 4 * kPi;
    Worst worst;
    for (std::size_t i = 0; i < motion.size(); ++i) {
      const double theta = static_cast<double>(i) * kDegree;
      const double x = 31 * (std::cos(theta) - std::sin(theta) * cotangent);
      const double v = -31 * omega * (std::sin(theta) + std::cos(theta) * cotangent);
      worst.see(std::abs(motion.value(i, "slide.position") - x) / 31);
      worst.see(std::abs(motion.value(i, "slide.velocity") - v) / (31 * omega));
      worst.see(std::abs(motion.value(i, "slide.acceleration") + omega * omega * x) / (31 * omega * omega));
    }
    EXPECT_AT_MOST(worst.value(), 1e-14);
  }
}

// Exactly at the end of its stroke the yoke is at rest, while the crank's pin is not.
TEST(ScotchYoke, IsOkExactlyAtTheEndOfItsStroke) {
  const RunTable motion =
      analyze(shipped("scotch_yoke", {"joints.slot.direction=141", "driver.positions=[51, 231]"}));
  expect_all_ok(motion);
}

// The yoke moves the crank: theta = ±acos(x/31).
TEST(ScotchYoke, TurnsItsCrankWhenTheYokeIsDriven) {
  const RunTable motion = analyze(
      shipped("scotch_yoke", {"driver={joint = \"slide\", positions = [24, 11, -5, -29], velocity = 7}",
                              "bodies.crank.pose.angle=40"}));
  expect_all_ok(motion);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const double x = motion.value(i, "driver");
    const double root = std::sqrt(31 * 31 - x * x);
    EXPECT_NEAR(motion.radians(i, "crank.angle"), std::acos(x / 31), 1e-14);
    EXPECT_NEAR(motion.radians(i, "crank.omega"), -7 / root, 1e-14);
    EXPECT_NEAR(motion.radians(i, "crank.alpha"), -49 * x / (root * root * root), 1e-14);
  }
}

// The toggle press: crank, knee and ram by intersecting circles.
void compare_toggle(const RunTable& motion, Worst& worst) {
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Path3 A = turning({-260, -150}, 50, static_cast<double>(i) * kDegree, 2 * kPi, 0);
    const Path3 T{};
    const Path3 K = held_by(meeting_point(A.p, 230, 0, 150, -1), A, T);
    compare_point(motion, i, "rod.K", K, 200, worst);
    const double h = std::sqrt(160 * 160 - K.p.real() * K.p.real());
    const double h1 = -K.p.real() * K.v.real() / h;
    const double h2 = -(K.v.real() * K.v.real() + K.p.real() * K.a.real() + h1 * h1) / h;
    const Path3 R{{0, K.p.imag() - h}, {0, K.v.imag() - h1}, {0, K.a.imag() - h2}};
    compare_point(motion, i, "ram.R", R, 200, worst);
  }
}

TEST(TogglePress, HasTheMotionOfItsKneeAndRam) {
  const RunTable motion = analyze(shipped("toggle_press"));
  expect_all_ok(motion);
  Worst worst;
  compare_toggle(motion, worst);
  EXPECT_AT_MOST(worst.value(), 1e-13);
  // The ram is at rest where the knee is straight, or where the knee reverses.
  std::size_t ends = 0;
  for (const RunEvent& event : motion.events()) ends += event.type == EventType::kStrokeEnd ? 1 : 0;
  EXPECT_GE(ends, 2U);
}

// Three links on one pin count as two joints, and it does not matter which two are written.
TEST(TogglePress, MovesTheSameWhicheverTwoJointsMakeItsTriplePin) {
  const std::vector<Settings> choices = {{"joints.knee_upper.between=[\"lower.K\", \"upper.K\"]"},
                                         {"joints.knee_lower.between=[\"upper.K\", \"lower.K\"]"},
                                         {"joints.knee_lower.between=[\"lower.K\", \"upper.K\"]"},
                                         {"joints.knee_upper.between=[\"upper.K\", \"rod.K\"]",
                                          "joints.knee_lower.between=[\"lower.K\", \"rod.K\"]"}};
  for (const Settings& choice : choices) {
    const RunTable motion = analyze(shipped("toggle_press", choice));
    expect_all_ok(motion);
    Worst worst;
    compare_toggle(motion, worst);
    EXPECT_AT_MOST(worst.value(), 1e-13) << choice[0];
  }
}

// The lever's slot always points to the crank's pin.
void compare_lever(const RunTable& motion, double radius, Worst& worst) {
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const double omega = motion.radians(i, "driver.velocity");
    const Path3 P = turning({0, 90}, radius, motion.radians(i, "driver"), omega, 0);
    const Complex rate = P.v / P.p;
    const Complex change = P.a / P.p - rate * rate;
    worst.see(angle_error(motion.radians(i, "lever.angle"), std::arg(P.p)));
    worst.see(relative_error(motion.radians(i, "lever.omega"), rate.imag()));
    worst.see(relative_error(motion.radians(i, "lever.alpha"), change.imag()));
  }
}

TEST(QuickReturn, SwingsOrTurnsTheLeverThatCarriesTheSlot) {
  for (const double radius : {40.0, 120.0}) {
    const RunTable motion =
        analyze(shipped("quick_return", {fmt::format("bodies.crank.points.P=[{}, 0]", radius)}));
    expect_all_ok(motion);
    Worst worst;
    compare_lever(motion, radius, worst);
    EXPECT_AT_MOST(worst.value(), 2e-13);
    const double turned = motion.value(360, "lever.angle") - motion.value(0, "lever.angle");
    EXPECT_NEAR(turned, radius > 90 ? 360 : 0, 1e-11);
  }
}

// The reverse arrangement: the slot passes through the crank's pivot, and the pin is on the lever, 120 from
// the lever's pivot. Cosine rule in the triangle of the pivots and the pin.
TEST(QuickReturn, MovesALeverWhosePinRunsInTheCranksSlot) {
  const RunTable motion =
      analyze(shipped("quick_return", {"joints.slot.between=[\"crank.O\", \"lever.T\"]",
                                       "bodies.lever.points.T=[120, 0]", "bodies.lever.pose.angle=49"}));
  expect_all_ok(motion);
  Worst worst;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Complex u = direction(motion.radians(i, "driver"));
    const double omega = motion.radians(i, "driver.velocity");
    // |90 i + s u| = 120 with s > 0: the pivot lies inside the pin's circle.
    const double sine = u.imag(), cosine = u.real();
    const double root = std::sqrt(120. * 120 - 90. * 90 * cosine * cosine);
    const double root1 = 90. * 90 * cosine * sine * omega / root;
    const double root2 = (90. * 90 * (cosine * cosine - sine * sine) * omega * omega - root1 * root1) / root;
    const double s = -90 * sine + root, s1 = -90 * cosine * omega + root1;
    const double s2 = 90 * sine * omega * omega + root2;
    const Path3 T{90.0 * kI + s * u, s1 * u + kI * omega * s * u,
                  s2 * u + 2.0 * kI * omega * s1 * u - omega * omega * s * u};
    compare_point(motion, i, "lever.T", T, 120, worst);
    worst.see(angle_error(motion.radians(i, "lever.angle"), std::arg(T.p)));
    worst.see(relative_error(motion.radians(i, "lever.omega"), (T.v / T.p).imag()));
    worst.see(std::abs(motion.value(i, "slot.position") - s) / 120);
  }
  EXPECT_AT_MOST(worst.value(), 1e-13);
}

TEST(Parallelogram, GoesStraightOnWhereItCouldFoldOver) {
  const RunTable motion = analyze(shipped("parallelogram"));
  expect_all_ok(motion);
  Worst worst;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    worst.see(std::abs(motion.radians(i, "right.angle") - motion.radians(i, "driver")));
    worst.see(std::abs(motion.radians(i, "coupler.angle")));
    worst.see(std::abs(motion.value(i, "right.omega") / 360 - 1));
    worst.see(std::abs(motion.value(i, "right.alpha")) / 360);
    worst.see(std::abs(motion.value(i, "coupler.omega")) / 360);
  }
  // Half a degree from a change point a position loses a factor of 1/sin(0.5 deg) = 115, and rates lose its
  // square.
  EXPECT_AT_MOST(worst.value(), 115 * 115 * 1e-15);
}

// tan(φ/2) = -(a+b)/(a-b) tan(θ/2) with the frame a = 100 and the cranks b = 40.
TEST(Parallelogram, TurnsItsCranksAgainstEachOtherWhenCrossed) {
  const RunTable motion =
      analyze(shipped("parallelogram", {"bodies.right.pose.angle=-107", "bodies.coupler.pose.angle=-47"}));
  expect_all_ok(motion);
  const double k = -140.0 / 60;
  Worst angles, rates;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const double half = motion.radians(i, "driver") / 2;
    const double c = std::cos(half), s = std::sin(half);
    const double phi = 2 * std::atan2(k * s, c);
    const double below = c * c + k * k * s * s;  // φ' = k/below
    const double omega = 2 * kPi;
    angles.see(angle_error(motion.radians(i, "right.angle"), phi));
    rates.see(std::abs(motion.radians(i, "right.omega") / omega - k / below));
    rates.see(std::abs(motion.radians(i, "right.alpha") / (omega * omega) +
                       k * (k * k - 1) * s * c / (below * below)));
  }
  EXPECT_AT_MOST(angles.value(), 115e-15);
  EXPECT_AT_MOST(rates.value(), 115 * 115 * 1e-15);
  EXPECT_NEAR(motion.value(720, "right.angle") - motion.value(0, "right.angle"), -720, 1e-10);
}

TEST(FiveBar, MovesItsToolAsTwoDriversTellIt) {
  for (const bool timed : {false, true}) {
    const Profile profile = shipped("five_bar");
    const RunTable motion = timed ? step(profile) : analyze(profile);
    expect_all_ok(motion);
    Worst worst;
    for (std::size_t i = 0; i < motion.size(); ++i) {
      const auto crank = [&](Complex center, const std::string& name) {
        return turning(center, 80, motion.radians(i, name), motion.radians(i, name + ".velocity"),
                       motion.radians(i, name + ".acceleration"));
      };
      const Path3 A = crank(0, "driver.left"), B = crank(120, "driver.right");
      const Path3 T = held_by(meeting_point(A.p, 130, B.p, 130, 1), A, B);
      compare_point(motion, i, "left_link.T", T, 130, worst);
      compare_point(motion, i, "right_link.T", T, 130, worst);
    }
    EXPECT_AT_MOST(worst.value(), 1e-13);
  }
}

// A round roller on its own pin touches where a roller fixed to the arm would; its spin has no effect.
TEST(RollerBody, MovesItsArmLikeARollerFixedToItAndKeepsItsAngle) {
  const RunTable motion = analyze(shipped("roller_body", {"bodies.roller.pose.angle=33"}));
  const RunTable fixed = analyze(profile_of(R"(
[bodies.ground]
points.O1 = [0, 0]
points.O2 = [80, 0]
[bodies.cam]
points.O    = [0, 0]
curves.disc = { type = "ellipse", center = [8, 3], semi_axes = [24, 17], rotation = 15 }
[bodies.arm]
pose       = { x = 80, y = 0, angle = -35 }
points.O   = [0, 0]
curves.rim = { type = "circle", center = [-60, 0], radius = 15 }
[joints]
cam_pivot = { type = "revolute", between = ["ground.O1", "cam.O"] }
arm_pivot = { type = "revolute", between = ["ground.O2", "arm.O"] }
[contacts.touch]
between = ["cam.disc", "arm.rim"]
[driver]
joint    = "cam_pivot"
end      = 360
velocity = 60
)"));
  expect_all_ok(motion);
  expect_all_ok(fixed);
  ASSERT_EQ(motion.size(), fixed.size());
  Worst worst;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    for (const char* column : {"arm.angle", "arm.omega", "arm.alpha", "touch.normal"}) {
      worst.see(std::abs(motion.radians(i, column) - fixed.radians(i, column)));
    }
    worst.see(std::abs(motion.vector(i, "touch.") - fixed.vector(i, "touch.")) / 80);
    EXPECT_EQ(motion.value(i, "roller.omega"), 0);
    EXPECT_EQ(motion.value(i, "roller.alpha"), 0);
    EXPECT_NEAR(motion.value(i, "roller.angle"), 33, 1e-13);
  }
  EXPECT_AT_MOST(worst.value(), 1e-13);
}

// A pair that rolls through one turn rolls through any number of turns.
TEST(RollingEllipses, DoNotSlipAfterABillionTurns) {
  const Mechanism mechanism = shipped("rolling_ellipses").mechanism;
  for (const double turns : {0.0, 1e7, 1e9}) {
    SCOPED_TRACE(turns);
    const auto run = start_run(mechanism, {turns * 2 * kPi});
    ASSERT_TRUE(run);
    std::vector<double> positions;
    for (int k = 0; k <= 1000; ++k) {
      positions.push_back(turns * 2 * kPi + k * 2e9 * kPi / 1000);
    }
    EXPECT_FALSE(find_slip(*run, positions));
  }
}

// Rolling, the roller's rim moves with the cam's: equal arcs from the first row on, no sliding.
TEST(RollerBody, IsTurnedByTheCamWhereItRollsFromTheAngleOfItsPose) {
  const RunTable motion =
      analyze(shipped("roller_body", {"contacts.touch.rolling=true", "bodies.roller.pose.angle=33"}));
  expect_all_ok(motion);
  ASSERT_EQ(motion.size(), 361U);
  EXPECT_NEAR(motion.value(0, "roller.angle"), 33, 1e-13);
  Worst worst;
  double turned = 0;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    worst.see(std::abs(motion.value(i, "touch.sliding")) / 80);
    worst.see(std::abs(motion.value(i, "touch.arc1") - motion.value(i, "touch.arc2")) / 80);
    // The roller's own arc, measured against the turning of its outward normal. That normal is -n, and its
    // tangent is -t.
    const double against = motion.radians(i, "touch.normal") - motion.radians(i, "roller.angle");
    if (i == 0) turned = against;
    worst.see(std::abs(15 * (against - turned) + motion.value(i, "touch.arc2")) / 80);
  }
  EXPECT_AT_MOST(worst.value(), 1e-12);
}

// The pin need not be the origin of the roller's frame.
TEST(RollerBody, KeepsItsAngleWhereverItsFrameIs) {
  const RunTable motion = analyze(
      shipped("roller_body", {"bodies.roller.points.P=[7, -3]", "bodies.roller.curves.rim.center=[7, -3]"}));
  const RunTable plain = analyze(shipped("roller_body"));
  expect_all_ok(motion);
  Worst worst;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    for (const char* column : {"arm.angle", "arm.omega", "arm.alpha", "roller.angle", "roller.omega"}) {
      worst.see(std::abs(motion.radians(i, column) - plain.radians(i, column)));
    }
  }
  EXPECT_AT_MOST(worst.value(), 1e-13);
}

// A crank moves a block along a lever. Turned by half a turn the lever has all its joint points in the same
// places: its angle in the pose decides.
TEST(BlockOnALever, StartsWhereItsPoseIs) {
  for (int k = 0; k < 72; ++k) {
    const double theta = 0.1 + k * kPi / 36;
    const Complex pin = std::polar(40.0 + k, theta) + Complex(0, 130);
    const double turned = k % 2 == 0 ? 0 : 180;
    const double angle = std::arg(pin) * 180 / kPi + turned;
    const double off = k % 3;  // of poses [mm, deg]
    const RunTable motion = analyze_text(fmt::format(
        R"([bodies.ground]
points = {{ O2 = [0, 130], O4 = [0, 0] }}
[bodies.crank]
pose.y = 130
points = {{ O = [0, 0], P = [{}, 0] }}
[bodies.block]
pose = {{ x = {}, y = {}, angle = {} }}
points.P = [0, 0]
[bodies.lever]
pose.angle = {}
points = {{ O = [0, 0], T = [170, 0] }}
[joints]
a = {{ type = "revolute", between = ["ground.O2", "crank.O"] }}
b = {{ type = "revolute", between = ["crank.P", "block.P"] }}
slide = {{ type = "prismatic", between = ["lever.O", "block.P"], direction = [1, 0], angle = 0 }}
pivot = {{ type = "revolute", between = ["ground.O4", "lever.O"] }}
[driver]
joint = "a"
start = {}
samples = 1
)",
        40 + k, pin.real() + off, pin.imag() - off, angle, angle + off, theta * 180 / kPi));
    SCOPED_TRACE(k);
    EXPECT_NEAR(motion.value(0, "lever.angle"), angle, 1e-10);
    EXPECT_NEAR(motion.value(0, "slide.position"), std::abs(pin) * (turned == 0 ? 1 : -1), 1e-10);
  }
}

}  // namespace
}  // namespace higherpair

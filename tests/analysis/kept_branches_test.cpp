// Linkages and contacts whose branches cross stay on their branch, wherever they start and however far apart
// the rows are: random mechanisms, and some whose rows fall on a crossing or very close to it.
#include "coupled_cranks.hpp"
#include "higherpair/analysis/run.hpp"
#include "run_testing.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

constexpr int kRuns = 400;
constexpr int kFewRows = 20;

// Mechanisms whose motion is known in closed form, on one of two branches that cross.
struct Change {
  const char* name;
  std::string (*profile)(double theta);                 // with the driver at theta [rad]
  double (*error)(const MotionRow& row, double theta);  // of the motion [rad; m in units of 0.1 m]
  double period;                                        // from crossing to crossing [rad]
  double first;                                         // a crossing [rad]
};

std::string driven_at(const char* text, double theta, double coupler = 0, double follower = 0) {
  return fmt::format(fmt::runtime(std::string("[units]\nangle = \"rad\"\nlength = \"m\"\n") + text),
                     fmt::arg("t", theta), fmt::arg("x", 0.04 * std::cos(theta)),
                     fmt::arg("y", 0.04 * std::sin(theta)), fmt::arg("half", theta / 2),
                     fmt::arg("coupler", coupler), fmt::arg("follower", follower));
}

// With the joints of a four-bar linkage, driven at its left crank.
std::string four_bar_at(const char* bodies, double theta, double coupler = 0, double follower = 0) {
  const std::string text = std::string(bodies) + R"(
[joints]
o = {{ type = "revolute", between = ["ground.O", "left.O"] }}
a = {{ type = "revolute", between = ["left.A", "coupler.A"] }}
b = {{ type = "revolute", between = ["coupler.B", "right.B"] }}
q = {{ type = "revolute", between = ["ground.Q", "right.Q"] }}
[driver]
joint = "o"
start = {t}
)";
  return driven_at(text.c_str(), theta, coupler, follower);
}

std::string turned_parallelogram(double theta) {
  return four_bar_at(R"([bodies]
ground = {{ points = {{ O = [0, 0], Q = [0.1, 0] }} }}
left = {{ pose.angle = {t}, points = {{ O = [0, 0], A = [0.04, 0] }} }}
coupler = {{ pose = {{ x = {x}, y = {y} }}, points = {{ A = [0, 0], B = [0.1, 0] }} }}
right = {{ pose = {{ x = 0.1, angle = {t} }}, points = {{ Q = [0, 0], B = [0.04, 0] }} }}
)",
                     theta);
}

// Three of them in a row, whose cranks are 1 rad ahead of the driver and 0.04 long to within rounding.
std::string rhombi_in_series(double theta) {
  std::string text = driven_at(R"([bodies]
ground.points = {{ G0 = [0, 0], G1 = [0.04, 0], G2 = [0.08, 0], G3 = [0.12, 0] }}
crank0 = {{ pose = {{ angle = {t} }}, points = {{ G = [0, 0], T = [0.021612092234725587, 0.03365883939231586] }} }}
)",
                               theta);
  const auto add = [&](const char* part, int i) {
    text += fmt::format(fmt::runtime(part), fmt::arg("i", i), fmt::arg("next", i + 1), fmt::arg("t", theta),
                        fmt::arg("g", 0.04 * (i + 1)), fmt::arg("x", 0.04 * (i + std::cos(theta + 1))),
                        fmt::arg("y", 0.04 * std::sin(theta + 1)));
  };
  for (int i = 0; i < 3; ++i) {
    add(R"(rod{i} = {{ pose = {{ x = {x}, y = {y} }}, points = {{ A = [0, 0], B = [0.04, 0] }} }}
crank{next} = {{ pose = {{ x = {g}, angle = {t} }}, points = {{ G = [0, 0], T = [0.021612092234725587, 0.03365883939231586] }} }}
)",
        i);
  }
  text += "[joints]\no = { type = \"revolute\", between = [\"ground.G0\", \"crank0.G\"] }\n";
  for (int i = 0; i < 3; ++i) {
    add(R"(a{i} = {{ type = "revolute", between = ["crank{i}.T", "rod{i}.A"] }}
b{i} = {{ type = "revolute", between = ["rod{i}.B", "crank{next}.T"] }}
g{i} = {{ type = "revolute", between = ["ground.G{next}", "crank{next}.G"] }}
)",
        i);
  }
  return text + fmt::format("[driver]\njoint = \"o\"\nstart = {}\n", theta);
}

// Cranks of 0.04 crossed in a frame of 0.0408: where they are in line the follower is 101 times as fast.
constexpr double kCrossedFrame = 0.0408;

double crossed_follower(double theta) {
  const std::complex<double> A = std::polar(0.04, theta), Q = kCrossedFrame;
  const std::complex<double> u = (Q - A) / std::abs(Q - A);
  return std::arg(A + u * u * kCrossedFrame - Q);
}

std::string crossed_cranks(double theta) {
  const double follower = crossed_follower(theta);
  const std::complex<double> A = std::polar(0.04, theta);
  const std::complex<double> B = kCrossedFrame + std::polar(0.04, follower);
  return four_bar_at(R"([bodies]
ground = {{ points = {{ O = [0, 0], Q = [0.0408, 0] }} }}
left = {{ pose.angle = {t}, points = {{ O = [0, 0], A = [0.04, 0] }} }}
coupler = {{ pose = {{ x = {x}, y = {y}, angle = {coupler} }}, points = {{ A = [0, 0], B = [0.0408, 0] }} }}
right = {{ pose = {{ x = 0.0408, angle = {follower} }}, points = {{ Q = [0, 0], B = [0.04, 0] }} }}
)",
                     theta, std::arg(B - A), follower);
}

std::string equal_slider_crank(double theta) {
  return driven_at(R"([bodies]
ground.points.O = [0, 0]
crank = {{ pose.angle = {t}, points = {{ O = [0, 0], A = [0.04, 0] }} }}
rod = {{ pose = {{ x = {x}, y = {y}, angle = -{t} }}, points = {{ A = [0, 0], B = [0.04, 0] }} }}
slider = {{ pose.x = 0.06, points.B = [0, 0] }}
[joints]
o = {{ type = "revolute", between = ["ground.O", "crank.O"] }}
a = {{ type = "revolute", between = ["crank.A", "rod.A"] }}
b = {{ type = "revolute", between = ["rod.B", "slider.B"] }}
guide = {{ type = "prismatic", between = ["ground.O", "slider.B"], direction = [1, 0] }}
[driver]
joint = "o"
start = {t}
)",
                   theta);
}

std::string lever_through_the_pivot(double theta) {
  return driven_at(R"([bodies]
ground.points = {{ O = [0, 0], Q = [-0.04, 0] }}
crank = {{ pose.angle = {t}, points = {{ O = [0, 0], A = [0.04, 0] }} }}
lever = {{ pose = {{ x = -0.04, angle = {half} }}, points.Q = [0, 0] }}
[joints]
o = {{ type = "revolute", between = ["ground.O", "crank.O"] }}
slot = {{ type = "slot", between = ["lever.Q", "crank.A"], direction = [1, 0] }}
q = {{ type = "revolute", between = ["ground.Q", "lever.Q"] }}
[driver]
joint = "o"
start = {t}
)",
                   theta);
}

// At the crossing on the right the contact point lies on the follower's pivot.
constexpr const char* kDiscs = R"([bodies]
ground.points = {{ P = [-0.05, 0], O = [0, 0], Q = [0.1, 0] }}
left = {{ pose.angle = {t}, points.O = [0, 0], curves.c = {{ type = "circle", center = [0.04, 0], radius = 0.06 }} }}
right = {{ pose = {{ x = 0.1, angle = {t} }}, points.Q = [0, 0], curves.c = {{ type = "circle", center = [0.04, 0], radius = 0.04 }} }}
wheel = {{ pose = {{ x = -0.05, angle = {t} }}, points.P = [0, 0] }}
[joints]
o = {{ type = "revolute", between = ["ground.O", "left.O"] }}
q = {{ type = "revolute", between = ["ground.Q", "right.Q"] }}
p = {{ type = "revolute", between = ["ground.P", "wheel.P"] }}
belt = {{ type = "belt", between = ["wheel.P", "left.O"], ratio = 1 }}
[contacts]
touch = {{ between = ["left.c", "right.c"] }}
[driver]
start = {t}
)";

std::string equal_discs(double theta) {
  return driven_at(kDiscs, theta) + "joint = \"o\"\n";
}

std::string equal_discs_on_a_belt(double theta) {
  return driven_at(kDiscs, theta) + "joint = \"p\"\n";
}

std::string disc_that_pushes_a_disc(double theta) {
  return driven_at(R"([bodies]
ground.points.O = [0, 0]
left = {{ pose.angle = {t}, points.O = [0, 0], curves.c = {{ type = "circle", center = [0.04, 0], radius = 0.015 }} }}
right = {{ pose.x = 0.06, points.B = [0, 0], curves.c = {{ type = "circle", center = [0, 0], radius = 0.025 }} }}
[joints]
o = {{ type = "revolute", between = ["ground.O", "left.O"] }}
guide = {{ type = "prismatic", between = ["ground.O", "right.B"], direction = [1, 0] }}
[contacts]
touch = {{ between = ["left.c", "right.c"] }}
[driver]
joint = "o"
start = {t}
)",
                   theta);
}

double off_parallel(const MotionRow& row, double theta) {
  return std::abs(row.bodies[2].theta) + std::abs(row.bodies[3].theta - theta);
}

double off_rhombi(const MotionRow& row, double theta) {
  double off = 0;
  for (std::size_t i = 1; i < row.bodies.size(); ++i) {
    const bool is_rod = i % 2 == 0;
    off += std::abs(std::remainder(row.bodies[i].theta - (is_rod ? 0 : theta), 2 * kPi));
  }
  return off;
}

double off_crossed(const MotionRow& row, double theta) {
  return std::abs(std::remainder(row.bodies[3].theta - crossed_follower(theta), 2 * kPi));
}

double off_isosceles(const MotionRow& row, double theta) {
  return std::abs(row.bodies[2].theta + theta) +
         std::abs(row.bodies[3].X_WB.p_WB.x() - 0.08 * std::cos(theta));
}

double off_half_angle(const MotionRow& row, double theta) {
  return std::abs(std::remainder(row.bodies[2].theta - theta / 2, 2 * kPi));
}

double off_parallel_disc(const MotionRow& row, double theta) {
  return std::abs(row.bodies[2].theta - theta);
}

double off_cosine(const MotionRow& row, double theta) {
  return std::abs(row.bodies[2].X_WB.p_WB.x() - 0.08 * std::cos(theta));
}

// A number in [0, 1), the same on every platform.
double share(std::mt19937_64& random) {
  return static_cast<double>(random() % 1000000007) / 1000000007;
}

// Short, long and uniform steps, and steps that come close to a crossing after some rows.
double any_step(const Change& change, double start, std::mt19937_64& random) {
  switch (random() % 4) {
    case 0:
      return 0.01 + share(random);
    case 1:
      return std::round(1 + 60 * share(random)) * kPi / 180;
    case 2:
      return 1 + 11 * share(random);
    default:
      break;
  }
  const double crossing = change.first + std::round(4 * share(random)) * change.period;
  const double beside = random() % 3 == 0 ? 0 : (share(random) - 0.5) * std::pow(10, -1 - 8 * share(random));
  return (crossing - start) / std::round(1 + 40 * share(random)) * (1 + beside);
}

const Change kChanges[] = {
    Change{"Parallelogram", turned_parallelogram, off_parallel, kPi, kPi},
    Change{"RhombiInSeries", rhombi_in_series, off_rhombi, kPi, kPi - 1},
    Change{"CrossedCranks", crossed_cranks, off_crossed, kPi, kPi},
    Change{"EqualSliderCrank", equal_slider_crank, off_isosceles, kPi, kPi / 2},
    Change{"LeverThroughThePivot", lever_through_the_pivot, off_half_angle, 2 * kPi, kPi},
    Change{"EqualDiscs", equal_discs, off_parallel_disc, kPi, kPi},
    Change{"EqualDiscsOnABelt", equal_discs_on_a_belt, off_parallel_disc, kPi, kPi},
    Change{"DiscThatPushesADisc", disc_that_pushes_a_disc, off_cosine, kPi, kPi / 2}};

TEST(KeptBranches, DoNotDependOnTheRows) {
  for (const Change& change : kChanges) {
    SCOPED_TRACE(change.name);
    std::mt19937_64 random(1);
    for (int i = 0; i < kRuns; ++i) {
      double start = 0.1 + 1.3 * share(random);
      if (i % 3 == 0) {
        start = std::round(start * 12) * kPi / 36;
      }
      const double step = any_step(change, start, random);
      SCOPED_TRACE(fmt::format("from {} by {}", start, step));
      const auto profile = read_profile_text(change.profile(start), change.name);
      ASSERT_TRUE(profile) << to_string(profile.error().front());
      auto run = start_run(profile->mechanism, {start});
      ASSERT_TRUE(run) << run.error().reason;
      for (int k = 1; k <= kFewRows; ++k) {
        const double theta = start + k * step;
        move_to(*run, {{theta, 1, 0}});
        ASSERT_TRUE(run->row.status == RowStatus::kOk || run->row.status == RowStatus::kSingular) << k;
        // Next to a crossing a contact is known only to the square root of rounding.
        ASSERT_LE(change.error(run->row, theta), 1e-7) << k;
      }
    }
  }
}

// With rows far apart the angles could just as well have gone the other way round.
TEST(Angles, GoTheShortWayOverAStretchThatCannotBeAssembled) {
  const auto expect_alike = [](const std::string& name, testing::Settings settings, const char* column) {
    settings.emplace_back("driver.samples=5");
    const testing::RunTable few = testing::analyze(testing::shipped(name, settings));
    settings.back() = "driver.samples=361";
    const testing::RunTable many = testing::analyze(testing::shipped(name, settings));
    ASSERT_EQ(few.size(), 5U);
    ASSERT_EQ(many.size(), 361U);
    std::size_t lost = 0;
    for (std::size_t k = 0; k < few.size(); ++k) {
      SCOPED_TRACE(fmt::format("{} row {}", name, k));
      ASSERT_EQ(few.status(k), many.status(90 * k));
      if (few.status(k) == RowStatus::kOk) {
        EXPECT_NEAR(few.value(k, column), many.value(90 * k, column), 1e-9);
      }
      lost += few.status(k) == RowStatus::kOk ? 0 : 1;
    }
    EXPECT_GT(lost, 0U);
  };
  expect_alike("four_bar", {"bodies.ground.points.O4=[2, 0]", "bodies.crank.points.A=[-2, 0]"},
               "coupler.angle");
  expect_alike("disc_in_ring",
               {"bodies.ground.points.O2=[-5.855358163792044, -50]", "bodies.cam.points.O=[50, 0]",
                "bodies.ring.pose.x=0"},
               "touch.normal");
}

// The driver positions of the limits that a run over one turn from `start` finds, forwards or backwards.
std::vector<double> found_limits(const testing::CoupledCranks& cranks, double start, int rows, bool back) {
  constexpr double kOneDegree = kPi / 180;
  const double from = (back ? start + 2 * kPi : start) / kOneDegree;
  const testing::RunTable motion = testing::analyze(testing::shipped(
      "geared_five_bar",
      {"joints.gears.ratio=3", fmt::format("bodies.right_crank.pose.angle={}", cranks.phase / kOneDegree),
       fmt::format("bodies.left_link.points.T=[{}, 0]", cranks.reach / 2),
       fmt::format("bodies.right_link.points.T=[{}, 0]", cranks.reach / 2),
       fmt::format("driver.start={}", from), fmt::format("driver.end={}", from + (back ? -360 : 360)),
       fmt::format("driver.samples={}", rows)}));
  std::vector<double> found;
  for (const RunEvent& event : motion.events()) {
    if (event.type == EventType::kLimitPosition) {
      found.push_back(event.driver);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// The second of the three stretches is 0.5° long.
TEST(LimitPositions, BoundStretchesThatNoRowLiesIn) {
  const testing::CoupledCranks cranks{200 * kPi / 180, 91.115};
  const std::vector<double> limits = cranks.limits(0);
  ASSERT_EQ(limits.size(), 6U);
  for (const int rows : {7, 61, 601}) {
    for (const bool back : {false, true}) {
      SCOPED_TRACE(fmt::format("{} {}", rows, back));
      const std::vector<double> found = found_limits(cranks, 0, rows, back);
      ASSERT_EQ(found.size(), limits.size());
      for (std::size_t k = 0; k < limits.size(); ++k) {
        EXPECT_NEAR(found[k], limits[k], 1e-12);
      }
    }
  }
}

// For stretches anywhere, and as short as they come: the reach is hardly enough for one of them.
TEST(LimitPositions, BoundTheShortestStretches) {
  int shortest = 0;
  for (int phase = 0; phase < 360; phase += 7) {
    testing::CoupledCranks cranks{phase * kPi / 180, 0};
    std::vector<double> tops;
    double start = 0;
    for (int k = 0; k < 3600; ++k) {
      const double theta = 2 * kPi * k / 3600, step = 2 * kPi / 3600;
      if (cranks.room(theta) > cranks.room(theta - step) && cranks.room(theta) >= cranks.room(theta + step)) {
        tops.push_back(cranks.room(theta));
      }
      start = cranks.room(theta) > cranks.room(start) ? theta : start;
    }
    for (const double top : tops) {
      cranks.reach = -top + 0.002;
      SCOPED_TRACE(fmt::format("{} {}", phase, cranks.reach));
      const std::vector<double> limits = cranks.limits(start);
      const std::vector<double> found = found_limits(cranks, start, 7, false);
      ASSERT_EQ(found.size(), limits.size());
      for (std::size_t k = 0; k < limits.size(); ++k) {
        EXPECT_NEAR(found[k], limits[k], 1e-9);
        shortest += k % 2 == 1 && k + 1 < limits.size() && limits[k + 1] - limits[k] < 0.01 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(shortest, 30);
}

}  // namespace
}  // namespace higherpair

// The derivatives that a design's search uses, compared with differences of whole candidates.
#include "front/cam_profile.hpp"
#include "higherpair/design/optimise.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::model_of;
using testing::shipped_model;

// All values of a candidate, in one column.
Eigen::VectorXd worth(DesignEvaluator& evaluator, const std::vector<double>& x, int branch) {
  DesignValues values;
  evaluator.evaluate(x, branch, values);
  Eigen::VectorXd all(1 + values.residuals.size() + values.constraints.size());
  all << values.cost, values.residuals, values.constraints;
  return all;
}

Eigen::VectorXd difference(DesignEvaluator& evaluator, std::vector<double> x, std::size_t i, int branch,
                           double h) {
  const double at = x[i];
  x[i] = at + h;
  Eigen::VectorXd high = worth(evaluator, x, branch);
  x[i] = at - h;
  return (high - worth(evaluator, x, branch)) / (2 * h);
}

// Extrapolated from two steps to the fourth order; where the two disagree there is a kink.
struct Difference {
  Eigen::VectorXd value;
  Eigen::VectorXd doubt;
};
Difference slope_of(DesignEvaluator& evaluator, const std::vector<double>& x, std::size_t i, int branch,
                    double h) {
  const Eigen::VectorXd wide = difference(evaluator, x, i, branch, h);
  const Eigen::VectorXd narrow = difference(evaluator, x, i, branch, h / 2);
  return {(4 * narrow - wide) / 3, (wide - narrow).cwiseAbs()};
}

// Whether the slopes on both sides differ by more than a smooth function's would.
bool has_kink(DesignEvaluator& evaluator, std::vector<double> x, std::size_t i, int branch, Eigen::Index row,
              double h) {
  const double at = x[i];
  std::array<double, 5> values{};
  for (int k = -2; k <= 2; ++k) {
    x[i] = at + k * h;
    values[k + 2] = worth(evaluator, x, branch)(row);
  }
  const double near = std::abs(values[1] - 2 * values[2] + values[3]);
  const double far = std::abs(values[0] - 2 * values[2] + values[4]);
  return near > 0.3 * far && near > 1e-13 * (1 + std::abs(values[2]));
}

struct Seen {
  int candidates = 0;  // with exact derivatives
  int numbers = 0;     // derivatives compared
  int kinks = 0;
  int off = 0;  // derivatives with an error larger than rounding
};

// Rounding error of a difference over this step.
double rounding_of(double value, double h) {
  return 1e-13 * (1 + std::abs(value)) / h;
}

Seen compare(const Model& model, int candidates, double closeness, unsigned seed, bool every_branch = false) {
  const DesignProblem problem = design_problem(model).value();
  const auto evaluator = problem.evaluator();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  Seen seen;
  for (int k = 0; k < candidates; ++k) {
    std::vector<double> x;
    for (const DesignVariable& variable : problem.variables) {
      const double anywhere = variable.low + uniform(random) * (variable.high - variable.low);
      x.push_back(std::lerp(variable.start, anywhere, closeness * uniform(random)));
    }
    const int branch = every_branch ? k % problem.branches : problem.start_branch;
    DesignJacobian jacobian;
    if (!evaluator->differentiate(x, branch, jacobian)) continue;
    ++seen.candidates;
    const Eigen::VectorXd at = worth(*evaluator, x, branch);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double range = problem.variables[i].high - problem.variables[i].low;
      const double step = 1e-5 * range;
      const Difference expected = slope_of(*evaluator, x, i, branch, step);
      // Where the greatest reach of a dyad passes from one triple of positions to the next, its derivative
      // may jump by less than a wide difference can show.
      const double narrow_step = step / 64;
      const Difference narrow = slope_of(*evaluator, x, i, branch, narrow_step);
      const auto column = static_cast<Eigen::Index>(i);
      Eigen::VectorXd found(at.size());
      found << jacobian.cost(column), jacobian.residuals.col(column), jacobian.constraints.col(column);
      for (Eigen::Index r = 0; r < at.size(); ++r) {
        const double scale = std::abs(expected.value(r)) + (1 + std::abs(at(r))) / range;
        const double off = std::abs(found(r) - expected.value(r));
        const auto agrees = [&](const Difference& slope, double h) {
          return std::abs(found(r) - slope.value(r)) <= slope.doubt(r) + 1e-6 * scale + rounding_of(at(r), h);
        };
        const bool same = agrees(expected, step) || agrees(narrow, narrow_step);
        // At a kink the largest of several numbers is a different one on either side.
        const bool kink = expected.doubt(r) > 1e-4 * scale || has_kink(*evaluator, x, i, branch, r, step);
        seen.kinks += kink ? 1 : 0;
        seen.numbers += kink ? 0 : 1;
        seen.off += same || kink ? 0 : 1;
        EXPECT_LE(off, 1e-3 * scale + expected.doubt(r) + (kink ? INFINITY : 0))
            << "candidate " << k << ", variable " << i << ", number " << r << ": " << found(r)
            << ", expected " << expected.value(r);
      }
    }
  }
  return seen;
}

// Four-bars side by side on one crank, so many that a branch cannot say the modes of all.
std::string many_four_bars(int count) {
  std::string ground = "[bodies.ground]\npoints.O = [0, 0]\n", bodies, joints;
  for (int i = 0; i < count; ++i) {
    const double x = 60 + 3 * i, y = 5 * i % 17, rod = 55 + 2.5 * i, rocker = 30 + i;
    const double far = std::hypot(x - 10, y), bearing = std::atan2(y, x - 10);
    const double rod_angle = bearing + std::acos((rod * rod + far * far - rocker * rocker) / (2 * rod * far));
    const double rocker_angle = std::atan2(rod * std::sin(rod_angle) - y, 10 + rod * std::cos(rod_angle) - x);
    const std::string n = std::to_string(i);
    std::ostringstream text;
    text << "[bodies.rod" << n << "]\npose = { x = 10, y = 0, angle = " << rod_angle * 180 / kPi
         << " }\npoints.A = [0, 0]\npoints.C = [" << rod << ", 0]\n[bodies.rocker" << n
         << "]\npose = { x = " << x << ", y = " << y << ", angle = " << rocker_angle * 180 / kPi
         << " }\npoints.B = [0, 0]\npoints.C = [" << rocker << ", 0]\n";
    bodies += text.str();
    ground += "points.B" + n + " = [" + std::to_string(x) + ", " + std::to_string(y) + "]\n";
    for (const auto& [name, first, second] : {std::array{"a" + n, std::string("crank.A"), "rod" + n + ".A"},
                                              std::array{"b" + n, "ground.B" + n, "rocker" + n + ".B"},
                                              std::array{"c" + n, "rod" + n + ".C", "rocker" + n + ".C"}}) {
      joints +=
          "[joints." + name + "]\ntype = \"revolute\"\nbetween = [\"" + first + "\", \"" + second + "\"]\n";
    }
  }
  return ground + "[bodies.crank]\npoints.O = [0, 0]\npoints.A = [10, 0]\n" + bodies +
         "[joints.O]\ntype = \"revolute\"\nbetween = [\"ground.O\", \"crank.O\"]\n" + joints + R"(
[driver]
joint = "O"
samples = 37
[design.variables]
rod = { path = "bodies.rod16.points.C.0", min = 90, max = 100 }
rocker = { path = "bodies.rocker0.points.C.0", min = 28, max = 34 }
[[design.objectives]]
column = "rocker0.angle"
of = "range"
target = 30
[[design.constraints]]
column = "rocker16.angle"
of = "max"
below = 200
)";
}

TEST(ManyDyads, EachHaveAConstraintOnTheirClosure) {
  const Model model = model_of(many_four_bars(19));
  const DesignProblem problem = design_problem(model).value();
  EXPECT_EQ(problem.constraints, 19 + 1 + 1);
  const auto evaluator = problem.evaluator();
  DesignValues values;
  DesignJacobian jacobian;
  evaluator->evaluate(std::array{95.0, 30.0}, problem.start_branch, values);
  ASSERT_TRUE(evaluator->differentiate(std::array{95.0, 30.0}, problem.start_branch, jacobian));
  EXPECT_EQ(values.constraints.size(), problem.constraints);
  EXPECT_EQ(jacobian.constraints.rows(), problem.constraints);
  const Seen seen = compare(model, 4, 0.1, 17);
  EXPECT_EQ(seen.candidates, 4);
  EXPECT_EQ(seen.off, 0);
}

// A shipped mechanism of a certain kind with a task of its own.
struct Kind {
  const char* profile;
  const char* variables;  // name, path and bounds of each
  const char* goals;      // objectives and constraints
  const char* rows = "driver.samples=37";
};

std::string task_of(const Kind& kind) {
  std::ostringstream text;
  text << std::ifstream(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + kind.profile + ".toml").rdbuf();
  text << "\n[design]\n[design.variables]\n" << kind.variables << kind.goals;
  return text.str();
}

const Kind kKindsOfTasks[] = {
    Kind{"slider_crank",
         R"(a = { path = "bodies.crank.points.A.0", min = 1, max = 3 }
b = { path = "bodies.rod.points.B.0", min = 4, max = 9 }
)",
         R"([[design.objectives]]
path = { point = "rod.B", through = [[3, 1], [5, 2], [6, 1.5]] }
[[design.objectives]]
column = "slide.acceleration"
of     = "maxabs"
[[design.constraints]]
column = "rod.omega"
of     = "rms"
below  = 3
)"},
    Kind{"quick_return",
         R"(crank = { path = "bodies.crank.points.P.0", min = 20, max = 60 }
frame = { path = "bodies.ground.points.O2.1", min = 70, max = 120 }
tip   = { path = "bodies.lever.points.T.0", min = 100, max = 300 }
)",
         R"([[design.objectives]]
column = "lever.T.ax"
of     = "max"
[[design.objectives]]
column = "lever.angle"
of     = "range"
target = 50
[[design.constraints]]
column = "slot.velocity"
of     = "max"
below  = 600
)"},
    Kind{"watt_sixbar",
         R"(b = { path = "bodies.link2.points.B.0", min = 30, max = 50 }
d = { path = "bodies.link4.points.H.1", min = 50, max = 70 }
)",
         R"([[design.objectives]]
column = "link6.alpha"
of     = "maxabs"
[[design.constraints]]
grashof = "crank-rocker"
coupler = "link3"
)"},
    Kind{"four_bar",
         R"(a = { path = "bodies.crank.points.A.0", min = 1, max = 3 }
b = { path = "bodies.coupler.points.B.0", min = 3, max = 8 }
)",
         R"([[design.objectives]]
size = "width"
[[design.objectives]]
reach  = "coupler.B"
from   = "ground.O2"
target = 6
[[design.constraints]]
size   = "height"
bodies = ["coupler", "rocker"]
below  = 3
)"},
    Kind{"four_bar",
         R"(a = { path = "bodies.crank.points.A.0", min = 1.8, max = 2.2 }
b = { path = "bodies.coupler.points.B.0", min = 3.4, max = 3.7 }
)",
         R"([[design.objectives]]
column = "rocker.angle"
follow = [[90, 70], [0, 60], [270, 250]]
change = true
[[design.objectives]]
column = "coupler.omega"
follow = [[0, 300], [40, 500]]
[[design.objectives]]
column = "coupler.E.x"
of     = "max"
[[design.constraints]]
column = "rocker.omega"
of     = "max"
below  = 900
)"},
    Kind{"flat_faced_translating",
         R"(e = { path = "bodies.cam.curves.disc.center.0", min = 5, max = 15 }
r = { path = "bodies.cam.curves.disc.radius", min = 15, max = 30 }
)",
         R"([[design.objectives]]
column = "follower.y"
of     = "mean"
[[design.objectives]]
size   = "largest"
bodies = ["cam"]
[[design.constraints]]
column = "touch.sliding"
of     = "maxabs"
below  = 10
)"},
    Kind{"parabola_cam",
         R"(pivot  = { path = "bodies.ground.points.O2.0", min = 60, max = 80 }
roller = { path = "bodies.follower.curves.disc.radius", min = 10, max = 20 }
)",
         R"([[design.objectives]]
column = "follower.angle"
of     = "range"
target = 30
[[design.constraints]]
column = "touch.transmission"
of     = "min"
above  = 40
)"},
    Kind{"hyperbola_cam",
         R"(pivot  = { path = "bodies.ground.points.O2.1", min = 15, max = 25 }
roller = { path = "bodies.follower.curves.roller.radius", min = 5, max = 15 }
)",
         R"([[design.objectives]]
column = "follower.roller.vy"
of     = "max"
)"},
    Kind{"knife_edge",
         R"(e = { path = "bodies.cam.curves.disc.center.0", min = 5, max = 15 }
offset = { path = "bodies.ground.points.rail.0", min = -5, max = 5 }
)",
         R"([[design.objectives]]
column = "touch.pressure"
of     = "max"
)"},
    Kind{"flat_faced_oscillating",
         R"(r = { path = "bodies.cam.curves.disc.radius", min = 15, max = 25 }
pivot = { path = "bodies.ground.points.O2.0", min = 55, max = 80 }
)",
         R"([[design.objectives]]
path = { point = "follower.tip", timed = true, at = [0, 100, 200], through = [[10, 20], [12, 25], [11, 30]] }
[[design.objectives]]
column = "follower.alpha"
of     = "rms"
)"},
    Kind{"scotch_yoke",
         R"(crank = { path = "bodies.crank.points.P.0", min = 20, max = 50 }
place = { path = "bodies.ground.points.O.0", min = -5, max = 5 }
)",
         R"([[design.objectives]]
column = "yoke.S.x"
of     = "max"
[[design.objectives]]
column = "slide.acceleration"
of     = "maxabs"
[[design.constraints]]
column = "slot.velocity"
of     = "max"
below  = 300
)"},
    Kind{"toggle_press",
         R"(crank = { path = "bodies.crank.points.A.0", min = 45, max = 55 }
upper = { path = "bodies.upper.points.K.0", min = 145, max = 160 }
ram   = { path = "bodies.ground.points.ram.0", min = -5, max = 5 }
)",
         R"([[design.objectives]]
column = "ram.R.y"
of     = "min"
target = -305
[[design.objectives]]
column = "lower.omega"
of     = "rms"
)"},
    Kind{"five_bar",
         R"(left  = { path = "bodies.left_link.points.T.0", min = 110, max = 150 }
right = { path = "bodies.right_crank.points.B.0", min = 70, max = 90 }
)",
         R"([[design.objectives]]
column = "left_link.T.y"
of     = "range"
target = 20
[[design.objectives]]
column = "right_link.alpha"
of     = "maxabs"
)",
         "drivers.left.samples=61"},
    Kind{
        "geared_five_bar",
        R"(crank = { path = ["bodies.left_crank.points.A.0", "bodies.right_crank.points.B.0"], min = 20, max = 40 }
link  = { path = ["bodies.left_link.points.T.0", "bodies.right_link.points.T.0"], min = 110, max = 130 }
)",
        R"([[design.objectives]]
column = "left_link.T.x"
of     = "range"
[[design.constraints]]
column = "left_link.T.vy"
of     = "maxabs"
below  = 300
)"},
    Kind{"planetary_gear",
         R"(tracer = { path = "bodies.planet.points.tracer.0", min = 1, max = 8 }
arm    = { path = ["bodies.arm.points.P.0", "bodies.planet.pose.x"], min = 25, max = 30 }
)",
         R"([[design.objectives]]
column = "planet.tracer.x"
of     = "max"
[[design.objectives]]
path = { point = "planet.tracer", through = [[20, 10], [10, 20], [-10, 20]] }
)"},
    Kind{"ellipse_cam_roller",
         R"(pivot  = { path = "bodies.ground.points.O2.0", min = 75, max = 90 }
roller = { path = "bodies.follower.curves.roller.radius", min = 8, max = 16 }
centre = { path = "bodies.cam.curves.oval.center.0", min = 4, max = 12 }
)",
         R"([[design.objectives]]
column = "follower.alpha"
of     = "maxabs"
[[design.constraints]]
column = "touch.pressure"
of     = "maxabs"
below  = 40
)"},
    Kind{"law_cam_roller",
         R"(prime  = { path = "bodies.follower.pose.y", min = 45, max = 60 }
roller = { path = "bodies.follower.curves.roller.radius", min = 8, max = 12 }
)",
         R"([[design.objectives]]
column = "touch.pressure"
of     = "max"
target = 20
[[design.constraints]]
column = "touch.rho1"
of     = "at"
at     = 60
above  = 40
)"},
    Kind{"roller_body",
         R"(arm    = { path = "bodies.arm.points.P.0", min = -65, max = -55 }
roller = { path = "bodies.roller.curves.rim.radius", min = 10, max = 20 }
)",
         R"([[design.objectives]]
column = "arm.angle"
of     = "range"
target = 20
)"}};

TEST(Kinds, HaveTheDerivativesOfDifferences) {
  for (const Kind& kind : kKindsOfTasks) {
    SCOPED_TRACE(kind.profile);
    const Model model = model_of(task_of(kind), {kind.rows});
    const Seen seen = compare(model, 4, 0.02, 11);
    EXPECT_EQ(seen.candidates, 4);
    EXPECT_GT(seen.numbers, 10 * seen.kinks);
    EXPECT_EQ(seen.off, 0);
  }
}

TEST(Gradients, AreThoseOfDifferencesFarAndNear) {
  for (const char* profile : {"design_five_points", "design_eighteen_points", "design_arch_path",
                              "design_ellipse_path", "design_straight_path"}) {
    SCOPED_TRACE(profile);
    const Seen near = compare(shipped_model(profile), 20, 0.05, 5);
    EXPECT_EQ(near.candidates, 20);
    EXPECT_GT(near.numbers, 10 * near.kinks);
    EXPECT_EQ(near.off, 0);
    // Most of these cannot turn; their shortfall is differentiated for pin linkages only.
    const Seen far = compare(shipped_model(profile), 60, 1, 6, true);
    EXPECT_GE(far.candidates, 10);
    EXPECT_GT(far.numbers, 3 * far.kinks);
    EXPECT_EQ(far.off, 0);
  }
}

// A path whose position, rotation and scale do not count, in every combination.
TEST(FreePaths, HaveTheDerivativesOfDifferences) {
  for (const char* free : {"[\"position\"]", "[\"turn\"]", "[\"scale\"]", "[\"position\", \"scale\"]",
                           "[\"position\", \"turn\"]", "[\"position\", \"turn\", \"scale\"]"}) {
    const Model model =
        shipped_model("design_eighteen_points", {std::string("design.objectives.0.path.free=") + free});
    const Seen seen = compare(model, 10, 0.05, 3);
    EXPECT_EQ(seen.candidates, 10);
    EXPECT_GT(seen.numbers, 10 * seen.kinks) << free;
    EXPECT_EQ(seen.off, 0) << free;
  }
}

}  // namespace
}  // namespace higherpair

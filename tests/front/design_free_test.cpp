// Paths of which only the shape counts, without times: they are recognised wherever they are.
#include "front/cam_profile.hpp"
#include "higherpair/design/optimise.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::shipped_model;
using Complex = std::complex<double>;

// A four-bar whose crank turns once, with a task about its coupler's path.
Model four_bar(const std::vector<std::string>& overrides) {
  std::vector<std::string> all = {"driver.start=0", "driver.end=360", "driver.samples=73"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return shipped_model("design_ellipse_path", all);
}

// Points of the model's path at unequal distances, between the rows, beginning at a fraction of the turn;
// each is transformed by p -> z p + t.
std::string points_of(const Model& model, int count, double from, double turns, Complex z, Complex t) {
  std::string at = "[0";  // the first point belongs to the poses
  for (int k = 0; k < count; ++k) {
    const double share = (k + 0.3 * std::sin(2.0 * k)) / count;
    at += fmt::format(", {}", 360 * (from + turns * share));
  }
  const Motion motion = model.with({{"driver.positions", at + "]"}}).value().run().value();
  std::string points = "[";
  for (std::size_t k = 1; k < motion.size(); ++k) {
    const Complex p = z * Complex(motion.column("coupler.E.x")[k], motion.column("coupler.E.y")[k]) + t;
    points += fmt::format("{}[{}, {}]", k == 1 ? "" : ", ", p.real(), p.imag());
  }
  return points + "]";
}

std::string path(const std::string& points, const std::string& keys) {
  return fmt::format("design.objectives=[{{ path = {{ point = \"coupler.E\", through = {}, {} }} }}]", points,
                     keys);
}

DesignReport designed(const Model& model, int starts) {
  DesignSettings settings;
  settings.starts = starts;
  auto report = design(model, settings);
  if (!report) throw std::runtime_error(to_string(report.error()));
  return *std::move(report);
}

TEST(FormsOfPaths, AreFoundWhereverTheyLie) {
  const Complex z = std::polar(1.7, 2.1), t = {40, -25};
  const Model known = four_bar({});
  struct Case {
    const char* keys;
    double from, turns;
    Complex z, t;
  };
  for (const Case& one :
       {Case{R"(closed = true, free = ["position", "turn", "scale"])", 0.37, 1, z, t},
        Case{R"(closed = true, free = ["position", "turn"])", 0.81, 1, std::polar(1.0, -2.4), t},
        Case{R"(free = ["position", "turn", "scale"])", 0.2, 0.6, z, t},
        Case{R"(ordered = false, free = ["position", "turn"])", 0.1, 0.5, std::polar(1.0, 0.7), t},
        Case{R"(closed = true, free = ["position"])", 0.5, 1, 1, t},
        Case{R"(closed = true, free = ["turn"])", 0.5, 1, std::polar(1.0, 0.4), 0}}) {
    const std::string points = points_of(known, 14, one.from, one.turns, one.z, one.t);
    const DesignReport report = designed(four_bar({path(points, one.keys)}), 1);
    EXPECT_LE(report.objectives[0].before, 1e-18) << one.keys;
    ASSERT_TRUE(report.objectives[0].placement) << one.keys;
    const auto& placed = *report.objectives[0].placement;
    const Complex found = std::polar(placed.scale, placed.turn * kPi / 180);
    // Where the pivots may move, rotating them is as good as rotating the path.
    if (std::all_of(report.variables.begin(), report.variables.end(),
                    [](const auto& variable) { return variable.after == variable.before; })) {
      EXPECT_LE(std::abs(found - one.z), 1e-9) << one.keys;
      EXPECT_LE(std::abs(Complex(placed.x, placed.y) - one.t), 1e-7) << one.keys;
    }
  }
}

// A negative factor would turn the path by half a turn.
TEST(FormsOfPaths, AreNotTurnedWhereOnlyTheirScaleIsFree) {
  const Model known = four_bar({});
  const std::string turned = points_of(known, 14, 0.3, 1, -1.2, {50, 40});
  const std::string at = "[5, 25, 40, 60, 85, 110, 140, 180, 210, 230, 260, 280, 310, 350]";
  for (const std::string& keys :
       {std::string(R"(closed = true, free = ["position", "scale"])"), std::string(R"(free = ["scale"])"),
        "timed = true, at = " + at + R"(, free = ["position", "scale"])"}) {
    const DesignReport report = designed(four_bar({path(turned, keys)}), 1);
    ASSERT_TRUE(report.objectives[0].placement) << keys;
    EXPECT_EQ(report.objectives[0].placement->turn, 0) << keys;
    EXPECT_GE(report.objectives[0].placement->scale, 0) << keys;
    EXPECT_GT(report.objectives[0].before, 1) << keys;
  }
}

// Starting from a different linkage, the known one is found from the shape of its path alone.
TEST(FormsOfPaths, AreEnoughToFindTheLinkage) {
  const Model known = four_bar({});
  const std::string points = points_of(known, 24, 0.3, 1, std::polar(0.6, -1.3), {5, 9});
  std::ostringstream text;
  text << std::ifstream(HIGHERPAIR_SOURCE_DIR "/profiles/design_ellipse_path.toml").rdbuf();
  std::string other = text.str();
  const std::string there = "points.E = [10, 10]";
  ASSERT_NE(other.find(there), std::string::npos);
  other.replace(other.find(there), there.size(), "points.E = [6, 14]");
  const Model model =
      testing::model_of(other, {path(points, R"(closed = true, free = ["position", "turn", "scale"])")});
  const DesignReport report = designed(model, 12);
  EXPECT_LE(report.after, 1e-9 * report.before);
}

// Derivatives of the single distances are correct only to first order in the distances; those of their sum
// are exact.
TEST(FormsOfPaths, HaveTheDerivativesOfTheirSum) {
  const Model known = four_bar({});
  const std::string points = points_of(known, 14, 0.3, 1, std::polar(1.4, -1.3), {5, 9});
  for (const char* keys : {R"(closed = true, free = ["position", "turn", "scale"])",
                           R"(closed = true, free = ["position", "turn"])",
                           R"(closed = true, free = ["turn"])", R"(free = ["position", "scale"])"}) {
    const DesignProblem problem = design_problem(four_bar({path(points, keys)})).value();
    const auto evaluator = problem.evaluator();
    std::mt19937 random(4);
    std::uniform_real_distribution<double> near(-0.02, 0.02);
    int compared = 0;
    for (int k = 0; k < 6; ++k) {
      std::vector<double> x;
      for (const DesignVariable& variable : problem.variables)
        x.push_back(variable.start * (1 + near(random)));
      const auto sum = [&] {
        DesignValues values;
        evaluator->evaluate(x, problem.start_branch, values);
        return values.residuals.squaredNorm();
      };
      DesignValues values;
      evaluator->evaluate(x, problem.start_branch, values);
      if (values.constraints.maxCoeff() > 0) continue;
      DesignJacobian jacobian;
      ASSERT_TRUE(evaluator->differentiate(x, problem.start_branch, jacobian));
      const Eigen::RowVectorXd gradient = 2 * values.residuals.transpose() * jacobian.residuals;
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double at = x[i], h = 1e-5;
        x[i] = at + h;
        const double high = sum();
        x[i] = at - h;
        const double low = sum();
        x[i] = at;
        EXPECT_NEAR(gradient(static_cast<Eigen::Index>(i)), (high - low) / (2 * h),
                    1e-6 * (1 + gradient.norm()))
            << keys << ", candidate " << k << ", variable " << i;
        ++compared;
      }
    }
    EXPECT_GE(compared, 12) << keys;
  }
}

// The same shape is read from a table, wherever its points are.
TEST(FormsOfPaths, ThatAreShippedFitIntoTheirBox) {
  const DesignReport report = designed(shipped_model("design_film_hook"), 8);
  EXPECT_TRUE(report.holds);
  EXPECT_LE(report.after, 5);  // sum over 14 points, mm^2
  ASSERT_EQ(report.constraints.size(), 3U);
  EXPECT_EQ(report.constraints[0].what, "width or height below 130");
}

}  // namespace
}  // namespace higherpair

// Derivatives of contacts of composite curves: compared with conics of the same shape, with closed forms, and
// with runs with other numbers.
#include "front/cam_profile.hpp"
#include "higherpair/higherpair.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::model_of;
using testing::shipped_model;

// All columns of all rows, and their derivatives by all numbers that the profile names.
struct Slopes {
  std::vector<Column> columns;
  std::vector<SensitivityNumber> numbers;
  std::vector<std::vector<double>> values, slopes;  // row by row
};

Slopes slopes_of(const Model& model, const std::vector<std::string>& columns,
                 const std::vector<std::string>& by = {}) {
  SensitivitySettings settings;
  settings.by = by;
  Slopes all;
  const auto table = sensitivity_rows(
      model, columns, settings,
      [&](const SlopeTable& made) {
        all.columns = made.columns;
        all.numbers = made.numbers;
      },
      [&](const RowSlopes& row) {
        all.values.emplace_back(row.values.begin(), row.values.end());
        all.slopes.emplace_back(row.slopes.begin(), row.slopes.end());
        return true;
      });
  EXPECT_TRUE(table) << (table ? "" : to_string(table.error()));
  return all;
}

constexpr double kNothing = 1e-6;  // in the units of tables: columns that are 0 to within rounding

// The largest absolute value of each column over all rows.
std::vector<double> largest_of(const Slopes& all) {
  std::vector<double> largest(all.columns.size(), 0);
  for (std::size_t k = 0; k < all.values.size(); ++k) {
    for (std::size_t c = 0; c < largest.size(); ++c) {
      if (std::isfinite(all.values[k][c])) largest[c] = std::max(largest[c], std::abs(all.values[k][c]));
    }
  }
  return largest;
}

// An eccentric and a follower on it; the outline of the eccentric is filled in.
constexpr const char* kSwinging = R"(
[bodies.ground]
points = { O1 = [0, 0], O2 = [70, 5] }
[bodies.cam]
points.O = [0, 0]
[bodies.follower]
pose = { x = 70, y = 5, angle = 140 }
points.O = [0, 0]
mass = 0.3
center_of_mass = [30, 2]
inertia = "1.6e-5 kg m^2"
curves.roller = { type = "circle", center = [61, 2], radius = 8 }
[joints]
pivot = { type = "revolute", between = ["ground.O1", "cam.O"] }
arm   = { type = "revolute", between = ["ground.O2", "follower.O"] }
[contacts.touch]
between = ["cam.disc", "follower.roller"]
[driver]
joint        = "pivot"
start        = 3
end          = 350
samples      = 37
velocity     = "3 rad/s"
acceleration = "2 rad/s^2"
[tolerances]
roller = { path = "bodies.follower.curves.roller.radius", plus_minus = 0.1 }
length = { path = "bodies.follower.curves.roller.center.0", plus_minus = 0.1 }
pivot  = { path = "bodies.ground.points.O2.0", plus_minus = 0.1 }
)";

constexpr const char* kLifting = R"(
[bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
[bodies.follower]
pose = { x = 0, y = 45 }
points.O = [0, 0]
mass = 0.3
center_of_mass = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = [0.2, -1] }
[joints]
pivot = { type = "revolute", between = ["ground.O", "cam.O"] }
slide = { type = "prismatic", between = ["ground.O", "follower.O"], direction = [0, 1] }
[contacts.touch]
between = ["cam.disc", "follower.face"]
[driver]
joint        = "pivot"
start        = 3
end          = 350
samples      = 37
velocity     = "3 rad/s"
acceleration = "2 rad/s^2"
[tolerances]
normal = { path = "bodies.follower.curves.face.normal.0", plus_minus = 0.1 }
point  = { path = "bodies.follower.curves.face.point.1", plus_minus = 0.1 }
)";

constexpr const char* kDisc = R"(
eccentricity = { path = "bodies.cam.curves.disc.center.0", plus_minus = 0.1 }
radius       = { path = "bodies.cam.curves.disc.radius", plus_minus = 0.1 }
[bodies.cam.curves.disc]
type   = "circle"
center = [10, 3]
radius = 31
)";

constexpr const char* kTwoArcs = R"(
[tolerances.eccentricity]
path       = ["bodies.cam.curves.disc.spans.0.center.0", "bodies.cam.curves.disc.spans.1.center.0"]
plus_minus = 0.1
[tolerances.radius]
path       = ["bodies.cam.curves.disc.spans.0.radius", "bodies.cam.curves.disc.spans.1.radius"]
plus_minus = 0.1
[bodies.cam.curves.disc]
type  = "chain"
spans = [ { type = "arc", center = [10, 3], radius = 31, from = -37, to = 143 },
          { type = "arc", center = [10, 3], radius = 31, from = 143, to = 323 } ]
)";

// The same disc as an offset of a smaller one.
constexpr const char* kOffset = R"(
[tolerances.eccentricity]
path       = "bodies.cam.curves.core.center.0"
plus_minus = 0.1
[tolerances.radius]
path       = "bodies.cam.curves.core.radius"
plus_minus = 0.1
[bodies.cam.curves]
core = { type = "circle", center = [10, 3], radius = 24 }
disc = { type = "offset", of = "core", by = 7 }
)";

class OfADisc : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(OfADisc, AreThoseOfTheConic) {
  const auto& [follower, chain] = GetParam();
  const std::vector<std::string> columns = {"follower.*", "touch.x",      "touch.y",       "touch.normal",
                                            "touch.rho*", "touch.c*",     "touch.sliding", "touch.pressure",
                                            "touch.r3",   "touch.force*", "driver.effort*"};
  const Slopes expected = slopes_of(model_of(follower + std::string(kDisc)), columns);
  const Slopes found = slopes_of(model_of(follower + std::string(chain)), columns);
  ASSERT_EQ(found.columns.size(), expected.columns.size());
  ASSERT_EQ(found.numbers.size(), expected.numbers.size());
  ASSERT_EQ(found.slopes.size(), 37U);
  const std::vector<double> largest = largest_of(expected);
  double worst = 0;
  for (std::size_t i = 0; i < expected.numbers.size(); ++i) {
    ASSERT_EQ(found.numbers[i].name, expected.numbers[i].name);
    for (std::size_t c = 0; c < largest.size(); ++c) {
      ASSERT_EQ(found.columns[c].name, expected.columns[c].name);
      for (std::size_t k = 0; k < found.slopes.size(); ++k) {
        const double ours = found.slopes[k][i * largest.size() + c];
        const double theirs = expected.slopes[k][i * largest.size() + c];
        if (std::isnan(theirs) || largest[c] < kNothing) continue;
        const double off = std::abs(ours - theirs) / (std::abs(theirs) + largest[c] / 30);
        worst = std::isnan(off) || off > worst ? off : worst;
        EXPECT_LE(off, 2e-10) << found.columns[c].name << " by " << found.numbers[i].name << " in row " << k
                              << ": " << ours << ", of the conic " << theirs;
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

INSTANTIATE_TEST_SUITE_P(OfDiscs, OfADisc,
                         ::testing::Values(std::pair(kSwinging, kTwoArcs), std::pair(kSwinging, kOffset),
                                           std::pair(kLifting, kTwoArcs), std::pair(kLifting, kOffset)),
                         [](const auto& one) {
                           return std::string(one.param.first == kSwinging ? "Swinging" : "Lifting") +
                                  (one.param.second == kTwoArcs ? "TwoArcs" : "Offset");
                         });

// A roller swings on a cam; the keys of the cam's curve are filled in.
std::string under_a_roller(const std::string& curve) {
  return std::string(R"(
[bodies.ground]
points = { O1 = [0, 0], O2 = [70, 5] }
[bodies.cam]
points.O = [0, 0]
[bodies.cam.curves.disc]
)") + curve +
         R"([bodies.follower]
pose = { x = 70, y = 5, angle = 150 }
points.O = [0, 0]
curves.roller = { type = "circle", center = [51, 2], radius = 9 }
[joints]
pivot = { type = "revolute", between = ["ground.O1", "cam.O"] }
arm   = { type = "revolute", between = ["ground.O2", "follower.O"] }
[contacts.touch]
between = ["cam.disc", "follower.roller"]
[driver]
joint    = "pivot"
end      = 360
samples  = 50
velocity = "3 rad/s"
)";
}

// A cam of straight edges and an arc with rounded corners.
const std::string kFillets = under_a_roller(R"(type   = "chain"
fillet = 6
spans  = [ { type = "segment", from = [-25, -20], to = [28, -18] },
           { type = "segment", from = [28, -18], to = [20, 24] },
           { type = "segment", from = [20, 24], to = [-22, 27] },
           { type = "segment", from = [-22, 27], to = [-25, -20] } ]
)");

const std::string kPoints = under_a_roller(R"(type   = "spline"
points = [[30, 0], [25, 17], [8, 29], [-9, 27], [-22, 15], [-26, -1], [-21, -16], [-8, -25], [8, -26], [23, -17]]
)");

struct Shape {
  const char* name;
  std::string text;  // empty: a shipped profile
  std::vector<std::string> numbers;
  std::vector<std::string> overrides = {};
};

Model model_of(const Shape& shape) {
  return !shape.text.empty() ? model_of(shape.text, shape.overrides)
                             : shipped_model(shape.name, shape.overrides);
}

// Differences of the sixth order between runs with other numbers, with an estimate of their error.
void expect_differences_of_runs(const Shape& shape, const std::vector<std::string>& columns,
                                const RunSettings& settings, double tolerance, int least) {
  const Model model = model_of(shape);
  const Slopes found = slopes_of(model, columns, shape.numbers);
  const std::vector<double> largest = largest_of(found);
  const std::size_t count = largest.size();
  double worst = 0;
  int compared = 0;
  for (std::size_t i = 0; i < found.numbers.size(); ++i) {
    const double value = found.numbers[i].value, scale = std::max(std::abs(value), 10.0);
    const double h = 1e-4 * scale;
    std::vector<Motion> runs;
    for (const double step : {-3.0, -2.0, -1.0, 1.0, 2.0, 3.0}) {
      const auto other = model.with({{found.numbers[i].paths[0], value + step * h}});
      ASSERT_TRUE(other) << to_string(other.error());
      runs.push_back(other->run(settings).value());
    }
    for (std::size_t c = 0; c < count; ++c) {
      const std::string& name = found.columns[c].name;
      if (name.ends_with(".arc1") || name.ends_with(".arc2") || largest[c] < kNothing) continue;
      for (std::size_t k = 0; k < found.slopes.size(); ++k) {
        const auto half = [&](std::size_t steps) {
          return (runs[2 + steps].column(name)[k] - runs[3 - steps].column(name)[k]) /
                 (2 * static_cast<double>(steps) * h);
        };
        const double sixth = 1.5 * half(1) - 0.6 * half(2) + 0.1 * half(3);
        const double doubt = std::abs(sixth - (4 * half(1) - half(2)) / 3);
        const double ours = found.slopes[k][i * count + c];
        if (std::isnan(sixth) && std::isnan(ours)) continue;
        // A size without sign that is 0 has none: to both sides it grows.
        const double grows = runs[3].column(name)[k] - found.values[k][c];
        const bool kink = std::abs(sixth) < kNothing && grows > kNothing;
        if (kink && std::isnan(ours)) continue;
        const double size = std::abs(sixth) + largest[c] / scale;
        // Where a centre of curvature passes a pivot, its distance from the pivot is not smooth.
        const bool passes = name == "touch.r2" && found.values[k][c] < 1;
        // Near a joint of two spans the other numbers lead to its other side.
        if (!(doubt <= 1e-4 * size) || passes) continue;
        ++compared;
        const double off = std::abs(ours - sixth) / size;
        worst = std::isnan(off) || off > worst ? off : worst;
        EXPECT_LE(std::abs(ours - sixth), tolerance * size + doubt)
            << name << " by " << found.numbers[i].name << " in row " << k << ": " << ours << ", " << sixth;
      }
    }
  }
  EXPECT_GT(compared, least);
  ::testing::Test::RecordProperty("worst", std::to_string(worst));
}

const Shape kShapesOfCams[] = {
    Shape{"Fillets", kFillets, {"bodies.cam.curves.disc.fillet", "bodies.ground.points.O2.0"}},
    Shape{"Points",
          kPoints,
          {"bodies.cam.curves.disc.points.2.0", "bodies.cam.curves.disc.points.7.1",
           "bodies.follower.curves.roller.radius"}},
    Shape{"law_cam_roller",
          "",
          {"bodies.follower.pose.y", "bodies.follower.curves.roller.radius", "bodies.ground.points.rail.0"},
          {"driver.samples=41"}},
    Shape{"law_cam_flat", "", {"bodies.follower.pose.y"}, {"driver.samples=41"}},
    Shape{"spline_cam",
          "",
          {"bodies.ground.points.O2.0", "bodies.follower.curves.roller.center.0"},
          {"driver.samples=41"}},
    Shape{"tangent_cam",
          "",
          {"bodies.ground.points.rail.0", "bodies.follower.curves.roller.radius"},
          {"driver.samples=41"}},
    Shape{"groove_cam", "", {"bodies.lever.curves.roller.radius"}, {"driver.samples=41"}},
    Shape{"valve_train",
          "",
          {"bodies.finger.curves.pad.radius", "bodies.finger.curves.nose.center.0"},
          {"driver.samples=41"}},
    Shape{"involute_pair", "", {"bodies.ground.points.O2.0"}, {"driver.samples=21"}}};

TEST(OfShapes, AreTheDifferencesBetweenRunsWithOtherNumbers) {
  for (const Shape& shape : kShapesOfCams) {
    SCOPED_TRACE(shape.name);
    expect_differences_of_runs(shape, {"*"}, {}, 2e-7, 300);
  }
}

TEST(OfShapes, OfJerksAreTheDifferencesBetweenRunsWithOtherNumbers) {
  for (const Shape& shape : kShapesOfCams) {
    SCOPED_TRACE(shape.name);
    RunSettings settings;
    settings.jerk = true;
    expect_differences_of_runs(shape, {"*.jerk", "*.j?"}, settings, 2e-6, 15);
  }
}

// A closed spline with a waist, and an offset of it.
constexpr const char* kWaist = R"(
[bodies.ground]
points = { O = [0, 0], P = [90, 10] }
[bodies.cam]
points.O = [0, 0]
curves.core = { type = "spline", points = [[45, 0], [42.052097, 11.267825], [34.641016, 20], [25.784271, 25.784271],
  [17.5, 30.310889], [9.437698, 35.22197], [0, 40], [-11.267825, 42.052097], [-22.5, 38.971143],
  [-30.784271, 30.784271], [-34.641016, 20], [-35.22197, 9.437698], [-35, 0], [-35.22197, -9.437698],
  [-34.641016, -20], [-30.784271, -30.784271], [-22.5, -38.971143], [-11.267825, -42.052097], [0, -40],
  [9.437698, -35.22197], [17.5, -30.310889], [25.784271, -25.784271], [34.641016, -20], [42.052097, -11.267825]] }
curves.grown = { type = "offset", of = "core", by = 3 }
[bodies.follower]
pose = { x = 90, y = 10, angle = 0 }
points.O = [0, 0]
curves.roller = { type = "circle", center = [-80, 30], radius = 6 }
[joints]
arm = { type = "revolute", between = ["ground.P", "follower.O"] }
pivot = { type = "revolute", between = ["ground.O", "cam.O"] }
[contacts.touch]
between = ["cam.core", "follower.roller"]
[driver]
joint = "pivot"
velocity = "3 rad/s"
positions = [0]
)";

Motion motion_at(const Shape& shape, const std::vector<double>& positions) {
  std::string list;
  for (const double at : positions) list += fmt::format("{}{}", list.empty() ? "" : ", ", at);
  Shape other = shape;
  other.overrides.push_back("driver.positions=[" + list + "]");
  return model_of(other).run().value();
}

// The first place at which the cam's curvature passes 0 continuously.
double inflection_of(const Shape& shape) {
  const auto flatness = [&](const std::vector<double>& positions) {
    const Motion motion = motion_at(shape, positions);
    std::vector<double> all;
    for (const double rho : motion.column("touch.rho1")) all.push_back(std::isnan(rho) ? 0 : 1 / rho);
    return all;
  };
  std::vector<double> positions;
  for (int k = 0; k <= 360; ++k) positions.push_back(k);
  const std::vector<double> all = flatness(positions);
  for (std::size_t k = 0; k + 1 < all.size(); ++k) {
    if (!(all[k] * all[k + 1] < 0)) continue;
    double low = positions[k], high = positions[k + 1];
    while (std::nextafter(low, high) < high) {
      const double middle = (low + high) / 2;
      if (middle == low || middle == high) break;
      (flatness({middle})[0] * all[k] > 0 ? low : high) = middle;
    }
    if (std::abs(flatness({low})[0]) < 1e-9) return low;
  }
  ADD_FAILURE() << "no inflection";
  return 0;
}

Shape near_inflection(const Shape& shape) {
  const double at = inflection_of(shape);
  std::string list = fmt::format("{}", at);
  for (const double off : {1e-1, 1e-3, 1e-5, 1e-6, 1e-7, 1e-9}) {
    list += fmt::format(", {}, {}", at - off, at + off);
  }
  Shape near = shape;
  near.overrides.push_back("driver.positions=[" + list + "]");
  return near;
}

const Shape kShapesWithInflections[] = {
    Shape{"Spline",
          kWaist,
          {"bodies.cam.curves.core.points.2.1", "bodies.follower.curves.roller.radius",
           "bodies.ground.points.P.0"}},
    Shape{"Offset",
          kWaist,
          {"bodies.cam.curves.grown.by", "bodies.cam.curves.core.points.3.0"},
          {"contacts.touch.between=[\"cam.grown\", \"follower.roller\"]"}},
    Shape{"law_cam_roller",
          "",
          {"bodies.follower.pose.y", "bodies.follower.curves.roller.radius", "bodies.ground.points.rail.0"},
          {"bodies.follower.pose.y=25"}}};

// Radii have a pole there, but not what moves.
TEST(OfInflections, AreTheDifferencesBetweenRunsWithOtherNumbers) {
  for (const Shape& shape : kShapesWithInflections) {
    SCOPED_TRACE(shape.name + std::string(" ") + shape.numbers[0]);
    expect_differences_of_runs(
        near_inflection(shape),
        {"follower.*", "touch.x", "touch.y", "touch.normal", "touch.sliding", "touch.pressure"}, {}, 2e-7,
        150);
  }
}

// dκ/dp = -(dρ/dp)/ρ² is the same on either side, however large ρ is.
TEST(OfInflections, OfRadiiAreThoseOfTheCurvature) {
  for (const Shape& shape : kShapesWithInflections) {
    SCOPED_TRACE(shape.name + std::string(" ") + shape.numbers[0]);
    const Shape near = near_inflection(shape);
    const Slopes found = slopes_of(model_of(near), {"touch.rho1"}, near.numbers);
    const auto c = static_cast<std::size_t>(
        std::find_if(found.columns.begin(), found.columns.end(),
                     [](const Column& column) { return column.name == "touch.rho1"; }) -
        found.columns.begin());
    for (std::size_t i = 0; i < found.numbers.size(); ++i) {
      const auto by_number = [&](std::size_t row) {
        const double rho = found.values[row][c];
        return -found.slopes[row][i * found.columns.size() + c] / (rho * rho);
      };
      const double expected = (by_number(3) + by_number(4)) / 2;  // at 1e-3 degrees
      for (std::size_t row = 5; row < found.values.size() - 2; ++row) {
        EXPECT_NEAR(by_number(row), expected, 1e-4 * std::abs(expected) + 1e-9)
            << found.numbers[i].name << ", row " << row;
      }
    }
  }
}

TEST(OfInflections, OfJerksAreTheDifferencesBetweenRunsWithOtherNumbers) {
  for (const Shape& shape : kShapesWithInflections) {
    SCOPED_TRACE(shape.name + std::string(" ") + shape.numbers[0]);
    RunSettings settings;
    settings.jerk = true;
    expect_differences_of_runs(near_inflection(shape), {"follower.jerk", "follower.*.j?"}, settings, 2e-5,
                               10);
  }
}

// A closed spline whose points are off a circle by little: its curvature has many extremes.
std::string rippled_cam(int count, double ripple) {
  std::string points;
  for (int k = 0; k < count; ++k) {
    const double at = 2 * kPi * k / count, r = 30 + ripple * std::sin(k * k);
    points += fmt::format("[{:.4f}, {:.4f}], ", 6 + r * std::cos(at), r * std::sin(at));
  }
  return fmt::format(R"(
[bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
curves.flank = {{ type = "spline", points = [{}] }}
[bodies.follower]
pose = {{ y = 40 }}
points.F = [0, 0]
curves.face = {{ type = "line", point = [0, 0], normal = [0, -1] }}
[joints]
main  = {{ type = "revolute", between = ["ground.O", "cam.O"] }}
guide = {{ type = "prismatic", between = ["ground.O", "follower.F"], direction = [0, 1] }}
[contacts.touch]
between = ["cam.flank", "follower.face"]
[driver]
joint    = "main"
end      = 360
samples  = 37
velocity = 800
)",
                     points);
}

// The slopes of the follower's largest acceleration and of its stroke, and their central differences over so
// small steps that the extremes stay where they are.
void expect_slopes_of_results(const Model& model, const std::vector<std::string>& by,
                              SlopeKind of_acceleration) {
  SensitivitySettings settings;
  for (const char* result : {"guide.acceleration:maxabs", "guide.position:range"}) {
    settings.results.push_back(measure_from(model, result).value());
  }
  settings.by = by;
  const auto report = sensitivity(model, settings);
  ASSERT_TRUE(report) << to_string(report.error());
  settings.by = {"bodies.cam.points.O.0"};
  for (std::size_t i = 0; i < report->numbers.size(); ++i) {
    const SensitivityNumber& number = report->numbers[i];
    std::vector<SensitivityReport> beside;
    const double h = 1e-5;
    for (const double step : {-h, h}) {
      const auto other = model.with({{number.paths[0], number.value + step}});
      ASSERT_TRUE(other) << to_string(other.error());
      beside.push_back(sensitivity(*other, settings).value());
    }
    for (std::size_t m = 0; m < report->results.size(); ++m) {
      const Slope& slope = report->results[m].slopes[i];
      const double expected = (beside[1].results[m].value - beside[0].results[m].value) / (2 * h);
      EXPECT_EQ(static_cast<int>(slope.kind), static_cast<int>(m == 0 ? of_acceleration : SlopeKind::kExact))
          << number.name << ", " << report->results[m].name;
      EXPECT_NEAR(slope.up, expected, 1e-5 * std::abs(expected) + 1e-6 * report->results[m].value)
          << number.name << ", " << report->results[m].name;
      EXPECT_LE(slope.error, 1e-4 * std::abs(expected) + 1e-6 * report->results[m].value) << number.name;
    }
  }
}

// The face is followed as far as the size of the cam requires, which jumps where the cam has other samples.
TEST(OfARippledCam, AreExactOnAFlatFace) {
  expect_slopes_of_results(model_of(rippled_cam(36, 0.02)), {"bodies.cam.curves.flank.points.*"},
                           SlopeKind::kExact);
}

// The largest acceleration is at a point of the spline, where the curvature has a corner. Already with a
// point a hundredth off it is elsewhere.
TEST(OfARippledCam, AreThoseOfTheExtremeThatAnotherOneSoonExceeds) {
  expect_slopes_of_results(model_of(rippled_cam(60, 0.01)),
                           {"bodies.cam.curves.flank.points.19.1", "bodies.cam.curves.flank.points.22.1",
                            "bodies.cam.curves.flank.points.24.0", "bodies.cam.curves.flank.points.25.1",
                            "bodies.cam.curves.flank.points.50.0"},
                           SlopeKind::kDifferences);
}

// All points of a spline moved by the same are the spline moved: as if the cam's pivot moved the other way.
// At its points, where it has only a continuous curvature, too.
TEST(OfSplines, ByAllPointsAreThoseByItsPosition) {
  const std::vector<std::string> columns = {"follower.angle", "follower.omega", "follower.alpha",
                                            "touch.rho1"};
  const std::vector<std::string> by = {"bodies.cam.curves.disc.points.*.0", "bodies.cam.points.O.0"};
  const Slopes found = slopes_of(model_of(kPoints, {"driver.samples=361"}), columns, by);
  ASSERT_EQ(found.numbers.size(), 11U);
  const std::size_t count = found.columns.size();
  const std::vector<double> largest = largest_of(found);
  std::size_t pivot = 0;
  while (found.numbers[pivot].name != "bodies.cam.points.O.0") ++pivot;
  double worst = 0;
  for (std::size_t k = 0; k < found.slopes.size(); ++k) {
    for (std::size_t c = 0; c < count; ++c) {
      if (largest[c] < kNothing) continue;
      double sum = 0, size = largest[c] / 30;
      for (std::size_t i = 0; i < found.numbers.size(); ++i) {
        const double slope = found.slopes[k][i * count + c];
        sum += slope;
        size = std::max(size, std::abs(slope));
      }
      worst = std::max(worst, std::abs(sum) / size);
      EXPECT_NEAR(sum, 0, 1e-9 * size) << found.columns[c].name << " in row " << k;
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

// The same numbers in other units give a larger or smaller copy.
TEST(OfCopies, ThatAreScaledAreTheSameNumbers) {
  const std::vector<std::string> columns = {"follower.*", "touch.x", "touch.rho1", "touch.pressure"};
  const std::vector<std::string> by = {"bodies.cam.curves.disc.points.2.0", "bodies.ground.points.O2.0"};
  const Slopes one = slopes_of(model_of(kPoints), columns, by);
  const std::vector<double> largest = largest_of(one);
  for (const char* unit : {"um", "km"}) {
    const std::string text = std::string("units.length = \"") + unit + "\"\n" + kPoints;
    const Slopes other = slopes_of(model_of(text), columns, by);
    ASSERT_EQ(other.slopes.size(), one.slopes.size());
    for (std::size_t k = 0; k < one.slopes.size(); ++k) {
      for (std::size_t j = 0; j < one.slopes[k].size(); ++j) {
        if (largest[j % largest.size()] < kNothing) continue;
        EXPECT_NEAR(other.slopes[k][j], one.slopes[k][j],
                    1e-9 * (std::abs(one.slopes[k][j]) + largest[j % largest.size()] / 10))
            << unit << ", row " << k << ", " << one.columns[j % largest.size()].name;
      }
    }
  }
}

TEST(OfCopies, ThatAreMirroredAreMirrored) {
  const std::vector<std::string> columns = {"follower.angle", "follower.omega", "follower.alpha",
                                            "touch.pressure"};
  const std::string text = kSwinging + std::string(kOffset);
  const Slopes one = slopes_of(model_of(text), columns);
  const Slopes image = slopes_of(
      model_of(text, {"bodies.ground.points.O2.1=-5", "bodies.follower.pose.y=-5",
                      "bodies.follower.pose.angle=-140", "bodies.follower.curves.roller.center.1=-2",
                      "bodies.cam.curves.core.center.1=-3", "driver.start=-3", "driver.end=-350",
                      "driver.velocity=-3 rad/s", "driver.acceleration=-2 rad/s^2"}),
      columns);
  ASSERT_EQ(image.slopes.size(), one.slopes.size());
  const std::vector<double> largest = largest_of(one);
  for (std::size_t k = 0; k < one.slopes.size(); ++k) {
    for (std::size_t j = 0; j < one.slopes[k].size(); ++j) {
      const std::size_t c = j % largest.size();
      const double sign = one.columns[c].name == "touch.pressure" ? 1 : -1;
      if (c == 0) continue;  // the driver
      EXPECT_NEAR(image.slopes[k][j], sign * one.slopes[k][j],
                  1e-9 * (std::abs(one.slopes[k][j]) + largest[c] / 10))
          << "row " << k << ", " << one.columns[c].name;
    }
  }
}

}  // namespace
}  // namespace higherpair

// Derivatives of results: closed forms, differences between whole runs with other numbers, kinks, and results
// without a derivative.
#include "front/cam_profile.hpp"
#include "front/slider_profile.hpp"
#include "higherpair/higherpair.hpp"
#include "io/profile_testing.hpp"
#include "sliding_cam.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::contains_all;
using testing::kCam;
using testing::kSlider;
using testing::lines_are;
using testing::model_of;
using testing::profile_of;
using testing::replaced;
using testing::shipped_model;

constexpr const char* kRocker = R"(
[bodies.ground]
points = { O2 = [0, 0], O4 = [80, 0] }
[bodies.crank]
points = { O = [0, 0], A = [20, 0] }
[bodies.coupler]
pose   = { x = 20, y = 0, angle = 45 }
points = { A = [0, 0], B = [70, 0] }
[bodies.rocker]
pose   = { x = 80, y = 0, angle = 100 }
points = { O = [0, 0], B = [50, 0] }
[joints]
o = { type = "revolute", between = ["ground.O2", "crank.O"] }
a = { type = "revolute", between = ["crank.A", "coupler.A"] }
b = { type = "revolute", between = ["coupler.B", "rocker.B"] }
p = { type = "revolute", between = ["ground.O4", "rocker.O"] }
[driver]
joint = "o"
samples = 20
)";

// Places are in degrees, as in all profiles here.
SensitivitySettings wanted(const std::vector<std::string>& results, const std::vector<std::string>& by = {}) {
  SensitivitySettings settings;
  const Model model = model_of(kRocker);
  for (const std::string& result : results) {
    settings.results.push_back(measure_from(model, result).value());
  }
  settings.by = by;
  return settings;
}

SensitivityReport report_of(const Model& model, const SensitivitySettings& settings) {
  const auto report = sensitivity(model, settings);
  EXPECT_TRUE(report) << (report ? "" : to_string(report.error()));
  return report.value_or(SensitivityReport());
}

const Slope& slope(const SensitivityReport& report, std::size_t result, const std::string& number) {
  static const Slope kNoSlope;
  for (std::size_t i = 0; i < report.numbers.size(); ++i) {
    if (report.numbers[i].name == number) return report.results.at(result).slopes.at(i);
  }
  ADD_FAILURE() << "no number " << number;
  return kNoSlope;
}

double exact(const SensitivityReport& report, std::size_t result, const std::string& number) {
  const Slope& found = slope(report, result, number);
  EXPECT_EQ(found.kind, SlopeKind::kExact) << number << ": " << found.remark;
  EXPECT_EQ(found.down, found.up) << number;
  return found.up;
}

std::string refusal(const Model& model, const SensitivitySettings& settings = {}) {
  const auto report = sensitivity(model, settings);
  return report ? "" : to_string(report.error());
}

// Stroke of an offset slider-crank: √((l+r)² − e²) − √((l−r)² − e²), independent of the rows.
TEST(SensitivityOfResults, TheStrokeOfASliderCrankIsTheClosedForm) {
  const double r = 30, l = 100, e = 12;
  const auto far = [&](double s) { return std::sqrt((l + s * r) * (l + s * r) - e * e); };
  for (const char* samples : {"driver.samples=7", "driver.samples=361", "driver.samples=50"}) {
    const SensitivityReport report =
        report_of(model_of(kSlider, {samples}), wanted({"slider.x:range", "slider.x:max", "slider.x:min"}));
    EXPECT_NEAR(report.results[0].value, far(1) - far(-1), 1e-10);
    const double by_r = (l + r) / far(1) + (l - r) / far(-1);
    EXPECT_NEAR(exact(report, 0, "bodies.crank.points.A.0"), by_r, 1e-9) << samples;
    const double by_l = (l + r) / far(1) - (l - r) / far(-1);
    EXPECT_NEAR(exact(report, 0, "bodies.rod.points.B.0"), by_l, 1e-9);
    EXPECT_NEAR(exact(report, 0, "bodies.ground.points.rail.1"), -e / far(1) + e / far(-1), 1e-9);
    EXPECT_NEAR(exact(report, 1, "bodies.crank.points.A.0"), (l + r) / far(1), 1e-9);
    EXPECT_NEAR(exact(report, 2, "bodies.crank.points.A.0"), -(l - r) / far(-1), 1e-9);
    // The second coordinate of the crank's end changes the crank's length only to second order, and its
    // start; the start only moves the position of an extreme, not its value.
    EXPECT_NEAR(exact(report, 0, "bodies.crank.points.A.1"), 0, 1e-9);
    EXPECT_EQ(exact(report, 0, "bodies.rod.pose.x"), 0);
  }
}

// Swing between the positions in which crank and coupler are in line, for crank-rockers of any lengths.
TEST(SensitivityOfResults, TheSwingOfARockerIsTheClosedForm) {
  const auto swing = [](double a, double b, double c, double d) {
    const auto limit = [&](double s) {
      return std::acos((d * d + c * c - (b + s * a) * (b + s * a)) / (2 * d * c));
    };
    return (limit(1) - limit(-1)) * 180 / kPi;
  };
  const auto derivative = [](auto f) { return (8 * (f(1e-3) - f(-1e-3)) - (f(2e-3) - f(-2e-3))) / 12e-3; };
  std::mt19937 random(11);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 12; ++i) {
    const double a = between(12, 22), b = between(62, 75), c = between(52, 60), d = between(75, 82);
    const Model model = model_of(
        kRocker,
        {"bodies.crank.points.A.0=" + std::to_string(a), "bodies.coupler.points.B.0=" + std::to_string(b),
         "bodies.rocker.points.B.0=" + std::to_string(c), "bodies.ground.points.O4.0=" + std::to_string(d),
         "bodies.rocker.pose.x=" + std::to_string(d)});
    const SensitivityReport report = report_of(model, wanted({"rocker.angle:range"}));
    EXPECT_NEAR(report.results[0].value, swing(a, b, c, d), 1e-4);  // the text has six digits
    EXPECT_NEAR(exact(report, 0, "bodies.crank.points.A.0"),
                derivative([&](double h) { return swing(a + h, b, c, d); }), 1e-5);
    EXPECT_NEAR(exact(report, 0, "bodies.coupler.points.B.0"),
                derivative([&](double h) { return swing(a, b + h, c, d); }), 1e-5);
    EXPECT_NEAR(exact(report, 0, "bodies.rocker.points.B.0"),
                derivative([&](double h) { return swing(a, b, c + h, d); }), 1e-5);
    EXPECT_NEAR(exact(report, 0, "bodies.ground.points.O4.0"),
                derivative([&](double h) { return swing(a, b, c, d + h); }), 1e-5);
  }
}

TEST(SensitivityOfResults, OfAMirrorImageAreMirrored) {
  const std::vector<std::string> results = {"slider.x:range", "slider.vx:max", "rod.angle:range"};
  const SensitivityReport one = report_of(model_of(kSlider, {}), wanted(results));
  const SensitivityReport other = report_of(
      model_of(kSlider, {"bodies.ground.points.rail.1=-12", "bodies.slider.pose.y=-12",
                         "bodies.rod.pose.angle=-7", "driver.end=-360", "driver.velocity=-2 rad/s"}),
      wanted(results));
  for (std::size_t m = 0; m < results.size(); ++m) {
    EXPECT_NEAR(one.results[m].value, other.results[m].value, 1e-9);
    for (std::size_t i = 0; i < one.numbers.size(); ++i) {
      const std::string& name = one.numbers[i].name;
      const bool turns = name.ends_with(".1") || name.ends_with(".y") || name.ends_with("angle");
      const double expected = (turns ? -1 : 1) * one.results[m].slopes[i].up;
      EXPECT_NEAR(other.results[m].slopes[i].up, expected, 1e-9) << name << " " << results[m];
    }
  }
}

// y = r + e sin θ, ÿ = -e ω² sin θ.
TEST(SensitivityOfResults, AnEccentricUnderAFlatFaceIsTheClosedForm) {
  const Model model = model_of(kCam, {"driver.velocity=360", "driver.start=0"});
  const double omega = 2 * kPi;
  const SensitivityReport report =
      report_of(model, wanted({"follower.y:max", "follower.y:range", "follower.ay:max", "follower.vy:at=0"},
                              {"bodies.*", "driver.velocity", "driver.start"}));
  const std::string e = "bodies.cam.curves.disc.center.0", r = "bodies.cam.curves.disc.radius";
  EXPECT_NEAR(exact(report, 0, e), 1, 1e-10);
  EXPECT_NEAR(exact(report, 0, r), 1, 1e-10);
  EXPECT_NEAR(exact(report, 1, e), 2, 1e-10);
  EXPECT_EQ(exact(report, 1, r), 0);
  EXPECT_NEAR(exact(report, 2, e), omega * omega, 1e-8);
  EXPECT_NEAR(exact(report, 2, "driver.velocity"), 2 * 10 * omega * kPi / 180, 1e-8);
  EXPECT_NEAR(exact(report, 3, e), omega, 1e-9);
  EXPECT_NEAR(exact(report, 3, "driver.velocity"), 10 * kPi / 180, 1e-9);
  // The row moves with the start; an extreme within the path does not.
  EXPECT_NEAR(exact(report, 3, "driver.start"), 0, 1e-9);
  EXPECT_NEAR(exact(report, 0, "driver.start"), 0, 1e-9);
  EXPECT_EQ(report.results[0].where, 90);
  EXPECT_EQ(report.where_unit, "deg");
}

TEST(SensitivityOfResults, MeansAreThoseOfTheRows) {
  const Model model = model_of(kCam, {});
  const SensitivityReport report =
      report_of(model, wanted({"follower.y:mean", "follower.y:rms", "follower.vy:rms"}, {"bodies.cam.*"}));
  double sum = 0, square = 0, by_e = 0;
  const int rows = 37;
  const Model other = model_of(kCam, {"driver.samples=37"});
  for (int k = 0; k < rows; ++k) {
    const double s = std::sin(k * kPi / 18), y = 30 + 10 * s;
    sum += s;
    square += y * y;
    by_e += y * s;
  }
  const SensitivityReport few =
      report_of(other, wanted({"follower.y:mean", "follower.y:rms"}, {"bodies.cam.*"}));
  const std::string e = "bodies.cam.curves.disc.center.0", r = "bodies.cam.curves.disc.radius";
  EXPECT_NEAR(exact(few, 0, r), 1, 1e-10);
  EXPECT_NEAR(exact(few, 0, e), sum / rows, 1e-10);
  EXPECT_NEAR(exact(few, 1, e), by_e / rows / std::sqrt(square / rows), 1e-9);
  EXPECT_NEAR(exact(report, 2, e), report.results[2].value / 10, 1e-8);
}

// Largest value (sense 1) or smallest (-1) of a column, with a parabola through three rows at an extreme.
double extreme(const ColumnValues& v, double sense) {
  std::size_t best = 0;
  for (std::size_t k = 0; k < v.size(); ++k) best = sense * v[k] > sense * v[best] ? k : best;
  if (best == 0 || best + 1 == v.size()) return v[best];
  const double a = v[best - 1], b = v[best], c = v[best + 1];
  return b + (c - a) * (c - a) / (8 * (2 * b - a - c));
}

double measured(const ColumnValues& v, MeasureKind kind) {
  switch (kind) {
    case MeasureKind::kMax:
      return extreme(v, 1);
    case MeasureKind::kMin:
      return extreme(v, -1);
    case MeasureKind::kMaxAbs:
      return std::max(std::abs(extreme(v, 1)), std::abs(extreme(v, -1)));
    default:
      return extreme(v, 1) - extreme(v, -1);
  }
}

// The results of a run with another number, from many rows; empty if there is no such mechanism.
std::vector<double> dense_results(const Model& model, const SensitivityReport& report,
                                  const SensitivityNumber& number, double step) {
  const auto other = model.with({{number.paths[0], number.value + step}});
  if (!other) return {};
  RunSettings settings;
  settings.samples = 5761;
  for (const auto& result : report.results) settings.columns.push_back(result.measure.column);
  const auto run = other->run(settings);
  std::vector<double> results;
  for (std::size_t m = 0; run && m < report.results.size(); ++m) {
    const Measure& measure = report.results[m].measure;
    results.push_back(measured(run->column(measure.column), measure.of));
  }
  return results;
}

struct Case {
  std::string name;
  std::string profile;
  std::vector<std::string> results;
  std::vector<std::string> overrides = {};
};

const Case kShippedCases[] = {
    Case{"RoundCam",
         "eccentric_disc_oscillating_roller",
         {"follower.angle:range", "follower.alpha:maxabs", "touch.pressure:max", "touch.sliding:max"}},
    Case{"EllipseCam", "ellipse_cam_roller", {"follower.angle:max", "follower.alpha:min"}},
    Case{"SlenderEllipseCam",
         "ellipse_cam_roller",
         {"follower.alpha:max", "touch.rho1:min"},
         {"bodies.cam.curves.oval.semi_axes.1=17", "bodies.cam.curves.oval.rotation=40"}},
    Case{"HyperbolaCam", "hyperbola_cam", {"follower.angle:min", "follower.omega:range"}},
    Case{"SixBar", "watt_sixbar", {"link6.angle:range", "link6.alpha:max"}},
    Case{"ScotchYoke", "scotch_yoke", {"yoke.ax:max"}},
    Case{"FlankOfALaw", "law_cam_roller", {"touch.pressure:max", "touch.rho1:max"}},
    Case{"Spline", "spline_cam", {"follower.alpha:max", "touch.pressure:max"}},
    Case{"SliderCrank", "slider_crank", {"piston.x:max", "slide.acceleration:maxabs"}},
    Case{"FourBar", "four_bar", {"coupler.E.y:max", "rocker.alpha:max"}},
    Case{"Gears", "geared_five_bar", {"left_link.T.y:max", "left_link.T.y:range", "T.velocity:max"}}};

TEST(SensitivityOfShipped, IsTheDifferenceBetweenRunsWithOtherNumbers) {
  for (const Case& shipped : kShippedCases) {
    SCOPED_TRACE(shipped.name);
    const Model model = shipped_model(shipped.profile, shipped.overrides);
    const SensitivityReport report = report_of(model, wanted(shipped.results, {"bodies.*"}));
    int compared = 0;
    for (std::size_t i = 0; i < report.numbers.size(); ++i) {
      const SensitivityNumber& number = report.numbers[i];
      const double h = 1e-4 * number.scale;
      std::vector<std::vector<double>> at;
      for (const double steps : {-2, -1, 1, 2}) at.push_back(dense_results(model, report, number, steps * h));
      if (std::ranges::any_of(at, [](const auto& results) { return results.empty(); })) continue;
      for (std::size_t m = 0; m < report.results.size(); ++m) {
        const Slope& ours = report.results[m].slopes[i];
        const double one = (at[2][m] - at[1][m]) / (2 * h), two = (at[3][m] - at[0][m]) / (4 * h);
        ++compared;
        const double scale = std::abs(report.results[m].value) / number.scale;
        EXPECT_NEAR(ours.up, (4 * one - two) / 3, 1e-5 * (scale + std::abs(two)) + 2 * std::abs(one - two))
            << number.name << " " << report.results[m].name << " " << ours.remark;
      }
    }
    EXPECT_GT(compared, 4);
  }
}

TEST(SensitivityOfResults, WhereTwoExtremesAreEqualTheResultHasAKink) {
  const SensitivityReport report = report_of(model_of(kCam, {}), wanted({"follower.vy:maxabs"}));
  // Upward and downward speeds are equal and remain equal: no kink.
  EXPECT_NEAR(exact(report, 0, "bodies.cam.curves.disc.center.0"), 1, 1e-9);
  const SensitivityReport yoke =
      report_of(model_of(kSlider, {"bodies.ground.points.rail.1=0", "bodies.slider.pose.y=0"}),
                wanted({"rod.angle:maxabs"}));
  // asin(r/l) at 90 and 270 degrees; an offset makes one of the two larger.
  const double s = 0.3, by_angle = 180 / kPi / std::sqrt(1 - s * s) / 100;
  const Slope& kink = slope(yoke, 0, "bodies.ground.points.rail.1");
  EXPECT_EQ(kink.kind, SlopeKind::kKink);
  EXPECT_NEAR(kink.up, by_angle, 1e-8);
  EXPECT_NEAR(kink.down, -by_angle, 1e-8);
  EXPECT_NEAR(std::abs(kink.steepest()), by_angle, 1e-8);
  EXPECT_NEAR(exact(yoke, 0, "bodies.crank.points.A.0"), by_angle, 1e-8);
  // Nearly equal: the other extreme is reported as a rival.
  const SensitivityReport off =
      report_of(model_of(kSlider, {"bodies.ground.points.rail.1=0.1", "bodies.slider.pose.y=0"}),
                wanted({"rod.angle:maxabs"}));
  ASSERT_TRUE(off.results[0].rival);
  EXPECT_NEAR(off.results[0].value - *off.results[0].rival, 0.2 * by_angle, 1e-4);
  EXPECT_EQ(slope(off, 0, "bodies.ground.points.rail.1").kind, SlopeKind::kExact);
}

// An arm of two equal links that folds up within many turns: x = l cos θ + l cos(θ + 180° θ/E), the largest
// at the start. The next one lies halfway between two of the places looked at first, the one after it on one
// of them.
TEST(SensitivityOfResults, TheRivalOfManyMaximaIsTheNextLargest) {
  const double l = 50, end = 10939.79 * kPi / 180;
  const Model arm = model_of(R"([bodies.ground]
points.O = [0, 0]
[bodies.upper]
points = { O = [0, 0], A = [50, 0] }
[bodies.lower]
pose = { x = 50 }
points = { A = [0, 0], T = [50, 0] }
[joints]
shoulder = { type = "revolute", between = ["ground.O", "upper.O"] }
elbow = { type = "revolute", between = ["upper.A", "lower.A"] }
[drivers.shoulder]
joint = "shoulder"
start = 0
end = 10939.79
samples = 3001
[drivers.elbow]
joint = "elbow"
start = 0
end = 180
samples = 3001
)");
  const auto x = [&](double theta) { return l * std::cos(theta) + l * std::cos(theta * (1 + kPi / end)); };
  double low = 1.9 * kPi, high = 2 * kPi;  // around the second largest maximum
  for (int i = 0; i < 100; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (x(a) < x(b) ? low : high) = x(a) < x(b) ? a : b;
  }
  const SensitivityReport report = report_of(arm, wanted({"lower.T.x:max"}));
  EXPECT_NEAR(report.results[0].value, 2 * l, 1e-9);
  ASSERT_TRUE(report.results[0].rival);
  EXPECT_NEAR(*report.results[0].rival, x(low), 1e-8);
}

TEST(SensitivityOfResults, DoNotDependOnTheUnitsOfTheFile) {
  const std::vector<std::string> results = {"slider.x:range", "slider.ax:max", "rod.omega:max"};
  const SensitivityReport mm = report_of(model_of(kSlider, {}), wanted(results));
  const SensitivityReport km = report_of(model_of(kSlider, {"units.length=km"}), wanted(results));
  const SensitivityReport um = report_of(model_of(kSlider, {"units.length=um"}), wanted(results));
  for (std::size_t m = 0; m < results.size(); ++m) {
    for (std::size_t i = 0; i < mm.numbers.size(); ++i) {
      const double one = mm.results[m].slopes[i].up;
      EXPECT_NEAR(km.results[m].slopes[i].up, one, 1e-9 * (1 + std::abs(one))) << mm.numbers[i].name;
      EXPECT_NEAR(um.results[m].slopes[i].up, one, 1e-9 * (1 + std::abs(one))) << mm.numbers[i].name;
    }
  }
}

// A disc of radius R = 50 as a conic, with its centre 10 from the pivot; the roller of the follower has r
// = 3. The term C x y moves its outline out by -C R³ sin(2φ)/4 at the normal's angle φ, and so the follower
// by that over the cosine of the pressure angle. Whatever the factor of the equation: C is 0, and takes its
// scale from the other terms.
constexpr const char* kConicDisc = R"(
[bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [10, 0]
curves.disc = { type = "conic", coefficients = [0.0004, 0.0004, 0, 0, 0, -1] }
[bodies.f]
pose = { y = 60 }
points.S = [0, 0]
curves.r = { type = "circle", center = [0, 0], radius = 3 }
[joints]
main = { type = "revolute", between = ["ground.O", "cam.O"] }
g = { type = "prismatic", between = ["ground.O", "f.S"], direction = [0, 1] }
[contacts.k]
between = ["cam.disc", "f.r"]
[driver]
joint = "main"
positions = [30]
)";

TEST(SensitivityOfResults, OfACoefficientThatIsZeroAreTheClosedForm) {
  const double turn = kPi / 6;
  const double pressure = std::asin(10 * std::cos(turn) / 53);
  const double phi = kPi / 2 - pressure - turn;
  const double slope_of_one = -std::pow(50, 3) * std::sin(2 * phi) / 4 / std::cos(pressure);
  for (const double factor : {1.0, 100.0, 0.01, 1e-6, -1e6}) {
    const std::string list =
        fmt::format("bodies.cam.curves.disc.coefficients=[{0}, {0}, 0, 0, 0, {1}]", 0.0004 * factor, -factor);
    const SensitivityReport report = report_of(
        model_of(kConicDisc, {list}), wanted({"f.y:last"}, {"bodies.cam.curves.disc.coefficients.2"}));
    const Slope& found = slope(report, 0, "bodies.cam.curves.disc.coefficients.2");
    EXPECT_EQ(found.kind, SlopeKind::kDifferences) << found.remark;
    EXPECT_NEAR(found.up * factor, slope_of_one, 1e-7 * std::abs(slope_of_one)) << factor;
  }
}

// The same disc, small beside its mechanism. Its radius is √(-F/A), and the normal's angle on it is π/2 less
// the pressure angle and the driver's: the contact moves along the disc by the radius times the change of
// that.
TEST(SensitivityOfResults, ByACoefficientOfASmallConicAreTheClosedForm) {
  const auto pressure = [](double turn) { return std::asin(10 * std::cos(turn) / 53); };
  const auto pressure_by_radius = [&](double turn) {
    return -10 * std::cos(turn) / (53 * 53 * std::cos(pressure(turn)));
  };
  const double turned = pressure(kPi / 6) + kPi / 6 - pressure(0);
  const double by_radius = turned + 50 * (pressure_by_radius(kPi / 6) - pressure_by_radius(0));
  for (const double far : {100.0, 1e4, 1e6}) {
    const std::vector<std::string> overrides = {"driver.positions=[0, 30]",
                                                fmt::format("bodies.ground.points.S=[0, {}]", -far),
                                                R"(joints.g.between=["ground.S", "f.S"])"};
    const SensitivityReport report = report_of(
        model_of(kConicDisc, overrides), wanted({"k.arc1:last"}, {"bodies.cam.curves.disc.coefficients.5"}));
    const Slope& found = slope(report, 0, "bodies.cam.curves.disc.coefficients.5");
    EXPECT_EQ(found.kind, SlopeKind::kDifferences) << found.remark;
    EXPECT_NEAR(std::abs(found.up), 25 * by_radius, 1e-6 * 25 * by_radius) << far;
    EXPECT_EQ(report.numbers.front().scale, 1) << far;
  }
}

// Its velocity is 0, so that the scale is the root of the acceleration, in any unit of time.
TEST(SensitivityOfResults, ADriverThatStartsFromRestHasTheScaleOfItsAcceleration) {
  for (const auto& [unit, seconds] : {std::pair("s", 1.0), {"ms", 1e-3}, {"min", 60.0}}) {
    const Model model =
        shipped_model("eccentric_disc_oscillating_roller",
                      {std::string("units.time=") + unit, "driver.velocity=0",
                       "driver.acceleration=4 rad/s^2", "driver.duration=0.2 s", "driver.samples=11"});
    SensitivitySettings settings = wanted({"follower.omega:last"}, {"driver.velocity"});
    settings.in_time = true;
    const SensitivityReport report = report_of(model, settings);
    ASSERT_EQ(report.numbers.size(), 1U);
    EXPECT_NEAR(report.numbers[0].scale / seconds, 2 * 180 / kPi, 1e-9) << unit;
  }
}

// The acceleration of a driver is 0, and arcs are differentiated by differences.
TEST(SensitivityOfResults, OfAnAccelerationThatIsZeroDoNotDependOnTheUnitOfTime) {
  std::vector<double> slopes;
  for (const char* unit : {"s", "ms", "min"}) {
    const Model model =
        shipped_model("eccentric_disc_oscillating_roller",
                      {std::string("units.time=") + unit, "driver.velocity=60 rpm", "driver.acceleration=0",
                       "driver.duration=0.2 s", "driver.samples=11"});
    SensitivitySettings settings = wanted({"touch.arc1:last"}, {"driver.acceleration"});
    settings.in_time = true;
    const Slope found = slope(report_of(model, settings), 0, "driver.acceleration");
    EXPECT_EQ(found.kind, SlopeKind::kDifferences) << unit << ": " << found.remark;
    const double seconds = std::string(unit) == "ms" ? 1e-3 : std::string(unit) == "min" ? 60 : 1;
    slopes.push_back(found.up * seconds * seconds);
  }
  EXPECT_NEAR(slopes[1], slopes[0], 1e-8 * std::abs(slopes[0]));
  EXPECT_NEAR(slopes[2], slopes[0], 1e-8 * std::abs(slopes[0]));
  EXPECT_NE(slopes[0], 0);
}

// At the vertex of an ellipse the curvature has an extreme, and its rate is 0 but for other dimensions: as
// part of a body's outline it changes as the ellipse itself does.
TEST(SensitivityOfResults, OfAJerkAtAVertexIsThatOfTheEllipse) {
  const std::string ellipse = profile_of(
      {"curves.oval = { type = \"ellipse\", center = [3, 0], semi_axes = [30, 20] }\n"
       "curves.hub = { type = \"circle\", center = [3, 0], radius = 5 }",
       "pose = { x = 45, y = 0 }\ncurves.roller = { type = \"circle\", center = [0, 0], radius = 12 }",
       "direction = [1, 0]", "between = [\"cam.oval\", \"follower.roller\"]",
       "start = 0\nend = 360\nvelocity = 100\nsamples = 5"});
  const std::vector<std::string> jerk = {"follower.jx:at=0"};
  const SensitivityReport alone = report_of(model_of(ellipse), wanted(jerk));
  const SensitivityReport part = report_of(
      model_of(replaced(ellipse, R"("cam.oval", "follower.roller")", R"("cam", "follower")")), wanted(jerk));
  const double by_center = exact(alone, 0, "bodies.cam.curves.oval.center.1");
  EXPECT_GT(by_center, 10);
  EXPECT_NEAR(exact(part, 0, "bodies.cam.curves.oval.center.1"), by_center, 1e-8 * by_center);
}

// The flank of a law's cam produces the law's lift whatever the cam's size. The path of the roller's centre
// does not depend on the roller: the flank's radius of curvature decreases by as much as the roller's
// increases.
TEST(SensitivityOfResults, OfAFlankThatALawHasShapedAreTheClosedForm) {
  const Model model = shipped_model("law_cam_roller", {"driver.samples=37"});
  const std::string r = "bodies.follower.curves.roller.radius", y = "bodies.follower.pose.y";
  const SensitivityReport report =
      report_of(model, wanted({"touch.rho1:max", "touch.rho1:min", "touch.rho2:max", "slide.position:range",
                               "slide.acceleration:max", "touch.pressure:max"},
                              {r, y}));
  EXPECT_NEAR(exact(report, 0, r), -1, 1e-10);
  EXPECT_NEAR(exact(report, 1, r), -1, 1e-10);
  EXPECT_NEAR(slope(report, 2, r).up, 1, 1e-11);
  EXPECT_EQ(exact(report, 3, r), 0);
  EXPECT_EQ(exact(report, 3, y), 0);
  EXPECT_EQ(exact(report, 4, y), 0);
  EXPECT_EQ(exact(report, 5, r), 0);
  // tan of the pressure angle is (s' - e)/(r0 + s): a larger base circle makes it smaller.
  EXPECT_LT(exact(report, 5, y), -0.1);
}

// A face square to its stroke has the pressure angle 0; tilted by ε to either side, that of atan ε.
TEST(SensitivityOfResults, OfASizeThatIsZeroHaveAKink) {
  const Model model = model_of(kCam, {"driver.velocity=360"});
  const std::string tilt = "bodies.follower.curves.face.normal.0";
  const SensitivityReport report =
      report_of(model, wanted({"touch.pressure:max", "touch.pressure:mean", "touch.pressure:rms",
                               "touch.pressure:at=30", "touch.pressure:range"},
                              {tilt}));
  for (std::size_t m = 0; m < 4; ++m) {
    EXPECT_NEAR(report.results[m].value, 0, 1e-12);
    const Slope& kink = slope(report, m, tilt);
    EXPECT_EQ(kink.kind, SlopeKind::kKink) << report.results[m].name;
    EXPECT_NEAR(kink.down, -180 / kPi, 1e-8) << report.results[m].name;
    EXPECT_NEAR(kink.up, 180 / kPi, 1e-8) << report.results[m].name;
  }
  EXPECT_NEAR(slope(report, 4, tilt).up, 0, 1e-8);  // it is the same everywhere, whatever the tilt
}

TEST(SensitivityOfRows, HaveNoDerivativeAtAKink) {
  int rows = 0;
  const auto table = sensitivity_rows(
      model_of(kCam, {"driver.samples=5"}), {"touch.pressure", "follower.y"},
      wanted({}, {"bodies.follower.curves.face.normal.0"}), [](const SlopeTable&) {},
      [&](const RowSlopes& row) {
        for (std::size_t c = 0; c < row.slopes.size(); ++c) {
          EXPECT_EQ(std::isnan(row.slopes[c]), c == row.slopes.size() - 1) << c;
        }
        ++rows;
        return true;
      });
  ASSERT_TRUE(table);
  EXPECT_EQ(rows, 5);
}

// The arm from the cam's pivot to the centre of the arc that is concentric with it.
TEST(SensitivityOfResults, OfALengthThatIsZeroInADwellAreThoseOfRunsToEitherSide) {
  struct Arm {
    const char* profile;
    const char* result;
    const char* number;
  };
  for (const Arm& arm : {Arm{"four_arc_cam", "touch.r2:range", "bodies.cam.points.O.0"},
                         Arm{"tangent_cam", "touch.r2:min", "bodies.cam.points.O.1"}}) {
    const Model model = shipped_model(arm.profile, {});
    const SensitivityReport report = report_of(model, wanted({arm.result}, {arm.number}));
    const Slope& kink = slope(report, 0, arm.number);
    const double h = 1e-5;
    const auto at = [&](double step) {
      const std::vector<double> results = dense_results(model, report, report.numbers[0], step);
      return results.empty() ? std::nan("") : results[0];
    };
    EXPECT_EQ(kink.kind, SlopeKind::kKink) << arm.result;
    EXPECT_NEAR(kink.up, (at(h) - at(0)) / h, 1e-4) << arm.result;
    EXPECT_NEAR(kink.down, (at(0) - at(-h)) / h, 1e-4) << arm.result;
  }
}

// In a parallelogram with cranks r and r + d the coupler turns by d/(l sin θ), to first order.
TEST(SensitivityOfResults, OfAColumnThatIsConstantAreThoseOfThePlaceThatChangesMost) {
  const std::string r = "bodies.right.points.B.0";
  const Model model = shipped_model("parallelogram", {"driver.start=20", "driver.end=163.7"});
  const SensitivityReport report = report_of(
      model,
      wanted({"coupler.angle:max", "coupler.angle:min", "coupler.angle:maxabs", "coupler.angle:range"}, {r}));
  const auto turn = [](double theta) { return 180 / kPi / 100 / std::sin(theta * kPi / 180); };
  const double most = turn(163.7), least = turn(90);
  const auto expect = [&](std::size_t m, double down, double up) {
    EXPECT_EQ(slope(report, m, r).kind, SlopeKind::kKink);
    EXPECT_NEAR(slope(report, m, r).down, down, 1e-9) << report.results[m].name;
    EXPECT_NEAR(slope(report, m, r).up, up, 1e-9) << report.results[m].name;
  };
  expect(0, least, most);
  expect(1, most, least);
  expect(2, -most, most);
  expect(3, least - most, most - least);
}

// Nothing moves a dwell, and rounding does not count as a derivative.
TEST(SensitivityOfResults, OfAColumnThatIsTheSameEverywhereAreZero) {
  const SensitivityReport report =
      report_of(shipped_model("involute_pair", {}),
                wanted({"wheel_pivot.acceleration:maxabs"}, {"bodies.ground.points.O2.0"}));
  EXPECT_EQ(exact(report, 0, "bodies.ground.points.O2.0"), 0);
}

// The other arcs stay in place; the gap that results does not matter at the top of the nose.
TEST(SensitivityOfResults, OfOneArcOfAChainAreThoseOfThatArc) {
  const std::string radius = "bodies.cam.curves.outline.spans.0.radius";
  const SensitivityReport report =
      report_of(shipped_model("four_arc_cam", {"driver.samples=37"}), wanted({"follower.y:range"}, {radius}));
  EXPECT_NEAR(exact(report, 0, radius), 1, 1e-9);
}

TEST(SensitivityOfResults, ANumberThatChangesTheRowsHasNoSlopes) {
  const Model model = model_of(kCam, {"driver.duration=1", "driver.time_step=0.01"});
  SensitivitySettings settings = wanted({"follower.y:last"}, {"driver.duration", "driver.time_step"});
  settings.in_time = true;
  const SensitivityReport report = report_of(model, settings);
  EXPECT_EQ(slope(report, 0, "driver.time_step").kind, SlopeKind::kNone);
  EXPECT_TRUE(contains(slope(report, 0, "driver.time_step").remark, "other rows"));
  EXPECT_EQ(report.where_unit, "s");
}

// The torque goes to -∞ at the limit position; its largest sample by size is at the start, and positive.
TEST(SensitivityOfResults, ThatGrowWithTheOtherSignHaveNoSlopes) {
  const SensitivityReport report =
      report_of(shipped_model("lock_up", {"driver.start=0", "driver.end=80", "driver.samples=9",
                                          "loads.push={ body = \"follower\", torque = 100 }",
                                          "loads.hold={ body = \"cam\", torque = -500 }"}),
                wanted({"driver.effort:maxabs"}, {"loads.push.torque"}));
  EXPECT_NEAR(report.results[0].value, 500 + 500 / 3.0, 1e-9);
  EXPECT_TRUE(contains(report.results[0].remark, "with the other sign it still grows"));
  EXPECT_TRUE(contains(slope(report, 0, "loads.push.torque").remark, "without bounds"));
}

// The largest sample is the first one, beside another limit position than that towards which it is unbounded.
TEST(SensitivityOfResults, ThatGrowElsewhereHaveNoSlopes) {
  const SensitivityReport report =
      report_of(shipped_model("lock_up", {"driver.start=294.168", "driver.end=430"}),
                wanted({"follower_pivot.acceleration:max"}, {"bodies.cam.curves.disc.radius"}));
  EXPECT_TRUE(contains(report.results[0].remark, "it still grows at 425."));
  EXPECT_EQ(slope(report, 0, "bodies.cam.curves.disc.radius").kind, SlopeKind::kNone);
  EXPECT_TRUE(contains(slope(report, 0, "bodies.cam.curves.disc.radius").remark, "without bounds"));
}

// What touches a body at rest moves along it: 90 degrees with any numbers. The derivatives are rounding at
// every place of the path, and the largest one to each side would count.
TEST(SensitivityOfResults, OfAColumnThatIsConstantButForRoundingAreZero) {
  const Model model = model_of(R"(
units.length = "m"
bodies.ground.points.O = [-0.3036126579185672, 0.24691751118265248]
bodies.ground.curves.round = { type = "circle", center = [1.1246795890274268, 0.4830555509962816], radius = 0.7294928466672169 }
bodies.anvil.points.O = [-0.3036126579185672, 0.24691751118265248]
bodies.anvil.curves.oval = { type = "ellipse", center = [-0.8680933838659026, 0.36452732909840885], semi_axes = [0.4354686878382511, 0.12857457257073193], rotation = 18.734226877548694 }
bodies.cam.points.O = [-0.3036126579185672, 0.24691751118265248]
bodies.cam.curves.edge = { type = "ellipse", center = [-0.139154540449317, -0.7449574934580531], semi_axes = [0.07333130903879553, 0.2508616364569471], rotation = 278.84963024481374 }
bodies.rider.curves.left = { type = "circle", center = [0.3837379348491962, -1.2152232398586769], radius = 1.1233820509888963 }
bodies.rider.curves.right = { type = "circle", center = [0.4356626386203546, 0.7267935615627925], radius = 1.0 }
bodies.rider.curves.roller = { type = "circle", center = [0.1435433003467232, -0.9337970005957518], radius = 0.19190958500598188 }
joints.o = { type = "revolute", between = ["cam.O", "ground.O"] }
joints.rest = { type = "revolute", between = ["ground.O", "anvil.O"] }
contacts.round = { between = ["rider.left", "ground.round"] }
contacts.oval = { between = ["anvil.oval", "rider.right"] }
contacts.ride = { between = ["rider.roller", "cam.edge"] }
drivers.o = { joint = "o", start = 0, end = 40, samples = 5 }
drivers.rest = { joint = "rest", start = 0, end = 0, samples = 5, velocity = 0 }
)");
  const SensitivityReport report = report_of(model, wanted({"oval.pressure:max"}));
  EXPECT_NEAR(report.results[0].value, 90, 1e-9);
  for (const Slope& one : report.results[0].slopes) {
    EXPECT_EQ(one.kind, SlopeKind::kExact);
    EXPECT_EQ(std::max(std::abs(one.down), std::abs(one.up)), 0);
  }
}

TEST(SensitivityOfResults, DefaultsAreWhatAMechanismIsFor) {
  std::vector<std::string> names;
  for (const NamedMeasure& result : default_results(shipped_model("eccentric_disc_oscillating_roller", {}))) {
    names.push_back(result.name);
  }
  EXPECT_TRUE(lines_are(
      names, {"follower_pivot.position:range", "follower_pivot.acceleration:maxabs", "touch.pressure:max"}));
}

TEST(SensitivityOfResults, AreTheSameOnAnyNumberOfThreads) {
  const Model model = shipped_model("watt_sixbar", {});
  SensitivitySettings settings;
  settings.threads = 1;
  const SensitivityReport one = report_of(model, settings);
  settings.threads = 3;
  const SensitivityReport three = report_of(model, settings);
  for (std::size_t m = 0; m < one.results.size(); ++m) {
    for (std::size_t i = 0; i < one.numbers.size(); ++i) {
      const double a = one.results[m].slopes[i].up, b = three.results[m].slopes[i].up;
      EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b)));
    }
  }
}

TEST(SensitivityOfResults, StopWhenTold) {
  const std::atomic<bool> stop = true;
  SensitivitySettings settings;
  settings.stop = &stop;
  const auto report = sensitivity(model_of(kCam, {}), settings);
  EXPECT_TRUE(!report || report->stopped);
}

TEST(SensitivityOfResults, SayWhatIsWrong) {
  const Model model = model_of(kCam, {});
  EXPECT_TRUE(contains(refusal(model, wanted({"folower.y:max"})), "did you mean `follower.y`"));
  EXPECT_TRUE(contains_all(refusal(model, wanted({}, {"bodies.cam.curves.disc.radus"})),
                           {"setting by bodies.cam.curves.disc.radus: no number of the profile",
                            "did you mean `bodies.cam.curves.disc.radius`"}));
  EXPECT_TRUE(contains(refusal(model, wanted({"follower.y:at=1.5"})), "no row is at 1.5"));
  EXPECT_TRUE(contains(refusal(model_of(kSlider, {"bodies.rod.points.B.0=3"})), "cannot"));
  Mechanism built = model.mechanism();
  EXPECT_TRUE(contains(refusal(Model::from(built).value()), "was built"));
  const auto wrong = [&](const std::string& text) { return to_string(measure_from(model, text).error()); };
  EXPECT_TRUE(contains(wrong("follower.y"), "expected COLUMN:OF"));
  EXPECT_TRUE(contains(wrong("follower.y:mx"), "did you mean `max`"));
  EXPECT_TRUE(contains(wrong("follower.y:at"), "expected COLUMN:at=X"));
  EXPECT_TRUE(contains(wrong("follower.y:at=x"), "expected COLUMN:at=X"));
  EXPECT_TRUE(
      contains(wrong("follower.y:at=3 mm"), "`3 mm`: mm is a length, expected an angle, such as deg"));
  EXPECT_TRUE(contains(wrong("follower.y:max=3"), "only `at` has a place"));
}

TEST(SensitivityOfResults, AreTakenAtAPlaceInAnyUnit) {
  const Model model = model_of(kCam, {});
  SensitivitySettings settings;
  const auto at = [&](const std::string& place) {
    return measure_from(model, "follower.y:at=" + place, settings).value().measure.at;
  };
  EXPECT_EQ(at("30"), 30);
  EXPECT_EQ(at("0.5 rev"), 180);
  EXPECT_NEAR(at("0.5 rad"), 90 / kPi, 1e-13);
  settings.in_time = true;
  EXPECT_EQ(at("500 ms"), 0.5);
  EXPECT_EQ(at("3"), 3);
}

// As check() does.
TEST(SensitivityOfResults, OfThousandsOfTurnsLeaveOpenWhatIsNotExamined) {
  const Model model = Model::open(HIGHERPAIR_SOURCE_DIR "/profiles/four_bar.toml",
                                  std::vector<std::string>{"driver.end=1e6", "driver.samples=3"})
                          .value();
  const SensitivityReport report =
      report_of(model, wanted({"rocker.angle:max", "rocker.angle:mean"}, {"bodies.crank.points.A.0"}));
  EXPECT_FALSE(report.good);
  ASSERT_FALSE(report.events.empty());
  const Event& end = report.events.back();
  EXPECT_EQ(end.type, EventType::kEnd);
  EXPECT_NEAR(end.driver, 500'000, 1);
  EXPECT_TRUE(contains(end.cause, "the path is too long to look for extremes beyond"));
  EXPECT_EQ(report.results[0].where, end.driver);  // the rocker turns fully
  EXPECT_EQ(report.results[0].remark, "not examined beyond 500000 deg");
  EXPECT_EQ(report.results[1].remark, "");
}

// A parallelogram turns fully through its change points; with another length it does not.
TEST(SensitivityOfResults, NextToAChangePointGrowWithoutBoundsByWhatDoesAwayWithIt) {
  const Model model = model_of(
      kRocker, {"bodies.coupler.points.B.0=80", "bodies.rocker.points.B.0=20", "bodies.coupler.pose.angle=0",
                "bodies.rocker.pose.angle=30", "driver.start=30", "driver.end=179.99", "driver.samples=3"});
  const std::string length = "bodies.rocker.points.B.0", pose = "bodies.rocker.pose.angle";
  for (const char* result : {"rocker.angle:last", "rocker.alpha:mean", "rocker.omega:max"}) {
    const SensitivityReport report = report_of(model, wanted({result}, {length, pose}));
    const Slope& of = slope(report, 0, length);
    EXPECT_EQ(of.kind, SlopeKind::kNone) << result << of.up;
    EXPECT_TRUE(contains(of.remark, "change point")) << result;
    EXPECT_EQ(slope(report, 0, pose).up, 0) << result;
  }
  std::vector<bool> has_slope;
  const auto table = sensitivity_rows(
      model, {"rocker.angle"}, wanted({}, {length}), [](const SlopeTable&) {},
      [&](const RowSlopes& row) {
        has_slope.push_back(std::isfinite(row.slopes.back()));
        return true;
      });
  ASSERT_TRUE(table) << to_string(table.error());
  EXPECT_EQ(has_slope, (std::vector{true, true, false}));
}

// The centre of a disc is 1.4 um from its pivot, at the end of a vector of equal components.
TEST(SensitivityOfRows, OfADistanceThatIsShortBesideTheMechanismAreTheClosedForm) {
  const Model model = shipped_model("eccentric_disc_oscillating_roller",
                                    {"driver.samples=3", "bodies.cam.curves.disc.center=[0.001, 0.001]"});
  SensitivitySettings settings;
  settings.by = {"bodies.cam.curves.disc.center.*"};
  int rows = 0;
  const auto table = sensitivity_rows(
      model, {"touch.r2"}, settings, [](const SlopeTable&) {},
      [&](const RowSlopes& row) {
        ++rows;
        EXPECT_EQ(row.slopes.size(), 4U);  // of the driver and the distance, by both numbers
        EXPECT_NEAR(row.slopes[1], std::sqrt(0.5), 1e-7);
        EXPECT_NEAR(row.slopes[3], std::sqrt(0.5), 1e-7);
        return true;
      });
  ASSERT_TRUE(table) << to_string(table.error());
  EXPECT_EQ(rows, 3);
}

// A pin that is moved by y along its circle of radius r is where the crank is y/r further. At 135 and 225
// degrees it enters and leaves a slot: there the wheel's velocity has a kink, its acceleration jumps.
TEST(SensitivityOfRows, ByDifferencesHaveNoneAtAKinkOrJump) {
  const Model model =
      shipped_model("geneva_four_slots", {"driver.start=120", "driver.end=240", "driver.samples=9"});
  const auto table = sensitivity_rows(
      model, {"wheel.omega", "wheel.angle", "wheel.alpha"}, wanted({}, {"bodies.crank.curves.pin.at.1"}),
      [](const SlopeTable&) {},
      [&](const RowSlopes& row) {
        const double r = 56.568542494923804;
        const double omega = row.values[2], alpha = row.values[3];
        const bool changes = row.row == 1 || row.row == 7;
        EXPECT_EQ(std::isnan(row.slopes[2]), changes) << row.row;
        EXPECT_EQ(std::isnan(row.slopes[3]), changes) << row.row;
        if (!changes) {
          EXPECT_NEAR(row.slopes[1], omega / r, 1e-9) << row.row;
          EXPECT_NEAR(row.slopes[2], alpha / r, 1e-9) << row.row;
        }
        return true;
      });
  ASSERT_TRUE(table) << to_string(table.error());
}

// Rows compared with runs with other numbers at the same positions.
TEST(SensitivityOfRows, AreTheDifferencesBetweenRowsWithOtherNumbers) {
  struct Compared {
    const char* profile;
    const char* number;
    std::vector<std::string> columns;
  };
  const std::vector<std::string> motion = {"follower.angle", "follower.alpha", "touch.arc1"};
  const std::vector<std::string> efforts = {"driver.effort", "driver.effort_check"};
  for (const auto& [name, number, columns] :
       {Compared{"eccentric_disc_oscillating_roller", "bodies.follower.curves.roller.radius", motion},
        Compared{"law_cam_roller", "bodies.follower.curves.roller.radius", motion},
        Compared{"watt_sixbar_forces", "bodies.triangle.points.H.0", efforts},
        Compared{"valve_train", "bodies.ground.points.camshaft.0", efforts}}) {
    const Model model = shipped_model(name, {"driver.samples=9"});
    SensitivitySettings settings;
    settings.by = {number};
    SlopeTable head;
    std::vector<std::vector<double>> slopes;
    const auto table = sensitivity_rows(
        model, columns, settings, [&](const SlopeTable& made) { head = made; },
        [&](const RowSlopes& row) {
          slopes.emplace_back(row.slopes.begin(), row.slopes.end());
          return true;
        });
    ASSERT_TRUE(table) << to_string(table.error());
    ASSERT_EQ(slopes.size(), 9U);
    ASSERT_EQ(head.numbers.size(), 1U);
    const auto at = [&](double h) {
      RunSettings run;
      run.forces = true;
      return model.with({{head.numbers[0].paths[0], head.numbers[0].value + h}}).value().run(run).value();
    };
    const double h = 1e-3;
    const Motion more = at(h), less = at(-h);
    std::size_t compared = 0;
    for (std::size_t c = 1; c < head.columns.size(); ++c) {
      for (std::size_t k = 0; k < slopes.size(); ++k) {
        const double difference =
            (more.column(head.columns[c].name)[k] - less.column(head.columns[c].name)[k]) / (2 * h);
        if (std::isnan(difference)) continue;
        ++compared;
        EXPECT_NEAR(slopes[k][c], difference, 1e-5 * (1 + std::abs(difference)))
            << name << " " << head.columns[c].name << " row " << k;
      }
    }
    EXPECT_GT(compared, slopes.size()) << name;
  }
}

TEST(SensitivityOfRows, AreRefusedForColumnsThatHaveNone) {
  const Model model = model_of(kCam);
  SensitivitySettings settings;
  settings.by = {"bodies.cam.curves.disc.radius"};
  const auto refused = [&](const std::vector<std::string>& columns) {
    const auto table = sensitivity_rows(
        model, columns, settings, [](const SlopeTable&) {}, [](const RowSlopes&) { return true; });
    return table ? "" : to_string(table.error());
  };
  for (const char* name : {"status", "stat*", "residual"}) {
    EXPECT_EQ(refused({"follower.y", name}),
              "setting columns " + std::string(name) +
                  ": has no derivatives: columns of words have none, and the residual is rounding");
  }
  EXPECT_EQ(refused({"follower.y", "*"}), "");
}

}  // namespace
}  // namespace higherpair

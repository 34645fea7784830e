// Settings, tasks and tables that a program fills in: what is beyond its range is refused by name, as an
// error that is a value.
#include "front/cam_profile.hpp"
#include "higherpair/higherpair.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::kCam;
using testing::model_of;
using testing::shipped_model;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <class T>
std::string refusal(const Result<T>& result) {
  return result ? "" : to_string(result.error());
}

TEST(Settings, OfAMapNeedTwoRowsAndATolerance) {
  const Model model = shipped_model("ellipse_cam_roller");
  for (const std::int64_t samples : {std::int64_t{1}, std::int64_t{0}, std::int64_t{-7}, kMostMapRows + 1}) {
    MapSettings settings;
    settings.samples = samples;
    EXPECT_TRUE(contains(refusal(map_of(model, settings)),
                         "setting samples " + std::to_string(samples) + ": must be from 2 to 10000000"));
  }
  MapSettings settings;
  settings.samples = 2;
  EXPECT_EQ(refusal(map_of(model, settings)), "");
  settings.tolerance = kNan;
  EXPECT_TRUE(contains(refusal(map_of(model, settings)), "setting tolerance nan: must be > 0"));
}

TEST(Settings, OfMobilityNeedATolerance) {
  EXPECT_TRUE(contains(refusal(mobility_of(model_of(kCam), kNan)), "tolerance = nan: must be > 0"));
}

TEST(Settings, OfAnExportNeedTwoPointsAndARadius) {
  const Model model = model_of(kCam);
  ExportSettings settings;
  settings.curves = {"cam.disc"};
  const ExportedCurve disc = exported_curves(model, settings).value().front();
  const auto with_points = [&](int points) { return curve_csv(model, disc, {{}, points}, model.units()); };
  for (const int points : {1, 0, -1}) {
    EXPECT_TRUE(contains(refusal(with_points(points)),
                         "ExportAccuracy::points = " + std::to_string(points) + ": must be >= 2"));
  }
  EXPECT_EQ(refusal(with_points(2)), "");
  settings.path = ExportSettings::Path::kCutter;
  for (const double radius : {0.0, -1e-3, kNan}) {
    settings.cutter = radius;
    EXPECT_TRUE(contains(refusal(exported_curves(model, settings)), "setting cutter "));
  }
  settings.cutter = 1e-3;
  settings.reach = kNan;
  EXPECT_TRUE(contains(refusal(exported_curves(model, settings)), "setting reach nan: must be > 0"));
}

TEST(Settings, OfADesignNeedASearch) {
  const Model model = shipped_model("design_eccentric");
  const auto refused = [&](const std::function<void(DesignSettings&)>& change) {
    DesignSettings settings;
    change(settings);
    return refusal(design(model, settings));
  };
  EXPECT_TRUE(contains(refused([](auto& s) { s.starts = 0; }), "setting starts 0: must be >= 1"));
  EXPECT_TRUE(contains(refused([](auto& s) { s.evaluations = 0; }), "setting evaluations 0: must be >= 1"));
  EXPECT_TRUE(contains(refused([](auto& s) { s.best = -1; }), "setting best -1: must be >= 1"));
  EXPECT_TRUE(contains(refused([](auto& s) { s.seconds = kNan; }), "setting seconds nan: must be >= 0"));
}

TEST(Settings, OfToleranceVariantsNeedOne) {
  const Model model = shipped_model("toleranced_linkage");
  const SensitivityReport report = sensitivity(model).value();
  for (const std::int64_t count : {0, -3}) {
    ToleranceVariantSettings settings;
    settings.count = count;
    EXPECT_TRUE(contains(refusal(tolerance_variants(model, report, settings)),
                         "setting count " + std::to_string(count) + ": must be from 1 to 100000000"));
  }
}

const std::string kCamWithVariables = std::string(kCam) + R"(
samples = 37
[design.variables]
r = { path = "bodies.cam.curves.disc.radius" }
x = { path = "bodies.cam.curves.disc.center.0" }
y = { path = "bodies.cam.curves.disc.center.1" }
)";

// The lift 31 + 9 sin θ of another disc, as a program would fill it in: without lines.
MeasuredTable lift_table() {
  MeasuredTable table;
  table.source = "made";
  table.columns.resize(2);
  table.columns[0].name = "driver";
  table.columns[1].name = "follower.y";
  for (int k = 0; k < 24; ++k) {
    table.columns[0].values.push_back(15 * k);
    table.columns[1].values.push_back(31 + 9 * std::sin(15 * k * kPi / 180));
  }
  return table;
}

TEST(Settings, OfAFitNeedASearchAndAShare) {
  const Model model = model_of(kCamWithVariables);
  FitSettings settings;
  for (const int starts : {0, -3}) {
    settings.starts = starts;
    EXPECT_TRUE(contains(refusal(fit(model, lift_table(), settings)),
                         "starts = " + std::to_string(starts) + ": must be >= 1"));
  }
  settings = {};
  settings.confidence = kNan;
  EXPECT_TRUE(
      contains(refusal(fit(model, lift_table(), settings)), "confidence = nan: must be between 0 and 1"));
}

TEST(TablesOfAProgram, NeedNoLinesToBeFitted) {
  const FitReport report = fit(model_of(kCamWithVariables), lift_table()).value();
  ASSERT_EQ(report.variables.size(), 3U);
  EXPECT_NEAR(report.variables[0].after, 31, 1e-9);
  EXPECT_NEAR(report.variables[1].after, 9, 1e-9);
  EXPECT_NEAR(report.variables[2].after, 0, 1e-9);
  EXPECT_EQ(report.residuals.front().line, 1);
  EXPECT_EQ(report.residuals.back().line, 24);
}

TEST(TablesOfAProgram, NeedEquallyManyValuesInEveryColumn) {
  MeasuredTable table = lift_table();
  table.columns[1].values.pop_back();
  EXPECT_EQ(refusal(fit(model_of(kCamWithVariables), table)),
            "made: follower.y has 23 values in a table of 24 rows: each row needs one");
  table.columns[0].name = "x";
  table.columns[1].name = "y";
  EXPECT_EQ(refusal(fit_curve(table, FittedCurve::kCircle)),
            "made: y has 23 values in a table of 24 rows: each row needs one");
  table.columns[0].values.pop_back();
  table.lines = {1, 2};
  EXPECT_EQ(refusal(fit_curve(table, FittedCurve::kCircle)),
            "made: x has 23 values in a table of 2 rows: each row needs one");
}

// Points of a circle of radius 5 about (3, -7).
TEST(TablesOfAProgram, NeedNoLinesForACurveButAShare) {
  MeasuredTable table;
  table.columns.resize(2);
  table.columns[0].name = "x";
  table.columns[1].name = "y";
  for (int k = 0; k < 9; ++k) {
    table.columns[0].values.push_back(3 + 5 * std::cos(0.6 * k));
    table.columns[1].values.push_back(-7 + 5 * std::sin(0.6 * k));
  }
  const CurveFitReport report = fit_curve(table, FittedCurve::kCircle).value();
  EXPECT_NEAR(report.numbers[2].value, 5, 1e-12);
  EXPECT_EQ(report.points.back().line, 9);
  for (const double confidence : {2.0, 0.0, kNan}) {
    EXPECT_TRUE(
        contains(refusal(fit_curve(table, FittedCurve::kCircle, confidence)), "must be between 0 and 1"));
  }
}

}  // namespace
}  // namespace higherpair

// Exported curves can be read again: DXF and CSV are read back by the profile's own curve types.
#include "higherpair/front/export.hpp"

#include "contact/support_curves.hpp"
#include "front/cam_profile.hpp"
#include "higherpair/higherpair.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;

namespace fs = std::filesystem;
using ExportPath = ExportSettings::Path;

class Export : public ::testing::Test {
protected:
  Export() { fs::create_directories(folder_); }
  ~Export() override { fs::remove_all(folder_); }

  static Model shipped(const std::string& name, const std::vector<std::string>& overrides = {}) {
    const auto model =
        Model::open(fmt::format("{}/profiles/{}.toml", HIGHERPAIR_SOURCE_DIR, name), overrides);
    EXPECT_TRUE(model) << to_string(model.error());
    return *model;
  }

  static ExportSettings of(const std::string& curve, ExportPath path = ExportPath::kCurve) {
    ExportSettings settings;
    settings.curves = {curve};
    settings.path = path;
    return settings;
  }

  static std::vector<ExportedCurve> taken(const Model& model, const ExportSettings& settings) {
    const auto curves = exported_curves(model, settings);
    EXPECT_TRUE(curves) << to_string(curves.error());
    return *curves;
  }

  static std::string refused(const Model& model, const ExportSettings& settings) {
    const auto curves = exported_curves(model, settings);
    EXPECT_FALSE(curves);
    return curves ? "" : to_string(curves.error());
  }

  // The profile of a model with the curve of its cam replaced.
  Model with_flank(const std::string& profile, const std::string& old_line, const std::string& table) const {
    std::ifstream file(fmt::format("{}/profiles/{}.toml", HIGHERPAIR_SOURCE_DIR, profile));
    std::ostringstream text;
    text << file.rdbuf();
    std::string changed = text.str();
    const auto at = changed.find(old_line);
    EXPECT_NE(at, std::string::npos);
    changed.replace(at, changed.find('\n', at) - at, table);
    const auto model = Model::from_text(changed, (folder_ / "test.toml").string());
    EXPECT_TRUE(model) << to_string(model.error());
    return *model;
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  fs::path folder_ =
      fs::path(::testing::TempDir()) /
      fmt::format("higherpair_export_{}", ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

std::vector<std::vector<double>> rows_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::vector<std::vector<double>> rows;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(cell.empty() ? NAN : std::stod(cell));
    }
    rows.push_back(row);
  }
  return rows;
}

double worst_difference(const Model& a, const Model& b, const std::string& column) {
  const auto run_a = a.run();
  const auto run_b = b.run();
  EXPECT_TRUE(run_a && run_b);
  const ColumnValues left = run_a->column(column);
  const ColumnValues right = run_b->column(column);
  EXPECT_EQ(run_a->size(), run_b->size());
  double worst = 0;
  for (std::size_t i = 0; i < run_a->size(); ++i) {
    worst = std::max(worst, std::abs(left[i] - right[i]));
  }
  return worst;
}

const std::string kFlankLine = "curves.flank = ";

TEST_F(Export, AFlankAsADrawingGivesItsLawBack) {
  const Model cam = shipped("law_cam_roller");
  for (const double tolerance : {1e-5, 1e-7}) {  // m
    const auto text = curves_dxf(cam, taken(cam, of("cam.flank")), {tolerance, {}}, cam.units());
    ASSERT_TRUE(text) << to_string(text.error());
    write("flank.dxf", *text);
    const Model again =
        with_flank("law_cam_roller", kFlankLine,
                   "curves.flank = { type = \"dxf\", file = \"flank.dxf\", layer = \"cam-flank\" }");
    // The follower's error is the distance divided by the cosine of the pressure angle, here below 45
    // degrees.
    EXPECT_LE(worst_difference(cam, again, "slide.position"), 1.5e3 * tolerance) << tolerance;
  }
}

TEST_F(Export, AFlankAsPointsGivesItsLawBackByASpline) {
  const Model cam = shipped("law_cam_roller");
  const auto text = curve_csv(cam, taken(cam, of("cam.flank")).front(), {{}, 720}, cam.units());
  ASSERT_TRUE(text) << to_string(text.error());
  write("flank.csv", *text);
  EXPECT_EQ(rows_of(*text).size(), 720U);
  const Model again =
      with_flank("law_cam_roller", kFlankLine, "curves.flank = { type = \"spline\", file = \"flank.csv\" }");
  EXPECT_LE(worst_difference(cam, again, "slide.position"), 1e-4);
}

TEST_F(Export, ThePitchCurveIsWhereTheRollersCentreIs) {
  const Model cam = shipped("law_cam_roller");
  const Boundary pitch = taken(cam, of("cam.flank", ExportPath::kPitch)).front().boundary;
  const auto motion = cam.run();
  ASSERT_TRUE(motion);
  const ColumnValues driver = motion->column("driver");
  const ColumnValues x = motion->column("follower.x");
  const ColumnValues y = motion->column("follower.y");
  for (std::size_t i = 0; i < motion->size(); i += 7) {
    const Vector2d p = Rotation<double>::from_angle(-driver[i] * kPi / 180) * Vector2d(x[i], y[i]) / 1000;
    double least = 1;
    for (const SpanPtr& span : pitch.spans()) {
      const Bounds range = span->range();
      // Newton's method from the nearest of many points.
      double at = range.low;
      for (int k = 0; k <= 400; ++k) {
        const double t = range.low + range.width() * k / 400;
        if ((span->at(t).p_B - p).norm() < (span->at(at).p_B - p).norm()) at = t;
      }
      for (int k = 0; k < 20; ++k) {
        const SpanPoint point = span->at(at);
        at = std::clamp(at + perp(point.n_B).dot(p - point.p_B) / point.speed, range.low, range.high);
      }
      least = std::min(least, (span->at(at).p_B - p).norm());
    }
    EXPECT_LE(least, 1e-12) << i;
  }
}

TEST_F(Export, ACutterAsLargeAsTheRollerGoesAlongThePitchCurve) {
  const Model cam = shipped("law_cam_roller");
  ExportSettings cutter = of("cam.flank", ExportPath::kCutter);
  cutter.cutter = 0.010;
  const auto pitch = taken(cam, of("cam.flank", ExportPath::kPitch));
  const auto path = taken(cam, cutter);
  EXPECT_EQ(*curve_csv(cam, path.front(), {{}, 100}, cam.units()),
            *curve_csv(cam, pitch.front(), {{}, 100}, cam.units()));
  // With a cutter half a millimetre smaller the path is half a millimetre nearer.
  cutter.cutter = 0.0095;
  const auto smaller = taken(cam, cutter);
  const auto a = rows_of(*curve_csv(cam, pitch.front(), {1e-5, {}}, cam.units()));
  for (const Boundary::Sample& sample : smaller.front().boundary.samples()) {
    const Vector2d out = sample.point.p_B + 0.0005 * sample.point.n_B;
    const SpanPoint same = pitch.front().boundary.at(sample.place);
    EXPECT_NEAR((out - same.p_B).norm(), 0, 1e-15);
  }
}

TEST_F(Export, RowsOfACsvHaveNormalCurvatureAndArc) {
  const Model cam = *Model::from_text(testing::kCam, "cam.toml", std::vector<std::string>{"units.length=cm"});
  const auto text = curve_csv(cam, taken(cam, of("cam.disc")).front(), {{}, 8}, cam.units());
  ASSERT_TRUE(text);
  EXPECT_TRUE(contains(*text, "x[cm],y[cm],nx[1],ny[1],curvature[1/cm],arc[cm]\n"));
  const auto rows = rows_of(*text);
  ASSERT_EQ(rows.size(), 8U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(rows[i][0], 10 + 30 * rows[i][2], 1e-13);
    EXPECT_NEAR(rows[i][1], 30 * rows[i][3], 1e-13);
    EXPECT_NEAR(std::hypot(rows[i][2], rows[i][3]), 1, 1e-15);
    EXPECT_NEAR(rows[i][4], 1.0 / 30, 1e-16);
    EXPECT_NEAR(rows[i][5], 30 * 2 * kPi * static_cast<double>(i) / 8, 1e-12);
  }
  // The result is the same in other units.
  Units inches = cam.units();
  inches.length = Unit::kInch;
  EXPECT_NEAR(rows_of(*curve_csv(cam, taken(cam, of("cam.disc")).front(), {{}, 8}, inches))[0][5], 0, 1e-16);
  EXPECT_NEAR(rows_of(*curve_csv(cam, taken(cam, of("cam.disc")).front(), {{}, 8}, inches))[3][4], 2.54 / 30,
              1e-15);
}

TEST_F(Export, ACornerHasTwoRowsAndNoCurvature) {
  const Model cam = *Model::from_text(std::string(testing::kCam) +
                                      "[bodies.plate.curves.edge]\ntype = \"chain\"\nspans = [\n"
                                      "{ type = \"segment\", from = [0, 0], to = [4, 0] },\n"
                                      "{ type = \"segment\", from = [4, 0], to = [4, 3] },\n"
                                      "{ type = \"segment\", from = [4, 3], to = [0, 0] } ]\n");
  const auto rows = rows_of(*curve_csv(cam, taken(cam, of("plate.edge")).front(), {}, cam.units()));
  ASSERT_EQ(rows.size(), 6U);
  for (const auto& row : rows) {
    EXPECT_TRUE(std::isnan(row[4]));
  }
}

TEST_F(Export, OpenConicsAndFacesGoAsFarAsIsSaid) {
  const Model cam = *Model::from_text(testing::kCam);
  EXPECT_TRUE(contains(refused(cam, of("follower.face")),
                       "follower.face has no ends: say with a reach how far from its point it is to go"));
  ExportSettings settings = of("follower.face");
  settings.reach = 0.012;
  const auto rows = rows_of(*curve_csv(cam, taken(cam, settings).front(), {}, cam.units()));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NEAR(std::abs(rows[0][0]), 12, 1e-14);
  EXPECT_NEAR(std::abs(rows[1][0]), 12, 1e-14);
  const Model parabola = shipped("parabola_cam");
  const auto& body = parabola.mechanism().bodies;
  std::string name;
  for (const Body& b : body) {
    for (const NamedCurve& c : b.curves) {
      if (c.curve.kind == CurveKind::kParabola) name = b.name + "." + c.name;
    }
  }
  EXPECT_TRUE(contains(refused(parabola, of(name)), "how far from its vertex"));
  settings = of(name);
  settings.reach = 0.02;
  EXPECT_EQ(taken(parabola, settings).size(), 1U);
}

TEST_F(Export, EveryShippedCurveGoesOutAsDxfAndSvg) {
  int curves = 0;
  for (const auto& entry : fs::directory_iterator(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles")) {
    if (entry.path().extension() != ".toml") continue;
    const auto model = Model::open(entry.path().string());
    ASSERT_TRUE(model) << to_string(model.error());
    for (const Body& body : model->mechanism().bodies) {
      for (const NamedCurve& curve : body.curves) {
        if (curve.copy_of >= 0 || is_point(curve.curve)) continue;
        ExportSettings settings = of(body.name + "." + curve.name);
        settings.reach = 0.05;
        const auto taken_ones = taken(*model, settings);
        const auto dxf = curves_dxf(*model, taken_ones, {}, model->units());
        ASSERT_TRUE(dxf) << entry.path() << " " << to_string(dxf.error());
        EXPECT_FALSE(contains(*dxf, "nan"));
        const auto svg = curves_svg(*model, taken_ones, {}, model->units());
        ASSERT_TRUE(svg) << to_string(svg.error());
        EXPECT_TRUE(contains(*svg, "data-role=\"outline\" data-name=\"" + body.name + "." + curve.name));
        ++curves;
      }
    }
  }
  EXPECT_GT(curves, 20);
}

TEST_F(Export, SaysWhatIsWrong) {
  const Model cam = *Model::from_text(testing::kCam, "cam.toml");
  EXPECT_TRUE(contains(refused(cam, of("cam.disk")),
                       "cam.toml: there is no curve cam.disk; did you mean `cam.disc`?"));
  EXPECT_TRUE(contains(refused(cam, {}), "name the curve to export: cam.disc, follower.face"));
  ExportSettings settings;
  settings.body = "can";
  EXPECT_TRUE(contains(refused(cam, settings), "there is no body can; did you mean `cam`?"));
  settings.body = "ground";
  EXPECT_TRUE(contains(refused(cam, settings), "the body ground has no curves to draw"));
  settings.body = "cam";
  EXPECT_EQ(taken(cam, settings).front().name, "cam.disc");
  EXPECT_TRUE(
      contains(refused(cam, of("cam.disc", ExportPath::kPitch)),
               "no circle or knife edge touches cam.disc, whose path would be the pitch curve: give the "
               "radius of a cutter instead"));
  const Model four_bar = shipped("four_bar");
  EXPECT_TRUE(contains(refused(four_bar, {}), "there are no curves"));
  const auto text = curve_csv(cam, taken(cam, of("cam.disc")).front(), {1e-12, {}}, cam.units());
  ASSERT_FALSE(text);
  EXPECT_TRUE(
      contains(to_string(text.error()),
               "a tolerance of 1e-09 mm is finer than cam.disc can be drawn: take at least 4.29e-08 mm"));
  EXPECT_FALSE(curves_dxf(cam, taken(cam, of("cam.disc")), {1e-12, {}}, cam.units()));
}

// A disc of 1e-160 mm at 12 mm is a point but for rounding; one of 1e-9 mm keeps its shape to within that.
TEST_F(Export, ACurveThatIsTooSmallForItsCoordinatesIsRefused) {
  const auto dxf_with = [](const std::string& radius) {
    const Model cam = shipped("flat_faced_oscillating", {"bodies.cam.curves.disc.radius=" + radius});
    return curves_dxf(cam, taken(cam, of("cam.disc")), {}, cam.units());
  };
  const auto none = dxf_with("1e-160");
  ASSERT_FALSE(none);
  EXPECT_TRUE(contains(to_string(none.error()), "cam.disc is too small to be drawn at 8 mm from"));
  EXPECT_TRUE(
      contains(to_string(none.error()), "make it at least 1.21e-11 mm large, or move the origin near it"));
  for (const char* radius : {"1e-10", "1e-9", "1e-6", "1e-3"}) {
    const auto text = dxf_with(radius);
    ASSERT_TRUE(text) << radius;
    EXPECT_LT(text->size(), 10000U) << radius;
  }
}

TEST_F(Export, SaysHowLargeACutterMayBe) {
  // A hole slightly larger than 20.
  const Model ring = testing::model_of(std::string(testing::kCam) +
                                       "[bodies.ring]\ncurves.hole = { type = \"circle\", center = [10, 0], "
                                       "radius = 20.00049, side = \"outside\" }\n");
  ExportSettings settings = of("ring.hole", ExportPath::kCutter);
  settings.cutter = 0.025;
  const std::string message = refused(ring, settings);
  EXPECT_TRUE(contains(message, "a cutter or roller of radius 25 mm is too large for ring.hole: at ("));
  EXPECT_TRUE(contains(message, "it is concave with a smaller radius; anything below 20 mm can"));
  settings.cutter = 0.020;
  EXPECT_EQ(taken(ring, settings).size(), 1U);
}

TEST_F(Export, SaysWhereNoCutterGets) {
  const std::string plate = std::string(testing::kCam) +
                            "[bodies.plate.curves.edge]\ntype = \"chain\"\nspans = [\n"
                            "{ type = \"segment\", from = [1, 0], to = [0, -2] },\n"
                            "{ type = \"segment\", from = [0, -2], to = [5, 0] },\n"
                            "{ type = \"segment\", from = [5, 0], to = [0, 2] },\n"
                            "{ type = \"segment\", from = [0, 2], to = [1, 0] } ]\n";
  const Model cam = *Model::from_text(plate);
  ExportSettings settings = of("plate.edge", ExportPath::kCutter);
  settings.cutter = 0.0001;
  EXPECT_TRUE(
      contains(refused(cam, settings),
               "plate.edge has a hollow corner at (1, 0), which no round cutter can cut: round it first"));
}

TEST_F(Export, SaysWhereAPathCrossesItself) {
  // A pocket of radius 10 with a mouth 6 wide.
  const std::string jaw = std::string(testing::kCam) +
                          "[bodies.jaw.curves.pocket]\ntype = \"chain\"\nclosed = false\nspans = [\n"
                          "{ type = \"segment\", from = [30, -3], to = [9.539392014169456, -3] },\n"
                          "{ type = \"arc\", center = [0, 0], radius = 10, from = 17.457603123722095, "
                          "to = 342.5423968762779 },\n"
                          "{ type = \"segment\", from = [9.539392014169456, 3], to = [30, 3] } ]\n";
  const auto model = Model::from_text(jaw);
  ASSERT_TRUE(model) << to_string(model.error());
  ExportSettings settings = of("jaw.pocket", ExportPath::kCutter);
  settings.cutter = 0.0029;
  const auto good = exported_curves(*model, settings);
  EXPECT_TRUE(good) << to_string(good.error());
  settings.cutter = 0.0035;
  EXPECT_TRUE(contains(refused(*model, settings), "its path crosses itself at"));
  EXPECT_TRUE(
      contains(refused(*model, settings), "where it cuts into another part; anything below 2.999 mm can"));
}

TEST_F(Export, SaysWhichRollerItCannotChoose) {
  const std::string two =
      std::string(testing::kCam) +
      "[bodies.r1]\npose = { x = 70 }\npoints.P = [0, 0]\n"
      "curves.c = { type = \"circle\", center = [0, 0], radius = 5 }\n"
      "[bodies.r2]\npose = { x = -70 }\npoints.P = [0, 0]\n"
      "curves.c = { type = \"circle\", center = [0, 0], radius = 7 }\n"
      "[joints.g1]\ntype = \"prismatic\"\nbetween = [\"ground.O\", \"r1.P\"]\ndirection = 0\n"
      "[joints.g2]\ntype = \"prismatic\"\nbetween = [\"ground.O\", \"r2.P\"]\ndirection = 0\n"
      "[contacts.k1]\nbetween = [\"cam.disc\", \"r1.c\"]\n"
      "[contacts.k2]\nbetween = [\"r2.c\", \"cam.disc\"]\n";
  const auto model = Model::from_text(two);
  ASSERT_TRUE(model) << to_string(model.error());
  EXPECT_TRUE(contains(refused(*model, of("cam.disc", ExportPath::kPitch)),
                       "rollers of different radii touch cam.disc (k1: 5 mm, k2: 7 mm): give the one that is "
                       "meant as the radius of a cutter"));
}

TEST_F(Export, AKnifeEdgeIsDrawnOnlyByItsCutter) {
  const Model knife = shipped("knife_edge");
  std::string name;
  for (const Body& b : knife.mechanism().bodies) {
    for (const NamedCurve& c : b.curves) {
      if (is_point(c.curve)) name = b.name + "." + c.name;
    }
  }
  EXPECT_TRUE(contains(refused(knife, of(name)), name + " is a point, of which there is nothing to draw"));
  ExportSettings settings = of(name, ExportPath::kCutter);
  settings.cutter = 0.003;
  EXPECT_TRUE(contains(*curves_dxf(knife, taken(knife, settings), {}, knife.units()), "CIRCLE"));
}

TEST_F(Export, ACurveByItsSupportGoesOutUnlessItHasCusps) {
  const testing::LobedCurve lobes(0.03, 0.002), cusps(0.03, 0.005);
  Mechanism mechanism = Model::from_text(testing::kCam)->mechanism();
  add_curve(mechanism, 1, "lobes", make_curve(lobes));
  add_curve(mechanism, 1, "cusps", make_curve(cusps));
  const auto model = Model::from(mechanism);
  ASSERT_TRUE(model) << to_string(model.error());
  const std::string name = mechanism.bodies[1].name;
  EXPECT_TRUE(contains(refused(*model, of(name + ".cusps")), name + ".cusps has cusps: it bounds no body"));
  const std::vector<ExportedCurve> all = taken(*model, of(name + ".lobes"));
  ASSERT_EQ(all.size(), 1U);
  ASSERT_TRUE(all[0].boundary.is_closed());
  const Span& span = *all[0].boundary.spans().at(0);
  for (double share = 0; share <= 1; share += 0.01) {
    const SpanPoint point = span.at(span.range().low + share * span.range().width());
    const double phi = std::atan2(point.n_B.y(), point.n_B.x());
    EXPECT_NEAR(point.p_B.dot(point.n_B), 0.03 + 0.002 * std::cos(3 * phi), 1e-16);
    EXPECT_NEAR(point.kappa * (0.03 - 0.016 * std::cos(3 * phi)), 1, 1e-12);
  }
}

TEST_F(Export, APictureHasTheTrueSize) {
  const Model cam = *Model::from_text(testing::kCam);
  const auto svg = curves_svg(cam, taken(cam, of("cam.disc")), {}, cam.units());
  ASSERT_TRUE(svg);
  // 60 mm wide, at 96 px to the inch, and a margin of 10 px.
  EXPECT_TRUE(contains(*svg, fmt::format("width=\"{:.5f}\"", 60 / 25.4 * 96 + 20)));
  EXPECT_TRUE(contains(*svg, "data-scale=\"3.77952755906\""));
  EXPECT_TRUE(contains(*svg, "data-role=\"origin\""));
}

}  // namespace
}  // namespace higherpair

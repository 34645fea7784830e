// Numbers fitted to measured motion: a six-bar from its own noisy motion, closed forms of linear problems,
// outliers, unknown zeros, numbers that cannot be told apart, and mistakes in measurements.
#include "higherpair/front/fit.hpp"

#include "front/cam_profile.hpp"
#include "higherpair/io/design_task.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::a_line_contains;
using testing::contains;
using testing::contains_all;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::kCam;
using testing::lines_are;
using testing::model_of;
using testing::shipped_model;

MeasuredTable table_of(const std::string& text) {
  auto table = read_measured_text(text, "measured.csv");
  if (!table) throw std::runtime_error(to_string(table.error()));
  return *std::move(table);
}

FitReport fitted(const Model& model, const MeasuredTable& table, const FitSettings& settings = {}) {
  auto report = fit(model, table, settings);
  if (!report) throw std::runtime_error(to_string(report.error()));
  return *std::move(report);
}

// The motion of a model at these positions of its driver.
MeasuredTable measured_motion(const Model& model, const std::vector<double>& positions,
                              const std::vector<std::string>& columns) {
  RunSettings settings;
  settings.positions = positions;
  settings.columns = columns;
  settings.columns.insert(settings.columns.begin(), "driver");
  const Motion motion = model.run(settings).value();
  MeasuredTable table;
  table.source = "measured.csv";
  for (std::size_t k = 0; k < positions.size(); ++k) table.lines.push_back(static_cast<int>(k) + 2);
  for (const std::string& name : settings.columns) {
    const auto values = motion.column(name).values;
    MeasuredColumn column;
    column.name = name;
    column.values.assign(values.begin(), values.end());
    column.place = {"measured.csv", 1, 1};
    table.columns.push_back(column);
  }
  return table;
}

std::vector<double> positions(double from, double to, int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) all.push_back(from + (to - from) * k / (count - 1));
  return all;
}

void add_noise(MeasuredColumn& column, double deviation, std::mt19937_64& engine) {
  std::normal_distribution<double> noise(0, deviation);
  for (double& value : column.values) value += noise(engine);
}

// The follower is at r + c_x sin θ + c_y cos θ [mm]: linear in the radius and centre of the disc.
const std::string kVariables = R"(
samples = 37
[design.variables]
r = { path = "bodies.cam.curves.disc.radius" }
x = { path = "bodies.cam.curves.disc.center.0" }
y = { path = "bodies.cam.curves.disc.center.1" }
)";

std::string message_of(const std::string& text, const std::string& measured,
                       const FitSettings& settings = {}) {
  const auto model = Model::from_text(text, "test.toml");
  if (!model) return to_string(model.error());
  const auto table = read_measured_text(measured, "measured.csv");
  if (!table) return to_string(table.error());
  const auto report = fit(*model, *table, settings);
  return report ? "" : to_string(report.error());
}

const std::string kCamFit = std::string(kCam) + kVariables;

std::string lift_table(const std::string& head, double (*of)(double theta)) {
  std::string text = head + "\n";
  for (int k = 0; k < 24; ++k) text += fmt::format("{},{}\n", 15 * k, of(15 * k * kPi / 180));
  return text;
}

double eccentric_lift(double theta) {
  return 30 + 10 * std::sin(theta);
}

TEST(Fit, ACamsEccentricityComesFromItsLift) {
  std::mt19937_64 engine(1);
  std::normal_distribution<double> noise(0, 0.05);
  // At equal steps over a turn the three functions are orthogonal: the estimates are sums, with variances
  // σ²/n and 2σ²/n.
  const int n = 24;
  double sum = 0, sine = 0, cosine = 0;
  std::string text = "driver,follower.y\n";
  std::vector<double> values;
  for (int k = 0; k < n; ++k) {
    const double theta = 2 * kPi * k / n;
    values.push_back(32.5 + 9.25 * std::sin(theta) + 1.125 * std::cos(theta) + noise(engine));
    sum += values.back() / n;
    sine += 2 * values.back() * std::sin(theta) / n;
    cosine += 2 * values.back() * std::cos(theta) / n;
    text += fmt::format("{},{}\n", 360.0 * k / n, values.back());
  }
  double square = 0;
  for (int k = 0; k < n; ++k) {
    const double theta = 2 * kPi * k / n;
    square += std::pow(values[k] - sum - sine * std::sin(theta) - cosine * std::cos(theta), 2);
  }
  const double s = std::sqrt(square / (n - 3));
  const FitReport report = fitted(model_of(kCamFit), table_of(text));
  EXPECT_TRUE(report.good);
  EXPECT_TRUE(report.exact);
  EXPECT_EQ(report.freedoms, n - 3);
  ASSERT_EQ(report.variables.size(), 3U);
  EXPECT_NEAR(report.variables[0].after, sum, 1e-9);
  EXPECT_NEAR(report.variables[1].after, sine, 1e-9);
  EXPECT_NEAR(report.variables[2].after, cosine, 1e-9);
  EXPECT_NEAR(report.variables[0].error, s / std::sqrt(n), 1e-9);
  EXPECT_NEAR(report.variables[1].error, s * std::sqrt(2.0 / n), 1e-9);
  // Student's t for 21 degrees of freedom, 97.5 %: 2.0796 in the tables.
  EXPECT_NEAR(report.variables[1].half / report.variables[1].error, 2.0796, 5e-5);
  EXPECT_NEAR(report.correlation(0, 1), 0, 1e-8);
  EXPECT_NEAR(report.columns[0].noise, s, 1e-9);
  EXPECT_NEAR(report.columns[0].rms, std::sqrt(square / n), 1e-10);
  EXPECT_EQ(report.variables[0].unit, "mm");
  EXPECT_EQ(report.variables[0].before, 30);
}

TEST(Fit, ExactValuesGiveTheNumbersAndTheirProfile) {
  const FitReport report = fitted(
      model_of(kCamFit),
      table_of(lift_table("driver[deg],follower.y[mm]", [](double t) { return 27.5 + 8.0 * std::sin(t); })));
  EXPECT_TRUE(report.good);
  EXPECT_NEAR(report.variables[0].after, 27.5, 1e-11);
  EXPECT_NEAR(report.variables[1].after, 8, 1e-11);
  EXPECT_NEAR(report.variables[2].after, 0, 1e-11);
  EXPECT_LE(report.columns[0].rms, 1e-12);
  EXPECT_NEAR(report.columns[0].explained, 1, 1e-12);
  const Model again = model_of(report.text);
  EXPECT_NEAR(again.mechanism().bodies[1].curves[0].curve.semi_latus, 0.0275, 1e-13);
  EXPECT_TRUE(contains(report.text, "points.P = [0, 0]"));
  EXPECT_THAT(report.notes, IsEmpty());
}

const std::vector<double> kTruth = {15, 18, 20, 7.5, 25, 24};

struct SixBar {
  Model truth = shipped_model("sixbar_slider");
  Model guess = shipped_model("sixbar_measured");
};

// 95 of 100 intervals contain the true length; ± 4 standard deviations of the count of independent trials.
TEST(Fit, TheSixBarIsFoundFromItsOwnNoisyMotionAsOftenAsTheIntervalsSay) {
  const SixBar bar;
  const MeasuredTable exact =
      measured_motion(bar.truth, positions(45, -300, 47), {"link4.angle", "slider.x"});
  constexpr int kTrials = 100;
  std::vector<int> hits(kTruth.size(), 0);
  FitSettings settings;
  settings.loss = FitLoss::kSquares;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::mt19937_64 engine(static_cast<unsigned>(trial) + 100);
    MeasuredTable table = exact;
    add_noise(table.columns[1], 0.08, engine);
    add_noise(table.columns[2], 0.03, engine);
    const FitReport report = fitted(bar.guess, table, settings);
    ASSERT_EQ(report.end, FitEnd::kConverged) << trial;
    EXPECT_TRUE(report.good) << trial;
    for (std::size_t i = 0; i < kTruth.size(); ++i) {
      hits[i] += std::abs(report.variables[i].after - kTruth[i]) <= report.variables[i].half ? 1 : 0;
    }
  }
  int all = 0;
  for (const int count : hits) {
    EXPECT_GE(count, 95 - 9);
    all += count;
  }
  EXPECT_GE(all, 600 * 0.95 - 30);
  EXPECT_LE(all, 600 * 0.95 + 25);
}

TEST(Fit, ExactMotionOfTheSixBarGivesItsLengths) {
  const SixBar bar;
  const MeasuredTable exact =
      measured_motion(bar.truth, positions(45, -300, 40), {"link4.angle", "slider.x"});
  const FitReport report = fitted(bar.guess, exact);
  EXPECT_TRUE(report.good);
  EXPECT_TRUE(report.exact);
  for (std::size_t i = 0; i < kTruth.size(); ++i) EXPECT_NEAR(report.variables[i].after, kTruth[i], 1e-8);
  ASSERT_EQ(report.measurement.size(), 1U);
  EXPECT_EQ(report.measurement[0].name, "offset of link4.angle");
  EXPECT_NEAR(report.measurement[0].after, 0, 1e-8);
}

TEST(Fit, TheShippedTableGivesTheLinkageBehindIt) {
  const Model model = shipped_model("sixbar_measured");
  const auto table = read_measured_file(HIGHERPAIR_SOURCE_DIR "/profiles/sixbar_measured.csv");
  const FitReport report = fitted(model, table.value());
  EXPECT_TRUE(report.good);
  for (std::size_t i = 0; i < kTruth.size(); ++i) {
    EXPECT_NEAR(report.variables[i].after, kTruth[i], 1.5 * report.variables[i].half) << i;
  }
  EXPECT_NEAR(report.measurement[0].after, 3.2, 1.5 * report.measurement[0].half);
  // The three wrong readings are found, and no others.
  std::vector<int> lines;
  for (const FitReport::Residual& residual : report.residuals) {
    if (residual.outlier) lines.push_back(residual.line);
  }
  EXPECT_THAT(lines, ElementsAre(32, 63, 79));
  EXPECT_TRUE(contains(report.text, "# The six-bar of sixbar_slider.toml as it was built"));
}

TEST(Fit, RobustLossesForgetWrongValues) {
  std::string text = "driver,follower.y\n";
  std::mt19937_64 engine(5);
  std::normal_distribution<double> noise(0, 0.02);
  for (int k = 0; k < 72; ++k) {
    const double wrong = k % 9 == 4 ? 3 + 0.1 * k : 0;
    text += fmt::format("{},{}\n", 5 * k, 31 + 9 * std::sin(5 * k * kPi / 180) + noise(engine) + wrong);
  }
  const Model model = model_of(kCamFit);
  FitSettings settings;
  const FitReport plain = fitted(model, table_of(text), settings);
  EXPECT_GT(std::abs(plain.variables[0].after - 31), 0.3);
  settings.loss = FitLoss::kHuber;
  const FitReport huber = fitted(model, table_of(text), settings);
  EXPECT_NEAR(huber.variables[0].after, 31, 0.02);
  settings.loss = FitLoss::kTukey;
  const FitReport tukey = fitted(model, table_of(text), settings);
  EXPECT_NEAR(tukey.variables[0].after, 31, 3 * tukey.variables[0].half);
  EXPECT_NEAR(tukey.variables[1].after, 9, 3 * tukey.variables[1].half);
  EXPECT_LT(tukey.variables[0].half, 0.01);
  EXPECT_EQ(tukey.columns[0].outliers, 8);
  EXPECT_EQ(huber.columns[0].outliers, 8);
  EXPECT_NEAR(tukey.columns[0].noise, 0.02, 0.01);
}

TEST(Fit, UnknownZerosOfColumnsAndDriversAreFound) {
  const std::string profile = std::string(kCam) + R"(
samples = 37
[design.variables]
x = { path = "bodies.cam.curves.disc.center.0" }
[[fit.columns]]
column = "follower.y"
offset = true
[[fit.columns]]
column = "driver"
offset = true
)";
  // The encoder shows 128.5 deg more than the cam has turned, and the gauge 4.25 mm less.
  std::string text = "driver,follower.y,follower.vy[mm/s]\n";
  for (int k = 0; k < 36; ++k) {
    const double theta = 10 * k * kPi / 180;
    text += fmt::format("{},{},\n", 10 * k + 128.5, 30 + 11 * std::sin(theta) - 4.25);
  }
  const FitReport report = fitted(model_of(profile), table_of(text));
  EXPECT_TRUE(report.good);
  EXPECT_NEAR(report.variables[0].after, 11, 1e-9);
  ASSERT_EQ(report.measurement.size(), 2U);
  EXPECT_EQ(report.measurement[0].name, "offset of driver");
  EXPECT_NEAR(report.measurement[0].after, 128.5, 1e-8);
  EXPECT_EQ(report.measurement[1].name, "offset of follower.y");
  EXPECT_NEAR(report.measurement[1].after, -4.25, 1e-9);
  EXPECT_TRUE(a_line_contains(report.notes, "follower.vy has no values"));
}

// A crank, and a slide whose zero is not known; a unit that is only presumed is that of its own driver, too.
const std::string kCrankAndSlide = R"(
[bodies.ground]
points.O = [0, 0]
points.Q = [0, 50]
[bodies.crank]
points.O = [0, 0]
points.A = [20, 0]
[bodies.slide]
pose = { x = 0, y = 50 }
points.Q = [0, 0]
points.B = [7, 3]
[joints]
pin = { type = "revolute", between = ["ground.O", "crank.O"] }
s   = { type = "prismatic", between = ["ground.Q", "slide.Q"], direction = [1, 0] }
[drivers.pin]
joint = "pin"
start = 0
end = 90
samples = 10
[drivers.s]
joint = "s"
start = 0
end = 30
samples = 10
[design.variables]
a = { path = "bodies.crank.points.A.0" }
)";

std::string crank_and_slide_table(double slide_off, double slide_factor) {
  std::string text = "driver.pin,driver.s,crank.A.x,slide.B.x,slide.B.y\n";
  for (int k = 0; k < 10; ++k) {
    const double s = 10 * k / 3.;
    text += fmt::format("{},{},{},{},53\n", 10 * k, slide_factor * s + slide_off,
                        21 * std::cos(10 * k * kPi / 180), s + 7);
  }
  return text;
}

TEST(Fit, TheZeroOfEachDriverIsInItsOwnUnit) {
  FitSettings settings;
  settings.offsets = {"driver.s", "driver.pin"};
  const FitReport report =
      fitted(model_of(kCrankAndSlide), table_of(crank_and_slide_table(4.5, 1)), settings);
  EXPECT_NEAR(report.variables[0].after, 21, 1e-9);
  ASSERT_EQ(report.measurement.size(), 2U);
  EXPECT_EQ(report.measurement[0].unit, "deg");
  EXPECT_EQ(report.measurement[1].unit, "mm");
  EXPECT_NEAR(report.measurement[1].after, 4.5, 1e-9);
}

TEST(Fit, ASlideThatIsMeasuredInMetresIsRecognisedBesideACrank) {
  EXPECT_TRUE(contains(message_of(kCrankAndSlide, crank_and_slide_table(0, 1e-3)),
                       "write driver.s[m] in the header"));
}

TEST(Fit, APathMeasuredInAFrameOfItsOwnGivesTheFrameAsWell) {
  const Model truth = shipped_model("four_bar");
  const std::string name =
      truth.mechanism().bodies[2].name + "." + truth.mechanism().bodies[2].points.back().name;
  RunSettings settings;
  settings.columns = {"driver", name + ".x", name + ".y"};
  settings.samples = 40;
  const Motion motion = truth.run(settings).value();
  std::string text = fmt::format("driver,{0}.x,{0}.y\n", name);
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double x = motion.column(name + ".x")[k], y = motion.column(name + ".y")[k];
    // Rotated by 35 deg, 1.7 times as large, and moved.
    const double c = 1.7 * std::cos(35 * kPi / 180), s = 1.7 * std::sin(35 * kPi / 180);
    text += fmt::format("{},{},{}\n", motion.column("driver")[k], c * x - s * y + 12, s * x + c * y - 7);
  }
  std::string variable;
  for (const Parameter& parameter : truth.parameters()) {
    if (variable.empty() && parameter.path.starts_with("bodies.") && parameter.value > 0 &&
        parameter.path.find(".points.B.") != std::string::npos) {
      variable = parameter.path;
    }
  }
  ASSERT_FALSE(variable.empty());
  std::ostringstream profile;
  profile << std::ifstream(HIGHERPAIR_SOURCE_DIR "/profiles/four_bar.toml").rdbuf();
  const std::string own = profile.str() + fmt::format(
                                              "\n[design.variables]\nlength = {{ path = \"{}\" }}\n"
                                              "[[fit.frames]]\npoint = \"{}\"\nfree = [\"position\", "
                                              "\"turn\", \"scale\"]\n",
                                              variable, name);
  const double right = model_of(own).profile().design->variables[0].range.start;
  std::string guess = own;
  const std::size_t at = guess.find("points.B = [3.5");
  ASSERT_NE(at, std::string::npos);
  guess.replace(at, 15, "points.B = [3.6");
  const FitReport report = fitted(model_of(guess), table_of(text));
  EXPECT_NEAR(report.variables[0].after, right, 1e-7 * right);
  ASSERT_EQ(report.measurement.size(), 4U);
  EXPECT_NEAR(report.measurement[0].after, 12, 1e-6);
  EXPECT_NEAR(report.measurement[1].after, -7, 1e-6);
  EXPECT_NEAR(report.measurement[2].after, 35, 1e-6);
  EXPECT_NEAR(report.measurement[3].after, 1.7, 1e-8);
}

TEST(Fit, AnglesOfAnInstrumentThatCountsWithinATurnAreUnwrapped) {
  const SixBar bar;
  MeasuredTable table =
      measured_motion(bar.truth, positions(45, -675, 60), {"link4.angle", "slider.x", "link2.angle"});
  for (double& angle : table.columns[3].values) angle = std::remainder(angle, 360);
  const FitReport report = fitted(bar.guess, table);
  EXPECT_NEAR(report.variables[1].after, kTruth[1], 1e-8);
  EXPECT_TRUE(
      a_line_contains(report.notes, "link2.angle: 41 of its angles are taken as so many whole turns"));
}

TEST(Fit, RowsInTimeMayHaveAnUnknownZero) {
  const std::string profile = std::string(kCam) + "velocity = 90\nacceleration = 20\n" + R"(
[design.variables]
x = { path = "bodies.cam.curves.disc.center.0" }
[[fit.columns]]
column = "time"
offset = true
)";
  std::string text = "time,follower.y,follower.vy\n";
  for (int k = 0; k < 40; ++k) {
    const double t = 0.07 * k, theta = (90 * t + 10 * t * t) * kPi / 180, omega = (90 + 20 * t) * kPi / 180;
    text += fmt::format("{},{},{}\n", t + 0.35, 30 + 12 * std::sin(theta), 12 * omega * std::cos(theta));
  }
  const FitReport report = fitted(model_of(profile), table_of(text));
  EXPECT_TRUE(report.exact);
  EXPECT_NEAR(report.variables[0].after, 12, 1e-8);
  EXPECT_NEAR(report.measurement[0].after, 0.35, 1e-9);
}

// A crank-slider that a law moves, with the crank's length to be fitted.
Model law_crank(const std::string& fit = "") {
  std::ostringstream read;
  read << std::ifstream(HIGHERPAIR_SOURCE_DIR "/profiles/start_stop_crank.toml").rdbuf();
  std::string text = read.str();
  const std::string length = "points.A = [30, 0]";
  text.replace(text.find(length), length.size(), "points.A = [28, 0]");
  return model_of(text + "\n[design.variables]\nr = { path = \"bodies.crank.points.A.0\" }\n" + fit);
}

// The motion of the shipped one, whose crank is 30 long, in time.
MeasuredTable motion_of_law(const std::string& column, double late) {
  RunSettings settings;
  settings.in_time = settings.jerk = true;
  settings.columns = {"time", column};
  const Motion motion = shipped_model("start_stop_crank").run(settings).value();
  const ColumnValues times = motion.column("time"), values = motion.column(column);
  std::string text = "time," + column + "\n";
  for (std::size_t k = 0; k < times.size(); k += 7)
    text += fmt::format("{},{}\n", times[k] + late, values[k]);
  return table_of(text);
}

TEST(Fit, ColumnsOfJerkTakeTheDriversJerkFromTheirLaw) {
  const FitReport report = fitted(law_crank(), motion_of_law("piston.jx", 0));
  EXPECT_NEAR(report.variables[0].after, 30, 1e-7);
  EXPECT_EQ(report.columns[0].outliers, 0);
}

TEST(Fit, AnUnknownZeroOfTimeIsFoundFromAccelerationsUnderALaw) {
  const FitReport report = fitted(law_crank("[[fit.columns]]\ncolumn = \"time\"\noffset = true\n"),
                                  motion_of_law("crank.A.ax", 0.003));
  EXPECT_TRUE(report.exact);
  EXPECT_NEAR(report.variables[0].after, 30, 1e-7);
  EXPECT_NEAR(report.measurement[0].after, 0.003, 1e-8);
}

TEST(Fit, ABodyCalledDriverIsMeasuredAsAnyOther) {
  const std::string profile = R"([bodies.ground]
points.O = [0, 0]
[bodies.driver]
points.O = [0, 0]
points.A = [28, 0]
[joints]
main = { type = "revolute", between = ["ground.O", "driver.O"] }
[driver]
joint = "main"
[design.variables]
r = { path = "bodies.driver.points.A.0" }
)";
  std::string text = "driver,driver.A.x,driver.A.y,driver.velocity\n";
  for (int k = 0; k < 12; ++k) {
    const double theta = 30 * k * kPi / 180;
    text += fmt::format("{},{},{},1\n", 30 * k, 30 * std::cos(theta), 30 * std::sin(theta));
  }
  const FitReport report = fitted(model_of(profile), table_of(text));
  EXPECT_EQ(report.columns.size(), 2U);
  EXPECT_NEAR(report.variables[0].after, 30, 1e-9);
}

TEST(Fit, NumbersThatOnlyTheirRatiosAreKnownOfAreNamed) {
  std::ostringstream text;
  text << std::ifstream(HIGHERPAIR_SOURCE_DIR "/profiles/sixbar_measured.toml").rdbuf();
  std::string profile = text.str();
  profile = profile.substr(0, profile.find("[design.variables]")) + R"([design.variables]
frame   = { path = "bodies.ground.points.F.0" }
crank   = { path = "bodies.link2.points.A.0" }
coupler = { path = "bodies.link3.points.B.0" }
rocker  = { path = "bodies.link4.points.F.0" }
)";
  const SixBar bar;
  const FitReport report =
      fitted(model_of(profile), measured_motion(bar.truth, positions(45, -300, 40), {"link4.angle"}));
  EXPECT_FALSE(report.good);
  EXPECT_TRUE(lines_are(
      report.undetermined,
      {"frame, crank, coupler and rocker cannot be told apart by these columns: only their ratios"}));
  EXPECT_FALSE(report.variables[0].determined);
  EXPECT_TRUE(std::isnan(report.variables[0].half));
  EXPECT_NEAR(report.variables[1].after / report.variables[0].after, 15.0 / 21, 1e-8);
}

// The lift of the follower's pivot is 0: what moves the cam on its own pin changes rounding alone.
TEST(Fit, ANumberThatChangesNothingButRoundingIsRefused) {
  std::ifstream file(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/hyperbola_cam.toml");
  std::stringstream text;
  text << file.rdbuf() << "\n[design.variables]\nq = { path = \"bodies.cam.points.O.0\" }\n";
  std::string measured = "driver[deg],follower.y[mm],follower.O.x[mm]\n";
  for (int k = -40; k <= 40; k += 10) measured += fmt::format("{},20,70\n", k);
  const auto with = [&](const std::string& value) {
    std::string profile = text.str();
    const std::size_t at = profile.find("points.O    = [0, 0]");
    return profile.replace(at, 20, "points.O    = [" + value + ", 0]");
  };
  EXPECT_TRUE(contains(message_of(with("0.3"), measured),
                       "design.variables.q: changes none of the measured columns"));
}

TEST(Fit, NumbersOfWhichOnlySumOrDifferenceIsKnownAreNamed) {
  // The position of the face on the follower and the radius of the disc lift the follower in the same way.
  const std::string profile = std::string(kCam) + R"(
[design.variables]
r = { path = "bodies.cam.curves.disc.radius" }
f = { path = "bodies.follower.curves.face.point.1" }
)";
  const FitReport report =
      fitted(model_of(profile), table_of(lift_table("driver,follower.y", eccentric_lift)));
  EXPECT_TRUE(lines_are(report.undetermined,
                        {"r and f cannot be told apart by these columns: only their difference"}));
}

TEST(Fit, ResidualsThatFollowOneAnotherAreNoted) {
  // A second harmonic, which no eccentric disc has.
  const FitReport report = fitted(model_of(kCamFit), table_of(lift_table("driver,follower.y", [](double t) {
                                    return 30 + 10 * std::sin(t) + 0.2 * std::sin(2 * t);
                                  })));
  EXPECT_TRUE(report.columns[0].systematic);
  EXPECT_TRUE(a_line_contains(report.notes, "residuals of follower.y follow one another"));
}

TEST(Fit, ResidualsLargerThanTheDeviationsGivenSayThatTheModelIsWrong) {
  const std::string given = "[[fit.columns]]\ncolumn = \"follower.*\"\ndeviation = ";
  const std::string table =
      lift_table("driver,follower.y", [](double t) { return 30 + 10 * std::sin(t) + 0.2 * std::sin(2 * t); });
  const FitReport small = fitted(model_of(kCamFit + given + "0.01\n"), table_of(table));
  EXPECT_TRUE(small.too_large);
  EXPECT_FALSE(small.good);
  EXPECT_GT(small.noise_ratio, 10);
  const FitReport large = fitted(model_of(kCamFit + given + "0.2\n"), table_of(table));
  EXPECT_FALSE(large.too_large);
  EXPECT_TRUE(large.good);
}

TEST(Fit, DeviationsBelowRoundingAreRefused) {
  const std::string lift = lift_table("driver,follower.y", eccentric_lift);
  EXPECT_TRUE(contains(message_of(kCamFit + "[[fit.columns]]\ncolumn = \"*\"\ndeviation = 1e-200\n", lift),
                       "fit.columns.0.deviation = 1e-200 mm: the rounding of follower.y is more, 4e-12 mm"));
  EXPECT_EQ(message_of(kCamFit + "[[fit.columns]]\ncolumn = \"*\"\ndeviation = 1e-11\n", lift), "");
}

// Where nothing but 0 was measured there is no rounding to compare with.
TEST(Fit, ResidualsThatAreTooManyDeviationsForANumberHaveNoChance) {
  const std::string profile = std::string(kCam) + R"(
samples = 37
[design.variables]
y = { path = "bodies.cam.curves.disc.center.1" }
[[fit.columns]]
column = "*"
deviation = 1e-200
)";
  const FitReport report =
      fitted(model_of(profile), table_of(lift_table("driver,follower.y", [](double) { return 0.; })));
  EXPECT_TRUE(report.too_large);
  EXPECT_FALSE(report.good);
}

TEST(Fit, BoundsHoldAndAreSaid) {
  std::string profile = kCamFit;
  profile.replace(profile.find("radius\" }"), 9, "radius\", min = 5, max = 30.5 }");
  const FitReport report =
      fitted(model_of(profile),
             table_of(lift_table("driver,follower.y", [](double t) { return 31 + 10 * std::sin(t); })));
  EXPECT_EQ(report.variables[0].after, 30.5);
  EXPECT_TRUE(report.variables[0].at_bound);
  EXPECT_EQ(report.variables[0].high, 30.5);
  EXPECT_NEAR(report.variables[1].after, 10, 1e-9);
}

TEST(Fit, ManyStartsFindWhatOneDoesNot) {
  // From a crank of 14.9 the search has to cross linkages that do not turn on its way to 5.
  const SixBar bar;
  const MeasuredTable exact =
      measured_motion(bar.truth, positions(45, -300, 30), {"link4.angle", "slider.x"});
  std::ostringstream text;
  text << std::ifstream(HIGHERPAIR_SOURCE_DIR "/profiles/sixbar_measured.toml").rdbuf();
  std::string profile = text.str();
  const std::pair<const char*, const char*> bounds[] = {
      {"A.0\" }", "A.0\", min = 5, max = 17 }"},  {"B.0\" }", "B.0\", min = 12, max = 25 }"},
      {"F.0\" }", "F.0\", min = 12, max = 25 }"}, {"E.0\" }", "E.0\", min = 2, max = 14 }"},
      {"G.0\" }", "G.0\", min = 20, max = 35 }"}, {"rail.1\" }", "rail.1\", min = 10, max = 30 }"}};
  for (const auto& [from, to] : bounds) profile.replace(profile.find(from), std::string(from).size(), to);
  FitSettings one_thread;
  one_thread.threads = 1;
  const FitReport report = fitted(model_of(profile), exact, one_thread);
  EXPECT_GT(report.starts, 1);
  for (std::size_t i = 0; i < kTruth.size(); ++i) EXPECT_NEAR(report.variables[i].after, kTruth[i], 1e-7);
  FitSettings threads;
  threads.threads = 3;
  EXPECT_EQ(fitted(model_of(profile), exact, threads).text, report.text);
}

TEST(Fit, UnitsOfTheHeaderAreConverted) {
  const FitReport report = fitted(
      model_of(kCamFit),
      table_of(lift_table("driver,follower.y[m]", [](double t) { return 0.0275 + 0.008 * std::sin(t); })));
  EXPECT_NEAR(report.variables[0].after, 27.5, 1e-9);
  EXPECT_EQ(report.columns[0].unit, "mm");
}

TEST(Fit, ValuesInAnotherUnitAreRecognised) {
  EXPECT_TRUE(contains(
      message_of(kCamFit,
                 lift_table("driver,follower.y", [](double t) { return 0.001 * eccentric_lift(t); })),
      "measured.csv:1:8: follower.y: these values are far from the motion of the profile in mm, "
      "but near it if they are in m (a factor of 1000); write follower.y[m] in the header"));
  EXPECT_TRUE(contains(
      message_of(kCamFit, lift_table("driver,follower.y", [](double t) { return eccentric_lift(t) / 25.4; })),
      "near it if they are in in (a factor of 25.4)"));
  std::string radians = "driver,follower.y\n";
  for (int k = 0; k < 40; ++k) radians += fmt::format("{},{}\n", k * 0.15, eccentric_lift(k * 0.15));
  EXPECT_TRUE(contains(
      message_of(kCamFit, radians),
      "driver: these values are far from the motion of the profile in deg, but near it if they are in "
      "rad (a factor of 57.2958)"));
  // An explicit unit is accepted without a note.
  EXPECT_EQ(message_of(kCamFit,
                       lift_table("driver,follower.y[mm]", [](double t) { return 0.5 * eccentric_lift(t); })),
            "");
}

TEST(Fit, ATableOfAnglesThatIsWhollyInRadiansIsRecognised) {
  const Model model = shipped_model("four_bar", {R"(design.variables.a={path="bodies.crank.points.A.0"})"});
  const Motion motion = model.run().value();
  const auto driver = motion.column("driver"), angle = motion.column("rocker.angle");
  std::string text = "driver,rocker.angle\n";
  for (std::size_t k = 0; k < motion.size(); k += 12) {
    text += fmt::format("{},{}\n", driver[k] * kPi / 180, angle[k] * kPi / 180);
  }
  const auto report = fit(model, table_of(text), {});
  ASSERT_FALSE(report);
  EXPECT_TRUE(contains_all(to_string(report.error()),
                           {"write driver[rad] in the header", "write rocker.angle[rad] in the header"}));
}

// The eccentricity that it takes is far beyond its bounds.
TEST(Fit, WhatIsFartherFromItThanFromItsMeanIsNotGood) {
  const Model model =
      model_of(std::string(kCam) +
               "[design.variables]\ne = { path = \"bodies.cam.curves.disc.center.0\", min = 9, max = 11 }\n");
  const FitReport report = fitted(
      model,
      table_of(lift_table("driver[deg],follower.y[mm]", [](double t) { return 30 - 10 * std::sin(t); })));
  EXPECT_NEAR(report.columns[0].explained, 1 - 19.0 * 19.0 / 100, 1e-6);
  EXPECT_TRUE(report.columns[0].unexplained);
  EXPECT_FALSE(report.good);
}

TEST(Fit, WhatIsMeasuredWronglyIsSaidWithItsPlace) {
  EXPECT_TRUE(contains(message_of(kCamFit, "driver,folower.y\n0,30\n"),
                       "measured.csv:1:8: \"folower.y\": there is no "
                       "such column; did you mean `follower.y`"));
  EXPECT_TRUE(contains(message_of(kCamFit, "angle,follower.y\n0,30\n"),
                       "measured.csv: has no column `driver` and no `time`, which says where each row is"));
  EXPECT_TRUE(
      contains(message_of(kCamFit, "driver\n0\n1\n"), "has no column with values that a motion could be"));
  EXPECT_TRUE(
      contains(message_of(kCamFit, "driver,follower.y\n0,30\n10,31\n"),
               "measured.csv: 2 measured values in 2 rows cannot say what 3 numbers are: measure more, or "
               "look for fewer"));
  EXPECT_TRUE(contains(message_of(kCamFit, "driver,follower.y\n0,30\n,31\n3,4\n5,6\n"),
                       "measured.csv:3:1: driver is missing: nothing says where this row is"));
  EXPECT_TRUE(contains(message_of(kCamFit, "driver,follower.y\n0,30\n1,x\n3,4\n5,6\n"),
                       "measured.csv:3:3: `x` is no number"));
  EXPECT_TRUE(contains(message_of(kCamFit, "driver,follower.y[deg]\n0,30\n1,2\n3,4\n5,6\n"),
                       "follower.y[deg]: deg is an angle, expected a length"));
  EXPECT_TRUE(contains(message_of(kCamFit, "driver,follower.y\n0,30\n1,2,3\n"),
                       "measured.csv:3:1: expected 2 fields, found 3"));
  EXPECT_TRUE(contains(message_of(kCamFit, "driver,follower.y\n0,30\n0,1e60\n1,1\n2,2\n"),
                       "follower.y: 1e+60 is too large"));
  MeasuredTable table;
  table.source = "lab";
  table.columns = {{"driver", "deg", {0, 10, 20, 30}, {}, {}},
                   {"follower.y", "mm", {30, std::numeric_limits<double>::infinity(), 31, 32}, {}, {}}};
  EXPECT_EQ(to_string(fit(model_of(kCamFit), table).error()), "lab: follower.y: inf is too large");
}

TEST(Fit, AProfileThatAsksForNothingOrTooMuchIsRefused) {
  const std::string lift = lift_table("driver,follower.y", eccentric_lift);
  EXPECT_TRUE(
      contains(message_of(kCam, lift), "no [design.variables]: they say which numbers are to be found"));
  EXPECT_TRUE(contains(message_of(kCamFit + "idle = { path = \"bodies.follower.pose.y\" }\n", lift),
                       "design.variables.idle: changes none of the measured columns"));
  EXPECT_TRUE(contains(message_of(kCamFit + "[[fit.columns]]\ncolumn = \"folower.y\"\noffset = true\n", lift),
                       "fit.columns.0.column: `folower.y` is no measured column; did you mean `follower.y`"));
  EXPECT_TRUE(contains(message_of(kCamFit + "[[fit.columns]]\ncolumn = \"driver\"\ndeviation = 1\n", lift),
                       "driver says where each row is and counts as exact"));
  EXPECT_TRUE(contains(message_of(kCamFit + "[fit]\nuse = [\"follower.vy\"]\n", lift),
                       "no column to be fitted is `follower.vy`; did you mean `follower.y`"));
  EXPECT_TRUE(
      contains(message_of(kCamFit + "[[fit.frames]]\npoint = \"follower.P\"\nfree = [\"turn\"]\n", lift),
               "fit.frames.0: both follower.P.x and follower.P.y have to be measured"));
  FitSettings settings;
  settings.offsets = {"folower.y"};
  EXPECT_TRUE(contains(message_of(kCamFit, lift, settings),
                       "setting offset folower.y: `folower.y` is no measured column"));
  settings = {};
  settings.confidence = 1;
  EXPECT_TRUE(contains(message_of(kCamFit, lift, settings), "confidence = 1: must be between 0 and 1"));
  const Model built = Model::from(model_of(kCamFit).mechanism()).value();
  EXPECT_TRUE(contains(to_string(fit(built, table_of(lift)).error()), "was built and has no profile"));
}

TEST(Fit, AsManyValuesAsNumbersLeaveNoIntervals) {
  const FitReport report = fitted(model_of(kCamFit), table_of("driver,follower.y\n0,30\n90,39\n180,30\n"));
  EXPECT_NEAR(report.variables[0].after, 30, 1e-9);
  EXPECT_NEAR(report.variables[1].after, 9, 1e-9);
  EXPECT_TRUE(std::isnan(report.variables[0].half));
  EXPECT_TRUE(a_line_contains(report.notes, "as many values as numbers"));
}

TEST(Fit, AColumnThatNothingChangesHasNoPart) {
  std::string text = "driver,follower.y,follower.x\n";
  for (int k = 0; k < 24; ++k)
    text += fmt::format("{},{},0\n", 15 * k, 30 + 8 * std::sin(15 * k * kPi / 180));
  const FitReport report = fitted(model_of(kCamFit), table_of(text));
  EXPECT_NEAR(report.variables[1].after, 8, 1e-9);
  EXPECT_TRUE(a_line_contains(report.notes, "follower.x is the same whatever the numbers"));
}

TEST(Fit, ARaisedFlagStopsItWithTheBestSoFar) {
  const std::atomic<bool> stop{true};
  FitSettings settings;
  settings.stop = &stop;
  const FitReport report =
      fitted(model_of(kCamFit), table_of(lift_table("driver,follower.y", eccentric_lift)), settings);
  EXPECT_EQ(report.end, FitEnd::kStopped);
  EXPECT_FALSE(report.good);
  EXPECT_FALSE(report.text.empty());
}

TEST(Fit, SaysHowFarItIs) {
  std::vector<FitProgress> seen;
  FitSettings settings;
  settings.starts = 3;
  settings.threads = 2;
  settings.progress = [&](const FitProgress& progress) { seen.push_back(progress); };
  const FitReport report =
      fitted(model_of(kCamFit), table_of(lift_table("driver,follower.y", eccentric_lift)), settings);
  ASSERT_GE(seen.size(), 4U);  // searches, and at least one round of noise
  EXPECT_EQ(seen[0].starts, 1);
  EXPECT_EQ(seen[2].starts, 3);
  EXPECT_EQ(seen[2].all_starts, 3);
  EXPECT_EQ(seen[2].rounds, 0);
  EXPECT_LE(seen[2].off, seen[0].off);
  EXPECT_GE(seen.back().rounds, 1);
  EXPECT_TRUE(report.good);
}

TEST(Fit, AngleVariablesAndForcesAreFittedAsWell) {
  // The driving effort against a load on the follower is F e cos θ, rotated with the slide.
  const std::string profile = std::string(kCam) + R"(
samples = 37
[loads]
push = { body = "follower", point = "P", force = [0, -12] }
[design.variables]
e = { path = "bodies.cam.curves.disc.center.0" }
f = { path = "loads.push.force.1" }
)";
  std::string text = "driver,follower.y,driver.effort\n";
  for (int k = 0; k < 24; ++k) {
    const double t = 15 * k * kPi / 180;
    text += fmt::format("{},{},{}\n", 15 * k, 30 + 9 * std::sin(t), 14 * 9 * std::cos(t));
  }
  // `driver.effort` is a result of the run, not its position.
  const FitReport report = fitted(model_of(profile), table_of(text));
  EXPECT_NEAR(report.variables[0].after, 9, 1e-8);
  EXPECT_NEAR(report.variables[1].after, -14, 1e-7);
  EXPECT_EQ(report.variables[1].unit, "N");
}

}  // namespace
}  // namespace higherpair

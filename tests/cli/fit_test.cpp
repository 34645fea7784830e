// The command `fit`: files, exit codes, what it prints.
#include "cli/program_testing.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace higherpair::testing {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

class FitCommand : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    copy_profiles({"sixbar_measured"});
    std::filesystem::copy_file(shipped_profile("sixbar_measured.csv"), folder_ / "sixbar_measured.csv",
                               std::filesystem::copy_options::overwrite_existing);
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  [[nodiscard]] std::string read(const std::string& name) const { return read_file(folder_ / name); }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
};

const std::string kFit = "fit sixbar_measured.toml sixbar_measured.csv ";

TEST_F(FitCommand, WritesTheFittedProfileAndSaysWhatItFound) {
  const Outcome outcome = run_program(kFit + "-o fitted.toml --json fit.json --csv residuals.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Six-bar with slider, from its measured motion"));
  EXPECT_THAT(outcome.out, HasSubstr("crank"));
  EXPECT_THAT(outcome.out, HasSubstr("offset of link4.angle"));
  EXPECT_THAT(outcome.out, HasSubstr("outliers, more than 4.685 deviations off:\n  line 32: slider.x = "));
  EXPECT_THAT(read("fitted.toml"), HasSubstr("# The six-bar of sixbar_slider.toml as it was built"));
  EXPECT_EQ(run_program("analyze fitted.toml --csv -").code, 0);
  const Json json = Json::parse(read("fit.json"));
  EXPECT_TRUE(json.at("good").get<bool>());
  EXPECT_EQ(json.at("end"), "converged");
  EXPECT_EQ(json.at("variables").size(), 6U);
  EXPECT_NEAR(json.at("variables")[0].at("after").get<double>(), 15, 0.05);
  EXPECT_EQ(json.at("variables")[0].at("unit"), "cm");
  EXPECT_EQ(json.at("outliers").size(), 3U);
  EXPECT_EQ(json.at("search").at("loss"), "huber");
  EXPECT_EQ(json.at("correlation").size(), 7U);
  const std::string csv = read("residuals.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "line[1],driver[deg],column,unit,measured[1],fitted[1],residual[1],weight[1],outlier[1]");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 97 - 5);
}

TEST_F(FitCommand, WritesWhatWasSetIntoTheProfile) {
  const Outcome outcome =
      run_program(kFit + "-o fitted.toml --json - --set fit.loss=tukey --set title=Other");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out).at("search").at("loss"), "tukey");
  EXPECT_THAT(read("fitted.toml"), HasSubstr("\"tukey\""));
  EXPECT_THAT(read("fitted.toml"), HasSubstr("title = \"Other\"\n"));
  const Outcome curve = run_program("fit sixbar_measured.csv --curve circle --set title=Other");
  EXPECT_EQ(curve.code, 2);
  EXPECT_THAT(curve.err, HasSubstr("--set: means nothing with --curve"));
}

TEST_F(FitCommand, OptionsTakeThePlaceOfTheProfile) {
  const Outcome outcome =
      run_program(kFit + "-o f.toml --json - --loss tukey --confidence 0.5 --seed 4 --threads 1");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json.at("search").at("loss"), "tukey");
  EXPECT_EQ(json.at("confidence"), 0.5);
  const Outcome angle = run_program(kFit + "-o f.toml --columns 'link4.*'");
  EXPECT_EQ(angle.code, 2);
  EXPECT_THAT(angle.err, HasSubstr("design.variables.fork: changes none of the measured columns"));
  const Outcome offset = run_program(kFit + "-o f.toml --offset driver,slider.x --quiet");
  EXPECT_THAT(offset.out, HasSubstr("offset of driver"));
}

TEST_F(FitCommand, WhatIsNotDeterminedIsExitCode4AndWritten) {
  write("t.toml", read("sixbar_measured.toml") +
                      "\n[design.variables.height]\npath = \"bodies.ground.points.rail.0\"\n");
  const Outcome outcome = run_program("fit t.toml sixbar_measured.csv -o f.toml");
  EXPECT_EQ(outcome.code, 2);  // the position of a rail's point along the rail has no effect
  std::string text = read("sixbar_measured.toml");
  text = text.substr(0, text.find("[design.variables]")) +
         "[design.variables]\nframe = { path = \"bodies.ground.points.F.0\" }\n"
         "crank = { path = \"bodies.link2.points.A.0\" }\ncoupler = { path = \"bodies.link3.points.B.0\" }\n"
         "rocker = { path = \"bodies.link4.points.F.0\" }\n";
  write("r.toml", text);
  const Outcome ratios =
      run_program("fit r.toml sixbar_measured.csv -o r2.toml --columns link4.angle --offset link4.angle");
  EXPECT_EQ(ratios.code, 4) << ratios.err;
  EXPECT_THAT(ratios.out, HasSubstr("cannot be told apart by these columns: only their ratios"));
  EXPECT_TRUE(exists("r2.toml"));
}

TEST_F(FitCommand, MistakesAreExitCode2AndNothingIsWritten) {
  EXPECT_THAT(run_program("fit sixbar_measured.toml -o f.toml").err,
              HasSubstr("the table of what was measured is missing"));
  EXPECT_THAT(run_program(kFit).err, HasSubstr("--output: is missing: where the fitted profile goes"));
  EXPECT_THAT(run_program(kFit + "-o sixbar_measured.csv").err, HasSubstr("MEASURED"));
  EXPECT_THAT(run_program(kFit + "-o sixbar_measured.toml").err, HasSubstr("FILE"));
  EXPECT_THAT(run_program(kFit + "-o f.toml --loss mean").err, HasSubstr("mean"));
  EXPECT_THAT(run_program(kFit + "-o f.toml --confidence 95").err, HasSubstr("is no share between 0 and 1"));
  EXPECT_THAT(run_program("fit sixbar_measured.toml none.csv -o f.toml").err,
              HasSubstr("none.csv: cannot be opened"));
  write("bad.csv", "driver,slidr.x\n1,2\n");
  const Outcome outcome = run_program("fit sixbar_measured.toml bad.csv -o f.toml");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err,
              HasSubstr("bad.csv:1:8: \"slidr.x\": there is no such column; did you mean `slider.x`"));
  EXPECT_FALSE(exists("f.toml"));
}

TEST_F(FitCommand, ADesignStillNeedsObjectivesAndBounds) {
  const Outcome outcome = run_program("design sixbar_measured.toml -o f.toml");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("design.objectives is missing: expected what is to be small"));
  EXPECT_THAT(outcome.err, HasSubstr("design.variables.crank.min is missing: expected the smallest value"));
}

TEST_F(FitCommand, FitsACircleToPoints) {
  std::string points = "x[in],y[in]\n";
  for (int k = 0; k < 20; ++k)
    points += fmt::format("{},{}\n", 1e3 + 2 * std::cos(0.2 * k), 5 + 2 * std::sin(0.2 * k));
  write("points.csv", points);
  const Outcome outcome = run_program("fit points.csv --curve circle -o c.toml --json c.json --csv d.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("radius"));
  const Json json = Json::parse(read("c.json"));
  EXPECT_EQ(json.at("type"), "circle");
  EXPECT_EQ(json.at("unit"), "in");
  EXPECT_NEAR(json.at("numbers")[0].at("value").get<double>(), 1e3, 1e-9);
  EXPECT_NEAR(json.at("numbers")[2].at("value").get<double>(), 2, 1e-9);
  EXPECT_THAT(read("c.toml"), HasSubstr("curves.fitted = { type = \"circle\", center = ["));
  EXPECT_THAT(read("d.csv"), HasSubstr("line[1],x[in],y[in],distance[in]"));
  // The curve that it writes can be read in a profile.
  write(
      "p.toml",
      "[units]\nlength = \"in\"\n[bodies.ground]\npoints.O = [0, 0]\n[bodies.cam]\npoints.O = [0, 0]\n" +
          read("c.toml") +
          "[joints.O]\ntype = \"revolute\"\nbetween = [\"ground.O\", \"cam.O\"]\n[driver]\njoint = \"O\"\n");
  EXPECT_EQ(run_program("mobility p.toml").code, 0);
}

TEST_F(FitCommand, FitsEveryKindOfCurve) {
  std::string line, parabola, hyperbola, ellipse;
  for (int k = -10; k <= 10; ++k) {
    const double t = 0.1 * k;
    line += fmt::format("{},{}\n", t, 1 + 0.5 * t);
    parabola += fmt::format("{} {}\n", t, 2 * t * t);
    hyperbola += fmt::format("{};{}\n", 3 * std::cosh(t), 2 * std::sinh(t));
    ellipse += fmt::format("{}\t{}\n", 3 * std::cos(3 * t), 2 * std::sin(3 * t));
  }
  const auto fitted = [&](const std::string& curve, const std::string& points) {
    write("p.csv", points);
    const Outcome outcome = run_program("fit p.csv --curve " + curve + " -o -");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  };
  EXPECT_THAT(fitted("line", line), HasSubstr("type = \"line\""));
  EXPECT_THAT(fitted("parabola", parabola), HasSubstr("type = \"parabola\""));
  EXPECT_THAT(fitted("hyperbola", hyperbola), HasSubstr("type = \"hyperbola\""));
  EXPECT_THAT(fitted("ellipse", ellipse), HasSubstr("type = \"ellipse\""));
  EXPECT_THAT(fitted("conic", hyperbola), HasSubstr("type = \"hyperbola\""));
}

TEST_F(FitCommand, PointsThatHaveNoSuchCurveAreSaid) {
  const auto refused = [&](const std::string& text, const std::string& curve) {
    write("p.csv", text);
    const Outcome outcome = run_program("fit p.csv --curve " + curve);
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  EXPECT_THAT(
      refused("x,y\n0,0\n1,1\n", "circle"),
      HasSubstr("p.csv: no circle can be fitted: the 2 points are fewer than the curve has parameters: at "
                "least 3 are needed"));
  EXPECT_THAT(refused("0,0\n1,1\n2,2\n", "circle"), HasSubstr("the 3 points lie on one line"));
  EXPECT_THAT(refused("a,b\n0,0\n1,1\n2,2\n", "circle"), HasSubstr("p.csv: needs a column `x`"));
  EXPECT_THAT(refused("x[mm],y[in]\n0,0\n", "line"), HasSubstr("p.csv:1:7: x is in mm and y in in"));
  EXPECT_THAT(refused("x[deg],y[deg]\n0,0\n", "line"),
              HasSubstr("p.csv:1:1: x[deg]: expected a unit of length"));
  EXPECT_THAT(refused("A.x,A.y,B.x,B.y\n0,0,1,1\n", "line"),
              HasSubstr("needs a column `x`: several names end in it"));
  EXPECT_THAT(refused("x,y\n0,0\n1,q\n", "line"), HasSubstr("p.csv:3:3: `q` is no number"));
  EXPECT_THAT(run_program("fit p.csv --curve oval").err, HasSubstr("oval"));
  EXPECT_THAT(run_program("fit p.csv other.csv --curve line").err, HasSubstr("no second file is read"));
  EXPECT_THAT(run_program("fit p.csv --curve line --loss huber").err,
              HasSubstr("--loss: means nothing with --curve"));
}

}  // namespace
}  // namespace higherpair::testing

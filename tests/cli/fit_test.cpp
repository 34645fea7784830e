// The command `fit`: files, exit codes, what it prints.
#include "cli/program_testing.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace higherpair::testing {
namespace {

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
  EXPECT_TRUE(contains(outcome.out, "Six-bar with slider, from its measured motion"));
  EXPECT_TRUE(contains(outcome.out, "crank"));
  EXPECT_TRUE(contains(outcome.out, "offset of link4.angle"));
  EXPECT_TRUE(contains(outcome.out, "outliers, more than 4.685 deviations off:\n  line 32: slider.x = "));
  EXPECT_TRUE(contains(read("fitted.toml"), "# The six-bar of sixbar_slider.toml as it was built"));
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
  EXPECT_TRUE(contains(read("fitted.toml"), "\"tukey\""));
  EXPECT_TRUE(contains(read("fitted.toml"), "title = \"Other\"\n"));
  const Outcome curve = run_program("fit sixbar_measured.csv --curve circle --set title=Other");
  EXPECT_EQ(curve.code, 2);
  EXPECT_TRUE(contains(curve.err, "--set: means nothing with --curve"));
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
  EXPECT_TRUE(contains(angle.err, "design.variables.fork: changes none of the measured columns"));
  const Outcome offset = run_program(kFit + "-o f.toml --offset driver,slider.x --quiet");
  EXPECT_TRUE(contains(offset.out, "offset of driver"));
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
  EXPECT_TRUE(contains(ratios.out, "cannot be told apart by these columns: only their ratios"));
  EXPECT_TRUE(exists("r2.toml"));
}

TEST_F(FitCommand, MistakesAreExitCode2AndNothingIsWritten) {
  EXPECT_TRUE(contains(run_program("fit sixbar_measured.toml -o f.toml").err,
                       "the table of what was measured is missing"));
  EXPECT_TRUE(contains(run_program(kFit).err, "--output: is missing: where the fitted profile goes"));
  EXPECT_TRUE(contains(run_program(kFit + "-o sixbar_measured.csv").err, "MEASURED"));
  EXPECT_TRUE(contains(run_program(kFit + "-o sixbar_measured.toml").err, "FILE"));
  EXPECT_TRUE(contains(run_program(kFit + "-o f.toml --loss mean").err, "mean"));
  EXPECT_TRUE(contains(run_program(kFit + "-o f.toml --confidence 95").err, "is no share between 0 and 1"));
  EXPECT_TRUE(
      contains(run_program("fit sixbar_measured.toml none.csv -o f.toml").err, "none.csv: cannot be opened"));
  write("bad.csv", "driver,slidr.x\n1,2\n");
  const Outcome outcome = run_program("fit sixbar_measured.toml bad.csv -o f.toml");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(
      contains(outcome.err, "bad.csv:1:8: \"slidr.x\": there is no such column; did you mean `slider.x`"));
  EXPECT_FALSE(exists("f.toml"));
}

TEST_F(FitCommand, ADesignStillNeedsObjectivesAndBounds) {
  const Outcome outcome = run_program("design sixbar_measured.toml -o f.toml");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err, "design.objectives is missing: expected what is to be small"));
  EXPECT_TRUE(contains(outcome.err, "design.variables.crank.min is missing: expected the smallest value"));
}

TEST_F(FitCommand, FitsACircleToPoints) {
  std::string points = "x[in],y[in]\n";
  for (int k = 0; k < 20; ++k)
    points += fmt::format("{},{}\n", 1e3 + 2 * std::cos(0.2 * k), 5 + 2 * std::sin(0.2 * k));
  write("points.csv", points);
  const Outcome outcome = run_program("fit points.csv --curve circle -o c.toml --json c.json --csv d.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "radius"));
  const Json json = Json::parse(read("c.json"));
  EXPECT_EQ(json.at("type"), "circle");
  EXPECT_EQ(json.at("unit"), "in");
  EXPECT_NEAR(json.at("numbers")[0].at("value").get<double>(), 1e3, 1e-9);
  EXPECT_NEAR(json.at("numbers")[2].at("value").get<double>(), 2, 1e-9);
  EXPECT_TRUE(contains(read("c.toml"), "curves.fitted = { type = \"circle\", center = ["));
  EXPECT_TRUE(contains(read("d.csv"), "line[1],x[in],y[in],distance[in]"));
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
  EXPECT_TRUE(contains(fitted("line", line), "type = \"line\""));
  EXPECT_TRUE(contains(fitted("parabola", parabola), "type = \"parabola\""));
  EXPECT_TRUE(contains(fitted("hyperbola", hyperbola), "type = \"hyperbola\""));
  EXPECT_TRUE(contains(fitted("ellipse", ellipse), "type = \"ellipse\""));
  EXPECT_TRUE(contains(fitted("conic", hyperbola), "type = \"hyperbola\""));
}

TEST_F(FitCommand, PointsThatHaveNoSuchCurveAreSaid) {
  const auto refused = [&](const std::string& text, const std::string& curve) {
    write("p.csv", text);
    const Outcome outcome = run_program("fit p.csv --curve " + curve);
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  EXPECT_TRUE(
      contains(refused("x,y\n0,0\n1,1\n", "circle"),
               "p.csv: no circle can be fitted: the 2 points are fewer than the curve has parameters: at "
               "least 3 are needed"));
  EXPECT_TRUE(contains(refused("0,0\n1,1\n2,2\n", "circle"), "the 3 points lie on one line"));
  EXPECT_TRUE(contains(refused("a,b\n0,0\n1,1\n2,2\n", "circle"), "p.csv: needs a column `x`"));
  EXPECT_TRUE(contains(refused("x[mm],y[in]\n0,0\n", "line"), "p.csv:1:7: x is in mm and y in in"));
  EXPECT_TRUE(
      contains(refused("x[deg],y[deg]\n0,0\n", "line"), "p.csv:1:1: x[deg]: expected a unit of length"));
  EXPECT_TRUE(
      contains(refused("A.x,A.y,B.x,B.y\n0,0,1,1\n", "line"), "needs a column `x`: several names end in it"));
  EXPECT_TRUE(contains(refused("x,y\n0,0\n1,q\n", "line"), "p.csv:3:3: `q` is no number"));
  EXPECT_TRUE(contains(run_program("fit p.csv --curve oval").err, "oval"));
  EXPECT_TRUE(contains(run_program("fit p.csv other.csv --curve line").err, "no second file is read"));
  EXPECT_TRUE(
      contains(run_program("fit p.csv --curve line --loss huber").err, "--loss: means nothing with --curve"));
}

}  // namespace
}  // namespace higherpair::testing

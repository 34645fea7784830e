// [fit] of a profile, and the tables that it is fitted to.
#include "higherpair/io/measured_table.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "higherpair/io/tasks.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using ::testing::ElementsAre;
using testing::lines_are;

const std::string kFittedCrank = R"([bodies.ground]
points.O = [0, 0]
[bodies.crank]
points.O = [0, 0]
points.A = [20, 0]
[joints.O]
type = "revolute"
between = ["ground.O", "crank.O"]
[driver]
joint = "O"
)";

FitTask task_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return *read_profile_text(kFittedCrank + text, "test.toml", overrides).value().fit;
}

std::string mistake_in(const std::string& text) {
  const auto profile = read_profile_text(kFittedCrank + text, "test.toml", {});
  return profile ? "" : to_string(profile.error().front());
}

TEST(FitTask, IsReadWithAllItsKeys) {
  const FitTask task = task_of(R"([fit]
loss = "tukey"
confidence = 0.9
starts = 7
seed = 3
use = ["crank.*"]
[[fit.columns]]
column = "crank.A.x"
deviation = 0.05
weight = 2
offset = true
[[fit.frames]]
point = "crank.A"
free = ["turn", "scale"]
)");
  EXPECT_EQ(task.loss, FitLoss::kTukey);
  EXPECT_EQ(name_of(task.loss), "tukey");
  EXPECT_EQ(task.confidence, 0.9);
  EXPECT_EQ(task.starts, 7);
  EXPECT_EQ(task.seed, 3U);
  EXPECT_TRUE(lines_are(task.use, {"crank.*"}));
  ASSERT_EQ(task.columns.size(), 1U);
  EXPECT_EQ(task.columns[0].deviation, 0.05);
  EXPECT_EQ(task.columns[0].weight, 2);
  EXPECT_TRUE(task.columns[0].offset);
  EXPECT_EQ(task.columns[0].place.line, 17);
  ASSERT_EQ(task.frames.size(), 1U);
  EXPECT_FALSE(task.frames[0].position);
  EXPECT_TRUE(task.frames[0].turn && task.frames[0].scale);
}

TEST(FitTask, HoldsWithoutATableAndWithOverrides) {
  EXPECT_EQ(read_profile_text(kFittedCrank, "test.toml").value().fit, nullptr);
  EXPECT_EQ(task_of("", {"fit.loss=huber"}).loss, FitLoss::kHuber);
  EXPECT_EQ(task_of("[fit]\nseed = 5000000000").seed, 5'000'000'000U);
}

TEST(FitTask, DeviationsMayHaveTheirOwnUnit) {
  const auto deviation = [](const std::string& column, const std::string& text) {
    return task_of("[[fit.columns]]\ncolumn = \"" + column + "\"\ndeviation = \"" + text + "\"\n")
        .columns[0]
        .deviation;
  };
  EXPECT_EQ(deviation("crank.A.x", "50 um"), 0.05);
  EXPECT_EQ(deviation("*.angle", "0.001 rev"), 0.36);
  EXPECT_EQ(deviation("crank.omega", "1 rpm"), 6);
}

struct WrongFit {
  const char* text;
  const char* message;
};

const WrongFit kWrongFits[] = {
    WrongFit{"fit = 3", "fit"},
    WrongFit{"[fit]\nloss = \"hubert\"", "did you mean `huber`"},
    WrongFit{"[fit]\nconfidence = 95", "fit.confidence = 95: expected a share between 0 and 1, such as 0.95"},
    WrongFit{"[fit]\nstarts = 0", "fit.starts = 0: expected an integer from 1 to 1000000000"},
    WrongFit{"[fit]\nseed = -1", "fit.seed = -1: must be >= 0"},
    WrongFit{"[fit]\nlos = \"huber\"", "fit.los"},
    WrongFit{"[fit]\nuse = \"crank.x\"", "expected a list of names or globs of columns"},
    WrongFit{"[fit]\ncolumns = 3", "expected a list of tables, [[fit.columns]]"},
    WrongFit{"[[fit.columns]]\noffset = true", "fit.columns.0.column is missing"},
    WrongFit{"[[fit.columns]]\ncolumn = \"crank.x\"\ndeviation = 0",
             "fit.columns.0.deviation = 0: must be > 0"},
    WrongFit{"[[fit.columns]]\ncolumn = \"crank.x\"\ndeviation = \"1 deg\"",
             "fit.columns.0.deviation = \"1 deg\": deg is an angle, expected a length, such as mm"},
    WrongFit{"[[fit.columns]]\ncolumn = \"crank.*\"\ndeviation = \"1 mm\"",
             "the unit of `crank.*` is not known here: write a plain number, in the unit of tables"},
    WrongFit{"[fit]\nconfidence = \"95 mm\"", "this has no unit: write a plain number"},
    WrongFit{"[[fit.columns]]\ncolumn = \"crank.x\"\nweight = -1", "fit.columns.0.weight = -1: must be > 0"},
    WrongFit{"[[fit.frames]]\npoint = \"crank.B\"\nfree = [\"turn\"]",
             "body `crank` has no point `B`; did you mean `O` or `A`?"},
    WrongFit{"[[fit.frames]]\npoint = \"ground.O\"\nfree = [\"turn\"]", "a point of ground does not move"},
    WrongFit{"[[fit.frames]]\npoint = \"crank.A\"", "fit.frames.0.free is missing"},
    WrongFit{"[[fit.frames]]\npoint = \"crank.A\"\nfree = []", "expected a list of \"position\", \"turn\""},
    WrongFit{"[[fit.frames]]\npoint = \"crank.A\"\nfree = [\"turm\"]", "did you mean `turn`"},
    WrongFit{"[[fit.frames]]\npoint = \"crank.A\"\nfree = [\"turn\"]\n[[fit.frames]]\npoint = "
             "\"crank.A\"\nfree = "
             "[\"turn\"]",
             "this point has a frame already"},
    WrongFit{"[fit.variables]\nr = 3", "the numbers to be found are the variables of [design]"}};

TEST(WrongFits, AreSaidWithPlaceAndRule) {
  for (const WrongFit& wrong : kWrongFits) {
    SCOPED_TRACE(wrong.text);
    EXPECT_TRUE(contains(mistake_in(wrong.text), wrong.message));
  }
}

MeasuredTable measured(const std::string& text) {
  return read_measured_text(text, "m.csv").value();
}

std::string refusal(const std::string& text) {
  const auto table = read_measured_text(text, "m.csv");
  return table ? "" : to_string(table.error().diagnostics.front());
}

TEST(MeasuredTable, TakesUnitsMissingValuesAndAnySeparator) {
  for (const char separator : {',', ';', '\t'}) {
    std::string text =
        "\xEF\xBB\xBF# a note\ndriver[deg]|\"slider.x [ mm ]\"|status\r\n\n1|2.5|ok\r\n2||ok\n3|NaN|ok\n";
    std::replace(text.begin(), text.end(), '|', separator);
    const MeasuredTable table = measured(text);
    ASSERT_EQ(table.columns.size(), 3U);
    EXPECT_EQ(table.columns[0].unit, "deg");
    EXPECT_EQ(table.columns[1].name, "slider.x");
    EXPECT_EQ(table.columns[1].unit, "mm");
    EXPECT_EQ(table.columns[1].values[0], 2.5);
    EXPECT_TRUE(std::isnan(table.columns[1].values[1]));
    EXPECT_THAT(table.lines, ElementsAre(4, 5, 6));
    ASSERT_TRUE(table.columns[2].mistake);
    EXPECT_EQ(to_string(*table.columns[2].mistake).find("m.csv:4:"), 0U);
    EXPECT_FALSE(table.columns[1].mistake);
  }
}

TEST(MeasuredTable, SaysWhatIsWrongWithIt) {
  EXPECT_EQ(refusal(""), "m.csv: has no rows below a line that names the columns");
  EXPECT_EQ(refusal("driver,x\n"), "m.csv: has no rows below a line that names the columns");
  EXPECT_TRUE(contains(refusal("1,2\n3,4\n"), "m.csv:1:1: `1`: the first line has to name the columns"));
  EXPECT_TRUE(contains(refusal("driver,x,x\n1,2,3\n"), "m.csv:1:10: `x`: two columns have this name"));
  EXPECT_TRUE(contains(refusal("driver,x[mm\n1,2\n"), "m.csv:1:8: `x[mm`: the unit has no closing bracket"));
  EXPECT_TRUE(contains(refusal("driver,x\n1,2,3\n"), "m.csv:2:1: expected 2 fields, found 3"));
  EXPECT_TRUE(contains(refusal("driver,x\n1,5,2,7\n"), "decimals are written with a point, not a comma"));
  EXPECT_TRUE(contains(refusal(std::string("d\0r\0", 4)), "UTF-16"));
  EXPECT_TRUE(contains(to_string(read_measured_file("/nowhere/m.csv").error()), "cannot be opened"));
  const MeasuredTable comma = measured("driver;x\n1;2,5\n");
  EXPECT_TRUE(contains(comma.columns[1].mistake->message,
                       "`2,5` is no number: a decimal number is written with a point: 2.5"));
}

TEST(MeasuredTable, HasAtMostFiveThousandColumns) {
  std::string head = "driver", row = "1";
  for (int k = 1; k < 5000; ++k) {
    head += fmt::format(",c{}", k);
    row += ",2";
  }
  EXPECT_EQ(measured(fmt::format("{}\n{}\n", head, row)).columns.size(), 5000U);
  EXPECT_EQ(
      refusal(head + ",x\n"),
      "m.csv:1:1: has 5001 columns, and at most 5000 are read: leave out those that are not to be fitted");
  EXPECT_EQ(read_measured_text(head + ",x\n1\n", "m.csv").error().diagnostics.size(), 1U);
  EXPECT_EQ(read_measured_text(std::string(4000, ','), "m.csv").error().diagnostics.size(),
            5U);  // all without a name
}

TEST(MeasuredTable, MayHaveNoHeaderWhereItsColumnsAreKnown) {
  const MeasuredTable table = read_measured_text("1 2\n3 4\n", "p.csv", {"x", "y"}).value();
  EXPECT_EQ(table.columns[1].name, "y");
  EXPECT_EQ(table.columns[1].values[1], 4);
  EXPECT_THAT(table.lines, ElementsAre(1, 2));
  const MeasuredTable blanks = read_measured_text("x;y\n1\u00a0;\u202f2\n", "p.csv").value();
  EXPECT_THAT(blanks.columns[0].values, ElementsAre(1));
  EXPECT_THAT(blanks.columns[1].values, ElementsAre(2));
  EXPECT_EQ(read_measured_text("y,x\n3,4\n", "p.csv", {"x", "y"}).value().columns[0].name, "y");
}

TEST(MeasuredTable, UnitsOfHeadersHaveFactors) {
  EXPECT_NEAR(factor_between("rad", "deg", Units()).value(), 57.29577951308232, 1e-13);
  EXPECT_NEAR(factor_between("in/s", "mm/s", Units()).value(), 25.4, 1e-13);
  EXPECT_NEAR(factor_between("rad/s^2", "deg/s^2", Units()).value(), 57.29577951308232, 1e-13);
  EXPECT_EQ(factor_between("N m", "N*mm", Units()).value(), 1000);
  EXPECT_EQ(factor_between("ms", "s", Units()).value(), 0.001);
  EXPECT_TRUE(contains(factor_between("kg", "mm", Units()).error(), "kg is a mass, expected a length"));
}

}  // namespace
}  // namespace higherpair

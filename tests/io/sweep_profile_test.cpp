// The meaning of [sweep] in a profile, and every message about it.
#include "higherpair/io/tasks.hpp"
#include "io/only_message.hpp"
#include "support/texts.hpp"

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::contains;
using ::testing::ElementsAre;
using testing::kCamProfile;
using testing::lines_are;
using testing::messages;
using testing::Overrides;
using testing::part;
using testing::read;

constexpr const char* kSweep = R"(
[sweep]
method = "random"
count  = 100
[sweep.variables]
r = { path = "bodies.cam.curves.disc.radius", normal = [20, 0.1] }
[sweep.results]
peak = { column = "follower.alpha", of = "maxabs" }
)";

std::string cam(const std::string& sweep = kSweep) {
  return std::string(kCamProfile) + sweep;
}

SweepTask task_of(const Overrides& overrides, const std::string& sweep = kSweep) {
  const Profile profile = read(cam(sweep), overrides);
  return profile.sweep ? *profile.sweep : SweepTask();
}

// The message about a single mistake, without its position.
std::string message(const Overrides& overrides, const std::string& sweep = kSweep) {
  const std::string all = testing::only_message(cam(sweep), overrides);
  const std::size_t at = all.find(": sweep");
  return at == std::string::npos ? all : all.substr(at + 2);
}

TEST(SweepProfiles, AreReadInTheirOrder) {
  const SweepTask task = task_of({}, R"(
[sweep]
method = "sobol"
count = 1e4
seed = 7
variables.r = { path = "bodies.cam.curves.disc.radius", min = 18, max = 22 }
variables.e = { path = ["bodies.cam.curves.disc.center.0", "bodies.ground.points.O1.0"], normal = [10, 0.1], min = 9.5 }
variables.w = { path = "driver.velocity", triangular = [50, 60, 80] }
variables.u = { path = "bodies.follower.mass", uniform = [0.3, 0.5] }
variables.v = { path = "driver.end", values = [90, 180] }
results.peak = { column = "follower.alpha", of = "max", where = true }
results.rest = { column = "follower.angle", of = "at", at = 30 }
counts = true
)");
  const auto& variables = task.plan.variables;
  ASSERT_EQ(variables.size(), 5U);
  EXPECT_EQ(task.plan.method, SweepMethod::kSobol);
  EXPECT_EQ(task.plan.count, 10000);
  EXPECT_EQ(task.plan.seed, 7U);
  EXPECT_EQ(variables[0].name, "r");
  EXPECT_EQ(variables[0].distribution.low, 18);
  EXPECT_EQ(variables[0].distribution.high, 22);
  EXPECT_TRUE(
      lines_are(variables[1].paths, {"bodies.cam.curves.disc.center.0", "bodies.ground.points.O1.0"}));
  EXPECT_TRUE(variables[1].distribution.is_truncated());
  EXPECT_EQ(variables[1].distribution.low, 9.5);
  EXPECT_EQ(variables[2].distribution.mode, 60);
  EXPECT_EQ(variables[3].distribution.kind, DistributionKind::kUniform);
  EXPECT_THAT(variables[4].distribution.values, ElementsAre(90, 180));
  EXPECT_TRUE(lines_are(task.units, {"mm", "mm", "deg/s", "kg", "deg"}));
  ASSERT_EQ(task.results.size(), 2U);
  EXPECT_TRUE(task.results[0].where);
  EXPECT_EQ(task.results[1].measure.of, MeasureKind::kAt);
  EXPECT_EQ(task.results[1].measure.at, 30);
  EXPECT_EQ(task.results[1].measure.path, "sweep.results.rest.column");
  EXPECT_TRUE(task.counts);
}

TEST(SweepProfiles, MayWriteWholeRows) {
  const SweepTask task = task_of({"sweep.rows=[\"follower.*\"]", "sweep.time=true", "sweep.results={}"});
  EXPECT_TRUE(lines_are(task.rows, {"follower.*"}));
  EXPECT_TRUE(task.in_time);
}

TEST(SweepProfiles, MayCorrelateNormalVariables) {
  const std::string two =
      std::string(kSweep) +
      "[sweep.variables.s]\npath = \"bodies.follower.curves.roller.radius\"\nnormal = [15, 0.2]\n";
  const SweepTask by_covariance =
      task_of({"sweep.correlations=[{ between = [\"s\", \"r\"], covariance = 0.012 }]"}, two);
  ASSERT_EQ(by_covariance.plan.correlations.size(), 1U);
  EXPECT_EQ(by_covariance.plan.correlations[0].first, 1U);
  EXPECT_NEAR(by_covariance.plan.correlations[0].coefficient, 0.6, 1e-12);
  const auto says = [&](const std::string& list) { return message({"sweep.correlations=" + list}, two); };
  EXPECT_TRUE(contains(says("[{ between = [\"s\", \"r\"], coefficient = 1 }]"),
                       "must lie between -1 and 1; variables that are the same are one with several paths"));
  EXPECT_TRUE(
      contains(says("[{ between = [\"s\", \"r\"], covariance = 1 }]"), "the product of both deviations"));
  EXPECT_TRUE(contains(says("[{ between = [\"s\", \"q\"], coefficient = 0 }]"),
                       "there is no variable `q`; did you mean `r` or `s`?"));
  EXPECT_TRUE(contains(says("[{ between = [\"s\", \"s\"], coefficient = 0 }]"), "two different variables"));
  EXPECT_TRUE(
      contains(says("[{ between = [\"s\"], coefficient = 0 }]"), "expected the names of two variables"));
  EXPECT_TRUE(contains(says("[{ between = [\"s\", \"r\"] }]"), "coefficient is missing"));
  EXPECT_TRUE(
      contains(says("[{ between = [\"s\", \"r\"], coefficient = 0.1, covariance = 0.1 }]"), "say the same"));
  EXPECT_TRUE(contains(says("[{ between = [\"s\", \"r\"], coefficient = 0.1 }, { between = [\"r\", \"s\"], "
                            "coefficient = 0.2 }]"),
                       "between these two already"));
  EXPECT_TRUE(contains(says("3"), "expected a list of { between"));
  EXPECT_TRUE(contains(message({"sweep.correlations=[{ between = [\"s\", \"r\"], coefficient = 0.1 }]",
                                "sweep.variables.s.min=14"},
                               two),
                       "only variables with `normal`, without `min` and `max`, can be correlated"));
}

TEST(SweepProfiles, ThatContradictThemselvesInCorrelationsAreRefused) {
  const std::string three = std::string(kSweep) + R"(
[sweep.variables.s]
path = "bodies.follower.curves.roller.radius"
normal = [15, 0.2]
[sweep.variables.t]
path = "bodies.ground.points.O2.0"
normal = [80, 0.2]
)";
  EXPECT_TRUE(
      contains(message({"sweep.correlations=[{between=[\"r\",\"s\"],coefficient=0.9},{between=[\"s\",\"t\"],"
                        "coefficient=0.9},"
                        "{between=[\"r\",\"t\"],coefficient=-0.9}]"},
                       three),
               "these contradict each other"));
}

TEST(SweepProfiles, NameWhatDoesNotExist) {
  const auto path = [](const std::string& text) { return message({"sweep.variables.r.path=" + text}); };
  EXPECT_TRUE(contains(path("bodies.cam.curves.disk.radius"),
                       "there is no `disk` in bodies.cam.curves; did you mean `disc`?"));
  EXPECT_TRUE(contains(path("body.cam"), "there is no `body` in the profile; did you mean `bodies`?"));
  EXPECT_TRUE(contains(path("bodies.cam.curves.disc.center.2"),
                       "there is no `2` in bodies.cam.curves.disc.center; did you mean `0` or `1`?"));
  EXPECT_TRUE(
      contains(path("bodies.cam.curves.disc.center"),
               "this is a list; expected the path of a number, such as bodies.cam.curves.disc.center.0"));
  EXPECT_TRUE(contains(path("sweep.count"), "a sweep cannot vary itself"));
  EXPECT_TRUE(contains(path("[]"), "expected at least one path"));
  EXPECT_TRUE(contains(path("3"), "expected a string, found an integer"));
  EXPECT_TRUE(contains(path("[\"driver.end\", \"driver.end\"]"), "another variable sets this already"));
}

TEST(SweepProfiles, NoteThatANumberWithAUnitOfItsOwnIsVariedInTheUnitOfTheProfile) {
  const auto notes = [](const char* radius) {
    std::string all;
    for (const Diagnostic& note :
         read(cam(), {std::string("bodies.cam.curves.disc.radius=") + radius}).notes) {
      all += to_string(note) + "\n";
    }
    return all;
  };
  EXPECT_TRUE(contains(
      notes("\"2 cm\""),
      "sweep.variables.r.path: the profile gives bodies.cam.curves.disc.radius as \"2 cm\", and plain "
      "values of a sweep are in the profile's `units`: if that is not meant, give them a unit of their "
      "own, too"));
  EXPECT_FALSE(contains(notes("20"), "sweep"));
  const Profile with_units =
      read(cam(), {"bodies.cam.curves.disc.radius=2 cm",
                   "sweep.variables.r={ path = \"bodies.cam.curves.disc.radius\", min = \"1.9 cm\", max = "
                   "\"2.1 cm\" }"});
  for (const Diagnostic& note : with_units.notes) EXPECT_FALSE(contains(to_string(note), "sweep"));
}

TEST(SweepProfiles, HaveValuesWithUnitsOfTheirOwn) {
  const SweepTask task = task_of({}, R"(
[sweep]
method = "random"
count = 9
variables.min = { path = "bodies.cam.curves.disc.radius", min = "1.8 cm", max = 22 }
variables.normal = { path = "bodies.cam.curves.disc.center.0", normal = ["1 cm", "100 um"], min = "9.5 mm" }
variables.also = { path = "bodies.ground.points.O1.0", normal = [10, 0.2] }
variables.triangular = { path = "driver.velocity", triangular = [50, "10 rpm", 80] }
variables.uniform = { path = "bodies.follower.mass", uniform = ["300 g", 0.5] }
variables.values = { path = "driver.end", values = ["0.25 rev", 180] }
results.rest = { column = "follower.angle", of = "at", at = "0.125 rev" }
)");
  const auto& variables = task.plan.variables;
  ASSERT_EQ(variables.size(), 6U);
  EXPECT_EQ(variables[0].distribution.low, 18);
  EXPECT_EQ(variables[0].distribution.high, 22);
  EXPECT_EQ(variables[1].distribution.mean, 10);
  EXPECT_EQ(variables[1].distribution.deviation, 0.1);
  EXPECT_EQ(variables[1].distribution.low, 9.5);
  EXPECT_EQ(variables[3].distribution.mode, 60);
  EXPECT_EQ(variables[4].distribution.low, 0.3);
  EXPECT_THAT(variables[5].distribution.values, ElementsAre(90, 180));
  EXPECT_EQ(task.results[0].measure.at, 45);
  const auto in_time =
      task_of({"sweep.time=true", "sweep.results.peak.of=at", "sweep.results.peak.at=20 ms"});
  EXPECT_EQ(in_time.results[0].measure.at, 0.02);
}

TEST(SweepProfiles, HaveCovariancesWithUnitsOfTheirOwn) {
  const SweepTask task = task_of(
      Overrides{"sweep.variables.e={ path = \"bodies.cam.curves.disc.center.0\", normal = [10, 0.2] }",
                "sweep.correlations=[{ between = [\"r\", \"e\"], covariance = \"1e-4 cm^2\" }]"});
  ASSERT_EQ(task.plan.correlations.size(), 1U);
  EXPECT_NEAR(task.plan.correlations[0].coefficient, 0.01 / (0.1 * 0.2), 1e-15);
  EXPECT_TRUE(contains(
      message({"sweep.variables.e={ path = \"bodies.cam.curves.disc.center.0\", normal = [10, 0.2] }",
               "sweep.correlations=[{ between = [\"r\", \"e\"], covariance = \"1e-4 cm\" }]"}),
      "cm is a length, expected"));
}

TEST(SweepProfiles, SayWhatIsWrongWithValues) {
  const auto with = [](const std::string& keys) {
    return message({"sweep.variables.r={ path = \"bodies.cam.curves.disc.radius\", " + keys + " }"});
  };
  EXPECT_TRUE(contains(message({"sweep.variables.r={ path = \"bodies.cam.curves.disc.radius\" }"}),
                       "expected one of `values`"));
  EXPECT_TRUE(contains(with("values = [1], uniform = [1, 2]"), "expected only one of `values`"));
  EXPECT_TRUE(contains(with("values = []"), "expected at least one"));
  EXPECT_TRUE(contains(with("min = 3"), "max is missing"));
  EXPECT_TRUE(contains(with("min = 3, max = 2"), "must be larger than min = 3"));
  EXPECT_TRUE(contains(with("normal = [20]"), "expected a list of 2 numbers, found 1"));
  EXPECT_TRUE(contains(with("normal = [20, 0]"), "a deviation above 0"));
  EXPECT_TRUE(contains(with("normal = [20, 0.1], min = 22"), "next to nothing of this distribution"));
  EXPECT_TRUE(contains(with("triangular = [1, 3, 2]"), "in this order"));
  EXPECT_TRUE(contains(with("uniform = [2, 1]"), "in this order"));
  EXPECT_TRUE(contains(with("uniform = [1, 2], count = 3"), "belongs to `min` and `max` of a grid"));
  EXPECT_TRUE(
      contains(with("uniform = [1, \"2 deg\"]"),
               "sweep.variables.r.uniform.1 = \"2 deg\": deg is an angle, expected a length, such as mm"));
  EXPECT_TRUE(contains(with("min = \"2 mn\", max = 3"), "sweep.variables.r.min = \"2 mn\": "));
  EXPECT_TRUE(contains(message({"sweep.variables.r={ path = \"driver.samples\", values = [\"3 mm\"] }"}),
                       "values.0 = \"3 mm\": driver.samples has no unit: write a plain number"));
}

TEST(SweepProfiles, SayWhatAMethodNeeds) {
  EXPECT_TRUE(contains(message({"sweep.method=sobel"}),
                       "expected one of grid, list, random, sobol; did you mean `sobol`?"));
  EXPECT_TRUE(contains(message({"sweep.count=0"}), "expected an integer from 1 to 100000000000"));
  EXPECT_TRUE(contains(message({"sweep.count=1000000000000"}), "expected an integer from 1 to 100000000000"));
  EXPECT_TRUE(contains(message({"sweep.seed=-1"}), "must be >= 0"));
  EXPECT_TRUE(
      contains(message({}, "[sweep]\nmethod = \"random\"\ncount = 3\n"), "sweep.variables is missing"));
  EXPECT_TRUE(contains(message({}, "[sweep]\nmethod = \"random\"\ncount = 3\nvariables = {}\n"),
                       "expected at least one variable"));
  const std::string grid = R"(
[sweep]
method = "grid"
variables.r = { path = "bodies.cam.curves.disc.radius", min = 18, max = 22, count = 5 }
)";
  EXPECT_EQ(count_of(task_of({}, grid).plan), 5);
  EXPECT_TRUE(contains(message({"sweep.count=3"}, grid), "a variable of a grid has its own `count`"));
  EXPECT_TRUE(contains(message({"sweep.seed=3"}, grid), "only random and sobol have one"));
  EXPECT_TRUE(contains(message({"sweep.variables.r.count=0"}, grid), "expected an integer from 1 to"));
  EXPECT_TRUE(contains(message({"sweep.variables.s={ path = \"driver.end\", normal = [90, 1] }"}, grid),
                       "a grid takes `values`, or `min`, `max` and `count`"));
  EXPECT_TRUE(
      contains(message({"sweep.correlations=[]"}, grid), "only draws (random, sobol) can be correlated"));
  const std::string list = R"(
[sweep]
method = "list"
variables.r = { path = "bodies.cam.curves.disc.radius", values = [18, 19] }
)";
  EXPECT_EQ(count_of(task_of({}, list).plan), 2);
  EXPECT_TRUE(contains(message({"sweep.variables.s={ path = \"driver.end\", values = [1, 2, 3] }"}, list),
                       "3 values, but r has 2; in a list all variables have equally many"));
  EXPECT_TRUE(contains(message({"sweep.variables.s={ path = \"driver.end\", min = 1, max = 3 }"}, list),
                       "a list takes `values`"));
}

TEST(SweepProfiles, RefuseAGridBeyondAllMeasure) {
  const std::string grid = R"(
[sweep]
method = "grid"
[sweep.variables]
a = { path = "bodies.cam.curves.disc.radius", min = 18, max = 22, count = 10000 }
b = { path = "bodies.cam.curves.disc.center.0", min = 8, max = 12, count = 10000 }
c = { path = "bodies.follower.curves.roller.radius", min = 14, max = 16, count = 10000 }
)";
  EXPECT_EQ(message({}, grid),
            "sweep: this grid has 1000000000000 variants, and at most 100000000000 are possible: give the "
            "variables "
            "fewer values, or let method = \"sobol\" with a `count` fill the same space evenly");
}

TEST(SweepProfiles, SayWhatIsWrongWithResults) {
  EXPECT_TRUE(
      contains(message({"sweep.results.peak.of=maximum"}), "expected one of max, min, maxabs, range"));
  EXPECT_TRUE(
      contains(message({"sweep.results.peak.of=at"}), "peak.at is missing: expected the driver's position"));
  EXPECT_TRUE(contains(message({"sweep.results.peak.at=3"}), "belongs to of = \"at\""));
  EXPECT_TRUE(contains(message({"sweep.results.peak.column=follower.*"}), "expected the name of one column"));
  EXPECT_TRUE(contains(message({"sweep.results.peak.colum=3"}), "unknown key; did you mean `column`?"));
  EXPECT_TRUE(contains(message({"sweep.results.other={ of = \"max\" }"}), "other.column is missing"));
  EXPECT_TRUE(contains(message({"sweep.results.other={ column = \"driver\", of = \"rms\", where = true }"}),
                       "\"rms\" is of all rows and has no position"));
  EXPECT_TRUE(contains(message({"sweep.results.r={ column = \"driver\", of = \"max\" }"}),
                       "there is another column `r` in the table"));
  EXPECT_TRUE(contains(message({"sweep.results.status={ column = \"driver\", of = \"max\" }"}),
                       "there is another column `status`"));
  EXPECT_TRUE(contains(message({"sweep.rows=[\"driver\"]"}), "leave one of the two out"));
  EXPECT_TRUE(contains(message({"sweep.rows=driver", "sweep.results={}"}), "expected a list of columns"));
  EXPECT_TRUE(contains(message({"sweep.resuls=3"}), "did you mean `results`?"));
}

TEST(SweepProfiles, SayAllMistakesAtOnce) {
  EXPECT_TRUE(lines_are(messages(cam(), {"sweep.count=0", "sweep.variables.r.path=bodies.cam.nothing",
                                         "sweep.results.peak.of=most", "sweep.some=1"}),
                        {part("override sweep.count=0: sweep.count = 0: expected an integer from 1 to 1"),
                         part("there is no `nothing` in bodies.cam"), part("expected one of max"),
                         part("sweep.some: unknown key")}));
}

}  // namespace
}  // namespace higherpair

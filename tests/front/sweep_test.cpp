// Sweeps: every variant compared with a run of its own, on any number of threads, in parts, and where it
// fails.
#include "front/cam_profile.hpp"
#include "higherpair/higherpair.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::contains;
using ::testing::ElementsAre;
using testing::kCam;
using testing::lines_are;
using testing::model_of;
using testing::shipped_model;

constexpr const char* kSweep = R"(
[sweep]
method = "random"
count  = 2500
seed   = 5
[sweep.variables]
e = { path = "bodies.cam.curves.disc.center.0", normal = [10, 0.5] }
r = { path = "bodies.cam.curves.disc.radius", min = 25, max = 35 }
[sweep.results]
top    = { column = "follower.y", of = "max", where = true }
fast   = { column = "follower.vy", of = "maxabs" }
swing  = { column = "follower.y", of = "range" }
middle = { column = "follower.y", of = "at", at = 90 }
)";

Model cam_sweep(const std::vector<std::string>& overrides = {}, const std::string& sweep = kSweep) {
  return model_of(kCam + sweep, overrides);
}

std::string csv_of(const Sweep& sweep, int threads) {
  std::string text = sweep_csv_header(sweep);
  run_sweep(sweep, 0, threads, [&](const SweepBlock& block) {
    append_sweep_csv(sweep, block, text);
    return true;
  });
  return text;
}

std::vector<std::string> names_of(const Sweep& sweep) {
  std::vector<std::string> names;
  for (const Column& column : sweep.columns()) names.push_back(column.name + "[" + column.unit + "]");
  return names;
}

std::string sweep_refusal(const Model& model, const SweepSettings& settings = {}) {
  const auto sweep = Sweep::of(model, settings);
  return sweep ? "" : to_string(sweep.error());
}

TEST(Sweeps, HaveAColumnForEveryVariableAndResult) {
  EXPECT_TRUE(lines_are(names_of(Sweep::of(cam_sweep()).value()),
                        {"variant[1]", "e[mm]", "r[mm]", "top[mm]", "top.where[deg]", "fast[mm/s]",
                         "swing[mm]", "middle[mm]", "status[]"}));
}

TEST(Sweeps, AgreeWithARunOfEveryVariantOnItsOwn) {
  const Model model = cam_sweep({"sweep.count=40"});
  const Sweep sweep = Sweep::of(model).value();
  const SweepBlock block = sweep.block(0);
  ASSERT_EQ(block.variants, 40);
  EXPECT_EQ(block.good, 40);
  for (std::size_t k = 0; k < 40; ++k) {
    const double* row = &block.values[k * sweep.columns().size()];
    const Model variant =
        model.with({{"bodies.cam.curves.disc.center.0", row[1]}, {"bodies.cam.curves.disc.radius", row[2]}})
            .value();
    const Motion motion = variant.run().value();
    const ColumnValues y = motion.column("follower.y");
    const ColumnValues vy = motion.column("follower.vy");
    const auto top = std::max_element(y.begin(), y.end());
    EXPECT_EQ(row[0], static_cast<double>(k));
    EXPECT_EQ(row[3], *top);
    EXPECT_EQ(row[4], static_cast<double>(top - y.begin()));
    EXPECT_EQ(row[5], std::max(std::abs(*std::max_element(vy.begin(), vy.end())),
                               std::abs(*std::min_element(vy.begin(), vy.end()))));
    EXPECT_EQ(row[6], *top - *std::min_element(y.begin(), y.end()));
    EXPECT_EQ(row[7], y[90]);
    // The closed form: y = r + e sin θ.
    EXPECT_NEAR(row[3], row[2] + row[1], 1e-11);
    EXPECT_EQ(row[8], 0);
    EXPECT_EQ(block.causes[k], "");
  }
}

TEST(Sweeps, GiveTheSameTableOnAnyNumberOfThreads) {
  const Sweep sweep = Sweep::of(cam_sweep({"driver.samples=73"})).value();
  ASSERT_GT(sweep.blocks(), 2);
  const std::string one = csv_of(sweep, 1);
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 2501);
  for (const int threads : {0, 2, 3, 8}) {
    EXPECT_EQ(csv_of(sweep, threads), one) << threads;
  }
}

TEST(Sweeps, OfTheirPartsMakeTheWhole) {
  const Model model = cam_sweep({"driver.samples=73", "sweep.count=2501"});
  const Sweep whole = Sweep::of(model).value();
  const std::string header = sweep_csv_header(whole);
  for (const int parts : {2, 3, 7}) {
    std::string text = header;
    std::int64_t variants = 0;
    for (int part = 1; part <= parts; ++part) {
      SweepSettings settings;
      settings.part = part;
      settings.parts = parts;
      const Sweep sweep = Sweep::of(model, settings).value();
      EXPECT_EQ(sweep.first(), variants);
      variants += sweep.size();
      text += csv_of(sweep, 2).substr(header.size());
    }
    EXPECT_EQ(text, csv_of(whole, 2)) << parts;
  }
}

TEST(Sweeps, MayHaveMorePartsThanVariants) {
  SweepSettings settings;
  settings.parts = 7;
  std::int64_t variants = 0;
  for (settings.part = 1; settings.part <= 7; ++settings.part) {
    variants += Sweep::of(cam_sweep({"sweep.count=3"}), settings)->size();
  }
  EXPECT_EQ(variants, 3);
}

TEST(Sweeps, BeginAtAnyBlockAndEndWhereTheyAreTold) {
  const Sweep sweep = Sweep::of(cam_sweep({"driver.samples=73"})).value();
  std::vector<std::int64_t> numbers;
  run_sweep(sweep, 1, 2, [&](const SweepBlock& block) {
    numbers.push_back(block.number);
    return numbers.size() < 2;
  });
  EXPECT_THAT(numbers, ElementsAre(1, 2));
}

TEST(Sweeps, ThatAreStoppedGiveNoTornBlock) {
  std::atomic<bool> stop = false;
  SweepSettings settings;
  settings.stop = &stop;
  const Sweep sweep = Sweep::of(cam_sweep(), settings).value();
  stop = true;
  EXPECT_FALSE(sweep.block(0).complete);
  int taken = 0;
  run_sweep(sweep, 0, 2, [&](const SweepBlock&) {
    ++taken;
    return true;
  });
  EXPECT_EQ(taken, 0);
}

TEST(Sweeps, MakeRowsOfVariantsThatFail) {
  const Model model = cam_sweep({}, R"(
[sweep]
method = "list"
variables.r = { path = "bodies.cam.curves.disc.radius", values = [30, -1, 12, 0] }
results.top = { column = "follower.y", of = "max" }
)");
  const Sweep sweep = Sweep::of(model).value();
  EXPECT_EQ(csv_of(sweep, 2),
            "variant[1],r[mm],top[mm],status,cause\n"
            "0,30,40,ok,\n"
            "1,-1,,not_started,bodies.cam.curves.disc.radius = -1 mm: must be > 0\n"
            "2,12,22,ok,\n"
            "3,0,,not_started,bodies.cam.curves.disc.radius = 0 mm: must be > 0\n");
  const SweepBlock block = sweep.block(0);
  EXPECT_EQ(block.variants, 4);
  EXPECT_EQ(block.good, 2);
  EXPECT_EQ(sweep.forecast().tried, 4);
  EXPECT_EQ(sweep.forecast().unreadable, 2);
  EXPECT_EQ(sweep.forecast().variant, 1);
}

TEST(Sweeps, SayWhyAVariantIsNotGood) {
  const Model model =
      Model::open(HIGHERPAIR_SOURCE_DIR "/profiles/lock_up.toml",
                  std::vector<std::string>{"sweep.method=list", "sweep.variables.v.path=driver.end",
                                           "sweep.variables.v.values=[30, 100]",
                                           "sweep.results.a={column=\"driver\",of=\"last\"}"})
          .value();
  const SweepBlock block = Sweep::of(model)->block(0);
  ASSERT_EQ(block.causes.size(), 2U);
  EXPECT_EQ(block.causes[0], "");
  EXPECT_TRUE(contains(block.causes[1], "limit_position at driver = 65.8344"));
  EXPECT_EQ(block.good, 1);
  EXPECT_EQ(block.values[3], 0);
  EXPECT_EQ(block.values[7], static_cast<double>(RowStatus::kNotAssemblable));
}

// All rows are ok, but the path between them is not.
TEST(Sweeps, HoldThePathBetweenRowsAgainstAVariantToo) {
  const Model model = Model::open(HIGHERPAIR_SOURCE_DIR "/profiles/lock_up.toml",
                                  std::vector<std::string>{"driver.positions=[0, 359]", "sweep.method=list",
                                                           "sweep.variables.v.path=driver.velocity",
                                                           "sweep.variables.v.values=[1]"})
                          .value();
  const SweepBlock block = Sweep::of(model)->block(0);
  EXPECT_EQ(block.values.back(), 0);
  EXPECT_EQ(block.good, 0);
  EXPECT_TRUE(contains(block.causes[0], "limit_position"));
}

TEST(Sweeps, CountRowsAndEvents) {
  const Sweep sweep = Sweep::of(cam_sweep({"sweep.counts=true", "sweep.count=2"})).value();
  const SweepBlock block = sweep.block(0);
  const auto value = [&](const std::string& name) {
    for (std::size_t i = 0; i < sweep.columns().size(); ++i) {
      if (sweep.columns()[i].name == name) return block.values[i];
    }
    return -1.0;
  };
  EXPECT_EQ(value("rows.ok"), 361);
  EXPECT_EQ(value("rows.not_assemblable"), 0);
  EXPECT_EQ(value("events.stroke_end"), 2);
  EXPECT_EQ(value("events.overlap"), 0);
  EXPECT_EQ(value("events.law_jump"), 0);
}

TEST(Sweeps, WriteWholeRowsWhereTheyAreAskedTo) {
  const Model model = cam_sweep({}, R"(
[sweep]
method = "list"
rows = ["driver", "follower.y"]
variables.r = { path = "bodies.cam.curves.disc.radius", values = [30, -1, 33] }
)");
  const Sweep sweep = Sweep::of(model).value();
  EXPECT_TRUE(
      lines_are(names_of(sweep), {"variant[1]", "r[mm]", "driver[deg]", "follower.y[mm]", "status[]"}));
  const SweepBlock block = sweep.block(0);
  ASSERT_EQ(block.causes.size(), 361U + 1 + 361);
  EXPECT_EQ(block.variants, 3);
  RunSettings settings;
  settings.columns = {"driver", "follower.y"};
  const Motion motion = model.with({{"bodies.cam.curves.disc.radius", 33.0}})->run(settings).value();
  for (std::size_t k = 0; k < 361; ++k) {
    const double* row = &block.values[(362 + k) * 5];
    EXPECT_EQ(row[0], 2);
    EXPECT_EQ(row[1], 33);
    EXPECT_EQ(row[2], motion.column("driver")[k]);
    EXPECT_EQ(row[3], motion.column("follower.y")[k]);
    EXPECT_EQ(row[4], 0);
  }
  EXPECT_TRUE(contains(block.causes[361], "must be > 0"));
  EXPECT_TRUE(std::isnan(block.values[361 * 5 + 3]));
}

TEST(Sweeps, OfRowsWorkOutForcesWhereAColumnNeedsThem) {
  const Model model = cam_sweep({}, R"(
[sweep]
method = "list"
rows = ["touch.force"]
variables.r = { path = "bodies.cam.curves.disc.radius", values = [30] }
)");
  EXPECT_TRUE(
      lines_are(names_of(Sweep::of(model).value()), {"variant[1]", "r[mm]", "touch.force[N]", "status[]"}));
}

TEST(Sweeps, SetAllPathsOfAVariable) {
  const Model model = cam_sweep({}, R"(
[sweep]
method = "list"
variables.a = { path = ["bodies.cam.curves.disc.radius", "bodies.follower.pose.y"], values = [31] }
results.top = { column = "follower.y", of = "max" }
)");
  EXPECT_EQ(Sweep::of(model)->block(0).values[2], 41);
}

TEST(Sweeps, SayWhatTheyCannotDo) {
  EXPECT_TRUE(contains(sweep_refusal(model_of(kCam)), "there is no [sweep]"));
  EXPECT_TRUE(contains(
      sweep_refusal(cam_sweep({"sweep.results.top.column=folower.y"})),
      "sweep.results.top.column = \"folower.y\": there is no such column; did you mean `follower.y`"));
  EXPECT_TRUE(contains(
      sweep_refusal(cam_sweep({"sweep.rows=[\"folower.*\"]", "sweep.results={}"}, std::string(kSweep))),
      "rows"));
  EXPECT_TRUE(contains(sweep_refusal(cam_sweep({}, R"(
[sweep]
method = "list"
variables.r = { path = "bodies.cam.curves.disc.radius", values = [-3, -2] }
)")),
                       "sweep: not one variant of 2 that were tried can be read; variant 0: "
                       "bodies.cam.curves.disc.radius = -3 mm: must be > 0"));
  SweepSettings settings;
  settings.part = 3;
  settings.parts = 2;
  EXPECT_TRUE(contains(sweep_refusal(cam_sweep(), settings), "part 3 of 2"));
  EXPECT_TRUE(contains(sweep_refusal(cam_sweep({"bodies.loose.points.P=[0, 0]"})), "loose"));
}

TEST(Sweeps, OfRowsNameColumnsThatDoNotExist) {
  const Model model = cam_sweep({}, R"(
[sweep]
method = "list"
rows = ["folower.*"]
variables.r = { path = "bodies.cam.curves.disc.radius", values = [30] }
)");
  EXPECT_TRUE(contains(sweep_refusal(model), "sweep.rows: no column of this run has such a name"));
}

TEST(Sweeps, OfRowsRefuseAVariableWithTheNameOfAColumn) {
  const Model model = cam_sweep({}, R"(
[sweep]
method = "list"
rows = ["driver"]
variables.driver = { path = "bodies.cam.curves.disc.radius", values = [30] }
)");
  EXPECT_TRUE(contains(sweep_refusal(model), "two columns would be called `driver`"));
}

// A task that varies the radius of the disc: y = r + 10 sin θ.
SweepTask task_of_radius() {
  SweepTask task;
  SweepVariable radius;
  radius.name = "r";
  radius.paths = {"bodies.cam.curves.disc.radius"};
  radius.distribution.kind = DistributionKind::kValues;
  radius.distribution.values = {25, 31, 37};
  task.plan.variables = {radius};
  task.units = {"mm"};
  SweepResult top;
  top.name = "top";
  top.measure.column = "follower.y";
  task.results = {top};
  return task;
}

std::string task_refusal(const std::function<void(SweepTask&)>& change, const Model& model = model_of(kCam)) {
  auto task = std::make_shared<SweepTask>(task_of_radius());
  change(*task);
  SweepSettings settings;
  settings.task = std::move(task);
  return sweep_refusal(model, settings);
}

TEST(SweepTasksOfAProgram, AreRun) {
  SweepSettings settings;
  settings.task = std::make_shared<SweepTask>(task_of_radius());
  const Sweep sweep = Sweep::of(model_of(kCam), settings).value();
  const SweepBlock block = sweep.block(0);
  ASSERT_EQ(block.variants, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(block.values[4 * k + 2], 35 + 6.0 * static_cast<double>(k), 1e-9);
  }
  for (const std::int64_t none :
       {std::int64_t{-1}, std::int64_t{1}, std::numeric_limits<std::int64_t>::max()}) {
    EXPECT_EQ(sweep.variants_of(none), 0);
    EXPECT_EQ(sweep.block(none).values.size(), 0U);
  }
}

TEST(SweepTasksOfAProgram, NameTheirMistake) {
  EXPECT_TRUE(
      contains(task_refusal([](auto& t) { t.plan.variables[0].paths = {"bodies.cam.curves.disk.radius"}; }),
               "bodies.cam.curves.disk.radius: there is no such key"));
  EXPECT_TRUE(
      contains(task_refusal([](auto& t) { t.plan.variables[0].paths = {"bodies.cam.curves.disc.type"}; }),
               "bodies.cam.curves.disc.type: this is a string; expected the path of a number"));
  EXPECT_TRUE(contains(task_refusal([](auto& t) { t.plan.variables[0].paths.clear(); }),
                       "sweep.variables.r: expected at least one path"));
  EXPECT_EQ(task_refusal([](auto& t) { t.units.clear(); }),
            "test.toml: sweep.units: 0 for 1 variables: each needs its own");
  EXPECT_EQ(task_refusal([](auto& t) { t.plan.variables[0].distribution.values.clear(); }),
            "test.toml: sweep.variables.r: expected at least one of `values`");
  EXPECT_TRUE(contains(task_refusal([](auto&) {}, Model::from(model_of(kCam).mechanism()).value()),
                       "has no keys to set"));
}

SweepSummary summary_of(const Sweep& sweep) {
  SweepSummary summary(sweep);
  for (const auto pass : {&SweepSummary::add, &SweepSummary::place}) {
    run_sweep(sweep, 0, 1, [&](const SweepBlock& block) {
      (summary.*pass)(block);
      return true;
    });
  }
  return summary;
}

// The follower's top is at the sum of radius and eccentricity: 100 values from 37 to 47 mm.
TEST(SweepSummaries, HaveTheDistributionOfEveryResult) {
  const SweepSummary summary = summary_of(Sweep::of(cam_sweep({}, R"(
[sweep]
method = "grid"
[sweep.variables]
e = { path = "bodies.cam.curves.disc.center.0", min = 7, max = 17, count = 100 }
[sweep.results]
top = { column = "follower.y", of = "max" }
)"))
                                              .value());
  EXPECT_EQ(summary.variants(), 100);
  EXPECT_TRUE(summary.good());
  EXPECT_TRUE(summary.causes().empty());
  ASSERT_EQ(summary.results().size(), 1);
  const ColumnStatistics& top = summary.results().front();
  EXPECT_EQ(top.count(), 100);
  EXPECT_NEAR(top.least(), 37, 1e-12);
  EXPECT_NEAR(top.largest(), 47, 1e-12);
  EXPECT_NEAR(top.mean(), 42, 1e-12);
  EXPECT_NEAR(top.deviation(), 10 / 99.0 * std::sqrt(100 * 101 / 12.0), 1e-12);
  EXPECT_NEAR(top.quantile(0.25), 39.5, 0.1);
  EXPECT_THAT(top.histogram(2), ElementsAre(50, 50));
  EXPECT_TRUE(
      contains(summary.text("A title"), "A title\n\n100 variants: 100 ok\n\ntop [mm]\n  smallest 37 "));
}

TEST(ColumnStatistics, LeaveOutWhatIsNoNumber) {
  ColumnStatistics none;
  EXPECT_TRUE(std::isnan(none.mean()));
  EXPECT_THAT(none.histogram(2), ElementsAre(0, 0));
  ColumnStatistics some;
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> values = {1e308, -1e308, infinity, -infinity, std::nan("")};
  for (const double value : values) some.add(value);
  for (const double value : values) some.place(value);
  EXPECT_EQ(some.count(), 2);
  EXPECT_EQ(some.mean(), 0);
  EXPECT_THAT(some.histogram(2), ElementsAre(1, 1));
  EXPECT_TRUE(some.histogram(0).empty());
}

TEST(SweepSummaries, CountCausesThatDifferInTheirNumbersAsOne) {
  const SweepSummary summary = summary_of(Sweep::of(cam_sweep({}, R"(
[sweep]
method = "list"
[sweep.variables]
r = { path = "bodies.cam.curves.disc.radius", values = [-3, 31, -2, 30] }
[sweep.results]
top = { column = "follower.y", of = "max" }
)"))
                                              .value());
  EXPECT_FALSE(summary.good());
  ASSERT_EQ(summary.causes().size(), 1);
  EXPECT_EQ(summary.causes()[0].count, 2);
  EXPECT_TRUE(contains(summary.causes()[0].example, "radius = -3 mm: must be > 0"));
  EXPECT_EQ(summary.results().front().count(), 2);
}

TEST(ModelVariants, AreTheModelsThatWithMakes) {
  const Model model = shipped_model("ellipse_cam_roller");
  const std::vector<std::string> paths = {"bodies.follower.curves.roller.radius", "driver.end"};
  ModelVariants variants = ModelVariants::of(model, paths).value();
  for (const double radius : {7.3, 11.9, 5.0}) {
    const Motion quick = variants.with(std::vector<double>{radius, 300})->run().value();
    const Motion slow = model.with({{paths[0], radius}, {paths[1], 300.0}})->run().value();
    ASSERT_EQ(quick.size(), 361U);
    for (const Column& column : slow.columns()) {
      const ColumnValues a = quick.column(column.name);
      const ColumnValues b = slow.column(column.name);
      for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_TRUE(a[k] == b[k] || (std::isnan(a[k]) && std::isnan(b[k]))) << column.name;
      }
    }
  }
  const auto wrong = variants.with(std::vector<double>{-1, 300});
  ASSERT_FALSE(wrong);
  EXPECT_TRUE(contains(to_string(wrong.error()), "roller.radius = -1 mm: must be > 0"));
  for (const std::vector<double>& values : {std::vector<double>{}, {7.3}, {7.3, 300, 3}}) {
    const auto refused = variants.with(values);
    ASSERT_FALSE(refused) << values.size();
    EXPECT_EQ(refused.error().kind, ErrorKind::kInput);
    EXPECT_TRUE(contains(to_string(refused.error()), "values for 2 paths: each path needs its own"));
  }
}

TEST(ModelVariants, NeedAProfileAndPathsOfIt) {
  const Model model = model_of(kCam);
  const std::vector<std::string> paths = {"bodies.cam.curves.disc.size"};
  EXPECT_TRUE(contains(to_string(ModelVariants::of(model, paths).error()), "there is no such key"));
  const Model built = Model::from(model.mechanism()).value();
  EXPECT_TRUE(
      contains(to_string(ModelVariants::of(built, paths).error()), "was built, or made by ModelVariants"));
}

TEST(ModelVariants, MayChangeEveryNumberThatTheirModelLists) {
  for (const char* name :
       {"design_eccentric", "tolerance_study", "toleranced_linkage", "ellipse_cam_roller"}) {
    const Model model = shipped_model(name);
    for (const Parameter& parameter : model.parameters()) {
      const std::vector<std::string> path = {parameter.path};
      auto variants = ModelVariants::of(model, path);
      ASSERT_TRUE(variants) << to_string(variants.error());
      EXPECT_TRUE(variants->with(std::vector{parameter.value})) << parameter.path;
    }
  }
  const Model inches = model_of(kCam, {"bodies.cam.curves.disc.radius=1.2 in"});
  const std::vector<std::string> radius = {"bodies.cam.curves.disc.radius"};
  const Model variant = ModelVariants::of(inches, radius).value().with(std::vector{31.0}).value();
  EXPECT_DOUBLE_EQ(variant.mechanism().bodies[1].curves[0].curve.semi_latus, 0.031);
}

TEST(ModelVariants, HaveNoKeysThemselves) {
  const Model model = model_of(kCam);
  const std::vector<std::string> radius = {"bodies.cam.curves.disc.radius"};
  const Model variant = ModelVariants::of(model, radius).value().with(std::vector{31.0}).value();
  EXPECT_TRUE(variant.parameters().empty());
  EXPECT_TRUE(contains(to_string(variant.with({{radius[0], 32.0}}).error()), "made by ModelVariants"));
}

TEST(ModelVariants, RefusePathsThatLeadToNoNumber) {
  const Model model = shipped_model("ellipse_cam_roller");
  for (const auto& [path, kind] : {std::pair("title", "a string"), std::pair("bodies.follower", "a table"),
                                   std::pair("bodies.cam.points.O", "a list")}) {
    const std::vector<std::string> paths = {path};
    EXPECT_TRUE(contains(to_string(ModelVariants::of(model, paths).error()),
                         std::string(path) + ": this is " + kind + "; expected the path of a number"));
  }
}

}  // namespace
}  // namespace higherpair

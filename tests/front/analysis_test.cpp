// Rows one after the other, what happens between them, and many simultaneous runs of one model.
#include "front/cam_profile.hpp"
#include "higherpair/higherpair.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::kCam;
using testing::model_of;
using testing::shipped_model;
using ::testing::SizeIs;
using testing::text_of;

// Where crank 2 and rod 5 are in line the pin is 7 or 3 from the pivot; the slide passes 0.75 beside it.
TEST(Analysis, SaysTheCoordinateAtWhichAJointReverses) {
  const Motion motion = shipped_model("slider_crank").run().value();
  std::vector<double> values;
  for (const Event& event : motion.events()) {
    if (event.type == EventType::kStrokeEnd) values.push_back(event.value.value());
  }
  ASSERT_THAT(values, SizeIs(2));
  EXPECT_NEAR(std::max(values[0], values[1]), std::sqrt(49 - 0.5625), 1e-9);
  EXPECT_NEAR(std::min(values[0], values[1]), std::sqrt(9 - 0.5625), 1e-9);
}

TEST(Analysis, GivesTheRowsOfTheMotionOneByOne) {
  RunSettings settings;
  settings.samples = 50;
  settings.jerk = true;
  const Model model = shipped_model("ellipse_cam_roller");
  const Motion motion = model.run(settings).value();
  Analysis analysis = model.start(settings).value();
  EXPECT_EQ(analysis.size(), 50);
  std::vector<Row> rows;
  for (Row row; analysis.next(row);) {
    rows.push_back(row);  // rows are the caller's own copies
  }
  ASSERT_THAT(rows, SizeIs(motion.size()));
  EXPECT_EQ(analysis.events().size(), motion.events().size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].number, static_cast<std::int64_t>(k));
    EXPECT_EQ(rows[k].status, motion.statuses()[k]);
    for (std::size_t i = 0; i < motion.columns().size(); ++i) {
      const double expected = motion.column(motion.columns()[i].name)[k];
      EXPECT_TRUE(rows[k].values[i] == expected || std::isnan(expected));
    }
  }
}

TEST(Analysis, FollowsTheClosedFormOfACam) {
  RunSettings settings;
  settings.units = kSiUnits;
  const Motion motion = model_of(kCam, {"driver.velocity=\"2 rad/s\""}).run(settings).value();
  const auto theta = motion.column("driver");
  const auto y = motion.column("follower.y");
  const auto vy = motion.column("follower.vy");
  const auto ay = motion.column("follower.ay");
  ASSERT_EQ(motion.size(), 361U);
  EXPECT_TRUE(motion.good());
  for (std::size_t k = 0; k < motion.size(); ++k) {
    EXPECT_NEAR(y[k], 0.030 + 0.010 * std::sin(theta[k]), 2e-16);
    EXPECT_NEAR(vy[k], 0.020 * std::cos(theta[k]), 2e-16);
    EXPECT_NEAR(ay[k], -0.040 * std::sin(theta[k]), 1e-15);
  }
}

TEST(Analysis, TakesPositionsInPlaceOfTheProfiles) {
  RunSettings settings;
  settings.positions = {0, 90, 30};
  const Motion motion = model_of(kCam).run(settings).value();
  const auto y = motion.column("follower.y");
  ASSERT_EQ(y.size(), 3U);
  EXPECT_NEAR(y[1], 40, 1e-13);
  EXPECT_NEAR(y[2], 35, 1e-13);
}

TEST(Analysis, RunsInTime) {
  RunSettings settings;
  settings.in_time = true;
  const Model model = model_of(
      kCam, {"driver.velocity=90", "driver.acceleration=10", "driver.duration=2", "driver.time_step=0.5"});
  const Motion motion = model.run(settings).value();
  const auto time = motion.column("time");
  const auto driver = motion.column("driver");
  ASSERT_EQ(motion.size(), 5U);
  for (std::size_t k = 0; k < motion.size(); ++k) {
    EXPECT_EQ(time[k], 0.5 * static_cast<double>(k));
    EXPECT_NEAR(driver[k], 90 * time[k] + 5 * time[k] * time[k], 1e-13);
  }
  EXPECT_FALSE(motion.events().empty());
  for (const Event& event : motion.events()) {
    ASSERT_TRUE(event.time.has_value());
    EXPECT_NEAR(90 * *event.time + 5 * *event.time * *event.time, event.driver, 1e-9);
  }
}

TEST(Path, IsNotGoodWhereALimitLiesBetweenTwoRowsThatAreOk) {
  const Model model = shipped_model("lock_up");
  RunSettings settings;
  settings.positions = {0, 359};
  const Motion motion = model.run(settings).value();
  EXPECT_EQ(motion.statuses()[0], RowStatus::kOk);
  EXPECT_EQ(motion.statuses()[1], RowStatus::kOk);
  EXPECT_FALSE(motion.good());
  settings.positions = {0, 1};
  EXPECT_TRUE(model.run(settings).value().good());
}

// Arcs along the curves end in a gap of the motion, whether a row lies in it or not.
TEST(Path, HasNoArcsBehindALimitBetweenTwoRowsThatAreOk) {
  const Model model = shipped_model("lock_up");
  RunSettings settings;
  for (const std::vector<double>& positions :
       {std::vector<double>{0, 10, 359}, {0, 10, 180, 359}, {0, 10, 60, 300, 359}}) {
    settings.positions = positions;
    const Motion motion = model.run(settings).value();
    const std::span<const double> arcs = motion.column("touch.arc1").values;
    EXPECT_LT(arcs[1], -9);
    EXPECT_TRUE(std::isnan(arcs.back())) << positions.size();
    EXPECT_EQ(motion.statuses().back(), RowStatus::kOk);
  }
}

TEST(Path, IsNotGoodWhereAContactOpensBetweenTwoRowsThatAreOk) {
  RunSettings settings;
  settings.forces = true;
  settings.samples = 3;
  const Motion motion =
      shipped_model("cam_with_return_spring", {"driver.velocity=\"900 rpm\""}).run(settings).value();
  bool opens = false;
  for (const Event& event : motion.events()) {
    opens = opens || event.type == EventType::kContactOpen;
    EXPECT_NE(event.cause, "");
  }
  EXPECT_TRUE(opens);
  EXPECT_FALSE(motion.good());
}

TEST(Stop, EndsARunWithinALongRow) {
  std::atomic<bool> stop = false;
  RunSettings settings;
  settings.stop = &stop;
  settings.samples = 2;
  settings.columns = {"driver"};
  Analysis analysis = shipped_model("ellipse_cam_roller", {"driver.end=1e9"}).start(settings).value();
  Row row;
  ASSERT_TRUE(analysis.next(row));
  EXPECT_FALSE(analysis.stopped());
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop = true;
  });
  EXPECT_FALSE(analysis.next(row));
  stopper.join();
  EXPECT_TRUE(analysis.stopped());
  EXPECT_FALSE(analysis.next(row));
}

// Whenever the stop comes, a run that does not say that it was stopped has found all that opens.
TEST(Stop, IsSaidInTheSearchForOpeningsAfterTheLastRow) {
  const Model model =
      shipped_model("cam_with_return_spring", {"driver.samples=3", "driver.velocity=\"900 rpm\""});
  for (int i = 0; i < 100; ++i) {
    std::atomic<bool> stop = false;
    RunSettings settings;
    settings.forces = true;
    settings.stop = &stop;
    Analysis analysis = model.start(settings).value();
    Row row;
    ASSERT_TRUE(analysis.next(row) && analysis.next(row));
    std::thread stopper([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(20 * i));
      stop = true;
    });
    const bool given = analysis.next(row);
    stopper.join();
    EXPECT_NE(given, analysis.stopped());
    EXPECT_TRUE(!given || !analysis.good());
  }
}

TEST(Stop, LeavesAMotionThatIsNotGood) {
  const std::atomic<bool> stop = true;
  RunSettings settings;
  settings.stop = &stop;
  const Motion motion = model_of(kCam).run(settings).value();
  EXPECT_EQ(motion.size(), 0U);
  EXPECT_TRUE(motion.stopped());
  EXPECT_FALSE(motion.good());
  EXPECT_TRUE(motion.column("driver").values.empty());
}

// Also run under the thread sanitizer.
TEST(Threads, AnalyseOneModelAtOnceWithTheSameResultBitForBit) {
  for (const std::string name : {"ellipse_cam_roller", "watt_sixbar_forces", "geared_five_bar"}) {
    const Model model = shipped_model(name);
    RunSettings settings;
    settings.samples = 40;
    settings.forces = true;
    settings.jerk = true;
    const std::string alone = text_of(model.run(settings).value());
    std::vector<std::string> together(8);
    std::vector<std::thread> threads;
    for (std::string& text : together) {
      threads.emplace_back([&, copy = model] { text = text_of(copy.run(settings).value()); });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    for (const std::string& text : together) {
      EXPECT_EQ(text, alone) << name;
    }
  }
}

TEST(Settings, ThatAreWrongAreErrorsOfTheInput) {
  const Model model = model_of(kCam);
  const auto refusal = [&](const RunSettings& settings) {
    const auto refused = model.start(settings);
    EXPECT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kInput);
    return to_string(refused.error());
  };
  RunSettings settings;
  settings.derivatives = 7;
  EXPECT_TRUE(contains(refusal(settings), "setting derivatives 7: must be from 3 to 6"));
  settings = {};
  settings.tolerance = 0;
  EXPECT_TRUE(contains(refusal(settings), "setting tolerance 0: must be > 0"));
  settings = {};
  settings.samples = 0;
  EXPECT_TRUE(contains(refusal(settings), "must be an integer from 1"));
  settings = {};
  for (const double position : {double(INFINITY), 1e30, -3.7e12}) {
    settings.positions = {position};
    EXPECT_TRUE(contains(refusal(settings), "setting positions ")) << position;
    EXPECT_TRUE(contains(refusal(settings), "is not finite, or beyond 1e9 turns")) << position;
  }
  settings.positions.clear();
  settings.units = kSiUnits;
  settings.units->angle = Unit::kMetre;
  EXPECT_TRUE(
      contains(refusal(settings), "Units::angle = m: is the unit of a length, expected that of an angle"));
  settings = {};
  settings.positions = {0, 1};
  settings.in_time = true;
  EXPECT_TRUE(contains(refusal(settings), "positions"));
  settings.positions.clear();
  EXPECT_TRUE(contains(refusal(settings), "duration is missing"));
}

TEST(Start, SaysWhyAMechanismCannotBeStarted) {
  const auto apart = model_of(kCam, {"joints.guide.direction=[1, 0]"}).start();
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().kind, ErrorKind::kMechanism);
  EXPECT_TRUE(contains(to_string(apart.error()), "test.toml: contacts.touch: "));
  const auto slips = model_of(kCam, {"contacts.touch.rolling=true"}).start();
  ASSERT_FALSE(slips);
  EXPECT_EQ(slips.error().kind, ErrorKind::kMechanism);
  EXPECT_TRUE(contains(to_string(slips.error()), "cannot roll"));
}

}  // namespace
}  // namespace higherpair

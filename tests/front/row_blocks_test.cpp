// Long runs in blocks on several threads: rows, events and verdict are those of a run row by row, to the last
// bit, and no event is lost or doubled where a block begins.
#include "front/cam_profile.hpp"
#include "higherpair/front/motion.hpp"
#include "higherpair/higherpair.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::shipped_model;

struct Whole {
  std::vector<RowStatus> statuses;
  std::vector<double> values;
  std::string csv;
  std::vector<std::string> events;
  bool good = false;
};

std::vector<std::string> texts_of(const std::vector<Event>& events) {
  std::vector<std::string> texts;
  for (const Event& event : events) {
    texts.push_back(fmt::format("{} {} {} {} {} {}", name_of(event.type), event.driver,
                                event.time.value_or(-1), event.item, event.row, event.cause));
  }
  return texts;
}

Whole row_by_row(Analysis analysis) {
  Whole whole;
  Row row;
  while (analysis.next(row)) {
    whole.statuses.push_back(row.status);
    whole.values.insert(whole.values.end(), row.values.begin(), row.values.end());
    append_csv_row(analysis.columns(), row, whole.csv);
  }
  whole.events = texts_of(analysis.events());
  whole.good = analysis.good();
  return whole;
}

Whole in_blocks(Analysis analysis, int threads) {
  Whole whole;
  run_blocks(
      analysis, threads,
      [&](const RowBlock& block, BlockTexts& texts) {
        texts.resize(1);
        append_csv_rows(analysis.columns(), block, texts[0]);
      },
      [&](const RowBlock& block, const BlockTexts& texts) {
        EXPECT_EQ(block.first, static_cast<std::int64_t>(whole.statuses.size()));
        whole.statuses.insert(whole.statuses.end(), block.statuses.begin(), block.statuses.end());
        whole.values.insert(whole.values.end(), block.values.begin(), block.values.end());
        whole.csv += texts.front();
        return true;
      });
  whole.events = texts_of(analysis.events());
  whole.good = analysis.good();
  return whole;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

void expect_same(const Whole& a, const Whole& b) {
  EXPECT_EQ(a.statuses, b.statuses);
  EXPECT_TRUE(same_bits(a.values, b.values));
  EXPECT_TRUE(a.csv == b.csv);
  EXPECT_EQ(a.events, b.events);
  EXPECT_EQ(a.good, b.good);
}

class Blocks : public ::testing::TestWithParam<const char*> {
protected:
  const Model model_ = shipped_model(GetParam());

  [[nodiscard]] Analysis start(std::int64_t samples) const {
    RunSettings settings;
    settings.samples = samples;
    settings.forces = has_forces(model_.mechanism());
    return model_.start(settings).value();
  }
};

TEST_P(Blocks, AreTheRowsOfARunOnAnyNumberOfThreads) {
  const Whole alone = row_by_row(start(9007));
  EXPECT_EQ(alone.statuses.size(), 9007U);
  for (const int threads : {1, 2, 5}) {
    expect_same(in_blocks(start(9007), threads), alone);
  }
}

// The rows of a run do not depend on their number.
TEST_P(Blocks, BeginWithTheRowsOfARunThatHasNone) {
  const Whole few = row_by_row(start(1 + 2000));
  const Whole many = row_by_row(start(1 + 6 * 2000));
  const std::size_t width = few.values.size() / few.statuses.size();
  double largest = 0;
  for (const double value : few.values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  ASSERT_EQ(many.values.size(), width * many.statuses.size());
  int apart = 0;
  for (std::size_t row = 0; row < few.statuses.size(); ++row) {
    if (few.statuses[row] != RowStatus::kOk) continue;
    EXPECT_EQ(many.statuses[6 * row], RowStatus::kOk) << row;
    for (std::size_t i = 0; i < width; ++i) {
      const double a = few.values[row * width + i];
      const double b = many.values[6 * row * width + i];
      if (std::isnan(a) != std::isnan(b) || std::abs(a - b) > 1e-9 * (largest + std::abs(a))) ++apart;
    }
  }
  EXPECT_EQ(apart, 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, Blocks,
                         ::testing::Values("four_bar", "watt_sixbar_forces", "ellipse_cam_roller", "five_bar",
                                           "spline_cam", "law_cam_roller", "rolling_ellipses", "four_arc_cam",
                                           "planetary_gear", "quick_return", "double_rocker", "parallelogram",
                                           "geneva_four_slots", "valve_train", "slider_crank",
                                           "start_stop_crank"));

std::vector<std::string> kinds_of(const Whole& whole) {
  std::vector<std::string> kinds;
  for (const std::string& event : whole.events) kinds.push_back(event.substr(0, event.find(' ')));
  return kinds;
}

// 181 rows of a whole turn are one block. With 8191 rows the last one of the first block is at half a turn,
// with 8193 the first one of the second; there symmetric mechanisms reverse, begin, or pass a change point.
TEST(BlocksOfSymmetricMechanisms, LoseNoEventWhereOneBegins) {
  for (const char* name : {"slider_crank", "scotch_yoke", "parallelogram", "oval_in_ring", "law_cam_flat",
                           "flat_faced_translating", "knife_edge", "straight_line", "quick_return"}) {
    const Model model = shipped_model(name);
    const auto run = [&](std::int64_t samples) {
      RunSettings settings;
      settings.samples = samples;
      return in_blocks(model.start(settings).value(), 2);
    };
    const std::vector<std::string> expected = kinds_of(run(181));
    for (const std::int64_t samples : {8191, 8192, 8193, 4097, 4098}) {
      EXPECT_EQ(kinds_of(run(samples)), expected) << name << ", " << samples << " rows";
    }
  }
}

TEST(BlocksOfListedPositions, FollowEveryTurnOfTheDriver) {
  const Model model = shipped_model("ellipse_cam_roller");
  std::mt19937 random(3);
  std::uniform_real_distribution<double> steps(-9, 10);
  RunSettings settings;
  for (double at = 0; settings.positions.size() < 10000; at += steps(random))
    settings.positions.push_back(at);
  const Whole alone = row_by_row(model.start(settings).value());
  EXPECT_THAT(alone.events, ::testing::SizeIs(::testing::Gt(20)));
  expect_same(in_blocks(model.start(settings).value(), 3), alone);
}

// Three times over a limit and back, within a block: after a gap in the motion there are no arcs.
TEST(BlocksOfListedPositions, GoOverALimitAndBack) {
  const Model model = shipped_model("lock_up");
  RunSettings settings;
  for (int k = 0; k < 9000; ++k) settings.positions.push_back(50 + 16.2 * std::sin(kPi * k / 1500));
  const Whole alone = row_by_row(model.start(settings).value());
  EXPECT_THAT(alone.statuses, ::testing::Contains(RowStatus::kNotAssemblable));
  EXPECT_EQ(alone.statuses.back(), RowStatus::kOk);
  for (const int threads : {1, 2, 4}) expect_same(in_blocks(model.start(settings).value(), threads), alone);
}

TEST(BlocksInTime, PassWhereTheDriverTurnsBackWithinOne) {
  const Model model = shipped_model("four_bar", {"driver.velocity=100", "driver.acceleration=-40",
                                                 "driver.duration=6", "driver.time_step=0.0005"});
  RunSettings settings;
  settings.in_time = true;
  const Whole alone = row_by_row(model.start(settings).value());
  expect_same(in_blocks(model.start(settings).value(), 2), alone);
  settings.samples = 100;
  EXPECT_EQ(kinds_of(row_by_row(model.start(settings).value())), kinds_of(alone));
}

TEST(BlocksUnderWay, EndWhereTheyAreNotWantedAnyMore) {
  const Model model = shipped_model("four_bar");
  RunSettings settings;
  settings.samples = 100000;
  Analysis analysis = model.start(settings).value();
  int taken = 0;
  run_blocks(
      analysis, 3, [](const RowBlock&, BlockTexts&) {},
      [&](const RowBlock&, const BlockTexts&) { return ++taken < 3; });
  EXPECT_EQ(taken, 3);
  EXPECT_FALSE(analysis.stopped());
}

TEST(BlocksUnderWay, EndWhereTheRunIsStopped) {
  const Model model = shipped_model("four_bar");
  std::atomic<bool> stop = false;
  RunSettings settings;
  settings.samples = 100000;
  settings.stop = &stop;
  Analysis analysis = model.start(settings).value();
  int taken = 0;
  run_blocks(
      analysis, 3, [](const RowBlock&, BlockTexts&) {},
      [&](const RowBlock&, const BlockTexts&) {
        stop = ++taken >= 2;
        return true;
      });
  EXPECT_LT(taken, 25);
  EXPECT_TRUE(analysis.stopped());
}

// Openings are searched for after the last row. Without them a run may look good that is not.
TEST(BlocksUnderWay, CountAsStoppedInTheSearchForOpenings) {
  std::atomic<bool> stop = false;
  RunSettings settings;
  settings.forces = true;
  settings.stop = &stop;
  const Model model =
      shipped_model("cam_with_return_spring", {"driver.samples=3", "driver.velocity=\"900 rpm\""});
  Analysis whole = model.start(settings).value();
  EXPECT_FALSE(row_by_row(std::move(whole)).good);
  Analysis analysis = model.start(settings).value();
  run_blocks(
      analysis, 1, [](const RowBlock&, BlockTexts&) {},
      [&](const RowBlock&, const BlockTexts&) { return stop = true; });
  EXPECT_TRUE(analysis.stopped());
}

TEST(RowsAsCsv, AreTheSameOneByOneAndInBlocks) {
  const std::vector<std::string_view> words = {"yes", "a long word that is not short"};
  const std::vector<Column> columns = {{"a", "1", {}}, {"b", "", words}, {"c", "m", {}}, {"d", "m", {}}};
  std::mt19937_64 random(5);
  RowBlock block;
  std::string one_by_one;
  for (int i = 0; i < 5000; ++i) {
    const auto any = [&] {
      const auto bits = random();
      double value = 0;
      std::memcpy(&value, &bits, sizeof value);
      return std::isfinite(value) ? value : i % 2 == 0 ? -0.0 : std::nan("");
    };
    Row row{i, RowStatus::kOk, {any(), i % 3 == 2 ? std::nan("") : i % 3, 1.0 / (i % 7 + 1), any()}};
    append_csv_row(columns, row, one_by_one);
    block.statuses.push_back(row.status);
    block.values.insert(block.values.end(), row.values.begin(), row.values.end());
  }
  std::string text;
  append_csv_rows(columns, block, text);
  EXPECT_TRUE(text == one_by_one);
}

}  // namespace
}  // namespace higherpair

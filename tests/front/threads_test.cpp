// One model on several threads at once gives each of them the same result as one thread alone, bit for bit.
// Built with the thread sanitizer (preset `tsan`), it also proves that they share no data that is written.
#include "front/cam_profile.hpp"
#include "higherpair/higherpair.hpp"

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::shipped_model;
using testing::text_of;

constexpr int kThreads = 4;

void on_threads(const std::function<void(int)>& work) {
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back(work, i);
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
}

class OneModel : public ::testing::TestWithParam<const char*> {};

TEST_P(OneModel, RunsOnSeveralThreadsAsOnOne) {
  const Model model = shipped_model(GetParam());
  RunSettings settings;
  settings.samples = 46;
  settings.forces = has_forces(model.mechanism());
  const std::string alone = text_of(model.run(settings).value());
  std::atomic<int> equal = 0;
  on_threads([&](int) {
    for (int pass = 0; pass < 3; ++pass) {
      equal += text_of(model.run(settings).value()) == alone ? 1 : 0;
    }
  });
  EXPECT_EQ(equal, 3 * kThreads);
}

TEST_P(OneModel, IsChangedOnSeveralThreads) {
  const Model model = shipped_model(GetParam());
  const auto run = [&](int i) {
    RunSettings settings;
    settings.samples = 7 + i;
    const auto variant = model.with({{"gravity", "[0, -9.81]"}});
    return variant ? text_of(variant->run(settings).value()) : to_string(variant.error());
  };
  std::vector<std::string> alone;
  for (int i = 0; i < kThreads; ++i) alone.push_back(run(i));
  std::vector<std::string> together(kThreads);
  on_threads([&](int i) { together[i] = run(i); });
  EXPECT_EQ(together, alone);
}

INSTANTIATE_TEST_SUITE_P(Shipped, OneModel,
                         ::testing::Values("four_bar", "watt_sixbar_forces", "ellipse_cam_roller", "five_bar",
                                           "spline_cam", "law_cam_roller", "rolling_ellipses", "four_arc_cam",
                                           "planetary_gear", "quick_return"));

TEST(SweepOnThreads, WorksOutTheSameBlocks) {
  const Model model = shipped_model("tolerance_study", {"sweep.count=64", "driver.samples=19"});
  const Sweep sweep = Sweep::of(model).value();
  const std::vector<double> alone = sweep.block(0).values;
  std::atomic<int> equal = 0;
  on_threads([&](int) { equal += sweep.block(0).values == alone ? 1 : 0; });
  EXPECT_EQ(equal, kThreads);
}

}  // namespace
}  // namespace higherpair

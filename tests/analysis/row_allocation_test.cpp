// After the first row a running analysis allocates no heap memory.
#include "analysis/counting_allocator.hpp"
#include "higherpair/analysis/dyad_chain.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/higherpair.hpp"
#include "higherpair/io/profile_reader.hpp"

#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::allocation_count;

constexpr int kTurnRows = 3600;

class RowAllocation : public ::testing::TestWithParam<const char*> {
protected:
  Profile profile =
      read_profile_file(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + GetParam() + ".toml").value();
  higherpair::Run run = start_run(profile.mechanism, {0}).value();
};

TEST_P(RowAllocation, RowsOfTheTableAndTheirTextMakeNone) {
  RunSettings settings;
  settings.samples = kTurnRows;
  const Model model = Model::from(profile.mechanism, profile.units, profile.programs).value();
  Analysis analysis = model.start(settings).value();
  Row row;
  std::string text;
  text.reserve(1 << 16);
  std::size_t made = 0;
  std::size_t events = 0;
  for (int k = 0; k < kTurnRows; ++k) {
    const std::size_t before = allocation_count();
    ASSERT_TRUE(analysis.next(row));
    text.clear();
    append_csv_row(analysis.columns(), row, text);
    // The text of an event is allocated.
    made += k == 0 || analysis.events().size() > events ? 0 : allocation_count() - before;
    events = analysis.events().size();
    ASSERT_EQ(row.status, RowStatus::kOk);
  }
  EXPECT_EQ(made, 0U);
}

TEST_P(RowAllocation, MovingTheMechanismMakesNone) {
  std::size_t made = 0;
  for (int k = 0; k < kTurnRows; ++k) {
    const std::vector<DriverMotion> drivers{{2 * kPi * k / kTurnRows, 1, 0.5}};
    const std::size_t before = allocation_count();
    move_to(run, drivers);
    // The text of an event is allocated.
    made += k == 0 || !run.events.empty() ? 0 : allocation_count() - before;
    ASSERT_EQ(run.row.status, RowStatus::kOk);
  }
  EXPECT_EQ(made, 0U);
}

TEST(ForceAllocation, BalancingDyadsAndPairsMakesNone) {
  for (const auto& [name, start] :
       {std::pair("watt_sixbar_forces", 135 * kPi / 180), std::pair("cam_with_return_spring", 0.0)}) {
    const Profile profile =
        read_profile_file(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + name + ".toml").value();
    higherpair::Run run = start_run(profile.mechanism, {start}).value();
    InverseDynamics dynamics(run);
    std::size_t made = 0;
    for (int k = 0; k < kTurnRows; ++k) {
      const std::vector<DriverMotion> drivers{{start + 2 * kPi * k / kTurnRows, 1, 0.5}};
      move_to(run, drivers);
      const std::size_t before = allocation_count();
      const Reactions& reactions = dynamics.solve(run);
      made += k == 0 ? 0 : allocation_count() - before;
      ASSERT_TRUE(reactions.defined);
    }
    EXPECT_EQ(made, 0U) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Profiles, RowAllocation,
                         ::testing::Values("eccentric_disc_oscillating_roller", "ellipse_cam_roller",
                                           "flat_faced_oscillating", "flat_faced_translating",
                                           "rolling_ellipses"),
                         [](const auto& test) { return std::string(test.param); });

TEST(ChainAllocation, FurtherVariantsOfALinkageTakeNone) {
  for (const char* name : {"four_bar", "slider_crank", "watt_sixbar"}) {
    const std::string path = std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + name + ".toml";
    const Profile profile = read_profile_file(path).value();
    std::vector<DriverMotion> rows;
    for (int k = 0; k < kTurnRows; ++k) {
      rows.push_back({2 * kPi * k / kTurnRows, 1, 0});
    }
    Mechanism mechanism = profile.mechanism;
    mechanism.bodies[2].mass = MassProperties{1, Vector2d(0.01, 0), 1e-3};
    mechanism.loads.push_back({"load", 3, Vector2d(0.01, 0), Vector2d(3, 4), 0.1, LoadFrame::kBody});
    auto chain = DyadChain::of(mechanism, make_plan(mechanism).value(), rows,
                               {{2, std::nullopt, ChainColumn::Quantity::kAngle},
                                {3, 0, ChainColumn::Quantity::kAx},
                                {0, std::nullopt, ChainColumn::Quantity::kEffort}});
    ASSERT_TRUE(chain) << name;
    ASSERT_TRUE(chain->solve(mechanism)) << name;
    mechanism.bodies[1].points[1].p_B *= 1.01;
    const std::size_t before = allocation_count();
    const bool proven = chain->solve(mechanism);
    EXPECT_EQ(allocation_count() - before, 0U) << name;
    EXPECT_TRUE(proven) << name;
  }
}

}  // namespace
}  // namespace higherpair

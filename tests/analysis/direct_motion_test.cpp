// Positions in closed form compared with runs that follow the motion, and the gaps of dyads that cannot be
// closed.
#include "higherpair/analysis/direct_motion.hpp"

#include "analysis/run_testing.hpp"
#include "higherpair/io/driver_schedule.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::shipped;

TEST(DirectMotions, HaveThePositionsOfTheRun) {
  for (const char* name : {"four_bar", "slider_crank", "watt_sixbar", "sixbar_slider", "straight_line"}) {
    SCOPED_TRACE(name);
    const Profile profile = shipped(name);
    const DriverSchedule schedule = DriverSchedule::analyze(profile, 40).value();
    const Mechanism& mechanism = profile.mechanism;
    auto run = start_run(mechanism, schedule.first_positions());
    ASSERT_TRUE(run);
    ASSERT_TRUE(DirectMotion::is_possible(run->plan()));
    DirectMotion direct(mechanism, run->plan(), branch_of(*run));
    int compared = 0;
    for (std::int64_t k = 0; k < schedule.size(); ++k) {
      const DriverMotion motion{schedule.state(k).si.position, 1.3, -0.4};
      move_to(*run, {motion});
      if (run->row.status != RowStatus::kOk) continue;
      ++compared;
      ASSERT_TRUE(direct.move_to({motion}, true)) << k;
      for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        const BodyMotion& ours = direct.bodies()[i];
        const BodyMotion& theirs = run->row.bodies[i];
        EXPECT_NEAR((ours.X_WB.p_WB - theirs.X_WB.p_WB).norm(), 0, 1e-12 * run->plan().size);
        EXPECT_NEAR(std::remainder(ours.theta - theirs.theta, 2 * kPi), 0, 1e-12);
        EXPECT_NEAR((ours.v_WB - theirs.v_WB).norm(), 0, 1e-10 * (run->plan().size + theirs.v_WB.norm()));
        EXPECT_NEAR(ours.alpha, theirs.alpha, 1e-9 * (1 + std::abs(theirs.alpha)));
      }
    }
    EXPECT_GT(compared, 10);
  }
}

TEST(DirectMotion, IsNotPossibleWithContacts) {
  EXPECT_FALSE(DirectMotion::is_possible(make_plan(shipped("ellipse_cam_roller").mechanism).value()));
}

TEST(ClosureGap, OfAFourBarIsWhatItsLinksAreShortOf) {
  Mechanism mechanism = shipped("straight_line").mechanism;  // sides 1, 2, 2.5, 2.5 cm
  const Plan plan = make_plan(mechanism).value();
  DirectMotion motion(mechanism, plan, 0);
  const auto gap = [](const DirectMotion& at) {
    double largest = -1;
    for (const auto& one : at.gaps()) largest = one ? std::max(largest, *one) : largest;
    return largest;
  };
  // With the crank on the line of pivots |O4 A| is 3 cm and 1 cm: 2 cm short of 5 cm, and 1 cm more than 0.
  EXPECT_TRUE(motion.move_to({{kPi, 0, 0}}, false));
  EXPECT_NEAR(gap(motion), -0.02, 1e-15);
  EXPECT_TRUE(motion.move_to({{0, 0, 0}}, false));
  EXPECT_NEAR(gap(motion), -0.01, 1e-15);
  // With a rocker of 0.2 cm the links reach 2.7 cm, 0.3 cm too little; and their difference, 2.3 cm, is 1.3
  // cm more than 1 cm.
  mechanism.bodies[3].points[1].p_B = {0.002, 0};
  DirectMotion stuck(mechanism, redimensioned(plan, mechanism), 0);
  EXPECT_FALSE(stuck.move_to({{kPi, 0, 0}}, false));
  EXPECT_NEAR(gap(stuck), 0.003, 1e-15);
  EXPECT_FALSE(stuck.move_to({{0, 0, 0}}, false));
  EXPECT_NEAR(gap(stuck), 0.013, 1e-15);
}

TEST(Branches, OfARunStartedOnThemAreTheirs) {
  const Profile profile = shipped("watt_sixbar");
  const DriverSchedule schedule = DriverSchedule::analyze(profile).value();
  const Plan plan = make_plan(profile.mechanism).value();
  ASSERT_EQ(branch_count(plan), 4);
  int started = 0;
  for (int branch = 0; branch < 4; ++branch) {
    const auto run =
        start_on_branch(make_run_model(profile.mechanism, plan), schedule.first_positions(), branch);
    if (!run) continue;
    ++started;
    EXPECT_EQ(branch_of(*run), branch);
  }
  EXPECT_GE(started, 2);
}

}  // namespace
}  // namespace higherpair

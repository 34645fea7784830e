#include "contact/oracle_case.hpp"
#include "contact/pair_follower.hpp"
#include "geometry/geometry_testing.hpp"
#include "higherpair/contact/finder.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::kDegree;
using testing::noise;
using testing::OracleCase;

FollowedContact started(const OracleCase& reference) {
  const double u = reference.data.at("th1_start_deg").get<double>() * kDegree;
  const FindResult found = find_nearest_contact(reference.pair, u, reference.data.at("start").at("q2_near"));
  EXPECT_EQ(found.status, FindStatus::kFound);
  return start_track(reference.pair, found.at, found.branch);
}

TEST(TrackerOracle, FollowsTheContactThroughAllRows) {
  for (const OracleCase& reference : testing::oracle_cases()) {
    SCOPED_TRACE(reference.id);
    FollowedContact track = started(reference);
    for (const auto& row : reference.data.at("rows")) {
      SCOPED_TRACE(row.at("th1_deg").dump());
      ASSERT_EQ(follow_to(track, row.at("th1")).status, TrackStatus::kOk);
      const double q = row.at("q2");
      const double dq = row.at("dq2");
      const double d2q = row.at("d2q2");
      EXPECT_LE(std::abs(track.at.q - q), 1e-13 * std::max(1.0, std::abs(q)) + noise(row, 0));
      EXPECT_LE(std::abs(track.at.dq - dq), 1e-12 * std::max(1.0, std::abs(dq)) + noise(row, 1));
      EXPECT_LE(std::abs(track.at.d2q - d2q), 1e-11 * std::max(1.0, std::abs(d2q)) + noise(row, 2));
    }
  }
}

TEST(TrackerOracle, FindsTheSameWithAHundredTimesMoreRows) {
  for (const OracleCase& reference : testing::oracle_cases()) {
    SCOPED_TRACE(reference.id);
    FollowedContact coarse = started(reference);
    FollowedContact fine = coarse;
    double from = coarse.at.u;
    for (const auto& row : reference.data.at("rows")) {
      const double to = row.at("th1");
      for (int i = 1; i <= 100; ++i) {
        ASSERT_EQ(follow_to(fine, i == 100 ? to : from + (to - from) * i / 100).status, TrackStatus::kOk);
      }
      ASSERT_EQ(follow_to(coarse, to).status, TrackStatus::kOk);
      EXPECT_LE(std::abs(fine.at.q - coarse.at.q), 1e-14 * (1 + std::abs(coarse.at.q)) + noise(row, 0));
      EXPECT_LE(std::abs(fine.phi - coarse.phi), 1e-13 + 20 * noise(row, 0));
      from = to;
    }
  }
}

TEST(Tracker, LocatesTheLimitPositionAndTakesTheBranchUpAgainBeyondTheGap) {
  for (const OracleCase& reference : testing::oracle_cases()) {
    if (!reference.data.contains("limits")) {
      continue;
    }
    FollowedContact track = started(reference);
    const double limit = reference.data.at("limits").at("th1_max");
    const TrackResult lost = follow_to(track, 1.9);
    ASSERT_EQ(lost.status, TrackStatus::kNotAssemblable);
    ASSERT_TRUE(lost.limit.has_value());
    EXPECT_LE(std::abs(lost.limit->u - limit), 1e-14);
    EXPECT_EQ(follow_to(track, kPi).status, TrackStatus::kNotAssemblable);
    const TrackResult resumed = follow_to(track, 2 * kPi - 0.3);
    ASSERT_EQ(resumed.status, TrackStatus::kOk);
    ASSERT_TRUE(resumed.limit.has_value());
    EXPECT_LE(std::abs(resumed.limit->u - (2 * kPi - limit)), 1e-14);
  }
}

}  // namespace
}  // namespace higherpair

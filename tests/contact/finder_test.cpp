#include "higherpair/contact/finder.hpp"

#include "contact/oracle_case.hpp"
#include "geometry/geometry_testing.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::kDegree;
using testing::OracleCase;

TEST(FinderOracle, FindsTheContactByMovingTheFollowerUntilItTouches) {
  for (const OracleCase& reference : testing::oracle_cases()) {
    SCOPED_TRACE(reference.id);
    const nlohmann::json& start = reference.data.at("start");
    const double u = reference.data.at("th1_start_deg").get<double>() * kDegree;
    const FindResult found = find_contact(reference.pair, u, start.at("approach").at("q_start"),
                                          start.at("approach").at("direction"));
    ASSERT_EQ(found.status, FindStatus::kFound);
    const double q = start.at("q2_near");
    EXPECT_LE(std::abs(found.at.q - q), 2e-8 * std::max(1.0, std::abs(q)));
    EXPECT_LE((found.at.p1_W - testing::vector_of(start.at("P_near"))).norm(),
              2e-7 * (1 + found.at.p1_W.norm()));
  }
}

TEST(FinderOracle, FindsTheContactNearestToARoughPose) {
  for (const OracleCase& reference : testing::oracle_cases()) {
    SCOPED_TRACE(reference.id);
    const nlohmann::json& start = reference.data.at("start");
    const double u = reference.data.at("th1_start_deg").get<double>() * kDegree;
    const double q = start.at("q2_near");
    for (const double off : {-0.05, -1e-6, 0.0, 1e-6, 0.05}) {
      const FindResult found = find_nearest_contact(reference.pair, u, q + off);
      ASSERT_EQ(found.status, FindStatus::kFound) << off;
      EXPECT_LE(std::abs(found.at.q - q), 2e-8 * std::max(1.0, std::abs(q))) << off;
    }
  }
}

}  // namespace
}  // namespace higherpair

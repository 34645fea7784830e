#include "contact/oracle_case.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::noise;
using testing::OracleCase;

// The sensitivity of the answers to one rounding of the inputs is added to every tolerance. The guess is 1e-3
// rad off in the normal and 1e-3 in the follower's coordinate.
TEST(ContactOracle, IsFoundFromAGuessNearby) {
  for (const OracleCase& reference : testing::oracle_cases()) {
    SCOPED_TRACE(reference.id);
    for (const auto& row : reference.data.at("rows")) {
      const double u = row.at("th1");
      const double q = row.at("q2");
      const Vector2d n = testing::vector_of(row.at("n"));
      const Vector2d p = testing::vector_of(row.at("P"));
      const int branch = velocity_per_q(reference.pair.motion2, p).dot(n) > 0 ? 1 : -1;
      const Vector2d n_guess = Rotation<double>::from_angle(1e-3) * n;
      const ContactResult result = solve_contact(reference.pair, u, q + 1e-3 * branch, n_guess, branch);
      SCOPED_TRACE(reference.id + " at " + std::to_string(u));
      ASSERT_EQ(result.status, ContactStatus::kOk);
      const double dq = row.at("dq2");
      const double d2q = row.at("d2q2");
      EXPECT_LE(std::abs(result.at.q - q), 1e-13 * std::max(1.0, std::abs(q)) + noise(row, 0));
      EXPECT_LE(std::abs(result.at.dq - dq), 1e-12 * std::max(1.0, std::abs(dq)) + noise(row, 1));
      EXPECT_LE(std::abs(result.at.d2q - d2q), 1e-11 * std::max(1.0, std::abs(d2q)) + noise(row, 2));
      EXPECT_LE((result.at.n_W - n).norm(), 1e-12 + noise(row, 0));
      EXPECT_LE((result.at.p1_W - p).norm(), 1e-12 * p.norm() + 100 * noise(row, 0));
      EXPECT_LE((result.at.p2_W - result.at.p1_W).norm(), 1e-12 * p.norm());
      const double omega1 = reference.data.at("omega1");
      const double sliding = row.at("v_slide");
      EXPECT_LE(std::abs(result.at.sliding * omega1 - sliding),
                1e-11 * (std::abs(sliding) + p.norm()) + 1e3 * noise(row, 1));
    }
  }
}

}  // namespace
}  // namespace higherpair

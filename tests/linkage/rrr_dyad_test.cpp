#include "linkage/four_bar_motion.hpp"
#include "linkage/moving_ends.hpp"
#include "linkage/rrr_motion.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

/// The Watt six-bar of the reference data: a four-bar A B C E, and a dyad from the point H of its rocker to
/// F.
class WattSixBar : public ::testing::Test {
protected:
  nlohmann::json data = read_data("watt_sixbar.json");
  nlohmann::json geometry = data["geometry"];
  FourBar loop{length("E"), length("AB"), length("BC"), length("CE"), 0};

  double length(const char* name) const {
    const auto& value = geometry[name];
    return value.is_array() ? number(value[0]) : number(value);  // points lie on the x axis
  }

  /// C to the left of the line from B to E is σ = -1 of the four-bar.
  FourBarMotion first_loop(double theta2_deg, int s1) const {
    return four_bar_by_crank(loop, {theta2_deg * kDegree, 1, 0}, mode_of(-s1));
  }

  PointMotion motion_of_H(const FourBarMotion& first) const {
    const BodyMotion rocker{{Rotation<double>::from_angle(first.theta4), Vector2d(length("E"), 0)},
                            first.theta4,
                            Vector2d::Zero(),
                            first.rates->omega4,
                            Vector2d::Zero(),
                            first.rates->alpha4};
    return point_motion(rocker, length("EH") * unit_vector(-number(geometry["angle_CEH_rad"])));
  }
};

TEST_F(WattSixBar, BothLoopsAgreeWithTheReferenceOverTheWholeTurn) {
  int rows = 0;
  Worst angle, omega, alpha, place;
  for (const auto& branch : data["branches"]) {
    if (!branch["full_rotation"]) continue;
    for (const auto& row : branch["rows"]) {
      const FourBarMotion first = first_loop(number(row["theta2_deg"]), branch["s1"]);
      ASSERT_TRUE(first.rates);
      angle.see(angle_error(first.theta3, number(row["theta3"])));
      angle.see(angle_error(first.theta4 + kPi, number(row["theta4"])));
      omega.see(std::abs(first.rates->omega3 - number(row["omega3"])));
      omega.see(std::abs(first.rates->omega4 - number(row["omega4"])));
      alpha.see(std::abs(first.rates->alpha3 - number(row["alpha3"])));
      alpha.see(std::abs(first.rates->alpha4 - number(row["alpha4"])));

      const PointMotion H = motion_of_H(first);
      const PointMotion F{Vector2d(length("F"), 0), Vector2d::Zero(), Vector2d::Zero()};
      const RrrMotion second = rrr_dyad(H, F, length("DH"), length("DF"), mode_of(branch["s2"]));
      ASSERT_TRUE(second.rates);
      for (int i = 0; i < 2; ++i) {
        place.see(std::abs(H.p_W[i] - number(row["H"][i])));
        place.see(std::abs(second.p_WC[i] - number(row["D"][i])));
      }
      angle.see(angle_error(angle_of(second.u_a) + kPi, number(row["theta5"])));
      angle.see(angle_error(angle_of(second.u_b) + kPi, number(row["theta6"])));
      omega.see(std::abs(second.rates->omega_a - number(row["omega5"])));
      omega.see(std::abs(second.rates->omega_b - number(row["omega6"])));
      alpha.see(std::abs(second.rates->alpha_a - number(row["alpha5"])));
      alpha.see(std::abs(second.rates->alpha_b - number(row["alpha6"])));
      ++rows;
    }
  }
  EXPECT_EQ(rows, 74);
  EXPECT_AT_MOST(angle.value(), 4e-15);
  EXPECT_AT_MOST(place.value(), 4e-16);
  EXPECT_AT_MOST(omega.value(), 1e-14);
  EXPECT_AT_MOST(alpha.value(), 2e-14);
}

TEST_F(WattSixBar, OtherAssemblyOfTheFirstLoopStopsWhereTheReferenceSays) {
  int rows = 0;
  for (const auto& branch : data["branches"]) {
    if (branch["full_rotation"]) continue;
    for (const auto& row : branch["rows"]) {
      if (!row.contains("assembles")) continue;
      const FourBarMotion first = first_loop(number(row["theta2_deg"]), branch["s1"]);
      bool assembles = first.status == LinkageStatus::kOk;
      if (assembles) {
        const PointMotion F{Vector2d(length("F"), 0), Vector2d::Zero(), Vector2d::Zero()};
        assembles =
            rrr_dyad(motion_of_H(first), F, length("DH"), length("DF"), mode_of(branch["s2"])).status ==
            LinkageStatus::kOk;
      }
      EXPECT_EQ(assembles, row["assembles"].get<bool>()) << row["theta2_deg"];
      ++rows;
    }
  }
  EXPECT_GT(rows, 0);
}

TEST(RrrDyad, JoinsTwoMovingPointsAndMovesByTheDerivatives) {
  Random random(51);
  Worst closure;
  RatesCheck check;
  while (check.count() < 4000) {
    const MovingPoint A = random_point(random), B = random_point(random);
    const double a = random.between(0.2, 2), b = random.between(0.2, 2);
    const AssemblyMode mode = mode_of(check.count() % 2 == 0 ? 1 : -1);
    const RrrMotion motion = rrr_dyad(A.at(0), B.at(0), a, b, mode);
    if (motion.status != LinkageStatus::kOk) continue;
    const Vector2d u_a = vector_of(motion.u_a), u_b = vector_of(motion.u_b);
    const Vector2d p_A = A.at(0).p_W, p_B = B.at(0).p_W;
    closure.see((p_A + a * u_a - p_B - b * u_b).norm());
    closure.see((p_A + a * u_a - motion.p_WC).norm());
    EXPECT_GT(sign(mode) * cross<double>(p_B - p_A, motion.p_WC - p_A), 0);
    if (std::abs(cross(u_a, u_b)) < 0.5) continue;

    const auto values_at = [&](double t) {
      const RrrMotion there = rrr_dyad(A.at(t), B.at(t), a, b, mode);
      return std::array<double, 4>{angle_of(there.u_a), angle_of(there.u_b), there.p_WC.x(), there.p_WC.y()};
    };
    const RrrMotion::Rates& rates = motion.rates.value();
    check.compare<4>(values_at, {true, true, false, false},
                     {rates.omega_a, rates.omega_b, rates.v_WC.x(), rates.v_WC.y()},
                     {rates.alpha_a, rates.alpha_b, rates.a_WC.x(), rates.a_WC.y()});
  }
  EXPECT_AT_MOST(closure.value(), 1e-14);
  check.expect_small();
}

TEST(RrrDyad, TellsEachStatus) {
  const auto fixed = [](double x, double y) { return PointMotion{{x, y}, {1, 2}, {3, 4}}; };
  const AssemblyMode mode = AssemblyMode::kPlus;
  EXPECT_EQ(rrr_dyad(fixed(0, 0), fixed(3, 4), 2.9, 2.3, mode).status, LinkageStatus::kOk);
  EXPECT_EQ(rrr_dyad(fixed(0, 0), fixed(3, 4), 2.6, 2.3, mode).status, LinkageStatus::kNotAssemblable);
  EXPECT_EQ(rrr_dyad(fixed(0, 0), fixed(3, 4), 8.1, 2.3, mode).status, LinkageStatus::kNotAssemblable);
  for (const auto& [a, b] : {std::pair{2.7, 2.3}, std::pair{7.3, 2.3}}) {
    const RrrMotion motion = rrr_dyad(fixed(0, 0), fixed(3, 4), a, b, mode);
    EXPECT_EQ(motion.status, LinkageStatus::kSingular);
    EXPECT_FALSE(motion.rates);
    EXPECT_AT_MOST((motion.p_WC - a * Vector2d(0.6, 0.8)).norm(), 4e-15);
  }
  const RrrMotion coincident = rrr_dyad(fixed(1, 2), fixed(1, 2), 1.3, 1.3, mode);
  EXPECT_EQ(coincident.status, LinkageStatus::kSingular);
  EXPECT_AT_MOST((coincident.p_WC - Vector2d(1, 3.3)).norm(), 1e-15);
  EXPECT_EQ(rrr_dyad(fixed(1, 2), fixed(1, 2), 1.3, 1.4, mode).status, LinkageStatus::kNotAssemblable);
}

// Where the coordinates are large, lengths as short as these are differences of roundings.
TEST(RrrDyad, FarFromTheOriginIsAtItsLimitToWithinTheRoundingOfItsPlace) {
  for (const double x : {1e4 / 3, 1e6 / 3, 1e8 / 3}) {
    for (const double d : {1.1, 1.3, 1.7, 2.3}) {
      const PointMotion A{{x, 2 * x}, {1, 2}, {3, 4}}, B{{x + d, 2 * x}, {1, 2}, {3, 4}};
      EXPECT_EQ(rrr_dyad(A, B, 0.6 * d, 0.4 * d, AssemblyMode::kPlus).status, LinkageStatus::kSingular);
      EXPECT_EQ(rrr_dyad(A, B, 1.6 * d, 0.6 * d, AssemblyMode::kPlus).status, LinkageStatus::kSingular);
    }
  }
}

TEST(RrrDyad, AShortLinkStillHasAUnitDirection) {
  Random random(52);
  for (int i = 0; i < 1000; ++i) {
    const double a = std::pow(10.0, random.between(-7, -1));
    const Vector2d D = unit_vector(random.angle());
    const Reach<double> reach = rrr_reach(D, a, 1.0, 1.0);
    if (status_of(reach) != LinkageStatus::kOk) continue;
    const RrrPosition<double> position = rrr_position(D, a, 1.0, reach, 1.0);
    EXPECT_AT_MOST(std::abs(std::hypot(position.u_a.cos, position.u_a.sin) - 1), 1e-14);
  }
}

}  // namespace
}  // namespace higherpair

#include "higherpair/linkage/instant_centers.hpp"

#include "linkage/four_bar_motion.hpp"
#include "linkage/moving_ends.hpp"
#include "linkage/rrr_motion.hpp"
#include "linkage/slider_crank.hpp"

#include <Eigen/LU>

namespace higherpair {
namespace {

using namespace higherpair::testing;

/// A link with its origin at a moving point.
BodyMotion link_at(const PointMotion& origin, double theta, double omega, double alpha) {
  return {{Rotation<double>::from_angle(theta), origin.p_W}, theta, origin.v_W, omega, origin.a_W, alpha};
}

/// Ground and links 2, 3, 4 of a four-bar with O2 at the origin.
std::vector<BodyMotion> bodies_of(const FourBar& linkage, const FourBarMotion& motion) {
  const FourBarRates& rates = motion.rates.value();
  const BodyMotion crank = link_at(PointMotion{}, motion.theta2, rates.omega2, rates.alpha2);
  const PointMotion A = point_motion(crank, Vector2d(linkage.r2, 0));
  const PointMotion O4{linkage.r1 * unit_vector(linkage.theta1), Vector2d::Zero(), Vector2d::Zero()};
  return {BodyMotion{}, crank, link_at(A, motion.theta3, rates.omega3, rates.alpha3),
          link_at(O4, motion.theta4, rates.omega4, rates.alpha4)};
}

const InstantCenter& find(const std::vector<InstantCenter>& centers, std::size_t i, std::size_t j) {
  for (const InstantCenter& center : centers) {
    if (center.i == i && center.j == j) return center;
  }
  throw std::logic_error("no such pair");
}

/// Distance of the middle one of three points from the line through the outer two, relative to their
/// distance. If one centre is a direction: deviation of the line through the other two from that direction.
double off_line(const InstantCenter& a, const InstantCenter& b, const InstantCenter& c) {
  const auto row = [](const InstantCenter& center) {
    const bool point = center.kind == InstantCenterKind::kPoint;
    const Vector2d& p = point ? center.p_W : center.u_W;
    return Eigen::Vector3d(p.x(), p.y(), point ? 1 : 0);
  };
  Eigen::Matrix3d rows;
  rows << row(a).normalized(), row(b).normalized(), row(c).normalized();
  return std::abs(rows.determinant());
}

double worst_triple(const std::vector<InstantCenter>& centers, std::size_t bodies) {
  Worst worst;
  for (std::size_t i = 0; i < bodies; ++i) {
    for (std::size_t j = i + 1; j < bodies; ++j) {
      for (std::size_t k = j + 1; k < bodies; ++k) {
        worst.see(off_line(find(centers, i, j), find(centers, j, k), find(centers, i, k)));
      }
    }
  }
  return worst.value();
}

TEST(InstantCenters, OfAFourBarAreItsPivotsAndTheCrossingsOfItsSides) {
  Random random(121);
  int count = 0;
  while (count < 2000) {
    const FourBar linkage{random.between(0.5, 2), random.between(0.5, 2), random.between(0.5, 2),
                          random.between(0.5, 2), random.angle()};
    const auto motion = four_bar_by_crank(linkage, {random.angle(), 1.3, 0.4}, AssemblyMode::kPlus);
    if (!motion.rates || std::abs(std::sin(motion.theta3 - motion.theta4)) < 0.3 ||
        std::abs(std::sin(motion.theta2 - motion.theta4)) < 0.3 ||
        std::abs(std::sin(motion.theta3 - linkage.theta1)) < 0.3) {
      continue;
    }
    const std::vector<BodyMotion> bodies = bodies_of(linkage, motion);
    const std::vector<InstantCenter> centers = instant_centers(bodies, 1);
    ASSERT_EQ(centers.size(), 6U);
    ++count;
    const Vector2d A = bodies[2].X_WB.p_WB, O4 = bodies[3].X_WB.p_WB;
    const Vector2d B = O4 + linkage.r4 * unit_vector(motion.theta4);
    const auto crossing = [](const Vector2d& p, double along_p, const Vector2d& q, double along_q) {
      const Vector2d u = unit_vector(along_p), v = unit_vector(along_q);
      return Vector2d(p + cross<double>(q - p, v) / cross(u, v) * u);
    };
    const auto error = [&](std::size_t i, std::size_t j, const Vector2d& expected) {
      const InstantCenter& center = find(centers, i, j);
      return center.kind == InstantCenterKind::kPoint ? (center.p_W - expected).norm() : 1e9;
    };
    EXPECT_AT_MOST(error(0, 1, Vector2d::Zero()), 1e-15);
    EXPECT_AT_MOST(error(1, 2, A), 1e-12);
    EXPECT_AT_MOST(error(2, 3, B), 1e-12);
    EXPECT_AT_MOST(error(0, 3, O4), 1e-15);
    EXPECT_AT_MOST(error(0, 2, crossing(A, motion.theta2, B, motion.theta4)), 1e-12);
    EXPECT_AT_MOST(error(1, 3, crossing(Vector2d::Zero(), linkage.theta1, A, motion.theta3)), 1e-12);
    EXPECT_AT_MOST(worst_triple(centers, 4), 1e-12);
  }
}

TEST(InstantCenters, OfEveryThreeBodiesOfASixBarLieOnALine) {
  Random random(122);
  Worst worst;
  int count = 0;
  while (count < 1000) {
    const FourBar linkage{random.between(0.5, 2), random.between(0.5, 2), random.between(0.5, 2),
                          random.between(0.5, 2), random.angle()};
    const auto motion = four_bar_by_crank(linkage, {random.angle(), 1.3, 0.4}, AssemblyMode::kMinus);
    if (!motion.rates || std::abs(std::sin(motion.theta3 - motion.theta4)) < 0.3) continue;
    std::vector<BodyMotion> bodies = bodies_of(linkage, motion);
    const PointMotion C = point_motion(bodies[2], random_vector(random));
    const PointMotion D{random_vector(random, 2), Vector2d::Zero(), Vector2d::Zero()};
    const double c = random.between(0.5, 2), d = random.between(0.5, 2);
    const RrrMotion dyad = rrr_dyad(C, D, c, d, AssemblyMode::kPlus);
    if (!dyad.rates || std::abs(cross(vector_of(dyad.u_a), vector_of(dyad.u_b))) < 0.3) continue;
    bodies.push_back(link_at(C, angle_of(dyad.u_a), dyad.rates->omega_a, dyad.rates->alpha_a));
    bodies.push_back(link_at(D, angle_of(dyad.u_b), dyad.rates->omega_b, dyad.rates->alpha_b));
    const std::vector<InstantCenter> centers = instant_centers(bodies, 1);
    ASSERT_EQ(centers.size(), 15U);
    worst.see(worst_triple(centers, 6));
    ++count;
  }
  // Two bodies may happen to turn almost equally (to 1e-3 of the fastest); then their centre is far away and
  // less accurate.
  EXPECT_AT_MOST(worst.value(), 1e-11);
}

TEST(InstantCenters, OfASliderLieAtInfinityAcrossItsGuide) {
  const SliderCrank linkage{0.6, 1.7, 0.3, 0.4};
  const auto motion = slider_crank_by_crank(linkage, {1.1, 1.3, 0}, AssemblyMode::kPlus);
  const BodyMotion crank = turning({1.1, 1.3, 0});
  const PointMotion A = point_motion(crank, Vector2d(linkage.r2, 0));
  BodyMotion slider;
  slider.v_WB = motion.rates.value().r1_dot * unit_vector(linkage.theta1);
  slider.X_WB.p_WB = A.p_W + linkage.r3 * unit_vector(motion.theta3);
  const std::vector<BodyMotion> bodies{BodyMotion{}, crank,
                                       link_at(A, motion.theta3, motion.rates->omega3, 0), slider};
  const std::vector<InstantCenter> centers = instant_centers(bodies, 1);
  const InstantCenter& on_guide = find(centers, 0, 3);
  EXPECT_EQ(on_guide.kind, InstantCenterKind::kAtInfinity);
  EXPECT_AT_MOST(std::abs(on_guide.u_W.dot(unit_vector(linkage.theta1))), 1e-15);
  EXPECT_AT_MOST(std::abs(on_guide.u_W.norm() - 1), 1e-15);
  EXPECT_AT_MOST((find(centers, 2, 3).p_W - slider.X_WB.p_WB).norm(), 1e-14);
  EXPECT_AT_MOST(worst_triple(centers, 4), 1e-14);
}

TEST(InstantCenters, OfAParallelogramAreAtInfinityWhereItsBodiesTurnAlike) {
  const FourBar linkage{0.31, 0.17, 0.31, 0.17, 0.2};
  const auto motion = four_bar_by_crank(linkage, {1.4, 2.3, 0}, AssemblyMode::kMinus);
  const auto centers = instant_centers(bodies_of(linkage, motion), 1);
  EXPECT_EQ(find(centers, 0, 2).kind, InstantCenterKind::kAtInfinity);
  EXPECT_EQ(find(centers, 1, 3).kind, InstantCenterKind::kAtInfinity);
  EXPECT_EQ(find(centers, 0, 1).kind, InstantCenterKind::kPoint);
  // Coupler and ground: along the cranks; crank and crank: along the frame.
  EXPECT_AT_MOST(std::abs(cross(find(centers, 0, 2).u_W, unit_vector(1.4))), 1e-14);
  EXPECT_AT_MOST(std::abs(cross(find(centers, 1, 3).u_W, unit_vector(0.2))), 1e-14);
  EXPECT_AT_MOST(worst_triple(centers, 4), 1e-14);
}

TEST(InstantCenters, AreUndefinedForBodiesThatMoveAsOne) {
  Random random(123);
  const BodyMotion body = random_body(random).at(0);
  const PointMotion other = point_motion(body, Vector2d(0.7, -0.4));
  const std::vector<BodyMotion> bodies{BodyMotion{}, body, link_at(other, 0.3, body.omega, body.alpha)};
  const auto centers = instant_centers(bodies, 1);
  EXPECT_EQ(find(centers, 1, 2).kind, InstantCenterKind::kUndefined);
  EXPECT_AT_MOST((find(centers, 0, 1).p_W - find(centers, 0, 2).p_W).norm(), 1e-14);
  // The rounding of a body that only slides does not count as rotation.
  std::vector<BodyMotion> sliding(2);
  sliding[1].v_WB = {0, 1};
  sliding[1].omega = 1e-15;
  const InstantCenter far = instant_centers(sliding, 0.1)[0];
  EXPECT_EQ(far.kind, InstantCenterKind::kAtInfinity);
  EXPECT_EQ(std::abs(far.u_W.x()), 1);
  // Neither does that of a lever at its dead point, wherever the frame of a body at rest is, nor that of two
  // bodies that turn alike about points much nearer to each other than the size.
  std::vector<BodyMotion> resting(3);
  resting[0].omega = 1;
  resting[1] = link_at({{1, 0}, {0, 0}, {0, 0}}, 0, 1e-16, 0);
  resting[2].X_WB.p_WB = {2, 0};
  EXPECT_EQ(find(instant_centers(resting, 1), 1, 2).kind, InstantCenterKind::kUndefined);
  std::vector<BodyMotion> alike(2);
  alike[0].omega = 1;
  alike[1] = link_at({{1e-4, 0}, {0, 0}, {0, 0}}, 0, 1 + 4e-16, 0);
  EXPECT_EQ(instant_centers(alike, 1)[0].kind, InstantCenterKind::kAtInfinity);
  EXPECT_EQ(instant_centers(std::vector<BodyMotion>(2), 1)[0].kind, InstantCenterKind::kUndefined);
  EXPECT_TRUE(instant_centers({}, 1).empty());
}

}  // namespace
}  // namespace higherpair

#include "higherpair/geometry/pose.hpp"

#include "geometry/geometry_testing.hpp"

#include <Eigen/Geometry>

namespace higherpair {
namespace {

using namespace higherpair::testing;

TEST(Vector, PerpTurnsCounterClockwiseAndCrossIsPositiveThatWay) {
  EXPECT_EQ(perp(Vector2d(0.031, 0.0127)), Vector2d(-0.0127, 0.031));
  const Vector2d a(0.3, -0.7);
  EXPECT_GT(cross(a, perp(a)), 0);
  EXPECT_AT_MOST(std::abs(cross(a, a)), 1e-16);  // a compiler may fuse one of the products
  EXPECT_DOUBLE_EQ(cross(Vector2d(2, 3), Vector2d(5, 7)), 2 * 7 - 3 * 5);
}

TEST(Vector, AngleOfUndoesUnitVector) {
  Random random(1);
  Worst error;
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.angle();
    error.see(std::abs(angle_of(random.between(1e-6, 1e6) * unit_vector(angle)) - angle));
  }
  EXPECT_AT_MOST(error.value(), 1e-15);  // two roundings of up to π
  EXPECT_EQ(angle_of(Vector2d(-1, 0)), kPi);
  EXPECT_EQ(angle_of(Vector2d::Zero()), 0);
}

TEST(Vector, NearestTurnDiffersByWholeTurnsAndIsWithinHalfATurn) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.between(-50, 50);
    const double reference = random.between(-50, 50);
    const double nearest = nearest_turn(angle, reference);
    const double turns = (nearest - angle) / (2 * kPi);
    EXPECT_AT_MOST(std::abs(turns - std::round(turns)), 1e-14);
    EXPECT_AT_MOST(std::abs(nearest - reference), kPi + 1e-13);
  }
}

TEST(Vector, NearestTurnKeepsAnAngleHalfATurnAway) {
  EXPECT_EQ(nearest_turn(kPi, 0), kPi);
  EXPECT_EQ(nearest_turn(-kPi, 0), -kPi);
  EXPECT_EQ(nearest_turn(0, kPi), 0);
}

TEST(Vector, PrincipalAngleLiesInTheHalfOpenTurn) {
  EXPECT_EQ(principal_angle(kPi), kPi);
  EXPECT_EQ(principal_angle(-kPi), kPi);
  EXPECT_EQ(principal_angle(0.7), 0.7);
  EXPECT_NEAR(principal_angle(0.7 - 4 * kPi), 0.7, 4e-15);
  EXPECT_NEAR(principal_angle(4), 4 - 2 * kPi, 1e-15);
}

TEST(Vector, AngleFromToTurnsOneDirectionIntoTheOther) {
  Random random(4);
  Worst error;
  for (int i = 0; i < 1000; ++i) {
    const double turn = random.angle();
    const Vector2d a = random.between(1e-6, 1e6) * unit_vector(random.angle());
    const Vector2d b = random.between(1e-6, 1e6) * (Rotation<double>::from_angle(turn) * a);
    error.see(std::abs(angle_from_to(a, b) - turn));
  }
  EXPECT_AT_MOST(error.value(), 3e-15);  // b is turned with rounding
}

TEST(Rotation, IsThatOfEigen) {
  Random random(3);
  Worst error;
  for (int i = 0; i < 1000; ++i) {
    const double alpha = random.angle();
    const double beta = random.angle();
    const Vector2d v = random.vector(1);
    const auto ours = Rotation<double>::from_angle(alpha) * Rotation<double>::from_angle(beta);
    error.see(ours * v - Eigen::Rotation2Dd(alpha + beta) * v);
    error.see(ours.inverse() * v - Eigen::Rotation2Dd(-alpha - beta) * v);
  }
  EXPECT_AT_MOST(error.value(), 2e-15);  // the angles' sum alone is rounded by 4e-16
}

TEST(Rotation, StartsAsNoRotation) {
  EXPECT_EQ(Rotation<double>{} * Vector2d(0.031, 0.0127), Vector2d(0.031, 0.0127));
  EXPECT_EQ(Pose<double>{} * Vector2d(0.031, 0.0127), Vector2d(0.031, 0.0127));
}

TEST(Rotation, NormalisingSquaresTheErrorOfTheLength) {
  for (const double error : {1e-3, -1e-3, 1e-6, -1e-6}) {
    const Rotation<double> off{(1 + error) * std::cos(0.7), (1 + error) * std::sin(0.7)};
    const Rotation<double> mended = off.normalised();
    const double left = std::hypot(mended.cos, mended.sin) - 1;
    EXPECT_AT_MOST(std::abs(left + 1.5 * error * error), 2 * std::abs(error * error * error) + 4e-16);
    EXPECT_NEAR(std::atan2(mended.sin, mended.cos), 0.7, 4e-16);
  }
}

TEST(Rotation, AMillionNormalisedProductsStayARotation) {
  const auto step = Rotation<double>::from_angle(2 * kPi / 1000);
  Rotation<double> turning;
  for (int i = 0; i < 1'000'000; ++i) {
    turning = (turning * step).normalised();
  }
  EXPECT_AT_MOST(std::abs(std::hypot(turning.cos, turning.sin) - 1), 4e-16);
  EXPECT_AT_MOST(std::abs(turning.sin), 1e-10);  // a million steps, each rounded by up to 1e-16
}

TEST(Pose, TakesBodyPointsToGroundAsComplexNumbersSay) {
  Random random(4);
  Worst error;
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.angle();
    const Vector2d origin = random.vector(1);
    const Vector2d p_B = random.vector(1);
    const std::complex<double> expected = std::complex<double>(origin.x(), origin.y()) +
                                          std::polar(1.0, angle) * std::complex<double>(p_B.x(), p_B.y());
    const Vector2d p_W = Pose<double>{Rotation<double>::from_angle(angle), origin} * p_B;
    error.see(p_W - Vector2d(expected.real(), expected.imag()));
  }
  EXPECT_AT_MOST(error.value(), 1e-15);
}

TEST(Pose, InverseTimesUndoesTheProduct) {
  Random random(5);
  for (const double size : {1e-6, 1.0, 1e6}) {
    Worst error;
    for (int i = 0; i < 1000; ++i) {
      const Pose<double> X_WB = random.pose(size);
      const Vector2d p = random.vector(size);
      error.see((X_WB.inverse_times(X_WB * p) - p) / size);
      error.see((X_WB * X_WB.inverse_times(p) - p) / size);
    }
    EXPECT_AT_MOST(error.value(), 2e-15);
  }
}

TEST(Pose, KeepsDistancesAndOrientation) {
  Random random(6);
  Worst error;
  for (int i = 0; i < 1000; ++i) {
    const Pose<double> X_WB = random.pose(1);
    const Vector2d p = random.vector(1);
    const Vector2d q = random.vector(1);
    const Vector2d r = random.vector(1);
    error.see(std::abs((X_WB * p - X_WB * q).norm() - (p - q).norm()));
    error.see(
        std::abs(cross<double>(X_WB * q - X_WB * p, X_WB * r - X_WB * p) - cross<double>(q - p, r - p)));
  }
  EXPECT_AT_MOST(error.value(), 5e-15);
}

}  // namespace
}  // namespace higherpair

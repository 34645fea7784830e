#include "higherpair/linkage/reach.hpp"

#include "linkage/linkage_testing.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

TEST(Balance, KeepsDigitsThatPlainSumsLose) {
  EXPECT_EQ(balance(1.0, 1e-17, -1.0, 0.001), 0.001 + 1e-17);
  EXPECT_EQ(balance(3.0, 1e-14, -2.0, -1.0), 1e-14);
}

TEST(Balance, IsZeroForLengthsThatBalanceInDecimal) {
  EXPECT_NE(0.1 + 0.2 - 0.3, 0);
  EXPECT_EQ(balance(0.1, 0.2, -0.3, 0.0), 0);
  EXPECT_EQ(balance(17.3e-3, 29.1e-3, -40.2e-3, -6.2e-3), 0);
}

TEST(Status, IsDecidedByTheInequalitiesOfItsDocumentation) {
  EXPECT_EQ(status_of(2, 1), LinkageStatus::kOk);
  EXPECT_EQ(status_of(1, 1), LinkageStatus::kSingular);
  EXPECT_EQ(status_of(-1, 1), LinkageStatus::kSingular);
  EXPECT_EQ(status_of(-2, 1), LinkageStatus::kNotAssemblable);
  EXPECT_EQ(status_of(0, 0), LinkageStatus::kSingular);
  EXPECT_EQ(status_of(std::nan(""), 1), LinkageStatus::kNotAssemblable);
  EXPECT_EQ(status_of(Reach<double>{3, 0.5, 1}), LinkageStatus::kSingular);
}

TEST(CosineLine, KeepsItsDigitsAtBothEnds) {
  const CosineLine<double> line{0, 2, 4, 2};  // 2 (1 - cos ψ)
  for (const double psi : {1e-9, 1e-4, 0.3, 1.5, 1.6, 3.1}) {
    const auto u = Rotation<double>::from_angle(psi);
    const double half_sine = std::sin(psi / 2);
    const double expected = 4 * half_sine * half_sine;
    EXPECT_AT_MOST(std::abs(line.at(u, versine_of(u)) - expected), 1e-15 * expected);
  }
  const CosineLine<double> other{4, 2, 0, -2};  // 2 (1 + cos ψ)
  for (const double gap : {1e-9, 1e-4, 0.3}) {
    const Rotation<double> u{-std::cos(gap), std::sin(gap)};
    const double half_sine = std::sin(gap / 2);
    const double expected = 4 * half_sine * half_sine;
    EXPECT_AT_MOST(std::abs(other.at(u, versine_of(u)) - expected), 1e-15 * expected);
  }
}

TEST(CosineLine, KeepsItsDigitsAtAQuarterTurn) {
  const CosineLine<double> line{-3, 0, 3, 3};  // -3 cos ψ
  const Rotation<double> u{1e-9, 1};
  EXPECT_AT_MOST(std::abs(line.at(u, versine_of(u)) + 3e-9), 1e-24);
}

}  // namespace
}  // namespace higherpair

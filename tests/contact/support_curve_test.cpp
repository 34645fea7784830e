#include "contact/random_pair.hpp"
#include "contact/support_curves.hpp"
#include "higherpair/contact/subdivision.hpp"
#include "higherpair/geometry/support.hpp"

#include <random>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

double between(double low, double high, std::mt19937& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Intervals of all widths from a half turn to 1e-8, nine samples in each: h and h′ up to their stated error,
// ρ up to the rounding of its sample, relative to w² of a hyperbola next to the end of its cone.
void expect_samples_within_bounds(const SupportCurve& curve, std::mt19937& random) {
  for (std::size_t piece = 0; piece < curve.pieces().size(); ++piece) {
    const SupportPiece& part = curve.pieces()[piece];
    if (part.kind == PieceKind::kFace) {
      continue;
    }
    const Bounds domain = part.kind == PieceKind::kClosed ? Bounds{-4, 4} : part.phi;
    for (int i = 0; i < 300; ++i) {
      const double width = std::min(domain.width(), 3.0) * std::pow(10.0, between(-8, 0, random));
      const double low = between(domain.low, domain.high - width, random);
      const Bounds phi{low, std::min(low + width, domain.high)};
      const SupportBounds bounds = bounds_over(curve, piece, phi);
      for (int k = 0; k <= 8; ++k) {
        const SupportValue v = curve.at(piece, std::min(phi.low + width * k / 8, phi.high));
        ASSERT_TRUE(bounds.h.low - v.error <= v.h && v.h <= bounds.h.high + v.error)
            << v.h << " in " << phi.low << " " << phi.high;
        ASSERT_TRUE(bounds.dh.low - v.error <= v.dh && v.dh <= bounds.dh.high + v.error)
            << v.dh << " in " << phi.low << " " << phi.high;
        const double rounding = 1e-5 * std::abs(v.rho);
        ASSERT_TRUE(bounds.rho.low - rounding <= v.rho && v.rho <= bounds.rho.high + rounding)
            << v.rho << " in " << phi.low << " " << phi.high;
      }
    }
  }
}

class LibraryCurves : public ::testing::TestWithParam<int> {};

TEST_P(LibraryCurves, LieWithinTheirBoundsOverEveryInterval) {
  std::mt19937 random(4000 + static_cast<unsigned>(GetParam()));
  const Curve curve = testing::random_curve(GetParam() % 6, random);
  expect_samples_within_bounds(*make_support_curve(curve, 300), random);
}

// The closed form of the boundary point with a given normal is another one than that of the support.
TEST_P(LibraryCurves, HaveThePointsOfTheClosedForm) {
  std::mt19937 random(5000 + static_cast<unsigned>(GetParam()));
  const int kind = GetParam() % 6;
  // A line has no point of its normal.
  const Curve curve = testing::random_curve(kind == 4 ? 1 : kind, random);
  const auto support = make_support_curve(curve, 300);
  const SupportPiece& piece = support->pieces()[0];
  const Bounds domain = piece.kind == PieceKind::kClosed ? Bounds{-kPi, kPi} : piece.phi;
  const PlacedCurve<double> placed = place(curve, Pose<double>{});
  for (int i = 0; i < 200; ++i) {
    const double phi = between(domain.low, domain.high, random);
    const SupportValue v = support->at(0, phi);
    const Vector2d n = unit_vector(phi);
    const Vector2d p = v.h * n + v.dh * perp(n);
    const SupportPoint<double> closed = support_point(placed, n);
    // Near the end of the cone rounding of n moves either point by ρ times 1e-16.
    const double tolerance = 1e-14 * (1 + p.norm() + std::abs(closed.rho));
    EXPECT_LE((p - closed.p_W).norm(), tolerance) << "phi = " << phi;
    EXPECT_LE(std::abs(v.rho - closed.rho), 1e-8 * std::abs(closed.rho)) << "phi = " << phi;
    EXPECT_LE(v.error, 10 * tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(All, LibraryCurves, ::testing::Range(0, 120));

TEST(SupportBounds, HoldSamplesOfLobedCamsWithConcaveParts) {
  std::mt19937 random(6001);
  for (const double b : {0.01, 0.1, 0.3, -0.7}) {
    expect_samples_within_bounds(testing::LobedCurve(1.3, b), random);
    expect_samples_within_bounds(testing::LobedCurve(1.3, b, true), random);
  }
}

TEST(SupportBounds, AreAsNarrowAsTheSquareOfTheInterval) {
  const testing::LobedCurve cam(1.3, 0.2);
  for (const double width : {1e-2, 1e-3, 1e-4}) {
    const SupportBounds bounds = bounds_over(cam, 0, {0.4, 0.4 + width});
    const SupportValue low = cam.at(0, 0.4);
    const SupportValue high = cam.at(0, 0.4 + width);
    // h + h″ <= a + 8 b, |h| <= a + b: bends by at most (2 a + 9 b) width²; twice for the enclosure.
    EXPECT_LE(bounds.h.width() - std::abs(high.h - low.h), 2 * (2 * 1.3 + 9 * 0.2) * width * width);
  }
}

TEST(SupportCurve, OfAParabolaEndsAtTheGivenReach) {
  const double length = 0.37;
  const auto curve = make_support_curve(make_parabola({0, 0}, length, 0).value(), 25);
  const Bounds& phi = curve->pieces()[0].phi;
  for (const double end : {phi.low, phi.high}) {
    const SupportValue v = curve->at(0, end);
    const Vector2d n = unit_vector(end);
    const Vector2d p = v.h * n + v.dh * perp(n);
    EXPECT_NEAR(std::abs(p.y()), 25, 1e-9);
    EXPECT_NEAR(p.x(), 25.0 * 25 / (4 * length), 1e-7);
  }
}

TEST(SupportCurve, OfAHyperbolaEndsBeforeItsNormalsLoseTheirDigits) {
  const auto curve = make_support_curve(make_hyperbola({0, 0}, {1e-3, 1e-5}, 0).value(), 1e6);
  const Bounds& phi = curve->pieces()[0].phi;
  const SupportValue v = curve->at(0, phi.high);
  const double distance = std::hypot(v.h, v.dh);
  EXPECT_GT(distance, 1);
  EXPECT_LE(v.error, 1e-4 * distance);
}

}  // namespace
}  // namespace higherpair

#include "higherpair/geometry/spline_span.hpp"

#include "geometry/span_testing.hpp"

#include <cmath>
#include <random>

namespace higherpair {
namespace {

using testing::Worst;
using Points = std::vector<Vector2d>;

constexpr double kA = 0.0317;
constexpr double kB = 0.0211;

Vector2d on_ellipse(double u) {
  return {kA * std::cos(u), kB * std::sin(u)};
}

double curvature_of_ellipse(const Vector2d& p) {
  const double u = std::atan2(p.y() / kB, p.x() / kA);
  return kA * kB / std::pow(std::hypot(kA * std::sin(u), kB * std::cos(u)), 3);
}

Points ellipse(int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(on_ellipse(2 * kPi * i / count));
  return points;
}

SpanPtr spline(const Points& points, const SplineOptions& options) {
  auto span = spline_span(points, options);
  EXPECT_TRUE(span.has_value());
  return *span;
}

// Largest relative errors of a spline through points of the ellipse, in distance and in curvature.
struct Errors {
  double distance = 0;
  double curvature = 0;
};

Errors errors(const Span& span) {
  Worst distance;
  Worst curvature;
  for (int i = 0; i < 2003; ++i) {
    const SpanPoint point = span.at(span.range().low + span.range().width() * i / 2003);
    const double f = std::pow(point.p_B.x() / kA, 2) + std::pow(point.p_B.y() / kB, 2) - 1;
    distance.see(std::abs(f));
    curvature.see(std::abs(point.kappa / curvature_of_ellipse(point.p_B) - 1));
  }
  return {distance.value(), curvature.value()};
}

SplineOptions closed(int degree = 5) {
  SplineOptions options;
  options.degree = degree;
  options.closed = true;
  return options;
}

TEST(SplineSpan, ItsErrorFallsWithTheSixthPowerOfTheDistanceOfThePoints) {
  const Errors coarse = errors(*spline(ellipse(40), closed()));
  const Errors fine = errors(*spline(ellipse(80), closed()));
  EXPECT_GT(std::log2(coarse.distance / fine.distance), 5.5);
  EXPECT_GT(std::log2(coarse.curvature / fine.curvature), 3.5);
  EXPECT_LE(fine.distance, 1e-7);
  const Errors cubic_coarse = errors(*spline(ellipse(40), closed(3)));
  const Errors cubic_fine = errors(*spline(ellipse(80), closed(3)));
  EXPECT_GT(std::log2(cubic_coarse.distance / cubic_fine.distance), 3.5);
  EXPECT_GT(std::log2(cubic_coarse.curvature / cubic_fine.curvature), 1.5);
}

TEST(SplineSpan, ATableOfHalfDegreesGivesTheCurvatureToManyDigits) {
  const Errors table = errors(*spline(ellipse(720), closed()));
  EXPECT_AT_MOST(table.distance, 2e-13);
  EXPECT_AT_MOST(table.curvature, 1e-8);
}

TEST(SplineSpan, UnevenPointsAreNoWorse) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  const auto uneven = [&](int count) {
    Points points;
    for (int i = 0; i < count; ++i) points.push_back(on_ellipse(2 * kPi * (i + shift(random)) / count));
    return points;
  };
  const Errors coarse = errors(*spline(uneven(60), closed()));
  const Errors fine = errors(*spline(uneven(240), closed()));
  EXPECT_AT_MOST(fine.distance, coarse.distance / 300);
  EXPECT_AT_MOST(fine.curvature, 1e-4);
}

TEST(SplineSpan, NormalAndCurvaturesAreDerivativesOfThePoints) {
  testing::expect_span_laws(*spline(ellipse(71), closed()), kA, 1e-6);
  SplineOptions centripetal = closed();
  centripetal.parameter = SplineParameter::kCentripetal;
  testing::expect_span_laws(*spline(ellipse(71), centripetal), kA, 1e-6);
  testing::expect_span_laws(
      *spline({{0, 0}, {0.01, 0.003}, {0.017, 0.011}, {0.02, 0.021}, {0.031, 0.02}, {0.039, 0.033}}, {}),
      0.01, 1e-5);
}

TEST(SplineSpan, RunsRoundWithTheMaterialOnItsLeft) {
  const SpanPtr span = spline(ellipse(90), closed());
  const SpanPoint first = span->at(span->range().low);
  EXPECT_LE((first.p_B - Vector2d(kA, 0)).norm(), 1e-16);
  EXPECT_LE((first.n_B - Vector2d(1, 0)).norm(), 1e-9);
  EXPECT_GT(first.kappa, 0);
  EXPECT_NEAR(first.speed, 1, 1e-6);
  Points back = ellipse(90);
  std::reverse(back.begin(), back.end());
  EXPECT_LT(spline(back, closed())->at(0).kappa, 0);
}

TEST(SplineSpan, OfAClosedOneTheEndIsItsBeginInEveryRespect) {
  for (const int degree : {3, 5}) {
    const SpanPtr span = spline(ellipse(50), closed(degree));
    const SpanPoint begin = span->at(span->range().low);
    const SpanPoint end = span->at(span->range().high);
    EXPECT_LE((begin.p_B - end.p_B).norm(), 1e-16);
    EXPECT_LE((begin.n_B - end.n_B).norm(), 1e-13);
    EXPECT_NEAR(begin.kappa * kA, end.kappa * kA, 1e-10);
    if (degree == 5) {
      EXPECT_NEAR(begin.slope * kA * kA, end.slope * kA * kA, 1e-7);
    }
  }
  Points repeated = ellipse(50);
  repeated.push_back(repeated.front());
  const SpanPtr same = spline(repeated, closed());
  EXPECT_EQ(same->range().high, spline(ellipse(50), closed())->range().high);
}

TEST(SplineSpan, GoesThroughItsPointsHoweverUnevenlyTheyLie) {
  Points points;
  for (int i = 0; i < 60; ++i) points.emplace_back(0.001 * std::pow(1.15, i), 0.0003 * i * i);
  const SpanPtr span = spline(points, {});
  Worst worst;
  for (const Vector2d& p : points) {
    // The foot of the perpendicular, by bisection of (p(t) - p)·t.
    double low = span->range().low - 1e-9;
    double high = span->range().high + 1e-9;
    for (int i = 0; i < 80; ++i) {
      const double middle = (low + high) / 2;
      const SpanPoint point = span->at(middle);
      ((point.p_B - p).dot(perp(point.n_B)) < 0 ? low : high) = middle;
    }
    worst.see(span->at(low).p_B - p);
  }
  EXPECT_AT_MOST(worst.value(), 1e-13);
}

TEST(SplineSpan, SmoothingStaysWithinItsToleranceAndTakesTheNoiseAway) {
  std::mt19937 random(7);
  const double noise = 1e-6;
  std::uniform_real_distribution<double> error(-noise, noise);
  Points points;
  for (const Vector2d& p : ellipse(720)) points.emplace_back(p.x() + error(random), p.y() + error(random));
  SplineOptions smooth = closed();
  smooth.smoothing = 1.5 * noise;
  const SpanPtr span = spline(points, smooth);
  Worst distance;
  for (const Vector2d& p : points) {
    double least = 1;
    double normal = 0;
    for (int i = 0; i < 7200; ++i) {
      const SpanPoint point = span->at(span->range().width() * i / 7200);
      if ((point.p_B - p).norm() < least) {
        least = (point.p_B - p).norm();
        normal = std::abs((point.p_B - p).dot(point.n_B));
      }
    }
    distance.see(normal);
  }
  EXPECT_AT_MOST(distance.value(), smooth.smoothing + 1e-8);
  EXPECT_LT(20 * errors(*span).curvature, errors(*spline(points, closed())).curvature);
}

TEST(SplineSpan, EndTangentsHold) {
  const Points points = {{0, 0},         {0.011, 0.002}, {0.019, 0.009},
                         {0.023, 0.019}, {0.022, 0.03},  {0.018, 0.041}};
  for (const int degree : {3, 5}) {
    SplineOptions options;
    options.degree = degree;
    options.first_tangent = Vector2d(3, -1);
    options.last_tangent = Vector2d(-2, 1);
    const SpanPtr span = spline(points, options);
    EXPECT_LE((perp(span->at(span->range().low).n_B) - Vector2d(3, -1).normalized()).norm(), 1e-12);
    EXPECT_LE((perp(span->at(span->range().high).n_B) - Vector2d(-2, 1).normalized()).norm(), 1e-12);
    EXPECT_LE((span->at(span->range().low).p_B - points.front()).norm(), 1e-16);
    EXPECT_LE((span->at(span->range().high).p_B - points.back()).norm(), 1e-16);
  }
}

TEST(SplineSpan, AnArcWithItsTangentsIsBetterThanWithFreeEnds) {
  Points points;
  for (int i = 0; i <= 12; ++i) points.push_back(0.03 * unit_vector(0.1 * i));
  SplineOptions options;
  options.first_tangent = Vector2d(0, 1);
  options.last_tangent = unit_vector(1.2 + kPi / 2);
  const auto worst = [](const Span& span) {
    Worst error;
    for (int i = 0; i <= 300; ++i) {
      error.see(std::abs(span.at(span.range().width() * i / 300).p_B.norm() - 0.03));
    }
    return error.value();
  };
  EXPECT_LT(worst(*spline(points, options)), worst(*spline(points, {})) / 3);
}

TEST(SplineSpan, ItsErrorFallsAsFastAtFreeEnds) {
  const auto worst = [](int count) {
    Points points;
    for (int i = 0; i < count; ++i) points.push_back(on_ellipse(2.0 * i / (count - 1)));
    const SpanPtr span = spline(points, {});
    Worst error;
    for (int i = 0; i <= 400; ++i) {
      const Vector2d p = span->at(span->range().width() * i / 400).p_B;
      error.see(std::abs(std::pow(p.x() / kA, 2) + std::pow(p.y() / kB, 2) - 1));
    }
    return error.value();
  };
  EXPECT_GT(std::log2(worst(65) / worst(129)), 5.5);
}

TEST(SplineSpan, TheLengthOfTheCurveIsItsParameter) {
  const SpanPtr span = spline(ellipse(200), closed());
  Worst worst;
  for (int i = 0; i < 500; ++i) worst.see(std::abs(span->at(span->range().width() * i / 500).speed - 1));
  EXPECT_AT_MOST(worst.value(), 1e-7);
}

TEST(SplineSpan, IsTheSameAtEveryScale) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    Points points = ellipse(60);
    for (Vector2d& p : points) p *= scale;
    const SpanPtr span = spline(points, closed());
    const SpanPtr unscaled = spline(ellipse(60), closed());
    EXPECT_NEAR(span->at(0.037 * scale).kappa * scale / unscaled->at(0.037).kappa, 1, 1e-9);
  }
}

SplineFault fault(const Points& points, const SplineOptions& options) {
  const auto span = spline_span(points, options);
  EXPECT_FALSE(span.has_value());
  return span ? SplineFault{} : span.error();
}

TEST(SplineSpan, FaultsSayWhereTheyAre) {
  using Kind = SplineFault::Kind;
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {-1, 0}}, closed()).kind, Kind::kTooFew);
  Points points = ellipse(30);
  points[12] = points[11];
  const SplineFault repeated = fault(points, closed());
  EXPECT_EQ(repeated.kind, Kind::kRepeated);
  EXPECT_EQ(repeated.first, 11);
  EXPECT_EQ(repeated.second, 12);
  Points open = ellipse(30);
  open.resize(20);
  const SplineFault gap = fault(open, closed());
  EXPECT_EQ(gap.kind, Kind::kOpen);
  EXPECT_EQ(gap.first, 19);
  EXPECT_NEAR(gap.distance, (open.back() - open.front()).norm(), 1e-16);
  EXPECT_GT(gap.factor, 3);
  Points wrong = ellipse(30);
  std::swap(wrong[7], wrong[8]);
  const SplineFault back = fault(wrong, closed());
  EXPECT_EQ(back.kind, Kind::kTurnsBack);
  EXPECT_EQ(back.first, 7);
}

TEST(NurbsSpans, ARationalQuadraticIsACircle) {
  const double r = 0.0123;
  NurbsCurve curve;
  curve.degree = 2;
  curve.control = {{r, 0}, {r, r}, {0, r}, {-r, r}, {-r, 0}};
  curve.knots = {0, 0, 0, 1, 1, 2, 2, 2};
  const double w = std::sqrt(0.5);
  curve.weights = {1, w, 1, w, 1};
  const auto spans = nurbs_spans(curve);
  ASSERT_EQ(spans.size(), 2U);
  for (const SpanPtr& span : spans) {
    testing::expect_span_laws(*span, r, 1e-6);
    for (int i = 0; i <= 20; ++i) {
      const SpanPoint point = span->at(span->range().low + i / 20.0);
      EXPECT_NEAR(point.p_B.norm(), r, 1e-16);
      EXPECT_NEAR(point.kappa * r, 1, 1e-12);
      EXPECT_NEAR(point.slope * r * r, 0, 1e-11);
      EXPECT_LE((point.n_B - point.p_B / r).norm(), 1e-13);
    }
  }
  EXPECT_LE((spans[0]->at(1).p_B - Vector2d(0, r)).norm(), 1e-16);
}

TEST(NurbsSpans, ACubicIsTakenApartOnlyWhereItsCurvatureMayJump) {
  NurbsCurve curve;
  curve.degree = 3;
  curve.control = {{0, 0}, {1, 0}, {2, 1}, {3, 3}, {3.5, 5}, {3.5, 7}, {3, 9}};
  curve.knots = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4};
  const auto smooth = nurbs_spans(curve);
  ASSERT_EQ(smooth.size(), 1U);
  testing::expect_span_laws(*smooth[0], 1, 1e-5);
  EXPECT_LE((smooth[0]->at(0).p_B - curve.control.front()).norm(), 1e-15);
  EXPECT_LE((smooth[0]->at(4).p_B - curve.control.back()).norm(), 1e-14);
  EXPECT_NEAR(smooth[0]->at(2 - 1e-12).kappa, smooth[0]->at(2).kappa, 1e-10);
  curve.knots = {0, 0, 0, 0, 1, 2, 2, 4, 4, 4, 4};
  const auto jump = nurbs_spans(curve);
  ASSERT_EQ(jump.size(), 2U);
  EXPECT_LE((jump[0]->at(2).p_B - jump[1]->at(2).p_B).norm(), 1e-14);
}

TEST(NurbsSpans, OfDegreeOneAreStraight) {
  NurbsCurve curve;
  curve.degree = 1;
  curve.control = {{0, 0}, {2, 0}, {2, 0}, {2, 3}};
  curve.knots = {0, 0, 1, 2, 3, 3};
  const auto spans = nurbs_spans(curve);
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_EQ(spans[1]->at(spans[1]->range().high).p_B, Vector2d(2, 3));
  EXPECT_EQ(spans[1]->at(1).kappa, 0);
}

}  // namespace
}  // namespace higherpair

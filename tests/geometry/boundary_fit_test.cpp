// Curves through measured points: exact points of known curves, copies of them, closed forms of linear
// problems, noise compared with its covariance, and points that have no such curve.
#include "higherpair/geometry/boundary_fit.hpp"

#include "geometry/geometry_testing.hpp"

#include <algorithm>
#include <functional>
#include <random>

namespace higherpair {
namespace {

using testing::Random;
using testing::Worst;

using Points = std::vector<Vector2d>;

Points circle_points(const Vector2d& center, double radius, double from, double to, int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    points.push_back(center + radius * unit_vector(from + (to - from) * i / (count - 1)));
  }
  return points;
}

Points ellipse_points(const Vector2d& center, double a, double b, double rotation, double from, double to,
                      int count) {
  Points points;
  const Vector2d axis = unit_vector(rotation);
  for (int i = 0; i < count; ++i) {
    const double t = from + (to - from) * i / (count - 1);
    points.push_back(center + a * std::cos(t) * axis + b * std::sin(t) * perp(axis));
  }
  return points;
}

Points with_noise(Points points, double noise, std::mt19937_64& engine) {
  std::normal_distribution<double> error(0, noise);
  for (Vector2d& p : points) p += Vector2d(error(engine), error(engine));
  return points;
}

double sum_of_squares(const BoundaryFit& fit) {
  double sum = 0;
  for (const double d : fit.distances) sum += d * d;
  return sum;
}

TEST(BoundaryFit, ExactPointsOfACircleGiveItAtAnyPlaceAndScale) {
  for (const double radius : {1e-6, 0.031, 1.0, 1e6}) {
    for (const Vector2d& at : {Vector2d(0, 0), Vector2d(3, -7), Vector2d(1e6, 1e6)}) {
      const Vector2d center = radius * at;
      const auto fit = fit_circle(circle_points(center, radius, 0.3, 5.1, 23));
      ASSERT_TRUE(fit);
      // The error that rounding of the points allows.
      const double bound = 1e-15 * (10 * radius + 4 * center.norm());
      EXPECT_NEAR(fit->parameters[0], center.x(), bound);
      EXPECT_NEAR(fit->parameters[1], center.y(), bound);
      EXPECT_NEAR(fit->parameters[2], radius, bound);
      EXPECT_LE(fit->rms, bound);
    }
  }
}

TEST(BoundaryFit, AnArcOfFiveDegreesFarAwayGivesItsCircle) {
  const auto fit = fit_circle(circle_points({0.4, -0.2}, 57, 1.0, 1.0 + kPi / 36, 40));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->parameters[2], 57, 57e-10);
}

TEST(BoundaryFit, ThreePointsGiveTheCircleThroughThem) {
  const auto fit = fit_circle(Points{{0, 0}, {4, 0}, {0, 3}});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->parameters[0], 2, 1e-13);
  EXPECT_NEAR(fit->parameters[1], 1.5, 1e-13);
  EXPECT_NEAR(fit->parameters[2], 2.5, 1e-13);
  EXPECT_TRUE(std::isnan(fit->covariance(0, 0)));
}

// Points distributed equally about a centre give a circle with their mean distance as its radius.
TEST(BoundaryFit, ACircleThroughTwoConcentricRingsHasTheMeanRadius) {
  Points points = circle_points({5, 2}, 3, 0, 2 * kPi * 11 / 12, 12);
  const Points outer = circle_points({5, 2}, 4, 0, 2 * kPi * 11 / 12, 12);
  points.insert(points.end(), outer.begin(), outer.end());
  const auto fit = fit_circle(points);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->parameters[0], 5, 1e-12);
  EXPECT_NEAR(fit->parameters[1], 2, 1e-12);
  EXPECT_NEAR(fit->parameters[2], 3.5, 1e-12);
  EXPECT_NEAR(fit->rms, 0.5, 1e-13);
  // Σ d² = 24/4 with 24 - 3 degrees of freedom.
  EXPECT_NEAR(fit->noise, std::sqrt(6.0 / 21), 1e-12);
  EXPECT_NEAR(fit->covariance(2, 2), 6.0 / 21 / 24, 1e-12);
  EXPECT_NEAR(fit->covariance(0, 0), 6.0 / 21 / 12, 1e-12);
}

// A line whose points have small errors in y only: its slope is that of ordinary least squares.
TEST(BoundaryFit, ALineIsThatOfTotalLeastSquares) {
  Random random(3);
  Points points;
  double xx = 0, xy = 0, yy = 0;
  Vector2d mean = Vector2d::Zero();
  for (int i = 0; i < 31; ++i) points.push_back(random.vector(1).cwiseProduct(Vector2d(7, 0.4)));
  for (const Vector2d& p : points) mean += p / 31;
  for (const Vector2d& p : points) {
    const Vector2d d = p - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const auto fit = fit_line(points);
  ASSERT_TRUE(fit);
  const double direction = std::atan2(2 * xy, xx - yy) / 2;  // of the larger principal axis
  EXPECT_NEAR(std::remainder(fit->parameters[2] - direction - kPi / 2, kPi), 0, 1e-14);
  EXPECT_NEAR(fit->parameters[0], mean.x(), 1e-14);
  const double least = (xx + yy) / 2 - std::hypot((xx - yy) / 2, xy);
  EXPECT_NEAR(sum_of_squares(*fit), least, 1e-13);
  const double most = xx + yy - least;
  EXPECT_NEAR(fit->covariance(2, 2), least / 29 / most, 1e-14);
}

TEST(BoundaryFit, ExactPointsOfAnEllipseGiveItAtAnyPlaceAndScale) {
  Random random(5);
  Worst worst;
  for (int trial = 0; trial < 60; ++trial) {
    const double size = std::pow(10, random.between(-6, 6));
    const double a = size * random.between(1.2, 4), b = size, rotation = random.between(-1.5, 1.5);
    const Vector2d center = size * random.vector(trial % 3 == 0 ? 1e5 : 3);
    const auto fit = fit_conic(ellipse_points(center, a, b, rotation, random.angle(), random.angle() + 6, 29),
                               trial % 2 == 0 ? ConicForm::kEllipse : ConicForm::kAny);
    ASSERT_TRUE(fit) << describe(fit.error());
    const double scale = size + 0.3 * center.norm();
    worst.see((Vector2d(fit->parameters[0], fit->parameters[1]) - center) / scale);
    worst.see(std::abs(fit->parameters[2] - a) / scale);
    worst.see(std::abs(fit->parameters[3] - b) / scale);
    worst.see(std::abs(std::remainder(fit->parameters[4] - rotation, kPi)) * size / scale);
  }
  EXPECT_AT_MOST(worst.value(), 1e-11);
}

TEST(BoundaryFit, ExactPointsOfParabolasAndHyperbolasGiveThem) {
  Random random(7);
  Worst worst;
  for (int trial = 0; trial < 40; ++trial) {
    const double rotation = random.angle(), size = std::pow(10, random.between(-4, 4));
    const Vector2d at = size * random.vector(4), axis = unit_vector(rotation);
    Points parabola, hyperbola;
    for (int i = 0; i < 21; ++i) {
      const double t = -1 + 0.1 * i;
      parabola.push_back(at + size * (0.6 * t * t * axis + 1.2 * t * perp(axis)));
      hyperbola.push_back(at + size * (1.5 * std::cosh(t) * axis + 0.8 * std::sinh(t) * perp(axis)));
    }
    const auto p = fit_conic(parabola, ConicForm::kParabola);
    ASSERT_TRUE(p) << describe(p.error());
    worst.see((Vector2d(p->parameters[0], p->parameters[1]) - at) / size);
    worst.see(std::abs(p->parameters[2] / size - 0.6));
    worst.see(std::abs(std::remainder(p->parameters[3] - rotation, 2 * kPi)));
    const auto h = fit_conic(hyperbola, ConicForm::kHyperbola);
    ASSERT_TRUE(h) << describe(h.error());
    EXPECT_EQ(h->curve.kind, CurveKind::kHyperbola);
    worst.see((Vector2d(h->parameters[0], h->parameters[1]) - at) / size);
    worst.see(std::abs(h->parameters[2] / size - 1.5));
    worst.see(std::abs(h->parameters[3] / size - 0.8));
    worst.see(std::abs(std::remainder(h->parameters[4] - rotation, 2 * kPi)));
  }
  EXPECT_AT_MOST(worst.value(), 1e-9);
}

// Scaling, rotating or shifting the points does the same to the answer and changes nothing else.
TEST(BoundaryFit, CopiesOfNoisyPointsGiveCopiesOfTheCurve) {
  std::mt19937_64 engine(11);
  const Points points = with_noise(ellipse_points({2, 1}, 3, 1.4, 0.4, 0, 5.5, 41), 0.03, engine);
  const auto own = fit_conic(points, ConicForm::kEllipse);
  const auto own_circle = fit_circle(points);
  const auto own_line = fit_line(points);
  ASSERT_TRUE(own && own_circle && own_line);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const double turn = 0.7;
    const Vector2d shift = scale * Vector2d(40, -90);
    Points copy;
    for (const Vector2d& p : points) copy.push_back(scale * (Rotation<double>::from_angle(turn) * p) + shift);
    const auto moved = [&](const BoundaryFit& fit) -> Vector2d {
      return scale * (Rotation<double>::from_angle(turn) * Vector2d(fit.parameters[0], fit.parameters[1])) +
             shift;
    };
    const auto fit = fit_conic(copy, ConicForm::kEllipse);
    ASSERT_TRUE(fit);
    EXPECT_AT_MOST((Vector2d(fit->parameters[0], fit->parameters[1]) - moved(*own)).norm(), 1e-10 * scale);
    EXPECT_NEAR(fit->parameters[2], scale * own->parameters[2], 1e-10 * scale);
    EXPECT_NEAR(fit->parameters[3], scale * own->parameters[3], 1e-10 * scale);
    EXPECT_NEAR(std::remainder(fit->parameters[4] - own->parameters[4] - turn, kPi), 0, 1e-10);
    EXPECT_NEAR(fit->covariance(2, 2), scale * scale * own->covariance(2, 2),
                1e-6 * scale * scale * own->covariance(2, 2));
    const auto circle = fit_circle(copy);
    EXPECT_AT_MOST((Vector2d(circle->parameters[0], circle->parameters[1]) - moved(*own_circle)).norm(),
                   1e-10 * scale);
    EXPECT_NEAR(circle->parameters[2], scale * own_circle->parameters[2], 1e-10 * scale);
    const auto line = fit_line(copy);
    EXPECT_NEAR(std::remainder(line->parameters[2] - own_line->parameters[2] - turn, kPi), 0, 1e-12);
    EXPECT_NEAR(line->rms, scale * own_line->rms, 1e-12 * scale);
  }
}

// The fit has the least sum of squares: no neighbour has a smaller one, computed by dense sampling of the
// curve.
TEST(BoundaryFit, NoNeighbourOfAFittedEllipseIsNearerToThePoints) {
  std::mt19937_64 engine(13);
  const Points points = with_noise(ellipse_points({-1, 4}, 2.5, 1, -0.3, 0.2, 6, 37), 0.05, engine);
  const auto fit = fit_conic(points, ConicForm::kEllipse);
  ASSERT_TRUE(fit);
  const auto sum_for = [&](const std::vector<double>& x) {
    const auto curve = make_ellipse({x[0], x[1]}, {x[2], x[3]}, x[4]).value();
    double sum = 0;
    for (const Vector2d& p : points) {
      sum += (nearest_on_conic(implicit_coefficients(curve), p) - p).squaredNorm();
    }
    return sum;
  };
  EXPECT_NEAR(sum_for(fit->parameters), sum_of_squares(*fit), 1e-12);
  for (std::size_t i = 0; i < 5; ++i) {
    for (const double step : {-1e-4, 1e-4}) {
      std::vector<double> x = fit->parameters;
      x[i] += step;
      EXPECT_GT(sum_for(x), sum_of_squares(*fit));
    }
  }
}

// Compares with the distances to many points of the curve, none of which may be nearer.
TEST(BoundaryFit, TheNearestPointOfAConicIsNearestOfAll) {
  Random random(17);
  Worst off, far;
  for (int trial = 0; trial < 400; ++trial) {
    const double rotation = random.angle(), a = random.between(0.3, 3), b = random.between(0.3, 3);
    const Vector2d center = random.vector(2), axis = unit_vector(rotation);
    const bool is_ellipse = trial % 2 == 0;
    const Curve curve = is_ellipse ? make_ellipse(center, {a, b}, rotation).value()
                                   : make_parabola(center, a, rotation).value();
    // Also points on the axes, beyond the centre of curvature.
    const Vector2d p = trial % 5 == 0   ? Vector2d(center + random.between(-2, 2) * axis)
                       : trial % 7 == 0 ? center
                                        : Vector2d(center + random.vector(4));
    const auto coefficients = implicit_coefficients(curve);
    const Vector2d foot = nearest_on_conic(coefficients, p);
    double least = 1e300;
    for (int i = -4000; i < 4000; ++i) {
      const double t = is_ellipse ? kPi * i / 4000 : 0.001 * i;
      const Vector2d q = is_ellipse ? Vector2d(center + a * std::cos(t) * axis + b * std::sin(t) * perp(axis))
                                    : Vector2d(center + a * t * t * axis - 2 * a * t * perp(axis));
      least = std::min(least, (q - p).norm());
    }
    far.see(std::max(0.0, (foot - p).norm() - least));
    const auto& c = coefficients;
    off.see(std::abs(c[0] * foot.x() * foot.x() + c[1] * foot.y() * foot.y() + c[2] * foot.x() * foot.y() +
                     c[3] * foot.x() + c[4] * foot.y() + c[5]));
  }
  EXPECT_AT_MOST(off.value(), 1e-10);
  EXPECT_AT_MOST(far.value(), 1e-10);
}

// Student's t for 17 degrees of freedom and 95 % is 2.1098: of 400 circles about 380 within their intervals.
TEST(BoundaryFit, IntervalsHoldTheTruthAsOftenAsTheySay) {
  std::mt19937_64 engine(19);
  int radius = 0, center = 0, axis = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const auto fit = fit_circle(with_noise(circle_points({3, 1}, 2, 0, 4, 20), 0.01, engine));
    radius += std::abs(fit->parameters[2] - 2) <= 2.1098 * std::sqrt(fit->covariance(2, 2)) ? 1 : 0;
    center += std::abs(fit->parameters[0] - 3) <= 2.1098 * std::sqrt(fit->covariance(0, 0)) ? 1 : 0;
    const auto ellipse =
        fit_conic(with_noise(ellipse_points({3, 1}, 4, 2, 0.5, 0, 5, 22), 0.01, engine), ConicForm::kEllipse);
    axis += std::abs(ellipse->parameters[2] - 4) <= 2.1098 * std::sqrt(ellipse->covariance(2, 2)) ? 1 : 0;
  }
  // Four standard deviations of a binomial count, √(400 · 0.95 · 0.05) = 4.4, to either side.
  for (const int count : {radius, center, axis}) {
    EXPECT_GE(count, 380 - 18);
    EXPECT_LE(count, 380 + 18);
  }
}

TEST(BoundaryFit, DistancesArePositiveOutside) {
  Points points = circle_points({1, 1}, 5, 0, 6, 30);
  points.push_back({7.5, 1});
  EXPECT_GT(fit_circle(points)->distances.back(), 1);
  points = ellipse_points({1, 1}, 5, 3, 0.2, 0, 6, 30);
  points.emplace_back(9, 1);
  EXPECT_GT(fit_conic(points, ConicForm::kEllipse)->distances.back(), 1);
}

TEST(BoundaryFit, PointsWithoutSuchACurveAreRefused) {
  const auto error_of = [](const BoundaryFitResult& result) {
    return result ? std::string("none") : std::string(describe(result.error()));
  };
  EXPECT_EQ(error_of(fit_circle(Points{{0, 0}, {1, 1}})), "are fewer than the curve has parameters");
  EXPECT_EQ(error_of(fit_line(Points{{0, 0}})), "are fewer than the curve has parameters");
  EXPECT_EQ(error_of(fit_circle(Points{{0, 0}, {1, 1}, {NAN, 0}})),
            "are too large or too small, or no numbers");
  EXPECT_EQ(error_of(fit_circle(Points{{2, 1}, {2, 1}, {2, 1}})), "are all one point");
  EXPECT_EQ(error_of(fit_circle(Points{{0, 0}, {1, 2}, {2, 4}, {5, 10}})), "lie on one line");
  EXPECT_EQ(error_of(fit_conic(Points{{0, 0}, {1, 2}, {2, 4}, {5, 10}, {7, 14}})), "lie on one line");
  EXPECT_EQ(error_of(fit_line(Points{{1, 0}, {0, 1}, {-1, 0}, {0, -1}})),
            "are spread alike in all directions, so that no line is nearest");
  EXPECT_EQ(error_of(fit_conic(ellipse_points({0, 0}, 2, 1, 0, 0, 6, 20), ConicForm::kHyperbola)),
            "are nearest to a conic of another form");
  EXPECT_EQ(error_of(fit_conic(Points{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {0, 3}, {1, 2}, {3, 0}})),
            "are nearest to a pair of lines, or to no curve at all");
  EXPECT_EQ(describe(BoundaryFitError::kNotConverged), "have no nearest curve that could be found");
}

}  // namespace
}  // namespace higherpair

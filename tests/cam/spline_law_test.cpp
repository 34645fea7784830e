#include "cam/law_testing.hpp"
#include "higherpair/geometry/expansion.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::law_of;

LawDescription table(const std::function<double(double)>& s, double from, double to, int intervals,
                     int degree = 5) {
  LawDescription description;
  description.degree = degree;
  for (int i = 0; i <= intervals; ++i) {
    const double x = from + (to - from) * i / intervals;
    description.points.emplace_back(x, s(x));
  }
  return description;
}

LawDescription turn(const std::function<double(double)>& s, int intervals, int degree = 5) {
  LawDescription description = table(s, 0, 2 * kPi, intervals, degree);
  description.points.back().y() = description.points.front().y();
  description.ends = SplineEnds::kPeriodic;
  description.repeats = true;
  return description;
}

// h(θ) = √(4 sin² + cos²), the lift of a flat follower by an ellipse 2 × 1, and its derivatives.
double ellipse(double x, int k) {
  PowerSeries<double, 4> t(x);
  t.c[1] = 1;
  const auto h = sqrt(4.0 * sin(t) * sin(t) + cos(t) * cos(t));
  const double factorials[] = {1, 1, 2, 6, 24};
  return factorials[k] * h.c[k];
}

std::array<double, 4> largest_errors(const MotionLaw& law, const std::function<double(double, int)>& exact) {
  std::array<double, 4> largest{};
  for (int i = 0; i < 3601; ++i) {
    const double x = law.begin() + (law.end() - law.begin()) * i / 3600.3;
    for (int k = 0; k < 4; ++k) {
      double& error = largest[k];
      error = std::max(error, std::abs(law.derivative(k, x) - exact(x, k)));
    }
  }
  return largest;
}

// SciPy 1.10's splines have the same errors: 9e-9, 1.7e-6, 1e-3, 0.34 and 3e-12, 6e-10, 2.3e-7, 7.7e-5.
TEST(SplineLaw, IsAsCloseToATrueLiftAsSplinesAre) {
  const auto cubic = largest_errors(law_of(turn([](double x) { return ellipse(x, 0); }, 360, 3)), ellipse);
  const auto quintic = largest_errors(law_of(turn([](double x) { return ellipse(x, 0); }, 360, 5)), ellipse);
  const double expected_cubic[] = {9e-9, 1.7e-6, 1e-3, 0.34};
  const double expected_quintic[] = {3e-12, 6e-10, 2.3e-7, 7.7e-5};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LE(cubic[k], 1.2 * expected_cubic[k]) << k;
    EXPECT_LE(quintic[k], 1.2 * expected_quintic[k]) << k;
    EXPECT_GE(cubic[k], 0.5 * expected_cubic[k]) << k;
    EXPECT_GE(quintic[k], 0.5 * expected_quintic[k]) << k;
  }
}

TEST(SplineLaw, GoesThroughItsPoints) {
  for (const int degree : {3, 5}) {
    LawDescription description{.points = {{-1, 2}, {0.3, 5}, {0.4, 4.9}, {1.7, -3}, {2, 0}, {5, 1}},
                               .degree = degree};
    const MotionLaw law = law_of(description);
    for (const Vector2d& point : description.points) {
      EXPECT_NEAR(law(point.x()), point.y(), 1e-13);
      EXPECT_NEAR(law(point.x(), LawSide::kBefore), point.y(), 1e-13);
    }
    for (const double end : {-1.0, 5.0}) {
      const LawSide side = end < 0 ? LawSide::kAfter : LawSide::kBefore;
      for (int k = (degree + 1) / 2; k < degree; ++k) {
        EXPECT_NEAR(law.derivative(k, end, side), 0, 1e-8) << "natural";
      }
    }
    for (std::size_t i = 1; i + 1 < description.points.size(); ++i) {
      const double x = description.points[i].x();
      for (int k = 0; k < degree; ++k) {
        const double after = law.derivative(k, x);
        EXPECT_NEAR(law.derivative(k, x, LawSide::kBefore), after, 1e-10 * std::max(1.0, std::abs(after)));
      }
    }
  }
}

TEST(SplineLaw, IsTheParabolaThroughPointsOfOne) {
  const MotionLaw law = law_of(table([](double x) { return 3 - 2 * x + 0.5 * x * x; }, -3, 4, 11));
  for (double x = -3; x < 4; x += 0.1) {
    EXPECT_NEAR(law(x), 3 - 2 * x + 0.5 * x * x, 1e-13);
    EXPECT_NEAR(law.derivative(2, x), 1, 1e-11);
  }
}

TEST(SplineLaw, RepeatsSmoothlyWherePeriodic) {
  const MotionLaw law = law_of(turn([](double x) { return std::sin(x) + 0.2 * std::cos(3 * x); }, 90));
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(law.derivative(k, 0, LawSide::kBefore), law.derivative(k, 0, LawSide::kAfter), 1e-7);
  }
  for (const LawJoin& join : law.joins()) EXPECT_EQ(join.lowest_jump(), 0);
  // The closing point may be left out.
  LawDescription open = turn([](double x) { return std::sin(x) + 0.2 * std::cos(3 * x); }, 90);
  open.points.pop_back();
  open.period = 2 * kPi;
  const MotionLaw same = law_of(open);
  EXPECT_EQ(same.end(), 2 * kPi);
  for (double x = 0; x < 6; x += 0.1) EXPECT_NEAR(law.derivative(2, x), same.derivative(2, x), 1e-9);
}

TEST(SplineLaw, GoesOnHigherWhereItsLastPointIsHigher) {
  LawDescription description = table([](double x) { return x + std::sin(x); }, 0, 2 * kPi, 60);
  description.ends = SplineEnds::kPeriodic;
  description.repeats = true;
  const MotionLaw law = law_of(description);
  EXPECT_NEAR(law.advance(), 2 * kPi, 1e-13);
  for (double x = -7; x < 20; x += 0.37) {
    EXPECT_NEAR(law(x), x + std::sin(x), 1e-7);
    EXPECT_NEAR(law.derivative(2, x), -std::sin(x), 1e-4);
  }
}

// A 3-4-5 lift of 10 mm with 90° each of dwell, rise, dwell and fall, tabulated in steps of 1° and rounded to
// 1 µm. Compares the effect of the rounding on acceleration (peak 23.4 mm/rad²) for a spline through the
// points and for one that may deviate from them by half a unit of the last decimal.
TEST(SplineLaw, SmoothingTakesTheRoundingOfATableOutOfAcceleration) {
  const double quarter = kPi / 2;
  const MotionLaw truth = law_of({{LawType::kDwell, quarter},
                                  {LawType::kPolynomial345, quarter, 10},
                                  {LawType::kDwell, quarter},
                                  {LawType::kPolynomial345, quarter, -10}},
                                 true);
  LawDescription rounded = turn([&](double x) { return std::round(truth(x) * 1000) / 1000; }, 360);
  const auto exact = [&](double x, int k) { return truth.derivative(k, x); };
  const auto noisy = largest_errors(law_of(rounded), exact);
  EXPECT_GT(noisy[2], 8);
  rounded.smoothing = 0.0005;
  const MotionLaw smooth = law_of(rounded);
  const auto calm = largest_errors(smooth, exact);
  EXPECT_LT(calm[2], 1.4);
  EXPECT_LT(calm[0], 0.001);
  for (const Vector2d& point : rounded.points) {
    EXPECT_LE(std::abs(smooth(point.x()) - point.y()), 0.0005 * (1 + 1e-9));
  }
}

// A table of many points is smoothed with a large weight, which squares a condition number: only without loss
// of digits do points and tolerance alone determine the law, and its jerk above all.
TEST(SplineLaw, SmoothingIsTheSameInOtherUnits) {
  LawDescription degrees;
  LawDescription radians;
  for (int i = 0; i < 3600; ++i) {
    const double x = i / 10.0;
    const double t = std::max(0.0, 1 - std::abs(x - 180) / 60);
    const double s = std::round(1e7 * t * t * t * (10 - 15 * t + 6 * t * t)) / 1e6;
    degrees.points.emplace_back(x, s);
    radians.points.emplace_back(x * kPi / 180, s / 1000);
  }
  degrees.smoothing = 1e-6;
  radians.smoothing = 1e-9;
  degrees.period = 360;
  radians.period = 2 * kPi;
  for (LawDescription* description : {&degrees, &radians}) {
    description->ends = SplineEnds::kPeriodic;
    description->repeats = true;
  }
  const MotionLaw one = law_of(degrees);
  const MotionLaw other = law_of(radians);
  const double per_degree = kPi / 180;
  std::array<double, 4> largest{};
  for (int k = 0; k < 4; ++k) {
    largest[k] = std::abs(one.extremes(k).peak());
  }
  double farthest = 0;
  for (int i = 0; i < 3600; ++i) {
    const double x = i / 10.0;
    EXPECT_LE(std::abs(one(x) - degrees.points[i].y()), 1e-6 * (1 + 1e-6));
    farthest = std::max(farthest, std::abs(one(x) - degrees.points[i].y()));
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(one.derivative(k, x), 1000 * std::pow(per_degree, k) * other.derivative(k, x * per_degree),
                  1e-6 * largest[k])
          << k << " at " << x;
    }
  }
  EXPECT_GE(farthest, 1e-6 * (1 - 1e-3));
}

TEST(SplineLaw, EnoughSmoothingMakesAPolynomial) {
  LawDescription description = table([](double x) { return 1 + x * x; }, 0, 3, 30);
  for (std::size_t i = 0; i < description.points.size(); ++i) {
    description.points[i].y() += i % 2 == 0 ? 0.01 : -0.01;
  }
  description.smoothing = 0.02;
  const MotionLaw law = law_of(description);
  EXPECT_LT(std::abs(law.extremes(3).peak()), 0.05);
  EXPECT_NEAR(law.derivative(2, 1.5), 2, 0.05);
}

TEST(SplineLaw, ManyPointsAreFitted) {
  const MotionLaw law = law_of(turn([](double x) { return std::sin(x); }, 3600));
  EXPECT_NEAR(law.derivative(1, 1.0), std::cos(1.0), 1e-10);
  EXPECT_NEAR(law.extremes(1).greatest, 1, 1e-9);
}

std::string spline_fault(const LawDescription& description) {
  const auto law = MotionLaw::make(description);
  if (law) return "none";
  const LawFault& what = law.error();
  return (what.point ? std::to_string(*what.point) + "." : "") + what.key + ": " + what.rule;
}

TEST(SplineLaw, RefusesWhatIsNoTable) {
  EXPECT_EQ(spline_fault({.points = {{0, 0}, {1, 2}}}), ": a spline needs at least 3 points, found 2");
  EXPECT_EQ(spline_fault({.points = {{0, 0}, {1, 2}, {2, 0}}, .ends = SplineEnds::kPeriodic}),
            ": a spline needs at least 4 points, found 3");
  EXPECT_EQ(spline_fault({.points = {{0, 0}, {1, 2}, {1, 3}}}),
            "2.: has the same x as the point before, 1: give each x once");
  EXPECT_EQ(spline_fault({.points = {{0, 0}, {1, 2}, {0.5, 3}}}),
            "2.: x must grow from point to point: 0.5 comes after 1");
  EXPECT_EQ(spline_fault({.points = {{0, 0}, {1, std::numeric_limits<double>::infinity()}, {2, 3}}}),
            "1.: is not finite");
  EXPECT_EQ(spline_fault({.points = {{0, 0}, {1, 2}, {2, 3}}, .degree = 4}), "degree: must be 3 or 5");
  EXPECT_EQ(spline_fault({.points = {{0, 0}, {1, 2}, {2, 3}}, .smoothing = -1}), "smoothing: must be >= 0");
  EXPECT_EQ(spline_fault({.points = {{0, 0}, {1, 2}, {2, 3}}, .ends = SplineEnds::kPeriodic, .period = 2}),
            "period: must be longer than the points are apart");
}

}  // namespace
}  // namespace higherpair

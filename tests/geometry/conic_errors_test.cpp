// Numbers that define no curve are refused, each with its reason.
#include "geometry/geometry_testing.hpp"
#include "support/texts.hpp"

#include <limits>
#include <set>
#include <string>

namespace higherpair {
namespace {

using testing::contains;

using namespace higherpair::testing;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
using Six = std::array<double, 6>;

struct Refused {
  std::string what;
  Six coefficients;
  CurveError error;
};

std::vector<Refused> refused_conics() {
  return {
      {"no real point: circle", {1, 1, 0, 0, 0, 1}, CurveError::kImaginary},
      {"no real point: ellipse off the origin", {1, 2, 1, 3, -1, 9}, CurveError::kImaginary},
      {"no real point: parallel lines", {1, 0, 0, 0, 0, 1}, CurveError::kImaginary},
      {"no real point: inclined parallel lines", {1, 4, 4, 2, 4, 5}, CurveError::kImaginary},
      {"one point: origin", {1, 1, 0, 0, 0, 0}, CurveError::kSinglePoint},
      {"one point: (1, -2)", {1, 1, 0, -2, 4, 5}, CurveError::kSinglePoint},
      {"one point: flat ellipse", {1, 3, 2, 0, 0, 0}, CurveError::kSinglePoint},
      {"crossing lines: x² = y²", {1, -1, 0, 0, 0, 0}, CurveError::kLines},
      {"crossing lines: axes", {0, 0, 1, 0, 0, 0}, CurveError::kLines},
      {"crossing lines: (x - 1)(y + 2)", {0, 0, 1, 2, -1, -2}, CurveError::kLines},
      {"parallel lines: x² = 1", {1, 0, 0, 0, 0, -1}, CurveError::kLines},
      {"parallel lines: (x + 2y + 1)(x + 2y - 3)", {1, 4, 4, -2, -4, -3}, CurveError::kLines},
      {"one line twice: x² = 0", {1, 0, 0, 0, 0, 0}, CurveError::kLines},
      {"one line twice: (3x - y + 2)²", {9, 1, -6, 12, -4, 4}, CurveError::kLines},
      {"a single line", {0, 0, 0, 1, 2, 3}, CurveError::kNoQuadraticPart},
      {"nothing", {0, 0, 0, 0, 0, 0}, CurveError::kNoQuadraticPart},
      {"a constant", {0, 0, 0, 0, 0, 7}, CurveError::kNoQuadraticPart},
      {"hyperbola without a branch", {1, -1, 0, 0, 0, -1}, CurveError::kBranchNeeded},
  };
}

TEST(ConicErrors, EachDegenerateConicIsRefusedWithItsReasonWhateverItsFactor) {
  for (const Refused& refused : refused_conics()) {
    for (const double factor : {1.0, -1.0, 1e12, -1e-12, 0.3, 1e-200}) {
      SCOPED_TRACE(refused.what + " times " + std::to_string(factor));
      Six k = refused.coefficients;
      for (double& value : k) value *= factor;
      const auto curve = make_conic(k);
      ASSERT_FALSE(curve);
      EXPECT_EQ(curve.error(), refused.error) << describe(curve.error());
    }
  }
}

// The product of two lines a·p + c and b·p + d, rounded to double.
Six product(const Vector2d& a, double c, const Vector2d& b, double d) {
  return {a.x() * b.x(),         a.y() * b.y(),         a.x() * b.y() + a.y() * b.x(),
          a.x() * d + b.x() * c, a.y() * d + b.y() * c, c * d};
}

TEST(ConicErrors, LinesAreRefusedThoughTheirCoefficientsAreRounded) {
  Random random(51);
  for (int i = 0; i < 20000; ++i) {
    const Vector2d a = unit_vector(random.angle());
    const bool parallel = i % 3 == 0;
    const double crossing = i % 3 == 1 ? random.angle() : std::pow(10, random.between(-9, 0));
    const Vector2d b = parallel ? a : unit_vector(angle_of(a) + crossing);
    const double size = std::pow(10, random.between(-3, 3));
    const double c = size * random.between(-2, 2);
    const double d = i % 6 == 0 ? c : size * random.between(-2, 2);
    const auto curve = make_conic(product(a, c, b, d), Side::kInside, random.vector(3));
    ASSERT_FALSE(curve) << "number " << i << ": semi_latus " << curve->semi_latus << ", q " << curve->q;
    // A double line may be rounded to a conic without points, and nearly parallel lines to anything.
    if (i % 6 != 0 && std::abs(cross(a, b)) > 1e-6) {
      EXPECT_EQ(curve.error(), CurveError::kLines) << i;
    }
  }
}

TEST(ConicErrors, APointIsRefusedThoughItsCoefficientsAreRounded) {
  Random random(52);
  for (int i = 0; i < 5000; ++i) {
    const Vector2d a = unit_vector(random.angle());
    const Vector2d b = random.between(0.2, 1) * perp(a);
    const double c = random.between(-2, 2);
    const double d = random.between(-2, 2);
    const Six first = product(a, c, a, c);
    const Six second = product(b, d, b, d);
    Six sum{};
    for (std::size_t k = 0; k < 6; ++k) sum[k] = first[k] + second[k];
    const auto point = make_conic(sum);
    ASSERT_FALSE(point) << "number " << i << ": semi_latus " << point->semi_latus;
    EXPECT_EQ(point.error(), CurveError::kSinglePoint);

    sum[5] += 1e-3;
    const auto nothing = make_conic(sum);
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error(), CurveError::kImaginary);
    sum[5] -= 2e-3;
    EXPECT_TRUE(make_conic(sum));
  }
}

TEST(ConicErrors, ABranchPointInTheMiddleIsUnclear) {
  const Six hyperbola{1, -1, 0, 0, 0, -1};
  EXPECT_EQ(make_conic(hyperbola, Side::kInside, Vector2d(0, 0.7)).error(), CurveError::kBranchUnclear);
  EXPECT_EQ(make_conic(hyperbola, Side::kInside, Vector2d(kNan, 0)).error(), CurveError::kNotFinite);
  EXPECT_EQ(make_conic(hyperbola, Side::kInside, Vector2d(0, kInf)).error(), CurveError::kNotFinite);
}

TEST(ConicErrors, NoCoefficientMayBeInfiniteOrNoNumber) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (const double bad : {kNan, kInf, -kInf}) {
      Six k{1, 1, 0, 0, 0, -1};
      k[i] = bad;
      EXPECT_EQ(make_conic(k).error(), CurveError::kNotFinite);
    }
  }
}

TEST(ConicErrors, NaturalParametersMustBeFiniteAndPositive) {
  const Vector2d o(0.031, 0.0127);
  for (const double bad : {0.0, -0.02}) {
    EXPECT_EQ(make_circle(o, bad).error(), CurveError::kNotPositive);
    EXPECT_EQ(make_ellipse(o, {bad, 1}, 0).error(), CurveError::kNotPositive);
    EXPECT_EQ(make_ellipse(o, {1, bad}, 0).error(), CurveError::kNotPositive);
    EXPECT_EQ(make_parabola(o, bad, 0).error(), CurveError::kNotPositive);
    EXPECT_EQ(make_hyperbola(o, {bad, 1}, 0).error(), CurveError::kNotPositive);
    EXPECT_EQ(make_hyperbola(o, {1, bad}, 0).error(), CurveError::kNotPositive);
  }
  for (const double bad : {kNan, kInf, -kInf}) {
    for (const Vector2d& place : {Vector2d(bad, 0), Vector2d(0, bad)}) {
      EXPECT_EQ(make_circle(place, 1).error(), CurveError::kNotFinite);
      EXPECT_EQ(make_ellipse(place, {2, 1}, 0).error(), CurveError::kNotFinite);
      EXPECT_EQ(make_parabola(place, 1, 0).error(), CurveError::kNotFinite);
      EXPECT_EQ(make_hyperbola(place, {2, 1}, 0).error(), CurveError::kNotFinite);
      EXPECT_EQ(make_line(place, {1, 0}).error(), CurveError::kNotFinite);
      EXPECT_EQ(make_line(o, place).error(), CurveError::kNotFinite);
      EXPECT_EQ(make_point(place).error(), CurveError::kNotFinite);
    }
    EXPECT_EQ(make_circle(o, bad).error(), CurveError::kNotFinite);
    EXPECT_EQ(make_ellipse(o, {bad, 1}, 0).error(), CurveError::kNotFinite);
    EXPECT_EQ(make_ellipse(o, {1, bad}, 0).error(), CurveError::kNotFinite);
    EXPECT_EQ(make_ellipse(o, {2, 1}, bad).error(), CurveError::kNotFinite);
    EXPECT_EQ(make_parabola(o, bad, 0).error(), CurveError::kNotFinite);
    EXPECT_EQ(make_parabola(o, 1, bad).error(), CurveError::kNotFinite);
    EXPECT_EQ(make_hyperbola(o, {bad, 1}, 0).error(), CurveError::kNotFinite);
    EXPECT_EQ(make_hyperbola(o, {1, bad}, 0).error(), CurveError::kNotFinite);
    EXPECT_EQ(make_hyperbola(o, {1, 2}, bad).error(), CurveError::kNotFinite);
  }
  EXPECT_EQ(make_line(o, Vector2d::Zero()).error(), CurveError::kZeroNormal);
}

bool is_sound(const Curve& curve) {
  const bool finite = curve.vertex_B.allFinite() && curve.axis_B.allFinite() &&
                      std::isfinite(curve.semi_latus) && std::isfinite(curve.q);
  const bool right_q = (curve.kind == CurveKind::kEllipse && curve.q > 0 && curve.q <= 1) ||
                       (curve.kind == CurveKind::kCircle && curve.q == 1) ||
                       (curve.kind == CurveKind::kParabola && curve.q == 0) ||
                       (curve.kind == CurveKind::kHyperbola && curve.q < 0);
  return finite && right_q && curve.semi_latus > 0 && std::abs(curve.axis_B.norm() - 1) < 1e-14;
}

TEST(ConicErrors, AnySixNumbersMakeASoundCurveOrNone) {
  Random random(53);
  int made = 0;
  for (int i = 0; i < 100000; ++i) {
    const double reach = i % 2 == 0 ? 320 : 8;  // exponents up to the smallest and largest doubles
    Six k{};
    for (double& value : k) {
      value = random.index(4) == 0 ? 0 : random.sign() * std::pow(10, random.between(-reach, reach - 12));
    }
    if (random.index(2) == 0) k[1] = k[0];
    if (random.index(4) == 0) k[2] = 2 * k[0];
    const auto curve = make_conic(k, Side::kInside, random.vector(1));
    if (!curve) continue;
    ++made;
    EXPECT_TRUE(is_sound(*curve)) << k[0] << " " << k[1] << " " << k[2] << " " << k[3] << " " << k[4] << " "
                                  << k[5];
  }
  EXPECT_GT(made, 10000);
}

TEST(ConicErrors, AnyParametersMakeASoundCurveOrNone) {
  Random random(54);
  for (int i = 0; i < 10000; ++i) {
    const double a = std::pow(10, random.between(-323, 308));
    const double b = std::pow(10, random.between(-323, 308));
    const Vector2d place = std::pow(10, random.between(-300, 300)) * random.vector(1);
    for (const auto& curve : {make_circle(place, a), make_ellipse(place, {a, b}, 0.3),
                              make_parabola(place, a, 0.3), make_hyperbola(place, {a, b}, 0.3)}) {
      EXPECT_TRUE(!curve || is_sound(*curve)) << a << " " << b << " " << place.transpose();
    }
    const auto line = make_line(place, Vector2d(a, b));
    ASSERT_TRUE(!line || std::abs(line->axis_B.norm() - 1) < 1e-14) << a << " " << b;
  }
}

TEST(ConicErrors, EachHasItsOwnReadableText) {
  const std::vector<std::pair<CurveError, std::string>> words{
      {CurveError::kNotFinite, "finite"},
      {CurveError::kNotPositive, "> 0"},
      {CurveError::kZeroNormal, "zero"},
      {CurveError::kNoQuadraticPart, "no conic"},
      {CurveError::kImaginary, "no real point"},
      {CurveError::kSinglePoint, "single point"},
      {CurveError::kLines, "lines"},
      {CurveError::kOutOfRange, "too large or too small"},
      {CurveError::kBranchNeeded, "near = [x, y]"},
      {CurveError::kBranchUnclear, "between"},
  };
  std::set<std::string> texts;
  for (const auto& [error, word] : words) {
    const std::string text(describe(error));
    EXPECT_TRUE(contains(text, word));
    texts.insert(text);
  }
  EXPECT_EQ(texts.size(), words.size());
  // Where there is an alternative, the message says what to write instead.
  EXPECT_TRUE(contains(std::string(describe(CurveError::kLines)), "type \"line\""));
  EXPECT_TRUE(contains(std::string(describe(CurveError::kSinglePoint)), "type \"point\""));
}

}  // namespace
}  // namespace higherpair

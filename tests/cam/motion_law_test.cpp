#include "higherpair/cam/motion_law.hpp"

#include "cam/law_testing.hpp"
#include "higherpair/cam/law_series.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::kRises;
using testing::law_of;

constexpr double kOver = 1.37;
constexpr double kRise = 2.9;

// Largest |k-th derivative| of a rise of kRise over kOver, divided by rise/over^k.
double factor(const MotionLaw& law, int k) {
  return std::abs(law.extremes(k).peak()) * std::pow(law.end() - law.begin(), k) / kRise;
}

struct Peaks {
  LawType type;
  double v, a, j;
};

// Closed forms; those of the modified laws from the area under their acceleration.
TEST(PeakFactors, AreThoseOfTheTextbooks) {
  const double trapezoid = 8 * kPi / (2 + kPi);
  const double sine = 4 * kPi * kPi / (4 + kPi);
  const Peaks table[] = {
      {LawType::kUniform, 1, 0, 0},
      {LawType::kParabolic, 2, 4, 0},
      {LawType::kHarmonic, kPi / 2, kPi * kPi / 2, kPi * kPi * kPi / 2},
      {LawType::kCycloidal, 2, 2 * kPi, 4 * kPi * kPi},
      {LawType::kModifiedSine, 4 * kPi / (4 + kPi), sine, 4 * kPi * sine},
      {LawType::kModifiedTrapezoid, 2, trapezoid, 4 * kPi * trapezoid},
      {LawType::kPolynomial345, 15.0 / 8, 10 / std::sqrt(3), 60},
      {LawType::kPolynomial4567, 35.0 / 16, 84 * std::sqrt(5) / 25, 52.5},
  };
  for (const Peaks& row : table) {
    const MotionLaw law = law_of({{row.type, kOver, kRise}});
    EXPECT_NEAR(factor(law, 1), row.v, 1e-14) << static_cast<int>(row.type);
    EXPECT_NEAR(factor(law, 2), row.a, 1e-13) << static_cast<int>(row.type);
    EXPECT_NEAR(factor(law, 3), row.j, 1e-12) << static_cast<int>(row.type);
  }
}

// As printed in Norton, Cam Design and Manufacturing Handbook, and Rothbart, Cam Design Handbook.
TEST(PeakFactors, AgreeWithPublishedDecimals) {
  const Peaks table[] = {
      {LawType::kPolynomial345, 1.875, 5.7735, 60},      {LawType::kPolynomial4567, 2.1875, 7.5132, 52.5},
      {LawType::kCycloidal, 2, 6.2832, 39.4784},         {LawType::kModifiedTrapezoid, 2, 4.8881, 61.4260},
      {LawType::kModifiedSine, 1.7596, 5.5280, 69.4664}, {LawType::kHarmonic, 1.5708, 4.9348, 15.5031},
  };
  for (const Peaks& row : table) {
    const MotionLaw law = law_of({{row.type, kOver, kRise}});
    EXPECT_NEAR(factor(law, 1), row.v, 6e-5);
    EXPECT_NEAR(factor(law, 2), row.a, 6e-5);
    EXPECT_NEAR(factor(law, 3), row.j, 6e-5);
  }
}

// Sums of sines: acceleration 15/16 sin x + 3/16 sin 3x, or 27/28 and 3/28. Their peaks follow from sin 3x =
// 3s - 4s³ with s = sin x.
TEST(PeakFactors, OfHarmonicSumsAreThoseOfGutmanAndFreudenstein) {
  const auto sum = [](double first) {
    return law_of({{.type = LawType::kHarmonics,
                    .over = kOver,
                    .rise = kRise,
                    .sines = {-kRise * first / (2 * kPi), 0, -kRise * (1 - first) / (6 * kPi)}}});
  };
  const MotionLaw gutman = sum(15.0 / 16);
  EXPECT_NEAR(factor(gutman, 1), 2, 1e-14);
  EXPECT_NEAR(factor(gutman, 2), 2 * kPi * std::sqrt(2.0 / 3), 1e-13);
  EXPECT_NEAR(factor(gutman, 3), 6 * kPi * kPi, 1e-12);
  const MotionLaw freudenstein = sum(27.0 / 28);
  EXPECT_NEAR(factor(freudenstein, 1), 2, 1e-14);
  EXPECT_NEAR(factor(freudenstein, 2), 2 * kPi * 6 / 7, 1e-13);
  EXPECT_NEAR(factor(freudenstein, 3), 4 * kPi * kPi * 9 / 7, 1e-12);
}

// The double harmonic, s = h/2 ((1 - cos πu) - (1 - cos 2πu)/4), is the first half of a sum over twice the
// segment.
TEST(PeakFactors, OfTheDoubleHarmonicAreThoseOfTheTextbooks) {
  const MotionLaw law = law_of({{.type = LawType::kHarmonics, .over = 2, .cosines = {-0.5, 0.125}}});
  EXPECT_NEAR(law(1.0), 1, 1e-15);
  EXPECT_NEAR(law.extremes(1, 0, 1).greatest, 2.040524, 5e-7);
  EXPECT_NEAR(std::abs(law.extremes(2, 0, 1).peak()), kPi * kPi, 1e-13);
  EXPECT_NEAR(std::abs(law.extremes(3, 0, 1).peak()), 42.41372, 5e-6);
}

// The number at the end of a cell of a table, "4π^2 = 39.478418".
std::optional<double> number_at_end(const std::string& cell) {
  const std::size_t end = cell.find_last_not_of(' ');
  const std::size_t begin = end == std::string::npos ? end : cell.find_last_of(" =", end);
  const std::string word = begin == std::string::npos ? "" : cell.substr(begin + 1, end - begin);
  return word.find_first_not_of("0123456789.") == std::string::npos && !word.empty()
             ? std::optional(std::stod(word))
             : std::nullopt;
}

TEST(PeakFactors, AreThoseOfTheDocumentation) {
  std::ifstream page(HIGHERPAIR_SOURCE_DIR "/docs/laws.md");
  int rows = 0;
  for (std::string line; std::getline(page, line);) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(cell);
    const auto type = std::find_if(std::begin(kRises), std::end(kRises), [&](LawType candidate) {
      return cells.size() == 6 &&
             cells[1] == " `" + std::string(kLawNames[static_cast<std::size_t>(candidate)]) + "` ";
    });
    if (type == std::end(kRises)) continue;
    ++rows;
    const MotionLaw law = law_of({{*type, kOver, kRise}});
    for (int k = 1; k <= 3; ++k) {
      if (const auto shown = number_at_end(cells[static_cast<std::size_t>(k) + 1])) {
        EXPECT_NEAR(factor(law, k), *shown, 6e-7) << line;
      }
    }
    double product = 0;
    for (int i = 0; i <= 100000; ++i) {
      const auto s = series_at<2>(law, kOver * i / 100000);
      product = std::max(product, std::abs(s.c[1] * 2 * s.c[2]) * std::pow(kOver, 3) / (kRise * kRise));
    }
    if (const auto shown = number_at_end(cells[5])) {
      EXPECT_NEAR(product, *shown, 2e-6) << line;
    }
  }
  EXPECT_EQ(rows, 8);
}

TEST(PeakFactors, ComeWithTheirPlaces) {
  const MotionLaw law = law_of({{LawType::kCycloidal, 4, 3}});
  EXPECT_NEAR(law.extremes(1).greatest_at, 2, 1e-14);
  EXPECT_EQ(law.extremes(1).least, 0);
  EXPECT_NEAR(law.extremes(2).greatest_at, 1, 1e-14);
  EXPECT_NEAR(law.extremes(2).least_at, 3, 1e-14);
  const LawExtremes a = law_of({{LawType::kPolynomial345, 1, 1}}).extremes(2);
  EXPECT_NEAR(a.greatest_at, (3 - std::sqrt(3)) / 6, 1e-14);
  EXPECT_NEAR(a.least_at, (3 + std::sqrt(3)) / 6, 1e-14);
}

TEST(MotionLaw, BeginsAndEndsExactly) {
  for (const LawType type : kRises) {
    const MotionLaw law = law_of({{LawType::kDwell, 0.7}, {type, kOver, kRise}, {LawType::kDwell, 0.3}});
    const double end = 0.7 + kOver;
    EXPECT_EQ(law(0.7), 0);
    EXPECT_EQ(law(end, LawSide::kBefore), kRise) << static_cast<int>(type);
    EXPECT_EQ(law(end), kRise);
    if (type != LawType::kUniform) {
      EXPECT_EQ(law.derivative(1, 0.7), 0);
      EXPECT_EQ(law.derivative(1, end, LawSide::kBefore), 0) << static_cast<int>(type);
    }
  }
  for (const LawType type : {LawType::kCycloidal, LawType::kModifiedSine, LawType::kModifiedTrapezoid,
                             LawType::kPolynomial345, LawType::kPolynomial4567}) {
    const MotionLaw law = law_of({{type, kOver, kRise}});
    EXPECT_EQ(law.derivative(2, 0), 0);
    EXPECT_EQ(law.derivative(2, kOver, LawSide::kBefore), 0) << static_cast<int>(type);
  }
  const MotionLaw smooth = law_of({{LawType::kPolynomial4567, kOver, kRise}});
  EXPECT_EQ(smooth.derivative(3, 0), 0);
  EXPECT_EQ(smooth.derivative(3, kOver, LawSide::kBefore), 0);
}

TEST(MotionLaw, IsSymmetricAboutTheMiddleOfASegment) {
  for (const LawType type : kRises) {
    const MotionLaw law = law_of({{type, kOver, kRise}});
    EXPECT_NEAR(law(kOver / 2), kRise / 2, 1e-15 * kRise);
    for (double x = 0.001; x < kOver / 2; x += 0.0137) {
      EXPECT_NEAR(law(x) + law(kOver - x), kRise, 1e-14);
      EXPECT_NEAR(law.derivative(1, x), law.derivative(1, kOver - x), 1e-13);
      EXPECT_NEAR(law.derivative(2, x), -law.derivative(2, kOver - x), 1e-12);
    }
  }
}

// The closed forms of textbooks.
TEST(MotionLaw, FollowsTheFormulas) {
  const auto s = [](LawType type, double u) { return law_of({{type, kOver, kRise}})(u * kOver) / kRise; };
  for (double u = 0; u <= 1; u += 1.0 / 64) {
    EXPECT_NEAR(s(LawType::kUniform, u), u, 1e-15);
    EXPECT_NEAR(s(LawType::kParabolic, u), u < 0.5 ? 2 * u * u : 1 - 2 * (1 - u) * (1 - u), 1e-15);
    EXPECT_NEAR(s(LawType::kHarmonic, u), (1 - std::cos(kPi * u)) / 2, 1e-15);
    EXPECT_NEAR(s(LawType::kCycloidal, u), u - std::sin(2 * kPi * u) / (2 * kPi), 1e-15);
    EXPECT_NEAR(s(LawType::kPolynomial345, u), u * u * u * (10 + u * (-15 + u * 6)), 4e-15);
    EXPECT_NEAR(s(LawType::kPolynomial4567, u), std::pow(u, 4) * (35 + u * (-84 + u * (70 - 20 * u))), 4e-14);
    const double sine = u < 0.125   ? kPi * u - std::sin(4 * kPi * u) / 4
                        : u < 0.875 ? 2 + kPi * u - 9.0 / 4 * std::sin((kPi + 4 * kPi * u) / 3)
                                    : 4 + kPi * u - std::sin(4 * kPi * u) / 4;
    EXPECT_NEAR(s(LawType::kModifiedSine, u), sine / (4 + kPi), 4e-15);
  }
  // The modified trapezoid at the ends of its parts.
  const double per = 1 / (2 + kPi);
  EXPECT_NEAR(s(LawType::kModifiedTrapezoid, 0.125), per * (0.25 - 1 / (2 * kPi)), 1e-15);
  EXPECT_NEAR(s(LawType::kModifiedTrapezoid, 0.375), per * (0.25 - 1 / (2 * kPi) + 0.5 + kPi / 4), 1e-15);
}

TEST(MotionLaw, VelocityIntegratesToTheRise) {
  for (const LawType type : kRises) {
    const MotionLaw law = law_of({{type, kOver, kRise}});
    constexpr int kParts = 4000;  // a multiple of 8, so that the jerk does not jump within a part
    const double h = kOver / kParts;
    double sum = 0;
    for (int i = 0; i < kParts; ++i) {
      for (const double place : {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}) {
        sum += (place == 0 ? 8 : 5) * law.derivative(1, (i + 0.5 + place / 2) * h) * h / 18;
      }
    }
    EXPECT_NEAR(sum, kRise, 1e-12) << static_cast<int>(type);
  }
}

double difference(const MotionLaw& law, int k, double x, double h) {
  const auto f = [&](double y) { return law.derivative(k, y); };
  return (45 * (f(x + h) - f(x - h)) - 9 * (f(x + 2 * h) - f(x - 2 * h)) + (f(x + 3 * h) - f(x - 3 * h))) /
         (60 * h);
}

TEST(MotionLaw, DerivativesAreThoseOfDifferences) {
  std::vector<LawSegment> segments;
  for (const LawType type : kRises) {
    segments.push_back({type, kOver, kRise});
  }
  segments.push_back(
      {.type = LawType::kHarmonics, .over = 2, .rise = 1, .cosines = {0.3, -0.2}, .sines = {0.1, 0, 0.4}});
  const MotionLaw law = law_of(segments);
  const double value = law(law.end());
  LawSegment polynomial{.type = LawType::kPolynomial, .over = 1.7};
  polynomial.start = {value, -1, 2, 0.3};
  polynomial.end = {-2, 0.4, 7};
  segments.push_back(polynomial);
  const MotionLaw all = law_of(segments);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0, all.end());
  for (int i = 0; i < 2000; ++i) {
    const double x = anywhere(random);
    const double h = 1e-3;
    // The parts of a law begin at multiples of an eighth of the segment.
    bool at_join = false;
    double begin = 0;
    for (const LawSegment& segment : segments) {
      const double eighth = 8 * (x - begin) / segment.over;
      at_join = at_join || std::abs(eighth - std::round(eighth)) * segment.over / 8 < 4 * h;
      begin += segment.over;
    }
    for (int k = 1; !at_join && k <= 6; ++k) {
      const double exact = all.derivative(k, x);
      EXPECT_NEAR(exact, difference(all, k - 1, x, h), 1e-9 * std::pow(10, k)) << k << " at " << x;
    }
    std::array<double, 8> c{};
    all.expand(x, LawSide::kAfter, c);
    double factorial = 1;
    for (int k = 0; k < 8; ++k) {
      const double exact = all.derivative(k, x);
      EXPECT_NEAR(factorial * c[k], exact, 1e-13 * (std::abs(exact) + std::pow(20, k)));
      factorial *= k + 1;
    }
  }
}

TEST(MotionLaw, ReproducesTheBoundaryConditionsOfAPolynomial) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-5, 5);
  for (std::size_t p = 1; p <= 8; ++p) {
    for (std::size_t q = 1; q <= 8; ++q) {
      LawSegment segment{.type = LawType::kPolynomial, .over = 0.83};
      for (std::size_t k = 0; k < p; ++k) segment.start.push_back(number(random));
      for (std::size_t k = 0; k < q; ++k) segment.end.push_back(number(random));
      const MotionLaw law = law_of({segment});
      for (std::size_t k = 0; k < p; ++k) {
        EXPECT_NEAR(law.derivative(static_cast<int>(k), 0), segment.start[k], 1e-14 * 5);
      }
      for (std::size_t k = 0; k < q; ++k) {
        EXPECT_NEAR(law.derivative(static_cast<int>(k), 0.83, LawSide::kBefore), segment.end[k], 1e-14 * 5);
      }
      // Both halves are the same polynomial.
      const auto degree = static_cast<int>(p + q) - 1;
      for (int k = 0; k <= degree; ++k) {
        const double below = law.derivative(k, 0.415, LawSide::kBefore);
        const double above = law.derivative(k, 0.415, LawSide::kAfter);
        double scale = 10;
        for (int i = 0; i < k; ++i) scale *= (degree - i + 1) / 0.415;
        EXPECT_NEAR(below, above, 1e-12 * scale) << p << ' ' << q << ' ' << k;
      }
      EXPECT_EQ(law.derivative(degree + 1, 0.3), 0);
    }
  }
}

TEST(MotionLaw, APolynomialWithVanishingConditionsIsTheNamedOne) {
  LawSegment general{.type = LawType::kPolynomial, .over = kOver};
  general.start = {0, 0, 0};
  general.end = {kRise, 0, 0};
  const MotionLaw law = law_of({general});
  const MotionLaw named = law_of({{LawType::kPolynomial345, kOver, kRise}});
  general.start = {0, 0, 0, 0};
  general.end = {kRise, 0, 0, 0};
  const MotionLaw higher = law_of({general});
  const MotionLaw higher_named = law_of({{LawType::kPolynomial4567, kOver, kRise}});
  for (double x = 0; x < kOver; x += 0.01) {
    EXPECT_NEAR(law(x), named(x), 2e-15);
    EXPECT_NEAR(higher.derivative(2, x), higher_named.derivative(2, x), 2e-13);
  }
}

TEST(MotionLaw, ReportsWhatJumpsAtItsJoins) {
  const MotionLaw law =
      law_of({{LawType::kUniform, 2, 3}, {LawType::kParabolic, 2, 4}, {LawType::kCycloidal, 2, -7}});
  std::vector<double> places;
  std::vector<int> jumps;
  for (const LawJoin& join : law.joins()) {
    places.push_back(join.x);
    jumps.push_back(join.lowest_jump());
  }
  EXPECT_THAT(places, ElementsAre(0, 2, 3, 4, 6));
  EXPECT_THAT(jumps, ElementsAre(1, 1, 2, 2, 3));
  const LawJoin& at_start = law.joins()[0];
  EXPECT_THAT(at_start.before, ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(at_start.after, ElementsAre(0, 1.5, 0, 0));
  EXPECT_THAT(law.joins()[1].before, ElementsAre(3, 1.5, 0, 0));
  EXPECT_THAT(law.joins()[1].after, ElementsAre(3, 0, 4, 0));
  EXPECT_THAT(law.joins()[2].before, ElementsAre(5, 4, 4, 0));
  EXPECT_THAT(law.joins()[2].after, ElementsAre(5, 4, -4, 0));
}

TEST(MotionLaw, TakesTheSideThatIsAskedForAtAJoin) {
  const MotionLaw law = law_of({{LawType::kUniform, 2, 3}, {LawType::kUniform, 2, -1}});
  EXPECT_EQ(law.derivative(1, 2, LawSide::kBefore), 1.5);
  EXPECT_EQ(law.derivative(1, 2, LawSide::kAfter), -0.5);
  // A position within rounding of the join counts as the join.
  EXPECT_EQ(law.derivative(1, std::nextafter(2, 3), LawSide::kBefore), 1.5);
  EXPECT_EQ(law.derivative(1, std::nextafter(2, 0), LawSide::kAfter), -0.5);
  EXPECT_EQ(law.derivative(1, 2 + 1e-12, LawSide::kBefore), -0.5);
  EXPECT_EQ(law.derivative(1, 2 - 1e-12, LawSide::kAfter), 1.5);
}

TEST(MotionLaw, StaysBeyondItsEndsUnlessItRepeats) {
  const MotionLaw law = law_of({.origin = 1, .start = 5, .segments = {{LawType::kUniform, 2, 3}}});
  EXPECT_EQ(law(-100.0), 5);
  EXPECT_EQ(law(0.999), 5);
  EXPECT_EQ(law(2.0), 6.5);
  EXPECT_EQ(law(100.0), 8);
  EXPECT_EQ(law.derivative(1, 1, LawSide::kBefore), 0);
  EXPECT_EQ(law.derivative(1, 1, LawSide::kAfter), 1.5);
  EXPECT_EQ(law.derivative(1, 3, LawSide::kBefore), 1.5);
  EXPECT_EQ(law.derivative(1, 3, LawSide::kAfter), 0);
  EXPECT_EQ(law.advance(), 3);
}

TEST(MotionLaw, RepeatsEveryTurn) {
  const double third = 2 * kPi / 3;
  const MotionLaw law = law_of({{LawType::kCycloidal, third, kRise},
                                {LawType::kDwell, third},
                                {LawType::kPolynomial345, third, -kRise}},
                               true);
  EXPECT_EQ(law.advance(), 0);
  for (double x = 0.01; x < 2 * kPi; x += 0.1) {
    for (const int turn : {-3, -1, 1, 2, 1000}) {
      for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(law.derivative(k, x + turn * 2 * kPi), law.derivative(k, x), 1e-10);
      }
    }
  }
  EXPECT_EQ(law(2 * kPi, LawSide::kBefore), 0);
  EXPECT_EQ(law(-2 * kPi, LawSide::kAfter), 0);
  EXPECT_EQ(law.derivative(3, 0, LawSide::kBefore), law.derivative(3, 2 * kPi, LawSide::kBefore));
  EXPECT_NE(law.derivative(3, 0, LawSide::kBefore), law.derivative(3, 0, LawSide::kAfter));
}

TEST(MotionLaw, EveryRepetitionBeginsWhereTheOneBeforeEnds) {
  const MotionLaw law = law_of({{LawType::kCycloidal, 1, 0.25}, {LawType::kDwell, 1}}, true);
  EXPECT_EQ(law.advance(), 0.25);
  for (const double turn : {-4.0, -1.0, 0.0, 1.0, 7.0}) {
    EXPECT_NEAR(law(2 * turn + 0.5), 0.25 * turn + 0.125, 1e-15);
    EXPECT_EQ(law(2 * turn + 1.5), 0.25 * (turn + 1));
    EXPECT_EQ(law(2 * turn, LawSide::kBefore), 0.25 * turn);
    EXPECT_EQ(law(2 * turn, LawSide::kAfter), 0.25 * turn);
  }
  EXPECT_THAT(law.zeros(0, 0.5, 6), IsEmpty());
  EXPECT_LT(law.zeros(0, -3, 3).size(), 10U);  // where it dwells at 0
  EXPECT_NEAR(law.extremes(0, 0, 6).greatest, 0.75, 1e-15);
}

std::vector<LawSegment> everything() {
  std::vector<LawSegment> segments;
  double sense = 1;
  for (const LawType type : kRises) {
    segments.push_back({type, kOver, sense * kRise});
    segments.push_back({LawType::kDwell, 0.2});
    sense = -sense;
  }
  segments.push_back(
      {.type = LawType::kHarmonics, .over = 2, .cosines = {0.3, -0.2, 0, 0, 0.05}, .sines = {0.1, 0, 0.4}});
  return segments;
}

TEST(MotionLaw, BoundsHoldAndCloseUp) {
  const MotionLaw law = law_of(everything(), true);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(-20, 20), unit(0, 1);
  for (int i = 0; i < 3000; ++i) {
    const double from = anywhere(random);
    const double width = std::pow(10, -6 * unit(random));
    for (int k = 0; k < 4; ++k) {
      const Bounds bounds = law.bounds(k, from, from + width);
      for (int n = 0; n <= 10; ++n) {
        EXPECT_TRUE(bounds.contains(law.derivative(k, from + n * width / 10)))
            << k << ' ' << from << ' ' << width;
      }
    }
  }
  const Bounds tight = law.bounds(0, 0.6, 0.6 + 1e-6);
  EXPECT_LT(tight.width(), 1.1 * 1e-6 * law.derivative(1, 0.6) + 1e-13);
}

TEST(MotionLaw, ExtremesAreThoseOfManyPlaces) {
  const MotionLaw law = law_of(everything());
  for (int k = 0; k < 4; ++k) {
    const LawExtremes extremes = law.extremes(k);
    double least = 1e300, greatest = -1e300;
    for (int i = 0; i <= 200000; ++i) {
      const double value = law.derivative(k, law.end() * i / 200000.0);
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
    EXPECT_LE(extremes.least, least);
    EXPECT_GE(extremes.greatest, greatest);
    EXPECT_NEAR(extremes.least, least, 1e-2 * (greatest - least));
    EXPECT_NEAR(extremes.greatest, greatest, 1e-2 * (greatest - least));
    const auto is_there = [&](double value, double x) {
      return std::min(std::abs(law.derivative(k, x, LawSide::kBefore) - value),
                      std::abs(law.derivative(k, x, LawSide::kAfter) - value)) <= 1e-9 * (greatest - least);
    };
    EXPECT_TRUE(is_there(extremes.least, extremes.least_at)) << k;
    EXPECT_TRUE(is_there(extremes.greatest, extremes.greatest_at)) << k;
  }
}

TEST(MotionLaw, FindsZeros) {
  const MotionLaw law = law_of(
      {.start = -1, .segments = {{LawType::kCycloidal, 2, 2}, {LawType::kUniform, 1, -2}}, .repeats = true});
  EXPECT_THAT(law.zeros(0, 0.1, 2.9), ElementsAre(DoubleNear(1, 1e-15), DoubleNear(2.5, 1e-15)));
  EXPECT_THAT(law.zeros(0, 3.1, 5.9), ElementsAre(DoubleNear(4, 1e-14), DoubleNear(5.5, 1e-14)));
  EXPECT_THAT(law.zeros(2, 0.1, 1.9), ElementsAre(DoubleNear(1, 1e-15)));
  const MotionLaw corner = law_of({{LawType::kUniform, 1, 1}, {LawType::kUniform, 2, -1}});
  EXPECT_THAT(corner.zeros(1, 0.5, 2), ElementsAre(1));  // jumps over 0
  EXPECT_THAT(corner.zeros(1, 0.5, 0.9), IsEmpty());
  EXPECT_THAT(corner.places(0.25, 0, 3), ElementsAre(DoubleNear(0.25, 1e-15), DoubleNear(2.5, 1e-15)));
  EXPECT_THAT(corner.places(1, 0, 3), ElementsAre(1));
  EXPECT_THAT(corner.places(1.1, 0, 3), IsEmpty());
}

TEST(MotionLaw, NamesWhereAnotherFunctionBegins) {
  const MotionLaw law = law_of({{LawType::kModifiedTrapezoid, 8, 1}, {LawType::kDwell, 2}}, true);
  EXPECT_THAT(law.breaks(-1, 19), ElementsAre(0, 1, 3, 5, 7, 8, 10, 11, 13, 15, 17, 18));
  EXPECT_THAT(law_of({{LawType::kCycloidal, 1, 1}}).breaks(-1, 2), ElementsAre(0, 1));
}

std::string fault(const LawDescription& description) {
  const auto law = MotionLaw::make(description);
  if (law) return "none";
  const LawFault& what = law.error();
  return (what.segment ? std::to_string(*what.segment) + "."
          : what.point ? std::to_string(*what.point) + "."
                       : "") +
         what.key + ": " + what.rule;
}

std::string fault(const LawSegment& segment) {
  return fault(LawDescription{.segments = {{LawType::kUniform, 1, 2}, segment}});
}

TEST(MotionLaw, RefusesWhatIsNoLaw) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault(LawDescription{}), ": a law has either segments or points");
  EXPECT_EQ(fault({.segments = {{LawType::kDwell, 1}}, .points = {{0, 0}, {1, 1}, {2, 1}}}),
            ": a law has either segments or points");
  EXPECT_EQ(fault({.origin = kNaN, .segments = {{LawType::kDwell, 1}}}), "origin: must be finite, as start");
  EXPECT_EQ(fault({.origin = 1e30, .segments = {{LawType::kDwell, 1}}}),
            "origin: is so large that segments vanish beside it");
  EXPECT_EQ(fault({LawType::kCycloidal, 0, 1}), "1.over: must be > 0");
  EXPECT_EQ(fault({LawType::kCycloidal, kNaN, 1}), "1.over: must be > 0");
  EXPECT_EQ(fault({LawType::kCycloidal, 1, kNaN}), "1.: has a number that is not finite");
  EXPECT_EQ(fault({.segments = {{LawType::kCycloidal, 1e-100, 1e250}}}), ": leaves the range of numbers");
  EXPECT_EQ(fault({LawType::kDwell, 1, 3}),
            "1.rise: a dwell stays where it is: leave it out, or choose another law");
  EXPECT_EQ(fault({.type = LawType::kHarmonic, .over = 1, .start = {0}}),
            "1.start: has a meaning for law = \"polynomial\" only");
  EXPECT_EQ(fault({.type = LawType::kHarmonic, .over = 1, .end = {0}}),
            "1.end: has a meaning for law = \"polynomial\" only");
  EXPECT_EQ(fault({.type = LawType::kHarmonic, .over = 1, .cosines = {0}}),
            "1.cosines: has a meaning for law = \"harmonics\" only");
  EXPECT_EQ(fault({.type = LawType::kHarmonic, .over = 1, .sines = {0}}),
            "1.sines: has a meaning for law = \"harmonics\" only");
  EXPECT_EQ(fault({LawType::kHarmonics, 1, 1}),
            "1.sines: is missing: harmonics need sines or cosines, [first, second, ...]");
  EXPECT_EQ(
      fault({.type = LawType::kPolynomial, .over = 1, .end = {0}}),
      "1.start: is missing: a polynomial needs its value there, and as many derivatives as are to be given, "
      "[s, v, a, ...]");
  EXPECT_EQ(
      fault({.type = LawType::kPolynomial, .over = 1, .start = {2}}),
      "1.end: is missing: a polynomial needs its value there, and as many derivatives as are to be given, "
      "[s, v, a, ...]");
  EXPECT_EQ(fault({.type = LawType::kPolynomial, .over = 1, .start = {0}, .end = {2}}),
            "1.start: the law would jump: it begins at 0 where the segment before ends at 2; values in start "
            "and end "
            "count from 0, not from there");
  EXPECT_EQ(fault({.type = LawType::kPolynomial, .over = 1, .rise = 1, .start = {2}, .end = {2}}),
            "1.rise: a polynomial rises from start to end: leave it out");
  EXPECT_EQ(
      fault({.type = LawType::kPolynomial, .over = 1, .start = {2}, .end = std::vector<double>(13, 0.0)}),
      "1.end: has 13 conditions: at most 12 at each end");
  EXPECT_EQ(fault({.type = LawType::kPolynomial, .over = 1, .start = {2}, .end = {2}}), "none");
}

// A ratchet's pawl goes on by each of its strokes.
TEST(MotionLaw, RepeatedGoesOnByItsAdvance) {
  const MotionLaw law =
      testing::law_of({{LawType::kDwell, 1}, {LawType::kUniform, 2, 0.5}}, true).repeated(3);
  EXPECT_EQ(law.end(), 9);
  EXPECT_EQ(law.advance(), 1.5);
  for (const auto& [x, value] : {std::pair(3.5, 0.5), std::pair(5.0, 0.75), std::pair(8.0, 1.25)}) {
    EXPECT_NEAR(law(x), value, 1e-15);
    EXPECT_NEAR(law(x + 9), value + 1.5, 1e-15);
  }
}

}  // namespace
}  // namespace higherpair

#include "higherpair/linkage/piston.hpp"

#include "linkage/linkage_testing.hpp"
#include "linkage/slider_crank.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

/// Motion of a piston, from its outer dead centre towards the crank's pivot: a slider-crank without offset.
struct PistonMotion {
  double x = 0;  ///< [m]
  double v = 0;  ///< [m/s]
  double a = 0;  ///< [m/s²]
};

/// Rates by the chain rule, from x(θ) and its derivatives.
PistonMotion with_rates(double x, double x_1, double x_2, const AngleMotion& crank) {
  return {x, x_1 * crank.omega, x_2 * crank.omega * crank.omega + x_1 * crank.alpha};
}

/// 1 - cos θ without cancellation.
double versine(double theta) {
  const double half = std::sin(0.5 * theta);
  return 2 * half * half;
}

// The formulas of the library's header, evaluated directly.
PistonMotion exact_piston_motion(double r, double l, const AngleMotion& crank) {
  const double lambda = r / l;
  const double s = std::sin(crank.theta), c = std::cos(crank.theta);
  const double q = lambda * s;
  const double w = std::sqrt((1 - q) * (1 + q));
  const double x = r * versine(crank.theta) + l * q * q / (1 + w);
  const double x_1 = r * s * (1 + lambda * c / w);
  const double x_2 = r * (c + lambda * ((c - s) * (c + s) / w + q * q * c * c / (w * w * w)));
  return with_rates(x, x_1, x_2, crank);
}

PistonMotion harmonic_piston_motion(double r, double l, const AngleMotion& crank) {
  const double lambda = r / l;
  const double s = std::sin(crank.theta), c = std::cos(crank.theta);
  return with_rates(r * (versine(crank.theta) + 0.5 * lambda * s * s), r * s * (1 + lambda * c),
                    r * (c + lambda * (c - s) * (c + s)), crank);
}

TEST(Piston, MovesLikeTheSliderCrankSeenFromItsOuterDeadCentre) {
  Random random(111);
  Worst worst;
  for (int i = 0; i < 3000; ++i) {
    const double r = random.between(0.2, 2), l = r * random.between(1.1, 6);
    const AngleMotion crank{random.angle(), random.between(-2, 2), random.between(-2, 2)};
    const PistonMotion piston = exact_piston_motion(r, l, crank);
    const SliderCrankMotion motion = slider_crank_by_crank({r, l, 0, 0}, crank, AssemblyMode::kPlus);
    worst.see(std::abs(piston.x - (r + l - motion.r1)) / l);
    worst.see(std::abs(piston.v + motion.rates.value().r1_dot) / l);
    worst.see(std::abs(piston.a + motion.rates->r1_ddot) / l);
  }
  EXPECT_AT_MOST(worst.value(), 1e-13);
}

TEST(Piston, HarmonicMotionIsConsistentInItsDerivatives) {
  Random random(112);
  RatesCheck check;
  while (check.count() < 500) {
    const double r = random.between(0.2, 1), l = r * random.between(1.1, 6);
    const AngleMotion crank{random.angle(), random.between(-1.5, 1.5), random.between(-2, 2)};
    const PistonMotion piston = harmonic_piston_motion(r, l, crank);
    const auto value_at = [&](double t) {
      const double theta = crank.theta + crank.omega * t + crank.alpha * t * t / 2;
      return std::array<double, 1>{harmonic_piston_motion(r, l, {theta, 0, 0}).x};
    };
    check.compare<1>(value_at, {false}, {piston.v}, {piston.a});
  }
  check.expect_small();
}

TEST(Piston, ReproducesTheTextbookErrorsOfTheHarmonicMotion) {
  const auto errors = textbook("slider_crank_harmonic_003")["errors"];
  for (const int ratio : {3, 4}) {
    const std::string name = "l/r=" + std::to_string(ratio);
    const HarmonicError error = harmonic_error(1.0 / ratio);
    const auto check = [&](const HarmonicError::Largest& largest, const char* key) {
      const auto& entry = errors[name][key];
      const double expected = number(entry["max_error_correct_formula"]);
      EXPECT_AT_MOST(std::abs(largest.error - expected), 4e-15 * expected) << name << " " << key;
      const double theta = number(entry["at_theta_deg"]) * kDegree;
      EXPECT_AT_MOST(std::min(std::abs(largest.theta - theta), std::abs(kPi - largest.theta - theta)), 1e-9);
    };
    check(error.x, "x_over_r");
    check(error.v, "v_over_r_omega");
    check(error.a, "a_over_r_omega2");
  }
}

TEST(Piston, NoAngleHasALargerErrorThanTheOneNamed) {
  Random random(113);
  for (int i = 0; i < 300; ++i) {
    const double lambda = i == 0 ? 0.999 : random.between(0.05, 0.99);
    const HarmonicError largest = harmonic_error(lambda);
    const auto error_at = [&](double theta) {
      const AngleMotion crank{theta, 1, 0};
      const PistonMotion exact = exact_piston_motion(1, 1 / lambda, crank);
      const PistonMotion harmonic = harmonic_piston_motion(1, 1 / lambda, crank);
      return PistonMotion{std::abs(exact.x - harmonic.x), std::abs(exact.v - harmonic.v),
                          std::abs(exact.a - harmonic.a)};
    };
    EXPECT_AT_MOST(relative_error(error_at(largest.x.theta).x, largest.x.error), 1e-14);
    EXPECT_AT_MOST(relative_error(error_at(largest.v.theta).v, largest.v.error), 1e-14);
    EXPECT_AT_MOST(relative_error(error_at(-largest.v.theta).v, largest.v.error), 1e-14);
    EXPECT_AT_MOST(relative_error(error_at(kPi - largest.v.theta).v, largest.v.error), 1e-14);
    EXPECT_AT_MOST(relative_error(error_at(largest.a.theta).a, largest.a.error), 1e-12);
    for (int k = 0; k <= 200; ++k) {
      const PistonMotion error = error_at(2 * kPi * k / 200);
      EXPECT_TRUE(error.x <= largest.x.error + 1e-14 && error.v <= largest.v.error + 1e-14 &&
                  error.a <= largest.a.error * (1 + 1e-12) + 1e-14)
          << "lambda " << lambda << ", step " << k;
    }
  }
}

TEST(Piston, TinyErrorsKeepTheirDigits) {
  // Leading terms for a long rod: λ³/8, λ³ 3√3/32 at 60°, λ³/2; the next terms are smaller by λ².
  const double lambda = 1e-6, cube = lambda * lambda * lambda;
  const HarmonicError error = harmonic_error(lambda);
  EXPECT_AT_MOST(std::abs(error.x.error / (cube / 8) - 1), 4e-12);
  EXPECT_AT_MOST(std::abs(error.v.error / (cube * 3 * std::sqrt(3.0) / 32) - 1), 4e-12);
  EXPECT_AT_MOST(std::abs(error.a.error / (cube / 2) - 1), 4e-12);
  EXPECT_AT_MOST(std::abs(error.v.theta - kPi / 3), 4e-12);
}

}  // namespace
}  // namespace higherpair

// Bands of results from tolerances, compared with closed forms and random variants.
#include "front/cam_profile.hpp"
#include "front/slider_profile.hpp"
#include "higherpair/higherpair.hpp"
#include "support/texts.hpp"

#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::kCam;
using testing::kSlider;
using testing::model_of;
using testing::shipped_model;

// The top of the cam's lift is r + e: linear in both.
constexpr const char* kLinear = R"(
[tolerances]
radius = { path = "bodies.cam.curves.disc.radius", plus_minus = 0.03 }
throw = { path = "bodies.cam.curves.disc.center.0", plus = 0.06, minus = 0.02, sigmas = 4 }
[tolerances.results]
top = { column = "follower.y", of = "max", within = 0.05 }
)";

struct Bands {
  SensitivityReport report;
  std::vector<ToleranceBand> bands;
};

Bands bands_of(const Model& model) {
  Bands found;
  found.report = sensitivity(model).value();
  found.bands = tolerance_bands(*model.profile().tolerances, found.report);
  return found;
}

TEST(ToleranceBands, OfALinearResultAreTheRootSumOfSquares) {
  const auto [report, bands] = bands_of(model_of(kCam + std::string(kLinear)));
  const ToleranceBand& band = bands.at(0);
  EXPECT_NEAR(report.results[0].value, 40, 1e-12);
  EXPECT_NEAR(band.worst_low, 40 - 0.05, 1e-10);
  EXPECT_NEAR(band.worst_high, 40 + 0.09, 1e-10);
  EXPECT_NEAR(band.center, 40.02, 1e-10);
  const double sigma = std::hypot(0.01, 0.01);
  EXPECT_NEAR(band.deviation, sigma, 1e-10);
  EXPECT_NEAR(band.low, 40.02 - 3 * sigma, 1e-10);
  EXPECT_NEAR(band.high, 40.02 + 3 * sigma, 1e-10);
  EXPECT_NEAR(band.shares[0], 0.5, 1e-9);
  EXPECT_NEAR(band.shares[1], 0.5, 1e-9);
  EXPECT_TRUE(band.complete);
}

TEST(ToleranceBands, SayWhichToleranceToTightenAndHowFar) {
  const Model model = model_of(kCam + std::string(kLinear), {"tolerances.radius.plus_minus=0.06"});
  const ToleranceBand band = bands_of(model).bands.at(0);
  EXPECT_FALSE(band.kept);
  EXPECT_FALSE(band.worst_kept);
  EXPECT_EQ(band.order.front(), 0U);
  // 0.05 = 0.02 + 3 √(0.01² + σ²): σ is the factor times 0.02.
  ASSERT_TRUE(band.tighten);
  EXPECT_FALSE(std::isnan(*band.tighten));
  EXPECT_NEAR(*band.tighten, 0, 1e-4);
  ASSERT_TRUE(band.tighten_all);
  EXPECT_NEAR(*band.tighten_all, 0.01 / std::hypot(0.01, 0.02), 1e-9);
  const auto with = [&](const std::string& override) {
    return bands_of(model_of(kCam + std::string(kLinear), {"tolerances.radius.plus_minus=0.06", override}))
        .bands.at(0);
  };
  const ToleranceBand wider = with("tolerances.results.top.within=0.06");
  ASSERT_TRUE(wider.tighten);
  const double half = 0.06 * *wider.tighten;
  EXPECT_NEAR(0.02 + 3 * std::hypot(0.01, half / 3), 0.06, 1e-10);
  const ToleranceBand tight = with("tolerances.results.top.within=0.03");
  EXPECT_FALSE(tight.tighten);
  EXPECT_TRUE(tight.tighten_all);
  const ToleranceBand shifted = with("tolerances.results.top.within=0.01");
  EXPECT_FALSE(shifted.tighten_all);
  EXPECT_TRUE(with("tolerances.results.top.within=0.2").worst_kept);
}

// A normal number with one σ in its zone scatters over three: the worst case is none then.
TEST(ToleranceBands, OfNormalNumbersThatLeaveTheirZonesAreWiderThanTheWorstCase) {
  const ToleranceBand band = bands_of(model_of(kCam + std::string(kLinear),
                                               {"tolerances.radius.sigmas=1", "tolerances.throw.plus=1e-9",
                                                "tolerances.throw.minus=1e-9"}))
                                 .bands.at(0);
  EXPECT_NEAR(band.high - band.center, 0.09, 1e-8);
  EXPECT_NEAR(band.center - band.low, 0.09, 1e-8);
  EXPECT_NEAR(band.worst_high - band.center, 0.03, 1e-8);
  EXPECT_TRUE(band.worst_kept);
  EXPECT_FALSE(band.kept);
}

// Both kinds of correlation between the numbers of one result, and their effect.
TEST(ToleranceBands, OfCorrelatedNumbersHaveTheirCovariance) {
  const auto with = [](double coefficient) {
    return bands_of(model_of(kCam + std::string(kLinear) +
                             fmt::format("[[tolerances.correlations]]\nbetween = [\"throw\", \"radius\"]\n"
                                         "coefficient = {}\n",
                                         coefficient)))
        .bands.at(0);
  };
  const ToleranceBand together = with(0.8), apart = with(-0.8);
  EXPECT_NEAR(together.deviation, 0.01 * std::sqrt(2 + 2 * 0.8), 1e-10);
  EXPECT_NEAR(apart.deviation, 0.01 * std::sqrt(2 - 2 * 0.8), 1e-10);
  EXPECT_NEAR(together.shares[0], 0.5, 1e-9);
  for (const ToleranceBand& band : {together, apart}) {
    EXPECT_NEAR(band.worst_high, 40 + 0.09, 1e-10);
    EXPECT_NEAR(band.center, 40.02, 1e-10);
  }
  EXPECT_NEAR(with(0).deviation, 0.01 * std::sqrt(2.0), 1e-10);
}

// A radius with three times the scatter, and an eccentricity that compensates for some of it.
TEST(ToleranceBands, GiveANumberThatMakesUpForOthersANegativeShare) {
  const std::string correlated = kCam + std::string(kLinear) + R"(
[[tolerances.correlations]]
between    = ["radius", "throw"]
covariance = -2.4e-4
)";
  const ToleranceBand band = bands_of(model_of(correlated, {"tolerances.radius.plus_minus=0.09",
                                                            "tolerances.results.top.within=0.07"}))
                                 .bands.at(0);
  EXPECT_NEAR(band.deviation, 0.01 * std::sqrt(9 + 1 - 2 * 2.4), 1e-10);
  EXPECT_NEAR(band.shares[0], (9 - 2.4) / 5.2, 1e-9);
  EXPECT_NEAR(band.shares[1], (1 - 2.4) / 5.2, 1e-9);
  ASSERT_TRUE(band.tighten);
  const double f = *band.tighten;  // 0.02 off the middle, the rest is 3 σ
  EXPECT_LT(f, 1);
  EXPECT_NEAR(0.03 * std::sqrt(9 * f * f + 1 - 2 * 2.4 * f), 0.05, 1e-10);
}

// With a single uniform number three standard deviations would be beyond the zone.
TEST(ToleranceBands, AreNeverBeyondTheWorstCase) {
  const Model model = model_of(kCam + std::string(R"(
[tolerances]
radius = { path = "bodies.cam.curves.disc.radius", plus_minus = 0.03, distribution = "uniform" }
results.top = { column = "follower.y", of = "max" }
)"));
  const ToleranceBand band = bands_of(model).bands.at(0);
  EXPECT_NEAR(band.deviation, 0.03 / std::sqrt(3.0), 1e-10);
  EXPECT_NEAR(band.low, 40 - 0.03, 1e-10);
  EXPECT_EQ(band.low, band.worst_low);
}

TEST(ToleranceVariantsOf, ALinearResultAgreeWithItsBands) {
  const Model model = model_of(kCam + std::string(kLinear), {"driver.samples=13"});
  const auto [report, bands] = bands_of(model);
  ToleranceVariantSettings settings;
  settings.count = 20000;
  const ToleranceVariants variants = tolerance_variants(model, report, settings).value();
  EXPECT_EQ(variants.count, 20000);
  EXPECT_EQ(variants.good, 20000);
  const VariantBand& seen = variants.bands.at(0);
  EXPECT_EQ(seen.variants, 20000);
  EXPECT_FALSE(seen.curved);
  EXPECT_LT(seen.farthest, 1e-9);
  EXPECT_NEAR(seen.deviation, bands[0].deviation, 0.02 * bands[0].deviation);
  EXPECT_NEAR(seen.median, bands[0].center, 0.05 * bands[0].deviation);
  EXPECT_NEAR(seen.low, bands[0].low, 0.3 * bands[0].deviation);
  EXPECT_NEAR(seen.high, bands[0].high, 0.3 * bands[0].deviation);
  // A normal distribution about 40.02: the part within 40 ± 0.05.
  const auto below = [](double x) { return std::erfc(-x / std::sqrt(2.0)) / 2; };
  EXPECT_NEAR(seen.share_within, below(0.03 / bands[0].deviation) - below(-0.07 / bands[0].deviation), 0.005);
}

TEST(ToleranceVariantsOf, CorrelatedNumbersScatterTogether) {
  const Model model = model_of(kCam + std::string(kLinear) +
                                   "[[tolerances.correlations]]\nbetween = [\"radius\", \"throw\"]\n"
                                   "coefficient = -0.9\n",
                               {"driver.samples=13"});
  const auto [report, bands] = bands_of(model);
  EXPECT_NEAR(bands[0].deviation, 0.01 * std::sqrt(0.2), 1e-10);
  ToleranceVariantSettings settings;
  settings.count = 20000;
  const VariantBand seen = tolerance_variants(model, report, settings).value().bands.at(0);
  EXPECT_NEAR(seen.deviation, bands[0].deviation, 0.02 * bands[0].deviation);
  EXPECT_NEAR(seen.low, bands[0].low, 0.3 * bands[0].deviation);
  EXPECT_FALSE(seen.curved);
}

TEST(ToleranceVariantsOf, AreTheSameOnAnyNumberOfThreadsAndOthersWithAnotherSeed) {
  const Model model = model_of(kCam + std::string(kLinear), {"driver.samples=7"});
  const SensitivityReport report = sensitivity(model).value();
  const auto low = [&](int threads, std::uint64_t seed) {
    ToleranceVariantSettings settings;
    settings.count = 3000;
    settings.threads = threads;
    settings.seed = seed;
    return tolerance_variants(model, report, settings).value().bands.at(0).low;
  };
  EXPECT_EQ(low(1, 1), low(3, 1));
  EXPECT_NE(low(1, 1), low(1, 2));
}

// With zero offset the pivot changes the stroke to second order only, which no slope shows.
TEST(ToleranceVariantsOf, AResultThatBendsSayThatItDoes) {
  const Model model =
      model_of(kSlider + std::string(R"(
[tolerances]
offset = { path = "bodies.ground.points.rail.1", plus_minus = 3, distribution = "uniform" }
results.stroke = { column = "slider.x", of = "range" }
)"),
               {"bodies.ground.points.rail.1=0", "driver.start=30", "driver.end=390", "driver.samples=1441"});
  const auto [report, bands] = bands_of(model);
  EXPECT_NEAR(report.results[0].value, 60, 1e-9);
  EXPECT_NEAR(bands[0].worst_high - bands[0].worst_low, 0, 1e-9);
  ToleranceVariantSettings settings;
  settings.count = 600;
  const ToleranceVariants variants = tolerance_variants(model, report, settings).value();
  EXPECT_TRUE(variants.bands[0].curved);
  EXPECT_GT(variants.bands[0].high, 60.02);
}

TEST(ToleranceVariantsOf, AModelWithoutTolerancesOrAReportByOtherNumbersAreRefused) {
  const Model without = model_of(kCam, {"driver.samples=7"});
  const auto refused = tolerance_variants(without, sensitivity(without).value());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kInput);
  EXPECT_TRUE(contains(to_string(refused.error()), "test.toml: there is no [tolerances]"));
  const Model with = model_of(kCam + std::string(kLinear), {"driver.samples=7"});
  const auto other = tolerance_variants(with, sensitivity(without).value());
  ASSERT_FALSE(other);
  EXPECT_TRUE(contains(to_string(other.error()), "other numbers than those of [tolerances]"));
}

TEST(ToleranceVariantsOf, StopWhenTold) {
  const Model model = model_of(kCam + std::string(kLinear));
  const SensitivityReport report = sensitivity(model).value();
  const std::atomic<bool> stop = true;
  ToleranceVariantSettings settings;
  settings.stop = &stop;
  const auto variants = tolerance_variants(model, report, settings);
  EXPECT_TRUE(!variants || variants->stopped);
}

TEST(ToleranceBands, OfTheShippedProfileAgreeWithItsVariants) {
  const Model model = shipped_model("toleranced_linkage", {"driver.samples=61"});
  const auto [report, bands] = bands_of(model);
  ToleranceVariantSettings settings;
  settings.count = 4000;
  const ToleranceVariants variants = tolerance_variants(model, report, settings).value();
  EXPECT_EQ(variants.good, 4000);
  for (std::size_t m = 0; m < bands.size(); ++m) {
    EXPECT_TRUE(bands[m].complete);
    EXPECT_NEAR(variants.bands[m].deviation, bands[m].deviation, 0.06 * bands[m].deviation)
        << report.results[m].name;
    EXPECT_NEAR(variants.bands[m].median, bands[m].center, 0.1 * bands[m].deviation);
  }
}

}  // namespace
}  // namespace higherpair

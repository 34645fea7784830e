// The design tasks among the shipped profiles, compared with results obtained by other means.
#include "front/cam_profile.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::model_of;
using testing::shipped_model;

DesignReport designed(const std::string& profile, int starts,
                      const std::vector<std::string>& overrides = {}) {
  DesignSettings settings;
  settings.starts = starts;
  auto report = design(shipped_model(profile, overrides), settings);
  if (!report) throw std::runtime_error(to_string(report.error()));
  return *std::move(report);
}

// Largest acceleration of the slide of an offset slider-crank at a constant speed of the crank [mm/s²].
double peak_acceleration(double r, double l, double e, double omega) {
  double peak = 0;
  for (int k = 0; k < 3600; ++k) {
    const double theta = k * kPi / 1800;
    const double u = r * std::sin(theta) - e, du = r * std::cos(theta), ddu = -r * std::sin(theta);
    const double s = std::sqrt(l * l - u * u);
    const double a = -r * std::cos(theta) - (du * du + u * ddu) / s - u * u * du * du / (s * s * s);
    peak = std::max(peak, std::abs(a) * omega * omega);
  }
  return peak;
}

// All slider-cranks with a stroke S and a time ratio: their dead points are l + r and l - r from the crank's
// pivot, with the angle β between them.
TEST(DesignTasks, AQuickReturnIsTheBestOfItsFamily) {
  const double S = 100, beta = kPi * (1.8 - 1) / (1.8 + 1);
  double best = INFINITY;
  for (double r = 5; r < 50; r += 0.01) {
    const double l = std::sqrt((S * S - 2 * r * r * (1 + std::cos(beta))) / (2 * (1 - std::cos(beta))));
    const double e = (l * l - r * r) * std::sin(beta) / S;
    // Both ends of the stroke are on the same side of the foot of the pivot.
    const bool passes = l > r + e && std::abs(std::sqrt(std::pow(l + r, 2) - e * e) -
                                              std::sqrt(std::pow(l - r, 2) - e * e) - S) < 1e-6;
    if (passes) best = std::min(best, peak_acceleration(r, l, e, 2 * kPi));
  }
  const DesignReport report = designed("design_quick_return", 6);
  EXPECT_TRUE(report.holds);
  EXPECT_LE(report.objectives[0].after, best * (1 + 1e-4));
  EXPECT_GE(report.objectives[0].after, best * (1 - 5e-3));  // rows miss a little of the peak
}

TEST(DesignTasks, AStraightLineIsBetterThanChebyshevs) {
  const DesignReport report = designed("design_hoeken_line", 12);
  EXPECT_TRUE(report.holds);
  EXPECT_NEAR(report.before / 4, 0.0024384, 2e-5);  // Chebyshev's proportions, relative to the stroke
  EXPECT_LE(report.after / 4, 0.000895);            // best known: 0.0008925
}

TEST(DesignTasks, WattsLinesAreImproved) {
  const DesignReport report = designed("design_watt_line", 12);
  EXPECT_TRUE(report.holds);
  EXPECT_LE(report.after, 0.2 * report.before);
}

// The prime circle has also been published: 1.750944530 in.
TEST(DesignTasks, TheLeastCamHasThePressureAngleThatIsAllowed) {
  const DesignReport report = designed("design_least_cam", 1);
  EXPECT_TRUE(report.holds);
  EXPECT_NEAR(report.variables.front().after, 1.750944530, 1e-6);
  EXPECT_NEAR(report.constraints.front().after, 30, 1e-5);
  EXPECT_GT(report.constraints.front().cost, 0);
  EXPECT_EQ(report.constraints.front().cost_unit, "in/deg");
}

// y = √(a² sin² θ + b² cos² θ) against 4 (1 - cos 2θ).
TEST(DesignTasks, AnEllipseIsFittedToItsLaw) {
  const auto misses = [](double a, double b) {
    double sum = 0;
    for (int k = 0; k < 73; ++k) {
      const double theta = k * 5 * kPi / 180;
      const double y = std::hypot(a * std::sin(theta), b * std::cos(theta));
      const double y0 = b;
      sum += std::pow(y - y0 - 4 * (1 - std::cos(2 * theta)), 2);
    }
    return sum;
  };
  double best = INFINITY;
  for (double b = 30; b < 34; b += 1e-4) best = std::min(best, misses(40, b));
  const DesignReport report = designed("design_ellipse_cam", 6);
  EXPECT_TRUE(report.variables.front().at_bound);
  EXPECT_NEAR(report.after, best, 1e-6 * best);
}

// A path that a known linkage has, but moved, rotated and enlarged.
TEST(DesignTasks, OnlyTheFormOfAFreePathCounts) {
  const Model known = shipped_model("design_eighteen_points");
  const Motion motion = known.run().value();
  std::string through = "[";
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const double x = motion.column("coupler.E.x")[i], y = motion.column("coupler.E.y")[i];
    through += "[" + std::to_string(7 + 2 * (0.6 * x - 0.8 * y)) + ", " +
               std::to_string(-3 + 2 * (0.8 * x + 0.6 * y)) + "], ";
  }
  const std::string given = "design.objectives.0.path.through=" + through + "]";
  const auto report = [&](const std::string& free) {
    return designed("design_eighteen_points", 1, {given, "design.objectives.0.path.free=" + free});
  };
  EXPECT_LE(report("[\"position\", \"turn\", \"scale\"]").before, 1e-9);
  EXPECT_GE(report("[\"position\", \"turn\"]").before, 1);
  EXPECT_GE(report("[\"turn\", \"scale\"]").before, 1);
}

TEST(DesignTasks, AFourBarIsOfTheClassThatIsAsked) {
  const std::vector<std::string> grashof = {
      R"(design.constraints=[{ grashof = "crank-rocker", above = 0.2 }])"};
  const DesignReport report = designed("design_five_points", 12, grashof);
  EXPECT_TRUE(report.holds);
  ASSERT_EQ(report.constraints.size(), 1U);
  EXPECT_EQ(report.constraints[0].what, "room as a crank-rocker above 0.2");
  EXPECT_GE(report.constraints[0].after, 0.2 - 1e-9);
  EXPECT_EQ(report.constraints[0].unit, "mm");
}

TEST(DesignTasks, TheBestFewAreDifferentAndCanBeRead) {
  DesignSettings settings;
  settings.starts = 12;
  settings.best = 3;
  const DesignReport report = design(shipped_model("design_five_points"), settings).value();
  ASSERT_GE(report.optima.size(), 4U);
  EXPECT_EQ(report.optima[0].text, report.text);
  for (std::size_t k = 1; k < 3; ++k) {
    EXPECT_NE(report.optima[k].text, report.optima[k - 1].text);
    EXPECT_GE(report.optima[k].objective, report.optima[k - 1].objective);
    EXPECT_TRUE(model_of(report.optima[k].text).run().value().good());
    EXPECT_EQ(report.optima[k].as_found, true);
  }
  EXPECT_TRUE(report.optima[3].text.empty());
  EXPECT_FALSE(report.optima[3].as_found.has_value());
}

TEST(DesignTasks, APageShowsBothMechanismsAndNothingOfTheWeb) {
  const Model model = shipped_model("design_five_points", std::vector<std::string>{"title=A <b> & \"c\""});
  DesignSettings settings;
  settings.starts = 2;
  const DesignReport report = design(model, settings).value();
  const std::string page = design_page(model, report).value();
  const auto count = [&](const std::string& text) {
    std::size_t found = 0;
    for (std::size_t at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("<figure>"), 2U);
  EXPECT_EQ(count("class=\"target\""), 10U);
  EXPECT_NE(page.find("A &lt;b&gt; &amp; &quot;c&quot;"), std::string::npos);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("https://"), std::string::npos);
  // Both are drawn to one scale, and units are written as in print.
  const auto scale = [&](std::size_t from) {
    const std::size_t at = page.find("data-scale=\"", from);
    return page.substr(at, page.find('"', at + 12) - at);
  };
  EXPECT_EQ(scale(0), scale(page.find("After")));
  EXPECT_EQ(page.find("^2"), std::string::npos);
}

std::string message_of(const std::vector<std::string>& overrides,
                       const std::string& profile = "design_five_points") {
  const auto model = Model::open(HIGHERPAIR_SOURCE_DIR "/profiles/" + profile + ".toml", overrides);
  if (!model) return to_string(model.error());
  DesignSettings one;
  one.starts = 1;
  const auto report = design(*model, one);
  return report ? "" : to_string(report.error());
}

TEST(DesignTasks, SayWhatTheyCannotMean) {
  const auto says = [](const std::vector<std::string>& overrides, const std::string& what) {
    const std::string message = message_of(overrides);
    EXPECT_NE(message.find(what), std::string::npos) << message;
  };
  says({R"(design.constraints=[{ grashof = "crank-roker" }])"}, "did you mean `crank-rocker`");
  says({R"(design.constraints=[{ grashof = "crank-rocker", coupler = "crank" }])"},
       "design.constraints.0: expected a mechanism with one four-bar");
  says({R"(design.constraints=[{ without = [] }])"}, "expected a list of events, such as [\"dead_point\"]");
  says({R"(design.constraints=[{ without = ["dead_points"] }])"}, "did you mean `dead_point`");
  says({R"(design.constraints=[{ figure = "pressure" , below = 3 }])"}, "expected a figure of `check`");
  says({R"(design.constraints=[{ figure = "joints.rocker_pivot.accelerations", below = 3 }])"},
       "`check` has no such figure of this mechanism; did you mean");
  // Both curves of the contact have this figure.
  EXPECT_TRUE(contains(
      message_of({R"(design.objectives=[{ figure = "contacts.touch.convex_radios" }])"}, "design_eccentric"),
      "did you mean `contacts.touch.convex_radius`?"));
  says({R"(design.objectives.0.path.free=["place"])"}, "design.objectives.0.path.free.0");
  says({R"(design.objectives.0.path.free=[])"}, "expected a list of \"position\", \"turn\" and \"scale\"");
  says({R"(design.objectives=[{ column = "rocker.angle", follow = "lift" }])"}, "there is no law `lift`");
  says({R"(design.objectives=[{ column = "rocker.omega", follow = "lift" }])"},
       "a law is of an angle or of a coordinate");
}

}  // namespace
}  // namespace higherpair

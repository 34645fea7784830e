// The meaning of [tolerances] in a profile, and every message about it; all quantities of a profile.
#include "higherpair/io/profile_document.hpp"
#include "higherpair/io/tasks.hpp"
#include "io/only_message.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::contains_all;
using testing::kCamProfile;
using testing::lines_are;
using testing::Overrides;
using testing::read;

constexpr const char* kTolerances = R"(
[tolerances]
r = { path = "bodies.cam.curves.disc.radius", plus_minus = 0.02 }
[tolerances.results]
peak = { column = "follower.alpha", of = "maxabs", within = 3 }
)";

std::string toleranced_cam(const std::string& tolerances = kTolerances) {
  return std::string(kCamProfile) + tolerances;
}

std::string tolerance_message(const Overrides& overrides, const std::string& tolerances = kTolerances) {
  return testing::only_message(toleranced_cam(tolerances), overrides);
}

TEST(ToleranceProfiles, AreReadInTheirOrder) {
  const Profile profile = read(toleranced_cam(R"(
[tolerances]
r = { path = "bodies.cam.curves.disc.radius", plus_minus = "20 um" }
e = { path = "bodies.cam.curves.disc.center.0", plus = -0.01, minus = 0.03, distribution = "uniform" }
i = { path = "bodies.follower.inertia", plus = 0.5, distribution = "triangular" }
both = { path = ["bodies.ground.points.O1.0", "bodies.ground.points.O1.1"], plus_minus = 0.1, sigmas = 4 }
time = true
results.peak = { column = "follower.alpha", of = "max", within = 3 }
results.rest = { column = "follower.angle", of = "at", at = 30 }
)"));
  ASSERT_TRUE(profile.tolerances);
  const ToleranceTask& task = *profile.tolerances;
  ASSERT_EQ(task.tolerances.size(), 4U);
  const Tolerance& r = task.tolerances[0];
  EXPECT_EQ(r.name, "r");
  EXPECT_EQ(r.value, 20);
  EXPECT_EQ(r.unit, "mm");
  EXPECT_DOUBLE_EQ(r.plus, 0.02);
  EXPECT_DOUBLE_EQ(r.minus, 0.02);
  EXPECT_DOUBLE_EQ(r.deviation(), 0.02 / 3);
  EXPECT_EQ(r.kind, DistributionKind::kNormal);
  const Tolerance& e = task.tolerances[1];
  EXPECT_DOUBLE_EQ(e.middle(), 10 - 0.02);
  EXPECT_DOUBLE_EQ(e.half(), 0.01);
  EXPECT_DOUBLE_EQ(e.deviation(), 0.01 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(e.distribution().low, 9.97);
  EXPECT_DOUBLE_EQ(e.distribution().high, 9.99);
  const Tolerance& i = task.tolerances[2];  // "2.1e-4 kg m^2"
  EXPECT_DOUBLE_EQ(i.value, 210);
  EXPECT_EQ(i.unit, "kg*mm^2");
  EXPECT_DOUBLE_EQ(i.deviation(), 0.25 / std::sqrt(6.0));
  EXPECT_DOUBLE_EQ(i.distribution().mode, 210.25);
  EXPECT_TRUE(
      lines_are(task.tolerances[3].paths, {"bodies.ground.points.O1.0", "bodies.ground.points.O1.1"}));
  EXPECT_DOUBLE_EQ(task.tolerances[3].distribution().deviation, 0.025);
  EXPECT_TRUE(task.in_time);
  ASSERT_EQ(task.results.size(), 2U);
  EXPECT_EQ(task.results[0].within, 3);
  EXPECT_FALSE(task.results[1].within);
  const auto in_turns = read(toleranced_cam(), {"tolerances.results.peak.within=0.5 rev/s^2"}).tolerances;
  EXPECT_EQ(in_turns->results[0].within, 180);
  EXPECT_FALSE(read(kCamProfile).tolerances);
}

TEST(ToleranceProfiles, SayWhatIsWrongWithThem) {
  EXPECT_TRUE(contains_all(tolerance_message({"tolerances.r.path=bodies.cam.curves.disc.radus"}),
                           {"there is no `radus`", "did you mean `radius`"}));
  EXPECT_TRUE(contains(tolerance_message({"tolerances.r.path=bodies.cam.curves.disc"}),
                       "expected the path of a number"));
  EXPECT_TRUE(contains(tolerance_message({"tolerances.r.path=tolerances.r.plus_minus"}),
                       "tolerances have none themselves"));
  EXPECT_TRUE(
      contains(tolerance_message({"tolerances.r.path=driver.samples"}), "is no dimension of the mechanism"));
  EXPECT_TRUE(contains(
      tolerance_message(
          {"tolerances.r.path=[\"bodies.cam.curves.disc.radius\", \"bodies.cam.curves.disc.center.0\"]"}),
      "numbers with one tolerance are equal in the profile"));
  EXPECT_TRUE(
      contains(tolerance_message({"tolerances.e={path=\"bodies.cam.curves.disc.radius\", plus_minus=1}"}),
               "another variable sets this already"));
  EXPECT_TRUE(
      contains(tolerance_message({"tolerances.r.plus_minus=0"}), "tolerances.r.plus_minus = 0: must be > 0"));
  EXPECT_TRUE(contains(tolerance_message({"tolerances.r.plus_minus=2 deg"}), "expected a length"));
  EXPECT_TRUE(contains(tolerance_message({"tolerances.r.plus=0.1"}), "say the same"));
  EXPECT_TRUE(contains(tolerance_message({}, R"(
[tolerances]
r = { path = "bodies.cam.curves.disc.radius" }
)"),
                       "plus_minus is missing"));
  EXPECT_TRUE(contains(tolerance_message({}, R"(
[tolerances]
r = { path = "bodies.cam.curves.disc.radius", plus = 0.02, minus = -0.02 }
)"),
                       "is empty: plus + minus must be > 0"));
  EXPECT_TRUE(contains(tolerance_message({"tolerances.r.distribution=norml"}), "did you mean `normal`"));
  EXPECT_TRUE(contains(tolerance_message({"tolerances.r.sigmas=-1"}), "must be > 0"));
  EXPECT_TRUE(contains(tolerance_message({"tolerances.r.sigmas=4", "tolerances.r.distribution=uniform"}),
                       "belongs to a normal distribution"));
  EXPECT_TRUE(
      contains(tolerance_message({"tolerances.r.plusminus=1"}), "unknown key; did you mean `plus_minus`"));
  EXPECT_TRUE(contains(tolerance_message({"tolerances.results.peak.within=0"}), "must be > 0"));
  EXPECT_TRUE(contains(tolerance_message({"tolerances.results.peak.of=most"}), "expected one of"));
  EXPECT_TRUE(contains(tolerance_message({}, "[tolerances]\n"), "expected at least one tolerance"));
  EXPECT_TRUE(contains(tolerance_message({}, "[tolerances]\nr = 3\n"), "expected a tolerance"));
}

TEST(ToleranceProfiles, ReadCorrelationsAndSayWhatIsWrongWithThem) {
  const std::string two = std::string(kTolerances) + R"(
[tolerances.e]
path       = "bodies.cam.curves.disc.center.0"
plus_minus = 0.03
[tolerances.flat]
path         = "bodies.ground.points.O2.0"
plus_minus   = 0.03
distribution = "uniform"
)";
  const auto with = [](const std::string& entry) { return "tolerances.correlations=[" + entry + "]"; };
  const auto task =
      read(toleranced_cam(two), {with("{ between = [\"e\", \"r\"], coefficient = 0.6 }")}).tolerances;
  ASSERT_EQ(task->correlations.size(), 1U);
  EXPECT_EQ(task->correlations[0].first, 1U);
  EXPECT_EQ(task->correlations[0].second, 0U);
  EXPECT_EQ(task->correlations[0].coefficient, 0.6);
  EXPECT_EQ(task->tolerances.size(), 3U);
  const auto says = [&](const std::string& entry) { return tolerance_message({with(entry)}, two); };
  EXPECT_TRUE(contains(says("{ between = [\"e\", \"rr\"], coefficient = 0.6 }"),
                       "there is no tolerance `rr`; did you mean"));
  EXPECT_TRUE(contains(says("{ between = [\"e\", \"flat\"], coefficient = 0.6 }"),
                       "only tolerances with distribution = \"normal\" can be correlated"));
  EXPECT_TRUE(
      contains(says("{ between = [\"e\"], coefficient = 0.6 }"), "expected the names of two tolerances"));
  EXPECT_TRUE(contains(says("{ between = [\"e\", \"r\"], coefficient = 1 }"),
                       "tolerances that are the same are one with several paths"));
  // 0.01 mm and 0.02/3 mm
  EXPECT_TRUE(
      contains(says("{ between = [\"e\", \"r\"], covariance = 7e-5 }"), "the product of both deviations"));
}

TEST(Quantities, OfAProfileAreAllThatMeasureSomething) {
  const auto document = ProfileDocument::parse(kCamProfile, "test.toml").value();
  const auto quantities = document.quantities();
  const auto find = [&](const std::string& path) {
    const auto found = std::find_if(quantities.begin(), quantities.end(),
                                    [&](const auto& quantity) { return quantity.path == path; });
    return found == quantities.end() ? nullptr : &*found;
  };
  ASSERT_NE(find("bodies.cam.curves.disc.radius"), nullptr);
  EXPECT_EQ(find("bodies.cam.curves.disc.radius")->value, 20);
  EXPECT_EQ(find("bodies.cam.curves.disc.radius")->dimension, dimension::kLength);
  ASSERT_NE(find("bodies.follower.inertia"), nullptr);
  EXPECT_DOUBLE_EQ(find("bodies.follower.inertia")->value, 210);
  EXPECT_EQ(find("bodies.follower.pose.angle")->dimension, dimension::kAngle);
  EXPECT_EQ(find("driver.samples"), nullptr);
  EXPECT_EQ(find("title"), nullptr);
  EXPECT_EQ(std::count_if(quantities.begin(), quantities.end(),
                          [](const auto& quantity) { return quantity.path == "gravity.1"; }),
            1);
}

}  // namespace
}  // namespace higherpair

#include "io/profile_testing.hpp"
#include "linkage/slider_crank_profile.hpp"
#include "sliding_cam.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

// Contacts that may separate, whole bodies as partners, and guides with ends.

namespace higherpair {
namespace {

using testing::contains;
using testing::events_of;
using testing::model_of;
using testing::motion_of;
using testing::profile_of;
using testing::replaced;
using testing::shipped_model;

// Speed and acceleration of the wheel of a Geneva drive with n slots, with the crank at φ from the line of
// pivots and at unit speed. The wheel turns opposite to the crank.
struct Wheel {
  double omega = 0, alpha = 0;
};

Wheel geneva(int n, double phi) {
  const double m = std::sin(M_PI / n);
  const double d = 1 + m * m - 2 * m * std::cos(phi);
  return {-(m * std::cos(phi) - m * m) / d, m * (1 - m * m) * std::sin(phi) / (d * d)};
}

// A Geneva drive with its pivots 80 mm apart, constructed independently.
std::string geneva_profile(int n, const std::string& driver) {
  const double m = std::sin(M_PI / n);
  const double crank = 80 * m;
  const double slot = 80 * std::cos(M_PI / n);
  std::string wheel;
  for (int k = 0; k < n; ++k) {
    const double at = 2 * M_PI * k / n;
    wheel += fmt::format("curves.slot{} = {{ type = \"segment\", from = [{}, {}], to = [{}, {}] }}\n", k,
                         0.2 * slot * std::cos(at), 0.2 * slot * std::sin(at), slot * std::cos(at),
                         slot * std::sin(at));
  }
  return fmt::format(R"(
[bodies.ground]
points.O1 = [0, 0]
points.O2 = [-80, 0]
[bodies.crank]
points.O = [0, 0]
curves.pin = {{ type = "point", at = [{}, 0] }}
[bodies.wheel]
pose = {{ x = -80, y = 0, angle = {} }}
points.O = [0, 0]
{}[joints]
crank_pivot = {{ type = "revolute", between = ["ground.O1", "crank.O"] }}
wheel_pivot = {{ type = "revolute", between = ["ground.O2", "wheel.O"] }}
[contacts.drive]
between = ["crank.pin", "wheel"]
keep = "gap"
both_sides = true
[driver]
joint = "crank_pivot"
{})",
                     crank, 180.0 / n, wheel, driver);
}

TEST(GenevaWheel, TurnsByOneSlotInEveryTurnOfItsCrankAndRestsInBetween) {
  for (const int n : {4, 5, 6, 8}) {
    const Motion motion =
        motion_of(model_of(geneva_profile(n, "start = 0\nend = 720\nsamples = 721\nvelocity = \"1 rad/s\"")));
    ASSERT_TRUE(motion.good()) << n;
    const auto omega = motion.column("wheel_pivot.velocity");
    const auto alpha = motion.column("wheel_pivot.acceleration");
    const auto angle = motion.column("wheel_pivot.position");
    const auto driver = motion.column("driver");
    const double half = 90 - 180.0 / n;  // half of the crank's turn with the pin in a slot
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double phi = std::remainder(driver[k] - 180, 360);
      const Wheel wanted = std::abs(phi) < half ? geneva(n, phi * testing::kDegree) : Wheel{};
      if (std::abs(std::abs(phi) - half) > 1e-9) {
        ASSERT_NEAR(omega[k] * testing::kDegree, wanted.omega, 1e-12) << n << " at " << driver[k];
        ASSERT_NEAR(alpha[k] * testing::kDegree, wanted.alpha, 1e-10) << n << " at " << driver[k];
      }
    }
    EXPECT_NEAR(angle[720] - angle[0], -2 * 360.0 / n, 1e-9);
    EXPECT_NEAR(angle[360] - angle[0], -360.0 / n, 1e-9);
    const auto engaged = events_of(motion, EventType::kEngage);
    const auto released = events_of(motion, EventType::kRelease);
    ASSERT_EQ(engaged.size(), 2U);
    ASSERT_EQ(released.size(), 2U);
    EXPECT_NEAR(engaged[0].driver, 180 - half, 1e-6);
    EXPECT_NEAR(released[0].driver, 180 + half, 1e-6);
    EXPECT_NEAR(engaged[1].driver, 540 - half, 1e-6);
    EXPECT_NEAR(released[1].driver, 540 + half, 1e-6);
    EXPECT_EQ(engaged[0].item, "drive");
  }
}

TEST(GenevaWheel, HasThePeaksOfTheTextbook) {
  struct Peak {
    int n;
    double alpha, at;  // largest acceleration, and its angle from the line of pivots [deg]
  };
  for (const Peak& peak : {Peak{4, 5.4069810, 11.4637}, Peak{6, 1.3496373, 22.9031}}) {
    const double m = std::sin(M_PI / peak.n);
    RunSettings settings;
    settings.positions = {180 - peak.at - 0.01, 180 - peak.at, 180 - peak.at + 0.01, 180};
    const Motion motion =
        motion_of(model_of(geneva_profile(peak.n, "start = 0\nend = 360\nvelocity = \"1 rad/s\"")), settings);
    const auto alpha = motion.column("wheel_pivot.acceleration");
    EXPECT_NEAR(std::abs(alpha[1] * testing::kDegree), peak.alpha, 1e-6);
    EXPECT_LT(std::abs(alpha[0]), std::abs(alpha[1]));
    EXPECT_LT(std::abs(alpha[2]), std::abs(alpha[1]));
    EXPECT_NEAR(motion.column("wheel_pivot.velocity")[3] * testing::kDegree, -m / (1 - m), 1e-12);
  }
}

TEST(GenevaWheel, IsTheSameWhateverTheRowsAndTheSenseOfTurning) {
  const Motion fine = motion_of(model_of(geneva_profile(4, "start = 0\nend = 720\nsamples = 721")));
  const Motion coarse = motion_of(model_of(geneva_profile(4, "start = 0\nend = 720\nsamples = 7")));
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    EXPECT_NEAR(coarse.column("wheel_pivot.position")[k], fine.column("wheel_pivot.position")[120 * k], 1e-9)
        << k;
  }
  EXPECT_EQ(events_of(coarse, EventType::kEngage).size(), 2U);
  const Motion back = motion_of(model_of(geneva_profile(4, "start = 720\nend = 0\nsamples = 721")));
  EXPECT_NEAR(back.column("wheel_pivot.position")[720] - back.column("wheel_pivot.position")[0],
              fine.column("wheel_pivot.position")[0] - fine.column("wheel_pivot.position")[720], 1e-9);
}

TEST(GenevaWheel, MayStartWithThePinInASlot) {
  const Motion motion = motion_of(
      model_of(geneva_profile(4, "start = 180\nend = 540\nsamples = 361"), {"bodies.wheel.pose.angle=0"}));
  EXPECT_TRUE(motion.good());
  EXPECT_NEAR(motion.column("wheel_pivot.position")[360] - motion.column("wheel_pivot.position")[0], -90,
              1e-9);
  EXPECT_LT(motion.column("wheel_pivot.velocity")[0], 0);
}

TEST(GenevaWheel, WhoseSlotsThePinMissesStaysWhereItIs) {
  const Motion motion = motion_of(
      model_of(geneva_profile(4, "start = 0\nend = 360\nsamples = 37"), {"bodies.wheel.pose.angle=60"}));
  EXPECT_TRUE(events_of(motion, EventType::kEngage).empty());
  for (const double angle : motion.column("wheel_pivot.position")) {
    EXPECT_NEAR(angle, 60, 1e-12);
  }
}

// A crank of the wrong length: its pin does not come to the end of a slot, where it would turn the wheel, but
// crosses the middle line of one farther in, where √2·60 sin(φ - 45°) = 80, and of the next on its way out.
TEST(GenevaWheel, IsStruckByAPinThatComesThroughTheWallOfASlot) {
  const double inwards = 225 - std::asin(80 / (60 * std::sqrt(2))) / testing::kDegree;
  for (const int samples : {2, 5, 37, 361}) {
    for (const double sense : {1.0, -1.0}) {
      const Model model =
          model_of(geneva_profile(4, fmt::format("start = 0\nend = {}\nsamples = {}\nvelocity = {}",
                                                 360 * sense, samples, sense)),
                   {"bodies.crank.curves.pin.at=[60, 0]"});
      auto analysis = model.start({});
      ASSERT_TRUE(analysis);
      Row row;
      while (analysis->next(row)) {
      }
      EXPECT_FALSE(analysis->good());
      const auto& events = analysis->events();
      ASSERT_EQ(events.size(), 2U) << samples;
      for (const Event& event : events) {
        EXPECT_EQ(event.type, EventType::kOverlap);
        EXPECT_TRUE(contains(event.cause, "through a wall beside the curve"));
      }
      EXPECT_NEAR(events[0].driver, sense * inwards, 1e-9) << samples;
      EXPECT_NEAR(events[1].driver, sense * (360 - inwards), 1e-9) << samples;
      EXPECT_TRUE(analysis->notes().empty());
    }
  }
}

TEST(GenevaWheel, ThatThePinNeverReachesHasANote) {
  const Model model = model_of(geneva_profile(4, "start = 0\nend = 360\nsamples = 5"),
                               {"bodies.crank.curves.pin.at=[50, 0]"});
  auto analysis = model.start({});
  ASSERT_TRUE(analysis);
  Row row;
  while (analysis->next(row)) {
    EXPECT_EQ(analysis->notes().empty(), row.number < 4);
  }
  ASSERT_EQ(analysis->notes().size(), 1U);
  EXPECT_TRUE(
      contains(analysis->notes()[0].message, "contacts.drive: the two bodies touch nowhere on the path"));
}

TEST(GenevaWheel, NeedsNoForceWhileItIsHeldAndBalancesItsInertiaWhileItIsDriven) {
  RunSettings settings;
  settings.forces = true;
  const Motion motion = motion_of(shipped_model("geneva_four_slots"), settings);
  EXPECT_TRUE(motion.good());
  const auto force = motion.column("drive.force");
  const auto torque = motion.column("driver.effort");
  const auto omega = motion.column("wheel_pivot.velocity");
  const auto alpha = motion.column("wheel_pivot.acceleration");
  const double inertia = 400e-6;  // kg m²
  for (std::size_t k = 0; k < motion.size(); ++k) {
    // Virtual power: T ω_crank = I α ω, here in N mm.
    EXPECT_NEAR(torque[k], 1000 * inertia * (alpha[k] * testing::kDegree) * (omega[k] * testing::kDegree),
                1e-9)
        << k;
    if (omega[k] == 0) {
      EXPECT_EQ(force[k], 0) << k;
    }
  }
}

// The pin is not in a slot yet: the crank turns about its pivot, also against the wheel, which stands still.
TEST(GenevaWheel, HasTheInstantCentresOfItsStart) {
  const auto findings = mobility_of(shipped_model("geneva_four_slots"));
  ASSERT_TRUE(findings);
  const std::string json = mobility_json(*findings), text = mobility_text(*findings);
  EXPECT_TRUE(contains(text, "crank, wheel: (0, 0)"));
  EXPECT_TRUE(contains(text, "ground, crank: (0, 0)"));
  EXPECT_EQ(json.find("-1.408"), std::string::npos);
}

TEST(GenevaWheel, HasJerkOnlyWhileItIsDriven) {
  RunSettings settings;
  settings.jerk = true;
  settings.positions = {0, 90, 180, 270};
  const Motion motion = motion_of(shipped_model("geneva_four_slots"), settings);
  const auto jerk = motion.column("wheel.jerk");
  const double m = std::sin(M_PI / 4);
  EXPECT_NEAR(jerk[0], 0, 1e-12);
  EXPECT_NEAR(jerk[1], 0, 1e-12);
  EXPECT_NEAR(jerk[2] * testing::kDegree, m * (1 - m * m) / std::pow(1 - m, 4), 1e-9);
}

// A disc of radius 20, with its centre 10 from its pivot, strikes a tappet that rests 5 above its lowest
// position: y = 20 + 10 sin θ where that is above 25, between 30° and 150°.
const std::string kTappet =
    profile_of({R"(curves.disc = { type = "circle", center = [10, 0], radius = 20 })",
                R"(pose = { x = 0, y = 25 }
curves.face = { type = "line", point = [0, 0], normal = [0, -1] })",
                "direction = [0, 1]\nfrom = 25", "between = [\"cam\", \"follower\"]\nkeep = \"gap\"",
                "start = 0\nend = 720\nsamples = 73\nvelocity = \"1 rad/s\""});

TEST(LashedTappet, IsLiftedOffItsSeatAndComesBackToIt) {
  const Motion motion = motion_of(model_of(kTappet));
  ASSERT_TRUE(motion.good());
  const auto y = motion.column("guide.position");
  const auto v = motion.column("guide.velocity");
  const auto pressure = motion.column("touch.x");
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double theta = 10.0 * static_cast<double>(k) * testing::kDegree;
    const double reach = 20 + 10 * std::sin(theta);
    EXPECT_NEAR(y[k], std::max(25.0, reach), 1e-9) << k;
    if (std::abs(reach - 25) > 1e-6) {
      EXPECT_NEAR(v[k], reach > 25 ? 10 * std::cos(theta) : 0, 1e-9) << k;
      EXPECT_EQ(std::isnan(pressure[k]), reach < 25) << k;
    }
  }
  const auto engaged = events_of(motion, EventType::kEngage);
  const auto released = events_of(motion, EventType::kRelease);
  ASSERT_EQ(engaged.size(), 2U);
  ASSERT_EQ(released.size(), 2U);
  EXPECT_NEAR(engaged[0].driver, 30, 1e-6);
  EXPECT_NEAR(released[0].driver, 150, 1e-9);
  EXPECT_NEAR(engaged[1].driver, 390, 1e-6);
  EXPECT_TRUE(contains(engaged[0].cause, "jumps from 0 to 0.1511"));
  EXPECT_TRUE(contains(released[0].cause, "comes to the end of its guide"));
}

TEST(LashedTappet, HasTheSameEventsWhateverTheRows) {
  const Motion coarse = motion_of(model_of(kTappet, {"driver.samples=3"}));
  const auto engaged = events_of(coarse, EventType::kEngage);
  ASSERT_EQ(engaged.size(), 2U);
  EXPECT_NEAR(engaged[1].driver, 390, 1e-6);
}

// A roller of 6 on a slide at 7°, over a disc of 45 whose centre turns about O; it rests on a seat.
double seated_roller(double theta, double seat) {
  const std::complex<double> centre = std::polar(1.0, theta) * std::complex<double>(9, 2.5);
  const std::complex<double> along =
      (centre - std::complex<double>(0, -2)) * std::polar(1.0, -7 * testing::kDegree);
  return std::max(seat, along.real() + std::sqrt(51.0 * 51.0 - along.imag() * along.imag()));
}

Motion seated_roller_motion(double seat, int samples) {
  return motion_of(model_of(fmt::format(R"([bodies.ground]
points = {{ O = [0, 0], G = [0, -2] }}
[bodies.cam]
points.O = [0, 0]
curves.disc = {{ type = "circle", center = [9, 2.5], radius = 45 }}
[bodies.follower]
pose = {{ x = 59.92, y = 5.357, angle = 7 }}
points.P = [0, 0]
curves.roller = {{ type = "circle", center = [0, 0], radius = 6 }}
[joints]
pivot = {{ type = "revolute", between = ["ground.O", "cam.O"] }}
guide = {{ type = "prismatic", between = ["ground.G", "follower.P"], direction = 7, from = {} }}
[contacts.touch]
between = ["cam.disc", "follower.roller"]
keep = "gap"
[driver]
joint = "pivot"
start = 0
end = 720
samples = {}
)",
                                        seat, samples)));
}

// The seat is found to within a rounding, on either side of it.
TEST(SeatedRoller, IsPutDownAndLiftedWhateverTheRowsAndTheSeat) {
  for (const double seat : {50.1, 52.0, 54.0, 56.7, 59.0}) {
    for (int samples = 19; samples <= 361; samples += 18) {
      SCOPED_TRACE(fmt::format("{} {}", seat, samples));
      const Motion motion = seated_roller_motion(seat, samples);
      ASSERT_TRUE(motion.good());
      EXPECT_EQ(events_of(motion, EventType::kEngage).size(), 2U);
      EXPECT_EQ(events_of(motion, EventType::kRelease).size(), 2U);
      for (std::size_t k = 0; k < motion.size(); ++k) {
        const double theta = motion.column("driver")[k] * testing::kDegree;
        ASSERT_NEAR(motion.column("guide.position")[k], seated_roller(theta, seat), 1e-9) << k;
      }
    }
  }
}

// The face follows at 30 + 10 sin θ, from where it has been lifted off its seat.
TEST(Tappet, MayStartOnItsSeatHoweverSmallTheGap) {
  for (const double gap : {1e-9, 1e-6, 1e-4, 3e-3, 0.1, 5.0}) {
    SCOPED_TRACE(gap);
    const double seat = 30 + gap;
    const Motion motion = motion_of(model_of(testing::profile_of(testing::SlidingCam{
        "curves.disc = { type = \"circle\", center = [10, 0], radius = 30 }",
        fmt::format("pose.y = {}\ncurves.face = {{ type = \"line\", point = [0, 0], normal = [0, -1] }}",
                    seat),
        fmt::format("direction = [0, 1]\nfrom = {}", seat),
        "between = [\"cam.disc\", \"follower.face\"]\nkeep = \"gap\"",
        "start = 0\nend = 90\nsamples = 91"})));
    ASSERT_TRUE(motion.good());
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double lifted = 30 + 10 * std::sin(static_cast<double>(k) * testing::kDegree);
      EXPECT_NEAR(motion.column("guide.position")[k], std::max(seat, lifted), 1e-9) << k;
    }
    const auto engaged = events_of(motion, EventType::kEngage);
    ASSERT_EQ(engaged.size(), 1U);
    EXPECT_NEAR(engaged[0].driver * testing::kDegree, std::asin(gap / 10), 1e-9);
  }
}

// Crank 20, rod 60, slide along x: x = 20 cos θ + √(60² - 20² sin² θ), between 40 and 80.
std::string slider_crank(const std::string& ends) {
  return testing::slider_crank_profile(20, 60, "", ends) + R"([driver]
joint = "main"
start = 0
end = 360
samples = 37
)";
}

TEST(GuideWithEnds, EndsTheMotionWhereTheSliderLeavesItAndTakesItUpWhereItIsBack) {
  const Motion motion = motion_of(model_of(slider_crank("from = 50")));
  EXPECT_FALSE(motion.good());
  const auto x = motion.column("cylinder.position");
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double theta = 10.0 * static_cast<double>(k) * testing::kDegree;
    const double wanted = 20 * std::cos(theta) + std::sqrt(3600 - 400 * std::sin(theta) * std::sin(theta));
    const bool within = wanted >= 50;
    ASSERT_EQ(motion.statuses()[k], within ? RowStatus::kOk : RowStatus::kNotAssemblable) << k;
    if (within) {
      EXPECT_NEAR(x[k], wanted, 1e-12);
    }
  }
  const auto ends = events_of(motion, EventType::kEnd);
  ASSERT_EQ(ends.size(), 2U);
  // 50 = 20 c + √(3600 - 400 s²): c = (2500 + 400 - 3600)/2000.
  const double at = std::acos(-0.35) / testing::kDegree;
  EXPECT_NEAR(ends[0].driver, at, 1e-9);
  EXPECT_NEAR(ends[1].driver, 360 - at, 1e-9);
  EXPECT_EQ(ends[0].item, "cylinder");
  EXPECT_TRUE(contains(ends[0].cause, "joint cylinder comes to the end of its line, `from`"));
}

TEST(GuideWithEnds, ThatIsLongEnoughChangesNothing) {
  const Motion motion = motion_of(model_of(slider_crank("from = 40\nto = 80")));
  EXPECT_TRUE(motion.good());
  EXPECT_TRUE(events_of(motion, EventType::kEnd).empty());
}

TEST(GuideWithEnds, IsSaidWhereItCannotStart) {
  const auto motion = model_of(slider_crank("from = 0\nto = 70")).run();
  ASSERT_FALSE(motion);
  EXPECT_TRUE(contains(to_string(motion.error()), "joint cylinder would be beyond the end of its line"));
}

TEST(GuideWithEnds, IsNotNamedWhereTheLinksCannotReachEachOther) {
  // The slider's pose is beyond the end of the guide, but the actual reason is that the rod is too short.
  const auto motion =
      model_of(slider_crank("from = 0\nto = 70"), {"driver.start=90", "bodies.rod.points.B=[5, 0]"}).run();
  ASSERT_FALSE(motion);
  EXPECT_FALSE(contains(to_string(motion.error()), "beyond the end of its line"));
}

std::string error_of(const std::string& text) {
  const auto model = Model::from_text(text, "test.toml");
  return model ? "" : to_string(model.error());
}

TEST(MistakesInGaps, AreSaidWithPlaceAndRemedy) {
  EXPECT_TRUE(contains(error_of(slider_crank("from = 90\nto = 80")), "`from` must be below `to`"));
  EXPECT_TRUE(contains(error_of(replaced(kTappet, "between = [\"ground.O\", \"cam.O\"]",
                                         "between = [\"ground.O\", \"cam.O\"]\nfrom = 3")),
                       "has a meaning for prismatic joints and slots only"));
  EXPECT_TRUE(contains(error_of(replaced(kTappet, "\"gap\"", "\"gaps\"")), "touch"));
  EXPECT_TRUE(contains(error_of(replaced(kTappet, "keep = \"gap\"", "keep = \"gap\"\nrolling = true")),
                       "curves that may part slip"));
  EXPECT_TRUE(contains(error_of(replaced(kTappet, "\"cam\", ", "\"cam.disk*\", ")),
                       "no curve of `cam` has a name that begins so"));
  EXPECT_TRUE(contains(error_of(replaced(kTappet, "\"cam\", ", "\"ground\", ")),
                       "body `ground` has no curve that could touch anything"));
  EXPECT_TRUE(contains(error_of(replaced(kTappet, "\"cam\", ", "\"can\", ")), "there is no body `can`"));
}

TEST(Tappet, IsOpenAtTheStartWhateverItsApproach) {
  const Model model = model_of(replaced(kTappet, "keep = \"gap\"", "keep = \"gap\"\napproach = \"-\""));
  ASSERT_EQ(model.notes().size(), 1U);
  EXPECT_TRUE(contains(to_string(model.notes()[0]), "its `approach` has no effect"));
}

// Like the centre line of a slot, whose ends are not edges. The disc touches it at x = 10 cos θ: between 60°
// and 120°, and 240° and 300°.
TEST(FaceOfBothSides, IsLeftAtItsEndAndTakenUpWhereTheContactIsBack) {
  std::string text = replaced(kTappet, "{ type = \"line\", point = [0, 0], normal = [0, -1] }",
                              "{ type = \"segment\", from = [-5, 0], to = [5, 0] }");
  text = replaced(replaced(text, "keep = \"gap\"", "both_sides = true"), "from = 25", "");
  text = replaced(text, "start = 0", "start = 90");
  const Motion motion = motion_of(model_of(text, {"driver.end=450", "driver.samples=73"}));
  EXPECT_FALSE(motion.good());
  const auto y = motion.column("guide.position");
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double theta = (90 + 5.0 * static_cast<double>(k)) * testing::kDegree;
    if (std::abs(std::abs(std::cos(theta)) - 0.5) > 1e-9) {
      ASSERT_EQ(motion.statuses()[k] == RowStatus::kOk, std::abs(std::cos(theta)) < 0.5) << k;
    }
    if (motion.statuses()[k] == RowStatus::kOk) {
      EXPECT_NEAR(y[k], 20 + 10 * std::sin(theta), 1e-9) << k;
    }
  }
  const auto ends = events_of(motion, EventType::kEnd);
  ASSERT_EQ(ends.size(), 4U);
  EXPECT_NEAR(ends[0].driver, 120, 1e-9);
  EXPECT_NEAR(ends[1].driver, 240, 1e-9);
  EXPECT_NEAR(ends[2].driver, 300, 1e-9);
  EXPECT_NEAR(ends[3].driver, 420, 1e-9);
  EXPECT_TRUE(contains(ends[0].cause, "reaches the end of the curve of follower"));
}

// Two discs on one body, far apart: the contact moves from one to the other.
TEST(WholeBodies, TouchWithWhicheverCurveIsThere) {
  const std::string text = profile_of({R"(curves.base = { type = "circle", center = [0, 0], radius = 30 }
curves.nose = { type = "circle", center = [25, 0], radius = 10 })",
                                       R"(pose = { x = 0, y = 30 }
curves.face = { type = "line", point = [0, 0], normal = [0, -1] })",
                                       "direction = [0, 1]", R"(between = ["cam", "follower"])",
                                       "start = 0\nend = 360\nsamples = 361"});
  const Motion motion = motion_of(model_of(text));
  EXPECT_TRUE(motion.good());
  const auto y = motion.column("guide.position");
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double theta = static_cast<double>(k) * testing::kDegree;
    EXPECT_NEAR(y[k], std::max(30.0, 10 + 25 * std::sin(theta)), 1e-9) << k;
  }
  const auto over = events_of(motion, EventType::kSecondContact);
  ASSERT_EQ(over.size(), 2U);
  EXPECT_NEAR(over[0].driver, std::asin(0.8) / testing::kDegree, 1e-6);
  EXPECT_NEAR(over[1].driver, 180 - std::asin(0.8) / testing::kDegree, 1e-6);
}

// Discs that overlap, some of them within others: the edge stays on the outline of all of them together, also
// where its pose is on an arc within another disc.
TEST(WholeBodies, ThatOverlapAreTouchedOnTheirCommonOutline) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(10, 30), place(-12, 12);
  for (int trial = 0; trial < 20; ++trial) {
    std::string discs;
    std::vector<std::array<double, 3>> all;
    for (int i = 0; i < 4; ++i) {
      // Each contains the origin.
      const std::array<double, 3> disc = {place(random) / 2, place(random) / 2, radius(random)};
      discs += fmt::format("curves.disc{} = {{ type = \"circle\", center = [{}, {}], radius = {} }}\n", i,
                           disc[0], disc[1], disc[2]);
      all.push_back(disc);
    }
    const auto height = [&](double theta) {
      double highest = 0;
      for (const auto& [cx, cy, r] : all) {
        const double x = cx * std::cos(theta) - cy * std::sin(theta);
        const double y = cx * std::sin(theta) + cy * std::cos(theta);
        highest = std::max(highest, y + std::sqrt(r * r - x * x));
      }
      return highest;
    };
    const std::string pose = fmt::format("pose = {{ x = 0, y = {} }}\n", all[0][1] + all[0][2]);
    const std::string text =
        profile_of({discs, pose + "curves.edge = { type = \"point\", at = [0, 0] }", "direction = [0, 1]",
                    R"(between = ["cam", "follower"])", "start = 0\nend = 360\nsamples = 73"});
    const Motion motion = motion_of(model_of(text));
    EXPECT_TRUE(motion.good()) << trial;
    const auto y = motion.column("guide.position");
    for (std::size_t k = 0; k < motion.size(); ++k) {
      EXPECT_NEAR(y[k], height(static_cast<double>(k) * 5 * testing::kDegree), 1e-9) << trial << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace higherpair

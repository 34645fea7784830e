#include "higherpair/front/check.hpp"

#include "front/sliding_cam.hpp"
#include "higherpair/cam/hertz.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::contains_all;
using ::testing::IsEmpty;
using testing::model_of;
using testing::profile_of;
using testing::shipped_model;

constexpr double kDeg = kPi / 180;

CheckReport checked(const Model& model, const CheckSettings& settings = {}) {
  auto report = check(model, settings);
  if (!report) {
    throw std::runtime_error(to_string(report.error()));
  }
  return *std::move(report);
}

CheckReport checked(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return checked(model_of(text, overrides));
}

const CheckFigure* find(const CheckReport& report, const std::string& item, const std::string& quantity,
                        const std::string& of = "") {
  for (const CheckFigure& figure : report.figures) {
    if (figure.item == item && figure.quantity == quantity && (of.empty() || figure.of == of)) {
      return &figure;
    }
  }
  return nullptr;
}

const CheckFigure& figure(const CheckReport& report, const std::string& item, const std::string& quantity,
                          const std::string& of = "") {
  const CheckFigure* found = find(report, item, quantity, of);
  if (found == nullptr) {
    throw std::out_of_range(item + " has no " + quantity);
  }
  return *found;
}

double value(const CheckReport& report, const std::string& item, const std::string& quantity,
             const std::string& of = "") {
  return figure(report, item, quantity, of).value.value();
}

// A cam in millimetres and its translating follower: dwell, rise by 1, dwell and return, over 90 degrees
// each.
std::string four_quarters(const std::string& follower, double height, const std::string& more = "") {
  return profile_of({R"(curves.flank = { type = "cam", law = "lift", contact = "touch" })",
                     fmt::format("pose = {{ x = 0, y = {:.17g} }}\ncurves.tip = {}", height, follower),
                     "direction = [0, 1]", R"(between = ["cam.flank", "follower.tip"])",
                     fmt::format(R"(end = 360
velocity = "1 rad/s"
[laws.lift]
segments = [ {{ over = 90, law = "dwell" }}, {{ over = 90, law = "cycloidal", rise = 1 }},
             {{ over = 90, law = "dwell" }}, {{ over = 90, law = "cycloidal", rise = -1 }} ]
{})",
                                 more)});
}

const char* const kFace = R"({ type = "line", point = [0, 0], normal = [0, -1] })";
const char* const kRoller = R"({ type = "circle", center = [0, 0], radius = 0.5 })";

// A crank that turns a wheel by gears.
constexpr const char* kGears = R"([bodies.ground]
points.O = [0, 0]
points.P = [60, 0]
[bodies.crank]
points.O = [0, 0]
[bodies.wheel]
pose = { x = 60 }
points.P = [0, 0]
[joints]
O    = { type = "revolute", between = ["ground.O", "crank.O"] }
P    = { type = "revolute", between = ["ground.P", "wheel.P"] }
mesh = { type = "gears", between = ["crank.O", "wheel.P"], ratio = 0.5 }
[driver]
joint = "O"
samples = 3
[limits]
max_angular_acceleration = 1
)";

// A rod on a crank rubs on a post. Where ground has its pivots, and where the origin is, does not matter.
TEST(Check, AContactWithGroundHasNoPressureAngle) {
  const auto rod = [](double x, const std::string& between) {
    return model_of(fmt::format(R"([bodies.ground]
points = {{ O = [{0}, 0], Z = [{0}, 50] }}
curves.post = {{ type = "circle", center = [{1}, -9], radius = 5 }}
[bodies.crank]
points = {{ O = [0, 0], A = [20, 0] }}
[bodies.rod]
pose = {{ x = {2}, y = 0, angle = 0 }}
points.A = [0, 0]
curves.nose = {{ type = "circle", center = [40, 0], radius = 4 }}
[joints]
main = {{ type = "revolute", between = ["ground.O", "crank.O"] }}
pin = {{ type = "revolute", between = ["crank.A", "rod.A"] }}
[contacts.touch]
between = {3}
[driver]
joint = "main"
end = 30
samples = 4
)",
                                x, x + 60, x + 20, between));
  };
  for (const char* between : {R"(["rod.nose", "ground.post"])", R"(["ground.post", "rod.nose"])"}) {
    const CheckReport here = checked(rod(0, between)), there = checked(rod(-30, between));
    EXPECT_EQ(find(here, "contacts.touch", "pressure_angle"), nullptr);
    EXPECT_NEAR(value(here, "contacts.touch", "sliding_speed"),
                value(there, "contacts.touch", "sliding_speed"), 1e-9);
    ASSERT_EQ(here.figures.size(), there.figures.size());
    const Motion motion = rod(0, between).run().value();
    for (const double pressure : motion.column("touch.pressure").values) EXPECT_TRUE(std::isnan(pressure));
  }
  const Motion motion = rod(0, R"(["rod.nose", "ground.post"])").run().value();
  for (const double angle : motion.column("touch.transmission").values) EXPECT_TRUE(std::isnan(angle));
}

TEST(Check, OfThousandsOfTurnsEndsAndLeavesOpenWhatIsNotExamined) {
  const CheckReport turn = checked(kGears);
  EXPECT_TRUE(turn.good);
  EXPECT_EQ(figure(turn, "joints.P", "acceleration").verdict, Verdict::kKept);
  const CheckReport report = checked(kGears, {"driver.end=6e5"});
  EXPECT_FALSE(report.good);
  ASSERT_FALSE(report.events.empty());
  const Event& end = report.events.back();
  EXPECT_EQ(end.type, EventType::kEnd);
  EXPECT_NEAR(end.driver, 500'000, 1);
  EXPECT_TRUE(
      contains(end.cause, "the path is too long to look for extremes beyond; let the drivers go less far"));
  EXPECT_EQ(figure(report, "joints.P", "acceleration").verdict, Verdict::kUndecided);
  EXPECT_EQ(figure(report, "joints.P", "acceleration").remark, "not examined beyond 500000 deg");
}

TEST(Check, OfAFlatFacedCamGivesThePublishedFaceAndRadius) {
  const CheckReport report =
      checked(four_quarters(kFace, 1.892631278649, "[limits]\nmin_convex_radius = 0.25\n"));
  EXPECT_NEAR(value(report, "contacts.touch", "face_width"), 2.546479089, 5e-10);
  EXPECT_NEAR(value(report, "contacts.touch", "face_width"), 8 / kPi, 1e-12);
  EXPECT_NEAR(value(report, "contacts.touch", "convex_radius", "cam.flank"), 0.25, 1e-11);
  EXPECT_EQ(figure(report, "contacts.touch", "convex_radius", "cam.flank").verdict, Verdict::kKept);
  EXPECT_NEAR(value(report, "contacts.touch", "pressure_angle"), 0, 1e-13);
  EXPECT_NEAR(value(report, "cam.flank", "base_circle_for_radius"), 1.892631278649, 1e-11);
  // From the law: a = 2π h/T² and j = 4π² h/T³ with T = π/2 s.
  EXPECT_NEAR(std::abs(value(report, "joints.guide", "acceleration")), 2 * kPi / (kPi * kPi / 4), 1e-11);
  EXPECT_NEAR(std::abs(value(report, "joints.guide", "jerk")), 4 * kPi * kPi / (kPi * kPi * kPi / 8), 1e-9);
  EXPECT_NEAR(figure(report, "joints.guide", "jerk").at.value(), 90, 1e-6);
  EXPECT_TRUE(report.good);
}

TEST(Check, OfARollerCamGivesThePublishedAngleRadiusAndSizes) {
  const CheckReport report = checked(
      four_quarters(kRoller, 1.750944530030, "[limits]\nmax_pressure_angle = 30\nmin_convex_radius = 0.2\n"));
  const CheckFigure& pressure = figure(report, "contacts.touch", "pressure_angle");
  EXPECT_NEAR(pressure.value.value(), 30, 1e-9);
  EXPECT_NEAR(pressure.at.value(), 130.893, 5e-4);
  EXPECT_EQ(pressure.verdict, Verdict::kKept);
  EXPECT_EQ(pressure.unit, "deg");
  EXPECT_EQ(pressure.limit, 30);
  const CheckFigure& radius = figure(report, "contacts.touch", "convex_radius", "cam.flank");
  EXPECT_NEAR(radius.value.value(), 1.394109813 - 0.5, 5e-9);
  EXPECT_NEAR(radius.at.value(), 156.423, 5e-4);
  EXPECT_NEAR(value(report, "cam.flank", "prime_circle"), 1.750944530030, 1e-12);
  EXPECT_NEAR(value(report, "cam.flank", "base_circle"), 1.250944530030, 1e-12);
  EXPECT_NEAR(value(report, "cam.flank", "prime_circle_for_pressure_angle"), 1.750944530030, 1e-11);
  EXPECT_NEAR(value(report, "cam.flank", "roller_for_radius"), 1.394109813 - 0.2, 5e-9);
}

TEST(Check, HoldsTheReturnToALimitOfItsOwn) {
  const std::string limits = "[limits]\nmax_pressure_angle = 30\nmax_return_pressure_angle = 45\n";
  const CheckReport report = checked(four_quarters(kRoller, 2, limits));
  EXPECT_NEAR(value(report, "cam.flank", "prime_circle_with_offset"), 1.225614472, 5e-10);
  EXPECT_TRUE(contains(figure(report, "cam.flank", "prime_circle_with_offset").remark,
                       "0.3293225193 mm to the side"));
  // Radial and symmetric: both strokes have the same angle.
  EXPECT_NEAR(value(report, "contacts.touch", "pressure_angle"),
              value(report, "contacts.touch", "return_pressure_angle"), 1e-10);
  EXPECT_LT(figure(report, "contacts.touch", "pressure_angle").at.value(), 180);
  EXPECT_GT(figure(report, "contacts.touch", "return_pressure_angle").at.value(), 270);
  EXPECT_EQ(figure(report, "contacts.touch", "return_pressure_angle").limit, 45);
}

// Driven backwards, the return is the rise: its limit is the one that the larger cam keeps.
TEST(Check, OfACamDrivenBackwardsHoldsItsStrokesToTheLimitsTheOtherWayRound) {
  const auto size = [](const std::string& velocity, int out, int back) {
    return value(checked(profile_of({R"(curves.flank = { type = "cam", law = "lift", contact = "touch" })",
                                     fmt::format("pose = {{ x = 0, y = 2 }}\ncurves.tip = {}", kRoller),
                                     "direction = [0, 1]", R"(between = ["cam.flank", "follower.tip"])",
                                     fmt::format(R"(end = 360
velocity = "{} rad/s"
[laws.lift]
segments = [ {{ over = 60, law = "cycloidal", rise = 1 }}, {{ over = 90, law = "dwell" }},
             {{ over = 120, law = "cycloidal", rise = -1 }}, {{ over = 90, law = "dwell" }} ]
[limits]
max_pressure_angle = {}
max_return_pressure_angle = {}
)",
                                                 velocity, out, back)})),
                 "cam.flank", "prime_circle_for_pressure_angle");
  };
  EXPECT_NEAR(size("-1", 45, 30), size("1", 30, 45), 1e-11);
  EXPECT_GT(size("1", 30, 45), 1.1 * size("1", 45, 30));
}

// The centre of the roller rests 40 from the pivot, 12 beside it: what rounding moves it by is no return.
TEST(Check, OfAFollowerAtRestHasNoReturn) {
  const CheckReport report = checked(profile_of(
      {"curves.disc = { type = \"circle\", center = [0, 0], radius = 30 }",
       "pose = { x = 0, y = 38 }\ncurves.roller = { type = \"circle\", center = [12, 0], radius = 10 }",
       "direction = [0, 1]\n", "between = [\"cam.disc\", \"follower.roller\"]",
       "end = 360\n[limits]\nmax_pressure_angle = 30\nmax_return_pressure_angle = 45\n"}));
  EXPECT_NEAR(value(report, "contacts.touch", "pressure_angle"), std::asin(12.0 / 40) / kDeg, 1e-10);
  EXPECT_EQ(find(report, "contacts.touch", "return_pressure_angle"), nullptr);
}

// A harmonic rise of 50 mm over half a turn and a smallest radius of 25: the cam is a circle of radius 50.
TEST(Check, OfASimpleHarmonicCamFindsACircle) {
  const std::string text =
      profile_of({R"(curves.flank = { type = "cam", law = "lift", contact = "touch" })",
                  R"(pose = { x = 0, y = 25 }
curves.face = { type = "line", point = [0, 0], normal = [0, -1] })",
                  "direction = [0, 1]", R"(between = ["cam.flank", "follower.face"])", R"([laws.lift]
segments = [ { over = 180, law = "harmonic", rise = 50 }, { over = 180, law = "harmonic", rise = -50 } ])"});
  const CheckReport report = checked(text);
  EXPECT_NEAR(value(report, "contacts.touch", "convex_radius", "cam.flank"), 50, 1e-10);
  EXPECT_NEAR(value(report, "contacts.touch", "face_width"), 50, 1e-10);  // from -25 to 25
}

// e = 10 under a flat face, 0.5 kg, and a spring of 2 N/mm that is compressed by 5 mm at the lowest position:
// N is smallest at the top, 2 (5 + 20) N - 0.5 kg 10 mm ω².
std::string eccentric_profile(double speed, const std::string& limits = "") {
  return profile_of({R"(curves.disc = { type = "circle", center = [10, 0], radius = 30 })",
                     R"(pose = { x = 0, y = 30 }
curves.face = { type = "line", point = [0, 0], normal = [0, -1] }
mass = 0.5
center_of_mass = [0, 0])",
                     "direction = [0, 1]", R"(between = ["cam.disc", "follower.face"])",
                     fmt::format(R"(end = 360
velocity = "{} rad/s"
[springs]
s = {{ joint = "guide", stiffness = 2, free_length = 15 }}
{})",
                                 speed, limits)});
}

TEST(Check, FindsTheSpeedAtWhichAnEccentricLosesItsFollower) {
  const CheckReport report =
      checked(eccentric_profile(40, "[limits]\nmin_speed_factor = 2.5\nmin_contact_force = 10\n"));
  const CheckFigure& factor = figure(report, "mechanism", "speed_factor");
  EXPECT_NEAR(factor.value.value(), 100.0 / 40, 1e-12);
  EXPECT_EQ(factor.verdict, Verdict::kKept);
  EXPECT_FALSE(factor.at);
  // N = 2 (15 + 10 sin) - 8 sin: smallest at the bottom.
  const CheckFigure& least = figure(report, "contacts.touch", "least_contact_force");
  EXPECT_NEAR(least.value.value(), 2 * (15 - 10) + 8, 1e-11);
  EXPECT_NEAR(least.at.value(), 270, 1e-6);
  EXPECT_NEAR(value(report, "contacts.touch", "contact_force"), 50 - 8, 1e-11);
  EXPECT_TRUE(report.good);
}

TEST(Check, FailsWhereAContactOpens) {
  const CheckReport report = checked(eccentric_profile(110));
  const CheckFigure& least = figure(report, "contacts.touch", "least_contact_force");
  EXPECT_NEAR(least.value.value(), 50 - 0.5 * 0.010 * 110 * 110, 1e-11);
  EXPECT_NEAR(least.at.value(), 90, 1e-6);
  EXPECT_EQ(least.verdict, Verdict::kExceeded);
  EXPECT_EQ(least.limit, 0);
  EXPECT_TRUE(contains(least.remark, "opens"));
  EXPECT_NEAR(value(report, "mechanism", "speed_factor"), 100.0 / 110, 1e-12);
  EXPECT_FALSE(report.good);
  EXPECT_THAT(report.events, ::testing::Contains(::testing::Field(&Event::type, EventType::kContactOpen)));
}

// The torque is N e cos θ; the sliding speed of a flat face is y ω.
TEST(Check, DoesNotDecideALimitOfTheSpeedThatDampersHide) {
  // Contact force 18.943 N above the weight: opens at sqrt(18.943/(0.3 · 0.01)) rad/s, here without dampers.
  const std::vector<std::string> limited = {"limits.min_speed_factor=1"};
  EXPECT_NEAR(
      value(check(shipped_model("cam_with_return_spring", limited)).value(), "mechanism", "speed_factor"),
      std::sqrt(18.943 / 0.003) / (20 * kPi), 1e-9);
  const std::vector<std::string> damped = {"limits.min_speed_factor=1", "springs.return.damping=1e-7"};
  const CheckReport report = checked(shipped_model("cam_with_return_spring", damped));
  const CheckFigure& factor = figure(report, "mechanism", "speed_factor");
  EXPECT_FALSE(factor.value);
  EXPECT_EQ(factor.verdict, Verdict::kUndecided);
  EXPECT_TRUE(contains(factor.remark, "not known"));
  EXPECT_FALSE(report.good);
}

TEST(Check, SaysThatAContactOpensAtRest) {
  // Gravity lifts the follower off, whatever the speed and the damper.
  for (const char* damping : {"springs.return.damping=0", "springs.return.damping=1e-3"}) {
    const std::vector<std::string> lifted = {"limits.min_speed_factor=1", "gravity=[0,1e6]", damping};
    const CheckReport report = checked(shipped_model("cam_with_return_spring", lifted));
    const CheckFigure& factor = figure(report, "mechanism", "speed_factor");
    EXPECT_EQ(factor.value, 0);
    EXPECT_EQ(factor.verdict, Verdict::kExceeded);
    EXPECT_TRUE(contains(factor.remark, "opens at rest"));
  }
}

TEST(Check, GivesTorqueAndSpeedsOfAnEccentric) {
  const CheckReport report = checked(eccentric_profile(40, "[limits]\nmax_driving_torque = \"0.25 N m\"\n"));
  double torque = 0;
  for (int i = 0; i <= 200000; ++i) {
    const double theta = 2 * kPi * i / 200000;
    torque = std::max(torque, std::abs((30 + 12 * std::sin(theta)) * 10 * std::cos(theta)));
  }
  const CheckFigure& figure_of_torque = figure(report, "driver", "driving_torque");
  EXPECT_NEAR(std::abs(figure_of_torque.value.value()), torque, 1e-7);
  EXPECT_EQ(figure_of_torque.verdict, Verdict::kExceeded);
  EXPECT_EQ(figure_of_torque.limit, 250);
  EXPECT_FALSE(report.good);
  EXPECT_NEAR(value(report, "contacts.touch", "sliding_speed"), 40 * 40, 1e-9);  // y ω at the top
  EXPECT_NEAR(std::abs(value(report, "joints.guide", "acceleration")), 10 * 1600, 1e-8);
  EXPECT_NEAR(std::abs(value(report, "joints.guide", "jerk")), 10 * 64000, 1e-5);
  // Along the disc 30 ω, along the face 10 ω sin θ in the opposite direction.
  EXPECT_GT(value(report, "contacts.touch", "entrainment_speed"), 15 * 40);
}

// 1000 N on a roller over a disc: the normal force is 1000 N/cos φ, largest where sin φ = e/(r1 + r2).
TEST(Check, GivesHertzsPressureOfARollerUnderLoad) {
  const std::string text = R"([bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
curves.disc = { type = "circle", center = [6, 0], radius = 20 }
[bodies.follower]
pose = { x = 0, y = 29 }
points.P = [0, 0]
curves.roller = { type = "circle", center = [0, 0], radius = 10 }
[joints]
O     = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.O", "follower.P"], direction = [0, 1] }
[contacts.touch]
between = ["cam.disc", "follower.roller"]
[loads]
push = { body = "follower", point = "P", force = [0, -1000] }
[driver]
joint = "O"
end = 360
velocity = 1
[limits]
max_contact_pressure = "740 MPa"
elastic_modulus = "206 GPa"
poisson_ratio = 0.3
width = 10
)";
  const CheckReport report = checked(text);
  const double normal = 1000 / std::sqrt(1 - 0.04);
  // Pulled against the other wall of a groove, of radius -(20 + 2·10): 1/10 - 1/40 in place of 1/20 + 1/10.
  const CheckReport pulled = checked(text, {"contacts.touch.both_sides=true", "loads.push.force.1=1000"});
  EXPECT_NEAR(value(pulled, "contacts.touch", "contact_pressure"),
              735.1375547 * std::sqrt(normal / 1000) * std::sqrt(0.5), 1e-6);
  const CheckFigure& pressure = figure(report, "contacts.touch", "contact_pressure");
  EXPECT_NEAR(pressure.value.value(), 735.1375547 * std::sqrt(normal / 1000), 1e-6);
  EXPECT_EQ(pressure.verdict, Verdict::kExceeded);
  EXPECT_EQ(pressure.unit, "N/mm^2");
  EXPECT_NEAR(value(report, "contacts.touch", "contact_force"), normal, 1e-9);
  EXPECT_NEAR(value(report, "contacts.touch", "least_contact_force"), 1000, 1e-9);
  EXPECT_NEAR(value(report, "contacts.touch", "pressure_angle"), std::asin(0.2) / kDeg, 1e-10);
  EXPECT_EQ(figure(report, "contacts.touch", "convex_radius", "cam.disc").value, 20);
  EXPECT_EQ(figure(report, "contacts.touch", "convex_radius", "follower.roller").value, 10);
  EXPECT_THAT(report.notes, IsEmpty());
}

TEST(Check, OfACornerHasNoRadiusAndNoBoundForThePressure) {
  const std::string text = profile_of(
      {"curves.square = { type = \"chain\", spans = [{ type = \"segment\", from = [20, -20], to = [20, 20] "
       "}, "
       "{ type = \"segment\", from = [20, 20], to = [-20, 20] }, { type = \"segment\", from = [-20, 20], to "
       "= "
       "[-20, -20] }, { type = \"segment\", from = [-20, -20], to = [20, -20] }] }",
       "pose = { x = 0, y = 45 }\ncurves.roller = { type = \"circle\", center = [0, 0], radius = 10 }",
       "direction = [0, 1]", "between = [\"cam.square\", \"follower.roller\"]\napproach = \"-\"",
       "end = 360\n[loads]\npush = { body = \"follower\", point = \"P\", force = [0, -100] }\n[limits]\n"
       "max_contact_pressure = \"740 MPa\"\nmin_convex_radius = 3\nelastic_modulus = \"206 GPa\"\n"
       "poisson_ratio = 0.3\nwidth = 10"});
  const CheckReport report = checked(text);
  const CheckFigure& radius = figure(report, "contacts.touch", "convex_radius", "cam.square");
  EXPECT_EQ(radius.value, 0);
  EXPECT_EQ(radius.verdict, Verdict::kExceeded);
  const CheckFigure& pressure = figure(report, "contacts.touch", "contact_pressure");
  EXPECT_EQ(pressure.value, std::nullopt);
  EXPECT_EQ(pressure.verdict, Verdict::kExceeded);
  EXPECT_FALSE(report.good);
}

TEST(Check, NamesALimitOfAProgramThatMakesNoSense) {
  const Model model = shipped_model("ellipse_cam_roller");
  const auto with = [&](LimitKey key, double value) {
    CheckLimits limits;
    limits.all[static_cast<std::size_t>(key)] = GivenLimit{value, {}, "", {}};
    CheckSettings settings;
    settings.limits = std::make_shared<const CheckLimits>(limits);
    return check(model, settings);
  };
  const auto refusal = [&](LimitKey key, double value) { return to_string(with(key, value).error()); };
  EXPECT_TRUE(
      contains(refusal(LimitKey::kWidth, std::nan("")), "CheckLimits::all: width = nan: must be finite"));
  EXPECT_TRUE(contains(refusal(LimitKey::kElasticModulus, 0), "elastic_modulus = 0: must be > 0"));
  EXPECT_TRUE(contains(refusal(LimitKey::kPoissonRatio, 0.6), "poisson_ratio = 0.6: Poisson's ratio is"));
  EXPECT_TRUE(contains(refusal(LimitKey::kMaxPressureAngle, -1), "a pressure angle is limited to"));
  const auto unused = with(LimitKey::kMaxContactForce, 1);
  ASSERT_TRUE(unused);
  ASSERT_EQ(unused->notes.size(), 1U);
  EXPECT_TRUE(contains(note_text(unused->notes[0]),
                       "ellipse_cam_roller.toml: note: max_contact_force: nothing in this mechanism has"));
}

// A search for better numbers works on mechanisms of a model: their limits and materials remain.
TEST(Check, OfTheModelsOtherMechanismsHasTheSameLimits) {
  const Model model = shipped_model("checked_cam");
  const Model other = model.with_mechanism(model.mechanism()).value();
  EXPECT_EQ(value(checked(other), "contacts.touch", "contact_pressure"),
            value(checked(model), "contacts.touch", "contact_pressure"));
}

// Cycloidal rise of 10 mm in 120 degrees at 1000 rpm, 1.8 kg, 15 N/mm preloaded by 2.5 mm.
TEST(Check, SeesTheLiftOffOfACycloidalCam) {
  const std::string text = R"([bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
curves.flank = { type = "cam", law = "lift", contact = "touch" }
[bodies.follower]
pose = { x = 0, y = 60 }
points.P = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = [0, -1] }
mass = 1.8
center_of_mass = [0, 0]
[laws.lift]
segments = [ { over = 120, law = "cycloidal", rise = 10 }, { over = 60, law = "dwell" },
             { over = 120, law = "cycloidal", rise = -10 }, { over = 60, law = "dwell" } ]
[joints]
O     = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.O", "follower.P"], direction = [0, 1] }
[contacts.touch]
between = ["cam.flank", "follower.face"]
[springs]
s = { joint = "guide", stiffness = 15, free_length = 57.5 }
[driver]
joint = "O"
end = 360
velocity = "1000 rpm"
)";
  const Model model = model_of(text);
  RunSettings at_100;
  at_100.forces = true;
  at_100.positions = {100};
  const Motion motion = model.run(at_100).value();
  EXPECT_NEAR(motion.column("guide.acceleration")[0] / 1000, -136.035, 5e-4);
  EXPECT_NEAR(motion.column("touch.force")[0], -61.688, 5e-4);
  const CheckReport report = checked(model);
  const CheckFigure& least = figure(report, "contacts.touch", "least_contact_force");
  EXPECT_LE(least.value.value(), -61.688);
  EXPECT_EQ(least.verdict, Verdict::kExceeded);
  EXPECT_LT(value(report, "mechanism", "speed_factor"), 1);
  // At the reported speed the contact just holds.
  const double held = 1000 * value(report, "mechanism", "speed_factor");
  const CheckReport slower =
      checked(text, {fmt::format("driver.velocity=\"{:.17g} rpm\"", held * (1 - 1e-9))});
  EXPECT_TRUE(slower.good);
  EXPECT_NEAR(value(slower, "contacts.touch", "least_contact_force"), 0, 1e-5);
}

TEST(Check, OfASwingingRollerTakesTheAngleAtItsCentre) {
  const Model model = shipped_model("ellipse_cam_roller");
  const CheckReport report = checked(model);
  RunSettings settings;
  settings.samples = 20001;
  const Motion motion = model.run(settings).value();
  double centre = 0, contact = 0, least = 1e9, concave = 1e9;
  for (std::size_t row = 0; row < motion.size(); ++row) {
    centre = std::max(centre, 90 - motion.column("touch.transmission")[row]);
    contact = std::max(contact, motion.column("touch.pressure")[row]);
    const double rho = motion.column("touch.rho1")[row];
    (rho > 0 ? least : concave) = std::min(rho > 0 ? least : concave, std::abs(rho));
  }
  EXPECT_NEAR(value(report, "contacts.touch", "pressure_angle"), centre, 1e-6);
  EXPECT_NEAR(value(report, "contacts.touch", "pressure_angle_at_contact"), contact, 1e-6);
  EXPECT_NEAR(value(report, "contacts.touch", "convex_radius"), least, 1e-6);
  EXPECT_EQ(find(report, "contacts.touch", "concave_radius"), nullptr);
  EXPECT_GE(value(report, "contacts.touch", "pressure_angle"), centre);
}

TEST(Check, DoesNotDependOnTheNumberOfRows) {
  const Model model = shipped_model("checked_cam");
  const CheckReport whole = checked(model);
  for (const double samples : {2.0, 37.0, 1000.0}) {
    const CheckReport other = checked(model.with({{"driver.samples", samples}}).value());
    ASSERT_EQ(other.figures.size(), whole.figures.size());
    for (std::size_t i = 0; i < whole.figures.size(); ++i) {
      const CheckFigure &a = whole.figures[i], &b = other.figures[i];
      EXPECT_EQ(a.quantity, b.quantity);
      EXPECT_NEAR(a.value.value() / b.value.value(), 1, 1e-9) << a.item << " " << a.quantity;
      EXPECT_EQ(a.verdict, b.verdict);
    }
  }
}

// A round outline with a fine ripple, of 300 points. What samples of equal distance on the whole path miss
// in one turn they would find in the next.
TEST(Check, OfACamWithAFineRippleIsTheSameForAnyNumberOfTurns) {
  std::string points;
  for (int i = 0; i < 300; ++i) {
    const double angle = 2 * kPi * i / 300;
    const double r =
        40 + 5 * std::sin(angle) + 0.005 * std::sin(angle * 300 / 3.7) * (1 + std::sin(17 * angle) / 2);
    points +=
        fmt::format("{}[{:.12g}, {:.12g}]", i > 0 ? ", " : "", r * std::cos(angle), r * std::sin(angle));
  }
  const Model model = model_of(profile_of(
      {fmt::format(R"(curves.flank = {{ type = "spline", closed = true, points = [{}] }})", points),
       R"(pose = { x = 0, y = 55 }
curves.roller = { type = "circle", center = [0, 0], radius = 10 })",
       "direction = [0, 1]", R"(between = ["cam.flank", "follower.roller"])", "end = 360"}));
  const CheckReport once = checked(model);
  const CheckReport often = checked(model.with({{"driver.end", 1800}}).value());
  ASSERT_EQ(once.figures.size(), often.figures.size());
  for (std::size_t i = 0; i < once.figures.size(); ++i) {
    const CheckFigure &a = once.figures[i], &b = often.figures[i];
    EXPECT_NEAR(std::abs(a.value.value() / b.value.value()), 1, 1e-7) << a.item << " " << a.quantity;
  }
}

TEST(Check, OfACamThatTurnsBackwardsIsTheSame) {
  const CheckReport forward = checked(shipped_model("checked_cam"));
  const CheckReport backward = checked(
      shipped_model("checked_cam", {"driver.start=360", "driver.end=0", "driver.velocity=\"-600 rpm\""}));
  EXPECT_FALSE(forward.figures.empty());
  EXPECT_EQ(backward.figures.size(), forward.figures.size());
  for (const CheckFigure& one : forward.figures) {
    EXPECT_NEAR(std::abs(value(backward, one.item, one.quantity, one.of)), std::abs(one.value.value()),
                1e-8 * std::abs(one.value.value()))
        << one.item << " " << one.quantity;
  }
}

TEST(Check, NotesLimitsThatApplyToNothing) {
  const CheckReport report = checked(four_quarters(kRoller, 2, R"([limits]
max_face_width = 3
min_concave_radius = 1
max_angular_jerk = 5
max_driving_force = 9
min_speed_factor = 1.5
[limits.contacts.touch]
max_contact_force = 100
[limits.bodies.cam]
poisson_ratio = 0.3
)"));
  std::string notes;
  for (const Diagnostic& note : report.notes) {
    notes += to_string(note) + "\n";
  }
  EXPECT_TRUE(contains_all(
      notes, {"limits.max_face_width: nothing in this mechanism has this", "limits.max_driving_force",
              "limits.min_speed_factor", "limits.contacts.touch.max_contact_force",
              "limits.bodies.cam.poisson_ratio", "test.toml:"}));
  EXPECT_FALSE(contains(notes, "min_concave_radius"));
}

TEST(Check, TakesLimitsOfAProgram) {
  auto limits = std::make_shared<CheckLimits>();
  limits->all[static_cast<std::size_t>(LimitKey::kMaxPressureAngle)] = GivenLimit{10 * kDeg, {}, "mine", {}};
  CheckSettings settings;
  settings.limits = limits;
  const CheckReport report = checked(model_of(four_quarters(kRoller, 2)), settings);
  EXPECT_EQ(figure(report, "contacts.touch", "pressure_angle").verdict, Verdict::kExceeded);
  EXPECT_FALSE(report.good);
}

TEST(Check, OfAFreelyTurningRollerHasNoSliding) {
  const CheckReport report = checked(shipped_model("roller_body"));
  bool rolls = false;
  for (const CheckFigure& one : report.figures) {
    EXPECT_NE(one.quantity, "sliding_speed");
    rolls = rolls || one.quantity == "entrainment_speed";
  }
  EXPECT_TRUE(rolls);
}

// A disc about its pivot neither moves the arm nor turns the roller: the film is drawn in by the disc alone,
// at the speed of its rim, whichever body the contact names first.
TEST(Check, OfAFreelyTurningRollerIsDrawnInByTheOtherBody) {
  for (const char* between : {R"(["cam.disc", "roller.rim"])", R"(["roller.rim", "cam.disc"])"}) {
    const CheckReport report = checked(shipped_model(
        "roller_body", {"bodies.cam.curves.disc.center=[0, 0]", "bodies.cam.curves.disc.semi_axes=[20, 20]",
                        fmt::format("contacts.touch.between={}", between)}));
    for (const char* speed : {"entrainment_speed", "least_entrainment_speed"}) {
      EXPECT_NEAR(value(report, "contacts.touch", speed), 20 * 60 * kDeg, 1e-10) << between;
    }
  }
}

// The film is drawn in at e ω (1 - sin θ)/2.
TEST(Check, OfADiscWhoseRimPassesThroughItsPivotHasAPlaceWithoutEntrainment) {
  const CheckReport report = checked(
      profile_of({"curves.disc = { type = \"circle\", center = [10, 0], radius = 10 }",
                  fmt::format("pose = {{ x = 0, y = 10 }}\ncurves.tip = {}", kFace), "direction = [0, 1]",
                  "between = [\"cam.disc\", \"follower.tip\"]", "end = 360\nvelocity = \"1 rad/s\"\n"}));
  EXPECT_NEAR(value(report, "contacts.touch", "entrainment_speed"), 10, 1e-9);
  EXPECT_EQ(value(report, "contacts.touch", "least_entrainment_speed"), 0);
}

// Rolling turns the roller; the angle is that of what carries its pin all the same.
TEST(Check, OfARollerOnAPinHasThePressureAngleOfItsArm) {
  const double slips = value(checked(shipped_model("roller_body")), "contacts.touch", "pressure_angle");
  const double rolls = value(checked(shipped_model("roller_body", {"contacts.touch.rolling=true"})),
                             "contacts.touch", "pressure_angle");
  EXPECT_LT(slips, 80);
  EXPECT_NEAR(rolls, slips, 1e-9);
}

TEST(Check, OfALinkageHasAccelerationsAlone) {
  const CheckReport report = checked(shipped_model("slider_crank"));
  EXPECT_FALSE(report.figures.empty());
  for (const CheckFigure& one : report.figures) {
    EXPECT_TRUE(contains(one.item, "joints."));
  }
}

TEST(Check, SaysWhatStillGrowsTowardsALimitPosition) {
  const CheckReport report = checked(shipped_model("lock_up"));
  EXPECT_FALSE(report.good);
  EXPECT_TRUE(contains(figure(report, "contacts.touch", "sliding_speed").remark, "still grows"));
}

// The follower's load asks for a torque that goes to -∞ at the limit position, the cam's for 500 N mm: the
// largest torque in the samples is where the path begins.
TEST(Check, SaysWhatGrowsWithTheOtherSignThanItsLargestValue) {
  const CheckReport report = checked(shipped_model(
      "lock_up",
      {"driver.start=0", "driver.end=80", "loads.push={ body = \"follower\", torque = 100 }",
       "loads.hold={ body = \"cam\", torque = -500 }", "limits.joints.cam_pivot.max_driving_torque=1000"}));
  const CheckFigure torque = figure(report, "driver", "driving_torque");
  EXPECT_NEAR(torque.value.value(), 500 + 500 / 3.0, 1e-9);
  EXPECT_EQ(torque.at, 0);
  EXPECT_EQ(torque.verdict, Verdict::kUndecided);
  EXPECT_TRUE(contains_all(torque.remark, {"with the other sign it still grows at 65.",
                                           "deg, towards a limit position or dead point"}));
}

// Beginning next to the one limit position, where the acceleration is large already, it is not yet as large
// when the samples end beside the other one, towards which it has no bound.
TEST(Check, DoesNotDecideWhatGrowsFarFromItsLargestValue) {
  const CheckReport report =
      checked(shipped_model("lock_up", {"driver.start=294.168", "driver.end=430",
                                        "limits.joints.follower_pivot.max_angular_acceleration=1e11"}));
  const CheckFigure acceleration = figure(report, "joints.follower_pivot", "acceleration");
  EXPECT_NEAR(acceleration.at.value(), 294.168, 1e-9);
  EXPECT_EQ(acceleration.verdict, Verdict::kUndecided);
  EXPECT_TRUE(contains_all(acceleration.remark,
                           {"it still grows at 425.", "deg, towards a limit position or dead point"}));
  EXPECT_TRUE(contains(figure(report, "contacts.touch", "pressure_angle").remark, "it still grows at 425."));
}

// A parallelogram passes its change points smoothly.
TEST(Check, DecidesWhatIsSmoothThroughADeadPoint) {
  const CheckReport report =
      checked(shipped_model("parallelogram", {"limits.joints.right_pivot.max_angular_acceleration=1"}));
  EXPECT_EQ(figure(report, "joints.right_pivot", "acceleration").verdict, Verdict::kKept);
  for (const CheckFigure& one : report.figures) EXPECT_EQ(one.remark, "") << one.item << one.quantity;
}

// h = 80 mm: out within 0.3 s by a modified sine, back within 0.2 s by the 3-4-5 polynomial, whose
// acceleration 10/√3 h/T² and jerk 60 h/T³ at its ends are the largest.
TEST(Check, HoldsADrivenJointToItsLimits) {
  CheckSettings in_time;
  in_time.in_time = true;
  const CheckReport report =
      checked(shipped_model("law_driven_slider", {"limits.joints.guide.max_acceleration=\"11.5 m/s^2\"",
                                                  "limits.joints.guide.max_jerk=\"601 m/s^3\""}),
              in_time);
  const CheckFigure acceleration = figure(report, "joints.guide", "acceleration");
  EXPECT_NEAR(std::abs(acceleration.value.value()), 10 / std::sqrt(3.0) * 80 / 0.04, 1e-6);
  EXPECT_EQ(acceleration.verdict, Verdict::kExceeded);
  const CheckFigure jerk = figure(report, "joints.guide", "jerk");
  EXPECT_NEAR(std::abs(jerk.value.value()), 60 * 80 / 0.008, 1e-2);
  EXPECT_EQ(jerk.verdict, Verdict::kKept);
  EXPECT_FALSE(report.good);
  for (const Diagnostic& note : report.notes) EXPECT_FALSE(contains(note.message, "nothing"));
}

TEST(Check, InTimeNeedsNoTimeBetweenRows) {
  CheckSettings in_time;
  in_time.in_time = true;
  const CheckReport turn = checked(shipped_model("checked_cam"));
  const CheckReport same = checked(shipped_model("checked_cam", {"driver.duration=0.1"}), in_time);
  EXPECT_FALSE(same.figures.empty());
  EXPECT_NEAR(figure(same, "contacts.touch", "sliding_speed").value.value(),
              figure(turn, "contacts.touch", "sliding_speed").value.value(), 1e-9);
}

TEST(Check, OfADriverThatRunsEvenlySaysNothingUnlessLimited) {
  const std::vector<std::string> evenly = {"driver.acceleration=0"};
  for (const CheckFigure& one : checked(shipped_model("slider_crank", evenly)).figures) {
    EXPECT_NE(one.item, "joints.crank_pivot");
  }
  const CheckReport report = checked(shipped_model(
      "slider_crank", {"driver.acceleration=0", "limits.joints.crank_pivot.max_angular_acceleration=1"}));
  EXPECT_EQ(figure(report, "joints.crank_pivot", "acceleration").value, 0);
  EXPECT_EQ(figure(report, "joints.crank_pivot", "acceleration").verdict, Verdict::kKept);
}

// The pressure angle tends to 90 degrees at the limit position, wherever the samples beside it lie.
TEST(Check, DoesNotDecideALimitThatAFigureStillGrowsTowards) {
  const CheckReport report =
      checked(shipped_model("lock_up", {"limits.max_pressure_angle=85", "limits.min_convex_radius=1",
                                        "limits.max_sliding_speed=\"5 m/s\""}));
  const CheckFigure pressure = figure(report, "contacts.touch", "pressure_angle");
  EXPECT_LT(pressure.value, 85);
  EXPECT_EQ(pressure.verdict, Verdict::kUndecided);
  EXPECT_TRUE(contains(pressure.remark, "still grows"));
  EXPECT_TRUE(contains(figure(report, "contacts.touch", "pressure_angle_at_contact").remark, "still grows"));
  EXPECT_EQ(figure(report, "contacts.touch", "sliding_speed").verdict, Verdict::kUndecided);
  EXPECT_EQ(figure(report, "contacts.touch", "convex_radius", "cam.disc").verdict, Verdict::kKept);
  EXPECT_EQ(figure(checked(shipped_model("lock_up", {"limits.max_pressure_angle=70"})), "contacts.touch",
                   "pressure_angle")
                .verdict,
            Verdict::kExceeded);
  // Ending before it, the angle is known.
  const CheckReport before =
      checked(shipped_model("lock_up", {"driver.end=65", "limits.max_pressure_angle=85"}));
  EXPECT_EQ(figure(before, "contacts.touch", "pressure_angle").verdict, Verdict::kKept);
  EXPECT_TRUE(before.good);
}

// The right crank turns like the left one, through two change points where derivatives are mere rounding.
TEST(Check, OfAParallelogramFindsNoAcceleration) {
  const CheckReport report = checked(shipped_model("parallelogram"));
  EXPECT_NEAR(value(report, "joints.right_pivot", "acceleration"), 0, 1e-6);
  EXPECT_NEAR(value(report, "joints.right_pivot", "jerk"), 0, 0.1);
}

// A follower that slides along the normal has no pressure angle, and what rolls does not slide.
TEST(Check, SaysZeroOfWhatIsZeroButForRounding) {
  EXPECT_EQ(value(checked(shipped_model("four_arc_cam")), "contacts.touch", "pressure_angle"), 0);
  EXPECT_EQ(value(checked(shipped_model("rolling_ellipses")), "contacts.roll", "sliding_speed"), 0);
}

TEST(Check, FailsAsARunDoes) {
  const auto report = check(shipped_model("cam_with_return_spring", {"contacts.touch.rolling=true"}));
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ErrorKind::kMechanism);
  CheckSettings settings;
  settings.tolerance = -1;
  const Model model = model_of(four_quarters(kRoller, 2));
  EXPECT_TRUE(contains(to_string(check(model, settings).error()), "setting tolerance -1: must be > 0"));
  const auto limited = [&](const std::function<void(CheckLimits&)>& change) {
    CheckLimits limits;
    change(limits);
    CheckSettings with_limits;
    with_limits.limits = std::make_shared<const CheckLimits>(std::move(limits));
    const auto refused = check(model, with_limits);
    return refused ? "" : to_string(refused.error());
  };
  const GivenLimit none{kNoValue, {}, "limits.max_pressure_angle", {}};
  EXPECT_EQ(limited([](CheckLimits& limits) { limits.contacts.resize(1); }), "");
  EXPECT_TRUE(contains(limited([&](CheckLimits& limits) { limits.all[0] = none; }),
                       "CheckLimits::all: max_pressure_angle = nan: must be finite"));
  EXPECT_TRUE(contains(limited([](CheckLimits& limits) { limits.contacts.resize(9); }),
                       "CheckLimits::contacts: there are 9 for 1"));
}

TEST(Check, EndsWhereItIsStopped) {
  const std::atomic<bool> stop = true;
  CheckSettings settings;
  settings.stop = &stop;
  const auto report = check(model_of(four_quarters(kRoller, 2)), settings);
  EXPECT_TRUE(!report || (report->stopped && !report->good));
}

TEST(Check, OfTheValveTrainFindsOneSpeedForBothContacts) {
  const Model model = shipped_model("valve_train");
  const CheckReport report = checked(model);
  EXPECT_TRUE(report.good);
  const double factor = value(report, "mechanism", "speed_factor");
  const auto at = [&](double share) {
    return checked(model
                       .with({{"driver.velocity", fmt::format("{:.17g} rpm", 2000 * factor * share)},
                              {"limits", std::string("{}")}})
                       .value());
  };
  EXPECT_TRUE(at(1 - 1e-9).good);
  EXPECT_FALSE(at(1 + 1e-9).good);
  for (const char* contact : {"contacts.cam_finger", "contacts.finger_valve"}) {
    EXPECT_GT(value(report, contact, "least_contact_force"), 50) << contact;
  }
}

}  // namespace
}  // namespace higherpair

// Gear teeth as contacts: which pairs touch, and where the next ones engage and separate.
#include "higherpair/front/check.hpp"
#include "higherpair/front/contacts.hpp"
#include "higherpair/geometry/gear_pair.hpp"
#include "sliding_cam.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::events_of;
using ::testing::IsEmpty;
using testing::lines_are;
using testing::model_of;
using testing::motion_of;
using testing::part;
using testing::shipped_model;
using ::testing::SizeIs;

// A pair with the pinion at ground's origin, in millimetres. At 0 a tooth of the pinion and a space of the
// wheel are on the line of centres; the pinion drives counter-clockwise with the left flanks of its teeth.
struct Pair {
  InvoluteTooth pinion, wheel;
  double distance = 0;

  [[nodiscard]] GearPair gears() const { return {pinion, wheel, distance}; }
  [[nodiscard]] double pitch() const { return 360 / pinion.teeth; }

  // The driver's position at which the left flank of the tooth on x touches at the pitch point: there the
  // flank's point on the working pitch circle is on the line of centres.
  [[nodiscard]] double at_pitch_point() const {
    const double alpha = working_pressure_angle(gears());
    return -(half_angle_at_base(pinion) - involute_function(alpha)) / testing::kDegree;
  }
  // Driver position at which that pair of flanks engages.
  [[nodiscard]] double begins() const {
    return at_pitch_point() - path_of_contact(gears()).approach / base_radius(pinion) / testing::kDegree;
  }
  [[nodiscard]] double parts() const {
    return at_pitch_point() + path_of_contact(gears()).recess / base_radius(pinion) / testing::kDegree;
  }
};

std::string keys_of(const InvoluteTooth& tooth) {
  return fmt::format(
      "center = [0, 0], module = {}, teeth = {}, pressure_angle = {}, profile_shift = {}, backlash = {}",
      tooth.module, tooth.teeth, tooth.pressure_angle / testing::kDegree, tooth.profile_shift,
      tooth.backlash);
}

std::string whole_gear(const InvoluteTooth& tooth) {
  return fmt::format("curves.teeth = {{ type = \"gear\", {} }}\n", keys_of(tooth));
}

// The left flanks only, each as a curve with two ends.
std::string left_flanks(const InvoluteTooth& tooth) {
  std::string text;
  for (int i = 0; i < static_cast<int>(tooth.teeth); ++i) {
    text += fmt::format("curves.flank{} = {{ type = \"involute\", {}, tooth = {} }}\n", i, keys_of(tooth),
                        360.0 * i / tooth.teeth);
  }
  return text;
}

std::string profile_of(const Pair& pair, std::string (*curves)(const InvoluteTooth&), double start,
                       double end, const std::string& contact = "") {
  const double space = 180 / pair.wheel.teeth;  // from the middle of a tooth to that of the space beside it
  return fmt::format(R"([bodies.ground]
points.O1 = [0, 0]
points.O2 = [{}, 0]
[bodies.pinion]
points.O = [0, 0]
{}
[bodies.wheel]
pose = {{ x = {}, angle = {} }}
points.O = [0, 0]
{}
[joints]
pinion_pivot = {{ type = "revolute", between = ["ground.O1", "pinion.O"] }}
wheel_pivot  = {{ type = "revolute", between = ["ground.O2", "wheel.O"] }}
[contacts.mesh]
between = ["pinion", "wheel"]
approach = "+"
{}
[driver]
joint = "pinion_pivot"
start = {}
end = {}
samples = 61
)",
                     pair.distance, curves(pair.pinion), pair.distance,
                     180 + space - start * pair.pinion.teeth / pair.wheel.teeth, curves(pair.wheel), contact,
                     start, end);
}

std::vector<double> drivers_of(const std::vector<Event>& events) {
  std::vector<double> drivers;
  for (const Event& event : events) {
    drivers.push_back(event.driver);
  }
  return drivers;
}

// Checks that the ratio is that of the teeth in every row, and that pairs engage and separate one pitch after
// another, at the ends of the textbook's path of contact.
// \param within  tolerance of angles [deg]
void expect_pairs(const Motion& motion, const Pair& pair, double within) {
  ASSERT_TRUE(motion.good());
  const double ratio = -pair.pinion.teeth / pair.wheel.teeth;
  const ColumnValues driver = motion.column("driver");
  const ColumnValues angle = motion.column("wheel.angle");
  const ColumnValues omega = motion.column("wheel.omega");
  const ColumnValues sliding = motion.column("mesh.sliding");
  for (std::size_t i = 0; i < motion.size(); ++i) {
    EXPECT_NEAR(omega[i] / motion.column("driver.velocity")[i], ratio, 1e-12) << driver[i];
    EXPECT_NEAR(angle[i] - angle[0], ratio * (driver[i] - driver[0]), 1e-11) << driver[i];
    EXPECT_FALSE(std::isnan(sliding[i]));
  }
  const auto check = [&](const std::vector<double>& found, double first) {
    ASSERT_GE(found.size(), 3U);
    for (const double at : found) {
      const double pitches = (at - first) / pair.pitch();
      EXPECT_NEAR(pitches, std::round(pitches), within / pair.pitch()) << at;
    }
    for (std::size_t i = 1; i < found.size(); ++i) {
      EXPECT_NEAR(found[i] - found[i - 1], pair.pitch(), 2 * within);
    }
  };
  check(drivers_of(events_of(motion, EventType::kEngage)), pair.begins());
  check(drivers_of(events_of(motion, EventType::kRelease)), pair.parts());
}

TEST(GearContacts, TheNextPairBeginsBeforeTheOneBeforeItParts) {
  const Pair pair{{2, 20}, {2, 40}, 60};
  EXPECT_NEAR((pair.parts() - pair.begins()) / pair.pitch(), 1.635185964, 1e-9);
  const Motion flanks = motion_of(model_of(profile_of(pair, left_flanks, 0, 90)));
  expect_pairs(flanks, pair, 1e-10);
  const Pair loose{{2, 20, 20 * testing::kDegree, 0, 0.04}, {2, 40, 20 * testing::kDegree, 0, 0.03}, 60};
  const Motion gears = motion_of(model_of(profile_of(loose, whole_gear, 0, 60)));
  expect_pairs(gears, loose, 1e-10);
  for (const Event& event : gears.events()) {
    EXPECT_TRUE(event.type == EventType::kEngage || event.type == EventType::kRelease) << name_of(event.type);
    EXPECT_EQ(event.item, "mesh");
  }
  EXPECT_TRUE(contains(events_of(flanks, EventType::kEngage).at(0).cause, "now at 2"));
  EXPECT_TRUE(contains(events_of(flanks, EventType::kRelease).at(1).cause,
                       "goes on at another place where the two bodies touch, 1 left, without a jump"));
}

double contact_ratio_of(const std::string& profile) {
  const auto report = check(model_of(profile));
  for (const CheckFigure& figure : report.value().figures) {
    if (figure.quantity == "contact_ratio") {
      return figure.value.value();
    }
  }
  return 0;
}

// Without backlash the back flanks touch as well, but the pairs are those of the driving flanks.
TEST(GearContacts, WithoutPlayHaveThePairsAndTheContactRatioOfOneSide) {
  const double ratio = 1.6351859635714583;
  for (const double backlash : {0.0, 0.04}) {
    SCOPED_TRACE(backlash);
    const Pair pair{
        {2, 20, 20 * testing::kDegree, 0, backlash}, {2, 40, 20 * testing::kDegree, 0, backlash}, 60};
    const std::string profile = profile_of(pair, whole_gear, 0, 60);
    expect_pairs(motion_of(model_of(profile)), pair, 1e-10);
    EXPECT_NEAR(contact_ratio_of(profile), ratio, 1e-12);
  }
}

// Other teeth, with profile shift and thinning and at a larger than close distance: no symmetry in any
// number.
TEST(GearContacts, OfShiftedTeethWithPlayHaveThePathOfTheTextbookToo) {
  Pair pair{{3.1, 14, 20 * testing::kDegree, 0.4, 0.07}, {3.1, 23, 20 * testing::kDegree, -0.11, 0.02}};
  pair.distance = close_pair(pair.pinion, pair.wheel).distance + 0.13;
  expect_pairs(motion_of(model_of(profile_of(pair, left_flanks, 0, 130))), pair, 1e-9);
  expect_pairs(motion_of(model_of(profile_of(pair, whole_gear, 0, 90))), pair, 1e-9);
}

TEST(GearContacts, TouchAtThreePlacesAtOnceWhereTheContactRatioIsAboveTwo) {
  const Pair pair{{1.5, 71, 14.5 * testing::kDegree}, {1.5, 90, 14.5 * testing::kDegree}, 120.75};
  const double ratio = path_of_contact(pair.gears()).ratio;
  ASSERT_GT(ratio, 2.2);
  const Motion motion = motion_of(model_of(profile_of(pair, left_flanks, 0, 40)));
  expect_pairs(motion, pair, 1e-9);
  EXPECT_TRUE(contains(events_of(motion, EventType::kEngage).at(3).cause, "now at 3"));
}

TEST(GearContacts, HaveTheSameEventsWhateverTheRows) {
  const Pair pair{{2, 20}, {2, 40}, 60};
  const std::string text = profile_of(pair, left_flanks, 0, 90);
  const Motion fine = motion_of(model_of(text), 701);
  const Motion coarse = motion_of(model_of(text), 2);
  ASSERT_EQ(fine.events().size(), coarse.events().size());
  for (std::size_t i = 0; i < fine.events().size(); ++i) {
    EXPECT_EQ(fine.events()[i].type, coarse.events()[i].type);
    EXPECT_NEAR(fine.events()[i].driver, coarse.events()[i].driver, 1e-10);
    EXPECT_EQ(fine.events()[i].cause, coarse.events()[i].cause);
  }
}

// The backlash on the pitch circles as an angle of the wheel: the distance between the contacts of the two
// kinds of flanks.
TEST(GearContacts, LeaveTheirBacklashBehindTheFlanksThatWork) {
  for (const double apart : {0.0, 0.21}) {
    const Pair pair{
        {2, 20, 20 * testing::kDegree, 0, 0.05}, {2, 40, 20 * testing::kDegree, 0, 0.03}, 60 + apart};
    const auto branches = branches_of(model_of(profile_of(pair, whole_gear, 1.3, 20)));
    ASSERT_TRUE(branches);
    std::vector<double> free;
    for (const ContactEntry& entry : branches->contacts.at(0).entries) {
      if (entry.free && (free.empty() || entry.position - free.back() > 1e-9)) {
        free.push_back(entry.position);
      }
    }
    const double along = backlash(pair.gears());  // on the working pitch circles
    EXPECT_NEAR(along, apart == 0 ? 0.08 : 0.08 + 2 * apart * std::tan(20 * testing::kDegree),
                apart == 0 ? 1e-12 : 5e-3);
    const double play = along / (pair.distance * 40 / 60) / testing::kDegree;
    // Distances between neighbours alternate: one is the backlash, the next the rest of a pitch.
    ASSERT_GE(free.size(), 3U);
    const double first = free[1] - free[0];
    const double second = free[2] - free[1];
    EXPECT_NEAR(std::min(first, second), play, 1e-9);
    EXPECT_NEAR(first + second, 9, 1e-9);
  }
}

// Where the path of contact is shorter than a pitch, the tip of a tooth continues to push as an edge, more
// slowly than its flank would, until the next pair engages with a jump.
TEST(GearContacts, ThatAreTooFarApartGoOnOverTheirTips) {
  const Pair pair{{2, 20}, {2, 40}, 61.9};
  ASSERT_LT(path_of_contact(pair.gears()).ratio, 1);
  const Motion motion = motion_of(model_of(profile_of(pair, whole_gear, 0, 60)));
  EXPECT_TRUE(motion.good());
  EXPECT_FALSE(events_of(motion, EventType::kCorner).empty());
  const auto jumps = events_of(motion, EventType::kSecondContact);
  ASSERT_GE(jumps.size(), 3U);
  EXPECT_NEAR(jumps[2].driver - jumps[1].driver, 18, 1e-9);
  EXPECT_TRUE(events_of(motion, EventType::kEngage).empty());
}

std::string error_of(const Pair& pair) {
  const auto model = Model::from_text(profile_of(pair, whole_gear, 0, 1), "test.toml");
  return model ? "" : to_string(model.error());
}

TEST(GearContacts, NeedTeethThatARackLeavesWhole) {
  EXPECT_TRUE(
      contains(error_of({{2, 13}, {2, 40}, 53}),
               "curves.teeth: a rack cuts into the base circle of so few teeth (undercut, below 17.0973 "
               "teeth without profile shift): a `profile_shift` of 0.2397 at least"));
  EXPECT_EQ(error_of({{2, 13, 20 * testing::kDegree, 0.2397}, {2, 40}, 53.4}), "");
  EXPECT_TRUE(
      contains(error_of({{2, 9, 20 * testing::kDegree, 0.95}, {2, 40}, 50}), "the teeth are pointed"));
}

// 13 teeth against 40: by the reference the tip reaches 0.306157 modules past the base circle's tangent
// point.
TEST(GearContacts, HaveANoteWhereTipsInterfereWithRoots) {
  const auto flank = [](int teeth, const std::string& roll) {
    return fmt::format("curves.flank = {{ type = \"involute\", center = [0, 0], module = 2, teeth = {}{} }}",
                       teeth, roll);
  };
  const auto notes_of = [&](const std::string& pinion, const std::string& wheel) {
    const std::string text = fmt::format(R"([bodies.ground]
points.O1 = [0, 0]
points.O2 = [53, 0]
[bodies.pinion]
points.O = [0, 0]
{}
[bodies.wheel]
pose = {{ x = 53, angle = 185 }}
points.O = [0, 0]
{}
[joints]
pinion_pivot = {{ type = "revolute", between = ["ground.O1", "pinion.O"] }}
wheel_pivot  = {{ type = "revolute", between = ["ground.O2", "wheel.O"] }}
[contacts.mesh]
between = ["pinion.flank", "wheel.flank"]
[driver]
joint = "pinion_pivot"
start = 0
end = 5
)",
                                         pinion, wheel);
    std::vector<std::string> messages;
    const Model model = model_of(text);
    for (const Diagnostic& note : model.notes()) {
      messages.push_back(note.message);
    }
    return messages;
  };
  const std::string pinion = flank(13, ", roll = [1, 44]");
  EXPECT_TRUE(
      lines_are(notes_of(pinion, flank(40, "")),
                {"contacts.mesh: interference: the tips of wheel.flank come to where the roll of "
                 "pinion.flank is -2.8719 deg, 0.6123 mm past its base circle, but its involute begins at 1: "
                 "the contact would leave it at its root; let the `roll` of wheel.flank end at 27.306, or "
                 "give pinion.flank more teeth or `profile_shift`"}));
  EXPECT_NEAR(2 * path_of_contact({{1, 13}, {1, 40}, 26.5}).past_base[0], 0.6123, 5e-5);
  EXPECT_THAT(notes_of(pinion, flank(40, ", roll = [5, 27.306]")), IsEmpty());
  EXPECT_THAT(notes_of(pinion, flank(40, ", roll = [5, 27.307]")), SizeIs(1));
  // Not past the base circle, but below the beginning of the flank.
  EXPECT_TRUE(lines_are(notes_of(flank(13, ", roll = [4, 44]"), flank(40, ", roll = [5, 26.8]")),
                        {part("is 2.5584 deg, but its involute begins at 4")}));
}

TEST(GearContacts, HaveAShippedProfile) {
  const Pair pair{{2, 20, 20 * testing::kDegree, 0, 0.05}, {2, 40, 20 * testing::kDegree, 0, 0.05}, 60};
  expect_pairs(motion_of(shipped_model("gear_teeth")), pair, 1e-10);
}

// A gear of module 2 above a rack of trapezoidal teeth with its pitch line on y = 0; at the start a tooth of
// the gear and a space of the rack are at the same place, with play on both sides.
std::string rack_profile(double teeth, double addendum, double start, const std::string& approach) {
  constexpr double kModule = 2, kPlay = 0.05, kFoot = -2.5, kBottom = -6;
  const double pitch = kPi * kModule, radius = kModule * teeth / 2, slope = std::tan(20 * testing::kDegree);
  const double half = pitch / 4 - kPlay / 4;  // of a tooth on the pitch line
  std::vector<Vector2d> corners;
  for (int k = -8; k <= 8; ++k) {
    const double at = k * pitch;
    for (const Vector2d& p :
         {Vector2d(-half + kFoot * slope, kFoot), Vector2d(-half + addendum * slope, addendum),
          Vector2d(half - addendum * slope, addendum), Vector2d(half - kFoot * slope, kFoot)}) {
      corners.emplace_back(at + p.x(), p.y());
    }
  }
  corners.emplace_back(8.5 * pitch, kFoot);
  corners.emplace_back(8.5 * pitch, kBottom);
  corners.emplace_back(-8.5 * pitch, kBottom);
  corners.emplace_back(-8.5 * pitch, kFoot);
  std::string spans;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d &from = corners[i], &to = corners[(i + 1) % corners.size()];
    spans += fmt::format("  {{ type = \"segment\", from = [{}, {}], to = [{}, {}] }},\n", from.x(), from.y(),
                         to.x(), to.y());
  }
  const double angle = start * testing::kDegree;
  const double tooth = 360 / teeth;  // [deg]
  const double nearest = start - tooth * std::round(start / tooth);
  return fmt::format(R"([bodies.ground]
points.O = [0, {0}]
points.G = [0, 0]
[bodies.gear]
pose = {{ y = {0}, angle = {1} }}
points.O = [0, 0]
curves.teeth = {{ type = "gear", center = [0, 0], module = {2}, teeth = {3}, tooth = -90, backlash = {4} }}
[bodies.rack]
pose = {{ x = {5} }}
points.G = [0, 0]
[bodies.rack.curves.teeth]
type = "chain"
spans = [
{6}]
[joints]
pivot = {{ type = "revolute", between = ["ground.O", "gear.O"] }}
guide = {{ type = "prismatic", between = ["ground.G", "rack.G"], direction = [1, 0] }}
[contacts.mesh]
between = ["gear.teeth", "rack.teeth"]
approach = "{7}"
[driver]
joint = "pivot"
start = {1}
end = {8}
samples = 3
)",
                     radius, angle / testing::kDegree, kModule, teeth, kPlay,
                     radius * nearest * testing::kDegree + pitch / 2, spans, approach, start + 60);
}

// The textbook's contact ratio with a rack: from where the gear's tip circle meets the line of action to
// where the rack's tip line does.
TEST(GearContacts, WithARackHaveThePairsAndTheContactRatioOfTheTextbook) {
  const double alpha = 20 * testing::kDegree, pitch = kPi * 2;
  for (const double teeth : {20.0, 30.0}) {
    for (const double addendum : {1.9, 2.0}) {
      const double r = teeth, tip = r + 2, base = r * std::cos(alpha);
      const double path =
          std::sqrt(tip * tip - base * base) - r * std::sin(alpha) + addendum / std::sin(alpha);
      const double ratio = path / (pitch * std::cos(alpha));
      for (const char* approach : {"-", "+"}) {
        for (const double start : {-40.0, -27.0}) {
          SCOPED_TRACE(fmt::format("{} teeth, addendum {}, {} from {}", teeth, addendum, approach, start));
          const std::string profile = rack_profile(teeth, addendum, start, approach);
          const Motion motion = motion_of(model_of(profile));
          EXPECT_TRUE(motion.good());
          EXPECT_THAT(events_of(motion, EventType::kLimitPosition), IsEmpty());
          const auto engage = events_of(motion, EventType::kEngage),
                     release = events_of(motion, EventType::kRelease);
          ASSERT_GT(engage.size(), 1U);
          ASSERT_GT(release.size(), 1U);
          for (std::size_t i = 1; i < engage.size(); ++i) {
            EXPECT_NEAR(engage[i].driver - engage[i - 1].driver, 360 / teeth, 1e-9);
          }
          EXPECT_NEAR(contact_ratio_of(profile), ratio, 1e-10);
        }
      }
    }
  }
}

}  // namespace
}  // namespace higherpair

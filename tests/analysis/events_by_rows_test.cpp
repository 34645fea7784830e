// Events of bodies that touch at corners, at several places or along flat parts do not depend on which rows
// are asked for.
#include "analysis/run_testing.hpp"
#include "io/profile_testing.hpp"

#include <random>

#include <fmt/core.h>

namespace higherpair {
namespace {

using namespace higherpair::testing;

using Places = std::vector<std::pair<std::string, double>>;

constexpr double kTurn = 180 / kPi;

std::string polygon(const std::vector<Vector2d>& corners) {
  std::string spans;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d& from = corners[i];
    const Vector2d& to = corners[(i + 1) % corners.size()];
    spans += fmt::format(R"({{ type = "segment", from = [{}, {}], to = [{}, {}] }}, )", from.x(), from.y(),
                         to.x(), to.y());
  }
  return fmt::format(R"({{ type = "chain", spans = [{}] }})", spans);
}

// A cam with corners that turns about the origin, and a follower above it that slides along y.
std::string sliding(const std::vector<Vector2d>& cam, double offset, const std::string& follower) {
  return fmt::format(R"(
    [bodies.ground]
    points.O = [0, 0]
    points.G = [{0}, 0]
    [bodies.cam]
    points.O = [0, 0]
    curves.c = {1}
    [bodies.follower]
    pose = {{ x = {0}, y = 70 }}
    points.P = [0, 0]
    curves.r = {2}
    [joints.a]
    type = "revolute"
    between = ["ground.O", "cam.O"]
    [joints.b]
    type = "prismatic"
    between = ["ground.G", "follower.P"]
    direction = [0, 1]
    [contacts.k]
    between = ["cam.c", "follower.r"]
    approach = "-"
    [driver]
    joint = "a"
    end = 360
  )",
                     offset, polygon(cam), follower);
}

RunTable run_with(const Profile& profile, std::int64_t rows, std::vector<double> positions = {}) {
  RunSettings settings;
  if (positions.empty()) {
    settings.samples = rows;
  }
  settings.positions = std::move(positions);
  return {profile, settings};
}

// Types and positions [deg] of the events other than the ends of strokes.
Places events_of(const RunTable& motion) {
  Places events;
  for (const RunEvent& event : motion.events()) {
    if (event.type != EventType::kStrokeEnd) {
      events.emplace_back(name_of(event.type), kTurn * event.driver);
    }
  }
  return events;
}

std::size_t count_of(const RunTable& motion, EventType type) {
  return static_cast<std::size_t>(std::count_if(motion.events().begin(), motion.events().end(),
                                                [&](const RunEvent& event) { return event.type == type; }));
}

void expect_same(const Places& events, const Places& wanted, const std::string& what) {
  ASSERT_EQ(events.size(), wanted.size()) << what;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(events[i].first, wanted[i].first) << what;
    EXPECT_NEAR(events[i].second, wanted[i].second, 1e-8) << what;
  }
}

// In both senses and driven back.
void expect_same_for_all_rows(const std::string& text, const std::vector<EventType>& without,
                              const Settings& settings = {}) {
  for (Settings way :
       {Settings{}, Settings{"driver.end=-360"}, Settings{"driver.start=360", "driver.end=0"}}) {
    way.insert(way.end(), settings.begin(), settings.end());
    const Profile profile = profile_of(text, way);
    const Places wanted = events_of(run_with(profile, 37));
    for (const std::int64_t rows : {2, 3, 13, 181, 361, 1081}) {
      const RunTable motion = run_with(profile, rows);
      const std::string what = fmt::format("{} rows, {}", rows, way.empty() ? "" : way.front());
      expect_all_ok(motion);
      expect_same(events_of(motion), wanted, what);
      for (const EventType type : without) {
        EXPECT_EQ(count_of(motion, type), 0U) << what << ", " << name_of(type);
      }
    }
  }
}

// A row beyond the end of a flank by so little that the gap, which grows with the square of the way, is still
// within rounding.
TEST(EventsByRows, PairsOfTeethTouchAndPartWhereverRowsAre) {
  const Profile profile = shipped("gear_teeth");
  const Places wanted = events_of(run_with(profile, 2));
  ASSERT_EQ(wanted.size(), 10U);
  for (const std::int64_t rows : {37, 1081, 2001}) {
    const RunTable motion = run_with(profile, rows);
    expect_same(events_of(motion), wanted, fmt::format("{} rows", rows));
    for (std::size_t k = 0; k < motion.size(); ++k) {
      ASSERT_NEAR(motion.value(k, "wheel.omega"), -1800, 1e-9) << k;
      ASSERT_NEAR(motion.value(k, "wheel.alpha"), 0, 1e-6) << k;
    }
  }
}

TEST(EventsByRows, ARowMayBeNextToWhereAPairOfTeethTouchesOrParts) {
  const Profile profile = shipped("gear_teeth");
  const Places wanted = events_of(run_with(profile, 2));
  for (const double beside : {-1e-4, -1e-10, 0.0, 1e-10, 1e-4, 2e-3}) {
    std::vector<double> positions = {0};
    for (const auto& [type, driver] : wanted) {
      positions.push_back(driver + beside);
    }
    positions.push_back(90);
    expect_same(events_of(run_with(profile, 0, positions)), wanted, fmt::format("{}", beside));
    std::reverse(positions.begin(), positions.end());
    EXPECT_EQ(events_of(run_with(profile, 0, positions)).size(), wanted.size()) << beside;
  }
}

// Behind a sharp corner the knife edge is behind the face that it has left, but not within the body.
TEST(EventsByRows, AKnifeEdgeGoesOverSharpCornersWithoutAnOverlap) {
  expect_same_for_all_rows(sliding({{17.512, -3.449},
                                    {7.375, 25.184},
                                    {-6.827, 10.775},
                                    {-26.247, -2.487},
                                    {-8.37, -20.995},
                                    {5.976, -10.676}},
                                   -7, R"({ type = "point", at = [0, 0] })"),
                           {EventType::kOverlap, EventType::kRelease});
}

TEST(EventsByRows, SharpCornersGoOverCornersWithoutAnOverlap) {
  expect_same_for_all_rows(sliding({{22.711, -2.847},
                                    {13.621, 12.043},
                                    {-1.951, 15.069},
                                    {-15.816, 7.689},
                                    {-21.829, -17.333},
                                    {-8.367, -19.006},
                                    {9.57, -9.058}},
                                   0, polygon({{7.329, -0.525}, {-1.36, 6.44}, {-3.461, -10.894}})),
                           {EventType::kOverlap, EventType::kRelease});
}

// With the second contact the gap at the first one opens at once, not where it would pass an end.
TEST(EventsByRows, ARollerBridgesANotchWithoutARelease) {
  expect_same_for_all_rows(sliding({{20.548, -0.931},
                                    {11.056, 21.531},
                                    {-3.064, 22.587},
                                    {-13.237, 8.919},
                                    {-16.12, -11.637},
                                    {-5.082, -13.676},
                                    {18.204, -19.544}},
                                   0, R"({ type = "circle", center = [0, 0], radius = 6 })"),
                           {EventType::kOverlap, EventType::kRelease});
}

// The contact leaves the face by one end, goes on at the edge there and comes to the other end where the two
// flats lie on each other.
TEST(EventsByRows, AFaceTiltsOverTheCornersOfACam) {
  const std::string text =
      sliding({{15.488, -4.999}, {1.754, 12.677}, {-18.923, 10.332}, {-16.559, -15.222}, {9.288, -25.737}}, 4,
              R"({ type = "segment", from = [-12, 0], to = [9, 0] })");
  for (const char* between : {R"(["cam.c", "follower.r"])", R"(["follower.r", "cam.c"])"}) {
    expect_same_for_all_rows(text, {EventType::kOverlap, EventType::kRelease, EventType::kLimitPosition},
                             {fmt::format("contacts.k.between={}", between)});
  }
}

// The contact jumps from a corner of one body along a flat to a corner of the other: both sides change their
// spans in the same step.
TEST(EventsByRows, AFlatOfALeverComesToLieOnAFlatOfACam) {
  const std::string text = fmt::format(
      R"(
    [bodies.ground]
    points.O = [0, 0]
    points.G = [80, 0]
    [bodies.cam]
    points.O = [0, 0]
    curves.c = {}
    [bodies.lever]
    pose = {{ x = 80, y = 0, angle = -60 }}
    points.P = [0, 0]
    curves.r = {}
    [joints.a]
    type = "revolute"
    between = ["ground.O", "cam.O"]
    [joints.b]
    type = "revolute"
    between = ["ground.G", "lever.P"]
    [contacts.k]
    between = ["cam.c", "lever.r"]
    approach = "+"
    [driver]
    joint = "a"
    end = 360
  )",
      polygon({{22.682, 1.933},
               {7.196, 10.5},
               {-6.336, 15.31},
               {-14.198, -0.702},
               {-7.785, -9.142},
               {8.579, -14.276}}),
      polygon(
          {{-66.624, -0.985}, {-77.177, 5.609}, {-92.648, 5.317}, {-87.015, -6.105}, {-78.659, -13.565}}));
  expect_same_for_all_rows(text, {EventType::kOverlap, EventType::kRelease});
}

// Lines and arcs whose ends are rounded to some decimals, as drawings have them, meet in kinks of 1e-9 to
// 1e-5.
TEST(EventsByRows, AnOutlineOfRoundedNumbersIsFollowedOverItsJoints) {
  std::mt19937 random(5);
  for (const int decimals : {4, 6, 7, 9}) {
    for (int trial = 0; trial < 5; ++trial) {
      const auto between = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random);
      };
      const auto rounded = [&](double x) { return fmt::format("{:.{}f}", x, decimals); };
      const double base = between(15, 30), nose = between(4, base - 3);
      const double apart = std::max(between(12, 30), base - nose + 4), turned = between(0, 6);
      const double half = std::acos((base - nose) / apart);
      const auto place = [&](double radius, double angle, double along) {
        const Vector2d p = radius * unit_vector(turned + angle) + along * unit_vector(turned);
        return fmt::format("[{}, {}]", rounded(p.x()), rounded(p.y()));
      };
      const auto arc = [&](double radius, double along, double from, double to) {
        return fmt::format(R"({{ type = "arc", center = {}, radius = {}, from = {}, to = {} }}, )",
                           place(0, 0, along), rounded(radius), rounded(kTurn * (turned + from)),
                           rounded(kTurn * (turned + to)));
      };
      const auto segment = [](const std::string& from, const std::string& to) {
        return fmt::format(R"({{ type = "segment", from = {}, to = {} }}, )", from, to);
      };
      const std::string spans =
          arc(nose, apart, -half, half) + segment(place(nose, half, apart), place(base, half, 0)) +
          arc(base, 0, half, 2 * kPi - half) + segment(place(base, -half, 0), place(nose, -half, apart));
      std::string text =
          sliding({{1, 0}, {0, 1}, {-1, 0}}, 0, R"({ type = "circle", center = [0, 0], radius = 8 })");
      text = replaced(text, polygon({{1, 0}, {0, 1}, {-1, 0}}),
                      fmt::format(R"({{ type = "chain", tolerance = 0.01, spans = [{}] }})", spans));
      const Profile profile = profile_of(text);
      const std::size_t events = events_of(run_with(profile, 37)).size();
      for (const std::int64_t rows : {2, 73, 181, 361, 1000}) {
        const RunTable motion = run_with(profile, rows);
        expect_all_ok(motion);
        EXPECT_EQ(count_of(motion, EventType::kLimitPosition), 0U) << decimals << ' ' << trial << ' ' << rows;
        // With 4 there are notches, in which a second place touches for less than rounding tells.
        if (decimals > 4) {
          EXPECT_EQ(events_of(motion).size(), events) << decimals << ' ' << trial << ' ' << rows;
        }
      }
    }
  }
}

// Either of two arcs follows the other at both of its ends.
TEST(EventsByRows, ADiscOfTwoArcsIsFollowedOverBothJoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> turn(-180, 180), offset(3, 12), error(-5, 5);
  for (int trial = 0; trial < 12; ++trial) {
    const double from = turn(random), e = std::round(offset(random)), rounding = trial % 2 == 0 ? 1e-7 : 1e-6;
    const auto arc = [&](double begin) {
      return fmt::format(R"({{ type = "arc", center = [{}, 0], radius = 20, from = {}, to = {} }}, )", e,
                         begin + rounding * error(random), begin + 180 + rounding * error(random));
    };
    const std::string text = replaced(
        sliding({{1, 0}, {0, 1}, {-1, 0}}, 0, R"({ type = "circle", center = [0, 0], radius = 8 })"),
        polygon({{1, 0}, {0, 1}, {-1, 0}}),
        fmt::format(R"({{ type = "chain", tolerance = 0.01, spans = [{}{}] }})", arc(from), arc(from + 180)));
    const Profile profile = profile_of(text);
    for (const std::int64_t rows : {2, 37, 181, 361}) {
      const RunTable motion = run_with(profile, rows);
      expect_all_ok(motion);
      EXPECT_EQ(count_of(motion, EventType::kLimitPosition), 0U) << trial << ' ' << rows;
      for (std::size_t k = 0; k < motion.size(); ++k) {
        const double angle = 2 * kPi * static_cast<double>(k) / static_cast<double>(rows - 1);
        const double x = e * std::cos(angle);
        EXPECT_NEAR(motion.value(k, "follower.y"), e * std::sin(angle) + std::sqrt(28 * 28 - x * x), 1e-6)
            << trial << ' ' << k;
      }
    }
  }
}

// A smoothed table ripples beside its flanks, less and less down to the last digit.
TEST(EventsByRows, TheRippleOfATableHasNoStrokes) {
  const Profile profile = shipped("camshaft_lift_table");
  std::vector<double> first;
  for (const std::int64_t rows : {2, 7, 61, 361}) {
    const RunTable motion = run_with(profile, rows);
    std::vector<double> ends;
    for (const RunEvent& event : motion.events()) ends.push_back(kTurn * event.driver);
    if (first.empty()) first = ends;
    ASSERT_EQ(ends.size(), first.size()) << rows;
    for (std::size_t i = 0; i < ends.size(); ++i) EXPECT_NEAR(ends[i], first[i], 1e-8) << rows;
  }
  ASSERT_EQ(first.size(), 6U);
  EXPECT_NEAR(first[2], 180, 1e-9);
}

}  // namespace
Profile of_boundaries(const std::string& name) {
  auto profile = read_profile_file(HIGHERPAIR_TEST_DATA "/boundaries/" + name + ".toml");
  EXPECT_TRUE(profile) << name;
  return profile ? *profile : Profile{};
}

// Each was lost, reversed or jumped over at some of these numbers of rows.
TEST(BoundariesByRows, HaveTheSameEventsAndPositions) {
  for (const char* name :
       {"roller_from_flat_to_hollow", "faces_in_series", "corner_onto_arc", "triangle_on_hollow_spline",
        "flats_meet_at_a_fillet", "flats_meet_in_a_row", "arc_end_on_a_flat", "edge_on_a_corner"}) {
    SCOPED_TRACE(name);
    const Profile profile = of_boundaries(name);
    const RunTable finest = run_with(profile, 721);
    const Places wanted = events_of(finest);
    for (const std::int64_t rows : {2, 3, 7, 13, 16, 25, 37, 61, 121}) {
      const RunTable motion = run_with(profile, rows);
      const std::string what = fmt::format("{} rows", rows);
      expect_all_ok(motion);
      expect_same(events_of(motion), wanted, what);
      EXPECT_EQ(count_of(motion, EventType::kLimitPosition), 0U) << what;
      for (const RunEvent& event : motion.events()) {
        EXPECT_EQ(event.cause.find("nan"), std::string::npos) << what << ": " << event.cause;
      }
      if (720 % (rows - 1) != 0) continue;
      const auto step = static_cast<std::size_t>(720 / (rows - 1));
      for (const Body& body : profile.mechanism.bodies) {
        for (std::size_t k = 0; body.name != "ground" && k < motion.size(); ++k) {
          ASSERT_NEAR(motion.value(k, body.name + ".angle"), finest.value(k * step, body.name + ".angle"),
                      1e-9)
              << what << ' ' << k;
        }
      }
    }
  }
}

// The flat on which the roller's arm would come to its limit, at 0 mm, ends before it.
TEST(EventsByRows, ALimitBeyondTheEndOfAFlatIsNone) {
  const Profile profile = of_boundaries("roller_from_flat_to_hollow");
  for (const std::vector<double>& positions : {std::vector<double>{1, 0}, {1, 0, -2}, {1, 0.5, 0, -1, -2}}) {
    const RunTable motion = run_with(profile, 0, positions);
    expect_all_ok(motion);
    for (std::size_t k = 0; k < motion.size(); ++k) {
      if (motion.value(k, "driver") > 0.06) continue;
      // The roller's centre, on an arm of 30 about (2, 33), is 5 from the centre of the hollow of 8.
      const double angle = motion.value(k, "arm.angle") / kTurn;
      const Vector2d roller = Vector2d(2, 33) + 30 * Vector2d(std::sin(angle), -std::cos(angle));
      EXPECT_NEAR((roller - Vector2d(0, 8 + motion.value(k, "driver"))).norm(), 5, 1e-12);
    }
  }
}

// The corner of a cam slides along a flat onto an arc, at the root of |R(θ) c - O1| = |joint - O1|.
TEST(EventsByRows, ACornerReachesTheEndOfAFlatToFullPrecision) {
  const Profile profile = of_boundaries("corner_onto_arc");
  for (const std::int64_t rows : {7, 31, 601}) {
    EXPECT_NEAR(events_of(run_with(profile, rows)).at(0).second, 5.137266154426654, 1e-9) << rows;
  }
}

// The oval of `oval_in_ring` on a rocker that a parallelogram turns as the driver does: in a chain the motion
// goes over to second contacts as it does behind the driver itself.
TEST(EventsByRows, AChainGoesOverToSecondContacts) {
  const Profile chain = profile_of(R"(
[bodies.ground]
points.O1 = [0, 0]
points.O2 = [-10, -80]
points.O3 = [-200, -50]
[bodies.cam]
points.O = [0, 0]
points.B = [30, 40]
curves.oval = { type = "ellipse", center = [3, 1], semi_axes = [30, 12] }
[bodies.ring]
pose = { x = -10, y = -80, angle = 0 }
points.O = [0, 0]
curves.hole = { type = "circle", center = [10, 80], radius = 34, side = "outside" }
[bodies.crank]
pose = { x = -200, y = -50, angle = 0 }
points.O = [0, 0]
points.A = [30, 40]
[bodies.rod]
pose = { x = -170, y = -10, angle = 0 }
points.A = [0, 0]
points.B = [200, 50]
[joints]
cam_pivot   = { type = "revolute", between = ["ground.O1", "cam.O"] }
ring_pivot  = { type = "revolute", between = ["ground.O2", "ring.O"] }
crank_pivot = { type = "revolute", between = ["ground.O3", "crank.O"] }
a           = { type = "revolute", between = ["crank.A", "rod.A"] }
b           = { type = "revolute", between = ["rod.B", "cam.B"] }
[contacts.touch]
between = ["cam.oval", "ring.hole"]
[driver]
joint = "crank_pivot"
end = 360
velocity = "30 rpm"
)");
  const RunTable direct = run_with(shipped("oval_in_ring"), 61);
  Places wanted = events_of(direct);
  ASSERT_EQ(wanted.size(), 2U);
  for (const std::int64_t rows : {2, 7, 61, 361}) {
    const RunTable motion = run_with(chain, rows);
    expect_all_ok(motion);
    Places events = events_of(motion);
    std::erase_if(events, [](const auto& event) { return event.first == name_of(EventType::kDeadPoint); });
    expect_same(events, wanted, std::to_string(rows));
    for (std::size_t k = 0; rows == 61 && k < motion.size(); ++k) {
      EXPECT_NEAR(motion.value(k, "ring.angle"), direct.value(k, "ring.angle"), 1e-10) << k;
      EXPECT_NEAR(motion.value(k, "ring.alpha"), direct.value(k, "ring.alpha"), 1e-8) << k;
    }
  }
}

// Where the oval comes back into its ring another contact is nearer, so that the stretch is found only from
// the probes on at which its own is. Rows between are lost; it begins where it does.
TEST(EventsByRows, AStretchThatIsFoundLateBeginsWhereItDoes) {
  const Profile profile = profile_of(R"(
[units]
length="m"
[bodies.ground]
points.O=[0,0]
points.D=[2.9478,0]
points.R=[-1.0497,-0.5546]
[bodies.crank]
pose={x=0,y=0,angle=300.780}
points.O=[0,0]
points.A=[0.9692,0]
[bodies.rod]
pose={x=0.4960,y=-0.8327,angle=65.923}
points.A=[0,0]
points.B=[1.8679,0]
curves.oval={type="ellipse",center=[1.1334,0.1624],semi_axes=[0.8152,0.5994],rotation=98.0}
[bodies.rocker]
pose={x=2.9478,y=0,angle=152.687}
points.D=[0,0]
points.B=[1.9018,0]
[bodies.ring]
pose={x=-1.0497,y=-0.5546,angle=0}
points.O=[0,0]
curves.hole={ type="ellipse",center=[1.8624,0.8287],semi_axes=[0.8266,0.8183],rotation=70.8,side="outside" }
[joints]
o = { type = "revolute", between = ["ground.O","crank.O"] }
a = { type = "revolute", between = ["crank.A","rod.A"] }
b = { type = "revolute", between = ["rod.B","rocker.B"] }
d = { type = "revolute", between = ["ground.D","rocker.D"] }
q = { type = "revolute", between = ["ground.R","ring.O"] }
[contacts.touch]
between=["rod.oval","ring.hole"]
[driver]
joint="o"
start=300.780
end=660.780
velocity="30 rpm"
)");
  const Places wanted = events_of(run_with(profile, 61));
  ASSERT_FALSE(wanted.empty());
  EXPECT_NEAR(wanted.back().second, 652.457137199324, 1e-9);
  for (const std::int64_t rows : {7, 91, 181, 241, 361, 721}) {
    expect_same(events_of(run_with(profile, rows)), wanted, std::to_string(rows));
  }
}

// A crank's pin in a lever's slot is sqrt(50^2 + 20^2 + 2 50 20 sin u) from the lever's pivot, most at 90
// degrees: it passes the slot's end and comes back, between two rows or at some of them.
TEST(EventsByRows, AnEndThatIsPassedWithinAStepIsFound) {
  for (const double beyond : {1e-2, 1e-4, 1e-7}) {
    // An end counts as passed where it is exceeded by 1e-12 of the size.
    const double near = kTurn * 2e-10 / std::sqrt(4 * beyond * 1000 / 140);
    const Profile profile = profile_of(fmt::format(R"(
[bodies.ground]
points.A = [0, 0]
points.B = [0, 50]
[bodies.crank]
pose = {{ x = 0, y = 50, angle = 60 }}
points.B = [0, 0]
points.C = [20, 0]
[bodies.lever]
pose = {{ angle = 81 }}
points.A = [0, 0]
[joints]
crank = {{ type = "revolute", between = ["ground.B", "crank.B"] }}
lever = {{ type = "revolute", between = ["ground.A", "lever.A"] }}
slot = {{ type = "slot", between = ["lever.A", "crank.C"], direction = [1, 0], to = {:.10f} }}
[driver]
joint = "crank"
start = 0.5
end = 360.5
)",
                                                   70 - beyond));
    const double half = std::acos(((70 - beyond) * (70 - beyond) - 2900) / 2000) * kTurn;
    const Places wanted = {{"end", 90 - half}, {"end", 90 + half}};
    for (const std::int64_t rows : {2, 3, 7, 13, 61, 361, 721}) {
      const Places events = events_of(run_with(profile, rows));
      const std::string what = fmt::format("{} rows, {} mm", rows, beyond);
      ASSERT_EQ(events.size(), 2U) << what;
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(events[i].first, "end") << what;
        EXPECT_NEAR(events[i].second, wanted[i].second, near) << what;
      }
    }
  }
}

// A disc of radius 20 slides away over a pad of an arm, from its face onto the edge at its end, 60 from the
// arm's pivot. It slips off where its centre, 20 above the pivot, is in line with both: there the arm stays.
TEST(EventsByRows, AFollowerThatSlipsOffStaysWhereItDoes) {
  const Profile profile = profile_of(R"(
[bodies.ground]
points.O = [0, 0]
points.G = [-50, 20]
[bodies.block]
pose = { x = -50, y = 20 }
points.G = [0, 0]
curves.disc = { type = "circle", center = [0, 0], radius = 20 }
[bodies.arm]
points.O = [0, 0]
curves.pad = { type = "segment", from = [-40, 0], to = [-60, 0] }
[joints]
guide = { type = "prismatic", between = ["ground.G", "block.G"], direction = [-1, 0] }
arm = { type = "revolute", between = ["ground.O", "arm.O"] }
[contacts]
touch = { between = ["block.disc", "arm.pad"], keep = "gap" }
[driver]
joint = "guide"
start = 0
end = 60
)");
  const double far = std::sqrt(6000);
  for (const std::int64_t rows : {2, 5, 7, 31, 601}) {
    const RunTable motion = run_with(profile, rows);
    ASSERT_EQ(motion.events().size(), 2U) << rows;
    EXPECT_NEAR(motion.events()[1].driver, (far - 50) / 1000, 1e-14) << rows;
    EXPECT_NEAR(motion.value(motion.size() - 1, "arm.angle"), kTurn * std::atan2(20, -far) - 180, 1e-9)
        << rows;
  }
}

// An eccentric that lifts a valve by 10 mm about 20: at 25 it is on its stop, and pushed on; at 15 on its
// seat, which the eccentric goes on from.
TEST(EventsByRows, AFollowerAtTheEndOfItsGuidePartsOnlyIfItIsNotPushed) {
  const Profile profile = profile_of(R"(
[bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
curves.disc = { type = "circle", center = [10, 0], radius = 20 }
[bodies.valve]
pose = { x = 0, y = 20 }
points.P = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = [0, -1] }
[joints]
pivot = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.O", "valve.P"], direction = [0, 1], from = 15, to = 25 }
[contacts]
touch = { between = ["cam.disc", "valve.face"], keep = "gap" }
[driver]
joint = "pivot"
start = 0
end = 360
)");
  const Places wanted = {{"end", 30}, {"end", 150}, {"release", 210}, {"engage", 330}};
  for (const std::int64_t rows : {2, 5, 7, 61, 361}) {
    expect_same(events_of(run_with(profile, rows)), wanted, std::to_string(rows));
  }
}

// A disc on a crank moves an arm about Q, whose curve has edges at its ends.
struct DiscOnArm {
  Vector2d Q, center;  // of the disc, on the crank
  double radius;
  std::string curve, contact;
  double angle;   // of the arm in its pose [deg]
  double end;     // of the crank [deg]
  Vector2d edge;  // the one that is left last, on the arm
  double sense;   // the disc's centre is beyond the edge: 1, or between it and Q: -1
  std::vector<std::string> events;
};

// Where the disc's centre, the edge and Q are in line the arm slips off, and stays there; elsewhere on the
// edge it jams, and is not released. The edge would have limits beyond its end, on which the contact does not
// come.
TEST(EventsByRows, EdgesAreLeftWhereTheirBodiesPart) {
  const std::vector<DiscOnArm> all = {
      {{100, 0},
       {35, -20},
       30,
       R"({ type = "segment", from = [-35, 20], to = [-75, -20] })",
       "",
       60,
       360,
       {-75, -20},
       1,
       {"engage", "end", "end", "release"}},
      {{95, 0},
       {95, 25},
       15,
       R"({ type = "segment", from = [-20, 0], to = [-55, 5] })",
       R"(, approach = "-")",
       -50,
       -360,
       {-20, 0},
       -1,
       {"engage", "release"}},
      {{85, 0},
       {85, -25},
       20,
       R"({ type = "arc", center = [-35, 15], radius = 30, from = 0, to = 60 })",
       R"(, approach = "+")",
       -10,
       360,
       {-20, 15 + 15 * std::sqrt(3)},
       1,
       {"engage", "end", "end", "end", "end", "release"}}};
  for (const DiscOnArm& one : all) {
    const Profile profile = profile_of(fmt::format(R"(
[bodies.ground]
points.O = [0, 0]
points.Q = [{0}, 0]
[bodies.crank]
points.O = [0, 0]
curves.c = {{ type = "circle", center = [{1}, {2}], radius = {3} }}
[bodies.arm]
pose = {{ x = {0}, angle = {4} }}
points.O = [0, 0]
curves.c = {5}
[joints]
crank = {{ type = "revolute", between = ["ground.O", "crank.O"] }}
arm = {{ type = "revolute", between = ["ground.Q", "arm.O"] }}
[contacts]
k = {{ between = ["crank.c", "arm.c"], keep = "gap"{6} }}
[driver]
joint = "crank"
end = {7}
)",
                                                   one.Q.x(), one.center.x(), one.center.y(), one.radius,
                                                   one.angle, one.curve, one.contact, one.end));
    const Places wanted = events_of(run_with(profile, 601));
    ASSERT_EQ(wanted.size(), one.events.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(wanted[i].first, one.events[i]);
    }
    const double released = wanted.back().second / kTurn;
    const Vector2d centre = Rotation<double>::from_angle(released) * one.center;
    EXPECT_NEAR((centre - one.Q).norm(), std::abs(one.edge.norm() + one.sense * one.radius), 1e-11);
    const double arm = (angle_of(Vector2d(centre - one.Q)) - angle_of(one.edge)) * kTurn;
    for (const std::int64_t rows : {2, 3, 7, 13, 61, 361}) {
      const RunTable motion = run_with(profile, rows);
      expect_same(events_of(motion), wanted, std::to_string(rows));
      EXPECT_NEAR(std::remainder(motion.value(motion.size() - 1, "arm.angle") - arm, 360), 0, 1e-6) << rows;
    }
  }
}

// A block on a table, solved together with the slot and the tip on a ramp that hold it; at 0 mm it lies
// flat.
Profile rocking_block(double start, double end) {
  return profile_of(fmt::format(R"(
[bodies.ground]
points.G = [0, 0]
curves.table = {{ type = "segment", from = [80, 0], to = [-80, 0] }}
curves.ramp = {{ type = "line", point = [100, 10], normal = [1, 4] }}
[bodies.slide]
points.G = [0, 0]
points.S = [0, 0]
[bodies.b]
pose = {{ x = 0, y = 10, angle = 0 }}
points.P = [0, 0]
curves.block = {{ type = "chain", spans = [
  {{ type = "segment", from = [-30, -10], to = [20, -10] }},
  {{ type = "segment", from = [20, -10], to = [20, 30] }},
  {{ type = "segment", from = [20, 30], to = [-30, 30] }},
  {{ type = "segment", from = [-30, 30], to = [-30, -10] }}] }}
curves.tip = {{ type = "point", at = [100, 0] }}
[joints]
guide = {{ type = "prismatic", between = ["ground.G", "slide.G"], direction = [1, 0] }}
s = {{ type = "slot", between = ["slide.S", "b.P"], direction = [0, 1] }}
[contacts]
foot = {{ between = ["ground.table", "b.block"] }}
nose = {{ between = ["ground.ramp", "b.tip"] }}
[driver]
joint = "guide"
start = {}
end = {}
)",
                                start, end));
}

// The corner that touches, from the block's pose: the right one at positive positions, else the left one.
void expect_corner(const RunTable& motion, std::size_t row, double corner, const std::string& what) {
  const Complex turn = std::polar(1.0, motion.radians(row, "b.angle"));
  const Complex touched = motion.vector(row, "b.") + turn * Complex(corner, -10);
  EXPECT_NEAR(touched.imag(), 0, 1e-10) << what;
  EXPECT_NEAR(motion.value(row, "foot.x"), touched.real(), 1e-9) << what;
}

TEST(EventsByRows, ACoupledBlockGoesOnFromWhereItLiesFlat) {
  for (const double to : {40.0, -20.0}) {
    for (const std::int64_t rows : {2, 3, 7, 13, 61, 361}) {
      const RunTable motion = run_with(rocking_block(0, to), rows);
      const std::string what = fmt::format("to {}, {} rows", to, rows);
      expect_all_ok(motion);
      EXPECT_EQ(count_of(motion, EventType::kLimitPosition), 0U) << what;
      for (std::size_t k = 1; k < motion.size(); ++k) expect_corner(motion, k, to > 0 ? 20 : -30, what);
    }
  }
}

TEST(EventsByRows, ACoupledBlockComesToLieFlatAtTheEnd) {
  for (const double from : {20.0, -20.0}) {
    for (const std::int64_t rows : {2, 3, 7, 13, 61, 361}) {
      const RunTable motion = run_with(rocking_block(from, 0), rows);
      const std::string what = fmt::format("from {}, {} rows", from, rows);
      expect_all_ok(motion);
      EXPECT_TRUE(motion.events().empty()) << what;
      for (std::size_t k = 0; k < motion.size(); ++k) expect_corner(motion, k, from > 0 ? 20 : -30, what);
    }
  }
}

// Long steps came down beyond the range without this contact, which begins at the start.
TEST(EventsByRows, AFlatThatCannotBeLeftIsALimit) {
  const Profile profile = of_boundaries("flats_lie_at_a_limit");
  const RunTable finest = run_with(profile, 361);
  const Places wanted = events_of(finest);
  ASSERT_EQ(wanted.size(), 1U);
  EXPECT_EQ(wanted.front().first, name_of(EventType::kLimitPosition));
  for (const std::int64_t rows : {2, 3, 7, 13, 61}) {
    const RunTable motion = run_with(profile, rows);
    expect_same(events_of(motion), wanted, fmt::format("{} rows", rows));
    EXPECT_NEAR(motion.value(motion.size() - 1, "b5.angle"), finest.value(360, "b5.angle"), 1e-9) << rows;
  }
}

// The last event names the contact that makes the bodies lose their hold, and no other event is beside it.
void expect_to_end_with(const Profile& profile, EventType type, const std::string& contact,
                        const std::string& cause) {
  for (const std::int64_t rows : {2, 3, 7, 13, 61, 361}) {
    const RunTable motion = run_with(profile, rows);
    ASSERT_FALSE(motion.events().empty()) << rows;
    const RunEvent& last = motion.events().back();
    EXPECT_EQ(last.type, type) << rows << ": " << last.cause;
    ASSERT_TRUE(last.contact) << rows;
    EXPECT_EQ(profile.mechanism.contacts[*last.contact].name, contact) << rows;
    EXPECT_NE(last.cause.find(cause), std::string::npos) << rows << ": " << last.cause;
    for (const RunEvent& event : motion.events()) {
      EXPECT_TRUE(&event == &last || std::abs(event.driver - last.driver) > 1e-6)
          << rows << ": " << event.cause;
    }
  }
}

TEST(EventsByRows, ACoupledContactThatConformsIsOneLimit) {
  // A sole with an inflection on a floor; a tip on a ramp takes part.
  const Profile profile = profile_of(R"(
[bodies.ground]
points.G = [0, 0]
curves.floor = { type = "line", point = [0, 0], normal = [0, 1] }
curves.ramp = { type = "line", point = [100, 10], normal = [1, 2] }
[bodies.slide]
points.G = [0, 0]
points.S = [0, 0]
[bodies.b]
pose = { x = 0, y = 10, angle = 0 }
points.P = [0, 0]
curves.sole = { type = "spline", closed = false, material = "right", points = [
  [60, 1.4112], [50, 5.98472], [40, 9.09297], [30, 9.97495], [20, 8.41471], [10, 4.79426], [0, 0],
  [-10, -4.79426], [-20, -8.41471], [-30, -9.97495], [-40, -9.09297], [-50, -5.98472], [-60, -1.4112]] }
curves.tip = { type = "point", at = [100, 0] }
[joints]
guide = { type = "prismatic", between = ["ground.G", "slide.G"], direction = [1, 0] }
s = { type = "slot", between = ["slide.S", "b.P"], direction = [0, 1] }
[contacts]
nose = { between = ["ground.ramp", "b.tip"] }
foot = { between = ["ground.floor", "b.sole"] }
[driver]
joint = "guide"
end = 150
)");
  expect_to_end_with(profile, EventType::kLimitPosition, "foot", "the same curvature");
}

TEST(EventsByRows, ACoupledContactThatEndsIsNamed) {
  expect_to_end_with(of_boundaries("conforming_beside_an_edge"), EventType::kLimitPosition, "k1",
                     "the same curvature");
  expect_to_end_with(of_boundaries("hollow_curve_ends_on_a_flat"), EventType::kEnd, "k1", "the curve of b3");
}

// A side of the follower comes to lie on one of the cam's, which ends in a notch; before that the follower's
// own side ends.
TEST(EventsByRows, AFlatPartMayEndBeforeTheNotchOfTheOther) {
  const std::string cam = polygon({{-14.07, 22.68}, {-21.81, 3.32}, {-27.5, -2.31}, {22.71, 13.67}});
  const std::string follower = polygon({{6.7, 12.0}, {-9.0, -0.94}, {-1.32, -8.82}});
  const std::string text = fmt::format(R"(
    [bodies.ground]
    points.O = [0, 0]
    [bodies.cam]
    points.O = [0, 0]
    curves.c = {}
    [bodies.follower]
    pose.x = 70
    points.P = [0, 0]
    curves.f = {}
    [joints]
    pivot = {{ type = "revolute", between = ["ground.O", "cam.O"] }}
    guide = {{ type = "prismatic", between = ["ground.O", "follower.P"], direction = 0 }}
    [contacts.k]
    between = ["cam.c", "follower.f"]
    approach = "-"
    [driver]
    joint = "pivot"
    start = 174
    end = 175
  )",
                                       cam, follower);
  // Both sides have the same direction.
  const double at = kTurn * (std::atan2(12 + 0.94, 6.7 + 9) - std::atan2(5.63, 5.69)) + 180;
  for (const Settings& way : {Settings{}, Settings{"driver.start=175", "driver.end=174"}}) {
    for (const std::int64_t rows : {2, 11, 101}) {
      const RunTable motion = run_with(profile_of(text, way), rows);
      expect_all_ok(motion);
      expect_same(events_of(motion), {{"second_contact", at}}, fmt::format("{} rows", rows));
    }
  }
}

}  // namespace higherpair

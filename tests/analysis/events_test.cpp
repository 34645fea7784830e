#include "analysis/run_testing.hpp"
#include "equal_discs.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "io/profile_testing.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::shipped;

// Runs over a turn in the given number of equal steps and collects the events of one type.
std::vector<RunEvent> events_of(const Mechanism& mechanism, EventType type, int steps) {
  auto run = start_run(mechanism, {0}).value();
  std::vector<RunEvent> found;
  for (int k = 0; k <= steps; ++k) {
    move_to(run, {{2 * kPi * k / steps, 1, 0}});
    std::copy_if(run.events.begin(), run.events.end(), std::back_inserter(found),
                 [&](const RunEvent& event) { return event.type == type; });
  }
  return found;
}

TEST(StrokeEnds, OfAFlatFaceOnAnEccentricDiscAreAQuarterTurnFromTheCentre) {
  // s = r + e sin θ; the same for any spacing of the rows.
  for (const int steps : {3, 7, 361}) {
    const auto events = events_of(shipped("flat_faced_translating").mechanism, EventType::kStrokeEnd, steps);
    ASSERT_EQ(events.size(), 2U) << steps;
    EXPECT_NEAR(events[0].driver, kPi / 2, 1e-14);
    EXPECT_NEAR(events[1].driver, 3 * kPi / 2, 1e-14);
    EXPECT_EQ(shipped("flat_faced_translating").mechanism.joints[*events[0].joint].name, "slide");
  }
}

TEST(StrokeEnds, OfATappetInTwoGuidesAreThoseOfOne) {
  Mechanism tappet = shipped("flat_faced_translating").mechanism;
  Joint second = tappet.joints.back();
  ASSERT_EQ(second.type, JointType::kPrismatic);
  second.name = "upper";
  tappet.joints.push_back(second);
  const auto events = events_of(tappet, EventType::kStrokeEnd, 7);
  ASSERT_EQ(events.size(), 4U);  // of each guide
  for (const RunEvent& event : events) {
    EXPECT_NEAR(std::abs(event.driver - kPi), kPi / 2, 1e-14);
  }
}

// The rod's end runs in a slot of ground: the stroke ends where crank and rod are in line.
TEST(StrokeEnds, OfAPinInASlotOfGroundAreWhereCrankAndRodAreInLine) {
  Mechanism m;
  const int crank = add_body(m, "crank"), rod = add_body(m, "rod", Vector2d(0.03, 0));
  const PointRef O = add_point(m, kGround, "O", Vector2d::Zero());
  const int pivot = add_revolute(m, "pivot", O, add_point(m, crank, "O", Vector2d::Zero()));
  add_revolute(m, "pin", add_point(m, crank, "A", Vector2d(0.03, 0)),
               add_point(m, rod, "A", Vector2d::Zero()));
  const double offset = 0.011;
  const int slot = add_slot(m, "slot", add_point(m, kGround, "S", Vector2d(0, offset)),
                            add_point(m, rod, "B", Vector2d(0.09, 0)), Vector2d::UnitX());
  add_driver(m, pivot);
  for (const int steps : {3, 7, 361}) {
    const auto events = events_of(m, EventType::kStrokeEnd, steps);
    ASSERT_EQ(events.size(), 2U) << steps;
    EXPECT_NEAR(events[0].driver, std::asin(offset / 0.12), 1e-14);
    EXPECT_NEAR(*events[0].value, std::sqrt(0.12 * 0.12 - offset * offset), 1e-15);
    EXPECT_NEAR(events[1].driver, kPi + std::asin(offset / 0.06), 1e-14);
    EXPECT_NEAR(*events[1].value, std::sqrt(0.06 * 0.06 - offset * offset), 1e-15);
    EXPECT_EQ(events[0].joint, slot);
  }
}

// A crank's line passes 20 mm beside its pivot, and a block on it slides along a line 10 mm above the pivot:
// x = (10 cos θ - 20)/sin θ. The block goes to infinity at 180° and returns from there until cos θ = 1/2.
// Speeds near the pole must not count as the scale by which a speed near this stroke end is judged slow.
TEST(StrokeEnds, BehindAPoleAreWhereTheMotionReverses) {
  const Profile profile = testing::profile_of(R"([bodies]
ground = { points = { O = [0, 0], H = [0, 10] } }
guide = { points = { O = [0, 0], E = [0, 20] } }
block = { points.P = [0, 0] }
slide = { points.P = [0, 0] }
[joints]
pivot = { type = "revolute", between = ["ground.O", "guide.O"] }
along = { type = "prismatic", between = ["guide.E", "block.P"], direction = [1, 0] }
level = { type = "prismatic", between = ["ground.H", "slide.P"], direction = [1, 0] }
pin = { type = "revolute", between = ["block.P", "slide.P"] }
[driver]
joint = "pivot"
start = 70
end = 390
)");
  for (const std::int64_t rows : {7, 61, 601}) {
    const testing::RunTable motion = testing::analyze_at(profile, rows);
    std::vector<double> ends;
    std::vector<double> poles;
    for (const RunEvent& event : motion.events()) {
      (event.type == EventType::kStrokeEnd ? ends : poles).push_back(event.driver);
    }
    ASSERT_EQ(poles.size(), 2U) << rows;
    EXPECT_NEAR(poles[0], kPi, 1e-12);
    EXPECT_NEAR(poles[1], 2 * kPi, 1e-12);
    ASSERT_EQ(ends.size(), 1U) << rows;
    EXPECT_NEAR(ends[0], 5 * kPi / 3, 1e-9);
  }
}

// Three bodies with five joints, which cannot be split into dyads. Two of them run off to infinity where the
// slots j2 and j3 become parallel.
TEST(Poles, OfCoupledBodiesAreWhereTheirSlotsAreParallel) {
  const Profile profile = testing::profile_of(R"([units]
length = "m"
angle = "rad"
[bodies.ground]
points = { P0 = [0.174, -0.0573157], P1 = [-0.7, -0.30286873059426345], P2 = [-0.3, 0.8] }
[bodies.b1]
points = { P0 = [0.2, -0.0573], P1 = [0.7265, -0.24], P2 = [-0.4, 0] }
[bodies.b2]
points = { P0 = [0, 0], P1 = [0, 0], P2 = [0, 0] }
[bodies.b3]
points = { P0 = [0, 0.6], P1 = [0, 0], P2 = [-0.3, 0] }
[joints]
j0 = { type = "revolute", between = ["ground.P0", "b1.P0"] }
j1 = { type = "revolute", between = ["b3.P0", "b2.P0"] }
j2 = { type = "slot", between = ["b1.P1", "b2.P1"], direction = -2 }
j3 = { type = "slot", between = ["b2.P2", "ground.P1"], direction = 0 }
j4 = { type = "slot", between = ["b3.P1", "b1.P2"], direction = -0.4 }
j5 = { type = "slot", between = ["ground.P2", "b3.P2"], direction = 0 }
[driver]
joint = "j0"
start = 0
end = -2
)");
  for (const std::int64_t rows : {7, 13, 61, 601}) {
    const testing::RunTable motion = testing::analyze_at(profile, rows);
    const auto limit =
        std::find_if(motion.events().begin(), motion.events().end(),
                     [](const RunEvent& event) { return event.type == EventType::kLimitPosition; });
    ASSERT_NE(limit, motion.events().end()) << rows;
    EXPECT_NEAR(limit->driver, 2 - kPi, 1e-13) << rows;
  }
}

// Body b2 runs off along an asymptote of ground's hyperbola, in contact with the parabola of b1, whose axis
// turns with the driver: at the pole the two are parallel. Its distance grows with the square of what is
// left, so that it is far away long before the pole.
TEST(Poles, OfCoupledContactsAreWhereTheirCurvesOpenInParallel) {
  const Profile profile = testing::profile_of(R"([units]
length = "m"
angle = "rad"
[bodies.ground]
points.P = [-0.3825, 0.0676]
curves.C = { type = "hyperbola", center = [-0.4709, 0.1009], semi_axes = [0.4131, 0.3797], rotation = -5.6253 }
[bodies.b1]
pose = { x = -0.3676, y = 0.425, angle = 1.8087 }
points.P = [-0.3438, 0.0988]
curves.C = { type = "parabola", vertex = [-0.1718, 0.6286], focal_length = 0.7211, rotation = 0.1643 }
curves.D = { type = "ellipse", center = [-0.9855, 0.5034], semi_axes = [0.4969, 0.5023], rotation = 2.2872 }
[bodies.b2]
pose = { x = 0.5327, y = -0.6808, angle = 0.4617 }
curves.C = { type = "ellipse", center = [-0.3557, 0.7671], semi_axes = [0.4535, 0.2874], rotation = 0.1447 }
curves.D = { type = "parabola", vertex = [-0.649, 1.2742], focal_length = 0.2975, rotation = -0.7534 }
curves.E = { type = "hyperbola", center = [-0.7057, 0.5945], semi_axes = [0.3537, 0.4055], rotation = -1.0902 }
[joints]
pivot = { type = "revolute", between = ["b1.P", "ground.P"] }
[contacts]
k0 = { between = ["ground.C", "b2.C"] }
k1 = { between = ["b2.D", "b1.C"] }
k2 = { between = ["b2.E", "b1.D"] }
[driver]
joint = "pivot"
start = -1.8087
end = 0.28
)");
  const double asymptote = -5.6253 - std::atan2(0.3797, 0.4131) + 2 * kPi;
  const double pole = 0.1643 - asymptote;  // the driver turns ground relative to b1
  for (const std::int64_t rows : {7, 13, 61, 601, 2401}) {
    SCOPED_TRACE(rows);
    const testing::RunTable motion = testing::analyze_at(profile, rows);
    ASSERT_EQ(motion.failure(), "");
    std::vector<double> limits;
    for (const RunEvent& event : motion.events()) {
      if (event.type == EventType::kLimitPosition) limits.push_back(event.driver);
    }
    ASSERT_EQ(limits.size(), 1U);
    EXPECT_NEAR(limits[0], pole, 1e-9);
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double left = pole - motion.value(k, "driver");
      if (left > 1e-3 || left < 0) {
        EXPECT_EQ(motion.status(k), left > 0 ? RowStatus::kOk : RowStatus::kNotAssemblable) << k;
      }
    }
  }
}

// The pin enters a slot just over its end, from either side and wherever steps end.
TEST(Engagements, OfAGenevaWheelAreSeenWhateverTheRowsAndTheSenseOfTurning) {
  for (const int rows : {2, 4, 7, 37, 61, 361}) {
    for (const double start : {360.0, 300.0, 250.0, 241.0}) {
      SCOPED_TRACE(fmt::format("{} {}", rows, start));
      const testing::RunTable motion =
          testing::analyze(shipped("geneva_six_slots", {fmt::format("driver.start={}", start), "driver.end=0",
                                                        fmt::format("driver.samples={}", rows)}));
      ASSERT_EQ(motion.events().size(), 2U);
      EXPECT_EQ(motion.events()[0].type, EventType::kEngage);
      EXPECT_NEAR(motion.events()[0].driver, 4 * kPi / 3, 1e-9);
      EXPECT_EQ(motion.events()[1].type, EventType::kRelease);
      EXPECT_NEAR(motion.events()[1].driver, 2 * kPi / 3, 1e-9);
    }
  }
}

TEST(StrokeEnds, OfAnOutputAtRestAreNone) {
  // A disc that turns about its own centre moves nothing.
  for (const char* name : {"flat_faced_translating", "eccentric_disc_oscillating_roller", "knife_edge"}) {
    Profile profile = shipped(name);
    for (Body& body : profile.mechanism.bodies) {
      for (NamedCurve& named : body.curves) {
        if (body.name == "cam") {
          named.curve = make_circle({0, 0}, 0.03).value();
        }
      }
    }
    EXPECT_TRUE(events_of(profile.mechanism, EventType::kStrokeEnd, 361).empty()) << name;
  }
}

// The two positions at which both contacts hold at once, from the list of all contacts.
double smallest_distance_of_two_free_contacts(const Run& run, double u) {
  const auto& tracked = std::get<TrackedPair>(run.plan().groups[1].kind);
  const CurveContacts all = find_curve_contacts(tracked.pair, u);
  double smallest = INFINITY;
  for (std::size_t i = 0; i < all.contacts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool opposed = all.contacts[i].opposed && all.contacts[j].opposed;
      const bool apart = (all.contacts[i].p_W - all.contacts[j].p_W).norm() > 1e-3;
      if (opposed && apart) {
        smallest =
            std::min(smallest, std::abs(std::remainder(all.contacts[i].q - all.contacts[j].q, 2 * kPi)));
      }
    }
  }
  return smallest;
}

TEST(SecondContacts, BeginWhereTwoContactsHoldAtOnceWhateverTheSpacingOfRows) {
  const Profile profile = shipped("oval_in_ring");
  const auto run = start_run(profile.mechanism, {0}).value();
  std::vector<double> first;
  for (const int steps : {5, 36, 720}) {
    const auto events = events_of(profile.mechanism, EventType::kSecondContact, steps);
    ASSERT_EQ(events.size(), 2U) << steps;
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LE(smallest_distance_of_two_free_contacts(run, events[i].driver), 1e-12);
      first.resize(2, NAN);
      EXPECT_TRUE(std::isnan(first[i]) || std::abs(first[i] - events[i].driver) <= 1e-12);
      first[i] = events[i].driver;
    }
  }
}

// At 180 and 360 degrees a flat face touches joints of arcs.
TEST(CurvatureJumps, AreBehindARowAtTheJointWhateverTheRowsBefore) {
  const Mechanism mechanism = shipped("four_arc_cam").mechanism;
  for (const int sense : {1, -1}) {
    for (int rows = 1; rows <= 40; ++rows) {
      auto run = start_run(mechanism, {0}).value();
      for (const double turn : {0.5, 1.0}) {
        const double from = turn - 0.5;
        double last = NAN;  // place of a jump
        for (int k = 1; k <= rows; ++k) {
          move_to(run, {{sense * 2 * kPi * std::lerp(from, turn, static_cast<double>(k) / rows), 1, 0}});
          for (const RunEvent& event : run.events) {
            if (event.type == EventType::kCurvatureJump) last = event.driver;
          }
        }
        const double flank = sense > 0 ? 0.5 : 1.0;  // the joint that is reached on a flank
        EXPECT_NEAR(run.row.contacts[0].at.rho1, turn == flank ? 0.038 : 0.02, 1e-12) << rows << " " << turn;
        EXPECT_GT(std::abs(last - sense * 2 * kPi * turn), 0.1) << rows << " " << turn;
      }
    }
  }
}

// A step that leads just over a second contact is shortened by less than what is taken along at its end.
TEST(SecondContacts, AreFoundFromAnyRowBehind) {
  const Profile profile = shipped("oval_in_ring");
  const double at = events_of(profile.mechanism, EventType::kSecondContact, 360).at(0).driver;
  for (const double before : {0.5, 0.112, 1e-2, 1e-4}) {
    for (const double behind : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8}) {
      auto run = start_run(profile.mechanism, {0}).value();
      auto fine = run;
      for (const double u : {at - before, at + behind}) {
        move_to(run, {{u, 1, 0}});
        ASSERT_EQ(run.row.status, RowStatus::kOk) << before << " before, " << behind << " behind";
      }
      for (int k = 1; k <= 64; ++k) {
        move_to(fine, {{(at + behind) * k / 64, 1, 0}});
      }
      EXPECT_NEAR(run.row.bodies[2].theta, fine.row.bodies[2].theta, 1e-12)
          << before << " before, " << behind << " behind";
    }
  }
}

TEST(SecondContacts, KeepTheBodiesApart) {
  const Profile profile = shipped("oval_in_ring");
  auto run = start_run(profile.mechanism, {0}).value();
  const Contact& contact = profile.mechanism.contacts.front();
  for (int k = 0; k <= 720; ++k) {
    move_to(run, {{kPi * k / 360, 1, 0}});
    ASSERT_EQ(run.row.status, RowStatus::kOk) << k;
    const Separation here =
        separation(curve_of(profile.mechanism, contact.first), run.row.bodies[1].X_WB,
                   curve_of(profile.mechanism, contact.second), run.row.bodies[2].X_WB, 1e-12);
    EXPECT_GE(here.gap, -1e-10) << k;
  }
  EXPECT_FALSE(run.row.arcs_hold[0]);
}

TEST(SecondContacts, ThatMayNotBeTakenAreOverlaps) {
  Profile profile = shipped("oval_in_ring");
  profile.mechanism.contacts.front().jump = false;
  const auto overlaps = events_of(profile.mechanism, EventType::kOverlap, 360);
  const auto jumps = events_of(shipped("oval_in_ring").mechanism, EventType::kSecondContact, 360);
  ASSERT_EQ(overlaps.size(), 1U);
  EXPECT_NEAR(overlaps[0].driver, jumps[0].driver, 1e-12);
  auto run = start_run(profile.mechanism, {0}).value();
  // The branch ends at 118.11, exists again from 244.08 on, and is free of overlap from 260.6 on.
  const auto status_at = [&](double degrees) {
    move_to(run, {{degrees * kPi / 180, 1, 0}});
    return run.row.status;
  };
  EXPECT_EQ(status_at(105), RowStatus::kOverlap);
  EXPECT_EQ(status_at(119), RowStatus::kNotAssemblable);
  EXPECT_EQ(status_at(240), RowStatus::kNotAssemblable);
  EXPECT_EQ(status_at(265), RowStatus::kOk);
}

// A ring placed on an ellipse of ground so that it cuts the ellipse elsewhere.
TEST(Overlaps, ThatAreThereAtTheStartBeginInTheFirstRow) {
  const Profile profile = testing::profile_of(R"([units]
length = "m"
angle = "rad"
[bodies.ground]
points = { P0 = [0, -0.83] }
curves.C0 = { type = "ellipse", center = [0.06, -0.05], semi_axes = [0.6, 0.3], rotation = 2.4 }
[bodies.b1]
points = { P0 = [0, -0.83], P1 = [0.6, 0.06] }
[bodies.b2]
points = { P0 = [0.6, 0], P1 = [0.2, -0.3] }
[bodies.b3]
pose = { x = -0.0692425628845484, y = -0.0001908210026980793, angle = 0.25515127892918693 }
points = { P0 = [0.2, -0.3] }
curves.C0 = { type = "circle", center = [0.4, 0.2], radius = 0.7, side = "outside" }
[joints]
j0 = { type = "prismatic", between = ["b1.P0", "ground.P0"], direction = 0 }
j1 = { type = "revolute", between = ["b1.P1", "b2.P0"] }
j2 = { type = "revolute", between = ["b3.P0", "b2.P1"] }
[contacts]
k0 = { between = ["b3.C0", "ground.C0"], rolling = true }
[driver]
joint = "j0"
start = 0
end = 0.8
)");
  auto run = start_run(profile.mechanism, {0}).value();
  for (const double driver : {0.0, 1e-3}) {
    move_to(run, {{driver, 1, 0}});
    EXPECT_EQ(run.row.status, RowStatus::kOverlap) << driver;
    EXPECT_TRUE(run.events.empty()) << driver;
  }
}

// A parallelogram: crank 31, ground 70 [mm].
std::string parallelogram(const std::string& driver) {
  return R"(
[bodies.ground]
points.A = [0, 0]
points.D = [70, 0]
[bodies.crank]
points.A = [0, 0]
points.B = [31, 0]
[bodies.coupler]
pose = { x = 31 }
points.B = [0, 0]
points.C = [70, 0]
[bodies.rocker]
pose = { x = 70 }
points.D = [0, 0]
points.C = [31, 0]
[joints]
a = { type = "revolute", between = ["ground.A", "crank.A"] }
b = { type = "revolute", between = ["crank.B", "coupler.B"] }
c = { type = "revolute", between = ["coupler.C", "rocker.C"] }
d = { type = "revolute", between = ["ground.D", "rocker.D"] }
[driver]
joint = "a"
)" + driver;
}

TEST(DeadPoints, OfAParallelogramAreCrossedStraightOn) {
  const auto profile = read_profile_text(parallelogram("start = 10"), "parallelogram").value();
  auto run = start_run(profile.mechanism, {kPi / 18}).value();
  std::vector<double> found;
  for (const double degrees : {170.0, 180.0 - 1e-9, 180.0, 180.0 + 1e-6, 200.0, 359.0, 370.0}) {
    SCOPED_TRACE(degrees);
    move_to(run, {{degrees * kPi / 180, 1, 0}});
    for (const RunEvent& event : run.events) {
      if (event.type == EventType::kDeadPoint) {
        found.push_back(event.driver);
      }
    }
    const BodyMotion& rocker = run.row.bodies[3];
    EXPECT_NEAR(rocker.theta, degrees * kPi / 180, 1e-14);
    EXPECT_EQ(run.row.status, degrees == 180 ? RowStatus::kSingular : RowStatus::kOk);
    if (run.row.status == RowStatus::kOk) {
      // The cranks are always parallel; near the change point the rates are interpolated from both sides.
      EXPECT_NEAR(rocker.omega, 1, 1e-12);
      EXPECT_NEAR(rocker.alpha, 0, 1e-8);
    }
  }
  EXPECT_THAT(found, ::testing::ElementsAre(::testing::DoubleNear(kPi, 1e-10),
                                            ::testing::DoubleNear(2 * kPi, 1e-10)));
}

TEST(DeadPoints, OfEqualDiscsAreCrossedStraightOnWhateverTheRows) {
  const auto profile = read_profile_text(testing::kEqualDiscs, "discs").value();
  for (const double first : {0.0, 0.001, 3.3, 10.0, 45.0}) {
    for (const int rows : {1, 4, 8, 9, 12, 18, 36, 72, 360}) {
      SCOPED_TRACE(::testing::Message() << first << " and " << rows << " rows");
      auto run = start_run(profile.mechanism, {kPi / 2}).value();
      int crossings = 0;
      for (int k = 0; k <= rows; ++k) {
        const double u = kPi / 2 + (first + k * 360.0 / rows) * kPi / 180;
        move_to(run, {{u, 1, 0}});
        // Next to a crossing the angle is known only to the square root of rounding.
        EXPECT_NEAR(run.row.bodies[2].theta, u, 1e-9);
        for (const RunEvent& event : run.events) {
          EXPECT_EQ(event.type, EventType::kDeadPoint);
          EXPECT_NEAR(event.driver, (++crossings) * kPi, 1e-9);
        }
      }
      EXPECT_EQ(crossings, 2);
    }
  }
}

TEST(DeadPoints, CanBeStartedAtOnTheBranchOfTheSlowerMotion) {
  const auto profile = read_profile_text(parallelogram("start = 0"), "parallelogram").value();
  auto run = start_run(profile.mechanism, {0}).value();
  move_to(run, {{0, 1, 0}});
  EXPECT_EQ(run.row.status, RowStatus::kSingular);
  move_to(run, {{kPi / 3, 1, 0}});
  EXPECT_EQ(run.row.status, RowStatus::kOk);
  EXPECT_NEAR(run.row.bodies[3].theta, kPi / 3, 1e-13);
}

// Equal cranks at 0 and 100, drawn on the line of their pivots, and rods of 100 between points of them.
struct CranksAndRods {
  Mechanism mechanism;
  int crank = 0, other = 0;
  int pivot = 0, pin = 0;  // of the crank: on ground, to the first rod
};

CranksAndRods cranks_and_rods(const std::vector<double>& arms) {
  CranksAndRods made;
  Mechanism& m = made.mechanism;
  const Vector2d base(0.1, 0);
  made.crank = add_body(m, "a");
  made.other = add_body(m, "b", base);
  const auto pivot_of = [&](int body, const Vector2d& p_W) {
    return add_revolute(m, m.bodies[body].name + "o", add_point(m, kGround, m.bodies[body].name, p_W),
                        add_point(m, body, "O", Vector2d::Zero()));
  };
  made.pivot = pivot_of(made.crank, Vector2d::Zero());
  pivot_of(made.other, base);
  for (const double arm : arms) {
    const std::string name = fmt::format("rod{}", 1000 * arm);
    const Vector2d at(arm, 0);
    const int rod = add_body(m, name, at);
    const int pin = add_revolute(m, name + "a", add_point(m, made.crank, name, at),
                                 add_point(m, rod, "A", Vector2d::Zero()));
    made.pin = arm == arms.front() ? pin : made.pin;
    add_revolute(m, name + "b", add_point(m, rod, "B", base), add_point(m, made.other, name, at));
  }
  return made;
}

TEST(DeadPoints, OfCranksWithARodTooManyAreCrossedStraightOn) {
  for (const std::vector<double>& arms : {std::vector{0.03, 0.015}, std::vector{0.03, 0.021, -0.017}}) {
    CranksAndRods made = cranks_and_rods(arms);
    add_driver(made.mechanism, made.pivot);
    for (const int from : {0, 5}) {
      auto run = start_run(made.mechanism, {from * kPi / 9});
      ASSERT_TRUE(run) << run.error().reason;
      for (int k = from; k <= from + 18; ++k) {
        const double u = k * kPi / 9;
        move_to(*run, {{u, 1, 0}});
        const BodyMotion& other = run->row.bodies[made.other];
        EXPECT_NEAR(other.theta, u, 1e-13) << k;
        EXPECT_EQ(run->row.status, k % 9 == 0 ? RowStatus::kSingular : RowStatus::kOk) << k;
        EXPECT_NEAR(run->row.has_rates[made.other] ? other.omega : 1, 1, 1e-12) << k;
      }
    }
  }
}

TEST(DeadPoints, OfBodiesWithMoreConditionsThanCoordinatesLeaveRatesUndefined) {
  CranksAndRods made = cranks_and_rods({0.03, 0.015});
  add_driver(made.mechanism, made.pin);
  auto run = start_run(made.mechanism, {0});
  ASSERT_TRUE(run) << run.error().reason;
  move_to(*run, {{0, 1, 0}});
  EXPECT_EQ(run->row.status, RowStatus::kSingular);
  EXPECT_FALSE(run->row.has_rates[made.other]);
}

// A stroke that ends between the first row and the second, however close they are.
TEST(StrokeEnds, InTheFirstStepAreSaid) {
  const auto profile = shipped("toggle_press");
  const DriverSchedule schedule = DriverSchedule::analyze(profile).value();
  auto run = start_run(profile.mechanism, schedule.first_positions()).value();
  std::vector<double> ends;
  for (const std::int64_t k : {0, 1}) {
    move_to(run, {schedule.state(k).si});
    for (const RunEvent& event : run.events) {
      EXPECT_EQ(event.type, EventType::kStrokeEnd);
      ends.push_back(event.driver);
    }
  }
  ASSERT_FALSE(ends.empty());
  for (const double end : ends) EXPECT_NEAR(end, 0.273973480999 * kPi / 180, 1e-13);
}

// A ring turns about a pivot, with an ellipse in it that slides; lengths in mm, angles in degrees.
constexpr const char* kEllipseInRing = R"(
  [bodies.ground]
  points.D = [{0}, {1}]
  [bodies.body]
  points.D = [{0}, {1}]
  curves.c = {{ type = "ellipse", center = [0, 0], semi_axes = [{2}, {3}] }}
  [bodies.ring]
  points.D = [{0}, {1}]
  curves.c = {{ type = {4}, side = "outside" }}
  [joints.drive]
  type = "revolute"
  between = ["ground.D", "ring.D"]
  [joints.follow]
  type = "prismatic"
  between = ["ground.D", "body.D"]
  direction = {5}
  [contacts.touch]
  between = ["body.c", "ring.c"]
  [driver]
  joint = "drive"
  end = 360
)";

// Largest distances of the points of an ellipse at the origin, moved by `shift`, from `center`.
std::vector<double> farthest_points(double a, double b, const Vector2d& shift, const Vector2d& center) {
  constexpr int kCount = 100'000;
  const auto distance = [&](int i) {
    const double t = 2 * kPi * i / kCount;
    return (shift + Vector2d(a * std::cos(t), b * std::sin(t)) - center).norm();
  };
  std::vector<double> found;
  for (int i = 0; i < kCount; ++i) {
    if (distance(i) > distance(i - 1) && distance(i) >= distance(i + 1)) {
      found.push_back(distance(i));
    }
  }
  return found;
}

TEST(Overlaps, ThatBeginAndEndWithinAStepAreFound) {
  const double a = 41.0823150107552e-3, b = 30.540534291381633e-3, R = 43.061703226904015e-3;
  const Vector2d pivot(12.632389987521405e-3, -0.5908502260372338e-3);
  const double direction = 154.87317379314229;
  const Profile profile = testing::read(
      fmt::format(kEllipseInRing, 1e3 * pivot.x(), 1e3 * pivot.y(), 1e3 * a, 1e3 * b,
                  fmt::format(R"("circle", center = [0, 0], radius = {})", 1e3 * R), direction));
  for (const int steps : {1, 6, 13, 60, 360, 1440}) {
    const auto overlaps = events_of(profile.mechanism, EventType::kOverlap, steps);
    ASSERT_EQ(overlaps.size(), 2U) << steps;
    EXPECT_NEAR(overlaps[0].driver, 66.5089944419158 * kPi / 180, 1e-12) << steps;
    auto run = start_run(profile.mechanism, {0}).value();
    const auto two_farthest = [&](double driver) {
      move_to(run, {{driver, 1, 0}});
      const Vector2d center = pivot + Rotation<double>::from_angle(driver) * Vector2d(-pivot);
      return farthest_points(a, b, run.row.bodies[1].X_WB.p_WB, center);
    };
    for (const double distance : two_farthest(overlaps[0].driver)) {
      EXPECT_NEAR(distance, R, 1e-10) << steps;
    }
    const auto within = two_farthest(overlaps[0].driver + 1e-3);
    EXPECT_GT(*std::max_element(within.begin(), within.end()), R + 1e-8) << steps;
    EXPECT_EQ(run.row.status, RowStatus::kOverlap) << steps;
  }
}

// Curves drawn far from the origins of their bodies, as in a plan of a whole plant, are not larger for it.
// The second of these contacts begins 22 degrees beside the first.
TEST(SecondContacts, DoNotDependOnTheOriginsOfTheBodies) {
  std::vector<double> expected;
  for (const double shift : {0.0, 1e5, 1e6}) {
    const Profile profile = testing::read(fmt::format(
        R"(
          [bodies.ground]
          points.D = [{0}, 1.1571]
          points.F = [{1}, -99.0105]
          [bodies.body]
          points.D = [{0}, 1.1571]
          curves.c = {{ type = "ellipse", center = [{2}, 0], semi_axes = [28.3866, 23.622], rotation = -1.6 }}
          [bodies.ring]
          points.F = [{1}, -99.0105]
          curves.c = {{ type = "ellipse", center = [{2}, 0], semi_axes = [42.7373, 36.1453], side = "outside" }}
          [joints.drive]
          type = "revolute"
          between = ["ground.D", "body.D"]
          [joints.follow]
          type = "revolute"
          between = ["ground.F", "ring.F"]
          [contacts.touch]
          between = ["body.c", "ring.c"]
          [driver]
          joint = "drive"
          end = 360
        )",
        shift - 0.526, shift + 21.4313, shift));
    const auto seconds = events_of(profile.mechanism, EventType::kSecondContact, 6);
    ASSERT_EQ(seconds.size(), 2U) << shift;
    for (std::size_t i = 0; i < 2; ++i) {
      if (shift == 0) expected.push_back(seconds[i].driver);
      EXPECT_NEAR(seconds[i].driver, expected[i], 1e-9) << shift;
    }
  }
}

// Where the slide comes to be parallel to the axis of a parabola, the contact runs off to infinity. The
// rounding of its position there is no second contact.
TEST(SecondContacts, AreNoneWhereAContactRunsOffToInfinity) {
  const double direction = 162.38987107912487;
  const Profile profile = testing::read(fmt::format(
      kEllipseInRing, 0.17987, 0.0020657, 53.59155, 48.956923,
      R"("parabola", vertex = [1.0540776, -61.0100237], focal_length = 16.5477264, rotation = 90)",
      direction));
  for (const int steps : {1, 7, 60, 360}) {
    const auto seconds = events_of(profile.mechanism, EventType::kSecondContact, steps);
    ASSERT_EQ(seconds.size(), 1U) << steps;
    EXPECT_NEAR(seconds.front().driver, 258.0917 * kPi / 180, 1e-5) << steps;  // on the way back
    EXPECT_TRUE(events_of(profile.mechanism, EventType::kOverlap, steps).empty()) << steps;
    const auto limits = events_of(profile.mechanism, EventType::kLimitPosition, steps);
    ASSERT_FALSE(limits.empty());
    EXPECT_NEAR(limits.front().driver, (direction - 90) * kPi / 180, 1e-9) << steps;
  }
}

// Where a second contact appears, and with which rates, does not depend on the rows, even if a row falls on
// it.
TEST(SecondContacts, AreTheSameWhateverTheRows) {
  const auto profile = shipped("oval_in_ring");
  const double place = 99.39339667515179 * kPi / 180;
  std::string first_cause;
  for (const std::vector<double>& rows :
       {std::vector<double>{0, 2}, std::vector<double>{0, place, 2}, std::vector<double>{0, place + 1e-9, 2},
        std::vector<double>{0, 1, 1.5, 1.7, 1.8}}) {
    auto run = start_run(profile.mechanism, {0}).value();
    std::vector<RunEvent> seconds;
    for (const double u : rows) {
      move_to(run, {{u, 1, 0}});
      for (const RunEvent& event : run.events) {
        if (event.type == EventType::kSecondContact) seconds.push_back(event);
      }
    }
    ASSERT_EQ(seconds.size(), 1U);
    EXPECT_NEAR(seconds[0].driver, place, 2e-9);
    first_cause = first_cause.empty() ? seconds[0].cause : first_cause;
    EXPECT_EQ(seconds[0].cause, first_cause);
  }
}

TEST(LimitPositions, OfAFourBarAreWhereCouplerAndRockerAreInLine) {
  // Ground 80, crank 60, coupler 30, rocker 40: the limit is where the crank's end is 70 = 30 + 40 from the
  // rocker's pivot.
  auto profile = read_profile_text(parallelogram("start = 30"), "four-bar").value();
  Mechanism& mechanism = profile.mechanism;
  mechanism.bodies[0].points[1].p_B = {0.080, 0};
  mechanism.bodies[1].points[1].p_B = {0.060, 0};
  mechanism.bodies[2].points[1].p_B = {0.030, 0};
  mechanism.bodies[3].points[1].p_B = {0.040, 0};
  auto run = start_run(mechanism, {kPi / 6}).value();
  move_to(run, {{kPi / 2, 1, 0}});
  EXPECT_EQ(run.row.status, RowStatus::kNotAssemblable);
  ASSERT_EQ(run.events.size(), 1U);
  EXPECT_EQ(run.events[0].type, EventType::kLimitPosition);
  const double limit = std::acos((80.0 * 80 + 60 * 60 - 70 * 70) / (2.0 * 80 * 60));
  EXPECT_NEAR(run.events[0].driver, limit, 1e-14);
  // It comes back on the branch that it was on before the limit.
  move_to(run, {{kPi / 4, 1, 0}});
  EXPECT_EQ(run.row.status, RowStatus::kOk);
  const double back = run.row.bodies[3].theta;
  auto fresh = start_run(mechanism, {kPi / 6}).value();
  move_to(fresh, {{kPi / 4, 1, 0}});
  EXPECT_NEAR(fresh.row.bodies[3].theta, back, 1e-14);
}

}  // namespace
}  // namespace higherpair

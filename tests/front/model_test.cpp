// Models: from files, from text, built in C++, and with other dimensions.
#include "contact/support_curves.hpp"
#include "front/cam_profile.hpp"
#include "higherpair/higherpair.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::kCam;
using testing::model_of;
using testing::shipped_model;
using ::testing::SizeIs;
using testing::text_of;

TEST(Model, ThatCannotBeReadSaysWhatIsWrongAndWhere) {
  const auto missing = Model::open("no/such/file.toml");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kInput);
  EXPECT_TRUE(contains(to_string(missing.error()), "no/such/file.toml: cannot be opened"));
  const std::vector<std::string> overrides = {"bodies.cam.curves.disc.radius=-1", "joints.O.type=\"pin\""};
  const auto wrong = Model::from_text(kCam, "cam.toml", overrides);
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().diagnostics, SizeIs(::testing::Ge(2U)));
  EXPECT_TRUE(contains(to_string(wrong.error()), "override bodies.cam.curves.disc.radius=-1"));
}

TEST(Model, WithoutADriverCannotBeRun) {
  Mechanism mechanism = model_of(kCam).mechanism();
  mechanism.drivers.clear();
  const auto refused = Model::from(mechanism).value().run();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kMechanism);
}

// A four-bar of 10, 20, 35, 40 mm.
Mechanism four_bar() {
  Mechanism mechanism;
  mechanism.title = "four-bar";
  const PointRef A = add_point(mechanism, kGround, "A", {0, 0});
  const PointRef D = add_point(mechanism, kGround, "D", {0.040, 0});
  const int crank = add_body(mechanism, "crank");
  const int coupler = add_body(mechanism, "coupler", {0.010, 0}, 1.0);
  const int rocker = add_body(mechanism, "rocker", {0.040, 0}, 2.0);
  const int driven = add_revolute(mechanism, "a", A, add_point(mechanism, crank, "A", {0, 0}));
  add_revolute(mechanism, "b", add_point(mechanism, crank, "B", {0.010, 0}),
               add_point(mechanism, coupler, "B", {0, 0}));
  add_revolute(mechanism, "c", add_point(mechanism, coupler, "C", {0.035, 0}),
               add_point(mechanism, rocker, "C", {0.020, 0}));
  add_revolute(mechanism, "d", D, add_point(mechanism, rocker, "D", {0, 0}));
  add_driver(mechanism, driven);
  return mechanism;
}

TEST(Model, CanBeBuiltWithoutAFile) {
  const Model model = Model::from(four_bar()).value();
  const Motion motion = model.run().value();
  ASSERT_EQ(motion.size(), 361U);
  EXPECT_TRUE(motion.good());
  const auto bx = motion.column("crank.B.x");
  const auto by = motion.column("crank.B.y");
  const auto cx = motion.column("coupler.C.x");
  const auto cy = motion.column("coupler.C.y");
  for (std::size_t k = 0; k < motion.size(); ++k) {
    EXPECT_NEAR(std::hypot(cx[k] - bx[k], cy[k] - by[k]), 35, 1e-13);
    EXPECT_NEAR(std::hypot(cx[k] - 40, cy[k]), 20, 1e-13);
  }
  EXPECT_EQ(motion.column("driver.velocity")[0], 180 / kPi);
}

TEST(Model, ThatIsBuiltRunsAsTheOneThatIsRead) {
  const Model read = model_of(kCam);
  Mechanism cam;
  const PointRef O = add_point(cam, kGround, "O", {0, 0});
  const int disc = add_body(cam, "cam");
  const int follower = add_body(cam, "follower", {0, 0.030});
  const PointRef pivot = add_point(cam, disc, "O", {0, 0});
  const PointRef P = add_point(cam, follower, "P", {0, 0});
  const CurveRef edge = add_curve(cam, disc, "disc", make_circle({0.010, 0}, 0.030).value());
  const CurveRef face = add_curve(cam, follower, "face", make_line({0, 0}, {0, -1}).value());
  add_driver(cam, add_revolute(cam, "O", O, pivot));
  add_prismatic(cam, "guide", O, P, {0, 5});
  add_contact(cam, "touch", edge, face);
  const Motion one = read.run().value();
  const Motion other = Model::from(cam).value().run().value();
  EXPECT_EQ(text_of(one), text_of(other));
}

// A second coupler of another length.
TEST(Model, WithALinkTooManySaysSoWhereItCannotStart) {
  const Model model =
      shipped_model("four_bar", {"bodies.brace.points={P=[0,0],Q=[7.5,0]}",
                                 R"(joints.P={type="revolute",between=["crank.A","brace.P"]})",
                                 R"(joints.Q={type="revolute",between=["brace.Q","rocker.B"]})"});
  const auto motion = model.run();
  ASSERT_FALSE(motion);
  EXPECT_TRUE(contains(to_string(motion.error()),
                       "joints, contacts and drivers make 1 condition more than "
                       "the bodies can meet, unless the dimensions "
                       "are special: one of them may be too many"));
}

TEST(Model, HasSlots) {
  Mechanism yoke;
  const PointRef O = add_point(yoke, kGround, "O", {0, 0});
  const int crank = add_body(yoke, "crank");
  const int slide = add_body(yoke, "slide", {0.02, 0});
  add_driver(yoke, add_revolute(yoke, "O", O, add_point(yoke, crank, "O", {0, 0})));
  const PointRef pin = add_point(yoke, crank, "P", {0.02, 0});
  add_prismatic(yoke, "guide", O, add_point(yoke, slide, "S", {0, 0}), {1, 0});
  add_slot(yoke, "slot", add_point(yoke, slide, "T", {0, 0}), pin, {0, 1});
  const Motion motion = Model::from(yoke, kSiUnits).value().run().value();
  const auto x = motion.column("slide.x");
  const auto theta = motion.column("driver");
  for (std::size_t k = 0; k < motion.size(); ++k) {
    EXPECT_NEAR(x[k], 0.02 * std::cos(theta[k]), 1e-16);
  }
}

TEST(Model, ThatIsBuiltWrongNamesTheFault) {
  const auto refusal = [](const std::function<void(Mechanism&)>& change) {
    Mechanism mechanism = four_bar();
    change(mechanism);
    const auto refused = Model::from(mechanism);
    EXPECT_FALSE(refused);
    return refused ? "" : to_string(refused.error());
  };
  EXPECT_EQ(refusal([](Mechanism& m) { m.bodies.clear(); }),
            "four-bar: bodies: there are none: bodies[0] is ground");
  EXPECT_EQ(refusal([](Mechanism& m) { m.joints[1].first.body = 7; }),
            "four-bar: joints.b.first.body = 7: there are 4 bodies");
  EXPECT_EQ(refusal([](Mechanism& m) { m.joints[1].second.point = -1; }),
            "four-bar: joints.b.second.point = -1: there are 2 points on this body");
  EXPECT_EQ(refusal([](Mechanism& m) { m.joints[1].second = m.joints[1].first; }),
            "four-bar: joints.b: joins a body with itself");
  EXPECT_EQ(refusal([](Mechanism& m) { m.joints[0].name = ""; }), "four-bar: joints[0]: needs a name");
  EXPECT_EQ(refusal([](Mechanism& m) {
              m.joints[3].type = JointType::kPrismatic;
              m.joints[3].direction_A = {2, 0};
            }),
            "four-bar: joints.d.direction_A: must be a unit vector");
  const auto toothed = [&](double ratio, const GearTeeth& teeth) {
    return refusal([&](Mechanism& m) {
      m.joints[3].type = JointType::kGears;
      m.joints[3].turning_ratio = ratio;
      m.joints[3].teeth = teeth;
    });
  };
  EXPECT_EQ(toothed(1, {}), "four-bar: joints.d.teeth: only gears have teeth, and no inner gears of ratio 1");
  EXPECT_EQ(toothed(-2, {kPi / 2, 0}),
            "four-bar: joints.d.teeth.pressure_angle: must be between 0 and 90 degrees");
  EXPECT_EQ(toothed(-2, {0.3, -1}), "four-bar: joints.d.teeth.module: must be finite and not negative");
  EXPECT_EQ(refusal([](Mechanism& m) { m.drivers[0].joint = 9; }),
            "four-bar: drivers[0].joint = 9: there are 4 joints");
  EXPECT_EQ(refusal([](Mechanism& m) {
              m.drivers.push_back({"second", 0});
            }),
            "four-bar: drivers[0]: another driver drives joints.a already");
  EXPECT_EQ(refusal([](Mechanism& m) {
              m.drivers.push_back({"second", 3});
            }),
            "four-bar: drivers[0]: each of several drivers needs a name");
  EXPECT_EQ(
      refusal([](Mechanism& m) { m.bodies[2].points[0].p_B.x() = std::numeric_limits<double>::quiet_NaN(); }),
      "four-bar: bodies.coupler.points.B: must be finite, and at most 1e50 in SI units");
  EXPECT_EQ(refusal([](Mechanism& m) {
              m.bodies[1].mass = MassProperties{-1, Vector2d::Zero(), 0};
            }),
            "four-bar: bodies.crank.mass: mass and inertia must be >= 0");
  EXPECT_EQ(refusal([](Mechanism& m) {
              m.contacts.push_back({"k", {1, 0}, {2, 0}});
            }),
            "four-bar: contacts.k.first.curve = 0: there are 0 curves on this body");
  EXPECT_EQ(refusal([](Mechanism& m) {
              m.loads.push_back({"push", 5});
            }),
            "four-bar: loads.push.body = 5: there are 4 bodies");
  EXPECT_EQ(refusal([](Mechanism& m) {
              m.springs.push_back({"s", 4, {}, {}});
            }),
            "four-bar: springs.s.joint = 4: there are 4 joints");
  EXPECT_EQ(refusal([](Mechanism& m) {
              m.gravity_W = {INFINITY, 0};
            }),
            "four-bar: gravity: must be finite, and at most 1e50 in SI units");
  const std::string rule =
      ": a name begins with a letter from A to Z or a to z, or _, and goes on with these, digits and -";
  EXPECT_EQ(refusal([](Mechanism& m) { m.bodies[1].name = "my body,[x]\n"; }),
            "four-bar: bodies.my body,[x]<U+000A>" + rule);
  EXPECT_EQ(refusal([](Mechanism& m) { m.bodies[1].points[0].name = "A.x"; }),
            "four-bar: bodies.crank.points.A.x" + rule);
  EXPECT_EQ(refusal([](Mechanism& m) { m.joints[2].name = "2"; }), "four-bar: joints.2" + rule);
  EXPECT_EQ(refusal([](Mechanism& m) { m.drivers[0].name = "a b"; }), "four-bar: drivers.a b" + rule);
  const auto programs = Model::from(four_bar(), {}, std::vector<DriverProgram>(2));
  ASSERT_FALSE(programs);
  EXPECT_TRUE(contains(to_string(programs.error()), "2 programs for 1 drivers"));
  const auto units = Model::from(four_bar(), {.angle = Unit::kMetre});
  ASSERT_FALSE(units);
  EXPECT_EQ(to_string(units.error()),
            "four-bar: Units::angle = m: is the unit of a length, expected that of an angle");
  EXPECT_EQ(to_string(Model::from(four_bar(), {.angle = static_cast<Unit>(99)}).error()),
            "four-bar: Units::angle = 99: is no unit");
  EXPECT_EQ(refusal([](Mechanism& m) { m.joints[2].type = static_cast<JointType>(7); }),
            "four-bar: joints." + four_bar().joints[2].name + ".type: is no type of joint");
}

// Two wheels of radii 10 and 30 mm on pins in ground.
Mechanism gear_pair() {
  Mechanism m;
  m.title = "pair";
  const int one = add_body(m, "one"), two = add_body(m, "two", {0.040, 0});
  const PointRef A = add_point(m, one, "A", {0, 0}), B = add_point(m, two, "B", {0, 0});
  add_driver(m, add_revolute(m, "a", add_point(m, kGround, "A", {0, 0}), A));
  add_revolute(m, "b", add_point(m, kGround, "B", {0.040, 0}), B);
  Joint mesh;
  mesh.name = "mesh";
  mesh.type = JointType::kGears;
  mesh.first = A;
  mesh.second = B;
  mesh.turning_ratio = -1.0 / 3;
  m.joints.push_back(mesh);
  return m;
}

TEST(Model, OfGearsThatNothingCarriesNamesTheCarrier) {
  const auto refusal = [](const std::function<void(Mechanism&)>& change) {
    Mechanism m = gear_pair();
    change(m);
    const auto refused = Model::from(m);
    return refused ? "" : to_string(refused.error());
  };
  const std::string rule =
      "pair: joints.mesh.carrier: expected a body that carries both wheels on pins at these points";
  EXPECT_EQ(refusal([](Mechanism&) {}), "");
  EXPECT_EQ(refusal([](Mechanism& m) { m.joints[2].carrier = 1; }), rule);
  EXPECT_EQ(refusal([](Mechanism& m) { m.joints[2].second = add_point(m, 2, "off", {0.010, 0}); }), rule);
  for (const double ratio : {0.0, 1e10, -1e-10, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(refusal([&](Mechanism& m) { m.joints[2].turning_ratio = ratio; }),
              "pair: joints.mesh.turning_ratio: must be between 1e-9 and 1e9, with either sign");
  }
}

TEST(Model, ThatIsBuiltIsHeldToTheRulesOfProfiles) {
  const auto refusal = [](const std::function<void(Mechanism&)>& change) {
    Mechanism m = four_bar();
    change(m);
    const auto refused = Model::from(m);
    return refused ? "" : to_string(refused.error());
  };
  const auto spring = [&](const Spring& added) {
    return refusal([&](Mechanism& m) { m.springs.push_back(added); });
  };
  EXPECT_EQ(spring({"s", 3, {}, {}, 1, 0, 1}), "");
  EXPECT_EQ(spring({"s", 3, {}, {}, -1, 0, 1}), "four-bar: springs.s: stiffness and damping must be >= 0");
  EXPECT_EQ(spring({"s", 3, {}, {}, 1, 0, -1}), "four-bar: springs.s: stiffness and damping must be >= 0");
  EXPECT_EQ(spring({"", 3, {}, {}, 1, 0, 0}), "four-bar: springs[0]: needs a name");
  EXPECT_EQ(spring({"s", {}, {0, 0}, {1, 0}, 1, -1, 0}), "four-bar: springs.s.free: a length must be >= 0");
  EXPECT_EQ(refusal([](Mechanism& m) { m.loads = {{"", 1}}; }), "four-bar: loads[0]: needs a name");
  EXPECT_EQ(refusal([](Mechanism& m) {
              m.loads = {{"push", 1}, {"push", 2}};
            }),
            "four-bar: loads.push: another one has the same name");
  EXPECT_EQ(refusal([](Mechanism& m) { m.bodies[2].name = "crank"; }),
            "four-bar: bodies.crank: another one has the same name");
  EXPECT_EQ(refusal([](Mechanism& m) { m.joints[2].name = "a"; }),
            "four-bar: joints.a: another one has the same name");
  EXPECT_EQ(refusal([](Mechanism& m) { m.bodies[1].points[1].name = "A"; }),
            "four-bar: bodies.crank.points.A: another one has the same name");
  EXPECT_EQ(refusal([](Mechanism& m) { m.joints[1].relative_angle = 1e40; }),
            "four-bar: joints.b.relative_angle: must be at most 1e9 turns");
  EXPECT_EQ(refusal([](Mechanism& m) { m.bodies[0].mass.emplace(); }),
            "four-bar: bodies.ground: ground never moves: it has no pose and no mass");
  EXPECT_EQ(refusal([](Mechanism& m) { m.bodies[0].guess_theta = 1; }),
            "four-bar: bodies.ground: ground never moves: it has no pose and no mass");
  const auto curve = [&](const std::string& name, double radius) {
    return refusal([&](Mechanism& m) { add_curve(m, 1, name, make_circle({0, 0}, radius).value()); });
  };
  EXPECT_EQ(curve("", 1), "four-bar: bodies.crank.curves[0]: needs a name");
  EXPECT_TRUE(contains(curve("a b", 1), "four-bar: bodies.crank.curves.a b: a name begins"));
  EXPECT_TRUE(contains(curve("disc", 1e51), "bodies.crank.curves.disc: must be finite, and at most 1e50"));
  Mechanism geared = gear_pair();
  geared.springs.push_back({"s", 2, {}, {}, 1, 0, 0});
  EXPECT_EQ(to_string(Model::from(geared).error()), "pair: springs.s.joint: gears and belts have no spring");
}

// An ellipse of 30 and 20 mm whose values a test spoils.
class SpoiltEllipse final : public Span {
public:
  explicit SpoiltEllipse(std::function<void(double, SpanPoint&)> spoil) : spoil_(std::move(spoil)) {}
  [[nodiscard]] Bounds range() const override { return {0, 2 * kPi}; }
  [[nodiscard]] SpanPoint at(double t) const override {
    constexpr double a = 0.03, b = 0.02;
    const double s = std::sin(t), c = std::cos(t);
    const double speed = std::hypot(a * s, b * c);
    SpanPoint point{{a * c, b * s}, {b * c / speed, a * s / speed}, a * b / std::pow(speed, 3), 0, speed};
    point.slope = -3 * a * b * (a * a - b * b) * s * c / std::pow(speed, 6);
    spoil_(t, point);
    return point;
  }

private:
  std::function<void(double, SpanPoint&)> spoil_;
};

TEST(Model, WithASpanWhoseValuesDoNotBelongTogetherIsRefused) {
  const auto refusal = [](const std::function<void(double, SpanPoint&)>& spoil) {
    Mechanism cam = model_of(kCam).mechanism();
    cam.title = "cam";
    auto boundary = Boundary::make({std::make_shared<SpoiltEllipse>(spoil)}, true, 1e-6);
    cam.contacts[0].first = add_curve(cam, 1, "oval", std::move(boundary).value());
    const auto refused = Model::from(cam);
    return refused ? "" : to_string(refused.error());
  };
  const std::string at = "cam: bodies.cam.curves.oval, span 0: its ";
  const std::string path = "points must move at its speed along its normal turned +90 degrees";
  EXPECT_EQ(refusal([](double, SpanPoint&) {}), "");
  EXPECT_EQ(refusal([](double, SpanPoint& p) { p.kappa *= 1.5; }),
            at + "curvature is not that with which its normal turns");
  EXPECT_EQ(refusal([](double t, SpanPoint& p) {
              if (t > 3.1) p.kappa = std::numeric_limits<double>::quiet_NaN();
            }),
            at + "values must be finite");
  EXPECT_EQ(refusal([](double, SpanPoint& p) { p.n_B *= 2; }), at + "normal must be a unit vector");
  EXPECT_EQ(refusal([](double, SpanPoint& p) { p.n_B = -p.n_B; }), at + path);
  EXPECT_EQ(refusal([](double, SpanPoint& p) { p.speed *= 2; }), at + path);
}

TEST(Model, OfCurvesThatCannotTouchSaysWhy) {
  Mechanism cam = model_of(kCam).mechanism();
  cam.title = "cam";
  cam.bodies[1].curves[0].curve = make_circle({0.01, 0}, 0.03, Side::kOutside).value();
  EXPECT_EQ(to_string(Model::from(cam).error()),
            "cam: contacts.touch: a line cannot touch a concave curve (side = \"outside\")");
  Mechanism rolling = model_of(kCam).mechanism();
  rolling.title = "cam";
  rolling.contacts[0].rolling = true;
  rolling.contacts[0].keep = Keep::kGap;
  EXPECT_EQ(to_string(Model::from(rolling).error()),
            "cam: contacts.touch.rolling: curves with ends, of several parts, or that may part slip");
}

TEST(Model, ThatIsBuiltWithANumberBeyondItsRangeNamesIt) {
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  static constexpr double kInf = std::numeric_limits<double>::infinity();
  const std::string beyond = ": must be finite, and at most 1e50 in SI units";
  const auto refusal = [](const std::function<void(Mechanism&)>& change) {
    Mechanism cam = model_of(kCam).mechanism();
    cam.title = "cam";
    change(cam);
    const auto refused = Model::from(cam);
    return refused ? "" : to_string(refused.error());
  };
  const auto of_curve = [&](const std::function<void(Curve&)>& change) {
    return refusal([&](Mechanism& m) { change(m.bodies[1].curves[0].curve); });
  };
  EXPECT_EQ(refusal([](Mechanism&) {}), "");
  for (const double bad : {kInf, kNan, 1e51}) {
    EXPECT_EQ(refusal([&](Mechanism& m) {
                m.bodies[1].mass = MassProperties{bad, {0, 0}, 1};
              }),
              "cam: bodies.cam.mass" + beyond);
    EXPECT_EQ(refusal([&](Mechanism& m) {
                m.bodies[1].mass = MassProperties{1, {0, 0}, bad};
              }),
              "cam: bodies.cam.mass" + beyond);
    EXPECT_EQ(refusal([&](Mechanism& m) { m.joints[1].from = bad; }), "cam: joints.guide.from" + beyond);
    EXPECT_EQ(refusal([&](Mechanism& m) { m.joints[1].to = bad; }), "cam: joints.guide.to" + beyond);
    EXPECT_EQ(refusal([&](Mechanism& m) { m.bodies[1].points[0].p_B.y() = bad; }),
              "cam: bodies.cam.points.O" + beyond);
  }
  EXPECT_EQ(of_curve([](Curve& c) { c.vertex_B.x() = kNan; }), "cam: bodies.cam.curves.disc" + beyond);
  EXPECT_EQ(of_curve([](Curve& c) { c.kind = static_cast<CurveKind>(42); }),
            "cam: bodies.cam.curves.disc.kind: is no kind of curve");
  EXPECT_EQ(of_curve([](Curve& c) { c.semi_latus = kInf; }), "cam: bodies.cam.curves.disc" + beyond);
  EXPECT_EQ(of_curve([](Curve& c) { c.semi_latus = -0.03; }),
            "cam: bodies.cam.curves.disc.semi_latus: must be > 0");
  EXPECT_EQ(of_curve([](Curve& c) {
              c.axis_B = {2, 0};
            }),
            "cam: bodies.cam.curves.disc.axis_B: must be a unit vector");
  EXPECT_EQ(of_curve([](Curve& c) { c.kind = CurveKind::kChain; }),
            "cam: bodies.cam.curves.disc: is a chain and needs a boundary");
  EXPECT_EQ(of_curve([](Curve& c) { c.kind = CurveKind::kSupport; }),
            "cam: bodies.cam.curves.disc: is given by its support and needs one that has its piece");
  const auto of_parts = [&](CurveKind kind, std::vector<int> parts) {
    return refusal([&](Mechanism& m) {
      m.bodies[1].curves[0].curve.kind = kind;
      m.bodies[1].curves[0].parts = std::move(parts);
    });
  };
  EXPECT_EQ(of_parts(CurveKind::kChain, {3}),
            "cam: bodies.cam.curves.disc.parts = 3: there are 1 curves on this body");
  EXPECT_EQ(of_parts(CurveKind::kChain, {0}),
            "cam: bodies.cam.curves.disc.parts: must have no parts themselves");
  EXPECT_EQ(of_parts(CurveKind::kCircle, {0}), "cam: bodies.cam.curves.disc: has parts and must be a chain");
  EXPECT_EQ(refusal([](Mechanism& m) {
              NamedLaw law;
              law.name = "rise";
              law.law.segments = {{LawType::kHarmonic, 1, kNan}};
              m.laws = {law};
            }).find("cam: laws.rise.segments.0"),
            0U);
}

TEST(Model, WhoseDriverIsProgrammedWronglySaysSo) {
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  static constexpr double kInf = std::numeric_limits<double>::infinity();
  const auto refusal = [](const std::function<void(DriverProgram&)>& change) {
    const Mechanism mechanism = four_bar();
    DriverProgram program = default_program(mechanism, mechanism.drivers[0], Units());
    change(program);
    const auto refused = Model::from(mechanism, {}, {program});
    return refused ? "" : to_string(refused.error());
  };
  EXPECT_EQ(refusal([](DriverProgram&) {}), "");
  const std::string far = ": is not finite, or beyond 1e9 turns";
  const std::string beyond = ": must be finite, and at most 1e50 in SI units";
  EXPECT_EQ(refusal([](DriverProgram& p) { p.start = kNan; }), "four-bar: driver.start = nan" + far);
  EXPECT_EQ(refusal([](DriverProgram& p) { p.end = kInf; }), "four-bar: driver.end = inf" + far);
  EXPECT_EQ(refusal([](DriverProgram& p) {
              p.positions = {0, kNan, 2};
            }),
            "four-bar: driver.positions = nan" + far);
  EXPECT_EQ(refusal([](DriverProgram& p) { p.velocity = kNan; }), "four-bar: driver.velocity = nan" + beyond);
  EXPECT_EQ(refusal([](DriverProgram& p) { p.acceleration = kInf; }),
            "four-bar: driver.acceleration = inf" + beyond);
  EXPECT_EQ(refusal([](DriverProgram& p) { p.samples = 0; }),
            "four-bar: driver.samples = 0: must be from 1 to 9007199254740992");
  EXPECT_EQ(refusal([](DriverProgram& p) { p.samples = -3; }),
            "four-bar: driver.samples = -3: must be from 1 to 9007199254740992");
  EXPECT_EQ(refusal([](DriverProgram& p) { p.duration = -1; }),
            "four-bar: driver.duration = -1: must be >= 0");
  EXPECT_EQ(refusal([](DriverProgram& p) { p.duration = kInf; }),
            "four-bar: driver.duration = inf: must be finite");
  EXPECT_EQ(refusal([](DriverProgram& p) { p.time_step = 0; }),
            "four-bar: driver.time_step = 0: must be > 0");
  EXPECT_EQ(refusal([](DriverProgram& p) { p.time_step = -0.1; }),
            "four-bar: driver.time_step = -0.1: must be > 0");
}

TEST(Model, NamesTheTableOfOneOfSeveralDriversThatIsProgrammedWrongly) {
  Mechanism mechanism = four_bar();
  mechanism.drivers[0].name = "two";
  DriverProgram program = default_program(mechanism, mechanism.drivers[0], Units());
  program.duration = -1;
  const auto refused = Model::from(mechanism, {}, {program});
  ASSERT_FALSE(refused);
  EXPECT_EQ(to_string(refused.error()), "four-bar: drivers.two.duration = -1: must be >= 0");
}

// The roller's own copy for the contact must follow it, whatever kept the contact: a chain or a possible gap.
TEST(Model, WithAnotherCurveMovesAsTheProfileWithThatCurve) {
  for (const std::vector<std::string>& overrides :
       {std::vector<std::string>{}, {R"(contacts.touch.keep="gap")", "bodies.follower.pose.y=32"}}) {
    const Model cam = shipped_model("tangent_cam", overrides);
    Mechanism changed = cam.mechanism();
    Curve& roller = changed.bodies[2].curves[0].curve;
    roller = make_circle(center(roller), 1.2 * roller.semi_latus).value();
    const double radius = 1e3 * roller.semi_latus;
    const Model built = cam.with_mechanism(changed).value();
    const Model read = cam.with({{"bodies.follower.curves.roller.radius", radius}}).value();
    const Motion a = built.run().value();
    const Motion b = read.run().value();
    ASSERT_EQ(a.size(), b.size());
    for (const char* column : {"slide.position", "slide.velocity"}) {
      const auto one = a.column(column);
      const auto other = b.column(column);
      for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_NEAR(one[k], other[k], 1e-9 * (1 + std::abs(other[k]))) << column << " " << k;
      }
    }
    EXPECT_EQ(built.mechanism().bodies[2].curves.size(), changed.bodies[2].curves.size());
  }
}

// Contacts with copies of their curves, and with the joined curves of a whole body.
TEST(Model, WithItsOwnMechanismMovesAsBefore) {
  for (const char* name : {"tangent_cam", "geneva_four_slots", "groove_cam"}) {
    const Model model = shipped_model(name);
    const Model same = model.with_mechanism(model.mechanism()).value();
    EXPECT_EQ(text_of(model.run().value()), text_of(same.run().value())) << name;
  }
}

TEST(Model, WithAWholeConicInPlaceOfAChainNeedsNoBoundary) {
  const Model chain = shipped_model("tangent_cam");
  Mechanism changed = chain.mechanism();
  for (Body& body : changed.bodies) {
    for (NamedCurve& curve : body.curves) {
      if (!curve.boundary) continue;
      curve.boundary = nullptr;
      curve.curve = make_circle({0.005, 0}, 0.02).value();
    }
  }
  const Model model = chain.with_mechanism(changed).value();
  EXPECT_FALSE(model.mechanism().contacts[0].by_boundary);
  EXPECT_TRUE(model.run()->good());
  Mechanism marked = model_of(kCam).mechanism();
  marked.contacts[0].by_boundary = true;
  EXPECT_TRUE(Model::from(marked)->run()->good());
}

// Mechanisms of every kind of curve, and contacts with copies and parts of them.
TEST(Model, OfEveryShippedProfileCanBeBuiltFromItsMechanism) {
  for (const auto& entry : std::filesystem::directory_iterator(HIGHERPAIR_SOURCE_DIR "/profiles")) {
    if (entry.path().extension() != ".toml") continue;
    const Model read = Model::open(entry.path().string()).value();
    const auto built = Model::from(read.mechanism(), read.units(), read.profile().programs);
    EXPECT_TRUE(built) << entry.path() << ": " << to_string(built.error());
    EXPECT_TRUE(read.with_mechanism(read.mechanism())) << entry.path();
  }
}

TEST(Model, WithOtherNumbersRunsAsIfReadWithThem) {
  const std::vector<std::pair<std::string, std::vector<Setting>>> cases = {
      {"ellipse_cam_roller", {{"bodies.cam.curves.oval.semi_axes.0", 31.25}, {"driver.samples", 30}}},
      {"watt_sixbar", {{"driver.samples", 31}}},
      {"quick_return", {{"driver.samples", 31}}},
      {"slider_crank", {{"driver.samples", 31}, {"gravity", "[0, -1]"}}},
      {"cam_chain", {{"driver.samples", 31}}},
      {"geared_five_bar", {{"driver.samples", 31}}}};
  for (const auto& [name, settings] : cases) {
    std::vector<std::string> overrides;
    for (const Setting& setting : settings) {
      overrides.push_back(fmt::format("{}={}", setting.path, setting.value));
    }
    const auto fresh = Model::open(HIGHERPAIR_SOURCE_DIR "/profiles/" + name + ".toml", overrides);
    const auto changed = shipped_model(name).with(settings);
    ASSERT_EQ(fresh.has_value(), changed.has_value()) << name << (fresh ? "" : to_string(fresh.error()));
    if (fresh) {
      EXPECT_EQ(text_of(fresh->run().value()), text_of(changed->run().value())) << name;
    }
  }
}

// Slightly increases every number of every kind of group.
TEST(Model, WithEveryNumberChangedRunsAsIfReadWithThem) {
  for (const std::string name :
       {"watt_sixbar", "quick_return", "sixbar_slider", "slider_crank", "scotch_yoke", "ellipse_cam_roller",
        "roller_body", "cam_chain", "five_bar", "planetary_gear", "belt_drive", "rolling_ellipses"}) {
    const Model model = shipped_model(name);
    EXPECT_FALSE(model.parameters().empty());
    for (const Parameter& parameter : model.parameters()) {
      const Setting setting(parameter.path, 1.01 * parameter.value);
      const std::vector<std::string> overrides = {fmt::format("{}={}", setting.path, setting.value)};
      const auto changed = model.with({setting});
      const auto fresh = Model::open(HIGHERPAIR_SOURCE_DIR "/profiles/" + name + ".toml", overrides);
      ASSERT_EQ(fresh.has_value(), changed.has_value()) << name << " " << parameter.path;
      if (!fresh) {
        continue;
      }
      RunSettings settings;
      settings.positions = {fresh->profile().programs.front().start};
      if (fresh->profile().programs.size() != 1) {
        settings.positions.clear();
      }
      const auto one = fresh->run(settings);
      const auto other = changed->run(settings);
      ASSERT_EQ(one.has_value(), other.has_value()) << name << " " << parameter.path;
      EXPECT_EQ(one ? text_of(*one) : to_string(one.error()),
                other ? text_of(*other) : to_string(other.error()))
          << name << " " << parameter.path;
    }
  }
}

TEST(Model, WithAnotherStructureIsPlannedAnew) {
  const Model model = model_of(kCam);
  const Model rolls = model.with({{"contacts.touch.rolling", "true"}}).value();
  EXPECT_FALSE(rolls.run());
  EXPECT_TRUE(model.run());
  const Model more = model.with({{"bodies.roller.points.C", "[0, 0]"}, {"driver.samples", 2}}).value();
  EXPECT_FALSE(more.run());
}

// The rod hangs on a pin of the lever, which is placed before the lever's angle is only while the lever's two
// pins coincide.
constexpr const char* kCoincidentPins = R"(
[bodies.ground]
points = { O = [0, 0], G = [100, 0], H = [160, 20] }
[bodies.crank]
points = { O = [0, 0], A = [20, 0] }
[bodies.coupler]
pose = { x = 20, y = 0, angle = 40.8 }
points = { A = [0, 0], B = [90, 0] }
[bodies.rocker]
pose = { x = 100, y = 0, angle = 101.4 }
points = { G = [0, 0], B = [60, 0] }
[bodies.lever]
pose = { x = 88.1, y = 58.8, angle = 68.7 }
points = { P = [0, 0], Q = [0, 0], S = [70, 0] }
[bodies.rod]
pose = { x = 88.1, y = 58.8, angle = 18.7 }
points = { Q = [0, 0], E = [50, 0] }
[bodies.arm]
pose = { x = 160, y = 20, angle = 114.1 }
points = { H = [0, 0], E = [60, 0] }
[joints]
O = { type = "revolute", between = ["ground.O", "crank.O"] }
A = { type = "revolute", between = ["crank.A", "coupler.A"] }
B = { type = "revolute", between = ["coupler.B", "rocker.B"] }
G = { type = "revolute", between = ["ground.G", "rocker.G"] }
P = { type = "revolute", between = ["rocker.B", "lever.P"] }
Q = { type = "revolute", between = ["lever.Q", "rod.Q"] }
E = { type = "revolute", between = ["rod.E", "arm.E"] }
H = { type = "revolute", between = ["ground.H", "arm.H"] }
S = { type = "slot", between = ["arm.E", "lever.S"], direction = [1, 0] }
[driver]
joint = "O"
start = 0
end = 20
samples = 5
)";

TEST(Model, WithPinsThatPartIsPlannedAnew) {
  const Model model = model_of(kCoincidentPins);
  const Setting apart("bodies.lever.points.Q.0", 5);
  const Model with = model.with({apart}).value();
  const Model fresh = model_of(kCoincidentPins, {apart.path + "=5"});
  const Motion motion = with.run().value();
  EXPECT_TRUE(motion.good());
  EXPECT_EQ(text_of(motion), text_of(fresh.run().value()));
}

TEST(Model, WithARollerThatIsNotRoundAnyMoreIsRefused) {
  const Model model = shipped_model("roller_body");
  EXPECT_TRUE(model.run());
  EXPECT_FALSE(model.with({{"bodies.roller.curves.rim.center.0", 3}}).value().run());
}

TEST(Model, WithAKeyThatIsWrongSaysSo) {
  const Model model = model_of(kCam);
  const auto wrong = model.with({{"bodies.cam.curves.disc.radius", -3}});
  ASSERT_FALSE(wrong);
  EXPECT_TRUE(contains(to_string(wrong.error()), "override bodies.cam.curves.disc.radius=-3"));
  EXPECT_TRUE(contains(to_string(model.with({{"bodies.cam.curves.disc.radios", 3}}).error()),
                       "did you mean `radius`"));
  const auto built = Model::from(four_bar()).value().with({{"driver.end", 3}});
  ASSERT_FALSE(built);
  EXPECT_TRUE(contains(to_string(built.error()), "change a copy of its mechanism()"));
}

TEST(Model, ThatWasBuiltIsRedimensionedByAnotherMechanism) {
  const Model model = Model::from(four_bar()).value();
  Mechanism longer = model.mechanism();
  longer.bodies[2].points[1].p_B.x() = 0.036;
  EXPECT_EQ(text_of(model.with_mechanism(longer).value().run().value()),
            text_of(Model::from(longer).value().run().value()));
  longer.drivers.clear();
  const auto refused = model.with_mechanism(longer);
  ASSERT_FALSE(refused);
  EXPECT_TRUE(contains(to_string(refused.error()), "0 drivers instead of 1"));
}

// The points are apart by the rounding of a drawing, beside the travel of the slide.
TEST(Model, KnowsHowFarItsSlidesAreDriven) {
  const Model model = model_of(R"(
[bodies.ground]
points.O = [0, 0]
[bodies.slide]
pose = { x = 1e-6, y = 0 }
points.P = [0, 0]
[joints]
guide = { type = "prismatic", between = ["ground.O", "slide.P"], direction = [1, 0] }
[driver]
joint = "guide"
start = 10
end = 90
)");
  EXPECT_NEAR(model.mechanism().drivers.front().travel, 0.08, 1e-15);
  EXPECT_EQ(size_of(model.mechanism()), 1);
  const Model still = model.with({{"driver.end", 10.000001}}).value();
  EXPECT_NEAR(size_of(still.mechanism()), 1e-9, 1e-24);
  Mechanism mechanism = model.mechanism();
  mechanism.drivers.front().travel = 7;
  EXPECT_NEAR(model.with_mechanism(mechanism).value().mechanism().drivers.front().travel, 0.08, 1e-15);
  EXPECT_EQ(model_of(kCam).mechanism().drivers.front().travel, 0);
}

TEST(Model, NamesTheNumbersOfItsProfile) {
  std::vector<std::string> paths;
  for (const Parameter& parameter : model_of(kCam).parameters()) {
    paths.push_back(fmt::format("{} = {}", parameter.path, parameter.value));
  }
  EXPECT_THAT(paths,
              ::testing::IsSupersetOf({"bodies.cam.curves.disc.center.0 = 10",
                                       "bodies.cam.curves.disc.radius = 30", "bodies.follower.pose.y = 30"}));
  EXPECT_TRUE(Model::from(four_bar()).value().parameters().empty());
}

TEST(Model, NamesNumbersWithAUnitInTheUnitsOfItsProfile) {
  const Model inches = model_of(kCam, {"bodies.cam.curves.disc.radius=1.2 in"});
  const auto parameters = inches.parameters();
  EXPECT_EQ(parameters.size(), model_of(kCam).parameters().size());
  EXPECT_EQ(parameters.back().path, "bodies.cam.curves.disc.radius");
  EXPECT_NEAR(parameters.back().value, 30.48, 1e-13);
  const Setting same(parameters.back().path, parameters.back().value);
  EXPECT_EQ(curve_of(inches.with({same}).value().mechanism(), {1, 0}).semi_latus,
            curve_of(inches.mechanism(), {1, 0}).semi_latus);
}

// A cam given by its support under a flat face with ends.
Mechanism cam_under_face(const SupportCurve& support, double half_width) {
  Mechanism cam;
  const int disc = add_body(cam, "cam");
  const int follower = add_body(cam, "follower", {0, 0.010});
  const PointRef O = add_point(cam, kGround, "O", {0, 0});
  const int pivot = add_revolute(cam, "pivot", O, add_point(cam, disc, "O", {0, 0}));
  add_prismatic(cam, "guide", O, add_point(cam, follower, "P", {0, 0}), {0, 1});
  const CurveRef edge = add_curve(cam, disc, "edge", make_curve(support));
  const CurveRef face = add_curve(
      cam, follower, "face", *Boundary::make({face_span({-half_width, 0}, {half_width, 0})}, false, 1e-12));
  add_contact(cam, "touch", edge, face);
  add_driver(cam, pivot);
  return cam;
}

// An ellipse of 20 x 10 mm lifts a flat face by h = sqrt((20 sin θ)² + (10 cos θ)²) and touches it at the
// distance h′.
TEST(Model, WithACurveByItsSupportUnderAFaceThatEndsRuns) {
  const testing::EllipseBySupport ellipse({0, 0}, 0.020, 0.010, 0);
  const auto run = [&](double half_width) {
    const auto motion = Model::from(cam_under_face(ellipse, half_width), kSiUnits).value().run();
    EXPECT_TRUE(motion) << to_string(motion.error());
    return *motion;
  };
  const Motion motion = run(0.012);
  EXPECT_TRUE(motion.good());
  const auto height = motion.column("guide.position");
  const auto turned = motion.column("cam.angle");
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double theta = turned[k];
    EXPECT_NEAR(height[k], std::hypot(0.020 * std::sin(theta), 0.010 * std::cos(theta)), 1e-15);
  }
  // The contact is up to 10 mm off the guide.
  EXPECT_THAT(run(0.008).events(), ::testing::Contains(::testing::Field(&Event::type, EventType::kEnd)));
}

// A disc whose support, or the bounds of its radius of curvature, are wrong at some normals.
class WrongDisc final : public SupportCurve {
public:
  WrongDisc(double h, Bounds radius) : h_(h), radius_(radius) {}
  [[nodiscard]] const std::vector<SupportPiece>& pieces() const override { return pieces_; }
  [[nodiscard]] SupportValue at(std::size_t, double phi) const override {
    return {phi > 1 ? h_ : 0.03, 0, 0.03, 0, 1e-16};
  }
  [[nodiscard]] Bounds radius(std::size_t, const Bounds&) const override { return radius_; }

private:
  double h_;
  Bounds radius_;
  std::vector<SupportPiece> pieces_{{PieceKind::kClosed, {}, {}}};
};

TEST(Model, RefusesACurveWhoseSupportIsNoNumber) {
  const auto refusal = [](double h, const Bounds& radius) {
    const WrongDisc disc(h, radius);
    const auto model = Model::from(cam_under_face(disc, 0.02));
    return model ? "" : to_string(model.error());
  };
  EXPECT_EQ(refusal(0.03, {0.03, 0.03}), "");
  EXPECT_TRUE(contains(refusal(NAN, {0.03, 0.03}),
                       "bodies.cam.curves.edge, piece 0 at 1.178 rad: its support has to "
                       "be finite"));
  for (const Bounds& radius : {Bounds{NAN, NAN}, Bounds{0.031, 0.032}, Bounds{1, -1}}) {
    EXPECT_TRUE(
        contains(refusal(0.03, radius), "its radius of curvature is not within the bounds that it gives"));
  }
}

// h = a + b cos 3φ has h + h'' = a - 8 b cos 3φ, which changes sign where 8 b > a.
TEST(Model, RefusesACuspedCurveThatIsToBoundABody) {
  const testing::LobedCurve smooth(0.03, 0.003), cusped(0.03, 0.005);
  const Mechanism good = cam_under_face(smooth, 0.02), bad = cam_under_face(cusped, 0.02);
  const std::string fault =
      "cam.edge has cusps, for its radius of curvature h + h'' changes sign: it bounds no body; a larger "
      "constant part of h takes them out";
  EXPECT_TRUE(Model::from(good));
  EXPECT_EQ(to_string(Model::from(bad).error()), "mechanism: contacts.touch.first: " + fault);
  EXPECT_EQ(to_string(Model::from(good)->with_mechanism(bad).error()),
            "mechanism: contacts.touch.first: " + fault);
  Mechanism swapped = bad;
  std::swap(swapped.contacts[0].first, swapped.contacts[0].second);
  EXPECT_EQ(to_string(Model::from(swapped).error()), "mechanism: contacts.touch.second: " + fault);
  // Several curves of a body joined into one.
  Mechanism joined = bad;
  const CurveRef all = add_curve(joined, 1, "all", Curve{CurveKind::kChain});
  joined.bodies[1].curves[1].parts = {0};
  joined.contacts[0].first = all;
  EXPECT_EQ(to_string(Model::from(joined).error()), "mechanism: contacts.touch.first: " + fault);
  // A contact that may separate turns whole curves into boundaries too.
  Mechanism whole = bad;
  whole.bodies[2].curves[0] = {"face", make_line({0, 0}, {0, -1}).value()};
  EXPECT_TRUE(Model::from(whole));
  whole.contacts[0].keep = Keep::kGap;
  EXPECT_EQ(to_string(Model::from(whole).error()), "mechanism: contacts.touch.first: " + fault);
}

}  // namespace
}  // namespace higherpair

// Polygons: their arrows agree with the table, they close, and the picture shows them to scale.
#include "drawing/svg_reading.hpp"
#include "higherpair/drawing/row_polygons.hpp"
#include "higherpair/front/pictures.hpp"
#include "higherpair/higherpair.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::all_shipped;
using testing::Element;
using ::testing::IsEmpty;
using testing::read_back;
using testing::shipped;
using Kind = PolygonArrow::Kind;
using testing::lines_are;
using testing::part;

Polygons polygons_at(const Model& model, double at, bool forces = false) {
  PolygonSettings settings;
  settings.at = at;
  settings.forces = forces;
  const auto found = polygons_of(model, settings);
  EXPECT_TRUE(found) << to_string(found.error());
  return *found;
}

Vector2d along(const PolygonArrow& arrow) {
  return arrow.to - arrow.from;
}

double longest(const Polygon& polygon) {
  double most = 0;
  for (const PolygonArrow& arrow : polygon.arrows) most = std::max(most, along(arrow).norm());
  return most;
}

const PolygonArrow& arrow(const Polygon& polygon, const std::string& name) {
  const auto found = std::find_if(polygon.arrows.begin(), polygon.arrows.end(),
                                  [&](const PolygonArrow& each) { return each.name == name; });
  if (found == polygon.arrows.end()) throw std::runtime_error("no arrow " + name);
  return *found;
}

// A position in the middle of each shipped profile's run, with one driver.
std::vector<std::pair<Model, double>> shipped_positions() {
  std::vector<std::pair<Model, double>> all;
  for (const std::string& name : all_shipped()) {
    const Model model = shipped(name);
    const auto motion = model.run();
    if (!motion || model.mechanism().drivers.size() != 1) continue;
    const ColumnValues driver = motion->column("driver");
    all.emplace_back(model, driver[0] + 0.371 * (driver[driver.size() - 1] - driver[0]));
  }
  return all;
}

// The row of the table at a position that is reached in the same way as for the polygons.
Motion table_at(const Model& model, double at, bool forces = false) {
  const Motion run = model.run().value();
  RunSettings settings;
  settings.forces = forces;
  settings.positions = {run.column("driver")[0], at};
  return model.run(settings).value();
}

TEST(Polygon, HasTheVelocitiesAndAccelerationsOfTheTable) {
  int compared = 0;
  for (const auto& [model, at] : shipped_positions()) {
    const Polygons found = polygons_at(model, at);
    if (found.limit) continue;
    const Motion table = table_at(model, at);
    for (std::size_t k = 0; k < 2; ++k) {
      const Polygon& polygon = found.polygons[k];
      for (const PolygonArrow& each : polygon.arrows) {
        const auto x = table.find_column(each.item + (k == 0 ? ".vx" : ".ax"));
        if (each.kind != Kind::kAbsolute || !x) continue;
        const double y = table.column(each.item + (k == 0 ? ".vy" : ".ay"))[1];
        EXPECT_NEAR(along(each).x(), (*x)[1], 1e-9 * longest(polygon)) << each.item;
        EXPECT_NEAR(along(each).y(), y, 1e-9 * longest(polygon)) << each.item;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 60);
}

// Every tangential part begins where its normal part ends, and ends at the tip of the point's arrow; the
// Coriolis part begins where the sliding one does.
TEST(Polygon, ClosesOverItsParts) {
  int closed = 0;
  for (const auto& [model, at] : shipped_positions()) {
    const Polygon polygon = polygons_at(model, at).polygons[1];
    const double tolerance = 1e-8 * longest(polygon);
    for (std::size_t i = 0; i + 1 < polygon.arrows.size(); ++i) {
      const PolygonArrow& first = polygon.arrows[i];
      const PolygonArrow& second = polygon.arrows[i + 1];
      const bool parts = (first.kind == Kind::kNormal && second.kind == Kind::kTangential) ||
                         (first.kind == Kind::kCoriolis && second.kind == Kind::kSliding);
      if (!parts || first.item != second.item) continue;
      EXPECT_LE((first.to - second.from).norm(), tolerance);
      const bool ends =
          std::any_of(polygon.arrows.begin(), polygon.arrows.end(), [&](const PolygonArrow& each) {
            return each.kind == Kind::kAbsolute && (each.to - second.to).norm() <= tolerance;
          });
      EXPECT_TRUE(ends) << model.mechanism().title << ' ' << second.name;
      if (first.kind == Kind::kNormal) {
        EXPECT_NEAR(along(first).dot(along(second)), 0, 1e-8 * std::pow(longest(polygon), 2));
      }
      ++closed;
    }
  }
  EXPECT_GT(closed, 20);
}

// Data of the textbook: crank of 15 cm at 8 rad/s, clockwise, with or without a deceleration of 5 rad/s².
TEST(Polygon, OfTheTextbooksSixBarHasItsEquations) {
  const Polygons found = polygons_at(shipped("sixbar_slider"), 45);
  const Polygon& velocity = found.polygons[0];
  const Polygon& acceleration = found.polygons[1];
  EXPECT_TRUE(lines_are(velocity.equations,
                        {"v_{A} = ω_{link2} × r_{DA}", "v_{B} = v_{A} + v_{BA}", "v_{B} = ω_{link4} × r_{FB}",
                         "v_{E} = ω_{link4} × r_{FE}", "v_{G} = v_{E} + v_{GE}"}));
  EXPECT_THAT(acceleration.equations, ::testing::Contains("a_{B} = a_{A} + a_{BA}^{n} + a_{BA}^{t}"));
  EXPECT_EQ(velocity.unit, "cm/s");
  EXPECT_EQ(acceleration.unit, "cm/s^2");
  EXPECT_NEAR(along(arrow(velocity, "v_{A}")).norm(), 120, 1e-9);
  EXPECT_NEAR(along(arrow(acceleration, "a_{A}^{n}")).norm(), 960, 1e-9);
  EXPECT_NEAR(along(arrow(acceleration, "a_{A}^{t}")).norm(), 75, 1e-9);
  // v_BA²/BA with BA = 18 cm
  const double v_BA = along(arrow(velocity, "v_{BA}")).norm();
  EXPECT_NEAR(along(arrow(acceleration, "a_{BA}^{n}")).norm(), v_BA * v_BA / 18, 1e-8);
}

// A slider whose joint names ground last has the same polygons as one whose joint names it first.
TEST(Polygon, OfASlideOnGroundDoesNotDependOnTheOrderOfItsBodies) {
  const Polygons one = polygons_at(shipped("slider_crank"), 40);
  const Polygons other = polygons_at(
      shipped("slider_crank",
              {"joints.slide.between=[\"piston.B\", \"ground.rail\"]", "joints.slide.direction=[1, 0]"}),
      40);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(other.polygons[k].arrows.size(), one.polygons[k].arrows.size());
    EXPECT_EQ(other.polygons[k].equations, one.polygons[k].equations);
    for (std::size_t i = 0; i < one.polygons[k].arrows.size(); ++i) {
      EXPECT_EQ(other.polygons[k].arrows[i].name, one.polygons[k].arrows[i].name);
      EXPECT_EQ(other.polygons[k].arrows[i].item, one.polygons[k].arrows[i].item);
    }
  }
}

TEST(Polygon, OfASlideHasCoriolisAcceleration) {
  const Model model = shipped("quick_return");
  const Polygons found = polygons_at(model, 60);
  const Motion table = table_at(model, 60);
  const double omega = table.column("lever.omega")[1] * kPi / 180;
  const Vector2d sliding = along(arrow(found.polygons[0], "v_{PP′}"));
  const Vector2d coriolis = along(arrow(found.polygons[1], "a_{PP′}^{c}"));
  EXPECT_LE((coriolis - 2 * omega * perp(sliding)).norm(), 1e-9 * coriolis.norm());
  // The remaining vector is along the slide.
  const Vector2d rest = along(arrow(found.polygons[1], "a_{PP′}"));
  EXPECT_NEAR(cross(rest, sliding) / (rest.norm() * sliding.norm()), 0, 1e-9);
}

// The equivalent link is rigid: its ends move relative to each other at right angles to it, with the normal
// acceleration v²/L.
TEST(Polygon, OfAContactIsThatOfItsEquivalentLink) {
  const Model model = shipped("ellipse_cam_roller");
  const Polygons found = polygons_at(model, 60);
  const Motion table = table_at(model, 60);
  const double phi = table.column("touch.normal")[1] * kPi / 180;
  const double length = table.column("touch.r3")[1];
  const Vector2d v = along(arrow(found.polygons[0], "v_{C2/C1}"));
  EXPECT_NEAR(v.dot(unit_vector(phi)), 0, 1e-9 * v.norm());
  const Vector2d normal = along(arrow(found.polygons[1], "a_{C2/C1}^{n}"));
  EXPECT_NEAR(normal.norm(), v.squaredNorm() / length, 1e-8 * normal.norm());
}

// While the roller waits, the centre of the flank is the cam's pivot: what is left of its motion is rounding.
TEST(Polygon, InADwellHasNoArrows) {
  const Polygons found = polygons_at(shipped("law_cam_roller"), 141);
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_THAT(found.polygons[k].arrows, IsEmpty());
    EXPECT_TRUE(lines_are(found.polygons[k].notes, {"all of them are zero"}));
  }
}

TEST(Polygon, CallsPointsOfOneNameByTheirBodies) {
  const Model model = Model::from_text(R"([bodies.ground]
points = { O = [0, 0], Q = [60, 0] }
[bodies.crank]
points = { O = [0, 0], A = [20, 0] }
[bodies.rod]
pose = { x = 20, y = 0 }
points = { A = [0, 0], B = [50, 0], M = [25, 10] }
[bodies.lever]
pose = { x = 60, y = 0, angle = 100 }
points = { Q = [0, 0], B = [40, 0], M = [20, 5] }
[joints]
O = { type = "revolute", between = ["ground.O", "crank.O"] }
A = { type = "revolute", between = ["crank.A", "rod.A"] }
B = { type = "revolute", between = ["rod.B", "lever.B"] }
Q = { type = "revolute", between = ["ground.Q", "lever.Q"] }
[driver]
joint = "O"
)")
                          .value();
  const Polygons found = polygons_at(model, 50);
  std::vector<std::string> names;
  for (const PolygonPoint& point : found.polygons[0].points) names.push_back(point.name);
  EXPECT_THAT(names, ::testing::UnorderedElementsAre("a", "b", "rod.M", "lever.M"));
}

// A moving point O is written "o": the pole has a name of its own.
TEST(Polygon, HasAPoleThatHasNoPointsName) {
  int with_o = 0;
  for (const auto& [model, at] : shipped_positions()) {
    const Polygons found = polygons_at(model, at, true);
    for (const Polygon& polygon : found.polygons) {
      EXPECT_EQ(polygon.pole.empty(), polygon.kind == Polygon::Kind::kForce);
      for (const PolygonPoint& point : polygon.points) {
        EXPECT_NE(point.name, polygon.pole) << model.mechanism().title;
        with_o += point.name == "o" ? 1 : 0;
      }
    }
    std::vector<std::string> names;
    for (const Element& element : read_back(polygons_svg({found.polygons[0]}, ""))) {
      if (element.role != "label" || element.name.starts_with("v_")) continue;
      EXPECT_THAT(names, ::testing::Not(::testing::Contains(element.name))) << model.mechanism().title;
      names.push_back(element.name);
    }
  }
  EXPECT_GT(with_o, 5);
}

// The centre of the roller is the point O of the follower at every position, whatever the rounding.
TEST(Polygon, OfARollerAboutAPointHasOnePointForBoth) {
  for (const auto& [name, point] : {std::pair("tangent_cam", "o"), std::pair("design_least_cam", "p")}) {
    const Model model = shipped(name);
    for (const double at : {10., 40., 70., 77., 200.}) {
      const Polygons found = polygons_at(model, at);
      for (const Polygon& polygon : {found.polygons[0], found.polygons[1]}) {
        std::vector<std::string> names;
        for (const PolygonPoint& each : polygon.points) names.push_back(each.name);
        EXPECT_THAT(names, ::testing::Contains(point)) << name;
        EXPECT_THAT(names, ::testing::Not(::testing::Contains("C2"))) << name << " at " << at;
      }
    }
  }
}

TEST(Polygon, OfForcesClosesForEveryBody) {
  int closed = 0;
  for (const auto& [model, at] : shipped_positions()) {
    const Polygons found = polygons_at(model, at, true);
    double largest = 0;
    for (const Polygon& polygon : found.polygons) {
      if (polygon.kind == Polygon::Kind::kForce) largest = std::max(largest, longest(polygon));
    }
    for (const Polygon& polygon : found.polygons) {
      if (polygon.kind != Polygon::Kind::kForce || polygon.arrows.empty()) continue;
      EXPECT_LE((polygon.arrows.back().to - polygon.arrows.front().from).norm(), 1e-7 * largest)
          << model.mechanism().title << ", " << polygon.title;
      for (std::size_t i = 1; i < polygon.arrows.size(); ++i) {
        EXPECT_EQ(polygon.arrows[i].from, polygon.arrows[i - 1].to);
      }
      ++closed;
    }
  }
  EXPECT_GE(closed, 10);
}

// The torque of a brake on a roller that has no mass is that of the friction at its rim of 15 mm. The force
// on the arm turns with it.
TEST(Polygon, OfForcesClosesWithFrictionAndAForceThatTurnsWithItsBody) {
  std::ifstream file(HIGHERPAIR_SOURCE_DIR "/profiles/roller_body.toml");
  std::stringstream text;
  text << file.rdbuf() << "[loads]\nbrake = { body = \"roller\", torque = 90 }\n"
       << "press = { body = \"arm\", point = \"P\", force = [-3, -12], frame = \"body\" }\n";
  const std::vector<std::string> rolls = {"contacts.touch.rolling=true"};
  const Model model = Model::from_text(text.str(), "roller.toml", rolls).value();
  const Motion table = table_at(model, 70, true);
  EXPECT_NEAR(std::abs(table.column("touch.friction")[1]), 6, 1e-9);
  int closed = 0;
  for (const Polygon& polygon : polygons_at(model, 70, true).polygons) {
    if (polygon.kind != Polygon::Kind::kForce) continue;
    EXPECT_LE((polygon.arrows.back().to - polygon.arrows.front().from).norm(), 1e-9 * longest(polygon))
        << polygon.title;
    ++closed;
  }
  EXPECT_EQ(closed, 3);
  // The two forces on the roller are opposite in the drawing too.
  SceneSettings settings;
  settings.at = 70;
  settings.forces = true;
  const Scene scene = scenes_of(model, settings).value().scenes.front();
  Vector2d sum = Vector2d::Zero();
  for (const Shape& shape : scene.moving) {
    if (shape.role != Role::kForce || (shape.name != "touch" && shape.name != "roller_pin")) continue;
    sum += Vector2d(shape.numbers[2] - shape.numbers[0], shape.numbers[3] - shape.numbers[1]);
  }
  EXPECT_LE(sum.norm(), 1e-9 * scene.unit);
}

TEST(Polygon, OfForcesHasThoseOfTheTable) {
  const Model model = shipped("watt_sixbar_forces");
  const Polygons found = polygons_at(model, 200, true);
  const Motion table = table_at(model, 200, true);
  for (const Polygon& polygon : found.polygons) {
    if (polygon.title != "coupler") continue;
    EXPECT_EQ(polygon.unit, "N");
    const double fx = table.column("C.fx")[1];
    const double fy = table.column("C.fy")[1];
    EXPECT_NEAR(along(arrow(polygon, "F_{C}")).norm(), std::hypot(fx, fy), 1e-9 * std::hypot(fx, fy));
    return;
  }
  ADD_FAILURE() << "no polygon of the coupler";
}

TEST(Polygon, IsDrawnAtTheLimitWhereAPositionCannotBeReached) {
  const Polygons found = polygons_at(shipped("lock_up"), 120);
  ASSERT_TRUE(found.limit);
  EXPECT_FALSE(found.limit->empty());
  EXPECT_NEAR(found.driver, 65.83442067466342, 1e-9);
  EXPECT_EQ(found.driver_unit, "deg");
  // The rates are not defined at the limit.
  EXPECT_THAT(found.polygons[0].arrows, IsEmpty());
  EXPECT_TRUE(lines_are(found.polygons[0].notes, {part("the rates are not defined")}));
  EXPECT_NO_THROW(read_back(polygons_svg(found.polygons, "limit")));
}

TEST(Polygon, WithSeveralDriversIsOfTheNearestRow) {
  const Model model = shipped("five_bar");
  const Motion motion = model.run().value();
  const auto& driver = motion.columns()[0];
  const Polygons found = polygons_at(model, motion.column(driver.name)[3]);
  EXPECT_EQ(found.driver, motion.column(driver.name)[3]);
  EXPECT_FALSE(found.polygons[0].arrows.empty());
}

// The line of an arrow ends where its head begins.
TEST(Polygon, IsDrawnToScale) {
  const Polygons found = polygons_at(shipped("sixbar_slider"), 45);
  const auto drawn = read_back(polygons_svg(found.polygons, "six-bar"));
  double scale = 0;
  Vector2d origin;
  std::size_t next = 0;
  const std::vector<PolygonArrow>* arrows = nullptr;
  int read = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const Element& element = drawn[i];
    if (element.role == "polygon") {
      scale = element.number("data-scale");
      std::istringstream(element.attributes.at("data-origin")) >> origin.x() >> origin.y();
      arrows = &found.polygons[element.name == "Velocities" ? 0 : 1].arrows;
      next = 0;
    } else if (element.role == "velocity" || element.role == "acceleration") {
      const PolygonArrow& expected = (*arrows)[next++];
      EXPECT_EQ(element.name, expected.item);
      double x = 0, y = 0;
      std::istringstream(drawn[i + 2].attributes.at("d").substr(1)) >> x;
      const std::string d = drawn[i + 2].attributes.at("d");
      std::istringstream(d.substr(d.find(' ') + 1)) >> y;
      EXPECT_NEAR((x - origin.x()) / scale, expected.to.x(), 1e-4 / scale);
      EXPECT_NEAR((origin.y() - y) / scale, expected.to.y(), 1e-4 / scale);
      ++read;
    }
  }
  EXPECT_EQ(read, 22);
}

TEST(Polygon, OfEveryShippedProfileIsReadableXml) {
  for (const auto& [model, at] : shipped_positions()) {
    const Polygons found = polygons_at(model, at, true);
    const auto drawn = read_back(polygons_svg(found.polygons, model.mechanism().title));
    const double width = drawn.front().number("width");
    const double height = drawn.front().number("height");
    for (const Element& element : drawn) {
      if (element.tag != "line") continue;
      EXPECT_TRUE(element.number("x1") >= 0 && element.number("x2") <= width && element.number("y1") >= 0 &&
                  element.number("y2") <= height)
          << model.mechanism().title;
    }
  }
}

// Names in the table end before the numbers beside them; the picture is wider where they need that.
TEST(Polygon, HasRoomForItsNames) {
  Polygon polygon;
  const std::string name = "a_{finger_with_roller.C1/finger_with_roller.C2}";
  polygon.arrows.push_back({Kind::kAbsolute, "a_{A}", "a.A", Vector2d(0, 0), Vector2d(0.3, -0.7)});
  EXPECT_EQ(read_back(polygons_svg({polygon}, "short")).front().number("width"), 860);
  polygon.arrows.push_back({Kind::kRelative, name, "a.B", Vector2d(0, 0), Vector2d(0.3, -0.7)});
  const std::string term = "a_{" + std::string(80, 'n') + "}";
  polygon.equations.push_back(term + " = " + term);
  const auto drawn = read_back(polygons_svg({polygon}, "long"));
  const double width = drawn.front().number("width");
  double names = 0, numbers = width;
  for (const Element& element : drawn) {
    if (element.tag != "text") continue;
    const bool number = element.attributes.contains("text-anchor");
    double& edge = number ? numbers : names;
    edge = number ? std::min(edge, element.number("x")) : std::max(edge, element.number("x"));
  }
  EXPECT_LT(names + 10 * 0.5 * static_cast<double>(name.size()), numbers - 50);
  EXPECT_GT(width, names - 28 + 10 * 0.6 * 80);
}

// In a subscript a prime of the letters' size would be a dot.
TEST(Polygon, HasPrimesThatCanBeRead) {
  const Polygons found = polygons_at(shipped("quick_return"), 40);
  int primes = 0;
  for (const Element& element : read_back(polygons_svg(found.polygons, "primes"))) {
    if (element.tag != "tspan" || element.text.find("′") == std::string::npos) continue;
    EXPECT_EQ(element.text, "′");
    EXPECT_GE(element.number("font-size"), 14);
    ++primes;
  }
  EXPECT_GT(primes, 4);
}

TEST(Polygon, ChangesItsUnit) {
  Polygon polygon;
  polygon.arrows.push_back({Kind::kAbsolute, "v_{A}", "a.A", Vector2d(0, 0), Vector2d(0.3, -0.7)});
  polygon.points.push_back({"a", Vector2d(0.3, -0.7)});
  polygon = in_unit(polygon, 1000, "mm/s");
  EXPECT_EQ(polygon.unit, "mm/s");
  EXPECT_EQ(polygon.arrows[0].to, Vector2d(300, -700));
  EXPECT_EQ(polygon.points[0].at, Vector2d(300, -700));
}

}  // namespace
}  // namespace higherpair

// Drawings are read back: they are valid XML, and everything is drawn where the motion puts it.
#include "contact/support_curves.hpp"
#include "drawing/svg_reading.hpp"
#include "front/analysis_impl.hpp"
#include "higherpair/drawing/scene_maker.hpp"
#include "higherpair/higherpair.hpp"
#include "higherpair/io/design_task.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::all_shipped;
using testing::contains;
using testing::Element;
using testing::read_back;
using testing::shipped;

// Positions in a drawing, in millimetres of the mechanism.
struct Reading {
  explicit Reading(const std::string& svg)
      : elements(read_back(svg)), scale(elements.front().number("data-scale")) {
    std::istringstream(elements.front().attributes.at("data-origin")) >> x >> y;
  }
  [[nodiscard]] Vector2d mm(double px, double py) const { return {(px - x) / scale, (y - py) / scale}; }

  std::vector<Element> elements;
  double scale = 1, x = 0, y = 0;
};

std::vector<MotionRow> rows_of(const Model& model) {
  auto analysis = model.start().value();
  std::vector<MotionRow> rows;
  for (Row row; analysis.next(row);) rows.push_back(analysis.impl().run.row);
  return rows;
}

TEST(DrawnProfile, HasItsPinsAndContactsWhereTheMotionSays) {
  for (const std::string& name : all_shipped()) {
    SCOPED_TRACE(name);
    const Model model = shipped(name);
    const Mechanism& mechanism = model.mechanism();
    const std::vector<MotionRow> rows = rows_of(model);
    SceneMaker maker(mechanism, rows);
    for (std::size_t k = 0; k < rows.size(); k += 1 + rows.size() / 7) {
      const Scene& scene = maker.at(rows[k]);
      if (!scene.defined) continue;
      const Reading picture(draw_svg({&scene, 1}, {}));
      std::size_t pins = 0, touches = 0;
      for (const Element& element : picture.elements) {
        if (element.tag != "circle") continue;
        const Vector2d drawn = picture.mm(element.number("cx"), element.number("cy"));
        for (const Joint& joint : mechanism.joints) {
          if (element.role != "joint" || element.name != joint.name || joint.type != JointType::kRevolute)
            continue;
          const auto body = static_cast<std::size_t>(joint.second.body);
          const Vector2d p_B = mechanism.bodies[body].points[joint.second.point].p_B;
          EXPECT_LT((drawn - 1000 * (rows[k].bodies[body].X_WB * p_B)).norm(), 1e-4 * scene.unit)
              << joint.name;
          ++pins;
        }
        for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
          if (element.role != "contact" || element.name != mechanism.contacts[i].name) continue;
          EXPECT_LT((drawn - 1000 * rows[k].contacts[i].at.p_W()).norm(), 1e-4 * scene.unit);
          ++touches;
        }
      }
      const auto revolute =
          std::count_if(mechanism.joints.begin(), mechanism.joints.end(),
                        [](const Joint& joint) { return joint.type == JointType::kRevolute; });
      EXPECT_EQ(pins, static_cast<std::size_t>(revolute));
      const auto closed = std::count_if(rows[k].contacts.begin(), rows[k].contacts.end(),
                                        [](const ContactMotion& contact) { return contact.touches; });
      EXPECT_EQ(touches, static_cast<std::size_t>(closed));
    }
  }
}

// Symbols, bodies and names stay within the frame over the whole motion; no name covers another.
TEST(DrawnProfile, FitsIntoItsFrame) {
  for (const std::string& name : all_shipped()) {
    SCOPED_TRACE(name);
    const Model model = shipped(name);
    const std::vector<MotionRow> rows = rows_of(model);
    SceneMaker maker(model.mechanism(), rows);
    for (std::size_t k = 0; k < rows.size(); k += 1 + rows.size() / 13) {
      const Scene& scene = maker.at(rows[k]);
      if (!scene.defined) continue;
      const Reading picture(draw_svg({&scene, 1}, {}));
      const double width = picture.elements.front().number("width"),
                   height = picture.elements.front().number("height");
      struct TextBox {
        double x, y, half;
      };
      std::vector<TextBox> names;
      for (const Element& element : picture.elements) {
        if (element.tag == "circle" && (element.role == "body" || element.role == "joint")) {
          const double x = element.number("cx"), y = element.number("cy"), r = element.number("r");
          EXPECT_GT(x - r, -0.5) << element.name;
          EXPECT_LT(x + r, width + 0.5) << element.name;
          EXPECT_GT(y - r, -0.5) << element.name;
          EXPECT_LT(y + r, height + 0.5) << element.name;
        }
        if (element.role != "label") continue;
        const TextBox box{element.number("x"), element.number("y"),
                          3.5 * static_cast<double>(element.text.size())};
        EXPECT_GT(box.x - box.half, 0) << element.text;
        EXPECT_LT(box.x + box.half, width) << element.text;
        for (const TextBox& other : names) {
          EXPECT_FALSE(std::abs(box.x - other.x) < box.half + other.half && std::abs(box.y - other.y) < 12)
              << element.text << " at row " << k;
        }
        names.push_back(box);
      }
    }
  }
}

// The x, y, x, y, … of the path of an element [px].
std::vector<double> path_numbers(const Element& element) {
  std::string text = element.attributes.at("d");
  std::replace_if(
      text.begin(), text.end(), [](char c) { return std::isalpha(c) != 0; }, ' ');
  std::istringstream in(text);
  return {std::istream_iterator<double>(in), {}};
}

// No arrow loses its head, unless it is out of all proportion; longer ones than the longest were not scaled.
TEST(DrawnProfile, HasRoomForItsArrows) {
  for (const std::string& name : all_shipped()) {
    SCOPED_TRACE(name);
    const Model model = shipped(name);
    const std::vector<MotionRow> rows = rows_of(model);
    SceneMaker maker(model.mechanism(), rows);
    DrawSettings settings;
    settings.layers = {Role::kLink, Role::kVelocity, Role::kAcceleration};
    for (std::size_t k = 0; k < rows.size(); k += 1 + rows.size() / 37) {
      const Scene& scene = maker.at(rows[k]);
      if (!scene.defined) continue;
      const Reading picture(draw_svg({&scene, 1}, settings));
      const double longest = 14.001 * scene.unit * picture.scale;
      const double width = picture.elements.front().number("width"),
                   height = picture.elements.front().number("height");
      for (const Element& element : picture.elements) {
        if (element.role != "velocity" && element.role != "acceleration") continue;
        const auto n = path_numbers(element);
        ASSERT_EQ(n.size(), 4U);
        if (std::hypot(n[2] - n[0], n[3] - n[1]) > longest) continue;
        EXPECT_TRUE(n[2] > 0 && n[2] < width && n[3] > 0 && n[3] < height)
            << element.role << " of " << element.name << " at row " << k;
      }
    }
  }
}

TEST(Scenes, OfAPositionThatCannotBeReachedShowTheLimitBeforeIt) {
  SceneSettings settings;
  settings.at = 180;
  const Model model = shipped("lock_up");
  const auto scenes = scenes_of(model, settings);
  ASSERT_TRUE(scenes);
  ASSERT_TRUE(scenes->limit);
  // The cranks 50 and 75 in line over the frame of 80.
  EXPECT_NEAR(*scenes->limit, 180 / kPi * std::acos((50. * 50 + 80 * 80 - 75 * 75) / (2 * 50 * 80)), 1e-9);
  EXPECT_TRUE(scenes->scenes.front().defined);
  EXPECT_TRUE(contains(scenes->cause, "cannot be kept in contact"));
}

TEST(Scenes, AreAsManyAsTheStepsOfTheDriver) {
  SceneSettings settings;
  settings.every = 30;
  const auto scenes = scenes_of(shipped("four_bar"), settings);
  ASSERT_TRUE(scenes);
  EXPECT_EQ(scenes->scenes.size(), 13U);
  EXPECT_NEAR(scenes->scenes[3].places[1].theta - scenes->scenes[0].places[1].theta, kPi / 2, 1e-12);
  DrawSettings draw;
  draw.strip = true;
  draw.width = 200;
  EXPECT_EQ(read_back(draw_svg(scenes->scenes, draw)).front().number("width"), 2600);
}

// A strip of many pictures has several lines, so that it does not become too wide to be converted.
TEST(Scenes, OfALongStripAreInSeveralLines) {
  SceneSettings every;
  every.every = 22.5;
  const auto scenes = scenes_of(shipped("four_bar"), every).value();
  ASSERT_EQ(scenes.scenes.size(), 17U);
  DrawSettings draw;
  draw.strip = true;
  const auto drawn = read_back(draw_svg(scenes.scenes, draw));
  EXPECT_LE(drawn.front().number("width"), 5 * 900);
  std::set<std::pair<double, double>> places;
  for (const Element& element : drawn) {
    if (element.tag != "svg" || !element.attributes.contains("x")) continue;
    places.emplace(element.number("x"), element.number("y"));
    EXPECT_LE(element.number("x") + element.number("width"), drawn.front().number("width") + 1e-3);
    EXPECT_LE(element.number("y") + element.number("height"), drawn.front().number("height"));
  }
  EXPECT_EQ(places.size(), 17U);
}

PointRef point_named(const Mechanism& mechanism, const std::string& name) {
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const auto& points = mechanism.bodies[b].points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (mechanism.bodies[b].name + "." + points[p].name == name) {
        return {static_cast<int>(b), static_cast<int>(p)};
      }
    }
  }
  ADD_FAILURE() << name;
  return {};
}

// The path through a few given positions is the point's curve, not a chain of chords.
TEST(Scenes, HavePathsBetweenTheGivenPositions) {
  for (const char* name : {"design_arch_path", "design_five_points"}) {
    const Model model = shipped(name);
    SceneSettings settings;
    settings.traces = {model.profile().design->objectives.front().path()->point};
    const PointRef point = point_named(model.mechanism(), settings.traces.front());
    const Vector2d p_B = model.mechanism().bodies[point.body].points[point.point].p_B;
    const auto scenes = scenes_of(model, settings).value();
    const auto& fixed = scenes.scenes.front().fixed;
    const auto trace = std::find_if(fixed.begin(), fixed.end(),
                                    [](const Shape& shape) { return shape.role == Role::kTrace; });
    ASSERT_NE(trace, fixed.end()) << name;
    const auto& n = trace->numbers;
    for (std::size_t i = 0; i + 5 < n.size(); i += 2) {
      const Vector2d a(n[i + 2] - n[i], n[i + 3] - n[i + 1]), b(n[i + 4] - n[i + 2], n[i + 5] - n[i + 3]);
      EXPECT_LE(std::abs(std::atan2(cross(a, b), a.dot(b))), 10 * kPi / 180) << name << ' ' << i;
    }
    // It goes through the positions of the rows.
    for (const MotionRow& row : rows_of(model)) {
      const Vector2d p = 1000 * (row.bodies[point.body].X_WB * p_B);
      double nearest = 1e9;
      for (std::size_t i = 0; i < n.size(); i += 2) {
        nearest = std::min(nearest, (Vector2d(n[i], n[i + 1]) - p).norm());
      }
      EXPECT_LE(nearest, 1e-6) << name;
    }
  }
}

TEST(Scenes, RefuseWhatDoesNotSuit) {
  const auto message = [](const std::string& profile, const SceneSettings& settings) {
    const auto scenes = scenes_of(shipped(profile), settings);
    return scenes ? "" : to_string(scenes.error());
  };
  SceneSettings settings;
  settings.every = 0.01;
  EXPECT_TRUE(contains(message("four_bar", settings), "give a step > 0 that makes at most 200 pictures"));
  EXPECT_TRUE(contains(message("five_bar", settings), "are for a single driver"));
  settings.every = std::nullopt;
  settings.traces = {"couple.E"};
  EXPECT_TRUE(
      contains(message("four_bar", settings), "there is no point couple.E; did you mean `coupler.E`"));
}

TEST(Scenes, OfSeveralDriversAreThoseOfTheNearestRow) {
  SceneSettings settings;
  const Model model = shipped("five_bar");
  const auto motion = model.run().value();
  settings.at = motion.columns().front().name == "driver.left" ? motion.column("driver.left")[5] : 0;
  const auto scenes = scenes_of(model, settings);
  ASSERT_TRUE(scenes);
  EXPECT_NEAR(scenes->scenes.front().places[1].theta, rows_of(model)[5].bodies[1].theta, 1e-12);
}

// Arrows show the force on a joint's second body, to the scene's scale; the driver's torque is an arc.
TEST(Drawing, MarksItsTargets) {
  const auto scenes = scenes_of(shipped("four_bar")).value();
  DrawSettings settings;
  settings.targets = {{13, -7}, {41, 22}};
  const Reading picture(draw_svg(scenes.scenes, settings));
  std::vector<Vector2d> drawn;
  for (const Element& element : picture.elements) {
    if (element.role == "target") drawn.push_back(picture.mm(element.number("cx"), element.number("cy")));
  }
  ASSERT_EQ(drawn.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LT((drawn[i] - settings.targets[i]).norm(), 1e-3);
}

TEST(Drawing, OfNoSizeHasTheUsualOne) {
  const auto scenes = scenes_of(shipped("four_bar")).value();
  const DrawSettings usual;
  const std::string expected = draw_svg(scenes.scenes, usual);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -5.0, nan, std::numeric_limits<double>::infinity()}) {
    DrawSettings settings;
    settings.width = settings.most_height = settings.length.si = settings.velocity.si = bad;
    settings.targets = {{nan, 1}};
    EXPECT_EQ(draw_svg(scenes.scenes, settings), expected) << bad;
  }
}

TEST(Drawing, HasTheForcesOfTheTable) {
  const Model model = shipped("watt_sixbar_forces");
  SceneSettings at;
  at.at = 60;
  at.forces = true;
  const auto scenes = scenes_of(model, at).value();
  const Scene& scene = scenes.scenes.front();
  RunSettings settings;
  settings.forces = true;
  settings.positions = {0, 60};
  const Motion motion = model.run(settings).value();
  std::size_t arrows = 0, arcs = 0;
  for (const Shape& shape : scene.moving) {
    if (shape.role != Role::kForce) continue;
    if (shape.kind == Shape::Kind::kPath) {
      EXPECT_EQ(shape.name, "driver");
      arcs += shape.numbers.empty() ? 0 : 1;
      continue;
    }
    ASSERT_EQ(shape.numbers.size(), 4U) << shape.name;
    const Vector2d drawn(shape.numbers[2] - shape.numbers[0], shape.numbers[3] - shape.numbers[1]);
    const Vector2d force(motion.column(shape.name + ".fx")[1], motion.column(shape.name + ".fy")[1]);
    EXPECT_LT((drawn - scene.force_scale * force).norm(), 1e-9 * scene.unit) << shape.name;
    ++arrows;
  }
  EXPECT_EQ(arrows, model.mechanism().joints.size());
  EXPECT_EQ(arcs, 2U);  // the arc and its arrow head
}

TEST(Drawing, OfForcesNeedsSomethingThatLoads) {
  SceneSettings settings;
  settings.forces = true;
  const auto scenes = scenes_of(shipped("four_bar"), settings);
  ASSERT_FALSE(scenes);
  EXPECT_EQ(scenes.error().kind, ErrorKind::kInput);
  EXPECT_TRUE(contains(to_string(scenes.error()), "there are no forces to draw: give bodies a mass"));
}

// Each scale is a round number, and its bar has the length that its label states.
TEST(Drawing, HasTheScalesOfItsArrows) {
  SceneSettings at;
  at.forces = true;
  const Model model = shipped("watt_sixbar_forces");
  const auto scenes = scenes_of(model, at).value();
  DrawSettings settings = draw_settings(model.units());
  settings.layers = {Role::kVelocity, Role::kForce};
  std::map<std::string, std::string> texts;
  std::map<std::string, double> lengths;
  const Reading picture(draw_svg(scenes.scenes, settings));
  for (const Element& element : picture.elements) {
    if (element.role != "scale" || element.name.empty()) continue;
    if (element.tag == "text") {
      texts.emplace(element.name, element.text);
    } else if (element.name != "torque") {
      double x0 = 0, x1 = 0, y = 0;
      std::sscanf(element.attributes.at("d").c_str(), "M%lf %lfL%lf", &x0, &y, &x1);
      lengths[element.name] = x1 - x0;
    }
  }
  ASSERT_THAT(texts["force"], ::testing::MatchesRegex("[125]0* N"));
  const Scene& scene = scenes.scenes.front();
  const double px_per_mm = picture.scale / 1000 / settings.length.si;
  EXPECT_NEAR(lengths["force"], std::stod(texts["force"]) * scene.force_scale * px_per_mm, 1e-3);
  ASSERT_TRUE(contains(texts["velocity"], "/s"));
  EXPECT_NEAR(lengths["velocity"],
              std::stod(texts["velocity"]) * settings.velocity.si * 1000 * scene.velocity_scale * px_per_mm,
              1e-3);
}

// Bodies, points and curves look as the table [drawing] defines.
TEST(Drawing, FollowsTheLooksOfTheProfile) {
  const Model model =
      shipped("ellipse_cam_roller", {"drawing.cam.name=Nocken", "drawing.cam.colour=\"#f6d8a8\"",
                                     "drawing.cam.outline=true", "drawing.follower.points.O.hide=true"});
  const auto scenes = scenes_of(model).value();
  std::set<std::string> names;
  std::size_t cams = 0;
  for (const Element& element : read_back(draw_svg(scenes.scenes, {}))) {
    if (element.role == "label") names.insert(element.text);
    if (element.role != "body" || element.name != "cam") continue;
    ++cams;
    EXPECT_EQ(element.attributes.at("style"), "fill:none;stroke:#f6d8a8");
    EXPECT_EQ(element.attributes.at("class"), "body");
  }
  EXPECT_EQ(cams, 1U);
  EXPECT_TRUE(names.contains("Nocken"));
  EXPECT_FALSE(names.contains("cam"));
}

TEST(Drawing, HidesBodiesAndCurves) {
  for (const char* key : {"drawing.cam.hide=true", "drawing.cam.curves.disc.hide=true"}) {
    const auto scenes = scenes_of(shipped("eccentric_disc_oscillating_roller", {key})).value();
    for (const Shape& shape : scenes.scenes.front().fixed) {
      EXPECT_FALSE(shape.role == Role::kBody && shape.name == "cam") << key;
    }
  }
}

TEST(Drawing, EscapesWhatAProfileSays) {
  const Model model = shipped("four_bar", {"title=\"<script>alert('&')</script>\""});
  const auto scenes = scenes_of(model).value();
  DrawSettings settings;
  settings.title = model.mechanism().title;
  const std::string svg = draw_svg(scenes.scenes, settings);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(read_back(svg).at(1).text, "<script>alert('&')</script>");
}

TEST(Drawing, HasTheLayersThatAreAskedFor) {
  const auto scenes = scenes_of(shipped("four_bar")).value();
  DrawSettings settings;
  settings.layers = {Role::kLink, Role::kVelocity};
  std::set<std::string> roles;
  for (const Element& element : read_back(draw_svg(scenes.scenes, settings))) roles.insert(element.role);
  EXPECT_EQ(roles, (std::set<std::string>{"", "link", "velocity", "velocity-head", "scale", "scale-head",
                                          "caption"}));
  for (int role = 0; role < kRoleCount; ++role) {
    EXPECT_EQ(role_of(name_of(static_cast<Role>(role))), static_cast<Role>(role));
  }
}

// The equivalent linkage of the first contact in the first row.
std::vector<Shape> linkage_of(const Scene& scene) {
  std::vector<Shape> shapes;
  for (const Shape& shape : scene.moving) {
    if (shape.role == Role::kLinkage && !shape.numbers.empty()) shapes.push_back(shape);
  }
  return shapes;
}

// Centres of curvature may be anywhere: links to them are broken off within the picture and labelled with
// their length.
TEST(Drawing, BreaksLinksOffThatLeaveIt) {
  for (const char* name : {"parabola_cam", "hyperbola_cam"}) {
    const Model model = shipped(name);
    const Motion motion = model.run().value();
    const auto scenes = scenes_of(model).value();
    const Scene& scene = scenes.scenes.front();
    std::vector<double> lengths;
    for (const Shape& shape : linkage_of(scene)) {
      const std::vector<double>& n = shape.numbers;
      if (shape.kind == Shape::Kind::kText) {
        ASSERT_EQ(n.size(), 5U);
        lengths.push_back(n[4]);
      }
      const std::size_t points = shape.kind == Shape::Kind::kPath ? n.size() : 2;
      for (std::size_t i = 0; i + 1 < points; i += 2) {
        if (std::isnan(n[i])) continue;
        EXPECT_TRUE(n[i] > scene.view.low.x() && n[i] < scene.view.high.x()) << name;
        EXPECT_TRUE(n[i + 1] > scene.view.low.y() && n[i + 1] < scene.view.high.y()) << name;
      }
    }
    ASSERT_EQ(lengths.size(), 2U) << name;
    EXPECT_NEAR(lengths[0], motion.column("touch.r2")[0], 1e-9 * lengths[0]) << name;
    EXPECT_NEAR(lengths[1], std::abs(motion.column("touch.r3")[0]), 1e-9 * lengths[1]) << name;
    std::vector<std::string> texts;
    for (const Element& element : read_back(draw_svg(scenes.scenes, draw_settings(model.units())))) {
      if (element.tag == "text" && element.role == "linkage") texts.push_back(element.text);
    }
    EXPECT_THAT(texts, ::testing::UnorderedElementsAre(fmt::format("r2 = {:.4g} mm", lengths[0]),
                                                       fmt::format("r3 = {:.4g} mm", lengths[1])));
  }
}

// A link of which little is in the picture, since its pivot is near the edge, is broken off as well.
TEST(Drawing, BreaksAShortPieceOfALinkOff) {
  const Model model = Model::from_text(R"(
[bodies.ground]
points.O1 = [0, 0]
points.O2 = [30, -5]
[bodies.cam]
points.O     = [0, 0]
curves.flank = { type = "hyperbola", center = [-20, 0], semi_axes = [10, 14], side = "outside" }
[bodies.arm]
pose          = { x = 30, y = -5, angle = 180 }
points.O      = [0, 0]
curves.roller = { type = "circle", center = [30, 0], radius = 4 }
[joints]
cam = { type = "revolute", between = ["ground.O1", "cam.O"] }
arm = { type = "revolute", between = ["ground.O2", "arm.O"] }
[contacts.touch]
between = ["cam.flank", "arm.roller"]
[driver]
joint   = "cam"
start   = 10
end     = 60
samples = 121
)")
                          .value();
  const auto scenes = scenes_of(model).value();
  const Motion motion = model.run().value();
  std::map<std::string, double> lengths;
  for (const Shape& shape : linkage_of(scenes.scenes.front())) {
    if (shape.kind == Shape::Kind::kText) lengths[shape.text] = shape.numbers[4];
  }
  ASSERT_TRUE(lengths.contains("r2"));
  EXPECT_NEAR(lengths["r2"], motion.column("touch.r2")[0], 1e-9 * lengths["r2"]);
}

// The second wheel's centre of curvature, the foot of the common tangent on its base circle, lies above all
// bodies.
// A contact that is open has no place: it does not enlarge the picture.
TEST(Drawing, IsAsLargeFarFromTheOriginAsAtIt) {
  const auto scale_at = [](double x) {
    const std::string text = fmt::format(R"(
bodies.ground.points = {{ O = [{0}, {0}], Q = [{0}, {0}] }}
bodies.cam = {{ pose = {{ x = {0}, y = {0} }}, points.O = [0, 0], curves.e = {{ type = "circle", center = [3, 0], radius = 20 }} }}
bodies.f = {{ pose = {{ x = {0}, y = {1} }}, points.Q = [0, 0], curves.e = {{ type = "circle", center = [0, 0], radius = 5 }} }}
joints.a = {{ type = "revolute", between = ["ground.O", "cam.O"] }}
joints.b = {{ type = "prismatic", between = ["ground.Q", "f.Q"], direction = [0, 1] }}
contacts.t = {{ between = ["cam.e", "f.e"], keep = "gap" }}
driver = {{ joint = "a", samples = 13 }}
)",
                                         x, x + 50);
    const Model model = Model::from_text(text, "gap.toml").value();
    const std::vector<MotionRow> rows = rows_of(model);
    EXPECT_FALSE(rows.front().contacts.front().touches);
    SceneMaker maker(model.mechanism(), rows);
    const Scene& scene = maker.at(rows.front());
    return Reading(draw_svg({&scene, 1}, {})).scale;
  };
  EXPECT_NEAR(scale_at(1000), scale_at(0), 1e-3);
}

// The point of the body is at the pin but for the rounding of its pose.
TEST(Drawing, OfASinglePointDoesNotScaleItsRounding) {
  const auto unit_with = [](const std::string& pin, const std::string& point) {
    const Model model =
        Model::from_text(
            fmt::format("bodies.ground.points.P = {}\nbodies.bar.points.P = {}\n"
                        "joints.j = {{ type = \"revolute\", between = [\"bar.P\", \"ground.P\"] }}\n"
                        "driver.joint = \"j\"\n",
                        pin, point),
            "pin.toml")
            .value();
    SceneMaker maker(model.mechanism(), rows_of(model));
    return maker.scene().unit;
  };
  EXPECT_EQ(unit_with("[-0.8, -0.9]", "[-1.8, -0.37]"), unit_with("[0, 0]", "[0, 0]"));
}

TEST(Drawing, HasRoomForALinkageThatIsNeverFarOutside) {
  const Model model = shipped("involute_pair");
  const std::vector<MotionRow> rows = rows_of(model);
  SceneMaker maker(model.mechanism(), rows);
  std::size_t linkages = 0;
  for (const MotionRow& row : rows) {
    const Scene& scene = maker.at(row);
    for (const Shape& shape : linkage_of(scene)) {
      EXPECT_NE(shape.kind, Shape::Kind::kText);
      if (shape.kind != Shape::Kind::kPath || shape.closed) continue;
      ++linkages;
      ASSERT_EQ(shape.numbers.size(), 8U);
      EXPECT_NEAR(shape.numbers[5], 40 * std::cos(kPi / 9) * std::sin(kPi / 9), 1e-9);  // N2
    }
  }
  EXPECT_GT(linkages, 0U);
}

// Each above its position of the driver, and no picture on the caption of another.
TEST(Drawing, OfAStripHasThePositionsOfTheDriver) {
  SceneSettings wanted;
  wanted.every = 10;
  const auto scenes = scenes_of(shipped("four_bar"), wanted).value();
  DrawSettings settings;
  settings.strip = true;
  std::vector<std::string> captions;
  double end = 0;  // of the picture before
  for (const Element& element : read_back(draw_svg(scenes.scenes, settings))) {
    if (element.attributes.contains("class") && element.attributes.at("class") == "scene") {
      end = element.number("y") + element.number("height");
    } else if (element.role == "caption") {
      EXPECT_GT(element.number("y"), end);
      EXPECT_LT(element.number("y"), end + 24);
      captions.push_back(element.text);
    }
  }
  ASSERT_EQ(captions.size(), scenes.scenes.size());
  ASSERT_GT(captions.size(), 1U);
  EXPECT_EQ(captions[1], "driver = 10 deg");
}

// A single picture, or ghosts under the last position: below it at the right.
TEST(Drawing, HasThePositionOfItsDrivers) {
  const auto captions = [](const std::string& name, const SceneSettings& wanted) {
    std::vector<std::string> found;
    for (const Element& element : read_back(draw_svg(scenes_of(shipped(name), wanted).value().scenes, {}))) {
      if (element.role == "caption") found.push_back(element.text);
    }
    return found;
  };
  SceneSettings at, every;
  at.at = 30;
  every.every = 10;
  using Texts = std::vector<std::string>;
  EXPECT_EQ(captions("four_bar", {}), Texts{"driver = 0 deg"});
  EXPECT_EQ(captions("four_bar", at), Texts{"driver = 30 deg"});
  EXPECT_EQ(captions("four_bar", every), Texts{"driver = 360 deg"});
  EXPECT_EQ(captions("five_bar", {}), Texts{"driver.left = 110 deg, driver.right = 60 deg"});
}

// The arc of a driven pin is about it, and its head is where it turns to; so is the arrow beside a slide.
TEST(Drawing, MarksTheDrivenBodyInItsSense) {
  for (const double speed : {60.0, -60.0}) {
    const Model model = shipped("four_bar", {fmt::format("driver.velocity={}", speed)});
    const std::vector<MotionRow> rows = rows_of(model);
    const Scene scene = SceneMaker(model.mechanism(), rows).scene();
    std::vector<Shape> marks;
    for (const Shape& shape : scene.moving) {
      if (shape.role == Role::kDriver) marks.push_back(shape);
    }
    ASSERT_EQ(marks.size(), 2U);
    const Vector2d pin = kMillimetresPerMetre * model.mechanism().bodies[0].points[0].p_B;
    const std::vector<double>& arc = marks[0].numbers;
    const Vector2d from = Vector2d(arc[0], arc[1]) - pin;
    const Vector2d to = Vector2d(arc[arc.size() - 2], arc[arc.size() - 1]) - pin;
    const Vector2d tip = Vector2d(marks[1].numbers[0], marks[1].numbers[1]) - pin;
    EXPECT_NEAR(from.norm(), to.norm(), 1e-9);
    EXPECT_GT(speed * perp(from).dot(to), 0);
    EXPECT_GT(speed * perp(to).dot(tip), 0);
  }
  const Model model = shipped("law_driven_slider");
  const std::vector<MotionRow> rows = rows_of(model);
  SceneMaker maker(model.mechanism(), rows);
  const Joint& slide = driven_joint(model.mechanism());
  ASSERT_EQ(slide.type, JointType::kPrismatic);
  for (const MotionRow& row : rows) {
    const double speed = joint_motion(model.mechanism(), slide, row.bodies).velocity;
    for (const Shape& shape : maker.at(row).moving) {
      if (shape.role != Role::kDriver || speed == 0) continue;
      const std::vector<double>& n = shape.numbers;
      EXPECT_GT(speed * slide.direction_A.dot(Vector2d(n[2] - n[0], n[3] - n[1])), 0);
    }
  }
}

// Of a centre outside of the frame an arrow within it points there; one inside has none.
TEST(Drawing, PointsToCentresOutsideOfTheFrame) {
  const Model model = shipped("sixbar_slider");
  const std::vector<MotionRow> rows = rows_of(model);
  SceneMaker maker(model.mechanism(), rows);
  int outside = 0, inside = 0;
  for (const MotionRow& row : rows) {
    const Scene& scene = maker.at(row);
    const auto holds = [&](const Vector2d& p) {
      return (p.array() >= scene.view.low.array()).all() && (p.array() <= scene.view.high.array()).all();
    };
    std::map<std::string, Shape> arrows, texts;
    for (const Shape& shape : scene.moving) {
      if (shape.role != Role::kCenter) continue;
      if (shape.kind == Shape::Kind::kArrow) arrows[shape.name] = shape;
      if (shape.kind == Shape::Kind::kText) texts[shape.text] = shape;
    }
    for (std::size_t b = 1; b < row.bodies.size(); ++b) {
      const BodyMotion& body = row.bodies[b];
      const std::string& name = model.mechanism().bodies[b].name;
      const Vector2d p = kMillimetresPerMetre * (body.X_WB.p_WB + perp(body.v_WB) / body.omega);
      const std::vector<double>& n = arrows.at(name).numbers;
      EXPECT_EQ(texts.at("centre of " + name).numbers.empty(), n.empty());
      if (n.empty()) {
        inside += p.allFinite() && holds(p) ? 1 : 0;
        EXPECT_TRUE(body.omega == 0 || holds(p) || p.norm() > 100 * scene.view.size().norm()) << name;
        continue;
      }
      ++outside;
      const Vector2d tail(n[0], n[1]), tip(n[2], n[3]);
      EXPECT_TRUE(holds(tail) && holds(tip) && !holds(p)) << name;
      EXPECT_NEAR((tip - tail).normalized().dot((p - tip).normalized()), 1, 1e-9) << name;
    }
  }
  EXPECT_GT(outside, 0);
  EXPECT_GT(inside, 0);
}

// The distance of a point from the closed path of an element [px].
double distance_from(const Element& element, const Vector2d& p) {
  const std::vector<double> n = path_numbers(element);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < n.size(); i += 2) {
    const std::size_t k = (i + 2) % n.size();
    const Vector2d a(n[i], n[i + 1]), side = Vector2d(n[k], n[k + 1]) - a;
    const double share = side.norm() > 0 ? std::clamp((p - a).dot(side) / side.squaredNorm(), 0.0, 1.0) : 0;
    least = std::min(least, (p - a - share * side).norm());
  }
  return least;
}

// The last side of a closed outline counts as the others do: the names stood across the right sides of these.
TEST(Drawing, WritesNamesBesideNarrowBarsNotAcrossTheirSides) {
  SceneSettings wanted;
  wanted.at = 30;
  const auto all = read_back(draw_svg(scenes_of(shipped("toggle_press"), wanted).value().scenes, {}));
  int found = 0;
  for (const Element& label : all) {
    if (label.role != "label" || (label.text != "upper" && label.text != "lower")) continue;
    const double half = 3 * static_cast<double>(label.text.size());
    for (const Element& bar : all) {
      if (bar.role != "link" || bar.name != label.text) continue;
      for (const double x : {-half, -half / 2, 0.0, half / 2, half}) {
        EXPECT_GT(distance_from(bar, {label.number("x") + x, label.number("y")}), 3) << label.text;
      }
      ++found;
    }
  }
  EXPECT_EQ(found, 2);
}

// A dot has no name, and an arrow does not show which of two bodies it acts on.
TEST(Drawing, TellsWhoseItsCentresAndForcesAre) {
  SceneSettings wanted;
  wanted.forces = true;
  const auto scenes = scenes_of(shipped("watt_sixbar_forces"), wanted).value();
  DrawSettings settings;
  settings.layers = {Role::kLink, Role::kCenter, Role::kForce};
  std::set<std::string> told;
  for (const Element& element : read_back(draw_svg(scenes.scenes, settings))) {
    if (element.tag == "title") told.insert(element.text);
  }
  EXPECT_TRUE(told.contains("instant centre of triangle"));
  EXPECT_TRUE(told.contains("crank on coupler") || told.contains("coupler on crank"));
}

TEST(Drawing, IsAsWideAsItsHeightAllows) {
  const auto scenes = scenes_of(shipped("checked_cam")).value();
  const auto size = [&](const DrawSettings& settings) {
    const Element top = read_back(draw_svg(scenes.scenes, settings)).front();
    return Vector2d(top.number("width"), top.number("height"));
  };
  const Vector2d usual = size({});
  EXPECT_LT(usual.x(), 900);
  EXPECT_GT(usual.y(), 1000);
  EXPECT_LT(usual.y(), 1060);  // including the scales
  DrawSettings wide;
  wide.most_height = 1e9;
  EXPECT_NEAR(size(wide).x(), 900, 1e-9);
  const auto slide = scenes_of(shipped("motion_laws")).value();
  const Reading narrow(draw_svg(slide.scenes, {}));
  EXPECT_GE(narrow.elements.front().number("width"), 240);
}

// A pin that runs in slots is not drawn as a knife edge.
TEST(Drawing, HasPinsAndSlotsWhereAContactHoldsBothSides) {
  const auto scenes = scenes_of(shipped("geneva_four_slots")).value();
  const Scene& scene = scenes.scenes.front();
  std::size_t pins = 0, slots = 0;
  for (const Shape& shape : scene.fixed) {
    if (shape.role != Role::kJoint) continue;
    const std::vector<double>& n = shape.numbers;
    if (shape.name == "crank" && shape.kind == Shape::Kind::kCircle) {
      EXPECT_NEAR(n[0], 40 * std::sqrt(2.), 1e-9);
      EXPECT_NEAR(n[2], scene.unit, 1e-9);
      ++pins;
    }
    if (shape.name != "wheel" || shape.kind != Shape::Kind::kPath) continue;
    Vector2d middle = Vector2d::Zero();  // mean of both sides
    for (std::size_t i = 0; i < n.size(); i += 2) middle += 2 * Vector2d(n[i], n[i + 1]) / n.size();
    EXPECT_NEAR(middle.cwiseAbs().minCoeff(), 0, 1e-9);
    ++slots;
  }
  EXPECT_EQ(pins, 1U);
  EXPECT_EQ(slots, 4U);
}

// Bars connect every curve to the points of its body: a ring whose pivot is in its hole, a flank of a tooth.
TEST(Drawing, JoinsCurvesToTheirPivots) {
  for (const auto& [model, body] :
       {std::pair(shipped("disc_in_ring", {"bodies.ring.curves.hole.center=[10, 32]"}), "ring"),
        std::pair(shipped("involute_pair"), "wheel")}) {
    const auto scenes = scenes_of(model).value();
    const auto& fixed = scenes.scenes.front().fixed;
    EXPECT_TRUE(std::any_of(fixed.begin(), fixed.end(), [&, name = body](const Shape& shape) {
      return shape.role == Role::kLink && shape.name == name;
    })) << body;
  }
}

// Points [mm] are within closed shapes of a body.
bool is_covered(const Scene& scene, int body, const Vector2d& p) {
  for (const Shape& shape : scene.fixed) {
    if (shape.body != body || !shape.closed || shape.kind != Shape::Kind::kPath) continue;
    bool within = false;
    const auto& n = shape.numbers;
    for (std::size_t i = 0, j = n.size() - 2; i < n.size(); j = i, i += 2) {
      if ((n[i + 1] > p.y()) != (n[j + 1] > p.y()) &&
          p.x() < n[i] + (p.y() - n[i + 1]) / (n[j + 1] - n[i + 1]) * (n[j] - n[i])) {
        within = !within;
      }
    }
    if (within) return true;
  }
  return false;
}

// A lever whose only point is its pivot reaches from there to the slot, or to the rail, that it guides with.
TEST(Drawing, JoinsSlotsAndRailsToTheirBodies) {
  for (const char* pair :
       {R"(slide = { type = "slot", between = ["lever.Q", "crank.A"], direction = [1, 0] })",
        R"(pin = { type = "revolute", between = ["crank.A", "block.A"] }
slide = { type = "prismatic", between = ["lever.Q", "block.A"], direction = [1, 0] })"}) {
    const bool has_block = std::string(pair).find("block") != std::string::npos;
    const Model model =
        Model::from_text(fmt::format(R"(
[bodies.ground]
points.O = [0, 0]
points.Q = [60, 0]
[bodies.crank]
points.O = [0, 0]
points.A = [20, 0]
[bodies.lever]
pose     = {{ x = 60, angle = 180 }}
points.Q = [0, 0]
{}
[joints]
crank = {{ type = "revolute", between = ["ground.O", "crank.O"] }}
lever = {{ type = "revolute", between = ["ground.Q", "lever.Q"] }}
{}
[driver]
joint = "crank"
)",
                                     has_block ? "[bodies.block]\npose = { x = 20 }\npoints.A = [0, 0]" : "",
                                     pair))
            .value();
    const auto scenes = scenes_of(model).value();
    for (double x = 0.3; x < 80; x += 1) {  // the pin is between 40 and 80 from the pivot
      EXPECT_TRUE(is_covered(scenes.scenes.front(), 2, {x, 0.1})) << pair << ' ' << x;
    }
  }
}

// A ring that is a chain is joined to its pivot as a round one is, and has no seam.
TEST(Drawing, JoinsRingsOfChainsToTheirPivots) {
  const Model model = Model::from_text(R"(
[bodies.ground]
points.O1 = [0, 0]
points.O2 = [5, 0]
[bodies.cam]
points.O = [0, 0]
[bodies.cam.curves.track]
type  = "chain"
side  = "outside"
spans = [
  { type = "segment", from = [-40, -20], to = [40, -20] },
  { type = "arc", center = [40, 0], radius = 20, from = -90, to = 90 },
  { type = "segment", from = [40, 20], to = [-40, 20] },
  { type = "arc", center = [-40, 0], radius = 20, from = 90, to = 270 },
]
[bodies.arm]
pose          = { x = 5, y = 0, angle = 80 }
points.O      = [0, 0]
curves.roller = { type = "circle", center = [20, 0], radius = 6 }
[joints]
cam = { type = "revolute", between = ["ground.O1", "cam.O"] }
arm = { type = "revolute", between = ["ground.O2", "arm.O"] }
[contacts.touch]
between = ["cam.track", "arm.roller"]
[driver]
joint   = "cam"
end     = 40
samples = 41
)")
                          .value();
  const auto scenes = scenes_of(model).value();
  const Scene& scene = scenes.scenes.front();
  EXPECT_TRUE(is_covered(scene, 1, {0.1, 0.1}));
  const auto ring = std::find_if(scene.fixed.begin(), scene.fixed.end(), [](const Shape& shape) {
    return shape.role == Role::kBody && shape.body == 1;
  });
  ASSERT_NE(ring, scene.fixed.end());
  // The inner boundary and the outer one, each closed: no line leads from one to the other.
  EXPECT_EQ(std::count_if(ring->numbers.begin(), ring->numbers.end(), [](double x) { return std::isnan(x); }),
            2);
  for (std::size_t i = 0; i < ring->numbers.size(); i += 2) {
    const Vector2d p(ring->numbers[i], ring->numbers[i + 1]);
    if (std::isnan(p.x())) continue;
    const double from_middle = Vector2d(std::max(std::abs(p.x()) - 40, 0.0), p.y()).norm();
    EXPECT_GE(from_middle, 20 - 1e-6);
  }
  const auto bar = std::find_if(scene.fixed.begin(), scene.fixed.end(), [](const Shape& shape) {
    return shape.role == Role::kLink && shape.body == 1;
  });
  ASSERT_NE(bar, scene.fixed.end());
  double farthest = 0;
  for (std::size_t i = 0; i < bar->numbers.size(); i += 2) {
    const Vector2d p(bar->numbers[i], bar->numbers[i + 1]);
    farthest = std::max(farthest, Vector2d(std::max(std::abs(p.x()) - 40, 0.0), p.y()).norm());
  }
  EXPECT_GE(farthest, 20);
}

// The guide of a rod is outside of the roller at its end.
TEST(Drawing, HasGuidesBeyondTheRoller) {
  const Model model = Model::from_text(R"(
[bodies.ground]
points.O = [0, 0]
[bodies.wedge]
points.P    = [0, 0]
curves.face = { type = "line", point = [0, 10], normal = [-1, 3] }
[bodies.lifter]
pose          = { x = 0, y = 30 }
points.Q      = [0, 0]
curves.roller = { type = "circle", center = [0, 0], radius = 5 }
[joints]
rail  = { type = "prismatic", between = ["ground.O", "wedge.P"], direction = [1, 0] }
guide = { type = "prismatic", between = ["ground.O", "lifter.Q"], direction = [0, 1] }
[contacts.touch]
between = ["wedge.face", "lifter.roller"]
[driver]
joint   = "rail"
start   = 0
end     = 30
samples = 31
)")
                          .value();
  const auto scenes = scenes_of(model);
  ASSERT_TRUE(scenes) << to_string(scenes.error());
  const Scene& scene = scenes->scenes.front();
  double roller = 0;
  for (const Shape& shape : scene.fixed) {
    if (shape.role == Role::kBody && shape.name == "lifter") roller = shape.numbers[2];
  }
  ASSERT_GT(roller, 0);
  const Scene::Place& place = scene.places[2];
  for (const Shape& shape : scene.fixed) {
    if (shape.role != Role::kFixed || shape.name != "guide") continue;
    for (std::size_t i = 0; i < shape.numbers.size(); i += 2) {
      if (std::isnan(shape.numbers[i])) continue;
      EXPECT_GT(std::hypot(shape.numbers[i] - place.x, shape.numbers[i + 1] - place.y), roller);
    }
  }
}

// A name that has no place is left out: it would cover another one, or leave the picture.
TEST(Drawing, LeavesOutNamesThatHaveNoPlace) {
  std::string text = "[bodies.ground]\n";
  std::string bodies, joints = "[joints]\n";
  constexpr int kLevers = 12;
  for (int i = 0; i < kLevers; ++i) {
    text += fmt::format("points.G{} = [{}, 0]\n", i, 40 * i);
    bodies += fmt::format(
        "[bodies.rocking_lever_number_{0}]\npose = {{ x = {1}, angle = 90 }}\npoints.base_pin_{0} = [0, 0]\n"
        "points.upper_pin_{0} = [30, 0]\n",
        i, 40 * i);
    joints += fmt::format(
        "pivot_{0} = {{ type = \"revolute\", between = [\"ground.G{0}\", "
        "\"rocking_lever_number_{0}.base_pin_{0}\"] }}\n",
        i);
    if (i == 0) continue;
    bodies += fmt::format(
        "[bodies.connecting_rod_{0}]\npose = {{ x = {1}, y = 30 }}\npoints.left_{0} = [0, 0]\n"
        "points.right_{0} = [40, 0]\n",
        i, 40 * (i - 1));
    joints += fmt::format(
        "a_{0} = {{ type = \"revolute\", between = [\"rocking_lever_number_{1}.upper_pin_{1}\", "
        "\"connecting_rod_{0}.left_{0}\"] }}\n"
        "b_{0} = {{ type = \"revolute\", between = [\"connecting_rod_{0}.right_{0}\", "
        "\"rocking_lever_number_{0}.upper_pin_{0}\"] }}\n",
        i, i - 1);
  }
  const Model model =
      Model::from_text(text + bodies + joints + "[driver]\njoint = \"pivot_0\"\nstart = 90\nend = 110\n")
          .value();
  const Reading picture(draw_svg(scenes_of(model).value().scenes, {}));
  const double width = picture.elements.front().number("width");
  std::vector<Element> names;
  for (const Element& element : picture.elements) {
    if (element.role != "label") continue;
    const auto half = [](const Element& one) { return 3.5 * static_cast<double>(one.text.size()); };
    EXPECT_GT(element.number("x") - half(element), 0) << element.text;
    EXPECT_LT(element.number("x") + half(element), width) << element.text;
    for (const Element& other : names) {
      EXPECT_FALSE(std::abs(element.number("x") - other.number("x")) < half(element) + half(other) &&
                   std::abs(element.number("y") - other.number("y")) < 12)
          << element.text << " and " << other.text;
    }
    names.push_back(element);
  }
  EXPECT_GE(names.size(), 6U);
}

// What a spring on ground pushes against is drawn.
TEST(Drawing, HasWallsForSpringsOnGround) {
  for (const char* name : {"valve_train", "checked_cam"}) {
    const Model model = shipped(name);
    const auto scenes = scenes_of(model).value();
    const auto& fixed = scenes.scenes.front().fixed;
    for (const Spring& spring : model.mechanism().springs) {
      EXPECT_TRUE(std::any_of(fixed.begin(), fixed.end(), [&](const Shape& shape) {
        return shape.role == Role::kFixed && shape.name == spring.name;
      })) << name;
    }
  }
}

TEST(Drawing, HasArcsThatLookRound) {
  const auto scenes = scenes_of(shipped("four_arc_cam")).value();
  const auto& fixed = scenes.scenes.front().fixed;
  const auto cam = std::find_if(fixed.begin(), fixed.end(), [](const Shape& shape) {
    return shape.role == Role::kBody && shape.name == "cam" && shape.kind == Shape::Kind::kPath;
  });
  ASSERT_NE(cam, fixed.end());
  std::vector<Vector2d> lines;
  for (std::size_t i = 0; i + 3 < cam->numbers.size(); i += 2) {
    const Vector2d line(cam->numbers[i + 2] - cam->numbers[i], cam->numbers[i + 3] - cam->numbers[i + 1]);
    if (line.norm() > 1e-6) lines.push_back(line);
  }
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const double turn = std::atan2(cross(lines[i], lines[i + 1]), lines[i].dot(lines[i + 1]));
    EXPECT_LE(std::abs(turn), 0.07) << i;
  }
}

// The points drawn of an ellipse satisfy its equation.
TEST(Drawing, HasCurvesGivenByTheirSupport) {
  const double a = 0.020, b = 0.010;
  const testing::EllipseBySupport ellipse({0, 0}, a, b, 0);
  Mechanism cam;
  const int disc = add_body(cam, "cam");
  const PointRef O = add_point(cam, kGround, "O", {0, 0});
  add_driver(cam, add_revolute(cam, "pivot", O, add_point(cam, disc, "O", {0, 0})));
  add_curve(cam, disc, "edge", make_curve(ellipse));
  const auto scenes = scenes_of(Model::from(cam).value()).value();
  const auto& fixed = scenes.scenes.front().fixed;
  const auto edge = std::find_if(fixed.begin(), fixed.end(), [](const Shape& shape) {
    return shape.role == Role::kBody && shape.name == "cam" && shape.kind == Shape::Kind::kPath;
  });
  ASSERT_NE(edge, fixed.end());
  ASSERT_GT(edge->numbers.size(), 60U);
  for (std::size_t i = 0; i < edge->numbers.size(); i += 2) {
    const double x = edge->numbers[i] / (1e3 * a), y = edge->numbers[i + 1] / (1e3 * b);
    EXPECT_NEAR(std::hypot(x, y), 1, 1e-12) << i;
  }
}

// Spirals that wind with their pivots, and zigzags that change with their slides.
TEST(Drawing, HasTheSpringsOfJoints) {
  const Model model = shipped("cam_with_return_spring",
                              {"springs.along={ joint = \"guide\", stiffness = 1, free_length = 0 }",
                               "springs.about={ joint = \"cam_pivot\", stiffness = 1, free_angle = 0 }"});
  const auto ends = [&](const std::string& name, double at) {
    SceneSettings settings;
    settings.at = at;
    const auto scenes = scenes_of(model, settings).value();
    for (const Shape& shape : scenes.scenes.front().moving) {
      if (shape.role != Role::kSpring || shape.name != name) continue;
      const auto& n = shape.numbers;
      return std::pair(Vector2d(n[0], n[1]), Vector2d(n[n.size() - 2], n.back()));
    }
    throw std::out_of_range(name);
  };
  const auto [below, above] = ends("along", 0);
  const auto [still, moved] = ends("along", 90);
  EXPECT_GT(above.y(), below.y());
  EXPECT_NEAR((still - below).norm(), 0, 1e-9);
  EXPECT_NEAR((moved - above - Vector2d(0, 10)).norm(), 0, 1e-9);
  const auto [outside, inside] = ends("about", 40);
  EXPECT_NEAR(angle_of(outside), 0, 1e-12);
  EXPECT_NEAR(angle_of(inside), 40 * kPi / 180, 1e-12);
  EXPECT_GT(outside.norm(), inside.norm());
}

// A bar is drawn behind the face that it carries, even if a point of its body is on the face.
TEST(Drawing, KeepsBarsBehindFaces) {
  for (const char* name : {"flat_faced_translating", "cam_with_return_spring"}) {
    const Model model = shipped(name);
    const auto scenes = scenes_of(model).value();
    const Body& follower = model.mechanism().bodies[2];
    const auto face = std::find_if(follower.curves.begin(), follower.curves.end(),
                                   [](const NamedCurve& curve) { return is_line(curve.curve); });
    ASSERT_NE(face, follower.curves.end());
    const Vector2d into = (face->curve.side == Side::kOutside ? -1 : 1) * face->curve.axis_B;
    for (const Shape& shape : scenes.scenes.front().fixed) {
      if (shape.role != Role::kLink || shape.body != 2) continue;
      for (std::size_t i = 0; i < shape.numbers.size(); i += 2) {
        const Vector2d p(shape.numbers[i], shape.numbers[i + 1]);
        EXPECT_GT((p - 1000 * face->curve.vertex_B).dot(into), -1e-9) << name;
      }
    }
  }
}

// The linkage of the demo's mechanism: O1 C1 = 10, C1 C2 = 35, C2 O2 = 60, O1 O2 = 80.
TEST(Drawing, HasTheEquivalentLinkageInItsLengths) {
  SceneSettings at;
  at.at = 77;
  const auto scenes = scenes_of(shipped("eccentric_disc_oscillating_roller"), at).value();
  int linkages = 0;
  for (const Shape& shape : scenes.scenes.front().moving) {
    if (shape.role != Role::kLinkage || shape.kind != Shape::Kind::kPath || shape.closed) continue;
    ++linkages;
    ASSERT_EQ(shape.numbers.size(), 8U);
    std::vector<Vector2d> p;
    for (std::size_t i = 0; i < 8; i += 2) p.emplace_back(shape.numbers[i], shape.numbers[i + 1]);
    EXPECT_NEAR((p[1] - p[0]).norm(), 10, 1e-9);
    EXPECT_NEAR((p[2] - p[1]).norm(), 35, 1e-9);
    EXPECT_NEAR((p[3] - p[2]).norm(), 60, 1e-9);
    EXPECT_NEAR((p[3] - p[0]).norm(), 80, 1e-9);
  }
  EXPECT_EQ(linkages, 1);
}

}  // namespace
}  // namespace higherpair

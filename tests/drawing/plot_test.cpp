// Plots are read back: lines, marks and shading are where the table and the events put them.
#include "drawing/svg_reading.hpp"
#include "higherpair/drawing/printed_number.hpp"
#include "higherpair/front/pictures.hpp"
#include "higherpair/higherpair.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::all_shipped;
using testing::contains;
using testing::Element;
using testing::lines_are;
using testing::read_back;
using testing::shipped;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kHundredth = 0.011;  // px: coordinates in pictures are rounded to 0.01

// An axis as described by its attributes.
struct Axis {
  double low = 0, high = 1, begin = 0, end = 1;

  explicit Axis(const Element& element) {
    std::istringstream(element.attributes.at("data-domain")) >> low >> high;
    std::istringstream(element.attributes.at("data-range")) >> begin >> end;
  }
  [[nodiscard]] double px(double value) const { return begin + (value - low) / (high - low) * (end - begin); }
};

std::vector<Element> with_role(const std::vector<Element>& all, const std::string& role) {
  std::vector<Element> found;
  std::copy_if(all.begin(), all.end(), std::back_inserter(found),
               [&](const Element& element) { return element.role == role; });
  return found;
}

Axis axis(const std::vector<Element>& all, const std::string& name, const std::string& unit) {
  for (const Element& element : with_role(all, "axis")) {
    if (element.name == name && element.attributes.at("data-unit") == unit) return Axis(element);
  }
  ADD_FAILURE() << "no axis " << name << " in " << unit;
  return Axis(all.front());
}

Element series(const std::vector<Element>& all, const std::string& name) {
  for (const Element& element : with_role(all, "series")) {
    if (element.name == name) return element;
  }
  ADD_FAILURE() << "no line " << name;
  return {};
}

// The points of a path, with its pieces one after the other.
std::vector<Vector2d> points_of(const Element& path) {
  std::string text = path.attributes.at("d");
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == 'M' || c == 'L'; }, ' ');
  std::istringstream in(text);
  std::vector<Vector2d> points;
  for (double x = 0, y = 0; in >> x >> y;) points.emplace_back(x, y);
  return points;
}

MotionPlot plot(const Model& model, std::vector<std::string> y, std::optional<std::string> x = {}) {
  PlotSettings settings;
  settings.y = std::move(y);
  settings.x = std::move(x);
  auto made = plot_of(model, settings);
  EXPECT_TRUE(made) << to_string(made.error());
  return *made;
}

std::string error_of(const Model& model, std::vector<std::string> y, std::optional<std::string> x = {}) {
  PlotSettings settings;
  settings.y = std::move(y);
  settings.x = std::move(x);
  const auto made = plot_of(model, settings);
  return made ? "none" : to_string(made.error());
}

PlotData line(std::vector<double> x, std::vector<double> y, const std::string& unit = "mm") {
  PlotData data;
  data.title = "line";
  data.x = {"driver", "deg"};
  data.series.push_back({"y", unit, std::move(x), std::move(y)});
  return data;
}

TEST(Plot, DrawsEveryRowWhereTheTableHasIt) {
  const Model model = shipped("ellipse_cam_roller", {"driver.samples=37"});
  const auto drawn = read_back(plots_svg({plot(model, {"follower.angle", "follower.alpha"}).data}));
  const Motion motion = model.run().value();
  const ColumnValues driver = motion.column("driver");
  for (const char* name : {"follower.angle", "follower.alpha"}) {
    const ColumnValues values = motion.column(name);
    const auto points = points_of(series(drawn, name));
    const Axis x = axis(drawn, "x", "deg");
    const Axis y = axis(drawn, "y", std::string(values.unit));
    ASSERT_EQ(points.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(points[i].x(), x.px(driver[i]), kHundredth);
      EXPECT_NEAR(points[i].y(), y.px(values[i]), kHundredth);
    }
  }
}

// A line's points lie where the axis says, however small its values are.
TEST(Plot, SaysTheEndsOfItsAxesToManyDigits) {
  for (const double scale : {1.0, 1e-4, 1e-9, 1e9}) {
    const std::vector<double> values = {1.2345678 * scale, 1.3 * scale, 1.2777777 * scale};
    const auto drawn = read_back(plots_svg({line({0, 10, 20}, values)}));
    const Axis y = axis(drawn, "y", "mm");
    const auto points = points_of(series(drawn, "y"));
    ASSERT_EQ(points.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(points[i].y(), y.px(values[i]), kHundredth) << scale;
    }
  }
}

TEST(Plot, LeavesAGapWhereAValueIsUndefined) {
  const auto drawn = read_back(plots_svg({line({0, 10, 20, 30, 40}, {1, 2, kNaN, 4, 5})}));
  const std::string path = series(drawn, "y").attributes.at("d");
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
  EXPECT_EQ(points_of(series(drawn, "y")).size(), 4U);
}

// The pieces of a path.
std::vector<std::vector<Vector2d>> pieces_of(const Element& path) {
  std::vector<std::vector<Vector2d>> pieces;
  std::string d = path.attributes.at("d");
  for (std::size_t at = 0; at < d.size();) {
    const std::size_t next = std::min(d.find('M', at + 1), d.size());
    Element piece = path;
    piece.attributes["d"] = d.substr(at, next - at);
    pieces.push_back(points_of(piece));
    at = next;
  }
  return pieces;
}

TEST(Plot, HasADotForAPointThatIsJoinedToNoOther) {
  PlotData data = line({0, 10, 20, 30}, {1, kNaN, 3, 4});
  data.series[0].breaks = {3};
  const auto drawn = read_back(plots_svg({data}));
  const Axis x = axis(drawn, "x", "deg");
  const auto dots = with_role(drawn, "dot");
  ASSERT_EQ(dots.size(), 3U);
  EXPECT_NEAR(dots[1].number("cx"), x.px(20), kHundredth);
  EXPECT_EQ(series(drawn, "y").attributes.at("d").find('M', 1) != std::string::npos, true);
}

// On the line of action the sliding velocity is proportional to the distance from the pitch point, which
// grows evenly while one pair of teeth is in contact: in a plot it falls in every piece, and no line leads up
// from one pair to the next.
TEST(Plot, BreaksALineWhereTheContactGoesOnAtOtherTeeth) {
  const MotionPlot teeth = plot(shipped("gear_teeth"), {"mesh.sliding", "wheel.angle"});
  const auto drawn = read_back(plots_svg({teeth.data}));
  const auto pieces = pieces_of(series(drawn, "mesh.sliding"));
  EXPECT_EQ(pieces.size(), 6U);
  for (const auto& piece : pieces) {
    for (std::size_t i = 1; i < piece.size(); ++i) EXPECT_GT(piece[i].y(), piece[i - 1].y());  // y down
  }
  EXPECT_EQ(pieces_of(series(drawn, "wheel.angle")).size(), 1U);
}

constexpr const char* kCamWithNotch = R"(
[bodies.ground]
points.O1 = [0, 0]
points.O2 = [0, 0]

[bodies.cam]
points.O = [0, 0]

[bodies.cam.curves.outline]
type   = "chain"
fillet = 4
spans  = [
  { type = "arc", center = [0, 0], radius = 30, from = 60, to = 120 },
  { type = "segment", from = [-15, 25.980762113533157], to = [-30, 0] },
  { type = "arc", center = [-30, -10], radius = 10, from = -90, to = 90 },
  { type = "arc", center = [0, -20], radius = 30, from = 180, to = 360 },
  { type = "segment", from = [30, -20], to = [30, 0] },
  { type = "segment", from = [30, 0], to = [15, 25.980762113533157] },
]

[bodies.follower]
pose          = { x = 0, y = 45 }
points.P      = [0, 0]
curves.roller = { type = "circle", center = [0, 0], radius = 5 }

[joints]
pivot = { type = "revolute", between = ["ground.O1", "cam.O"] }
slide = { type = "prismatic", between = ["ground.O2", "follower.P"], direction = [0, 1] }

[contacts.touch]
between = ["cam.outline", "follower.roller"]

[driver]
joint    = "pivot"
end      = 360
samples  = 73
velocity = 360
)";

// Behind a limit position the motion is on another branch: the mark is at the end of the line that leads to
// it, also where x turns back.
TEST(Plot, BreaksALineAtALimitPosition) {
  const Model model = Model::from_text(kCamWithNotch).value();
  const MotionPlot made = plot(model, {"slide.velocity"}, "slide.position");
  const PlotSeries& velocity = made.data.series[0];
  const Motion motion = model.run().value();
  const auto limit = std::find_if(motion.events().begin(), motion.events().end(),
                                  [](const Event& event) { return event.type == EventType::kLimitPosition; });
  ASSERT_NE(limit, motion.events().end());
  const auto row = static_cast<std::size_t>(limit->row);
  EXPECT_THAT(velocity.breaks, ::testing::Contains(row));
  const auto mark =
      std::find_if(made.data.points.begin(), made.data.points.end(),
                   [](const PlotPoint& point) { return point.label.starts_with("limit position"); });
  ASSERT_NE(mark, made.data.points.end());
  EXPECT_EQ(mark->x, velocity.x[row - 1]);
  EXPECT_EQ(mark->y, velocity.y[row - 1]);
  // What does not jump is one line.
  EXPECT_THAT(plot(model, {"cam.angle"}).data.series[0].breaks, ::testing::IsEmpty());
}

TEST(Plot, KeepsAUnitWhosePowerIsNoNumber) {
  EXPECT_TRUE(contains(plots_svg({line({0, 1}, {0, 1}, "x^y")}), "x^y"));
  EXPECT_TRUE(contains(plots_svg({line({0, 1}, {0, 1}, "x^99999999999")}), "x^99999999999"));
  EXPECT_TRUE(contains(plots_svg({line({0, 1}, {0, 1}, "deg/s^-2")}), "deg/s⁻²"));
}

constexpr const char* kTinyFourBar = R"(
[units]
length = "m"
mass   = "kg"
[bodies.ground]
points.O2 = [0, 0]
points.O4 = [6e-5, 0]
[bodies.crank]
points.O2 = [0, 0]
points.A  = [2e-5, 0]
[bodies.coupler]
pose     = { x = 2e-5, y = 0, angle = 60 }
points.A = [0, 0]
points.B = [5e-5, 0]
[bodies.rocker]
pose      = { x = 6e-5, y = 0, angle = 100 }
points.O4 = [0, 0]
points.B  = [4.5e-5, 0]
[joints]
j1 = { type = "revolute", between = ["ground.O2", "crank.O2"] }
j2 = { type = "revolute", between = ["crank.A", "coupler.A"] }
j3 = { type = "revolute", between = ["coupler.B", "rocker.B"] }
j4 = { type = "revolute", between = ["ground.O4", "rocker.O4"] }
[driver]
joint    = "j1"
end      = 360
samples  = 73
velocity = 360
[loads]
push = { body = "rocker", point = "B", force = [-1e-8, 0] }
)";

// The torque on the crank of a mechanism of micrometres and nanonewtons is 1e-13 N m, and no rounding.
TEST(Plot, ShowsWhatIsTinyInItsUnit) {
  const Model model = Model::from_text(kTinyFourBar).value();
  const PlotSeries effort = plot(model, {"driver.effort"}).data.series[0];
  const double largest = *std::max_element(effort.y.begin(), effort.y.end());
  EXPECT_GT(largest, 1e-13);
  EXPECT_LT(largest, 1e-12);
  const auto drawn = read_back(plots_svg({plot(model, {"driver.effort"}).data}));
  const Axis y = axis(drawn, "y", "N*m");
  EXPECT_LT(y.px(-largest) - y.px(largest), 1e3);
  EXPECT_GT(y.px(-largest) - y.px(largest), 50);
}

TEST(Plot, ShowsWhatRoundingHasLeftOfNoughtAsNought) {
  const MotionPlot aside = plot(shipped("toggle_press"), {"ram.x"});
  const auto& x = aside.data.series[0].y;
  EXPECT_NE(*std::min_element(x.begin(), x.end()), *std::max_element(x.begin(), x.end()));
  const auto points = points_of(series(read_back(plots_svg({aside.data})), "ram.x"));
  for (const Vector2d& point : points) EXPECT_EQ(point.y(), points.front().y());
}

TEST(Plot, HasNoNumberThatIsNone) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const PlotData& data :
       {line({0, 1}, {kNaN, kNaN}), line({}, {}), line({kNaN, 1}, {1, 2}), line({0, 1}, {infinity, 1}),
        line({3, 3}, {7, 7}), PlotData{}, line({0, 1}, {1e308, -1e308}), line({-1e308, 1e308}, {0, 1})}) {
    PlotData marked = data;
    marked.marks = {{kNaN, "a", "b", ""}, {-infinity, "a", "b", ""}};
    marked.ranges = {{kNaN, 1, "r"}, {0, infinity, "r"}};
    marked.points = {{kNaN, 1, "mm", "p", "", ""}, {0, infinity, "mm", "p", "", ""}};
    for (const std::string& svg : {plots_svg({data}), plots_svg({marked}), plots_svg({data}, kNaN),
                                   plots_svg({data}, 0), plots_svg({data}, infinity)}) {
      EXPECT_FALSE(contains(svg, "nan"));
      EXPECT_FALSE(contains(svg, "inf"));
      EXPECT_NO_THROW(read_back(svg));
    }
  }
}

TEST(Plot, StacksPanelsByUnitInTheOrderAskedFor) {
  const Model model = shipped("ellipse_cam_roller", {"driver.samples=37"});
  const auto drawn =
      read_back(plots_svg({plot(model, {"follower.alpha", "follower.angle", "touch.pressure"}).data}));
  std::vector<std::string> units;
  for (const Element& panel : with_role(drawn, "panel")) units.push_back(panel.name);
  EXPECT_TRUE(lines_are(units, {"deg/s^2", "deg"}));
}

std::vector<std::string> labels_of_x(const std::string& svg) {
  std::vector<std::string> labels;
  bool inside = false;
  for (const Element& element : read_back(svg)) {
    if (element.role == "axis") inside = element.name == "x";
    const bool tick = element.tag == "text" && element.attributes.count("text-anchor") == 1;
    if (inside && tick && element.text.find('[') == std::string::npos) labels.push_back(element.text);
  }
  return labels;
}

TEST(PrintedNumber, HasAPowerOfTenOnlyWhereItIsLong) {
  EXPECT_EQ(printed_significant(40479.6, 4), "40480");
  EXPECT_EQ(printed_significant(1e6, 6), "1000000");
  EXPECT_EQ(printed_significant(9999999.6, 6), "1·10⁷");
  EXPECT_EQ(printed_significant(2.5e8, 6), "2.5·10⁸");
  EXPECT_EQ(printed_significant(-0.125, 6), "−0.125");
  EXPECT_EQ(printed_significant(1e-4, 6), "0.0001");
  EXPECT_EQ(printed_significant(7.4e-7, 6), "7.4·10⁻⁷");
  EXPECT_EQ(printed_significant(0, 6), "0");
}

TEST(Plot, HasTicksAtRoundNumbers) {
  EXPECT_TRUE(lines_are(labels_of_x(plots_svg({line({0, 360}, {0, 1})})),
                        {"0", "45", "90", "135", "180", "225", "270", "315", "360"}));
  EXPECT_TRUE(lines_are(labels_of_x(plots_svg({line({-7.25, 40}, {0, 1})})),
                        {"−5", "0", "5", "10", "15", "20", "25", "30", "35", "40"}));
  // Of many turns, at whole ones.
  EXPECT_TRUE(
      lines_are(labels_of_x(plots_svg({line({0, 7200}, {0, 1})})),
                {"0", "720", "1440", "2160", "2880", "3600", "4320", "5040", "5760", "6480", "7200"}));
  PlotData fine = line({0, 0.0031}, {0, 1});
  fine.x.unit = "mm";
  EXPECT_TRUE(contains(plots_svg({fine}), "×10⁻³ mm"));
}

TEST(Plot, OfAConstantIsAStraightLineAmidItsAxis) {
  const auto drawn = read_back(plots_svg({line({0, 10, 20}, {57.3, 57.3 + 1e-13, 57.3})}));
  const auto points = points_of(series(drawn, "y"));
  EXPECT_EQ(points[0].y(), points[1].y());
  const auto zero = read_back(plots_svg({line({0, 10, 20}, {0, 3e-14, -2e-14})}));
  EXPECT_EQ(points_of(series(zero, "y"))[0].y(), points_of(series(zero, "y"))[1].y());
}

TEST(Plot, MarksEventsAtTheirPlaces) {
  const Model model = shipped("ellipse_cam_roller");
  const auto drawn = read_back(plots_svg({plot(model, {"follower.angle"}).data}));
  const Motion motion = model.run().value();
  const Axis x = axis(drawn, "x", "deg");
  const auto marks = with_role(drawn, "event");
  ASSERT_EQ(marks.size(), motion.events().size());
  ASSERT_GE(marks.size(), 4U);
  std::size_t next = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i].role != "event") continue;
    EXPECT_EQ(drawn[i].name, "follower_pivot");
    EXPECT_TRUE(contains(drawn[i + 1].text, motion.events()[next].cause));
    EXPECT_NEAR(drawn[i + 2].number("x1"), x.px(motion.events()[next].driver), 1e-4);
    ++next;
  }
}

TEST(Plot, ShadesRowsThatAreNotOkBetweenTheLimits) {
  const MotionPlot locked = plot(shipped("lock_up"), {"follower.angle"});
  EXPECT_FALSE(locked.good);
  ASSERT_EQ(locked.data.ranges.size(), 1U);
  EXPECT_NEAR(locked.data.ranges[0].from, 65.83442067466342, 1e-9);
  const auto drawn = read_back(plots_svg({locked.data}));
  const Axis x = axis(drawn, "x", "deg");
  const auto shaded = with_role(drawn, "status");
  ASSERT_EQ(shaded.size(), 2U);  // the shaded range and its label
  EXPECT_EQ(shaded[0].name, "not assemblable");
  EXPECT_NEAR(shaded[0].number("x"), x.px(65.83442067466342), 1e-3);
  EXPECT_EQ(shaded[1].text, "not assemblable");
}

TEST(Plot, PutsEventsOnTheLineWhereXTurnsBack) {
  const MotionPlot curve = plot(shipped("straight_line"), {"coupler.P.y"}, "coupler.P.x");
  EXPECT_TRUE(curve.data.marks.empty());
  ASSERT_FALSE(curve.data.points.empty());
  const auto& xs = curve.data.series[0].x;
  for (const PlotPoint& point : curve.data.points) {
    EXPECT_GE(point.x, *std::min_element(xs.begin(), xs.end()));
    EXPECT_LE(point.x, *std::max_element(xs.begin(), xs.end()));
    EXPECT_EQ(point.unit, "cm");
  }
}

TEST(Plot, NamesRowsThatAreNotOkInWordsWhereXTurnsBack) {
  const MotionPlot locked = plot(shipped("lock_up"), {"touch.y"}, "touch.x");
  EXPECT_TRUE(locked.data.ranges.empty());
  ASSERT_EQ(locked.data.notes.size(), 1U);
  EXPECT_TRUE(contains(locked.data.notes[0], "not assemblable: driver from 66 to 294 deg"));
}

TEST(Plot, WorksOutForcesAndJerkWhereAColumnNeedsThem) {
  const Model model = shipped("cam_with_return_spring", {"driver.samples=13"});
  EXPECT_EQ(plot(model, {"driver.effort"}).data.series.size(), 1U);
  EXPECT_EQ(plot(model, {"follower.jerk"}).data.series.size() > 0, true);
}

TEST(Plot, RunsInTime) {
  PlotSettings settings;
  settings.y = {"slider.vx"};
  settings.run.in_time = true;
  const auto made = plot_of(shipped("sixbar_slider"), settings);
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(made->data.x.name, "time");
  EXPECT_EQ(made->data.x.unit, "s");
  EXPECT_NEAR(made->data.series[0].x.back(), 0.6, 1e-12);
}

TEST(Plot, RefusesWhatIsNoColumnOfNumbers) {
  const Model model = shipped("ellipse_cam_roller");
  EXPECT_TRUE(
      contains(error_of(model, {"follower.alfa"}), "setting y follower.alfa: no column of this run has"));
  EXPECT_TRUE(contains(error_of(model, {"follower.alfa"}), "did you mean `follower.alpha`"));
  EXPECT_TRUE(contains(error_of(model, {"driver"}, "touch.presure"), "setting x touch.presure: no column"));
  EXPECT_TRUE(contains(error_of(model, {"status"}), "setting y status: this column holds words"));
  EXPECT_TRUE(contains(error_of(model, {"driver"}, "status"), "setting x status: this column holds words"));
  EXPECT_TRUE(contains(error_of(model, {"driver"}, "follower.*"), "expected the name of one column"));
  EXPECT_TRUE(contains(error_of(model, {}), "setting y: names no column"));
}

TEST(Plot, EscapesWhatNamesHold) {
  PlotData data = line({0, 1}, {0, 1});
  data.title = "<script>alert(\"&\")</script>";
  data.series[0].name = "a<b\x01";
  const std::string svg = plots_svg({data});
  EXPECT_FALSE(contains(svg, "<script"));
  EXPECT_EQ(read_back(svg)[1].text, data.title);
}

TEST(Plot, BreaksALongTitleBeforeTheMargin) {
  PlotData data = line({0, 1}, {0, 1});
  data.title =
      "A very long title that a person may well give to a mechanism, about offsets and base circles of a "
      "disc cam with a roller follower";
  int lines = 0;
  for (const Element& element : read_back(plots_svg({data}, 720))) {
    const auto kind = element.attributes.find("class");
    if (kind == element.attributes.end() || kind->second != "title") continue;
    ++lines;
    const double mean_letter = 8.3;  // of bold DejaVu Sans at 13 px
    EXPECT_LE(element.number("x") + mean_letter * static_cast<double>(element.text.size()), 720)
        << element.text;
  }
  EXPECT_EQ(lines, 2);
}

TEST(Plot, LeavesOutPointsThatLieOnEachOther) {
  std::vector<double> x, y;
  for (int i = 0; i < 200'000; ++i) {
    x.push_back(i * 0.0018);
    y.push_back(std::sin(x.back() / 57));
  }
  const std::string svg = plots_svg({line(x, y)});
  EXPECT_LT(svg.size(), 80'000U);
  const auto points = points_of(series(read_back(svg), "y"));
  EXPECT_NEAR(points.back().x(), axis(read_back(svg), "x", "deg").px(x.back()), kHundredth);
}

// The boxes of a plot's labels, with at least the width of Helvetica, do not overlap.
TEST(Plot, OfEveryShippedProfileHasNoLabelOnAnother) {
  struct Box {
    double left, right, y;
  };
  for (const std::string& name : all_shipped()) {
    const auto made = plot_of(shipped(name), {{"*.position", "*.omega"}, {}, {}});
    if (!made) continue;  // a mechanism without motion or without such columns
    std::vector<Box> boxes;
    for (const Element& element : read_back(plots_svg({made->data}))) {
      if (element.tag != "text" || element.text.empty()) continue;
      const double width = 5.5 * static_cast<double>(element.text.size());
      const auto anchor = element.attributes.count("text-anchor") ? element.attributes.at("text-anchor") : "";
      const double left = element.number("x") - (anchor == "end"      ? width
                                                 : anchor == "middle" ? width / 2
                                                                      : 0);
      boxes.push_back({left, left + width, element.number("y")});
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const bool apart = boxes[i].right <= boxes[k].left || boxes[k].right <= boxes[i].left ||
                           std::abs(boxes[i].y - boxes[k].y) >= 11;
        EXPECT_TRUE(apart) << name << ": labels at " << boxes[i].left << ' ' << boxes[i].y << " and "
                           << boxes[k].left << ' ' << boxes[k].y;
      }
    }
  }
}

// Neither beyond the edge on the right nor, where there is no room on the left either, on that side.
TEST(Plot, ShortensLabelsThatHaveNoRoom) {
  PlotData data;
  data.x = {"driver", "deg"};
  data.series.push_back({"angle", "deg", {0, 100}, {0, 1}});
  const std::string label = "stroke end: " + std::string(200, 'g');
  for (const double x : {10., 50., 95.}) data.marks.push_back({x, label, "g", label});
  const auto drawn = read_back(plots_svg({data}));
  const double width = drawn.front().number("width");
  int labels = 0;
  for (const Element& element : drawn) {
    if (element.tag != "text" || element.text.find("stroke end") == std::string::npos) continue;
    const double x = element.number("x"), length = 6 * static_cast<double>(element.text.size());
    const bool left = element.attributes.at("text-anchor") == "end";
    EXPECT_GE(left ? x - length : x, 0);
    EXPECT_LE(left ? x : x + length, width);
    EXPECT_TRUE(contains(element.text, "…"));
    ++labels;
  }
  EXPECT_EQ(labels, 3);
}

TEST(MapPlot, HasTheBranchesAndFoldsOfTheMap) {
  const MapReport map = map_of(shipped("lock_up")).value();
  const auto plots = plots_of(map);
  ASSERT_EQ(plots.size(), 1U);
  const ContactMapReport& contact = map.contacts[0];
  const auto drawn = read_back(plots_svg(plots));
  const Axis x = axis(drawn, "x", "deg");
  const Axis y = axis(drawn, "y", "deg");
  ASSERT_EQ(plots[0].points.size(), contact.events.size() + 1);
  for (std::size_t i = 0; i < contact.events.size(); ++i) {
    EXPECT_EQ(plots[0].points[i].x, contact.events[i].at.driver);
    EXPECT_EQ(plots[0].points[i].y, contact.events[i].at.position);
  }
  const auto own = std::find_if(plots[0].series.begin(), plots[0].series.end(),
                                [](const PlotSeries& line) { return line.line == PlotLine::kEmphasis; });
  ASSERT_NE(own, plots[0].series.end());
  const MapBranchReport& branch = contact.branches[contact.own->branch - 1];
  const auto points = points_of(series(drawn, own->name));
  EXPECT_NEAR(points.front().x(), x.px(branch.rows.front().driver), kHundredth);
  EXPECT_NEAR(points.back().y(), y.px(branch.rows.back().position), kHundredth);
}

}  // namespace
}  // namespace higherpair

#pragma once

#include "higherpair/geometry/pose.hpp"

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

// Pictures as plain data and as SVG: scenes of a mechanism, plots, and polygons of velocities, accelerations
// and forces.

/// How a body, or one of its points or curves, is drawn if not by default.
struct Look {
  std::string name;      ///< name shown in the picture; empty: its own
  std::string colour;    ///< of its fill, or of a point's trace, "#rrggbb" or "#rgb"; empty: the default
  bool hide = false;     ///< not drawn; for a point: neither its name nor its trace
  bool outline = false;  ///< drawn as a line, not filled
};

struct BodyLook {
  Look body;
  std::vector<Look> points;  ///< one for each of Body::points
  std::vector<Look> curves;  ///< one for each of Body::curves
};

/// One for each of Mechanism::bodies; empty: all are drawn by default.
using Looks = std::vector<BodyLook>;

/// Lengths of scenes are in millimetres.
inline constexpr double kMillimetresPerMetre = 1000;

/// What a shape shows. The names are those of `data-role` in SVG and of the layers in draw and report.
enum class Role {  // in drawing order, later ones on top
  kLink,           ///< bars and plates between the points of a body
  kBody,           ///< a body within its curves
  kGear,           ///< pitch circles of gears and belts
  kSpring,         ///< springs and dampers
  kFixed,          ///< symbols of what is fixed
  kJoint,          ///< pins, slides, slots
  kCurvature,      ///< osculating circles and their centres
  kTangent,        ///< common tangent
  kNormal,         ///< common normal
  kLinkage,        ///< the equivalent linkage
  kContact,        ///< the touching point
  kCenter,         ///< instant centres; of those outside of the frame arrows at its edge
  kTrace,          ///< path of a point
  kVelocity,       ///< arrows
  kAcceleration,   ///< arrows
  kForce,          ///< arrows: forces of joints and contacts on their second bodies, and the drivers' effort
  kDriver,         ///< arrows in the sense of the drivers
  kLabel,          ///< names
};
inline constexpr int kRoleCount = 18;

/// "body"; "linkage" for the equivalent linkage, …
[[nodiscard]] std::string_view name_of(Role role);
[[nodiscard]] std::optional<Role> role_of(std::string_view name);

/// One shape of a drawing.
struct Shape {
  enum class Kind {
    kPath,    ///< points x, y, x, y, …; filled if `closed`. Separate pieces are divided by two NaN
    kCircle,  ///< center x, y, radius
    kArrow,   ///< from x, y to x, y
    kText,  ///< position x, y, then the direction x, y in which the text is offset from it; a fifth number is
            ///< the value [mm] of a length that the text names
  };
  Role role = Role::kBody;
  Kind kind = Kind::kPath;
  std::string name;             ///< of the body, joint, contact or point: "cam", "touch", "coupler.P"
  int body = 0;                 ///< the body in whose frame the numbers are; 0: ground
  bool closed = false;          ///< of a path
  std::string text;             ///< of kText; else what a pointer on the shape is told, if anything
  std::vector<double> numbers;  ///< [mm]; empty where it is not defined in this row
  std::string colour;           ///< of its fill or line, "#rrggbb"; empty: that of its role
  bool outline = false;         ///< not filled although closed
};

/// An upright rectangle [mm].
struct Box {
  Vector2d low = Vector2d::Zero(), high = Vector2d::Zero();

  [[nodiscard]] Vector2d size() const { return high - low; }
  /// The smallest box that contains both.
  [[nodiscard]] Box joined(const Box& other) const {
    return {low.cwiseMin(other.low), high.cwiseMax(other.high)};
  }
};

/// A mechanism as a picture shows it: shapes that are fixed in the frames of their bodies, the poses of these
/// frames, and shapes that change from row to row, in ground.
struct Scene {
  struct Place {
    double x = 0, y = 0, theta = 0;  ///< of a body's frame [mm, rad]
  };
  struct Room {
    Role role = Role::kVelocity;
    Box box;
  };
  Box view;  ///< contains everything that moves, over the whole motion; links of equivalent linkages that
             ///< leave it are drawn broken off
  std::vector<Room> rooms;    ///< for the arrows of these layers, over the whole motion, where they are drawn
  double unit = 1;            ///< unit of length of symbols [mm]: a pin has the radius 1
  double velocity_scale = 0;  ///< arrow length per velocity [mm/(mm/s)]; 0: nothing moves
  double acceleration_scale = 0;  ///< the same for an acceleration [mm/(mm/s²)]
  double force_scale = 0;         ///< the same for a force [mm/N]; 0: there are none
  double torque_scale = 0;        ///< angle of the arc per driving torque [rad/(N m)]; 0: there are none
  std::vector<Shape> fixed;       ///< drawn in this order, the ground first
  std::deque<Shape> moving;       ///< drawn after them; references hold while others are added
  bool defined = true;            ///< false: the row has no position
  std::vector<Place> places;      ///< one for each of Mechanism::bodies
  std::string caption;            ///< written below it: "driver = 45 deg"
};

/// A unit used in a picture: its name as in tables, and its value in SI units.
struct PictureUnit {
  std::string name;
  double si = 1;
};

/// Widths, heights and units that are not finite and > 0 count as those given here.
struct DrawSettings {
  std::vector<Role> layers;  ///< empty: default_layers()
  double width = 900;        ///< of the picture, or of each picture of a strip [px]
  /// Largest height, scale bars excluded; a higher picture is drawn narrower [px].
  double most_height = 1000;
  bool strip = false;  ///< several scenes side by side, many of them in several lines, not one over the other
  PictureUnit length{"mm", 1e-3};  ///< unit of `data-scale` and the scale bar
  PictureUnit velocity{"mm/s", 1e-3};
  PictureUnit acceleration{"mm/s^2", 1e-3};
  PictureUnit force{"N", 1};
  PictureUnit torque{"N*m", 1};
  std::vector<Vector2d> targets;  ///< points marked by small circles, in ground [mm]
  std::string title;              ///< for screen readers
};

/// The layers drawn if none are named: all but velocities, accelerations, forces and instant centres.
[[nodiscard]] std::vector<Role> default_layers();

/// A picture of a mechanism as SVG. The last scene is drawn in full, those before it as ghosts, or all side
/// by side; below them are the scales of lengths and arrows. Every element carries data-role and data-name;
/// the top element data-scale (px per unit of length) and data-origin (px of ground's origin), y up.
/// \pre  at least one scene, all from one call of scenes_of()
[[nodiscard]] std::string draw_svg(std::span<const Scene> scenes, const DrawSettings& settings);

// A plot as plain data, and its picture. Numbers are in the units that are named beside them; NaN is
// undefined and leaves a gap, and so does what is beyond 1e150. Marks, points and ranges there are left out.

struct PlotAxis {
  std::string name;  ///< "driver"
  std::string unit;  ///< as in tables: "deg/s^2"; "1" or empty: a pure number
};

/// How a line is drawn.
enum class PlotLine {
  kOwn,       ///< in a colour and a dash pattern of its own
  kEmphasis,  ///< the one to look at
  kFaint,     ///< in the background
};

/// A line. Those of one unit share a panel; panels are stacked in the order of their first lines.
struct PlotSeries {
  std::string name;
  std::string unit;
  std::vector<double> x;
  std::vector<double> y;  ///< as many as x
  PlotLine line = PlotLine::kOwn;
  std::vector<std::size_t> breaks =
      {};                ///< points that no line joins to the point before, in ascending order
  double noise = 1e-10;  ///< where all values are within this of 0 the line is one at 0 [unit]
};

/// An event at x, in all panels: a thin vertical line with a label.
struct PlotMark {
  double x = 0;
  std::string label;   ///< short
  std::string name;    ///< the item that the event concerns, for data-name
  std::string detail;  ///< a sentence, shown where a pointer rests on the mark
};

/// An event at a point of the panel of `unit`: a small circle with a label.
struct PlotPoint {
  double x = 0;
  double y = 0;
  std::string unit;
  std::string label;
  std::string name;
  std::string detail;
};

/// A range of x that is shaded and named.
struct PlotRange {
  double from = 0;
  double to = 0;
  std::string label;
};

struct PlotData {
  std::string title;
  PlotAxis x;
  std::string y_name;  ///< quantity that all series show; empty: given by their names
  std::vector<PlotSeries> series;
  std::vector<PlotMark> marks;
  std::vector<PlotPoint> points;
  std::vector<PlotRange> ranges;
  std::vector<std::string> notes;  ///< lines of text below the plot
};

/// The plots as one SVG picture, one below the other. Elements carry data-role (`axis`, `tick`, `series`,
/// `event`, `status`) and data-name; each axis carries data-domain, its two ends in its unit, and data-range,
/// the same in px, so that what is drawn can be read back.
/// \param width  [px], from 200 to 100,000; another one counts as the nearest of them
[[nodiscard]] std::string plots_svg(const std::vector<PlotData>& plots, double width = 720);

// Velocity, acceleration and force polygons of one row, as textbooks draw them. In names `_{…}` is a
// subscript and `^{…}` a superscript: "a_{BA}^{n}".

/// An arrow of a polygon.
struct PolygonArrow {
  enum class Kind {
    kAbsolute,    ///< from the pole
    kRelative,    ///< between two points of one body, or the ends of an equivalent link
    kNormal,      ///< normal part of a relative acceleration, towards the other point: -ω² r
    kTangential,  ///< tangential part of it: α ẑ×r
    kSliding,     ///< along a slide, relative to its guide
    kCoriolis,    ///< 2 ω ẑ×v, v being the velocity of sliding
    kForce,
  };
  Kind kind = Kind::kAbsolute;
  std::string name;  ///< "v_{BA}"
  std::string item;  ///< its name in tables: "link3.B", "link3.B/link3.A", a joint, contact, load or spring
  Vector2d from = Vector2d::Zero();
  Vector2d to = Vector2d::Zero();
};

struct PolygonPoint {
  std::string name;  ///< "b"
  Vector2d at = Vector2d::Zero();
};

struct Polygon {
  enum class Kind { kVelocity, kAcceleration, kForce };
  Kind kind = Kind::kVelocity;
  std::string title;  ///< for a force polygon the body's name
  std::string unit;   ///< of all vectors; empty: SI
  std::string pole;   ///< its name, "o_{v}" or "o_{a}"; empty for forces
  std::vector<PolygonPoint> points;
  std::vector<PolygonArrow> arrows;
  std::vector<std::string> equations;
  std::vector<std::string> notes;  ///< why something is missing
};

/// The polygons one below the other as an SVG picture, each to the largest scale that fits, with a scale
/// bar, its equations and the values of its arrows. Elements carry data-role (`velocity`, `acceleration`,
/// `force`, `label`) and data-name; the group of a polygon carries data-scale (px per unit) and data-origin
/// ("x y" in px of the pole, y up).
/// \param width  [px], from 200 to 100,000; another one counts as the nearest of them
[[nodiscard]] std::string polygons_svg(const std::vector<Polygon>& polygons, const std::string& title,
                                       double width = 860);

}  // namespace higherpair

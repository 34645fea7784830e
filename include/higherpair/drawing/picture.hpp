#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

// Pictures as plain data and as SVG: scenes of a mechanism, plots, and polygons of velocities, accelerations
// and forces.

/// How a body, or a point or curve of it, is drawn where not as usual.
struct Look {
  std::string name;      ///< in the picture; empty: its own
  std::string colour;    ///< "#rrggbb" or "#rgb": what fills it, of a point its trace; empty: the usual one
  bool hide = false;     ///< not drawn; a point's name and trace
  bool outline = false;  ///< a line, not filled
};

struct BodyLook {
  Look body;
  std::vector<Look> points;  ///< of Body::points
  std::vector<Look> curves;  ///< of Body::curves
};

/// Of Mechanism::bodies; empty: all are drawn as usual.
using Looks = std::vector<BodyLook>;

/// Lengths of scenes are in millimetres: so many are a metre.
inline constexpr double kMillimetres = 1000;

/// What a shape shows. The names are those of `data-role` in SVG and of the layers in draw and report.
enum class Role {  // in the order in which they are drawn, one over the other
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
  kCenter,         ///< instant centres
  kTrace,          ///< path of a point
  kVelocity,       ///< arrows
  kAcceleration,   ///< arrows
  kForce,          ///< arrows: what joints and contacts do to their second bodies, and the drivers' effort
  kLabel,          ///< names
};
inline constexpr int kRoleCount = 17;

/// "body", "equivalent linkage" is "linkage", …
[[nodiscard]] std::string_view name_of(Role role);
[[nodiscard]] std::optional<Role> role_of(std::string_view name);

/// One shape of a drawing.
struct Shape {
  enum class Kind {
    kPath,    ///< points x, y, x, y, …; `closed`: filled. Pieces apart are separated by two NaN
    kCircle,  ///< center x, y, radius
    kArrow,   ///< from x, y to x, y
    kText,    ///< at x, y, and the direction x, y in which it keeps clear of it; with a fifth number
              ///< its text is the name of a length [mm], which is that number
  };
  Role role = Role::kBody;
  Kind kind = Kind::kPath;
  std::string name;             ///< of the body, joint, contact or point: "cam", "touch", "coupler.P"
  int body = 0;                 ///< whose frame the numbers are in; 0: ground
  bool closed = false;          ///< of a path
  std::string text;             ///< of kText
  std::vector<double> numbers;  ///< [mm]; empty where it is not defined in this row
  std::string colour;           ///< "#rrggbb" that fills it, or of its line; empty: that of its role
  bool outline = false;         ///< not filled although closed
};

/// An upright rectangle [mm].
struct Box {
  Vector2d low = Vector2d::Zero(), high = Vector2d::Zero();

  [[nodiscard]] Vector2d size() const { return high - low; }
};

/// A mechanism as a picture shows it: shapes that never change in the frames of their bodies, where these
/// are, and shapes that are another in every row, in ground.
struct Scene {
  struct Place {
    double x = 0, y = 0, theta = 0;  ///< of a body's frame [mm, rad]
  };
  Box view;  ///< holds all that moves, over the whole motion; links of equivalent linkages that leave it are
             ///< broken off
  double unit = 1;                ///< [mm] in which symbols are drawn: a pin has the radius 1
  double velocity_scale = 0;      ///< length of an arrow for a velocity [mm/(mm/s)]; 0: nothing moves
  double acceleration_scale = 0;  ///< the same for an acceleration [mm/(mm/s²)]
  double force_scale = 0;         ///< the same for a force [mm/N]; 0: there are none
  double torque_scale = 0;        ///< turn of the arc for a driving torque [rad/(N m)]; 0: there are none
  std::vector<Shape> fixed;       ///< drawn in this order, the ground first
  std::vector<Shape> moving;      ///< drawn after them
  bool defined = true;            ///< false: the row has no position
  std::vector<Place> places;      ///< of Mechanism::bodies
};

/// A unit of a picture: its name as tables have it, and what it is in SI units.
struct PictureUnit {
  std::string name;
  double si = 1;
};

struct DrawSettings {
  std::vector<Role> layers;        ///< empty: all but motion, forces and instant centres
  double width = 900;              ///< of the picture, or of each picture of a strip [px]
  double most_height = 1000;       ///< without scales: what would be higher is drawn narrower [px]
  bool strip = false;              ///< several scenes side by side, not one over the other
  PictureUnit length{"mm", 1e-3};  ///< of `data-scale` and the scale bar
  PictureUnit velocity{"mm/s", 1e-3};
  PictureUnit acceleration{"mm/s^2", 1e-3};
  PictureUnit force{"N", 1};
  PictureUnit torque{"N*m", 1};
  std::string title;  ///< for screen readers
};

/// The layers of a picture where none are named.
[[nodiscard]] std::vector<Role> default_layers();

/// A picture of a mechanism as SVG. The last scene is drawn whole, those before it as ghosts, or all side by
/// side; below them the scales of lengths and arrows. Every element carries data-role and data-name; the top
/// element data-scale (px per unit of length) and data-origin (px of ground's origin), y up.
/// \pre  at least one scene, all of one SceneMaker
[[nodiscard]] std::string draw_svg(std::span<const Scene> scenes, const DrawSettings& settings);

// A plot as plain data, and its picture. Numbers are in the units that are named beside them; NaN is
// undefined and leaves a gap.

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
  std::vector<double> y;  ///< as many
  PlotLine line = PlotLine::kOwn;
};

/// Something that happens at x, in all panels: a thin vertical line with a label.
struct PlotMark {
  double x = 0;
  std::string label;   ///< short
  std::string name;    ///< what it happens at, for data-name
  std::string detail;  ///< a sentence, shown where a pointer rests on the mark
};

/// Something that happens at a point of the panel of `unit`: a small circle with a label.
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
  std::string y_name;  ///< of the quantity that all series show; empty: their names say it
  std::vector<PlotSeries> series;
  std::vector<PlotMark> marks;
  std::vector<PlotPoint> points;
  std::vector<PlotRange> ranges;
  std::vector<std::string> notes;  ///< lines of text below the plot
};

/// The plots as one SVG picture, one below the other. Elements carry data-role (`axis`, `tick`, `series`,
/// `event`, `status`) and data-name; each axis carries data-domain, its two ends in its unit, and data-range,
/// the same in px, so that what is drawn can be read back.
/// \param width  [px], at least 200
[[nodiscard]] std::string plots_svg(const std::vector<PlotData>& plots, double width = 720);

// Velocity, acceleration and force polygons of one row, as textbooks draw them. In names `_{…}` is lowered
// and `^{…}` raised text: "a_{BA}^{n}".

/// An arrow of a polygon.
struct PolygonArrow {
  enum class Kind {
    kAbsolute,    ///< from the pole
    kRelative,    ///< of two points of one body, or of the ends of an equivalent link
    kNormal,      ///< its part towards the other point: -ω² r
    kTangential,  ///< the rest of it: α ẑ×r
    kSliding,     ///< along a slide, seen from its guide
    kCoriolis,    ///< 2 ω ẑ×v of the sliding
    kForce,
  };
  Kind kind = Kind::kAbsolute;
  std::string name;  ///< "v_{BA}"
  std::string item;  ///< what tables call it: "link3.B", "link3.B/link3.A", a joint, contact, load or spring
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
  std::string title;  ///< of a force polygon the body's name
  std::string unit;   ///< of all vectors; empty: SI
  std::vector<PolygonPoint> points;
  std::vector<PolygonArrow> arrows;
  std::vector<std::string> equations;
  std::vector<std::string> notes;  ///< why something is missing
};

/// Converts a polygon to another unit.
void convert(Polygon& polygon, double factor, const std::string& unit);

/// The polygons one below the other as an SVG picture, each to the largest scale that fits, with a scale
/// bar, its equations and the values of its arrows. Elements carry data-role (`velocity`, `acceleration`,
/// `force`, `label`) and data-name; the group of a polygon carries data-scale (px per unit) and data-origin
/// ("x y" in px of the pole, y up).
[[nodiscard]] std::string polygons_svg(const std::vector<Polygon>& polygons, const std::string& title,
                                       double width = 860);

}  // namespace higherpair

#pragma once

#include "higherpair/analysis/row.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/mechanism/description.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

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

/// Whether bodies have a place in the row, as its table has: also where that is not to be trusted.
[[nodiscard]] bool has_place(const MotionRow& row);

/// Makes the scenes of one mechanism, row by row.
class SceneMaker {
public:
  /// \param mechanism  outlives the maker
  /// \param rows    of a motion, at least one with a position: how much room the picture needs, and how far
  ///                slides and contacts travel
  /// \param traces  points whose paths are drawn, besides those that are joined to nothing
  /// \param reactions  in the same rows; empty: no forces are drawn
  SceneMaker(const Mechanism& mechanism, const std::vector<MotionRow>& rows,
             const std::vector<PointRef>& traces = {}, const std::vector<Reactions>& reactions = {},
             const Looks& looks = {});

  /// The scene of the row given last; at first of the first one that has a place.
  [[nodiscard]] const Scene& scene() const { return scene_; }

  /// The scene of a row; the reference holds until the next call.
  /// \param reactions  in this row, where the maker has any; none: forces are left out
  const Scene& at(const MotionRow& row, const Reactions* reactions = nullptr);

private:
  const Mechanism* mechanism_;
  Scene scene_;
  double largest_ = 1;  // circle that is drawn [mm]
  bool forces_ = false;
  std::size_t next_ = 0;  // of scene_.moving, while it is filled

  Shape& next(Role role, const std::string& name, Shape::Kind kind, bool closed = false);
  void add_contact(const MotionRow& row, std::size_t index);
  void add_linkage(const MotionRow& row, std::size_t index);
  void add_spring(const MotionRow& row, const Spring& spring);
  void add_belt(const MotionRow& row, const Joint& joint);
  void add_motion(const MotionRow& row, int body);
  void add_forces(const MotionRow& row, const Reactions& reactions);
  void add_effort(const MotionRow& row, const Driver& driver, double effort);
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

}  // namespace higherpair

#pragma once

#include "higherpair/analysis/row.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/mechanism/description.hpp"

#include <string>
#include <vector>

namespace higherpair {

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

/// The velocities of the joints' points and of the centres of curvature of contacts: from the pole (0, 0) an
/// arrow to each, and between those of one body, or of one equivalent link, their relative velocity. A point
/// that slides along a moving body is compared with the point of that body where it is just then (A′).
/// Without arrows, but with a note, where the rates are not defined.
[[nodiscard]] Polygon velocity_polygon(const Mechanism& mechanism, const MotionRow& row);

/// The accelerations of the same points, those of joints also in their normal and tangential parts, those
/// along a slide with Coriolis' acceleration.
[[nodiscard]] Polygon acceleration_polygon(const Mechanism& mechanism, const MotionRow& row);

/// Of every moving body all forces on it head to tail: weight, inertia, loads, springs, driving forces, then
/// joints and contacts. They close. A body on which no force acts has none; where the balance does not
/// determine a force, a note says so.
[[nodiscard]] std::vector<Polygon> force_polygons(const Mechanism& mechanism, const MotionRow& row,
                                                  const Reactions& reactions);

/// The same in another unit.
void convert(Polygon& polygon, double factor, const std::string& unit);

/// The polygons one below the other as an SVG picture, each to the largest scale that fits, with a scale
/// bar, its equations and the values of its arrows. Elements carry data-role (`velocity`, `acceleration`,
/// `force`, `label`) and data-name; the group of a polygon carries data-scale (px per unit) and data-origin
/// ("x y" in px of the pole, y up).
[[nodiscard]] std::string polygons_svg(const std::vector<Polygon>& polygons, const std::string& title,
                                       double width = 860);

}  // namespace higherpair

#pragma once

#include "draw.hpp"
#include "higherpair/contact/contact_pair.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace higherpair::fire {

/// A curve, by the numbers that describe it in a profile; lengths [m], angles [rad].
struct Shape {
  CurveKind kind = CurveKind::kPoint;
  Side side = Side::kInside;
  double x = 0, y = 0;  ///< centre, vertex, a point of the line, the point itself
  double a = 1, b = 1;  ///< radius, semi-axes, focal length
  double angle = 0;     ///< rotation; for a line the direction of its outward normal
};

/// A joint to ground.
struct Mount {
  bool turns = true;
  double x = 0, y = 0;    ///< pivot, or the point of the slide's line at coordinate 0, in ground
  double bx = 0, by = 0;  ///< the body's point there, in its frame
  double direction = 0;   ///< direction of the slide
  double theta = 0;       ///< angle of the sliding body
};

/// A four-bar that turns body 1: a crank about (x, y), whose end is joined by a rod to the point (cx, cy) of
/// body 1.
struct Crank {
  double x = 0, y = 0;
  double length = 1, angle = 0;
  double cx = 0, cy = 0;
};

/// One trial: curves of a driver and a follower, their start and their range of motion.
struct Case {
  Shape curve1, curve2;
  Mount mount1, mount2;
  std::optional<Crank> crank;
  double u = 0, q = 0;  ///< start coordinates of the bodies; the follower's is approximate
  double step = 0.03;   ///< step of u, or of the crank's angle if there is one
  int rows = 60;
};

/// Random cases with all kinds of curves, sides, joints and sizes; a seed gives the same cases on every
/// machine.
class Cases : private Draw {
public:
  explicit Cases(std::uint64_t seed) : Draw(seed) {}
  [[nodiscard]] Case next();

private:
  Shape shape(int kind, bool ring);
  Mount mount();
  void make_conforming(Case& one);
  void make_singular(Case& one);
  void make_parallel(Case& one);
  void move_beside_limit(Case& one);
};

/// A curve as written in a profile, with all digits.
[[nodiscard]] std::string curve_text(const Shape& shape);

/// The numbers of a case that appear in its profile, to be changed one by one.
[[nodiscard]] std::vector<double*> numbers(Case& one);

/// The pair of curves; none if the numbers describe no valid curve.
[[nodiscard]] std::optional<ContactPair> pair_of(const Case& one);

/// A profile that describes the case, with all digits.
[[nodiscard]] std::string profile_of(const Case& one, const std::string& title);

}  // namespace higherpair::fire

#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace higherpair::fire {

/// A curve by the numbers that a profile gives it; lengths [m], angles [rad].
struct Shape {
  CurveKind kind = CurveKind::kPoint;
  Side side = Side::kInside;
  double x = 0, y = 0;  ///< centre, vertex, a point of the line, the point itself
  double a = 1, b = 1;  ///< radius, semi-axes, focal length
  double angle = 0;     ///< rotation; of a line: of its outward normal
};

/// A joint to ground.
struct Mount {
  bool turns = true;
  double x = 0, y = 0;    ///< pivot, or the point of the slide's line at coordinate 0, in ground
  double bx = 0, by = 0;  ///< the body's point there
  double direction = 0;   ///< of the slide
  double theta = 0;       ///< of the sliding body
};

/// A four-bar that turns body 1: crank about (x, y), its end joined to the point (cx, cy) of body 1.
struct Crank {
  double x = 0, y = 0;
  double length = 1, angle = 0;
  double cx = 0, cy = 0;
};

/// One trial: a driver's curve and a follower's, where they start and how far they go.
struct Case {
  Shape curve1, curve2;
  Mount mount1, mount2;
  std::optional<Crank> crank;
  double u = 0, q = 0;  ///< coordinates of the two bodies at the start, that of the follower roughly
  double step = 0.03;   ///< of u; with a crank of its angle
  int rows = 60;
};

/// Random cases of all kinds of curves, sides, joints and sizes; the same for a seed on every machine.
class Cases {
public:
  explicit Cases(std::uint64_t seed) : engine_(seed) {}
  [[nodiscard]] Case next();

private:
  double between(double low, double high);
  int pick(int count);
  Shape shape(int kind, bool ring);
  Mount mount();
  void make_conforming(Case& one);
  void make_singular(Case& one);
  void make_parallel(Case& one);
  void move_beside_limit(Case& one);

  std::mt19937_64 engine_;
};

/// A curve as a profile writes it, numbers to the last digit.
[[nodiscard]] std::string curve_text(const Shape& shape);

/// The numbers of a case that a profile shows, to be changed one by one.
[[nodiscard]] std::vector<double*> numbers(Case& one);

/// The pair of curves; none where the numbers describe no curve.
[[nodiscard]] std::optional<ContactPair> pair_of(const Case& one);

/// A profile that describes the case, numbers to the last digit.
[[nodiscard]] std::string profile_of(const Case& one, const std::string& title);

}  // namespace higherpair::fire

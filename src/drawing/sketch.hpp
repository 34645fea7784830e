#pragma once

#include "higherpair/analysis/row.hpp"
#include "higherpair/drawing/picture.hpp"
#include "higherpair/drawing/scene_maker.hpp"
#include "higherpair/dynamics/reactions.hpp"

#include <array>
#include <optional>
#include <vector>

namespace higherpair {

// Sizes of symbols [units].
inline constexpr double kPinRadius = 1;
inline constexpr double kSlotHalf = 1.35;  // half the width of a slot

/// The input and the result of making the shapes of a mechanism; lengths in metres.
struct Sketch {
  const Mechanism& mechanism;
  std::vector<const MotionRow*> rows;  ///< those in which the positions are defined
  double unit = 1;                     ///< length unit of symbols [m]
  std::vector<Shape> shapes;           ///< made so far, in metres
  const Looks& looks;

  /// The look of a body, and of a point or curve of it.
  [[nodiscard]] Look look(int body) const;
  [[nodiscard]] Look point_look(int body, std::size_t point) const;
  [[nodiscard]] Look curve_look(int body, std::size_t curve) const;
  /// Gives this look to all shapes from index `first` on.
  void dress(std::size_t first, const Look& look);

  Shape& add(Role role, const std::string& name, int body, std::vector<double> numbers, bool closed = false,
             Shape::Kind kind = Shape::Kind::kPath);
  void add_circle(Role role, const std::string& name, int body, const Vector2d& center, double radius);
  void add_text(const std::string& name, const std::string& text, int body, const Vector2d& at,
                const Vector2d& away);
};

/// Smallest and largest coordinate of a slide or slot in the rows [m].
[[nodiscard]] std::array<double, 2> travelled_range(const Sketch& sketch, const Joint& joint);

/// The ends of the rail of a block, or of a slot, as coordinates along it [m].
[[nodiscard]] std::array<double, 2> rail_ends(const Sketch& sketch, const Joint& joint);

/// Whether the joint is a slide by a rod in a guide: a body that takes part in a contact slides so, any other
/// one as a block on a rail.
[[nodiscard]] bool is_rod(const Sketch& sketch, const Joint& joint);

/// Adds the bodies within their curves, bars and plates between their points, and names.
void add_bodies(Sketch& sketch);

/// Adds pins, slides, slots and wheels, and their supports on ground.
void add_joints(Sketch& sketch);

/// The largest force [N] and driving torque [N m] of a row; 0 if there are none.
struct LargestForces {
  double force = 0, torque = 0;
};
[[nodiscard]] LargestForces largest_forces(const Mechanism& mechanism, const Reactions& reactions);

/// Sets the scales of arrows so that the longest arrow of all rows fits.
void set_arrow_scales(const Sketch& sketch, Scene& scene);
void set_force_scales(const Mechanism& mechanism, const std::vector<Reactions>& reactions, Scene& scene);

/// Enlarges the rooms of the scene by the arrows that it has now; of those out of proportion by the part that
/// has the length of others.
void add_arrow_rooms(Scene& scene);

/// Adds what springs that are attached to ground push against.
void add_spring_walls(Sketch& sketch, const std::vector<std::optional<StraightSpring>>& springs);

/// Where a spring on the coordinate of a slide or slot is drawn: behind the block, beside the slot, or
/// between the guide of a rod and the rod's end.
[[nodiscard]] StraightSpring spring_along(const Sketch& sketch, const Joint& joint);

/// Pitch radii of the two wheels of gears or a belt at their distance [m].
[[nodiscard]] std::array<double, 2> wheel_radii(const Joint& joint, double distance);

}  // namespace higherpair

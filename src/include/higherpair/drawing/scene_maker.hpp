#pragma once

#include "higherpair/analysis/row.hpp"
#include "higherpair/drawing/picture.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/mechanism/description.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// Whether the row has positions of the bodies, as in its table, even if they are not to be trusted.
[[nodiscard]] bool has_place(const MotionRow& row);

/// The ends of a spring that is drawn straight, each in the frame of a body [m].
struct StraightSpring {
  int first_body = 0, second_body = 0;
  Vector2d first = Vector2d::Zero(), second = Vector2d::Zero();
  Vector2d shift = Vector2d::Zero();  ///< of both, in the frame of the first body
};

/// Makes the scenes of one mechanism, row by row.
class SceneMaker {
public:
  /// \param mechanism  must outlive the maker
  /// \param rows    of a motion, at least one with a position; they determine the extent of the picture and
  ///                how far slides and contacts travel
  /// \param traces  points whose paths are drawn, in addition to those that are joined to nothing
  /// \param reactions  in the same rows; empty: no forces are drawn
  SceneMaker(const Mechanism& mechanism, const std::vector<MotionRow>& rows,
             const std::vector<PointRef>& traces = {}, const std::vector<Reactions>& reactions = {},
             const Looks& looks = {});

  /// The scene of the row last passed to at(); at first, of the first row with a position.
  [[nodiscard]] const Scene& scene() const { return scene_; }

  /// The scene of a row, which scene() also returns from then on.
  /// \param reactions  in this row, where the maker has any; none: forces are left out
  const Scene& at(const MotionRow& row, const Reactions* reactions = nullptr);

private:
  const Mechanism* mechanism_;
  Scene scene_;
  double largest_ = 1;  // radius up to which curves are drawn as circles [mm]
  bool forces_ = false;
  // One for each spring of the mechanism; none: it is on a pivot.
  std::vector<std::optional<StraightSpring>> springs_;

  std::size_t next_ = 0;  // next index in scene_.moving while that is filled

  Shape& next(Role role, const std::string& name, Shape::Kind kind, bool closed = false);
  void add_contact(const MotionRow& row, std::size_t index);
  void add_linkage(const MotionRow& row, std::size_t index);
  void add_springs(const MotionRow& row);
  void add_straight_spring(const MotionRow& row, const Spring& spring, const StraightSpring& ends);
  void add_spiral_spring(const MotionRow& row, const Spring& spring);
  void add_belt(const MotionRow& row, const Joint& joint);
  void add_motion(const MotionRow& row, int body);
  void add_center(const MotionRow& row, int body);
  void add_driver(const MotionRow& row, const Driver& driver);
  void add_forces(const MotionRow& row, const Reactions& reactions);
  void add_effort(const MotionRow& row, const Driver& driver, double effort);
};

}  // namespace higherpair

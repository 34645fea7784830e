#pragma once

#include "higherpair/mechanism/description.hpp"

#include <string>

namespace higherpair {

/// A mechanism drawn in ground coordinates: all body frames coincide with the ground's, so that it is
/// assembled as drawn.
class DrawnMechanism {
public:
  DrawnMechanism();

  /// Adds a body; returns its index.
  int body(const std::string& name);
  /// Adds a pin between two bodies; returns the index of the joint.
  int pin(int first, int second, const Vector2d& p_W);
  /// The second body slides on the first along a direction.
  int slide(int first, int second, const Vector2d& p_W, const Vector2d& direction_W);
  /// A point of the second body runs in a straight slot of the first.
  int slot(int first, int second, const Vector2d& p_W, const Vector2d& direction_W);
  /// Adds a contact between two curves, the boundaries of the bodies.
  int touch(int first, const Curve& curve1, int second, const Curve& curve2, bool rolling = false);
  void drive(int joint, const std::string& name = "");

  /// Adds a body on a ground pin at O with its end at A.
  int crank(const std::string& name, const Vector2d& O);
  /// Adds two links from a pin A of body a and a pin B of body b to their common pin C. Returns the first;
  /// the second is the next body.
  int dyad(const std::string& name, int a, const Vector2d& A, int b, const Vector2d& B, const Vector2d& C);

  Mechanism mechanism;

private:
  PointRef point(int body, const Vector2d& p_W);
  int add(const Joint& joint);
};

/// Four-bar O2 = (0, 0), O4 = (ground, 0) in metres, crank at 1.1 rad, driven at its ground pin.
[[nodiscard]] DrawnMechanism drawn_four_bar(double ground, double crank, double coupler, double rocker);

}  // namespace higherpair

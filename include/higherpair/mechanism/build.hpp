#pragma once

#include "higherpair/mechanism/description.hpp"

#include <string>

namespace higherpair {

/// Builds a mechanism piece by piece: metres and radians, names as in a profile. Ground is body 0 and comes
/// by itself. What is added is not checked here but by Model::from.

inline constexpr int kGround = 0;

/// A body whose frame is at p_W, turned by theta, roughly, at the start; returns its index.
int add_body(Mechanism& mechanism, const std::string& name, const Vector2d& p_W = Vector2d::Zero(),
             double theta = 0);

/// A point of a body, or the boundary of one, in the body's frame.
PointRef add_point(Mechanism& mechanism, int body, const std::string& name, const Vector2d& p_B);
CurveRef add_curve(Mechanism& mechanism, int body, const std::string& name, const Curve& curve);

/// A curve of several spans, or with ends.
CurveRef add_curve(Mechanism& mechanism, int body, const std::string& name, Boundary boundary);

/// Joints; each returns its index. The body of the first point is the reference of the coordinate, and
/// `direction_A`, of any length > 0, is in its frame. A prismatic joint keeps the angle between the bodies
/// that they have in their poses.
int add_revolute(Mechanism& mechanism, const std::string& name, PointRef first, PointRef second);
int add_prismatic(Mechanism& mechanism, const std::string& name, PointRef first, PointRef second,
                  const Vector2d& direction_A);
int add_slot(Mechanism& mechanism, const std::string& name, PointRef first, PointRef second,
             const Vector2d& direction_A);

/// A contact that slips, to be found nearest to the poses; returns its index. The other ways are members of
/// Contact.
int add_contact(Mechanism& mechanism, const std::string& name, CurveRef first, CurveRef second);

/// Drives a joint; returns the driver's index. Of several drivers each needs a name.
int add_driver(Mechanism& mechanism, int joint, const std::string& name = "");

}  // namespace higherpair

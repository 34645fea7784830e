#pragma once

#include "higherpair/cam/motion_law.hpp"
#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/curve.hpp"
#include "higherpair/geometry/pose.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// A mechanism as its user describes it: plain data in SI units and radians. Bodies, points and curves refer
/// to each other by index. Whoever fills it (the profile reader, a program) must keep the indices valid.

struct NamedPoint {
  std::string name;
  Vector2d p_B = Vector2d::Zero();  ///< in the body's frame [m]
};

struct NamedCurve {
  std::string name;
  Curve curve;  ///< in the body's frame [m]
  /// Set for a curve with ends or of several spans, whose `curve` is of kind kChain; null for a whole conic,
  /// line or point.
  std::shared_ptr<const Boundary> boundary = nullptr;
  /// Index of the original curve, or of the first of several, if this is a contact's own copy; else -1. Set
  /// by Model, which makes copies anew: change the original.
  int copy_of = -1;
  /// Indices of the curves of the body that a contact takes as one, which is of kind kChain; else empty.
  std::vector<int> parts = {};
};

struct MassProperties {
  double mass = 0;                               ///< [kg]
  Vector2d center_of_mass_B = Vector2d::Zero();  ///< in the body's frame [m]
  double inertia = 0;                            ///< about the centre of mass [kg m²]
};

struct Body {
  std::string name;
  Vector2d guess_p_WB =
      Vector2d::Zero();    ///< estimate of the frame's origin at the first driver position [m]
  double guess_theta = 0;  ///< estimate of the frame's angle there [rad]
  std::vector<NamedPoint> points;
  std::vector<NamedCurve> curves;
  std::optional<MassProperties> mass;
};

struct PointRef {
  int body = 0;
  int point = 0;

  friend bool operator==(const PointRef&, const PointRef&) = default;
};

struct CurveRef {
  int body = 0;
  int curve = 0;

  friend bool operator==(const CurveRef&, const CurveRef&) = default;
};

enum class JointType {
  kRevolute,   ///< the two points coincide; coordinate: angle of the second body relative to the first [rad]
  kPrismatic,  ///< no relative turning, second point on a line of the first body; coordinate: displacement
               ///< [m]
  kSlot,       ///< second point on a line of the first body, free to turn; coordinate: displacement [m]
  kGears,      ///< the rotations of two wheels on a carrier are coupled; coordinate: angle of the second
               ///< wheel relative to the carrier [rad]
  kBelt,       ///< the same by a belt or chain that does not slip
};

/// Whether a joint couples the rotations of two wheels: θ2 - θc = turning_ratio (θ1 - θc) + relative_angle.
[[nodiscard]] constexpr bool couples_turning(JointType type) {
  return type == JointType::kGears || type == JointType::kBelt;
}

/// Whether the coordinate of a joint is an angle; else it is a length.
[[nodiscard]] constexpr bool has_angle(JointType type) {
  return type == JointType::kRevolute || couples_turning(type);
}

/// Whether a joint transmits a moment.
[[nodiscard]] constexpr bool has_moment(JointType type) {
  return type == JointType::kPrismatic || couples_turning(type);
}

/// Whether a joint can be driven: it leaves one freedom, its coordinate.
[[nodiscard]] constexpr bool can_be_driven(JointType type) {
  return type == JointType::kRevolute || type == JointType::kPrismatic;
}

/// The data of the teeth of two gears that forces need. Without it a pair transmits only its torque.
struct GearTeeth {
  /// Between the line of action of the teeth and the common tangent of the pitch circles [rad].
  double pressure_angle = 20 * kPi / 180;
  double module = 0;  ///< of the rack that cuts both [m]; 0: not known
};

struct Joint {
  std::string name;
  JointType type = JointType::kRevolute;
  PointRef first;  ///< its body is the reference of the coordinate
  PointRef second;
  Vector2d direction_A =
      Vector2d::UnitX();      ///< unit direction of the line in the first body's frame (not revolute)
  double relative_angle = 0;  ///< angle of the second body relative to the first [rad] (prismatic); phase
                              ///< between the wheels (gears and belts)
  int carrier = 0;            ///< gears and belts: the body on which both wheels turn
  double turning_ratio = 1;   ///< gears and belts: < 0 where the wheels turn against each other; not 0
  std::optional<GearTeeth> teeth;  ///< gears: decide in what direction the tooth force acts
  /// Ends of the line (prismatic, slot): the least and the largest coordinate [m]; none: unbounded.
  std::optional<double> from = {};
  std::optional<double> to = {};
};

/// Which contact is taken at the first driver position.
enum class Approach {
  kNearest,   ///< the possible contact whose follower coordinate is nearest to the pose's
  kPositive,  ///< first touch when the follower moves from its pose towards larger coordinates
  kNegative,  ///< first touch towards smaller coordinates
};

/// What happens where a contact cannot be kept.
enum class Keep {
  kTouching,  ///< the curves always touch; where they cannot, the motion ends
  kGap,       ///< the curves may part; the body that the contact moves then stays where it is on its joint
};

struct Contact {
  std::string name;
  CurveRef first;
  CurveRef second;
  bool rolling = false;
  Approach approach = Approach::kNearest;
  Keep keep = Keep::kTouching;
  bool both_sides = false;  ///< walls on both sides, as in a slot: the contact is held and may pull
  bool jump = true;         ///< continue with a second contact of the same curves when one appears
  /// Located by places along the boundaries, which both curves have. Set by Model, whatever it was before.
  bool by_boundary = false;
};

struct Driver {
  std::string name;  ///< empty for the only driver of a mechanism
  int joint = 0;     ///< index into Mechanism::joints
  /// How far it goes from its first position, if it slides and this is known [m]; a Model sets it.
  double travel = 0;
};

/// A motion law that something in the mechanism follows: a function of the coordinate of a joint [rad or m],
/// or of time [s].
struct NamedLaw {
  std::string name;
  LawDescription law;
};

enum class LoadFrame { kGround, kBody };

struct Load {
  std::string name;
  int body = 0;
  Vector2d p_B = Vector2d::Zero();    ///< where the force acts, in the body's frame [m]
  Vector2d force = Vector2d::Zero();  ///< [N], expressed in `frame`
  double torque = 0;                  ///< [N m]
  LoadFrame frame = LoadFrame::kGround;
};

/// A spring and damper between two points, or on the coordinate of one joint.
struct Spring {
  std::string name;
  std::optional<int> joint;  ///< set: acts on this joint's coordinate; else between `first` and `second`
  PointRef first;
  PointRef second;
  double stiffness = 0;  ///< [N/m], on a revolute joint [N m/rad]
  double free = 0;       ///< free length [m] or free angle [rad]
  double damping = 0;    ///< [N s/m], on a revolute joint [N m s/rad]
};

struct Mechanism {
  std::string title;
  std::string description;
  Vector2d gravity_W = Vector2d::Zero();  ///< [m/s²]
  std::vector<Body> bodies;               ///< bodies[0] is ground
  std::vector<Joint> joints;
  std::vector<Contact> contacts;
  std::vector<Driver> drivers;
  std::vector<Load> loads;
  std::vector<Spring> springs;
  std::vector<NamedLaw> laws;
};

/// Whether there is anything that could load the joints: masses, loads or springs.
[[nodiscard]] bool has_forces(const Mechanism& mechanism);

/// Functions that build a mechanism piece by piece, in metres and radians, with names as in a profile. Ground
/// is body 0 and is added automatically. Nothing is checked here; Model::from does that. \pre a body to which
/// a point or curve is added is there

inline constexpr int kGround = 0;

/// Adds a body whose frame is roughly at p_W, turned by theta, at the start; returns its index.
int add_body(Mechanism& mechanism, const std::string& name, const Vector2d& p_W = Vector2d::Zero(),
             double theta = 0);

/// Add a point or a curve of a body's boundary, in the body's frame.
PointRef add_point(Mechanism& mechanism, int body, const std::string& name, const Vector2d& p_B);
CurveRef add_curve(Mechanism& mechanism, int body, const std::string& name, const Curve& curve);

/// Adds a curve of several spans, or with ends.
CurveRef add_curve(Mechanism& mechanism, int body, const std::string& name, Boundary boundary);

/// Add a joint and return its index. The body of the first point is the reference of the coordinate, and
/// `direction_A`, of any length > 0, is in its frame. A prismatic joint keeps the angle that the bodies have
/// in their poses.
int add_revolute(Mechanism& mechanism, const std::string& name, PointRef first, PointRef second);
int add_prismatic(Mechanism& mechanism, const std::string& name, PointRef first, PointRef second,
                  const Vector2d& direction_A);
int add_slot(Mechanism& mechanism, const std::string& name, PointRef first, PointRef second,
             const Vector2d& direction_A);

/// Adds a slipping contact, taken nearest to the poses; returns its index. Other kinds are set in the members
/// of Contact.
int add_contact(Mechanism& mechanism, const std::string& name, CurveRef first, CurveRef second);

/// Drives a joint; returns the driver's index. With several drivers each needs a name.
int add_driver(Mechanism& mechanism, int joint, const std::string& name = "");

}  // namespace higherpair

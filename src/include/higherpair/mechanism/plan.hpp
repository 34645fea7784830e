#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/linkage/four_bar.hpp"
#include "higherpair/mechanism/description.hpp"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// A point fixed in a body.
struct BodyPoint {
  int body = 0;
  Vector2d p_B = Vector2d::Zero();  ///< in the body's frame [m]
};

/// A straight line fixed in a body, with a direction.
struct BodyLine {
  int body = 0;
  Vector2d p_B = Vector2d::Zero();  ///< a point of it, in the body's frame [m]
  Rotation<double> u_B;             ///< its direction in that frame
};

/// A body that does not rotate relative to another one, and one of whose points is known.
struct Rider {
  int body = 0;
  int carrier = 0;
  Vector2d p_B = Vector2d::Zero();  ///< the known point, in the frame of `body` [m]
  double relative_angle = 0;        ///< of the body relative to the carrier [rad]
  Rotation<double> relative;        ///< the same as a rotation
};

/// A body with one freedom relative to a known carrier, left by a revolute or prismatic joint.
struct CarriedBody {
  int body = 0;
  int carrier = 0;
  OneFreedom freedom;  ///< in the carrier's frame
  /// Freedom coordinate = sign · joint coordinate; -1 if the joint turns and names the carrier second.
  double sign = 1;
};

/// A body placed by a driven joint relative to a known one.
struct DrivenBody {
  int driver = 0;  ///< index of Mechanism::drivers
  CarriedBody carried;
};

// The dyads with pins at their ends answer alike which bodies are their links, and which known ones carry
// them.

/// Two links between known pins A and B that meet at C.
struct RrrDyad {
  BodyPoint A, B;
  int link_a = 0, link_b = 0;
  int pin_C = -1;  ///< the joint of the two links; -1: it is none of the mechanism's
  Vector2d a_pA = Vector2d::Zero(), a_pC = Vector2d::Zero();  ///< pins of link a, in its frame [m]
  Vector2d b_pB = Vector2d::Zero(), b_pC = Vector2d::Zero();  ///< pins of link b
  double length_a = 0, length_b = 0;                          ///< [m], > 0
  Rotation<double> along_a, along_b;  ///< direction from A (B) to C in the link's frame
  /// Where |AB| is determined by one angle (A on an arm that turns about a pin on the body of B): the loop,
  /// whose reach stays accurate at change points, and where to measure that angle.
  std::optional<FourBarLoop<double>> loop;
  BodyLine arm;     ///< from that pin to A, on the body of A
  BodyLine ground;  ///< from that pin to B, on the body of B

  [[nodiscard]] std::array<int, 2> links() const { return {link_a, link_b}; }
  [[nodiscard]] std::array<int, 2> known() const { return {A.body, B.body}; }
};

/// A link from a known pin A to a pin C that runs along a line of a known body; possibly with a slider at C.
struct RrpDyad {
  BodyPoint A;
  int link = 0;
  Vector2d pA = Vector2d::Zero(), pC = Vector2d::Zero();  ///< in the link's frame [m]
  double length = 0;                                      ///< [m], > 0
  Rotation<double> along;                                 ///< direction from A to C in the link's frame
  BodyLine line;
  std::optional<Rider> slider;

  [[nodiscard]] std::array<int, 1> links() const { return {link}; }
  [[nodiscard]] std::array<int, 2> known() const { return {A.body, line.body}; }
};

/// A link at a known pin A that carries a line through a known point B; possibly with a slider at B.
struct RprDyad {
  BodyPoint A, B;
  int link = 0;
  Vector2d pA = Vector2d::Zero();  ///< in the link's frame [m]
  BodyLine line;                   ///< on the link
  std::optional<Rider> slider;

  [[nodiscard]] std::array<int, 1> links() const { return {link}; }
  [[nodiscard]] std::array<int, 2> known() const { return {A.body, B.body}; }
};

/// The offset of the line of an RPR dyad from its pin A, both on the link [m].
[[nodiscard]] inline double slot_offset(const RprDyad& dyad) {
  return cross(Vector2d(dyad.line.u_B.cos, dyad.line.u_B.sin), Vector2d(dyad.line.p_B - dyad.pA));
}

/// Two slides that place a point C. C runs on the first line; the second line either lies on another known
/// body (two sliders joined by a pin C), or passes through a known pin A in a direction that turns with the
/// body of the first line (a body pinned at A slides on a body that slides on a known one). For one body on a
/// slide and a slot the slot is the second line.
struct SlideDyad {
  BodyLine first;
  BodyLine second;               ///< if `pin` is set only its direction counts, in the frame of first.body
  std::optional<BodyPoint> pin;  ///< A
  std::optional<Rider> pinned;   ///< the body pinned at A
  std::vector<Rider> riders;     ///< bodies whose point is C
};

/// A follower on ground in contact with a driver on ground: followed by tracking the contact.
struct TrackedPair {
  int contact = 0;
  int driver = 0;          ///< index of Mechanism::drivers
  double driver_sign = 1;  ///< u = sign · coordinate of the driven joint
  CarriedBody follower;
  ContactPair pair;             ///< body 1: the driver, body 2: the follower
  bool driver_is_first = true;  ///< whether the contact names the driver first
};

/// A body on a revolute or prismatic joint to a known body, in contact with a known body without rolling.
struct TouchingBody {
  int contact = 0;
  CarriedBody follower;
  bool follower_is_second = true;  ///< whether the contact names it second
};

/// A body attached by one pin only, whose rotation is not determined: it keeps the angle of its pose.
struct IdleBody {
  BodyPoint pin;  ///< on the known body
  int body = 0;
  Vector2d p_B = Vector2d::Zero();
};

/// A body on a pin of a known one, whose rotation is determined by gears or a belt: a wheel, or the arm of a
/// planetary gear.
struct GearedBody {
  BodyPoint pin;  ///< on the known body
  int body = 0;
  Vector2d p_B = Vector2d::Zero();
  int gears = 0;  ///< index of Mechanism::joints
};

/// Bodies whose conditions must be solved together.
struct CoupledBodies {};

using GroupKind = std::variant<DrivenBody, RrrDyad, RrpDyad, RprDyad, SlideDyad, TrackedPair, TouchingBody,
                               IdleBody, GearedBody, CoupledBodies>;

/// Bodies that must be placed together, and the conditions that place them: all those whose last placed body
/// is among them. Indices into the members of Mechanism.
struct BodySet {
  std::vector<int> bodies;
  std::vector<int> joints;
  std::vector<int> contacts;
  std::vector<int> drivers;
};

/// Calls f(body) for the bodies of the conditions of a set: those that they place, and those that they depend
/// on; some several times.
template <class F>
void for_each_joined_body(const Mechanism& mechanism, const BodySet& set, F f) {
  for (const int index : set.joints) {
    const Joint& joint = mechanism.joints[index];
    f(joint.first.body);
    f(joint.second.body);
    f(joint.carrier);
  }
  for (const int index : set.contacts) {
    const Contact& contact = mechanism.contacts[index];
    f(contact.first.body);
    f(contact.second.body);
  }
}

/// A set that is placed once the groups before it are known, and how.
struct Group : BodySet {
  GroupKind kind;
  std::vector<int> ended_joints = {};  ///< the `joints` whose line has an end
};

/// A body on a revolute or prismatic joint, seen from the body at the joint's other end.
[[nodiscard]] CarriedBody carried_body(const Mechanism& mechanism, const Joint& joint, int body);

/// How a body moves on its revolute or prismatic joint to ground, the first if it has several; none if it has
/// none, and for ground. A slide's direction is the joint's, whichever of its two bodies is on ground.
[[nodiscard]] std::optional<OneFreedom> grounded_freedom(const Mechanism& mechanism, int body);

/// The order of solution.
struct Plan {
  std::vector<Group> groups;
  std::vector<int> idle_bodies;  ///< whose rotation is not determined (a roller's spin)
  /// Those whose angle is determined by nothing but a rolling contact: they start with the angle of their
  /// pose.
  std::vector<int> phase_bodies;
  std::vector<bool> coincidences;  ///< of pins and round curves, on which the order and phase_bodies depend
  int surplus = 0;                 ///< number of conditions in excess of the coordinates
  bool couples = false;            ///< some of the groups are CoupledBodies
  double size = 1;                 ///< size_of the mechanism [m]
};

/// Those bodies of a group whose rotation is not determined.
[[nodiscard]] std::vector<int> idle_bodies_of(const Plan& plan, const Group& group);

/// Those of a group whose angle is determined by nothing but a rolling contact.
[[nodiscard]] std::vector<int> phase_bodies_of(const Plan& plan, const Group& group);

/// Index of the group that has a contact; none if no group does.
[[nodiscard]] std::optional<std::size_t> group_with_contact(const Plan& plan, int contact);

/// Largest distance between joint points and curve centres or vertices, in the poses [m]. Where all of them
/// coincide to within 1e-7 of their coordinates, the largest of these, in a body or in ground; 1 m where they
/// are below 1e-12 m. Below 1e-4 of the largest Driver::travel, distances and coordinates are taken for
/// rounding, such as that of a drawing, as if they were 0.
[[nodiscard]] double size_of(const Mechanism& mechanism);

/// The plan of a mechanism: its conditions are matched with its coordinates and split into the smallest sets
/// of bodies that can be solved one after the other (strongly connected components); each is recognised as a
/// closed-form group where possible. Independent of the order of the description. Refuses mechanisms some of
/// whose bodies are not placed; the message names these bodies, the count, and what to add.
[[nodiscard]] tl::expected<Plan, std::string> make_plan(const Mechanism& mechanism);

/// The plan of a mechanism with the same bodies, joints, contacts and drivers as the planned one, but other
/// dimensions: the order of solution is kept, the groups are filled in again.
[[nodiscard]] Plan redimensioned(const Plan& plan, const Mechanism& mechanism);

}  // namespace higherpair

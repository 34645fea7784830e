#pragma once

#include "chain_columns.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// Capacity.
inline constexpr std::size_t kMostChainJoints = 96;

/// What acts on the bodies of a chain apart from its joints, as plain numbers taken from a mechanism.
struct ChainLoads {
  struct Mass {
    int body = 0;
    MassProperties of;
  };
  struct Force {
    BodyPoint at;
    Vector2d force = Vector2d::Zero();
    double torque = 0;
    bool turns_along = false;  ///< `force` turns with the body: it is in its frame, not in ground's
  };
  /// Tension = stiffness (x - free) + damping ẋ.
  struct Tension {
    double stiffness = 0, free = 0, damping = 0;
  };
  struct PointSpring {
    BodyPoint first, second;
    Tension tension;
  };
  /// A spring on the coordinate of a slide or slot.
  struct LineSpring {
    BodyLine line;     ///< on the joint's first body, through its point
    BodyPoint second;  ///< its second point
    Tension tension;
  };
  /// A torsion spring on the driven pin.
  struct TurnSpring {
    int first = 0, second = 0;  ///< bodies of the joint
    Tension tension;
  };
  /// A torsion spring on another pin.
  struct PinSpring {
    TurnSpring on;
    ChainAngle first, second;  ///< angles of these bodies
  };

  Vector2d gravity_W = Vector2d::Zero();
  std::vector<Mass> masses;
  std::vector<Force> forces;
  std::vector<PointSpring> point_springs;
  std::vector<LineSpring> line_springs;
  std::vector<TurnSpring> turn_springs;
  std::vector<PinSpring> pin_springs;
};

/// A joint that holds a body of a group.
struct ChainSupport {
  int joint = -1;    ///< index of Mechanism::joints; none: -1
  double sign = 1;   ///< +1 where the held body is the joint's second, else -1
  BodyPoint second;  ///< the joint's second point, at which a guide's force is assumed to act
};

/// The joints of a group. Driven: `outer[0]` is the driven one. RRR: `outer` hold links a and b, `inner`
/// joins link a to b. RRP: `outer[0]` holds the link, `inner` is the pin at C, `outer[1]` the guide of the
/// slider on its line; without a slider `outer[1]` is the slot between link and line. RPR: `outer[0]` holds
/// the link at A, `outer[1]` the slider at B, and `inner` is the guide between link and slider; without a
/// slider `inner` is the slot of the link on B. Contacts: `outer[0]` holds the body that the contact places.
struct ChainSupports {
  std::array<ChainSupport, 2> outer;
  ChainSupport inner;
};

/// All data for the balance of forces of a chain.
struct ChainStatics {
  ChainLoads loads;
  std::vector<ChainSupports> supports;  ///< of the groups
  std::size_t joints = 0;               ///< of the mechanism
  std::size_t contacts = 0;
  /// Result of fill_chain_rows(): the squared length of the shortest spring between points in all rows.
  double shortest2 = 0;
};

/// Fills in `statics`; false where a chain cannot handle a group or a spring, or where a body's turning is
/// not determined.
/// \param groups  as chain_group() makes them of the plan
/// \param angles  of all bodies
[[nodiscard]] bool take_statics(const Mechanism& mechanism, const Plan& plan,
                                std::span<const ChainGroup> groups, std::span<const ChainAngle> angles,
                                ChainStatics& statics);

}  // namespace higherpair

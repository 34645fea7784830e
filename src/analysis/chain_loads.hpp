#pragma once

#include "chain_columns.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// What there is room for.
inline constexpr std::size_t kMostChainJoints = 96;

/// What acts on the bodies of a chain apart from its joints: plain numbers, taken from a mechanism.
struct ChainLoads {
  struct Mass {
    int body = 0;
    MassProperties of;
  };
  struct Force {
    BodyPoint at;
    Vector2d force = Vector2d::Zero();
    double torque = 0;
    bool turns_along = false;  ///< `force` is in the body's frame, not in ground
  };
  /// T = stiffness (x - free) + damping ẋ.
  struct Tension {
    double stiffness = 0, free = 0, damping = 0;
  };
  struct PointSpring {
    BodyPoint first, second;
    Tension tension;
  };
  /// On the coordinate of a slide or slot.
  struct LineSpring {
    BodyLine line;     ///< on the joint's first body, through its point
    BodyPoint second;  ///< its second point
    Tension tension;
  };
  /// On the coordinate of the driven pin.
  struct TurnSpring {
    int first = 0, second = 0;  ///< bodies of the joint
    Tension tension;
  };
  /// On the coordinate of another pin.
  struct PinSpring {
    TurnSpring on;
    ChainAngle first, second;  ///< of these bodies
  };

  Vector2d gravity_W = Vector2d::Zero();
  std::vector<Mass> masses;
  std::vector<Force> forces;
  std::vector<PointSpring> point_springs;
  std::vector<LineSpring> line_springs;
  std::vector<TurnSpring> turn_springs;
  std::vector<PinSpring> pin_springs;
};

/// A joint of a group, which holds a body of it.
struct ChainSupport {
  int joint = -1;     ///< index of Mechanism::joints; none: -1
  double sign = 1;    ///< +1 where the held body is the joint's second, else -1
  BodyPoint second;   ///< the joint's second point, at which a guide is taken to press
  bool rigid = true;  ///< whether it passes a moment on: a slide, not a slot
};

/// The joints of a group. Driven: `outer[0]` is the driven one. RRR: `outer` hold link a and b, `inner` link
/// a. RRP: `outer[0]` holds the link, `inner` the link at C, `outer[1]` is the guide on its line; where there
/// is no slider the link lies on that itself. RPR: `outer[0]` holds the link at A, `outer[1]` the slider at
/// B, and `inner` is the guide that holds the link; where there is no slider B lies on it itself. Contacts:
/// `outer[0]` holds the body that the contact places.
struct ChainSupports {
  std::array<ChainSupport, 2> outer;
  ChainSupport inner;
};

/// All that it takes to balance a chain.
struct ChainStatics {
  ChainLoads loads;
  std::vector<ChainSupports> supports;  ///< of the groups
  std::size_t joints = 0;               ///< of the mechanism
  std::size_t contacts = 0;
  /// The result of fill_chain_rows(): the squared length of the shortest spring between points in all rows.
  double shortest2 = 0;
};

/// Fills it in; false where a group or a spring is not for a chain: bodies whose turning nothing sets.
/// \param groups  as chain_group() makes them of the plan
/// \param angles  of all bodies
[[nodiscard]] bool take_statics(const Mechanism& mechanism, const Plan& plan,
                                std::span<const ChainGroup> groups, std::span<const ChainAngle> angles,
                                ChainStatics& statics);

}  // namespace higherpair

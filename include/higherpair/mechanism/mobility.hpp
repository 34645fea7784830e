#pragma once

#include "higherpair/geometry/pose.hpp"

#include <vector>

namespace higherpair {

/// The numbers of Gruebler's and Kutzbach's count. A pin of k bodies is described by k - 1 joints and so
/// counts k - 1 times.
struct MobilityCount {
  int bodies = 1;      ///< n, with ground
  int revolutes = 0;   ///< one freedom each
  int prismatics = 0;  ///< one
  int slots = 0;       ///< two
  int slipping = 0;    ///< contacts that slip: two
  int rolling = 0;     ///< contacts that roll: one
  int gears = 0;       ///< pairs of gears: two
  int belts = 0;       ///< belts and chains around two wheels: two

  /// j, joints and contacts.
  [[nodiscard]] int joints() const {
    return revolutes + prismatics + slots + slipping + rolling + gears + belts;
  }
  /// Σ f, the freedoms that they leave.
  [[nodiscard]] int freedoms() const { return joints() + slots + slipping + gears + belts; }
  /// M = 3 (n - j - 1) + Σ f.
  [[nodiscard]] int mobility() const { return 3 * (bodies - joints() - 1) + freedoms(); }
};

/// Turning of one body that changes nothing else: about the centre of its pins and of its round curves.
struct IdleFreedom {
  int body = 0;
  Vector2d p_W = Vector2d::Zero();  ///< the centre, at the start [m]
};

/// Why some conditions repeat what others say already.
enum class RedundancyCause {
  kSamePin,          ///< joints hold bodies together that other joints of the same pin hold already
  kParallelCranks,   ///< three or more equal and parallel links between the same two bodies
  kRollingOnPivots,  ///< pins keep two rolling curves in touch: only the slip is a condition of its own
  kSlidingOnPivots,  ///< pins keep two discs in touch that slip on each other: the contact sets nothing
  kSlidesAlone,      ///< a loop of slides alone: the last one repeats that nothing turns
  kMember,           ///< any other: a member more than it takes, which fits
};

/// Conditions that depend on each other: without as many as `conditions` of them nothing would change.
struct Redundancy {
  int conditions = 0;
  RedundancyCause cause = RedundancyCause::kMember;
  std::vector<int> joints;
  std::vector<int> contacts;
  std::vector<int> bodies;  ///< kParallelCranks: the parallel links
};

/// What a mechanism can do, by count and by the rank of its conditions.
struct Mobility {
  MobilityCount count;
  bool assembled = false;         ///< nothing but `count` is filled otherwise
  bool drivers_held = false;      ///< the start is at the given positions of the drivers
  std::vector<BodyMotion> start;  ///< of Mechanism::bodies
  int conditions = 0;             ///< rows of the constraint Jacobian, without drivers
  int rank = 0;                   ///< the largest over the positions looked at
  int positions = 0;              ///< how many these are
  int start_freedom = 0;          ///< dimension of the null space at the start
  int shaky = 0;                  ///< dimensions of the null space in which it moves infinitesimally only
  int freedom = 0;                ///< 3 (n - 1) - rank - shaky: what it moves in
  bool singular = false;          ///< the start has a larger null space: a change point, or shaky
  std::vector<IdleFreedom> idle;
  std::vector<Redundancy> redundancies;

  std::vector<int> useless_drivers;  ///< indices of drivers that move nothing that the others do not
  int missing_drivers = 0;           ///< freedoms, idle ones apart, that no driver sets
  std::vector<int> joints_to_drive;  ///< revolute and prismatic joints that still move with all drivers held
  std::vector<int> loose_bodies;     ///< bodies that do
  /// Velocities with the drivers moving at given rates; empty unless they set all but idle freedoms.
  std::vector<BodyMotion> moving;

  /// Freedoms that are worth a driver.
  [[nodiscard]] int useful() const { return freedom - static_cast<int>(idle.size()); }
  [[nodiscard]] bool drivers_fit() const { return missing_drivers == 0 && useless_drivers.empty(); }
};

}  // namespace higherpair

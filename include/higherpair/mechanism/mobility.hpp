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

/// Rotation of one body that moves nothing else, about the common centre of its pins and circular curves.
struct IdleFreedom {
  int body = 0;
  Vector2d p_W = Vector2d::Zero();  ///< the centre, at the start [m]
};

/// Why some conditions are redundant.
enum class RedundancyCause {
  kSamePin,          ///< joints connect bodies that other joints of the same pin connect already
  kParallelCranks,   ///< three or more equal and parallel links between the same two bodies
  kRollingOnPivots,  ///< pins already keep two rolling curves in contact: only the absence of slip is a
                     ///< condition of its own
  kSlidingOnPivots,  ///< pins already keep two slipping discs in contact: the contact adds no condition
  kSlidesAlone,      ///< a loop of slides only: the last one repeats the condition that nothing rotates
  kMember,           ///< any other: a member more than is needed, whose dimensions fit
};

/// Conditions that depend on each other: `conditions` of them could be removed without effect on the motion.
struct Redundancy {
  int conditions = 0;
  RedundancyCause cause = RedundancyCause::kMember;
  std::vector<int> joints;
  std::vector<int> contacts;
  std::vector<int> bodies;  ///< kParallelCranks: the parallel links
};

/// The mobility of a mechanism, by count and by the rank of its conditions.
struct Mobility {
  MobilityCount count;
  bool assembled = false;         ///< false: only `count` is filled
  bool drivers_held = false;      ///< the start is at the given positions of the drivers
  std::vector<BodyMotion> start;  ///< one for each of Mechanism::bodies
  int conditions = 0;             ///< rows of the constraint Jacobian, without drivers
  int rank = 0;                   ///< the largest over the positions looked at
  int positions = 0;              ///< number of positions looked at
  int start_freedom = 0;          ///< dimension of the null space at the start
  int shaky = 0;                  ///< dimensions of the null space in which it moves infinitesimally only
  int freedom = 0;                ///< 3 (n - 1) - rank - shaky: degrees of freedom of finite motion
  bool singular = false;          ///< the start has a larger null space: a change point, or shaky
  std::vector<IdleFreedom> idle;
  std::vector<Redundancy> redundancies;

  std::vector<int> useless_drivers;  ///< indices of drivers that set nothing that those before them do not
  int missing_drivers = 0;           ///< freedoms, without idle ones, that no driver sets
  std::vector<int> joints_to_drive;  ///< revolute and prismatic joints that still move with all drivers held
  std::vector<int> loose_bodies;     ///< bodies that still move then
  /// Velocities with the drivers moving at given rates; empty unless they set all but idle freedoms.
  std::vector<BodyMotion> moving;

  /// Freedoms that need a driver: all but the idle ones.
  [[nodiscard]] int useful() const { return freedom - static_cast<int>(idle.size()); }
  [[nodiscard]] bool drivers_fit() const { return missing_drivers == 0 && useless_drivers.empty(); }
};

}  // namespace higherpair

#pragma once

#include "higherpair/contact/rolling.hpp"
#include "higherpair/contact/tracker.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

enum class RowStatus {
  kOk,
  kNotAssemblable,  ///< the bodies cannot touch at this driver position
  kSingular,        ///< ∂gap/∂q is 0 to rounding: positions hold, rates are not defined
  kNotConverged,    ///< the closure residual exceeds the tolerance
};

/// Everything that one row of a motion table shows; SI units, ground frame.
struct MotionRow {
  RowStatus status = RowStatus::kNotConverged;
  double residual = 0;  ///< largest closure error of the row [m]
  std::vector<BodyMotion>
      bodies;                 ///< of Mechanism::bodies; ground at rest. Meaningless where not assemblable
  double joint_position = 0;  ///< of the follower's joint [rad or m], and its rates
  double joint_velocity = 0;
  double joint_acceleration = 0;
  ContactPosition contact;  ///< for a unit driver velocity, body 1 the driver
  double normal_angle = 0;  ///< of contact.n_W, continuous [rad]
  double sliding = 0;       ///< sliding velocity [m/s]
};

/// A limit position that the run has met.
struct LimitEvent {
  double driver = 0;  ///< coordinate of the driven joint [rad or m]
};

/// A running analysis: a plan and where the mechanism stands.
struct Run {
  Mechanism mechanism;
  Plan plan;
  std::optional<ContactTrack> track;    ///< of a slipping contact
  std::optional<RollingTrack> rolling;  ///< of a rolling one
  double tolerance = 1e-9;              ///< of plan.size: larger residuals are not `ok`
};

/// Starts a run at a driver position: the contact that the profile's `approach` picks is found.
/// The error says why there is none.
[[nodiscard]] tl::expected<Run, std::string> start_run(const Mechanism& mechanism, double driver,
                                                       double tolerance = 1e-9);

/// Where and how fast a pair that ought to roll would have to slip.
struct Slip {
  double driver = 0;    ///< coordinate of the driven joint [rad or m]
  double velocity = 0;  ///< sliding velocity for a unit velocity of the driven joint [m/rad or 1]
};

/// Rolls through the driver positions and returns the first at which the contact would have to slip, if any:
/// rolling removes two freedoms, and between two grounded joints only special pairs move all the same.
[[nodiscard]] std::optional<Slip> find_slip(const Run& run, const std::vector<double>& positions);

struct RunStep {
  MotionRow row;
  std::optional<LimitEvent> limit;
};

/// Moves the mechanism to a position of the driven joint with the given velocity and acceleration of the
/// joint.
[[nodiscard]] RunStep move_to(Run& run, double position, double velocity, double acceleration);

}  // namespace higherpair

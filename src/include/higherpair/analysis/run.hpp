#pragma once

#include "higherpair/analysis/driver_curve.hpp"
#include "higherpair/analysis/row.hpp"
#include "higherpair/analysis/state.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "higherpair/numeric/stop.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// Where and how fast a rolling pair would have to slip.
struct Slip {
  double driver = 0;    ///< coordinate of the driven joint [rad or m]
  double velocity = 0;  ///< sliding velocity for a unit velocity of the driven joint [m/rad or 1]
  int contact = 0;
};

/// Why a mechanism cannot be started.
struct StartFailure {
  std::string reason;
  std::optional<Slip> slip;  ///< set where a rolling contact would have to slip
};

/// The path of the drivers from one row to the next: straight, or a part of a curve in time. What it varies
/// are its inputs: the drivers' coordinates; on a curve the time alone. Its coordinate s runs from 0 to
/// `length`: with one input the change of that, with several the fraction of the path.
struct Path {
  std::vector<double> from;  ///< inputs
  std::vector<double> to;
  double length = 0;
  /// Fractions of the drivers' path from the previous row to this one, at `from` and at `to`: a path may be a
  /// part of it.
  double share_from = 0;
  double share_to = 1;
  std::shared_ptr<const DriverCurve> curve;  ///< null if the path is straight
  std::array<double, 2> piece{};             ///< of the curve: the breaks before and after the path [s]
  bool is_chord = false;                     ///< goes straight between two points of the curve

  [[nodiscard]] bool is_single() const { return from.size() == 1; }
  /// Writes the inputs at s to `out`.
  void inputs(double s, std::vector<double>& out) const;
  /// Writes the positions of the drivers at s and their rates per unit of s to `out`.
  void motions(double s, std::vector<DriverMotion>& out) const;

private:
  [[nodiscard]] DriverMotion on_curve(double s, std::size_t driver) const;
};

/// A joint to ground that is not driven, and the sense of its last motion.
struct OutputJoint {
  int joint = 0;
  int sense = 0;       ///< 0: has not moved yet
  double from = 0;     ///< where this stroke began, or a little behind where it has come to [rad or m]
  double least = 0;    ///< a shorter stroke is none, as a fraction of its unit
  double fastest = 0;  ///< speed in the last step, per unit of the path
};

/// Overlap monitoring of one contact.
struct OverlapWatch {
  bool needed = false;       ///< whether the bodies could overlap elsewhere
  bool overlaps = false;     ///< they currently do
  bool interrupted = false;  ///< the motion has switched to a second contact or had a gap: arcs end there

  /// The motion goes on with another contact of the two bodies, or with one after a gap.
  void interrupt() {
    overlaps = false;
    interrupted = true;
  }
};

/// A change point that the present step passes through.
struct Crossing {
  std::size_t group = 0;
  double s = 0;  ///< on the path
};

/// The closest that coupled bodies come to assembly beyond a limit.
struct Nearest {
  State state;
  std::vector<std::optional<LeastViolation>> continuations;  ///< of Plan::groups: how they were led there
};

/// Where a branch beyond a limit was found to be another one than the lost one.
struct OtherBranch {
  double x = 0;  ///< the leading input
  State state;
};

/// A limit at which the motion was lost.
struct Loss {
  std::vector<double> from;  ///< inputs at RunPosition::state, the last position before it
  std::vector<double> at;    ///< the inputs at the limit
  RunEvent event;
  /// How far on the line beyond it the branch has been searched for without success: the leading input.
  std::optional<double> looked_to;
  std::optional<OtherBranch> other;  ///< the last one found on that line
  std::optional<Nearest> nearest;    ///< with coupled bodies: their closest approach to assembly there
  bool for_good = false;             ///< the path was given up and is not resumed
  /// The limit is at infinity and beyond the row at which the motion was lost, so near to it that bodies or
  /// contacts are too far away to be computed.
  bool is_beyond_row = false;
};

/// Data shared by runs of one mechanism; none of them changes it.
struct RunModel {
  std::shared_ptr<const Mechanism> mechanism;
  std::shared_ptr<const Plan> plan;  ///< plan of the mechanism, from make_plan
};

/// The position of a run. Assigning it to another run of the same model puts that run there.
struct RunPosition {
  State state;  ///< the last position; rates per unit of the path
  /// What moves the run, there: the drivers' coordinates, or, on a curve, the time alone.
  std::vector<double> inputs;
  std::vector<double> targets;               ///< the inputs of the last row, which may not have been reached
  std::shared_ptr<const DriverCurve> curve;  ///< that the drivers follow; null if they go straight
  double time_unit = 1;  ///< on it: the least time in which a driver moves by one unit [s]
  /// The last row, if it is next to a change point or at a limit, and `state` short of it.
  std::optional<State> beside;
  bool on_branch = true;  ///< false: the motion was lost at a limit; `state` is the last position before it
  Loss lost;              ///< where, if so
  std::vector<OutputJoint> outputs;
  std::vector<OverlapWatch> watches;     ///< of Mechanism::contacts
  std::vector<RunEvent> reported;        ///< the events of change points ahead that have been reported
  std::optional<RunEvent> limit_here;    ///< a limit at the last row itself
  std::optional<RunEvent> limit_before;  ///< the same for the previous row

  /// The state that the last row shows, unless it was lost.
  [[nodiscard]] const State& shown() const { return beside ? *beside : state; }
};

/// Scratch data for trial steps; nothing in it is kept from one row to the next.
struct StepWorkspace {
  State trial;
  std::vector<DriverMotion> motions;                         ///< of the drivers, in `trial`
  std::vector<Crossing> crossings;                           ///< those of the present step
  std::vector<std::optional<LeastViolation>> continuations;  ///< of Plan::groups, in `trial` beyond a limit
  Path path;                                                 ///< to the next row
  std::vector<double> row_before;                            ///< inputs at the last row
  std::vector<DriverMotion> at_row;  ///< for callers of move_to() that compute the drivers at a row anew
};

/// A running analysis. A copy continues from its position independently, in any thread.
struct Run {
  RunModel model;
  /// Relative to the plan's size: rows with larger residuals are not `ok`
  double tolerance = kDefaultClosure;
  RunPosition at;
  StepWorkspace work;
  MotionRow row;                 ///< result of the last move_to
  std::vector<RunEvent> events;  ///< events of the last move_to
  /// Where on the drivers' path of the last move_to contacts passed smooth joints of boundaries, at which
  /// higher derivatives jump: fractions of it, at most some hundred.
  std::vector<double> smooth_joints;
  /// Once true, move_to gives up within an inner step, and its row and events are then meaningless; may be
  /// null.
  const std::atomic<bool>* stop = nullptr;

  /// With boundary contacts: the mechanism with curves that agree with the boundaries at the row's contacts.
  std::optional<Mechanism> local;
  /// The row is displaced by a change of dimensions (displaced.hpp), but not the state.
  bool is_displaced = false;

  [[nodiscard]] const Mechanism& mechanism() const { return local ? *local : *model.mechanism; }
  [[nodiscard]] const Plan& plan() const { return *model.plan; }
};

/// A model that owns its mechanism and plan.
[[nodiscard]] RunModel make_run_model(Mechanism mechanism, Plan plan);

/// Assembles a mechanism at the first positions of its drivers: of all assemblies the one whose joint points
/// are closest to their positions in the poses (least sum of squares); contacts are selected by their
/// `approach`.
[[nodiscard]] tl::expected<Run, StartFailure> start_run(const Mechanism& mechanism,
                                                        const std::vector<double>& drivers,
                                                        double tolerance = kDefaultClosure);

/// The same with a model that may be shared with other runs.
[[nodiscard]] tl::expected<Run, StartFailure> start_run(RunModel model, const std::vector<double>& drivers,
                                                        double tolerance = kDefaultClosure);

/// Whether the run has been asked to stop.
[[nodiscard]] inline bool is_stopped(const Run& run) {
  return is_raised(run.stop);
}

/// Moves along the straight path of the drivers to their given positions, in as many inner steps as are
/// necessary to stay on the branch, and fills run.row and run.events. A step is accepted only if the solution
/// agrees with the prediction from the preceding rates. Does not allocate unless an event happens or bodies
/// are coupled.
/// \param drivers  of Mechanism::drivers; velocity and acceleration are those at the row
void move_to(Run& run, const std::vector<DriverMotion>& drivers);

/// The same along a curve in time, from the row at `from` to the row at `to` [s]. A run that is not quite at
/// a row, because that is next to a change point or lost, goes straight to this one first.
/// \param drivers  at `to`; where rates jump there, either of both
void move_along(Run& run, const std::shared_ptr<const DriverCurve>& curve, double from, double to,
                const std::vector<DriverMotion>& drivers);

/// Velocities and accelerations of all bodies and contacts of `state`, whose positions are given, for the
/// rates of the drivers.
void set_rates(const Run& run, const std::vector<DriverMotion>& drivers, State& state);

/// Rolls through driver positions and returns the first at which a rolling contact of driver and follower
/// would have to slip, if any: rolling removes two freedoms, and between two grounded joints only special
/// pairs can still move.
[[nodiscard]] std::optional<Slip> find_slip(const Run& run, const std::vector<double>& positions);

}  // namespace higherpair

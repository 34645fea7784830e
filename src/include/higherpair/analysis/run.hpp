#pragma once

#include "higherpair/analysis/row.hpp"
#include "higherpair/analysis/state.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "higherpair/numeric/stop.hpp"

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// Where and how fast a pair that ought to roll would have to slip.
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

/// The straight path of the drivers from one row to the next. Its coordinate s runs from 0 to `length`: with
/// one driver the change of that driver's coordinate, with several the share of the path.
struct Path {
  std::vector<double> from;
  std::vector<double> to;
  double length = 0;
  double share_from =
      0;  ///< of the way from the row before to this one: at `from`; a path may be a part of it
  double share_to = 1;

  [[nodiscard]] bool is_single() const { return from.size() == 1; }
  /// Positions at s into `out`.
  void positions(double s, std::vector<double>& out) const;
  /// The drivers at s and their rates per unit of s into `out`.
  void motions(double s, std::vector<DriverMotion>& out) const;
};

/// A joint to ground that is not driven, and the sense in which it moved last.
struct OutputJoint {
  int joint = 0;
  int body = 0;
  bool turns = true;
  Vector2d direction_W = Vector2d::UnitX();  ///< of a slide
  int sense = 0;                             ///< 0: has not moved yet
  double fastest = 0;                        ///< speed in the last step, per unit of the path
};

/// Overlap monitoring of one contact.
struct OverlapWatch {
  bool needed = false;    ///< whether the bodies could overlap elsewhere
  bool overlaps = false;  ///< they do now
  bool jumped = false;    ///< the motion has gone over to a second contact: arcs are interrupted
};

/// Whether the bodies of a contact are in each other at the end of the present step.
struct StepOverlap {
  bool overlaps = false;
  Vector2d n_W = Vector2d::UnitX();  ///< along which, of conics
};

/// A change point that the present step leads through.
struct Crossing {
  std::size_t group = 0;
  double s = 0;  ///< on the path
};

/// As near as coupled bodies come to being assembled behind a limit.
struct Nearest {
  State state;
  std::vector<std::optional<LeastViolation>> ways;  ///< of Plan::groups: how they came there
};

/// A limit at which the motion was lost.
struct Loss {
  std::vector<double> from;  ///< the drivers at Run::state, the last position before it
  std::vector<double> at;    ///< the drivers at the limit
  RunEvent event;
  std::optional<double> looked_to;  ///< up to where on the straight line beyond it the branch has been looked
                                    ///< for in vain: coordinate of its leading driver
  std::optional<Nearest> nearest;   ///< with coupled bodies: there
  bool for_good = false;            ///< the path was given up, and is not taken up again
};

/// What runs of one mechanism share and none of them changes.
struct RunModel {
  std::shared_ptr<const Mechanism> mechanism;
  std::shared_ptr<const Plan> plan;  ///< of the mechanism, as make_plan gives it
};

/// The position of a run. A value: that of another run of the same model puts a run there.
struct Standing {
  State state;                  ///< the last position; rates per unit of the path
  std::vector<double> drivers;  ///< the drivers' coordinates there
  std::vector<double> targets;  ///< the drivers of the last row, which may not have been reached
  std::optional<State> beside;  ///< the last row, where it is next to a crossing of branches or at a limit,
                                ///< and `state` short of it
  bool held = true;             ///< false: lost at a limit; `state` is the last position before it
  Loss lost;                    ///< where, while not held
  std::vector<OutputJoint> outputs;
  std::vector<OverlapWatch> watches;     ///< of Mechanism::contacts
  std::vector<Crossing> reported;        ///< change points ahead that events have named; s: the driver
  std::optional<RunEvent> limit_here;    ///< a limit at the last row itself
  std::optional<RunEvent> limit_before;  ///< the same of the row before
};

/// Where steps are tried; means nothing from one row to the next.
struct StepWorkspace {
  State trial;
  std::vector<double> drivers;  ///< in `trial`
  std::vector<DriverMotion> motions;
  std::vector<Crossing> crossings;                  ///< of the present step
  std::vector<StepOverlap> overlaps;                ///< of Mechanism::contacts, in `trial`
  std::vector<std::optional<LeastViolation>> ways;  ///< of Plan::groups, in `trial` behind a limit
  Path path;                                        ///< to the next row
  std::vector<double> row_before;                   ///< the drivers there
};

/// A running analysis. A copy goes on from where it is, on its own and in any thread.
struct Run {
  RunModel model;
  double tolerance = kDefaultClosure;  ///< of the plan's size: larger residuals are not `ok`
  Standing at;
  StepWorkspace work;
  MotionRow row;                            ///< of the last move_to
  std::vector<RunEvent> events;             ///< of the last move_to
  const std::atomic<bool>* stop = nullptr;  ///< once true, move_to gives up within an inner step: its row
                                            ///< and events mean nothing then; may be null

  /// Where boundaries touch: the mechanism with curves that are like them at the row's contacts.
  std::optional<Mechanism> local;

  [[nodiscard]] const Mechanism& mechanism() const { return local ? *local : *model.mechanism; }
  [[nodiscard]] const Plan& plan() const { return *model.plan; }
};

/// A model with a mechanism and a plan of its own.
[[nodiscard]] RunModel make_run_model(Mechanism mechanism, Plan plan);

/// Assembles a mechanism at the first positions of its drivers: of all assemblies the one whose joint points
/// are nearest to their places in the poses (least sum of squares), contacts as their `approach` says.
[[nodiscard]] tl::expected<Run, StartFailure> start_run(const Mechanism& mechanism,
                                                        const std::vector<double>& drivers,
                                                        double tolerance = kDefaultClosure);

/// The same with what other runs may share.
[[nodiscard]] tl::expected<Run, StartFailure> start_run(RunModel model, const std::vector<double>& drivers,
                                                        double tolerance = kDefaultClosure);

/// Whether whoever asked for the run wants it no longer.
[[nodiscard]] inline bool is_stopped(const Run& run) {
  return is_raised(run.stop);
}

/// Moves along the straight path of the drivers to their given positions, in as many inner steps as it takes
/// to stay on the branch, and fills run.row and run.events. A step is accepted only where the solution agrees
/// with the prediction from the rates before. Does not allocate unless an event happens or bodies are
/// coupled.
/// \param drivers  of Mechanism::drivers; velocity and acceleration are those of the row
void move_to(Run& run, const std::vector<DriverMotion>& drivers);

/// Velocities and accelerations of all bodies and contacts of `state`, whose positions are given, for the
/// rates of the drivers.
void set_rates(const Run& run, const std::vector<DriverMotion>& drivers, State& state);

/// Rolls through driver positions and returns the first at which a rolling contact of driver and follower
/// would have to slip, if any: rolling removes two freedoms, and between two grounded joints only special
/// pairs move all the same.
[[nodiscard]] std::optional<Slip> find_slip(const Run& run, const std::vector<double>& positions);

}  // namespace higherpair

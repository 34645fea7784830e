#pragma once

#include "higherpair/cam/motion_law.hpp"
#include "higherpair/drawing/picture.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/units.hpp"
#include "higherpair/mechanism/description.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// What one driver is to do, in the profile's own units (angle for a revolute joint, length for a prismatic
/// one), so that tables repeat the given positions digit by digit.
struct DriverProgram {
  double start = 0;           ///< the profile's, or the joint's coordinate in the poses
  std::optional<double> end;  ///< none: a full turn after `start`; a prismatic joint stays at `start`
  std::optional<std::int64_t> samples;  ///< >= 1; none: kDefaultSamples
  std::vector<double> positions;        ///< if not empty, takes the place of start, end and samples
  double velocity = 0;                  ///< the profile's, or 1 rad/s or 1 length unit per second
  double acceleration = 0;
  std::optional<double> duration;   ///< of `step`, >= 0
  std::optional<double> time_step;  ///< of `step`, > 0
  /// The coordinate as a function of time; takes the place of start, end, velocity and acceleration.
  std::optional<MotionLaw> law;
  std::string law_name;  ///< what messages call it
  Place place;           ///< of the driver's table, for messages
};

/// One degree a row over a full turn.
inline constexpr std::int64_t kDefaultSamples = 361;

/// What a driver does unless told otherwise, in these units: from its coordinate in the poses a full turn at
/// 1 rad/s; a prismatic one stays there, its velocity 1 length unit per second.
[[nodiscard]] DriverProgram default_program(const Mechanism& mechanism, const Driver& driver,
                                            const Units& units);

struct CheckLimits;
struct DesignTask;
struct SweepTask;
struct ToleranceTask;

/// A profile as read: the mechanism in SI units, its units, and what its drivers do.
struct Profile {
  Mechanism mechanism;
  Units units;
  std::vector<DriverProgram> programs;              ///< one for each of mechanism.drivers, in the same order
  Looks looks;                                      ///< how it is drawn
  std::string source;                               ///< what diagnostics call it: the file's name
  std::vector<std::string> files;                   ///< paths of what was read besides: points, drawings
  Diagnostics notes;                                ///< what is probably a slip although it may be meant
  std::shared_ptr<const CheckLimits> limits;        ///< of [limits]; none without it
  std::shared_ptr<const DesignTask> design;         ///< of [design]; none without it
  std::shared_ptr<const SweepTask> sweep;           ///< of [sweep]; none without it
  std::shared_ptr<const ToleranceTask> tolerances;  ///< of [tolerances]; none without it
};

}  // namespace higherpair

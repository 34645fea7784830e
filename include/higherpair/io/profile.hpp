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
#include <string_view>
#include <utility>
#include <vector>

namespace higherpair {

/// The prescribed motion of one driver, in the profile's own units (angle for a revolute joint, length for a
/// prismatic one), so that tables repeat the given positions digit by digit.
struct DriverProgram {
  double start = 0;           ///< the profile's, or the joint's coordinate in the poses
  std::optional<double> end;  ///< none: a full turn after `start`; a prismatic joint stays at `start`
  std::optional<std::int64_t> samples;  ///< >= 1; none: kDefaultSamples
  std::vector<double> positions;        ///< if not empty, replaces start, end and samples
  double velocity = 0;                  ///< the profile's, or 1 rad/s or 1 length unit per second
  double acceleration = 0;
  std::optional<double> duration;   ///< for `step`, >= 0
  std::optional<double> time_step;  ///< for `step`, > 0
  /// The coordinate as a function of time; replaces start, end, velocity and acceleration.
  std::optional<MotionLaw> law;
  std::string law_name;                                   ///< its name in messages
  Place place;                                            ///< of the driver's table, for messages
  std::vector<std::pair<std::string, Place>> key_places;  ///< of its keys that are given

  /// The place of a key, or of the table where it is not given.
  [[nodiscard]] const Place& place_of(std::string_view key) const;
};

/// One row per degree over a full turn.
inline constexpr std::int64_t kDefaultSamples = 361;

/// The default motion of a driver, in these units: a full turn at 1 rad/s from its coordinate in the poses; a
/// prismatic one stays there, with a velocity of 1 length unit per second.
[[nodiscard]] DriverProgram default_program(const Mechanism& mechanism, const Driver& driver,
                                            const Units& units);

struct CheckLimits;
struct DesignTask;
struct FitTask;
struct SweepTask;
struct ToleranceTask;

/// A profile as read: the mechanism in SI units, the units of the profile, and the motion of the drivers.
struct Profile {
  Mechanism mechanism;
  Units units;
  std::vector<DriverProgram> programs;              ///< one for each of mechanism.drivers, in the same order
  Looks looks;                                      ///< how it is drawn
  std::string source;                               ///< its name in diagnostics: that of the file
  std::vector<std::string> files;                   ///< paths of the other files read: points, drawings
  Diagnostics notes;                                ///< on what is valid but probably a slip
  std::shared_ptr<const CheckLimits> limits;        ///< [limits]; null without it
  std::shared_ptr<const DesignTask> design;         ///< [design]; null without it
  std::shared_ptr<const FitTask> fit;               ///< [fit]; null without it
  std::shared_ptr<const SweepTask> sweep;           ///< [sweep]; null without it
  std::shared_ptr<const ToleranceTask> tolerances;  ///< [tolerances]; null without it
};

}  // namespace higherpair

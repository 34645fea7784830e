#pragma once

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/units.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

/// What a profile may say in [limits]: limits of what a mechanism does, and what its bodies are made of.
enum class LimitKey {
  kMaxPressureAngle,
  kMaxReturnPressureAngle,
  kMinConvexRadius,
  kMinConcaveRadius,
  kMaxFaceWidth,
  kMaxSlidingSpeed,
  kMinEntrainmentSpeed,
  kMaxContactForce,
  kMinContactForce,
  kMaxContactPressure,
  kMaxAcceleration,
  kMaxAngularAcceleration,
  kMaxJerk,
  kMaxAngularJerk,
  kMaxDrivingTorque,
  kMaxDrivingForce,
  kMinSpeedFactor,
  kElasticModulus,
  kPoissonRatio,
  kWidth,
};
inline constexpr std::size_t kLimitKeys = 20;

/// Its name in profiles: "max_pressure_angle".
[[nodiscard]] std::string_view name_of(LimitKey key);
[[nodiscard]] Dimension dimension_of(LimitKey key);

struct GivenLimit {
  double value = 0;               ///< SI units
  std::optional<double> profile;  ///< in those of the profile, as written
  std::string path;               ///< "limits.contacts.touch.max_pressure_angle"
  Place place;
};

/// By LimitKey; none where it is not given.
using LimitSet = std::array<std::optional<GivenLimit>, kLimitKeys>;

/// [limits]: what holds for all, and what some contacts, joints and bodies have for themselves.
struct CheckLimits {
  LimitSet all;
  std::vector<LimitSet> contacts;  ///< of Mechanism::contacts; may be empty
  std::vector<LimitSet> joints;    ///< of Mechanism::joints; may be empty
  std::vector<LimitSet> bodies;    ///< of Mechanism::bodies; may be empty
};

/// The limit of one of these things: its own, else that of all; null where neither is given.
[[nodiscard]] const GivenLimit* limit_of(const CheckLimits& limits, const std::vector<LimitSet>& own,
                                         std::size_t index, LimitKey key);

}  // namespace higherpair

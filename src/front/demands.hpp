#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/io/units.hpp"

#include <cmath>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>

#include <fmt/core.h>

namespace higherpair {

/// Whether a quantity in SI units is one that a profile may have: not too large, and no NaN.
[[nodiscard]] inline bool fits(double value) {
  return std::abs(value) <= kLargestQuantity;
}

[[nodiscard]] inline bool fits(const Vector2d& v) {
  return fits(v.x()) && fits(v.y());
}

inline constexpr const char* kFitRule = "must be finite, and at most 1e50 in SI units";

/// What a number that a program sets has to satisfy.
struct Demand {
  bool met = false;
  std::string number;  ///< its path, or "setting samples"
  double value = 0;
  std::string rule;  ///< "must be >= 2"
};

[[nodiscard]] inline Demand positive(std::string number, double value) {
  return {value > 0 && std::isfinite(value), std::move(number), value,
          std::isinf(value) ? "must be finite" : "must be > 0"};
}

template <class Number>
[[nodiscard]] Demand at_least(std::type_identity_t<Number> least, std::string number, Number given) {
  const auto value = static_cast<double>(given);
  return {given >= least && std::isfinite(value), std::move(number), value,
          std::isinf(value) ? "must be finite" : fmt::format("must be >= {}", least)};
}

/// From `low` to `high`, both included.
template <class Number>
[[nodiscard]] Demand within(std::type_identity_t<Number> low, std::type_identity_t<Number> high,
                            std::string number, Number value) {
  return {value >= low && value <= high, std::move(number), static_cast<double>(value),
          fmt::format("must be from {} to {}", low, high)};
}

[[nodiscard]] inline Demand share(std::string number, double value) {
  return {value > 0 && value < 1, std::move(number), value, "must be between 0 and 1"};
}

/// The first demand that is not met, as "setting samples 1: must be >= 2" or "driver.time_step = 0: must be
/// > 0"; empty if all are.
[[nodiscard]] inline std::string first_unmet(std::initializer_list<Demand> demands) {
  for (const Demand& demand : demands) {
    const char* joined = demand.number.starts_with("setting ") ? " " : " = ";
    if (!demand.met) return fmt::format("{}{}{}: {}", demand.number, joined, demand.value, demand.rule);
  }
  return "";
}

}  // namespace higherpair

#pragma once

#include "run_testing.hpp"

#include <cmath>
#include <complex>
#include <optional>

namespace higherpair::testing {

/// The lengths of a four-bar that is driven at the pin between crank and coupler: no body can be placed
/// before the others.
struct FourBar {
  double frame, crank, coupler, rocker;  // mm
};

/// Angle from the frame to the crank in the assembly σ = ±1; none where it cannot be assembled. In the
/// crank's frame the coupler's end B lies on a circle about A, and the frame's pin C on a circle about O.
/// \param driver  angle from the crank to the coupler
inline std::optional<double> crank_angle(const FourBar& bar, double driver, double sigma) {
  const Complex B = bar.crank + bar.coupler * std::polar(1.0, driver);
  const double cosine =
      (std::norm(B) + bar.frame * bar.frame - bar.rocker * bar.rocker) / (2 * bar.frame * std::abs(B));
  if (std::abs(cosine) > 1) return std::nullopt;
  return -(std::arg(B) + sigma * std::acos(cosine));
}

}  // namespace higherpair::testing

#pragma once

#include "higherpair/mechanism/description.hpp"

#include <string>
#include <vector>

namespace higherpair::testing {

/// The motion of a mechanism by other means than the library's: all conditions are solved together in 80-bit
/// arithmetic with the contact normals among the unknowns, in very short steps of the arc length along the
/// solution curve. Slow and simple; it has no groups, branches or events.
struct ReferenceMotion {
  enum class End {
    kReached,  ///< the drivers get to the end of their path
    kLimit,    ///< they turn back before: a limit
    kGaveUp,   ///< not regular at the start, or steps became too short; `why` says which
  };
  End end = End::kGaveUp;
  double share = 0;  ///< of the path, where it ended
  std::string why;
  std::vector<std::vector<double>>
      places;                     ///< at the stations before the end: x, y [m], angle [rad] of the bodies
  std::vector<double> crossings;  ///< shares at which branches cross: passed straight on
};

/// Follows the straight path of the drivers from their first positions [rad or m] to the last.
/// \param stations  fractions of the path, increasing, at which the bodies' poses are wanted
[[nodiscard]] ReferenceMotion reference_motion(const Mechanism& mechanism, const std::vector<double>& from,
                                               const std::vector<double>& to,
                                               const std::vector<double>& stations = {});

}  // namespace higherpair::testing

#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace higherpair {

/// Arc length of a span between two of its parameters, by Gauss's rule with eight points; exact to within
/// rounding on one of its parts() [m]. \pre not a corner
[[nodiscard]] double arc_between(const Span& span, double from, double to);

/// Arc lengths along the chains of a boundary.
class BoundaryArcs {
public:
  explicit BoundaryArcs(std::shared_ptr<const Boundary> boundary);

  /// The arc from the first place of its chain to a place, > 0 along the tangent [m].
  /// \param normal  the angle of the outward normal there in the body's frame [rad]; its whole turns
  ///                count the rounds of a closed chain
  [[nodiscard]] double at(const BoundaryPlace& place, double normal) const;

private:
  struct Mark {
    double arc = 0;     // from the first place of the chain [m]
    double normal = 0;  // angle of the normal, continuous along the chain [rad]
  };
  struct Chain {
    double length = 0;  // [m]
    double turn = 0;    // of the normal once around, 2π or -2π; 0 if the chain is open
  };

  [[nodiscard]] Mark mark_of(const BoundaryPlace& place, std::size_t sample) const;

  std::shared_ptr<const Boundary> boundary_;
  std::vector<Mark> marks_;                          // of the samples
  std::vector<std::size_t> samples_of_, chains_of_;  // of the spans: the first sample, the chain
  std::vector<Chain> chains_;
};

}  // namespace higherpair

#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/joint_sides.hpp"

#include <vector>

namespace higherpair {

/// How far apart the samples of a path are: so near that no contact passes more than one part of a boundary
/// (Span::parts or breaks, or a knot of the law that shaped it) between two of them, as far as its pace since
/// the last sample tells.
class SampleSteps {
public:
  explicit SampleSteps(const Mechanism& mechanism);

  /// The step to the next sample, after the run has moved to one at parameter `at` of the path.
  /// \param longest  the step where no contact passes parts faster
  [[nodiscard]] double next(const Run& run, double at, double longest);

private:
  // One of the two curves of a contact on boundaries.
  struct Side {
    SideOfContact of;
    std::vector<Bounds> ranges;        // of the spans
    std::vector<double> parts_before;  // of each span, and of all
    double at = 0;                     // the place of the last sample, in parts from the first span on
    bool touched = false;              // whether there is one
  };

  // Parts that the contact has passed since the last sample; 0 where it did not touch then or does not now.
  [[nodiscard]] static double passed(Side& side, const Run& run);

  std::vector<Side> sides_;
  double step_ = 0;  // 0: before the first sample
  double last_ = 0;
};

}  // namespace higherpair

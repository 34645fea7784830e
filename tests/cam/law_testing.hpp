#pragma once

#include "higherpair/cam/motion_law.hpp"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair::testing {

inline MotionLaw law_of(const LawDescription& description) {
  auto law = MotionLaw::make(description);
  if (!law) {
    ADD_FAILURE() << law.error().key << ": " << law.error().rule;
    return MotionLaw::make({.segments = {{LawType::kDwell, 1}}}).value();
  }
  return *law;
}

inline MotionLaw law_of(std::vector<LawSegment> segments, bool repeats = false) {
  return law_of({.segments = std::move(segments), .repeats = repeats});
}

/// All laws that rise without further parameters.
inline constexpr LawType kRises[] = {
    LawType::kUniform,      LawType::kParabolic,         LawType::kHarmonic,      LawType::kCycloidal,
    LawType::kModifiedSine, LawType::kModifiedTrapezoid, LawType::kPolynomial345, LawType::kPolynomial4567};

}  // namespace higherpair::testing

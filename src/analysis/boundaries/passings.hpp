#pragma once

#include "analysis/follow/path_events.hpp"

#include <optional>
#include <vector>

// Ends of spans that the other curve of a contact passes, as a pin passes the end of a slot.

namespace higherpair {

/// An end of a span of one curve of a contact, and the other curve, which may pass it.
struct Passing {
  CurveRef own, other;
  BoundaryPlace end;
  double outwards = 1;  ///< +1: the span ends in the direction of growing t
};

/// Appends those ends of a span of the curve `own` at which the next span joins it in a way that counts.
void append_passings(const Run& run, const CurveRef& own, const CurveRef& other, int span,
                     bool (*counts)(SpanJoint), std::vector<Passing>& passings);

/// Where the other curve faces that end: at its place with the opposite normal; a straight one, whose normal
/// does not change, at the foot of the perpendicular from the end.
struct PassingAt {
  double beyond = 0;  ///< distance beyond the end, along its tangent; of a straight one how far its normal
                      ///< has turned beyond that of the end, times the size of the end's curve [m]
  double beside = 0;  ///< distance from the end along its normal [m]
  BoundaryPlace other;
};

/// \param near  a place of the other curve from which the search for the facing one starts
/// \return none if that search does not lead to one
[[nodiscard]] std::optional<PassingAt> passing_at(const Run& run, const Passing& passing, const State& state,
                                                  const BoundaryPlace& near);

/// Where between run.at.state, which is at s, and run.work.trial, h beyond it, the other curve passes the end
/// in either sense, as a distance beyond s. Leaves run.work.trial unchanged.
[[nodiscard]] std::optional<double> passing_within(Run& run, const Path& path, double s, double h,
                                                   const Passing& passing, const BoundaryPlace& near);

}  // namespace higherpair

#include "sample_steps.hpp"

#include "higherpair/cam/flank.hpp"
#include "higherpair/geometry/boundary.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// A step is at most so many times as long as the one before, and at least a fraction of it: at a place to
// which the contact has jumped its pace is unknown.
constexpr double kLonger = 2;
constexpr double kShorter = 0.25;
constexpr double kPartsOfPiece = 4;  // between two breaks, where a derivative may turn
constexpr double kFirst = 0.25;      // of the longest step, where the pace is not known yet

// Parts of a span that may each have a shape of their own.
double parts_of(const Span& span) {
  const double pieces = 1.0 + static_cast<double>(span.breaks().size());
  double parts = std::max(static_cast<double>(span.parts()), kPartsOfPiece * pieces);
  if (const auto origin = flank_origin(span)) {
    const Bounds t = span.range();  // of the cam's coordinate, or of minus it
    const auto knots = std::max(origin->motion.law.breaks(t.low, t.high).size(),
                                origin->motion.law.breaks(-t.high, -t.low).size());
    parts = std::max(parts, static_cast<double>(knots));
  }
  return parts;
}

}  // namespace

SampleSteps::SampleSteps(const Mechanism& mechanism) {
  for (const SideOfContact& of : BoundarySides(mechanism)) {
    const Boundary& boundary = boundary_of(mechanism, ref_of(mechanism.contacts[of.contact], of.side));
    Side& added = sides_.emplace_back(Side{of, {}, {0}});
    for (const SpanPtr& span : boundary.spans()) {
      added.ranges.push_back(span->range());
      added.parts_before.push_back(added.parts_before.back() + parts_of(*span));
    }
  }
}

double SampleSteps::passed(Side& side, const Run& run) {
  const ContactMotion& contact = run.row.contacts[side.of.contact];
  const bool touched = std::exchange(side.touched, contact.touches);
  if (!contact.touches) return 0;
  const BoundaryPlace& place = contact.place[side.of.side];
  const auto span = static_cast<std::size_t>(place.span);
  const Bounds& range = side.ranges[span];
  const double share = range.width() > 0 ? std::clamp((place.t - range.low) / range.width(), 0.0, 1.0) : 0;
  const double was =
      std::exchange(side.at, std::lerp(side.parts_before[span], side.parts_before[span + 1], share));
  const double passed = std::abs(side.at - was);
  return touched ? std::min(passed, side.parts_before.back() - passed) : 0;  // around a closed curve
}

double SampleSteps::next(const Run& run, double at, double longest) {
  double most = 0;
  for (Side& side : sides_) {
    most = std::max(most, passed(side, run));
  }
  const double moved = at - std::exchange(last_, at);
  step_ = step_ == 0   ? kFirst * longest
          : moved <= 0 ? step_
                       : std::clamp(most > 0 ? moved / most : kInf, kShorter * step_, kLonger * step_);
  step_ = std::min(step_, longest);
  return step_;
}

}  // namespace higherpair

#include "higherpair/geometry/boundary_points.hpp"

#include "higherpair/geometry/boundary_arcs.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kProbesOfChord = 8;  // between two points, to measure the distance from the straight line
constexpr int kMostHalvings = 30;

// Arc lengths up to the end of each part of a span; 0 throughout on a corner.
std::vector<double> arcs_of(const Span& span) {
  const Bounds range = span.range();
  const int parts = span.is_corner() ? 1 : span.parts();
  std::vector<double> arcs{0};
  for (int k = 0; k < parts; ++k) {
    const double step = range.width() / parts;
    const double more =
        span.is_corner() ? 0 : arc_between(span, range.low + k * step, range.low + (k + 1) * step);
    arcs.push_back(arcs.back() + more);
  }
  return arcs;
}

double distance_from_line(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d chord = b - a;
  const double length = chord.norm();
  return length > 0 ? std::abs(cross(chord, Vector2d(p - a))) / length : (p - a).norm();
}

// The parameters within (from, to] at which points are placed.
void divide(const Span& span, double from, double to, double tolerance, int halvings,
            std::vector<double>& places) {
  const Vector2d a = span.at(from).p_B;
  const Vector2d b = span.at(to).p_B;
  double worst = 0;
  for (int k = 1; k < kProbesOfChord; ++k) {
    worst = std::max(worst, distance_from_line(span.at(from + (to - from) * k / kProbesOfChord).p_B, a, b));
  }
  if (worst <= tolerance || halvings == kMostHalvings) {
    places.push_back(to);
    return;
  }
  const double half = from + (to - from) / 2;
  divide(span, from, half, tolerance, halvings + 1, places);
  divide(span, half, to, tolerance, halvings + 1, places);
}

// Over half a turn, the ends may be closer to each other than to the curve between them: begin with parts.
std::vector<double> places_of(const Span& span, double tolerance) {
  constexpr int kLeastParts = 4;
  const Bounds range = span.range();
  std::vector<double> places{range.low};
  const int parts = span.parts() == 1 ? 1 : kLeastParts;
  for (int k = 0; k < parts; ++k) {
    const double from = range.low + range.width() * k / parts;
    const double to = k + 1 == parts ? range.high : range.low + range.width() * (k + 1) / parts;
    divide(span, from, to, tolerance, 0, places);
  }
  return places;
}

bool turns_at(SpanJoint joint) {
  return joint == SpanJoint::kNotch || joint == SpanJoint::kEnd;
}

}  // namespace

double length_of(const Boundary& boundary) {
  double length = 0;
  for (const SpanPtr& span : boundary.spans()) {
    length += arcs_of(*span).back();
  }
  return length;
}

std::vector<BoundaryStation> points_within(const Boundary& boundary, double tolerance) {
  assert(tolerance > 0);
  std::vector<BoundaryStation> stations;
  double begin = 0;
  const std::size_t count = boundary.spans().size();
  for (std::size_t i = 0; i < count; ++i) {
    const Span& span = *boundary.spans()[i];
    if (span.is_corner()) {
      for (const double t : {span.range().low, span.range().high}) {
        stations.push_back({begin, span.at(t), true});
      }
      continue;
    }
    std::vector<double> places = places_of(span, tolerance);
    const SpanJoint joint = boundary.joint_after(static_cast<int>(i));
    const double length = arcs_of(span).back();
    double arc = begin;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const bool last = k + 1 == places.size();
      arc += k == 0 ? 0 : arc_between(span, places[k - 1], places[k]);
      const bool own = !last || turns_at(joint);  // else the next span has it
      const bool behind_corner = k == 0 && boundary.spans()[(i + count - 1) % count]->is_corner();
      if (own && !behind_corner) {
        stations.push_back({last ? begin + length : arc, span.at(places[k]), false});
      }
    }
    begin += length;
  }
  return stations;
}

std::vector<BoundaryStation> points_at_equal_arcs(const Boundary& boundary, int count) {
  assert(count >= 2);
  const double length = length_of(boundary);
  const double step = length / (boundary.is_closed() ? count : count - 1);
  std::vector<BoundaryStation> stations;
  double begin = 0;
  for (std::size_t i = 0; i < boundary.spans().size(); ++i) {
    const Span& span = *boundary.spans()[i];
    const std::vector<double> arcs = arcs_of(span);
    const bool final_one = i + 1 == boundary.spans().size() && !boundary.is_closed();
    for (std::size_t part = 0; part + 1 < arcs.size() && !span.is_corner(); ++part) {
      const double step_t = span.range().width() / static_cast<double>(arcs.size() - 1);
      const double from = span.range().low + static_cast<double>(part) * step_t;
      const bool to_end = final_one && part + 2 == arcs.size();
      while (static_cast<int>(stations.size()) < count) {
        const double wanted = static_cast<double>(stations.size()) * step;
        const double within = wanted - begin - arcs[part];
        const double here = arcs[part + 1] - arcs[part];
        if (within >= here && !to_end) {
          break;
        }
        // Newton's method for the arc length from the beginning of the part.
        double t = from + step_t * std::clamp(within / here, 0.0, 1.0);
        constexpr int kMost = 8;
        for (int k = 0; k < kMost; ++k) {
          const double more = (within - arc_between(span, from, t)) / span.at(t).speed;
          t = std::clamp(t + more, from, from + step_t);
        }
        stations.push_back({wanted, span.at(t), false});
      }
    }
    begin += arcs.back();
  }
  return stations;
}

}  // namespace higherpair

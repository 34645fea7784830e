#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/contour.hpp"
#include "higherpair/geometry/polyline.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/tolerances.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace higherpair {
namespace {

// A straight line between two neighbouring samples of a span.
struct Chord {
  int span = 0;
  Bounds t;
  Vector2d from = Vector2d::Zero();
  Vector2d to = Vector2d::Zero();
};

// Neighbouring samples share a chord as long as the span hardly turns.
std::vector<Chord> chords_of(const Boundary& boundary) {
  const double straight = std::cos(0.15);
  std::vector<Chord> chords;
  Vector2d n_B = Vector2d::Zero();  // normal at the beginning of the last chord
  const auto& samples = boundary.samples();
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const auto& a = samples[i];
    const auto& b = samples[i + 1];
    if (a.place.span != b.place.span || boundary.is_corner(a.place)) {
      continue;
    }
    const bool goes_on = !chords.empty() && chords.back().span == a.place.span;
    if (goes_on && n_B.dot(b.point.n_B) > straight) {
      chords.back().t.high = b.place.t;
      chords.back().to = b.point.p_B;
    } else {
      chords.push_back({a.place.span, {a.place.t, b.place.t}, a.point.p_B, b.point.p_B});
      n_B = a.point.n_B;
    }
  }
  return chords;
}

// The fractions of both chords at which they meet, if that is on both; their ends count as well, with a
// margin for rounding.
std::optional<Vector2d> common_point(const Chord& a, const Chord& b) {
  return shares_of_crossing(a.from, a.to - a.from, b.from, b.to - b.from, kChordEndRounding);
}

// The next span beyond the end of a span, skipping corners; none at the end of an open boundary, unless the
// search wraps to the other end.
std::optional<int> span_beyond(const Boundary& boundary, int span, bool high, bool over_ends) {
  const int from = span;
  do {
    if (!over_ends && boundary.joint_after(high ? span : boundary.next_span(span, high)) == SpanJoint::kEnd) {
      return std::nullopt;
    }
    span = boundary.next_span(span, high);
  } while (span != from && boundary.spans()[span]->is_corner());
  return span;
}

// A place moved along its span, at most to the beginning of the next one.
BoundaryPlace moved_along(const Boundary& boundary, const BoundaryPlace& from, double dt) {
  const Bounds range = range_of(boundary, from.span);
  const double t = from.t + dt;
  if (range.contains(t)) {
    return {from.span, t};
  }
  const bool high = t > range.high;
  const auto beyond = span_beyond(boundary, from.span, high, false);
  return beyond ? end_of(boundary, *beyond, !high) : end_of(boundary, from.span, high);
}

bool is_near_end(const Boundary& boundary, const BoundaryPlace& place, bool high) {
  return std::abs(place.t - end_of(boundary, place.span, high).t) <
         kSameCrossingPlace * range_of(boundary, place.span).width();
}

// The ends of an open boundary may touch, as those of a flank over one turn do: that is a joint, too.
bool is_one_place(const Boundary& boundary, const BoundaryPlace& a, const BoundaryPlace& b) {
  const auto is_joint = [&](bool high) {
    return is_near_end(boundary, a, high) && is_near_end(boundary, b, !high) &&
           span_beyond(boundary, a.span, high, true) == b.span;
  };
  return (a.span == b.span &&
          std::abs(a.t - b.t) <= kSameCrossingPlace * range_of(boundary, a.span).width()) ||
         is_joint(false) || is_joint(true);
}

// The crossing of the curves themselves, by Newton's method; none if the iteration leaves the chords.
std::optional<SelfCrossing> refined(const Boundary& boundary, const Chord& a, const Chord& b,
                                    const Vector2d& parts) {
  const auto begin = [](const Chord& chord, double part) {
    return BoundaryPlace{chord.span, chord.t.low + std::clamp(part, 0.0, 1.0) * chord.t.width()};
  };
  const auto is_near = [](const Chord& chord, const Vector2d& p_B) {
    return (p_B - (chord.from + chord.to) / 2).norm() <= kBesideChord * (chord.to - chord.from).norm();
  };
  BoundaryPlace first = begin(a, parts(0));
  BoundaryPlace second = begin(b, parts(1));
  constexpr int kMost = 20;
  for (int i = 0; i < kMost; ++i) {
    const SpanPoint p = boundary.at(first);
    const SpanPoint q = boundary.at(second);
    if (!is_near(a, p.p_B) || !is_near(b, q.p_B)) {
      return std::nullopt;
    }
    const Vector2d gap = q.p_B - p.p_B;
    const double sine = cross(p.n_B, q.n_B);
    const double dt = cross(gap, perp(q.n_B)) / sine / p.speed;
    const double du = cross(gap, perp(p.n_B)) / sine / q.speed;
    if (!std::isfinite(dt) || !std::isfinite(du)) {
      return std::nullopt;
    }
    if (std::abs(dt) <= kCrossingSettled * a.t.width() && std::abs(du) <= kCrossingSettled * b.t.width()) {
      // Where the curves are parallel, as at a smooth joint, the steps are rounding or 0 however far apart
      // they are.
      const double length = (a.to - a.from).norm() + (b.to - b.from).norm();
      return gap.norm() > kCrossingSettled * length || is_one_place(boundary, first, second)
                 ? std::nullopt
                 : std::optional(SelfCrossing{first, second, p.p_B});
    }
    first = moved_along(boundary, first, dt);
    second = moved_along(boundary, second, du);
  }
  return std::nullopt;
}

// A grid of squares, about as many as there are chords, each with the chords that may pass through it.
class Grid {
public:
  explicit Grid(const std::vector<Chord>& chords) {
    Eigen::AlignedBox2d all;
    for (const Chord& chord : chords) {
      all.extend(chord.from);
      all.extend(chord.to);
    }
    low_ = all.min();
    side_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(chords.size()))));
    width_ = std::max(all.sizes().maxCoeff() / side_, kNeverZero);
    cells_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
    for (std::size_t i = 0; i < chords.size(); ++i) {
      for_each_cell(chords[i], [&](std::vector<std::size_t>& cell) { cell.push_back(i); });
    }
  }

  template <class Function>
  void for_each_cell(const Chord& chord, const Function& function) {
    const Vector2d low = chord.from.cwiseMin(chord.to);
    const Vector2d high = chord.from.cwiseMax(chord.to);
    for (int y = index(low.y() - low_.y()); y <= index(high.y() - low_.y()); ++y) {
      for (int x = index(low.x() - low_.x()); x <= index(high.x() - low_.x()); ++x) {
        function(cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) +
                        static_cast<std::size_t>(x)]);
      }
    }
  }

private:
  [[nodiscard]] int index(double distance) const {
    return std::clamp(static_cast<int>(distance / width_), 0, side_ - 1);
  }

  Vector2d low_ = Vector2d::Zero();
  double width_ = 1;
  int side_ = 1;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace

std::optional<SelfCrossing> find_self_crossing(const Boundary& boundary) {
  const std::vector<Chord> chords = chords_of(boundary);
  if (chords.empty()) {
    return std::nullopt;
  }
  Grid grid(chords);
  for (std::size_t i = 0; i < chords.size(); ++i) {
    std::optional<SelfCrossing> found;
    grid.for_each_cell(chords[i], [&](const std::vector<std::size_t>& cell) {
      for (const std::size_t k : cell) {
        const bool next = k == i + 1 && chords[k].span == chords[i].span;
        const auto parts = k > i && !next && !found ? common_point(chords[i], chords[k]) : std::nullopt;
        if (parts) found = refined(boundary, chords[i], chords[k], *parts);
      }
    });
    if (found) {
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace higherpair

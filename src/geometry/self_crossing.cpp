#include "higherpair/geometry/contour.hpp"

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

// Neighbouring samples between which a span hardly turns share a chord.
std::vector<Chord> chords_of(const Boundary& boundary) {
  const double straight = std::cos(0.15);
  std::vector<Chord> chords;
  Vector2d n_B = Vector2d::Zero();  // normal at the begin of the last chord
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

// The parts of both chords before their common point, if that lies on both.
std::optional<Vector2d> common_point(const Chord& a, const Chord& b) {
  const Vector2d u = a.to - a.from;
  const Vector2d v = b.to - b.from;
  const double sine = cross(u, v);
  if (sine == 0) {
    return std::nullopt;
  }
  const Vector2d between = b.from - a.from;
  const Vector2d parts(cross(between, v) / sine, cross(between, u) / sine);
  const bool on_both = (parts.array() >= 0).all() && (parts.array() <= 1).all();
  return on_both ? std::optional(parts) : std::nullopt;
}

bool is_near_joint(const Span& span, double t) {
  const Bounds range = span.range();
  const double near = 1e-6 * range.width();
  return t - range.low < near || range.high - t < near;
}

// The crossing of the curves themselves, by Newton's method, if it is no more than a chord away.
std::optional<SelfCrossing> refined(const Boundary& boundary, const Chord& a, const Chord& b,
                                    const Vector2d& parts) {
  const Span& first = *boundary.spans()[static_cast<std::size_t>(a.span)];
  const Span& second = *boundary.spans()[static_cast<std::size_t>(b.span)];
  double t = a.t.low + parts(0) * a.t.width();
  double u = b.t.low + parts(1) * b.t.width();
  constexpr int kMost = 20;
  for (int i = 0; i < kMost; ++i) {
    const SpanPoint p = first.at(t);
    const SpanPoint q = second.at(u);
    const Vector2d gap = q.p_B - p.p_B;
    const double sine = cross(p.n_B, q.n_B);
    const double dt = cross(gap, perp(q.n_B)) / sine / p.speed;
    const double du = cross(gap, perp(p.n_B)) / sine / q.speed;
    t += dt;
    u += du;
    const bool near = std::abs(t - (a.t.low + a.t.high) / 2) <= 1.5 * a.t.width() &&
                      std::abs(u - (b.t.low + b.t.high) / 2) <= 1.5 * b.t.width();
    if (!near || !first.range().contains(t) || !second.range().contains(u)) {
      return std::nullopt;
    }
    if (std::abs(dt) <= 1e-9 * a.t.width() && std::abs(du) <= 1e-9 * b.t.width()) {
      const bool at_joint = is_near_joint(first, t) && is_near_joint(second, u);
      const bool same = a.span == b.span && std::abs(t - u) <= 1e-6 * first.range().width();
      return at_joint || same ? std::nullopt
                              : std::optional(SelfCrossing{{a.span, t}, {b.span, u}, first.at(t).p_B});
    }
  }
  return std::nullopt;
}

// Squares over all chords, about as many as there are chords, each with those that may pass through it.
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
    width_ = std::max(all.sizes().maxCoeff() / side_, 1e-300);
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

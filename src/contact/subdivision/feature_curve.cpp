#include "feature_curve.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"

#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// The bridge at the joint after a span, by its index as a span; and vice versa.
int bridge_at(int joint) {
  return -1 - joint;
}
int joint_of_bridge(int span) {
  return -1 - span;
}

double norm_of(const IntervalVector& v) {
  return std::hypot(boost::numeric::norm(v.x), boost::numeric::norm(v.y));
}

}  // namespace

double least_sine(const std::vector<Stretch>& parts1, const std::vector<Stretch>& parts2) {
  double least = 1;
  int sign = 0;
  for (const Stretch& one : parts1) {
    for (const Stretch& two : parts2) {
      const Interval passing = cross(one.slope, two.slope);
      const int here = passing.lower() > 0 ? 1 : passing.upper() < 0 ? -1 : 0;
      if (here == 0 || here == -sign) {
        return 0;
      }
      sign = here;
      least = std::min(least, std::min(std::abs(passing.lower()), std::abs(passing.upper())) /
                                  (norm_of(one.slope) * norm_of(two.slope)));
    }
  }
  return least;
}

FeatureCurve::FeatureCurve(const Boundary& boundary, const Pose<double>& X_WB, const OneFreedom& follower,
                           double sense, double length, double error)
    : boundary_(&boundary), X_WB_(X_WB), follower_(follower), sense_(sense), length_(length), error_(error) {}

double FeatureCurve::error_at(const Vector2d& m) const {
  return error_ + kErrorOfPoints * (boundary_->size() + m.norm());
}

std::optional<Stretch> FeatureCurve::over(int span, const Bounds& t) const {
  if (span < 0) {
    return bridge(joint_of_bridge(span), t);
  }
  const auto bounds = boundary_->spans()[span]->bounds(t);
  if (!bounds || !std::isfinite(bounds->speed.width()) || !std::isfinite(bounds->turn.width())) {
    return std::nullopt;
  }
  const double middle = (t.low + t.high) / 2;
  const SpanPoint point = boundary_->at({span, middle});
  const Vector2d n_W = sense_ * (X_WB_.R_WB * point.n_B);
  const Vector2d m = X_WB_ * point.p_B - follower_.p_WO;
  Stretch stretch;
  stretch.span = span;
  stretch.t = t;
  stretch.from_middle = to_interval(t) - middle;
  stretch.flat = bounds->turn.low == 0 && bounds->turn.high == 0;
  const Interval phi =
      around(angle_of(n_W), kErrorOfPoints) + to_interval(bounds->turn) * stretch.from_middle;
  const IntervalVector n = unit_interval(phi);
  const Interval distance = sense_ * to_interval(bounds->speed) * stretch.from_middle;  // along n turned +90°
  const Interval error = around(0, error_at(m));
  const IntervalVector p = {m.x() + error - distance * n.y, m.y() + error + distance * n.x};
  if (follower_.turns) {
    stretch.q = phi;
    enclose_turning({m, n_W}, p, *bounds, n, stretch);
  } else {
    stretch.q = p.dot(exactly(follower_.direction_W));
    enclose_sliding({m, n_W}, phi, *bounds, n, stretch);
  }
  return stretch;
}

void FeatureCurve::enclose_turning(const Middle& at, const IntervalVector& p, const SpanBounds& bounds,
                                   const IntervalVector& n, Stretch& stretch) const {
  const Interval turn = to_interval(bounds.turn);
  const Interval speed = sense_ * to_interval(bounds.speed);
  const Interval error = around(0, 2 * error_at(at.m));
  stretch.middle = {at.m.dot(at.n) + error, at.m.dot(perp(at.n)) + error};
  stretch.range = {p.dot(n), p.dot(n.turned())};
  // Twice: the slope narrows the range, and the narrower range improves the slope.
  for (int pass = 0; pass < 2; ++pass) {
    stretch.slope = {turn * stretch.range.y, speed - turn * stretch.range.x};
    const IntervalVector by_slope = {stretch.middle.x + stretch.slope.x * stretch.from_middle,
                                     stretch.middle.y + stretch.slope.y * stretch.from_middle};
    stretch.range = {intersect(stretch.range.x, by_slope.x), intersect(stretch.range.y, by_slope.y)};
  }
}

void FeatureCurve::enclose_sliding(const Middle& at, const Interval& phi, const SpanBounds& bounds,
                                   const IntervalVector& n, Stretch& stretch) const {
  const Vector2d across = perp(follower_.direction_W);
  const Interval speed = sense_ * to_interval(bounds.speed);
  stretch.middle = {length_ * around(angle_of(at.n), kErrorOfPoints),
                    at.m.dot(across) + around(0, error_at(at.m))};
  stretch.slope = {length_ * to_interval(bounds.turn), speed * n.dot(exactly(follower_.direction_W))};
  stretch.range = {length_ * phi, stretch.middle.y + stretch.slope.y * stretch.from_middle};
}

std::optional<std::vector<Stretch>> FeatureCurve::pieces() const {
  std::vector<Stretch> pieces;
  for (std::size_t i = 1; i < boundary_->samples().size(); ++i) {
    const BoundaryPlace& from = boundary_->samples()[i - 1].place;
    const BoundaryPlace& to = boundary_->samples()[i].place;
    if (from.span != to.span) {
      continue;
    }
    auto piece = over(from.span, {from.t, to.t});
    if (!piece) {
      return std::nullopt;
    }
    pieces.push_back(*std::move(piece));
  }
  for (int joint = 0; joint < static_cast<int>(boundary_->spans().size()); ++joint) {
    if (auto gap = gap_at(joint)) {
      pieces.push_back(*std::move(gap));
    }
  }
  return pieces;
}

Stretch FeatureCurve::bridge(int joint, const Bounds& t) const {
  const Stretch from = at(end_of(*boundary_, joint, true));
  const Stretch to = at(end_of(*boundary_, boundary_->next_span(joint, true), false));
  Vector2d gap = median_of(to.middle - from.middle);
  double dq = boost::numeric::median(to.q - from.q);
  if (follower_.turns) {
    dq = std::remainder(dq, 2 * kPi);
  } else {
    gap.x() = std::remainder(gap.x(), 2 * kPi * length_);
  }
  const double middle = (t.low + t.high) / 2;
  Stretch stretch;
  stretch.span = bridge_at(joint);
  stretch.t = t;
  stretch.from_middle = to_interval(t) - middle;
  stretch.slope = exactly(gap);
  stretch.middle = {from.middle.x + middle * gap.x(), from.middle.y + middle * gap.y()};
  stretch.range = {stretch.middle.x + gap.x() * stretch.from_middle,
                   stretch.middle.y + gap.y() * stretch.from_middle};
  stretch.q = boost::numeric::hull(from.q, from.q + dq);
  return stretch;
}

// The bridge across a joint whose spans do not quite meet; none if they do.
std::optional<Stretch> FeatureCurve::gap_at(int joint) const {
  const SpanJoint kind = boundary_->joint_after(joint);
  if (kind == SpanJoint::kEnd || kind == SpanJoint::kNotch) {
    return std::nullopt;
  }
  Stretch whole = bridge(joint, {0, 1});
  return median_of(whole.slope).norm() > kSmoothJoint * length_ ? std::optional(std::move(whole))
                                                                : std::nullopt;
}

// Change of the parameter over `reach` along the boundary, but at most half of the span.
double FeatureCurve::step_along(const BoundaryPlace& from, double reach) const {
  const IntervalVector slope = at(from).slope;
  const double speed = std::max(boost::numeric::norm(slope.x), boost::numeric::norm(slope.y));
  const double half = range_of(*boundary_, from.span).width() / 2;
  return speed * half > reach ? reach / speed : half;
}

std::vector<Stretch> FeatureCurve::parts_near(const BoundaryPlace& place, double reach) const {
  const Bounds range = range_of(*boundary_, place.span);
  const double step = step_along(place, reach);
  std::vector<Stretch> parts;
  parts.push_back(
      *over(place.span, {std::max(range.low, place.t - step), std::min(range.high, place.t + step)}));
  for (const bool forward : {false, true}) {
    const bool leaves = forward ? place.t + step > range.high : place.t - step < range.low;
    const auto end = leaves ? end_ahead(*boundary_, place, forward) : std::nullopt;
    if (!end) {
      continue;
    }
    const BoundaryPlace& next = end->behind;
    const double length = step_along(next, reach);
    parts.push_back(
        *over(next.span, forward ? Bounds{next.t, next.t + length} : Bounds{next.t - length, next.t}));
    if (auto gap = gap_at(forward ? place.span : next.span)) {
      parts.push_back(*std::move(gap));
    }
  }
  return parts;
}

const std::array<Stretch, 2>& FeatureCurve::halves(const Stretch& whole) const {
  if (!whole.halves) {
    const double middle = (whole.t.low + whole.t.high) / 2;
    whole.halves = std::make_unique<std::array<Stretch, 2>>();
    (*whole.halves)[0] = *over(whole.span, {whole.t.low, middle});
    (*whole.halves)[1] = *over(whole.span, {middle, whole.t.high});
  }
  return *whole.halves;
}

}  // namespace higherpair

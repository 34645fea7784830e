#include "higherpair/geometry/boundary.hpp"

#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/geometry/local_conic.hpp"
#include "higherpair/geometry/outline.hpp"
#include "higherpair/geometry/support_chains.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>

namespace higherpair {
namespace {

SpanPoint first_of(const Span& span) {
  return span.at(span.range().low);
}

SpanPoint last_of(const Span& span) {
  return span.at(span.range().high);
}

// The chain with its convex corners inserted as spans.
std::vector<SpanPtr> with_corners(std::vector<SpanPtr> spans, bool closed) {
  std::vector<SpanPtr> all;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    all.push_back(spans[i]);
    if (i + 1 == spans.size() && !closed) {
      break;
    }
    const Span& next = *spans[(i + 1) % spans.size()];
    const SpanPoint end = last_of(*spans[i]);
    const double turn = angle_from_to(end.n_B, first_of(next).n_B);
    if (turn > kSameJointDirection && !spans[i]->is_corner() && !next.is_corner()) {
      const double from = std::atan2(end.n_B.y(), end.n_B.x());
      all.push_back(corner_span(first_of(next).p_B, from, from + turn));
    }
  }
  return all;
}

SpanJoint joint_of_ends(const Span& before, const Span& after, double size) {
  if (before.is_corner() || after.is_corner()) {
    return SpanJoint::kCurvatureJump;
  }
  const SpanPoint a = last_of(before);
  const SpanPoint b = first_of(after);
  if (angle_from_to(a.n_B, b.n_B) < -kSameJointDirection) {
    return SpanJoint::kNotch;
  }
  const double scale = std::max({std::abs(a.kappa), std::abs(b.kappa), 1 / size});
  return std::abs(a.kappa - b.kappa) <= kSameJointCurvature * scale ? SpanJoint::kSmooth
                                                                    : SpanJoint::kCurvatureJump;
}

std::vector<Boundary::Sample> sampled(const std::vector<SpanPtr>& spans) {
  std::vector<Boundary::Sample> samples;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Bounds range = spans[i]->range();
    const int parts = spans[i]->parts();
    for (int k = 0; k <= parts; ++k) {
      const double t = k == parts ? range.high : range.low + k * (range.width() / parts);
      samples.push_back({{static_cast<int>(i), t}, spans[i]->at(t)});
    }
  }
  return samples;
}

bool is_convex_chain(const std::vector<Boundary::Sample>& samples, const std::vector<SpanJoint>& joints,
                     double size) {
  return std::none_of(joints.begin(), joints.end(),
                      [](SpanJoint joint) { return joint == SpanJoint::kNotch; }) &&
         std::none_of(samples.begin(), samples.end(), [&](const Boundary::Sample& sample) {
           return sample.point.kappa < -kSameJointCurvature / size;
         });
}

}  // namespace

tl::expected<Boundary, BoundaryFault> Boundary::make(std::vector<SpanPtr> spans, bool closed,
                                                     double tolerance) {
  using Kind = BoundaryFault::Kind;
  if (spans.empty()) {
    return tl::unexpected(BoundaryFault{Kind::kEmpty, 0, 0});
  }
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const bool last = i + 1 == spans.size();
    if (last && !closed) {
      break;
    }
    const double distance = (first_of(*spans[(i + 1) % spans.size()]).p_B - last_of(*spans[i]).p_B).norm();
    if (!(distance <= tolerance)) {
      return tl::unexpected(BoundaryFault{last ? Kind::kOpen : Kind::kGap, static_cast<int>(i), distance});
    }
  }
  Boundary boundary;
  boundary.closed_ = closed;
  boundary.spans_ = with_corners(std::move(spans), closed);
  boundary.samples_ = sampled(boundary.spans_);
  for (const Sample& sample : boundary.samples_) {
    if (!(sample.point.speed > 0) || !sample.point.p_B.allFinite()) {
      return tl::unexpected(BoundaryFault{Kind::kCusp, sample.place.span, 0});
    }
  }
  boundary.set_outline({});
  const std::size_t count = boundary.spans_.size();
  for (std::size_t i = 0; i < count; ++i) {
    boundary.next_.push_back(static_cast<int>((i + 1) % count));
    boundary.previous_.push_back(static_cast<int>((i + count - 1) % count));
    boundary.joints_.push_back(i + 1 == count && !closed
                                   ? SpanJoint::kEnd
                                   : joint_of_ends(*boundary.spans_[i], *boundary.spans_[(i + 1) % count],
                                                   boundary.size_ > 0 ? boundary.size_ : 1));
  }
  boundary.convex_ =
      is_convex_chain(boundary.samples_, boundary.joints_, boundary.size_ > 0 ? boundary.size_ : 1);
  return boundary;
}

// From the samples.
void Boundary::set_outline(std::vector<Polyline> solids) {
  Vector2d low = Vector2d::Constant(kInf);
  Vector2d high = -low;
  for (const Sample& sample : samples_) {
    low = low.cwiseMin(sample.point.p_B);
    high = high.cwiseMax(sample.point.p_B);
  }
  arcs_.assign(spans_.size(), true);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const auto& [place, point] = samples_[i];
    const bool first = i == 0 || samples_[i - 1].place.span != place.span;
    const bool same = point.slope == 0 && (first || samples_[i - 1].point.kappa == point.kappa);
    arcs_[place.span] = arcs_[place.span] && same;
  }
  outline_ = std::make_shared<const Outline>(samples_, std::move(solids));
  size_ = (high - low).norm() / 2;
  middle_B_ = (low + high) / 2;
}

// Its chains, where there are several and all of them are closed with the material inside.
std::vector<Polyline> Boundary::solids() const {
  std::vector<Polyline> solids;
  for (std::size_t begin = 0, end = 0; begin < samples_.size(); begin = end) {
    const int last = next_span(samples_[begin].place.span, false);
    Features chain;
    double area = 0;
    Vector2d last_arm = Vector2d::Zero();
    for (; end < samples_.size() && samples_[end].place.span <= last; ++end) {
      const auto& [place, point] = samples_[end];
      chain.push_back({point.p_B, place});
      const Vector2d arm = point.p_B - chain.front().at;
      area += cross(last_arm, arm);
      last_arm = arm;
    }
    if (joint_after(last) == SpanJoint::kEnd || !(area > 0)) {
      return {};
    }
    solids.emplace_back(std::move(chain));
  }
  return solids.size() > 1 ? solids : std::vector<Polyline>{};
}

Boundary Boundary::of_parts(const std::vector<Boundary>& parts) {
  Boundary all;
  all.closed_ = true;
  all.convex_ = parts.size() == 1 && parts.front().convex_;
  for (const Boundary& part : parts) {
    const int first = static_cast<int>(all.spans_.size());
    const auto moved_on = [first](int span) { return first + span; };
    all.spans_.insert(all.spans_.end(), part.spans_.begin(), part.spans_.end());
    all.joints_.insert(all.joints_.end(), part.joints_.begin(), part.joints_.end());
    std::transform(part.next_.begin(), part.next_.end(), std::back_inserter(all.next_), moved_on);
    std::transform(part.previous_.begin(), part.previous_.end(), std::back_inserter(all.previous_), moved_on);
    for (Sample sample : part.samples_) {
      sample.place.span += first;
      all.samples_.push_back(sample);
    }
    all.closed_ = all.closed_ && part.closed_;
  }
  all.set_outline(all.solids());
  return all;
}

Boundary::Advance Boundary::advance(const BoundaryPlace& from, double ds, double dphi) const {
  const int count = static_cast<int>(spans_.size());
  BoundaryPlace place = from;
  const bool corner = is_corner(place);
  place.t += corner ? dphi : ds / at(place).speed;
  // Only an iteration that has gone astray passes more spans than there are.
  for (int passed = 0; passed <= count; ++passed) {
    const Span& span = *spans_[place.span];
    const Bounds range = span.range();
    const double beyond = place.t > range.high ? place.t - range.high : std::min(place.t - range.low, 0.0);
    if (beyond == 0) {
      return {place};
    }
    const bool forward = beyond > 0;
    const int next = next_span(place.span, forward);
    const double end = forward ? range.high : range.low;
    const SpanJoint joint = joint_after(forward ? place.span : next);
    if (joint == SpanJoint::kNotch || joint == SpanJoint::kEnd) {
      return {{place.span, end}, true, joint == SpanJoint::kEnd};
    }
    const Span& other = *spans_[next];
    const double start = forward ? other.range().low : other.range().high;
    // What is left is an arc; the rest of a corner's turn cannot be converted into one.
    const double left = span.is_corner() || other.is_corner() ? 0 : beyond * span.at(end).speed;
    place = {next, left == 0 ? start : start + left / other.at(start).speed};
  }
  const Bounds range = spans_[place.span]->range();
  return {{place.span, std::clamp(place.t, range.low, range.high)}};
}

Curve local_curve(const SpanPoint& point, bool corner, bool arc) {
  Curve curve;
  curve.vertex_B = point.p_B;
  if (corner) {
    return curve;
  }
  curve.axis_B = -point.n_B;
  if (point.kappa == 0) {
    curve.kind = CurveKind::kLine;
    curve.slope = point.slope;
    return curve;
  }
  curve.side = point.kappa > 0 ? Side::kInside : Side::kOutside;
  const double tau = -point.slope / (3 * point.kappa * point.kappa);
  const bool circle = (tau == 0 && arc) || !(std::abs(tau) < kSteepestParabola);
  const LocalConic<double> conic = local_conic(point.p_B, point.n_B, point.kappa, point.slope, circle);
  curve.kind = circle ? CurveKind::kCircle : CurveKind::kParabola;
  curve.vertex_B = conic.vertex_B;
  curve.axis_B = conic.axis_B;
  curve.semi_latus = conic.semi_latus;
  curve.q = circle ? 1 : 0;
  curve.kappa = circle && point.slope != 0 ? point.kappa : 0;
  curve.slope = circle ? point.slope : 0;
  return curve;
}

Boundary boundary_of(const Curve& curve, double reach) {
  if (curve.support != nullptr) {
    const std::vector<Boundary> chains = support_chains(*curve.support, reach);
    assert(!chains.empty());
    return Boundary::of_parts(chains);
  }
  std::vector<SpanPtr> spans;
  bool closed = true;
  if (is_point(curve)) {
    spans.push_back(corner_span(curve.vertex_B, -kPi, kPi));
  } else if (is_line(curve)) {
    const Vector2d t = -perp(curve.axis_B);
    spans.push_back(face_span(curve.vertex_B, t, {-reach, reach}));
    closed = false;
  } else {
    const PlacedCurve<double> placed = place(curve, Pose<double>{});
    const auto normals = normals_of(placed);
    closed = !normals;
    double from = -kPi;
    double to = kPi;
    if (normals) {
      // Half of the cone that is within reach, by bisection: farther out, points move away without bound.
      double inside = 0;
      double outside = normals->half;
      for (int i = 0; i < 60; ++i) {
        const double half = (inside + outside) / 2;
        const Vector2d n = unit_vector(normals->middle + half);
        const bool within =
            has_point(placed, n) && (support_point(placed, n).p_W - curve.vertex_B).norm() <= reach;
        (within ? inside : outside) = half;
      }
      from = normals->middle - inside;
      to = normals->middle + inside;
    }
    spans.push_back(conic_span(curve, from, to));
  }
  return *Boundary::make(std::move(spans), closed, kInf);
}

}  // namespace higherpair

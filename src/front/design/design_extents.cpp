#include "design_extents.hpp"

#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/support.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <optional>

namespace higherpair {
namespace {

constexpr int kMostBoundaryPasses = 20;  // of Newton's method on a boundary

// How far a boundary reaches along a unit direction: the best of its samples, refined to where the normal has
// this direction.
double far_along(const Boundary& boundary, const Vector2d& n_B) {
  const auto& samples = boundary.samples();
  const auto far = [&](const SpanPoint& point) { return point.p_B.dot(n_B); };
  const auto best = std::max_element(samples.begin(), samples.end(), [&](const auto& a, const auto& b) {
    return far(a.point) < far(b.point);
  });
  double farthest = far(best->point);
  BoundaryPlace place = best->place;
  for (int pass = 0; pass < kMostBoundaryPasses; ++pass) {
    const SpanPoint point = boundary.at(place);
    const double turn = angle_from_to(point.n_B, n_B);
    if (boundary.is_corner(place) || !(point.kappa > 0)) break;
    const auto next = boundary.advance(place, turn / point.kappa, 0);
    const double there = far(boundary.at(next.place));
    if (!(there > farthest)) break;
    farthest = there;
    place = next.place;
  }
  return farthest;
}

// None for an unbounded curve.
std::optional<double> far_along(const NamedCurve& curve, const Vector2d& direction_W,
                                const Pose<double>& X_WB) {
  if (curve.boundary != nullptr) {
    const Vector2d n_B = X_WB.R_WB.inverse() * direction_W;
    return X_WB.p_WB.dot(direction_W) + far_along(*curve.boundary, n_B);
  }
  const CurveKind kind = curve.curve.kind;
  if (kind != CurveKind::kPoint && kind != CurveKind::kCircle && kind != CurveKind::kEllipse) {
    return std::nullopt;
  }
  // The material may be on either side: for a ring, the extent of the hole counts.
  const PlacedCurve<double> placed = place(curve.curve, X_WB);
  return support_point(placed, Vector2d(placed.side * direction_W)).p_W.dot(direction_W);
}

double sum_of(const std::vector<ExtentTerm>& terms, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t k = from; k < to; ++k) sum += terms[k].far;
  return sum;
}

}  // namespace

std::vector<ExtentTerm> terms_of(const DesignTask::Extent& extent) {
  using Kind = DesignTask::Extent::Kind;
  std::vector<ExtentTerm> terms;
  const auto both = [&](const Vector2d& direction) {
    terms.push_back({direction});
    terms.push_back({-direction});
  };
  if (extent.kind == Kind::kReach) terms.emplace_back();
  if (extent.kind == Kind::kWidth || extent.kind == Kind::kLargest) both(Vector2d::UnitX());
  if (extent.kind == Kind::kHeight || extent.kind == Kind::kLargest) both(Vector2d::UnitY());
  return terms;
}

double far_along(const DesignTask::Extent& extent, const Vector2d& direction_W, const Mechanism& mechanism,
                 const std::vector<BodyMotion>& bodies) {
  const auto place_of = [&](const PointRef& point) {
    return Vector2d(bodies[point.body].X_WB * point_of(mechanism, point));
  };
  if (direction_W.isZero()) {
    return (place_of(extent.point) - place_of(extent.from)).norm();
  }
  double farthest = -kInf;
  for (const int index : extent.bodies) {
    const Body& body = mechanism.bodies[index];
    const Pose<double>& X_WB = bodies[index].X_WB;
    for (const NamedPoint& point : body.points) {
      farthest = std::max(farthest, (X_WB * point.p_B).dot(direction_W));
    }
    for (const NamedCurve& curve : body.curves) {
      farthest = std::max(farthest, far_along(curve, direction_W, X_WB).value_or(farthest));
    }
  }
  return farthest;
}

std::vector<ExtentTerm> terms_that_count(const DesignTask::Extent& extent,
                                         const std::vector<ExtentTerm>& terms) {
  if (extent.kind != DesignTask::Extent::Kind::kLargest) {
    return terms;
  }
  const bool wide = sum_of(terms, 0, 2) >= sum_of(terms, 2, 4);
  return wide ? std::vector(terms.begin(), terms.begin() + 2) : std::vector(terms.begin() + 2, terms.end());
}

}  // namespace higherpair

#pragma once

#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/geometry/pose.hpp"
#include "numeric/interval.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace higherpair {

/// Enclosure of a boundary's plane curve over an interval of a span's parameter. The curve is (h, h′) about
/// the pivot for a turning follower, and (angle of the normal times a length, p·d⊥) for a sliding one; for
/// body 2 with the normal -n, at q = 0. The bodies touch where their two curves meet.
struct Stretch {
  int span = -1;  ///< < 0: the bridge across a gap at a joint
  Bounds t;
  Interval from_middle;   ///< t - middle
  IntervalVector middle;  ///< the point there
  IntervalVector range;   ///< all points
  IntervalVector slope;   ///< derivative by t
  Interval q;             ///< a contact's follower coordinate is that of body 1 minus that of body 2
  bool flat = false;      ///< straight edge
  mutable std::unique_ptr<std::array<Stretch, 2>> halves;

  /// Approximate length [m].
  [[nodiscard]] double extent() const {
    return boost::numeric::width(from_middle) *
           std::max(boost::numeric::norm(slope.x), boost::numeric::norm(slope.y));
  }
};

/// The midpoint.
[[nodiscard]] inline Vector2d median_of(const IntervalVector& v) {
  return {boost::numeric::median(v.x), boost::numeric::median(v.y)};
}

/// Cross product of two directions.
[[nodiscard]] inline Interval cross(const IntervalVector& a, const IntervalVector& b) {
  return a.turned().dot(b);
}

/// A lower bound of the sine of the angle at which two curves cross, if all of these parts cross in the same
/// sense, so that the curves meet once at most; else 0. (A chord across several parts is a mean of their
/// tangents, so that the bound holds for it as well.)
[[nodiscard]] double least_sine(const std::vector<Stretch>& parts1, const std::vector<Stretch>& parts2);

class FeatureCurve {
public:
  /// \param sense   +1 for body 1, -1 for body 2
  /// \param length  that corresponds to one radian of a normal's angle [m]
  /// \param error   of the points, beyond rounding [m]
  FeatureCurve(const Boundary& boundary, const Pose<double>& X_WB, const OneFreedom& follower, double sense,
               double length, double error);

  /// None where the span gives no bounds. \param span  as Stretch::span; on a bridge t goes from 0 to 1
  [[nodiscard]] std::optional<Stretch> over(int span, const Bounds& t) const;
  /// The whole boundary, cut at its samples; none where a span gives no bounds. Where spans meet with a gap
  /// that exceeds rounding (as with the digits of a drawing), a straight bridge across it is a piece as well.
  [[nodiscard]] std::optional<std::vector<Stretch>> pieces() const;
  /// The part within `reach` [m] along the boundary of a place, across at most one joint of spans on either
  /// side.
  /// \pre pieces() are given
  [[nodiscard]] std::vector<Stretch> parts_near(const BoundaryPlace& place, double reach) const;
  /// The halves of a stretch, computed once.
  [[nodiscard]] const std::array<Stretch, 2>& halves(const Stretch& whole) const;

private:
  // At the middle of a stretch: the point relative to the follower's joint, and the normal.
  struct Middle {
    Vector2d m, n;
  };
  void enclose_turning(const Middle& at, const IntervalVector& p, const SpanBounds& bounds,
                       const IntervalVector& n, Stretch& stretch) const;
  void enclose_sliding(const Middle& at, const Interval& phi, const SpanBounds& bounds,
                       const IntervalVector& n, Stretch& stretch) const;
  [[nodiscard]] double error_at(const Vector2d& m) const;
  [[nodiscard]] Stretch at(const BoundaryPlace& place) const { return *over(place.span, {place.t, place.t}); }
  [[nodiscard]] std::optional<Stretch> gap_at(int joint) const;
  [[nodiscard]] Stretch bridge(int joint, const Bounds& t) const;
  [[nodiscard]] double step_along(const BoundaryPlace& from, double reach) const;

  const Boundary* boundary_;
  Pose<double> X_WB_;
  OneFreedom follower_;
  double sense_;
  double length_;
  double error_;
};

}  // namespace higherpair

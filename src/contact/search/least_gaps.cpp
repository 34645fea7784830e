#include "higherpair/contact/least_gaps.hpp"

#include "common_normals.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr int kStartArcs = 8;
// Ends the search where rounding leaves the sign of the slope open.
constexpr int kMostArcs = 4000;

// Whether one is a ring, and a body without flat parts may be in it.
bool may_be_in_ring(const Curve& curve1, const Curve& curve2) {
  return (curve1.side == Side::kOutside || curve2.side == Side::kOutside) && !is_line(curve1) &&
         !is_line(curve2);
}

// g, g′ and g″ at the normal with this angle.
struct Slope {
  double phi = 0;
  double gap = 0;
  double slope = 0;
  double bend = 0;
  double noise = 0;  // of the slope, by rounding
};

// Finds the minima of the gap g. Arcs of normals are halved until the sign of g′ on both halves is that of
// the cubic through its values and derivatives at their ends. How far g′ is from a cubic shows in the middle,
// in value or derivative: an arc with a narrow part, such as the flat side of a slender ellipse, is halved.
// That holds at any ratio of play to size, unlike bounds of g″, in which the play is a small difference of
// large radii.
class LeastGaps {
public:
  LeastGaps(const PlacedCurve<double>& curve1, const PlacedCurve<double>& curve2, double reach)
      : curve1_(curve1), curve2_(curve2), reach_(reach) {}

  /// \param arc  of normals; none: all
  /// \param known  the normal of one that is not wanted, or null
  std::vector<CommonNormal> within(const std::optional<NormalArc>& arc, const Vector2d* known) {
    const NormalArc domain = arc.value_or(NormalArc{});
    known_ = known == nullptr ? kNoValue : nearest_turn(angle_of(*known), domain.middle);
    const double half = arc ? domain.half * (1 - kFineGap) : domain.half;  // at its ends points are infinite
    const double begin = domain.middle - half, step = 2 * half / kStartArcs;
    const Slope first = at(begin);
    Slope from = first;
    for (int i = 1; i <= kStartArcs; ++i) {
      Slope to = at(begin + i * step);
      if (i == kStartArcs && !arc) {  // the same normal as the first, which rounding must not split
        to = first;
        to.phi += 2 * kPi;
      }
      look_between(from, to);
      from = to;
    }
    return std::move(found_);
  }

private:
  [[nodiscard]] CommonNormal normal_at(double phi) const {
    const Vector2d n = unit_vector(phi), inward = -n;
    const SupportPoint<double> s1 = support_point(curve1_, n);
    const SupportPoint<double> s2 = support_point(curve2_, inward);
    return {n, s1.p_W, s2.p_W, s1.rho, s2.rho};
  }

  static double slope_of(const CommonNormal& at) { return (at.p2_W - at.p1_W).dot(perp(at.n_W)); }

  [[nodiscard]] Slope at(double phi) const {
    const CommonNormal at = normal_at(phi);
    return {phi, at.gap(), slope_of(at), -(at.rho1 + at.rho2) - at.gap(),
            kRoundingOfSlope * (at.p1_W.norm() + at.p2_W.norm())};
  }

  void look_between(const Slope& a, const Slope& b) {
    const double h = b.phi - a.phi;
    const Slope middle = at(a.phi + h / 2);
    const double error = distance_from_cubic(a, middle, b);
    const bool is_resolved = (is_settled(a, middle, error) && is_settled(middle, b, error)) ||
                             (h <= kNarrowArc && (rises(a, middle, b, 1) || rises(b, middle, a, -1)));
    if (++arcs_ >= kMostArcs || h <= kFinestArc || is_resolved) {
      take(a, middle);
      take(middle, b);
      return;
    }
    look_between(a, middle);
    look_between(middle, b);
  }

  static double distance_from_cubic(const Slope& a, const Slope& middle, const Slope& b) {
    const double h = b.phi - a.phi;
    const double value = (a.slope + b.slope) / 2 + h / 8 * (a.bend - b.bend);
    const double derivative = 1.5 * (b.slope - a.slope) / h - (a.bend + b.bend) / 4;
    return std::abs(middle.slope - value) + h / 4 * std::abs(middle.bend - derivative);
  }

  // Whether the cubic from a to b has no zero, or rises or falls throughout, by its Bernstein coefficients,
  // each of which may be wrong by `error`. Where all are rounding the bodies conform.
  static bool is_settled(const Slope& a, const Slope& b, double error) {
    const double third = (b.phi - a.phi) / 3;
    const std::array c{a.slope, a.slope + third * a.bend, b.slope - third * b.bend, b.slope};
    const auto [least, most] = std::minmax_element(c.begin(), c.end());
    const double least_step = std::min({c[1] - c[0], c[2] - c[1], c[3] - c[2]});
    const double most_step = std::max({c[1] - c[0], c[2] - c[1], c[3] - c[2]});
    return *least > error || *most < -error || least_step > error || most_step < -error ||
           std::max(*most, -*least) <= a.noise;
  }

  // Whether |g′| rises from a to b, away from 0, as towards the end of an infinite curve.
  // \param sense  of φ from a to b
  static bool rises(const Slope& a, const Slope& middle, const Slope& b, double sense) {
    const double sign = a.slope < 0 ? -1 : 1, rise = sense * sign;
    return sign * middle.slope > sign * a.slope && sign * b.slope > sign * middle.slope &&
           rise * a.bend > 0 && rise * middle.bend > 0 && rise * b.bend > 0;
  }

  // Newton's method would not settle where the bodies conform to all digits but a few.
  void take(const Slope& a, const Slope& b) {
    const bool is_known = a.phi < known_ && known_ < b.phi;
    if (!(a.slope <= 0 && b.slope > 0) || is_known || is_out_of_reach(a, b)) {
      return;
    }
    const auto slope = [&](double x) { return slope_of(normal_at(a.phi + x)); };
    if (const auto x = root_between(slope, a.slope, b.phi - a.phi, b.slope)) {
      found_.push_back(normal_at(a.phi + *x));
    }
  }

  // For a minimum between a and b, where |g′| is not much larger than at the ends.
  [[nodiscard]] bool is_out_of_reach(const Slope& a, const Slope& b) const {
    const double h = 2 * (b.phi - a.phi);
    return std::max(a.gap + h * a.slope, b.gap - h * b.slope) > reach_;
  }

  const PlacedCurve<double>& curve1_;
  const PlacedCurve<double>& curve2_;
  double reach_;
  double known_ = kNoValue;  // angle of a normal
  int arcs_ = 0;
  std::vector<CommonNormal> found_;
};

}  // namespace

std::vector<CommonNormal> least_gaps(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                                     const Pose<double>& X_W2, double reach, const Vector2d* known) {
  std::vector<CommonNormal> least;
  if (!may_be_in_ring(curve1, curve2)) {
    return least;
  }
  const auto placed1 = place(curve1, X_W1), placed2 = place(curve2, X_W2);
  const CommonNormals normals = common_normals(placed1, placed2);
  if (!normals.empty) {
    least = LeastGaps(placed1, placed2, reach).within(normals.arc, known);
    std::erase_if(least, [&](const CommonNormal& at) { return !is_least_gap(at) || at.gap() > reach; });
  }
  return least;
}

bool overlap_far_out(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                     const Pose<double>& X_W2) {
  return may_be_in_ring(curve1, curve2) &&
         !common_normals(place(curve1, X_W1), place(curve2, X_W2)).cover_ring;
}

std::optional<CommonNormal> moved_least_gap(const Curve& curve1, const Pose<double>& X_W1,
                                            const Curve& curve2, const Pose<double>& X_W2,
                                            const CommonNormal& before) {
  const auto at = find_common_normal(curve1, X_W1, curve2, X_W2, before.n_W);
  return at && is_least_gap(*at) ? at : std::nullopt;
}

}  // namespace higherpair

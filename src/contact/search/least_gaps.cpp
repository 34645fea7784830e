#include "higherpair/contact/least_gaps.hpp"

#include "gap_of_normals.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/roots.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kStartArcs = 8;
constexpr int kMostArcs = 4000;
// Arcs of normals overlap by this fraction, so that a minimum where two of them meet is within one.
constexpr double kArcsOverlap = 1e-9;

// Finds the maxima of F = -g.
class LeastGaps {
public:
  LeastGaps(const GapProblem& problem, double reach) : problem_(problem), reach_(reach) {}

  /// The angles of the normals.
  std::vector<double> within(const NormalArc& domain) {
    const double half = domain.half / kStartArcs;
    for (int i = 0; i < kStartArcs; ++i) {
      arcs_.push_back({domain.middle - domain.half + (2 * i + 1) * half, half});
    }
    for (int taken = 0; !arcs_.empty() && taken < kMostArcs; ++taken) {
      const NormalArc arc = arcs_.back();
      arcs_.pop_back();
      look_into(arc);
    }
    return found_;
  }

private:
  [[nodiscard]] GapValue value(double phi) const { return gap_value(problem_, unit_vector(phi)); }

  void look_into(const NormalArc& arc) {
    const Vector2d n = unit_vector(arc.middle);
    const auto half = Rotation<double>::from_angle(arc.half);
    const GapValue middle = gap_value(problem_, n);
    const Bounds sum = curvature_bounds(problem_, n, half);  // of F″ + F
    const double highest = largest_gap(middle, half, sum.high);
    if (highest < -reach_) {
      return;
    }
    const double lowest = -largest_gap({-middle.f, -middle.slope, middle.rho_sum}, half, -sum.low);
    const Bounds bend{sum.low - highest, sum.high - lowest};  // of F″
    if (bend.high < 0) {
      take_maximum(arc, middle);
      return;
    }
    const bool no_maximum =
        bend.low > 0 || std::abs(middle.slope) > arc.half * std::max(bend.high, -bend.low);
    if (!no_maximum && arc.half >= kFinestArc) {
      arcs_.push_back({arc.middle - arc.half / 2, arc.half / 2});
      arcs_.push_back({arc.middle + arc.half / 2, arc.half / 2});
    }
  }

  // F′ falls throughout the arc.
  void take_maximum(const NormalArc& arc, const GapValue& middle) {
    const double half = arc.half * (1 + kArcsOverlap);
    const double end = std::copysign(half, middle.slope);  // the maximum is on this side of the middle
    const double at_end = value(arc.middle + end).slope;
    if (at_end * middle.slope > 0) {
      return;
    }
    const auto slope = [&](double x) { return value(arc.middle + x).slope; };
    if (const auto x = root_between(slope, middle.slope, end, at_end)) {
      found_.push_back(arc.middle + *x);
    }
  }

  const GapProblem& problem_;
  double reach_;
  std::vector<NormalArc> arcs_;
  std::vector<double> found_;
};

}  // namespace

std::vector<CommonNormal> least_gaps(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                                     const Pose<double>& X_W2, double reach) {
  const bool ring1 = curve1.side == Side::kOutside, ring2 = curve2.side == Side::kOutside;
  std::vector<CommonNormal> least;
  if (!(ring1 || ring2) || is_line(curve1) || is_line(curve2)) {
    return least;
  }
  const GapProblem problem{place(curve1, X_W1), place(curve2, X_W2), -1};
  const CommonNormals normals = common_normals(problem, ring1, ring2);
  if (normals.empty) {
    return least;
  }
  for (const double phi : LeastGaps(problem, reach).within(normals.arc.value_or(NormalArc{}))) {
    const auto at = find_common_normal(curve1, X_W1, curve2, X_W2, unit_vector(phi));
    const bool known = at && std::any_of(least.begin(), least.end(), [&](const CommonNormal& other) {
                         return (other.n_W - at->n_W).norm() <= kArcsOverlap;
                       });
    if (at && !known && at->gap() <= reach) {
      least.push_back(*at);
    }
  }
  return least;
}

bool overlap_far_out(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                     const Pose<double>& X_W2) {
  if (is_line(curve1) || is_line(curve2)) {
    return false;
  }
  const GapProblem problem{place(curve1, X_W1), place(curve2, X_W2), -1};
  return !common_normals(problem, curve1.side == Side::kOutside, curve2.side == Side::kOutside).cover_ring;
}

std::optional<CommonNormal> moved_least_gap(const Curve& curve1, const Pose<double>& X_W1,
                                            const Curve& curve2, const Pose<double>& X_W2,
                                            const CommonNormal& before) {
  const auto at = find_common_normal(curve1, X_W1, curve2, X_W2, before.n_W);
  return at && at->rho1 + at->rho2 + at->gap() < 0 ? at : std::nullopt;
}

}  // namespace higherpair

#include "higherpair/analysis/boundary_derivatives.hpp"

#include "higherpair/geometry/local_conic.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/numeric/stencil.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <Eigen/Core>

namespace higherpair {
namespace {

using Parametric = Partials<double, 1>;

constexpr int kMiddle = 4;

// Where each piece of a boundary is sampled, as fractions of its parameter range.
constexpr std::array kShares = {0.08, 0.37, 0.64, 0.93};

// Point, normal, curvature and its rate.
using SpanNumbers = Eigen::Matrix<double, 6, 1>;

// A place on a boundary that is the same on boundaries made with other numbers: between the same two breaks.
struct PiecePlace {
  int span = 0;
  std::size_t piece = 0;
  double share = 0;  // of the piece's parameter range
};

SpanNumbers numbers_at(const BoundaryPieces& of, const PiecePlace& place) {
  const std::vector<double>& ends = of.ends[place.span];
  const double t = std::lerp(ends[place.piece], ends[place.piece + 1], place.share);
  const SpanPoint point = of.boundary->spans()[place.span]->at(t);
  SpanNumbers numbers;
  numbers << point.p_B, point.n_B, point.kappa, point.slope;
  return numbers;
}

template <class Boundaries>
auto numbers_of(const Boundaries& boundaries, const PiecePlace& place, double step) {
  return [&boundaries, place, step](double by) {
    return numbers_at(boundaries[std::lround(by / step) + kMiddle], place);
  };
}

template <class Boundaries>
SpanNumbers slopes_at(const Boundaries& boundaries, const PiecePlace& place, double step) {
  return eighth_order_difference(numbers_of(boundaries, place, step), step);
}

BoundaryPieces pieces_of(std::shared_ptr<const Boundary> boundary) {
  BoundaryPieces pieces{std::move(boundary), {}};
  for (const SpanPtr& span : pieces.boundary->spans()) {
    std::vector<double> ends = span->breaks();
    ends.insert(ends.begin(), span->range().low);
    ends.push_back(span->range().high);
    pieces.ends.push_back(std::move(ends));
  }
  return pieces;
}

bool same_pieces(const BoundaryPieces& a, const BoundaryPieces& b) {
  const auto corners = [](const SpanPtr& one, const SpanPtr& two) {
    return one->is_corner() == two->is_corner();
  };
  const auto counts = [](const auto& one, const auto& two) { return one.size() == two.size(); };
  const auto &ours = a.boundary->spans(), &theirs = b.boundary->spans();
  return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(), corners) &&
         std::equal(a.ends.begin(), a.ends.end(), b.ends.begin(), b.ends.end(), counts);
}

// The largest of the slopes, each as a fraction of what a change of p by `scale` should do to a boundary.
double share_of(const SpanNumbers& slopes, const SpanNumbers& values, const Boundary& boundary,
                double scale) {
  const double size = boundary.size() > 0 ? boundary.size() : 1;
  const double length = boundary.middle_B().norm() + size;
  return std::max({slopes.head<2>().norm() / length, slopes.segment<2>(2).norm(),
                   std::abs(slopes(4)) / (std::abs(values(4)) + 1 / size)}) *
         scale;
}

// The largest f(values, slopes, boundaries, place) of all sampled places.
template <class Contacts, class F>
double largest_of(const Contacts& contacts, double step, F f) {
  double largest = 0;
  for (const auto& sides : contacts) {
    for (const auto& boundaries : sides) {
      const BoundaryPieces& own = boundaries[kMiddle];
      for (int span = 0; span < static_cast<int>(own.ends.size()); ++span) {
        for (std::size_t piece = 0; piece + 1 < own.ends[span].size(); ++piece) {
          for (const double share : kShares) {
            const PiecePlace place{span, piece, share};
            const double one =
                f(numbers_at(own, place), slopes_at(boundaries, place, step), boundaries, place);
            largest = one > largest || std::isnan(one) ? one : largest;
          }
        }
      }
    }
  }
  return largest;
}

}  // namespace

std::optional<BoundaryDerivatives> BoundaryDerivatives::of(const Family& mechanisms, double step) {
  BoundaryDerivatives derivatives;
  derivatives.step_ = step;
  derivatives.contacts_.resize(mechanisms[kMiddle]->contacts.size());
  for (const auto [contact, side] : BoundarySides(*mechanisms[kMiddle])) {
    Boundaries& boundaries = derivatives.contacts_[contact][side];
    for (std::size_t k = 0; k < boundaries.size(); ++k) {
      const CurveRef& ref = ref_of(mechanisms[k]->contacts[contact], side);
      boundaries[k] = pieces_of(described_curve(*mechanisms[k], ref).boundary);
    }
    for (const auto& other : boundaries) {
      if (!same_pieces(boundaries[kMiddle], other)) {
        return std::nullopt;
      }
    }
  }
  return derivatives;
}

PlaceDerivative BoundaryDerivatives::at(std::size_t contact, std::size_t side,
                                        const BoundaryPlace& place) const {
  const Boundaries& boundaries = contacts_[contact][side];
  const std::vector<double>& ends = boundaries[kMiddle].ends[place.span];
  const auto next = std::upper_bound(ends.begin() + 1, ends.end() - 1, place.t);
  const double low = *std::prev(next);
  const PiecePlace at{place.span, static_cast<std::size_t>(next - ends.begin()) - 1,
                      (place.t - low) / (*next - low)};
  const SpanNumbers slopes = slopes_at(boundaries, at, step_);
  return {slopes.head<2>(), slopes.segment<2>(2), slopes(4), slopes(5)};
}

Curve local_curve_derivative(const SpanPoint& at, const Curve& local, const PlaceDerivative& by_p) {
  Curve by;
  by.kind = local.kind;
  by.q = 0;
  by.vertex_B = by_p.p_B;
  by.axis_B = is_line(local) ? Vector2d(-by_p.n_B) : Vector2d(Vector2d::Zero());
  if (local.slope != 0) {
    by.kappa = by_p.kappa;
    by.slope = by_p.slope;
  }
  if (!is_conic(local)) {
    return by;
  }
  const auto vector = [](const Vector2d& value, const Vector2d& slope) {
    return Vector2<Parametric>(parametric(value.x(), slope.x()), parametric(value.y(), slope.y()));
  };
  const LocalConic<Parametric> conic =
      local_conic(vector(at.p_B, by_p.p_B), vector(at.n_B, by_p.n_B), parametric(at.kappa, by_p.kappa),
                  parametric(at.slope, by_p.slope), local.kind == CurveKind::kCircle);
  by.vertex_B = {conic.vertex_B.x().c[1], conic.vertex_B.y().c[1]};
  by.axis_B = {conic.axis_B.x().c[1], conic.axis_B.y().c[1]};
  by.semi_latus = conic.semi_latus.c[1];
  return by;
}

double BoundaryDerivatives::error(double scale) const {
  return largest_of(contacts_, step_,
                    [&](const SpanNumbers& values, const SpanNumbers& slopes, const Boundaries& boundaries,
                        const PiecePlace& place) {
                      const Boundary& own = *boundaries[kMiddle].boundary;
                      const SpanNumbers coarse =
                          sixth_order_difference(numbers_of(boundaries, place, step_), step_);
                      return share_of(slopes - coarse, values, own, scale) /
                             std::max(share_of(slopes, values, own, scale), 1.0);
                    });
}

double BoundaryDerivatives::largest(double scale) const {
  return largest_of(contacts_, step_,
                    [&](const SpanNumbers& values, const SpanNumbers& slopes, const Boundaries& boundaries,
                        const PiecePlace& /*place*/) {
                      return share_of(slopes, values, *boundaries[kMiddle].boundary, scale);
                    });
}

}  // namespace higherpair

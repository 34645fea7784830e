#include "higherpair/analysis/boundary_derivatives.hpp"

#include "analysis/boundaries/span_ends.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/local_conic.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/stencil.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace higherpair {
namespace {

using Parametric = Partials<double, 1>;

constexpr int kMiddle = 4;

// Where each span of a boundary is sampled, as fractions of its parameter range.
constexpr std::array kShares = {0.08, 0.37, 0.64, 0.93};

// Point, normal, curvature and its rate.
using SpanNumbers = Eigen::Matrix<double, 6, 1>;

SpanNumbers numbers_at(const Boundary& boundary, int span, double share) {
  const Span& one = *boundary.spans()[span];
  const Bounds range = one.range();
  const SpanPoint point = one.at(range.low + share * range.width());
  SpanNumbers numbers;
  numbers << point.p_B, point.n_B, point.kappa, point.slope;
  return numbers;
}

template <class Boundaries>
auto numbers_of(const Boundaries& boundaries, int span, double share, double step) {
  return [&boundaries, span, share, step](double by) {
    return numbers_at(*boundaries[std::lround(by / step) + kMiddle], span, share);
  };
}

template <class Boundaries>
SpanNumbers slopes_at(const Boundaries& boundaries, int span, double share, double step) {
  return eighth_order_difference(numbers_of(boundaries, span, share, step), step);
}

bool same_spans(const Boundary& a, const Boundary& b) {
  return std::equal(
      a.spans().begin(), a.spans().end(), b.spans().begin(), b.spans().end(),
      [](const SpanPtr& one, const SpanPtr& two) { return one->is_corner() == two->is_corner(); });
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

// The largest f(values, slopes, boundaries, span, share) of all sampled places.
template <class Contacts, class F>
double largest_of(const Contacts& contacts, double step, F f) {
  double largest = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t side = 0; side < 2 && contacts[i][side][kMiddle]; ++side) {
      const auto& boundaries = contacts[i][side];
      const Boundary& own = *boundaries[kMiddle];
      for (int span = 0; span < static_cast<int>(own.spans().size()); ++span) {
        for (const double share : kShares) {
          const double one = f(numbers_at(own, span, share), slopes_at(boundaries, span, share, step),
                               boundaries, span, share);
          largest = one > largest || std::isnan(one) ? one : largest;
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
  const std::vector<Contact>& contacts = mechanisms[kMiddle]->contacts;
  derivatives.contacts_.resize(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t side = 0; contacts[i].by_boundary && side < 2; ++side) {
      Boundaries& boundaries = derivatives.contacts_[i][side];
      for (std::size_t k = 0; k < boundaries.size(); ++k) {
        const CurveRef& ref = ref_of(mechanisms[k]->contacts[i], side);
        boundaries[k] = described_curve(*mechanisms[k], ref).boundary;
      }
      for (const auto& other : boundaries) {
        if (!same_spans(*boundaries[kMiddle], *other)) {
          return std::nullopt;
        }
      }
    }
  }
  return derivatives;
}

PlaceDerivative BoundaryDerivatives::at(std::size_t contact, std::size_t side,
                                        const BoundaryPlace& place) const {
  const Boundaries& boundaries = contacts_[contact][side];
  const Bounds range = range_of(*boundaries[kMiddle], place.span);
  const double share = (place.t - range.low) / range.width();
  const SpanNumbers slopes = slopes_at(boundaries, place.span, share, step_);
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
  const auto varied = [](double value, double slope) {
    Parametric number(value);
    number.c[1] = slope;
    return number;
  };
  const auto varied_vector = [&](const Vector2d& value, const Vector2d& slope) {
    return Vector2<Parametric>(varied(value.x(), slope.x()), varied(value.y(), slope.y()));
  };
  const LocalConic<Parametric> conic = local_conic(
      varied_vector(at.p_B, by_p.p_B), varied_vector(at.n_B, by_p.n_B), varied(at.kappa, by_p.kappa),
      varied(at.slope, by_p.slope), local.kind == CurveKind::kCircle);
  by.vertex_B = {conic.vertex_B.x().c[1], conic.vertex_B.y().c[1]};
  by.axis_B = {conic.axis_B.x().c[1], conic.axis_B.y().c[1]};
  by.semi_latus = conic.semi_latus.c[1];
  return by;
}

double BoundaryDerivatives::error(double scale) const {
  return largest_of(contacts_, step_,
                    [&](const SpanNumbers& values, const SpanNumbers& slopes, const Boundaries& boundaries,
                        int span, double share) {
                      const Boundary& own = *boundaries[kMiddle];
                      const SpanNumbers coarse =
                          sixth_order_difference(numbers_of(boundaries, span, share, step_), step_);
                      return share_of(slopes - coarse, values, own, scale) /
                             std::max(share_of(slopes, values, own, scale), 1.0);
                    });
}

double BoundaryDerivatives::largest(double scale) const {
  return largest_of(
      contacts_, step_,
      [&](const SpanNumbers& values, const SpanNumbers& slopes, const Boundaries& boundaries, int /*span*/,
          double /*share*/) { return share_of(slopes, values, *boundaries[kMiddle], scale); });
}

}  // namespace higherpair

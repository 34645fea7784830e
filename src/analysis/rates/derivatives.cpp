#include "higherpair/analysis/derivatives.hpp"

#include "analysis/boundaries/span_ends.hpp"
#include "higherpair/geometry/curvature_rates.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "series_motion.hpp"

#include <cassert>

namespace higherpair {

using Series = PowerSeries<double, kHighestDerivative>;

namespace {

// Adds what boundaries have beyond the local curves that agree with them at the row's contacts. False where
// their curvature's rates are not known.
bool add_beyond_local_curves(const Run& run, Dimensions<double>& dimensions) {
  for (const auto [contact, side] : BoundarySides(run.mechanism())) {
    const ContactMotion& motion = run.row.contacts[contact];
    if (!motion.touches) {
      continue;
    }
    const Boundary& boundary = boundary_at(run, contact, side);
    const BoundaryPlace& place = motion.place[side];
    const auto rates = boundary.curvature_rates(place);
    if (!rates) {
      return false;
    }
    const SpanPoint point = boundary.at(place);
    auto& of = side == 0 ? dimensions.contacts[contact].curve1 : dimensions.contacts[contact].curve2;
    if (of.bent) {
      of.bend = height_over_tangent(point, *rates);
    } else {
      const CurveRef& ref = ref_of(run.mechanism().contacts[contact], side);
      of.beyond = support_beyond(point, *rates, curve_of(run.mechanism(), ref));
      of.normal_angle = angle_of(point.n_B);
    }
  }
  return true;
}

}  // namespace

std::optional<std::vector<BodyDerivatives>> derivatives_of(const Run& run,
                                                           const std::vector<DriverMotion>& drivers,
                                                           int order, std::span<const HigherRates> higher) {
  assert(order >= 1 && order <= kHighestDerivative);
  const MotionRow& row = run.row;
  if (row.status == RowStatus::kNotAssemblable || !row.all_rates) {
    return std::nullopt;
  }
  Coordinates<Series> at = constant<Series>(row_coordinates(run));
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    at.drivers[i] = series_of_driver<kHighestDerivative>(drivers[i]);
    for (std::size_t k = 3; !higher.empty() && k <= kHighestDerivative; ++k) {
      at.drivers[i].c[k] = higher[i][k - 3] / kFactorials[k];
    }
  }
  Dimensions<double> dimensions = dimensions_of(run.mechanism());
  if (order > 3 && !add_beyond_local_curves(run, dimensions)) {
    return std::nullopt;
  }
  const auto held = plan_with_held_joints(run, dimensions, at);
  const auto motion = row_series(run, held ? *held : run.plan(), dimensions, dimensions, std::move(at));
  if (!motion.all_known()) {
    return std::nullopt;
  }
  std::vector<BodyDerivatives> bodies(motion.at.bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyAt<Series>& body = motion.at.bodies[i];
    bodies[i].p_WB.fill(Vector2d::Zero());
    bodies[i].theta.fill(0);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
      const Vector2d p_k(body.X_WB.p_WB.x().c[k], body.X_WB.p_WB.y().c[k]);
      bodies[i].p_WB[k] = kFactorials[k] * p_k;
      bodies[i].theta[k] = kFactorials[k] * body.theta.c[k];
    }
  }
  return bodies;
}

Vector2d point_derivative(const BodyDerivatives& body, const Vector2d& p_B, int k) {
  std::array<double, kHighestDerivative + 1> x{}, y{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = body.p_WB[i].x();
    y[i] = body.p_WB[i].y();
  }
  const auto theta = series_of<kHighestDerivative>(body.theta);
  const BodyAt<Series> frame{{Rotation<Series>::from_angle(theta),
                              {series_of<kHighestDerivative>(x), series_of<kHighestDerivative>(y)}},
                             theta};
  const Vector2<Series> p_W = frame.point(p_B);
  const auto order = static_cast<std::size_t>(k);
  return kFactorials[order] * Vector2d(p_W.x().c[order], p_W.y().c[order]);
}

}  // namespace higherpair

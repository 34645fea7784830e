#include "higherpair/geometry/involute_span.hpp"

#include "higherpair/geometry/curvature_rates.hpp"
#include "higherpair/geometry/pose.hpp"
#include "numeric/interval.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace higherpair {
namespace {

// The material is on the left of the direction of travel: a right flank is traversed outwards, φ = t, a left
// one inwards, φ = -t.
class InvoluteSpan final : public Span {
public:
  explicit InvoluteSpan(const Involute& involute)
      : involute_(involute), sense_(involute.hand == Hand::kRight ? 1 : -1) {}

  [[nodiscard]] SpanPoint at(double t) const override {
    const double r = involute_.base_radius;
    const double roll = sense_ * t;
    const Vector2d e = unit_vector(involute_.start + sense_ * roll);
    const Vector2d n = -sense_ * perp(e);
    const double rho = r * roll;
    // dκ/ds = -1/(r² φ³) where s grows with φ.
    return {involute_.center_B + r * e + rho * n, n, 1 / rho, -sense_ / (rho * rho * roll), rho};
  }
  [[nodiscard]] std::optional<CurvatureRates> curvature_rates(double t) const override {
    CurveSeries rho(involute_.base_radius * sense_ * t);
    rho.c[1] = involute_.base_radius * sense_;
    return rates_of_curvature(CurveSeries(1) / rho, rho);
  }
  [[nodiscard]] Bounds range() const override { return sense_ > 0 ? involute_.roll : -involute_.roll; }
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& t) const override {
    const Interval speed = involute_.base_radius * sense_ * to_interval(t);
    return SpanBounds{to_bounds(speed), {1, 1}};
  }
  // No part turns by more than a tenth of a radian, nor does its radius grow by much more than a third of the
  // whole.
  [[nodiscard]] int parts() const override {
    return std::max(8, 1 + static_cast<int>(involute_.roll.width() / 0.1));
  }

  [[nodiscard]] const Involute& involute() const { return involute_; }

private:
  Involute involute_;
  double sense_;
};

}  // namespace

SpanPtr involute_span(const Involute& involute) {
  assert(involute.base_radius > 0 && involute.roll.low > 0 && involute.roll.width() > 0);
  return std::make_shared<InvoluteSpan>(involute);
}

const Involute* involute_of(const Span& span) {
  const auto* own = dynamic_cast<const InvoluteSpan*>(&span);
  return own == nullptr ? nullptr : &own->involute();
}

double base_radius(const InvoluteTooth& tooth) {
  return tooth.module * tooth.teeth / 2 * std::cos(tooth.pressure_angle);
}

double half_angle_at_base(const InvoluteTooth& tooth) {
  const double tangent = std::tan(tooth.pressure_angle);
  const double thickness = kPi / 2 + 2 * tooth.profile_shift * tangent - tooth.backlash / tooth.module;
  return thickness / tooth.teeth + tangent - tooth.pressure_angle;
}

// The rack's straight edge ends one module below its pitch line; the point that its end cuts is at
// (1 - x) m / sin α on the line of action before the pitch point, which is r tan α from the base point.
double roll_at_root(const InvoluteTooth& tooth) {
  return std::tan(tooth.pressure_angle) -
         4 * (1 - tooth.profile_shift) / (tooth.teeth * std::sin(2 * tooth.pressure_angle));
}

double roll_at_tip(const InvoluteTooth& tooth) {
  const double ratio =
      (tooth.teeth / 2 + 1 + tooth.profile_shift) / (tooth.teeth / 2 * std::cos(tooth.pressure_angle));
  return std::sqrt(std::max(0.0, ratio * ratio - 1));
}

}  // namespace higherpair

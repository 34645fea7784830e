#include "touches.hpp"

#include "higherpair/mechanism/boundaries.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>

namespace higherpair {
namespace {

constexpr double kRoom = 4;  // margin beyond the contact points of a face [units]

// Whether `ref` is this curve. A contact may refer to a copy of it, or to several curves joined to one.
bool is_it(const Sketch& sketch, const CurveRef& ref, int body, std::size_t curve) {
  if (ref.body != body) {
    return false;
  }
  const auto& curves = sketch.mechanism.bodies[body].curves;
  const auto index = static_cast<int>(curve);
  return is_or_has(curves, ref.curve, index) || curves[ref.curve].copy_of == index;
}

}  // namespace

std::vector<Touch> touches_of(const Sketch& sketch, int body, std::size_t curve) {
  std::vector<Touch> touches;
  for (std::size_t i = 0; i < sketch.mechanism.contacts.size(); ++i) {
    const Contact& contact = sketch.mechanism.contacts[i];
    const bool first = is_it(sketch, contact.first, body, curve);
    if (!first && !is_it(sketch, contact.second, body, curve)) {
      continue;
    }
    for (const MotionRow* row : sketch.rows) {
      if (!row->contacts[i].touches) continue;
      const CommonNormal& at = row->contacts[i].at;
      const Pose<double>& X_WB = row->bodies[body].X_WB;
      const Vector2d n_W = first ? at.n_W : Vector2d(-at.n_W);
      touches.push_back({X_WB.inverse_times(first ? at.p1_W : at.p2_W), X_WB.R_WB.inverse() * n_W});
    }
  }
  return touches;
}

bool is_held(const Sketch& sketch, int body, std::size_t curve) {
  return std::any_of(
      sketch.mechanism.contacts.begin(), sketch.mechanism.contacts.end(), [&](const Contact& contact) {
        return contact.both_sides &&
               (is_it(sketch, contact.first, body, curve) || is_it(sketch, contact.second, body, curve));
      });
}

Vector2d edge_direction(const Sketch& sketch, int body, std::size_t curve) {
  Vector2d sum = Vector2d::Zero();
  for (const Touch& touch : touches_of(sketch, body, curve)) {
    sum -= touch.n_B;
  }
  return sum.norm() > 0 ? Vector2d(sum.normalized()) : Vector2d(-Vector2d::UnitY());
}

std::array<double, 2> touched_range(const Sketch& sketch, int body, std::size_t index) {
  const Curve& curve = sketch.mechanism.bodies[body].curves[index].curve;
  const Vector2d across = perp(curve.axis_B);
  double low = kInf, high = -kInf;
  for (const Touch& touch : touches_of(sketch, body, index)) {
    const double t = (touch.p_B - curve.vertex_B).dot(across);
    low = std::min(low, t);
    high = std::max(high, t);
  }
  if (!(low <= high)) {
    low = high = 0;
  }
  const double room = kRoom * sketch.unit + 0.1 * (high - low);
  return {low - room, high + room};
}

}  // namespace higherpair

#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "higherpair/mechanism/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace higherpair {
namespace {

double largest_distance(const std::vector<Vector2d>& points) {
  double square = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      square = std::max(square, (points[i] - points[k]).squaredNorm());
    }
  }
  return std::sqrt(square);
}

}  // namespace

double size_of(const Mechanism& mechanism) {
  std::vector<Vector2d> points;
  double largest = 0;  // largest coordinate, to which rounding is relative
  const std::vector<BodyMotion> bodies = posed_bodies(mechanism);
  const auto add = [&](int body, const Vector2d& p_B) {
    points.push_back(bodies[body].X_WB * p_B);
    largest = std::max({largest, p_B.norm(), points.back().norm()});
  };
  for (const Joint& joint : mechanism.joints) {
    add(joint.first.body, point_of(mechanism, joint.first));
    add(joint.second.body, point_of(mechanism, joint.second));
  }
  for (const Contact& contact : mechanism.contacts) {
    for (const CurveRef& ref : {contact.first, contact.second}) {
      const Curve& curve = curve_of(mechanism, ref);
      add(ref.body, anchor(curve));
      if (const auto middle = middle_of(curve)) {
        add(ref.body, *middle);
      }
    }
  }
  const double size = largest_distance(points);
  double least = kLeastSize;
  for (const Driver& driver : mechanism.drivers) {
    least = std::max(least, kLeastOfTravel * driver.travel);
  }
  if (size > kCoincident * largest && size > least) {
    return size;
  }
  return largest > least ? largest : 1;
}

}  // namespace higherpair

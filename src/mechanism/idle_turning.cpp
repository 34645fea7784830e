#include "idle_turning.hpp"

#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/tolerances.hpp"

#include <optional>

namespace higherpair {
namespace {

bool is_round_about(const Curve& curve, const Vector2d& p_B, double size) {
  const auto middle = round_center(curve);
  return middle && (*middle - p_B).norm() <= kRoundAbout * size;
}

// The first pin, or the centre of the first round curve that touches.
std::optional<Vector2d> middle_of_turning(const Mechanism& mechanism, int body) {
  for (const Joint& joint : mechanism.joints) {
    for (const PointRef& ref : {joint.first, joint.second}) {
      if (ref.body == body) {
        return point_of(mechanism, ref);
      }
    }
  }
  for (const Contact& contact : mechanism.contacts) {
    for (const CurveRef& ref : {contact.first, contact.second}) {
      if (ref.body == body) {
        return round_center(curve_of(mechanism, ref));
      }
    }
  }
  return std::nullopt;
}

}  // namespace

bool turns_idly(const SizedMechanism& sized, int body, const Vector2d& p_B) {
  const Mechanism& mechanism = sized.mechanism;
  bool touches = false;
  for (const Joint& joint : mechanism.joints) {
    for (const PointRef& ref : {joint.first, joint.second}) {
      if (ref.body == body && (joint.type != JointType::kRevolute ||
                               (point_of(mechanism, ref) - p_B).norm() > kRoundAbout * sized.size)) {
        return false;
      }
    }
  }
  for (const Contact& contact : mechanism.contacts) {
    for (const CurveRef& ref : {contact.first, contact.second}) {
      if (ref.body != body) {
        continue;
      }
      if (contact.rolling || !is_round_about(curve_of(mechanism, ref), p_B, sized.size)) {
        return false;
      }
      touches = true;
    }
  }
  return touches;
}

bool turns_idly(const SizedMechanism& sized, int body) {
  const auto middle = middle_of_turning(sized.mechanism, body);
  return middle && turns_idly(sized, body, *middle);
}

}  // namespace higherpair

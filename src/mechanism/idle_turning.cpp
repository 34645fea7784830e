#include "idle_turning.hpp"

#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/tolerances.hpp"

#include <algorithm>
#include <optional>

namespace higherpair {
namespace {

bool is_round_about(const Curve& curve, const Vector2d& p_B, double distance) {
  const auto middle = round_center(curve);
  return middle && (*middle - p_B).norm() <= distance;
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
      if (contact.rolling || !is_round_about(curve_of(mechanism, ref), p_B, kRoundAbout * sized.size)) {
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

bool is_nearly_round(const SizedMechanism& sized, int body) {
  const auto middle = middle_of_turning(sized.mechanism, body);
  const auto is_off = [&](const CurveRef& ref) {
    return ref.body == body &&
           !is_round_about(curve_of(sized.mechanism, ref), *middle, kNearlyRound * sized.size);
  };
  return middle && std::none_of(sized.mechanism.contacts.begin(), sized.mechanism.contacts.end(),
                                [&](const Contact& contact) {
                                  return is_off(contact.first) || is_off(contact.second);
                                });
}

}  // namespace higherpair

#include "condition_notes.hpp"

#include "io/tolerances.hpp"

#include <cmath>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

bool is_same_point(const Mechanism& mechanism, double size, const PointRef& a, const PointRef& b) {
  const auto& points = mechanism.bodies[a.body].points;
  return a.body == b.body && (points[a.point].p_B - points[b.point].p_B).norm() <= kSamePoint * size;
}

// Pins of the same two points, in either order, or slides and slots of them along the same line.
bool is_same_condition(const Mechanism& mechanism, double size, const Joint& a, const Joint& b) {
  const auto same = [&](const PointRef& first, const PointRef& second) {
    return is_same_point(mechanism, size, a.first, first) && is_same_point(mechanism, size, a.second, second);
  };
  if (a.type != b.type || couples_turning(a.type)) {
    return false;
  }
  if (a.type == JointType::kRevolute) {
    return same(b.first, b.second) || same(b.second, b.first);
  }
  const Vector2d& u = a.direction_A;
  const Vector2d& v = b.direction_A;
  return same(b.first, b.second) && std::abs(u.x() * v.y() - u.y() * v.x()) <= kSamePoint;
}

bool is_same_curve(const Mechanism& mechanism, const CurveRef& a, const CurveRef& b) {
  if (a.body != b.body) {
    return false;
  }
  const auto& curves = mechanism.bodies[a.body].curves;
  return a.curve == b.curve ||
         (!curves[a.curve].parts.empty() && curves[a.curve].parts == curves[b.curve].parts);
}

// Two curves may touch at two places, on opposite sides: then the approaches differ.
bool is_same_condition(const Mechanism& mechanism, const Contact& a, const Contact& b) {
  const auto same = [&](const CurveRef& first, const CurveRef& second) {
    return is_same_curve(mechanism, a.first, first) && is_same_curve(mechanism, a.second, second);
  };
  return a.approach == b.approach && (same(b.first, b.second) || same(b.second, b.first));
}

template <class Items, class IsSame>
std::string note(const Items& items, std::size_t index, const char* room, const IsSame& is_same) {
  for (std::size_t i = 0; i < index; ++i) {
    if (is_same(items[i], items[index])) {
      return fmt::format(
          "gives the same condition as {}.{}, so how they share their force is undefined, and it is left "
          "empty: leave one of them out",
          room, items[i].name);
    }
  }
  return "";
}

}  // namespace

std::string repeated_joint_note(const Mechanism& mechanism, double size, std::size_t joint) {
  return note(mechanism.joints, joint, "joints",
              [&](const Joint& a, const Joint& b) { return is_same_condition(mechanism, size, a, b); });
}

std::string repeated_contact_note(const Mechanism& mechanism, std::size_t contact) {
  return note(mechanism.contacts, contact, "contacts",
              [&](const Contact& a, const Contact& b) { return is_same_condition(mechanism, a, b); });
}

}  // namespace higherpair::io_detail

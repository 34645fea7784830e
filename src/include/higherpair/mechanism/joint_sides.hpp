#pragma once

#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <cstddef>
#include <optional>
#include <vector>

// A joint or contact as seen from one of its bodies.

namespace higherpair {

/// Whether one end of a joint or contact is on a body.
template <class Pair>
[[nodiscard]] bool has_end_on(const Pair& pair, int body) {
  return pair.first.body == body || pair.second.body == body;
}

/// Whether a joint is between these two bodies.
[[nodiscard]] inline bool joins(const Joint& joint, int one, int other) {
  return one != other && has_end_on(joint, one) && has_end_on(joint, other);
}

/// Whether a joint leaves a body one freedom relative to ground.
[[nodiscard]] inline bool is_grounded(const Joint& joint) {
  return has_end_on(joint, kGround) && can_be_driven(joint.type);
}

/// The joint that leaves a body one freedom relative to ground; none unless there is exactly one.
[[nodiscard]] inline std::optional<int> ground_joint(const Mechanism& mechanism, int body) {
  std::optional<int> found;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (is_grounded(joint) && joins(joint, kGround, body)) {
      if (found) return std::nullopt;
      found = static_cast<int>(i);
    }
  }
  return found;
}

/// The point or curve on a body. \pre has_end_on(pair, body)
template <class Pair>
[[nodiscard]] const auto& end_on(const Pair& pair, int body) {
  return pair.first.body == body ? pair.first : pair.second;
}

/// That on the other body.
template <class Pair>
[[nodiscard]] const auto& end_off(const Pair& pair, int body) {
  return pair.first.body == body ? pair.second : pair.first;
}

/// The curve of side 0 or 1.
[[nodiscard]] inline const CurveRef& ref_of(const Contact& contact, std::size_t side) {
  return side == 0 ? contact.first : contact.second;
}

/// A contact and one of its two curves.
struct SideOfContact {
  std::size_t contact = 0;
  std::size_t side = 0;  ///< 0 or 1
};

/// Both sides of all contacts by_boundary: a range that is its own iterator.
class BoundarySides {
public:
  explicit BoundarySides(const Mechanism& mechanism)
      : contacts_(mechanism.contacts.data()), end_(2 * mechanism.contacts.size()) {
    skip_others();
  }

  [[nodiscard]] BoundarySides begin() const { return *this; }
  [[nodiscard]] std::size_t end() const { return end_; }
  SideOfContact operator*() const { return {at_ / 2, at_ % 2}; }
  bool operator!=(std::size_t end) const { return at_ != end; }
  void operator++() {
    ++at_;
    skip_others();
  }

private:
  void skip_others() {
    while (at_ != end_ && !contacts_[at_ / 2].by_boundary) ++at_;
  }

  const Contact* contacts_;
  std::size_t end_;
  std::size_t at_ = 0;  // 2 contact + side
};

/// The point of a joint on a body, in its frame.
[[nodiscard]] inline const Vector2d& point_on(const Mechanism& mechanism, const Joint& joint, int body) {
  return point_of(mechanism, end_on(joint, body));
}

/// The point of a joint on the body other than this one.
[[nodiscard]] inline BodyPoint known_end(const Mechanism& mechanism, const Joint& joint, int body) {
  const PointRef& end = end_off(joint, body);
  return {end.body, point_of(mechanism, end)};
}

}  // namespace higherpair

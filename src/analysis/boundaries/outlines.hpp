#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/contact/near_places.hpp"

#include <array>
#include <optional>
#include <vector>

// What the search for where two bodies meet has to know of their outlines, which are boundaries, or curves
// that are convex or concave throughout. Both kinds answer the same questions.

namespace higherpair {

/// The two bodies of a contact at a position within a step.
struct Pairing {
  double x = 0;  ///< distance on the path from the step's beginning
  BodyMotion body1, body2;
  std::optional<CommonNormal> own;  ///< the contact's normal, while it is closed
};

/// The smaller of two bodies, which the other one is looked at from.
struct SmallerBody {
  bool is_first = true;
  Vector2d middle_B = Vector2d::Zero();
  double reach = 0;  ///< of its points from there [m]

  /// Upper bound of the speed of any of its points against the other body, per unit of the path.
  [[nodiscard]] double speed(const Pairing& at) const;
};

class BoundaryOutlines {
public:
  /// \param at  the contact at the step's beginning
  BoundaryOutlines(const Mechanism& mechanism, const Contact& contact, const ContactMotion& at);

  /// The places of least gap that are at most `reach` apart.
  [[nodiscard]] std::vector<NearPlace> near(const Pairing& at, double reach) const;
  /// The same place after the bodies have moved.
  [[nodiscard]] std::optional<NearPlace> moved(const Pairing& to, const NearPlace& before) const;
  /// Whether the bodies overlap however far out, where there is no place of least gap.
  [[nodiscard]] static bool overlap_far_out(const Pairing& /*at*/) { return false; }
  /// Whether a corner of one boundary is beside a face of the other at the corners from which the contact
  /// starts. The contact's own tangent separates the bodies there. A corner that has gone over a sharp one is
  /// behind the face that it has left, but not within the body.
  [[nodiscard]] bool leaves_corners(const NearPlace& place) const;
  [[nodiscard]] const SmallerBody& smaller() const { return smaller_; }
  /// Of both boundaries together [m].
  [[nodiscard]] double size() const { return boundary1_.size() + boundary2_.size(); }

private:
  const Boundary& boundary1_;
  const Boundary& boundary2_;
  SmallerBody smaller_;
  std::optional<std::array<int, 2>>
      corners_;  // where the contact is at the step's beginning, if it is at two
};

class CurveOutlines {
public:
  /// \param size  at the contact [m]
  CurveOutlines(const Mechanism& mechanism, const Contact& contact, double size);

  /// As for boundaries, with or without the contact itself.
  [[nodiscard]] std::vector<NearPlace> near(const Pairing& at, double reach) const;
  [[nodiscard]] std::optional<NearPlace> moved(const Pairing& to, const NearPlace& before) const;
  [[nodiscard]] bool overlap_far_out(const Pairing& at) const;
  [[nodiscard]] static bool leaves_corners(const NearPlace& /*place*/) { return false; }
  [[nodiscard]] const SmallerBody& smaller() const { return smaller_; }
  /// At the contact [m].
  [[nodiscard]] double size() const { return size_; }

private:
  const Curve& curve1_;
  const Curve& curve2_;
  SmallerBody smaller_;
  double size_;
};

}  // namespace higherpair

#pragma once

#include "higherpair/geometry/arc_length.hpp"
#include "higherpair/geometry/expansion.hpp"
#include "higherpair/geometry/support.hpp"
#include "higherpair/mechanism/description.hpp"

#include <array>
#include <optional>
#include <type_traits>
#include <vector>

namespace higherpair {

/// The conditions of joints, contacts and drivers as functions of the coordinates of the bodies, the angle φ
/// of the normal of each contact, and the dimensions of the mechanism. They are written only once; the scalar
/// type determines the result.
///     T = double         residuals
///     T = Partials       the Jacobian as well
///     T = PowerSeries    rates, accelerations, jerks, … for coordinates that are series in time
///     D = Partials       any of these with its derivatives with respect to dimensions
/// Every value is a length: angles are multiplied by a size. It is 0 where the condition holds.
/// \tparam T  type of the coordinates
/// \tparam D  type of the dimensions: double, T, or the coefficients of T

/// The coordinates of a body: position of its frame in ground [m], and its angle [rad].
template <class T>
struct BodyAt {
  Pose<T> X_WB;
  T theta{0};

  /// A point fixed in the body, in ground [m].
  template <class D>
  [[nodiscard]] Vector2<T> point(const Vector2<D>& p_B) const {
    return X_WB.p_WB + vector(p_B);
  }
  /// A vector fixed in the body, expressed in ground.
  template <class D>
  [[nodiscard]] Vector2<T> vector(const Vector2<D>& v_B) const {
    const auto& [c, s] = X_WB.R_WB;
    return vector_of(T(c * v_B.x() - s * v_B.y()), T(s * v_B.x() + c * v_B.y()));
  }
};

/// The angle [rad] reduced by whole turns to the value nearest to 0.
template <class T>
[[nodiscard]] inline T without_turns(const T& angle) {
  const double value = value_of(angle);
  return angle + (nearest_turn(value, 0) - value);
}

/// The numbers of a joint that its conditions depend on; see Joint.
template <class D>
struct JointDimensions {
  JointType type = JointType::kRevolute;
  Vector2<D> p_A = Vector2<D>::Zero(), p_B = p_A, direction_A = p_A;
  D relative_angle{0};
  D turning_ratio{1};
};

/// The values of the conditions of one joint, contact or driver.
template <class T>
struct ConditionValues {
  std::array<T, 3> value{};
  int count = 0;
  bool exist = true;  ///< false: a curve has no point with the normal of φ, and the values are meaningless

  void add(const T& v) { value[count++] = v; }
};

/// Coordinate of a joint: [rad], or [m] along its line (see JointType).
/// \param carrier  used for gears and belts only
template <class T, class D>
[[nodiscard]] T joint_coordinate(const JointDimensions<D>& joint, const BodyAt<T>& first,
                                 const BodyAt<T>& second, const BodyAt<T>& carrier) {
  if (has_angle(joint.type)) {
    return second.theta - (couples_turning(joint.type) ? carrier : first).theta;
  }
  return (second.point(joint.p_B) - first.point(joint.p_A)).dot(first.vector(joint.direction_A));
}

/// Number of conditions of a joint.
[[nodiscard]] constexpr int condition_count(JointType type) {
  return type == JointType::kRevolute || type == JointType::kPrismatic ? 2 : 1;
}

/// Revolute: x and y of p_B - p_A. Prismatic: the distance of p_B from the line of A, and size·(θ_B - θ_A -
/// relative angle), less whole turns. Slot: that distance. Gears and belts: size·((θ_B - θ_C) - k (θ_A -
/// θ_C) - relative angle), C the carrier and k the turning ratio.
template <class T, class D>
[[nodiscard]] ConditionValues<T> joint_conditions(const JointDimensions<D>& joint, const BodyAt<T>& first,
                                                  const BodyAt<T>& second, const BodyAt<T>& carrier,
                                                  double size) {
  ConditionValues<T> values;
  if (couples_turning(joint.type)) {
    values.add(size * ((second.theta - carrier.theta) - joint.turning_ratio * (first.theta - carrier.theta) -
                       joint.relative_angle));
    return values;
  }
  const Vector2<T> apart = second.point(joint.p_B) - first.point(joint.p_A);
  if (joint.type == JointType::kRevolute) {
    values.add(apart.x());
    values.add(apart.y());
    return values;
  }
  values.add(cross(first.vector(joint.direction_A), apart));
  if (joint.type == JointType::kPrismatic) {
    values.add(size * without_turns(T(second.theta - first.theta - joint.relative_angle)));
  }
  return values;
}

/// The coordinate of a driven joint less the position of the driver [rad or m].
template <class T, class D>
[[nodiscard]] T driver_condition(const JointDimensions<D>& joint, const BodyAt<T>& first,
                                 const BodyAt<T>& second, const T& position, double size) {
  const T off = joint_coordinate(joint, first, second, first) - position;
  return has_angle(joint.type) ? T(size * off) : off;
}

/// The numbers of a curve that a condition depends on; see Curve.
template <class D>
struct CurveDimensions {
  CurveKind kind = CurveKind::kPoint;
  double side = 1;  ///< +1 where the body is on the convex side, -1 where it is on the other
  Vector2<D> vertex_B, axis_B;
  D semi_latus{0};
  D q{1};
  /// For the local curve of a boundary: the support of the boundary exceeds that of the conic by
  /// Σ beyond[k] (φ - normal_angle)^(k+4) [m], φ being the angle of the normal in the body's frame. Nothing
  /// up to the third derivative of a motion depends on it.
  std::array<double, 3> beyond{};
  double normal_angle = 0;
  /// For a circle or line that represents a nearly straight part of a boundary: its height over the tangent
  /// at the vertex is Σ bend[k] x^(k+2) at the distance x along n turned +90° [m].
  bool bent = false;
  std::array<D, 5> bend{};
};

/// Adds to a point of the local conic what the boundary has beyond it: p = h n + h′ t, ρ = h + h″.
/// \param turn  φ - normal_angle, but for whole turns
template <class T, class D>
void add_beyond(const CurveDimensions<D>& curve, const T& turn, const Vector2<T>& n_W,
                SupportPoint<T>& point) {
  const T x = without_turns(turn);
  T h(0), dh(0), ddh(0);
  T power = x * x;
  for (std::size_t k = 0; k < curve.beyond.size(); ++k) {
    const auto n = static_cast<double>(k + 4);
    ddh += n * (n - 1) * curve.beyond[k] * power;
    power = power * x;
    dh += n * curve.beyond[k] * power;
    h += curve.beyond[k] * power * x;
  }
  point.p_W += h * n_W + dh * perp(n_W);
  point.rho += h + ddh;
}

/// Two curves with a common normal: n out of curve 1, and the points with the outward normals n and -n.
template <class T>
struct FacingPoints {
  Vector2<T> n_W;
  Vector2<T> p1_W, p2_W;  ///< for a line its given point
  T rho1{0}, rho2{0};     ///< [m]; 0 for a line
  T phi{0};               ///< angle of n [rad]: for a line that of its face
  T off{0};               ///< excess of the coordinate φ over that angle
  bool exist = true;      ///< false: a curve has no such point
};

/// Any curve but a line, at the present pose of its body.
template <class T, class D>
[[nodiscard]] PlacedCurve<T, D> placed_on(const BodyAt<T>& body, const CurveDimensions<D>& curve) {
  return {body.point(curve.vertex_B), body.vector(curve.axis_B), curve.semi_latus, curve.q, curve.side};
}

/// The point of a curve with an outward normal, for any curve but a line.
/// \param theta  of the body \param exist  set to false where there is no such point
template <class T, class D>
[[nodiscard]] SupportPoint<T> outline_point(const CurveDimensions<D>& own, const PlacedCurve<T, D>& curve,
                                            const T& theta, const Vector2<T>& n_W, const T& angle_of_n,
                                            bool& exist) {
  SupportPoint<T> support = support_point(curve, n_W);
  if (own.beyond != std::array<double, 3>{}) {
    add_beyond(own, T(angle_of_n - theta - own.normal_angle), n_W, support);
  }
  const bool near_half = value_of(T(n_W.dot(curve.axis_W))) * curve.side < 0;
  exist = exist && (curve.q > D(0) || (near_half && value_of(support.w2) > 0));
  return support;
}

/// The points of both curves whose normals lie along φ, the angle of curve 1's outward normal in ground W
/// [rad]: in contact where they coincide. A line prescribes the normal; `off` is then what φ exceeds its
/// angle by.
template <class T, class D>
[[nodiscard]] FacingPoints<T> facing_points(const CurveDimensions<D>& curve1, const BodyAt<T>& body1,
                                            const CurveDimensions<D>& curve2, const BodyAt<T>& body2,
                                            const T& phi) {
  using std::cos;
  using std::sin;
  const bool flat1 = curve1.kind == CurveKind::kLine;
  const bool flat2 = curve2.kind == CurveKind::kLine;
  const PlacedCurve<T, D> first = placed_on(body1, curve1);
  const PlacedCurve<T, D> second = placed_on(body2, curve2);
  FacingPoints<T> at;
  at.phi = phi;
  if (flat1 || flat2) {
    at.n_W = flat1 ? Vector2<T>(-first.axis_W) : second.axis_W;
    const Vector2<D> n_B = flat1 ? Vector2<D>(-curve1.axis_B) : curve2.axis_B;
    at.off = without_turns(T(phi - (flat1 ? body1 : body2).theta - angle_of(n_B)));
    at.phi = phi - at.off;
  } else {
    at.n_W = vector_of(T(cos(phi)), T(sin(phi)));
  }
  at.p1_W = first.vertex_W;
  at.p2_W = second.vertex_W;
  const auto set_point = [&](const CurveDimensions<D>& own, const PlacedCurve<T, D>& curve, const T& theta,
                             const Vector2<T>& n_W, const T& angle_of_n, Vector2<T>& p_W, T& rho) {
    const auto support = outline_point(own, curve, theta, n_W, angle_of_n, at.exist);
    p_W = support.p_W;
    rho = support.rho;
  };
  if (!flat1) {
    set_point(curve1, first, body1.theta, at.n_W, at.phi, at.p1_W, at.rho1);
  }
  if (!flat2) {
    set_point(curve2, second, body2.theta, -at.n_W, T(at.phi + kPi), at.p2_W, at.rho2);
  }
  return at;
}

/// Arc of a conic at ψ, with the sign of its side, from its derivative ρ [m]. \param x, y  of the point, as
/// in open_arc_length [m]
template <class T, class D>
[[nodiscard]] T arc_along(const CurveDimensions<D>& curve, const T& psi, const T& x, const T& y,
                          const T& rho) {
  if constexpr (std::is_same_v<T, D>) {
    return curve.side * (curve.q > D(0) ? conic_arc_length(curve.semi_latus, curve.q, psi)
                                        : open_arc_length(curve.semi_latus, curve.q, x, y));
  } else {
    return integrated(arc_along(curve, psi.c[0], x.c[0], y.c[0], rho.c[0]), rho, psi);
  }
}

/// Arc coordinate of a conic's point p with the outward normal angle ψ, growing with it [m]; 0 for points.
/// \param rho  radius of curvature there
template <class T, class D>
[[nodiscard]] T conic_arc(const CurveDimensions<D>& curve, const BodyAt<T>& body, const Vector2<T>& p_W,
                          const T& normal_angle, const T& rho) {
  if (curve.kind == CurveKind::kPoint) {
    return T(0);
  }
  const T psi = normal_angle - body.theta - angle_of(Vector2<D>(-curve.axis_B)) - (curve.side > 0 ? 0 : kPi);
  const Vector2<T> axis_W = body.vector(curve.axis_B);
  const Vector2<T> d = p_W - body.point(curve.vertex_B);
  return arc_along(curve, curve.q > D(0) ? psi : without_turns(psi), T(d.dot(axis_W)), T(cross(d, axis_W)),
                   rho);
}

/// Arc of the contact point on the first curve less that on the second, both along t = n turned +90°, as if
/// the points coincided: constant where the bodies roll [m]. For a line the arc is the distance from its
/// given point. 0 where the points do not exist.
template <class T, class D>
[[nodiscard]] T arc_difference(const CurveDimensions<D>& curve1, const BodyAt<T>& body1,
                               const CurveDimensions<D>& curve2, const BodyAt<T>& body2,
                               const FacingPoints<T>& at) {
  if (!at.exist) {
    return T(0);
  }
  const Vector2<T> t_W = perp(at.n_W);
  const T apart = (at.p2_W - at.p1_W).dot(t_W);
  T difference(0);
  if (curve1.kind == CurveKind::kLine || curve2.kind == CurveKind::kLine) {
    difference += apart;
  }
  if (curve1.kind != CurveKind::kLine) {
    difference += conic_arc(curve1, body1, at.p1_W, at.phi, at.rho1);
  }
  if (curve2.kind != CurveKind::kLine) {
    difference += conic_arc(curve2, body2, at.p2_W, T(at.phi + kPi), at.rho2);
  }
  return difference;
}

/// The same for a contact of Dimensions, with the bodies indexed as in the mechanism and the normal at the
/// angle φ.
template <class ContactDimensions, class T>
[[nodiscard]] T arc_difference(const ContactDimensions& contact, const std::vector<BodyAt<T>>& bodies,
                               const T& phi) {
  const BodyAt<T>& body1 = bodies[contact.first];
  const BodyAt<T>& body2 = bodies[contact.second];
  return arc_difference(contact.curve1, body1, contact.curve2, body2,
                        facing_points(contact.curve1, body1, contact.curve2, body2, phi));
}

/// The conditions of a contact on a curve that is nearly straight, whose normals do not determine where the
/// contact is: gap [m] of the other curve's point above it, and size·sin of the angle between the normals
/// there. \param n_W  out of the bent curve \param angle  of n [rad]
template <class T, class D>
[[nodiscard]] ConditionValues<T> bent_conditions(const CurveDimensions<D>& bent, const BodyAt<T>& body,
                                                 const CurveDimensions<D>& other, const BodyAt<T>& other_body,
                                                 const T& angle, double size) {
  using std::cos;
  using std::sin;
  const Vector2<T> n_W = vector_of(T(cos(angle)), T(sin(angle)));
  ConditionValues<T> values;
  const Vector2<T> facing = -n_W;
  const Vector2<T> p_W = outline_point(other, placed_on(other_body, other), other_body.theta, facing,
                                       T(angle + kPi), values.exist)
                             .p_W;
  const Vector2<T> up_W = -bent.side * body.vector(bent.axis_B);
  const Vector2<T> along_W = perp(up_W);
  const Vector2<T> d = p_W - body.point(bent.vertex_B);
  const T x = d.dot(along_W);
  T height(0), slope(0), power = x;
  for (std::size_t k = 0; k < bent.bend.size(); ++k) {
    slope += static_cast<double>(k + 2) * T(bent.bend[k]) * power;
    power = power * x;
    height += T(bent.bend[k]) * power;
  }
  values.add(d.dot(up_W) - height);
  values.add(size * cross(Vector2<T>(up_W - slope * along_W), n_W));
  return values;
}

/// Gap [m]; a condition for φ: the distance of the points along t [m] (with a line: size·(φ - angle of its
/// face)); and for a rolling contact the slip since the arcs differed by `held` [m]. At a contact point
/// neither the slip nor the gap depends on φ: at constant φ their derivatives with respect to the bodies are
/// the velocities of the material points along t and n.
template <class T, class D>
[[nodiscard]] ConditionValues<T> contact_conditions(const CurveDimensions<D>& curve1, const BodyAt<T>& body1,
                                                    const CurveDimensions<D>& curve2, const BodyAt<T>& body2,
                                                    const T& phi, const std::optional<T>& held, double size) {
  if (curve1.bent && !curve2.bent && curve2.kind != CurveKind::kLine) {
    return bent_conditions(curve1, body1, curve2, body2, phi, size);
  }
  if (curve2.bent && !curve1.bent && curve1.kind != CurveKind::kLine) {
    return bent_conditions(curve2, body2, curve1, body1, T(phi + kPi), size);
  }
  const FacingPoints<T> at = facing_points(curve1, body1, curve2, body2, phi);
  const Vector2<T> apart = at.p2_W - at.p1_W;
  const bool flat = curve1.kind == CurveKind::kLine || curve2.kind == CurveKind::kLine;
  ConditionValues<T> values;
  values.exist = at.exist;
  values.add(apart.dot(at.n_W));
  values.add(flat ? T(size * at.off) : T(cross(at.n_W, apart)));
  if (held) {
    const T arcs = arc_difference(curve1, body1, curve2, body2, at) - *held;
    values.add(flat ? arcs : T(arcs + values.value[1]));
  }
  return values;
}

}  // namespace higherpair

#pragma once

#include "higherpair/contact/common_normal.hpp"
#include "higherpair/mechanism/conditions.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// The dimensions of a mechanism that its conditions depend on.
/// \tparam D  double, or Partials: with the derivatives of all of them with respect to one or several
/// parameters
template <class D>
struct Dimensions {
  struct Joint {
    int first = 0, second = 0, carrier = 0;  ///< bodies
    JointDimensions<D> of;
  };
  struct Contact {
    int first = 0, second = 0;  ///< bodies
    CurveDimensions<D> curve1, curve2;
    bool rolling = false;
  };
  std::size_t bodies = 0;         ///< number of Mechanism::bodies
  std::vector<Joint> joints;      ///< of Mechanism::joints
  std::vector<Contact> contacts;  ///< of Mechanism::contacts
  std::vector<int> drivers;       ///< joint of each of Mechanism::drivers
};

/// \param number  makes a D from a number of the mechanism and the corresponding derivative
template <class D, class F>
[[nodiscard]] JointDimensions<D> joint_dimensions(const Mechanism& mechanism, const Joint& joint,
                                                  const Mechanism& derivative, const Joint& joint_derivative,
                                                  F number) {
  const auto vector = [&](const Vector2d& v, const Vector2d& dv) {
    return Vector2<D>(number(v.x(), dv.x()), number(v.y(), dv.y()));
  };
  JointDimensions<D> of;
  of.type = joint.type;
  of.relative_angle = number(joint.relative_angle, joint_derivative.relative_angle);
  of.turning_ratio = number(joint.turning_ratio, joint_derivative.turning_ratio);
  if (!couples_turning(joint.type)) {
    of.p_A = vector(point_of(mechanism, joint.first), point_of(derivative, joint.first));
    of.p_B = vector(point_of(mechanism, joint.second), point_of(derivative, joint.second));
    of.direction_A = vector(joint.direction_A, joint_derivative.direction_A);
  }
  return of;
}

/// The numbers alone.
[[nodiscard]] inline JointDimensions<double> joint_dimensions(const Mechanism& mechanism,
                                                              const Joint& joint) {
  return joint_dimensions<double>(mechanism, joint, mechanism, joint, [](double x, double) { return x; });
}

/// All numbers of a mechanism that its conditions depend on.
[[nodiscard]] Dimensions<double> dimensions_of(const Mechanism& mechanism);

/// Those of one curve.
[[nodiscard]] CurveDimensions<double> dimensions_of(const Curve& curve);

/// With the derivative of every dimension with respect to a parameter.
/// \param derivative  the same mechanism with each number replaced by its derivative
[[nodiscard]] Dimensions<Partials<double, 1>> dimensions_of(const Mechanism& mechanism,
                                                            const Mechanism& derivative);

/// Every coordinate that the conditions depend on, and the constants held by some of them.
template <class T>
struct Coordinates {
  std::vector<BodyAt<T>> bodies;  ///< of Mechanism::bodies; ground first
  std::vector<T> phi;             ///< angle of the normal of each contact, out of its first body [rad]
  std::vector<T> arcs;            ///< for each rolling contact: the constant arc difference [m]
  std::vector<T> drivers;         ///< position of each driver [rad or m]
  std::vector<T> held_angles;     ///< angle that each body keeps if it is idle [rad]
};

/// The coordinates of a body as the variables `first` to `first + 2` of N.
template <int N>
[[nodiscard]] BodyAt<Partials<double, N>> variable(const BodyAt<double>& at, std::size_t first) {
  BodyAt<Partials<double, N>> body;
  const auto& [c, s] = at.X_WB.R_WB;
  body.X_WB.R_WB = {c, s};
  body.X_WB.p_WB = {at.X_WB.p_WB.x(), at.X_WB.p_WB.y()};
  body.theta = at.theta;
  body.X_WB.p_WB.x().c[first] = 1;
  body.X_WB.p_WB.y().c[first + 1] = 1;
  body.theta.c[first + 2] = 1;
  body.X_WB.R_WB.cos.c[first + 2] = -s;
  body.X_WB.R_WB.sin.c[first + 2] = c;
  return body;
}

/// The same coordinates as constants of another scalar type.
template <class T>
[[nodiscard]] Coordinates<T> constant(const Coordinates<double>& at) {
  const auto all = [](const std::vector<double>& numbers) {
    return std::vector<T>(numbers.begin(), numbers.end());
  };
  Coordinates<T> constant{{}, all(at.phi), all(at.arcs), all(at.drivers), all(at.held_angles)};
  for (const BodyAt<double>& body : at.bodies) {
    const auto& [c, s] = body.X_WB.R_WB;
    const Vector2d& p_W = body.X_WB.p_WB;
    constant.bodies.push_back({{{T(c), T(s)}, {T(p_W.x()), T(p_W.y())}}, T(body.theta)});
  }
  return constant;
}

/// The values of coordinates of another scalar type.
template <class T>
[[nodiscard]] Coordinates<double> values_of(const Coordinates<T>& at) {
  const auto all = [](const std::vector<T>& numbers) {
    std::vector<double> values;
    for (const T& number : numbers) {
      values.push_back(value_of(number));
    }
    return values;
  };
  Coordinates<double> values{{}, all(at.phi), all(at.arcs), all(at.drivers), all(at.held_angles)};
  for (const BodyAt<T>& body : at.bodies) {
    const auto& [R_WB, p_WB] = body.X_WB;
    values.bodies.push_back(
        {{{value_of(R_WB.cos), value_of(R_WB.sin)}, {value_of(p_WB.x()), value_of(p_WB.y())}},
         value_of(body.theta)});
  }
  return values;
}

/// Some bodies and the conditions that determine them: those of a Group of a plan, or all of a mechanism.
struct ConditionSet : BodySet {
  std::vector<int> idle_bodies;  ///< whose rotation is not determined: they keep an angle
};

/// The values [m] of all conditions of a set: joints, contacts (gap, φ, slip if they roll), drivers, idle
/// bodies, in the order of the set. False where a contact's curve has no point for φ.
template <class T, class D>
bool append_conditions(const Dimensions<D>& dimensions, const ConditionSet& set, const Coordinates<T>& at,
                       double size, std::vector<T>& values) {
  const auto body = [&](int index) -> const BodyAt<T>& { return at.bodies[index]; };
  bool exist = true;
  const auto append = [&](const ConditionValues<T>& some) {
    exist = exist && some.exist;
    values.insert(values.end(), some.value.begin(), some.value.begin() + some.count);
  };
  for (const int index : set.joints) {
    const auto& joint = dimensions.joints[index];
    append(joint_conditions(joint.of, body(joint.first), body(joint.second), body(joint.carrier), size));
  }
  for (const int index : set.contacts) {
    const auto i = static_cast<std::size_t>(index);
    const auto& contact = dimensions.contacts[i];
    append(contact_conditions(contact.curve1, body(contact.first), contact.curve2, body(contact.second),
                              at.phi[i], contact.rolling ? std::optional<T>(at.arcs[i]) : std::nullopt,
                              size));
  }
  for (const int index : set.drivers) {
    const auto i = static_cast<std::size_t>(index);
    const auto& joint = dimensions.joints[dimensions.drivers[i]];
    values.push_back(driver_condition(joint.of, body(joint.first), body(joint.second), at.drivers[i], size));
  }
  for (const int idle : set.idle_bodies) {
    values.push_back(size * (body(idle).theta - at.held_angles[idle]));
  }
  return exist;
}

/// The points of a contact's curves that have its normal; for a line the foot of the other curve's point.
/// None where a curve has no such point.
[[nodiscard]] std::optional<CommonNormal> facing_at(const Dimensions<double>::Contact& contact,
                                                    const BodyAt<double>& first, const BodyAt<double>& second,
                                                    double phi);

/// Residual and Jacobian of the conditions of a set, in the order of append_conditions(). Its unknowns are
/// lengths: x, y and size·θ of each body of the set, then size·φ of each of its contacts.
class ConditionSystem {
public:
  /// \param size  [m], > 0, converts angles to lengths
  ConditionSystem(Dimensions<double> dimensions, ConditionSet set, double size);

  [[nodiscard]] const ConditionSet& set() const { return set_; }
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] Eigen::Index row_count() const { return rows_; }
  [[nodiscard]] Eigen::Index column_count() const { return columns_; }
  /// Column of x of a body; -1 if it is not in the set.
  [[nodiscard]] Eigen::Index body_column(int body) const { return body_columns_[body]; }
  /// Column of φ of a contact; -1 if it is not in the set.
  [[nodiscard]] Eigen::Index contact_column(int contact) const { return contact_columns_[contact]; }

  /// Residual [m] and Jacobian [1], resized if necessary. Returns whether each curve has a point with the
  /// normal φ (parabolas and hyperbolas have them for some normals only); if not, both are meaningless.
  bool evaluate(const Coordinates<double>& at, Eigen::VectorXd& values, Eigen::MatrixXd& J) const;

private:
  ConditionSet set_;
  Dimensions<double> dimensions_;
  double size_;
  Eigen::Index rows_ = 0, columns_ = 0;
  std::vector<Eigen::Index> body_columns_, contact_columns_;
};

}  // namespace higherpair

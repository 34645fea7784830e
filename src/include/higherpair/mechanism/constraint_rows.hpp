#pragma once

#include "higherpair/contact/common_normal.hpp"
#include "higherpair/geometry/pose.hpp"
#include "higherpair/mechanism/description.hpp"

#include <array>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// One condition of conditions.hpp with its derivatives with respect to the coordinates (x, y, θ) of at most
/// three bodies, for contacts at the common normal of both curves. With V = (v_x, v_y, ω) of a body's frame,
/// in ground, Σ coefficient·V is the rate of `value` [m], and the condition exerts λ·coefficient on its
/// bodies: a force and a torque about the frame's origin, λ in [N].
struct ConstraintRow {
  std::array<int, 3> body{};  ///< indices of Mechanism::bodies; ground where there are fewer
  std::array<Eigen::Vector3d, 3> coefficient{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                             Eigen::Vector3d::Zero()};
  double value = 0;  ///< [m]
};

/// The equivalent link of a contact.
[[nodiscard]] EquivalentLink link_of(const Mechanism& mechanism, const Contact& contact,
                                     const CommonNormal& at);

/// Where the search for a contact of bodies that need not touch yet begins: the places or the normal where
/// they are closest. \param size  of the mechanism [m]
[[nodiscard]] ContactMotion facing_motion(const Mechanism& mechanism, const Contact& contact,
                                          const Pose<double>& X_W1, const Pose<double>& X_W2, double size);

/// Moves a contact to the common normal near its present place, with the bodies held; false where there is
/// none.
[[nodiscard]] bool place_contact(const Mechanism& mechanism, const Contact& contact,
                                 const std::vector<BodyMotion>& bodies, ContactMotion& motion);

/// Number of rows: revolute and prismatic joints 2, slots, gears and belts 1; slipping contacts 1, rolling
/// ones 2.
[[nodiscard]] int row_count(const Joint& joint);
[[nodiscard]] int row_count(const Contact& contact);

/// The rows of a joint (joint_conditions).
/// \param size  [m], converts angles to lengths
void append_rows(const Mechanism& mechanism, const Joint& joint, const std::vector<BodyMotion>& bodies,
                 double size, std::vector<ConstraintRow>& rows);

/// The rows of a contact (contact_conditions): the gap along n, and for a rolling one the slip along t.
/// Neither depends on φ at a common normal; their coefficients are those of the material points there.
void append_rows(const Mechanism& mechanism, const Contact& contact, const ContactMotion& motion,
                 const std::vector<BodyMotion>& bodies, std::vector<ConstraintRow>& rows);

/// The row of a driver that prescribes the coordinate of a joint.
void append_driver_row(const Mechanism& mechanism, const Joint& joint, double position,
                       const std::vector<BodyMotion>& bodies, double size, std::vector<ConstraintRow>& rows);

/// The row that holds the angle of a body: size·(θ - held).
[[nodiscard]] ConstraintRow angle_row(const std::vector<BodyMotion>& bodies, int body, double held,
                                      double size);

/// Adds the coefficients of a row, by (x, y, size·θ), to a row of a matrix.
/// \param column_of  column of x of the row's k-th body; < 0: none
template <class Row, class F>
void add_coefficients(const ConstraintRow& row, double size, F column_of, Row&& J) {
  for (std::size_t k = 0; k < row.body.size(); ++k) {
    if (const Eigen::Index column = column_of(k); column >= 0) {
      J(column) += row.coefficient[k].x();
      J(column + 1) += row.coefficient[k].y();
      J(column + 2) += row.coefficient[k].z() / size;
    }
  }
}

/// The derivatives of rows by the coordinates (x, y, size·θ) of some bodies.
/// \param column_of  column of x of a body; < 0: none
template <class F>
[[nodiscard]] Eigen::MatrixXd jacobian_of(const std::vector<ConstraintRow>& rows, double size,
                                          Eigen::Index columns, F column_of) {
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), columns);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    add_coefficients(
        rows[i], size, [&](std::size_t k) { return column_of(rows[i].body[k]); },
        J.row(static_cast<Eigen::Index>(i)));
  }
  return J;
}

/// The values of rows [m].
[[nodiscard]] Eigen::VectorXd values_of(const std::vector<ConstraintRow>& rows);

/// Moves a body by a step in (x, y, size·θ).
void add_step(const Eigen::Vector3d& step, double size, BodyMotion& body);

/// Measures the arcs of a rolling contact from its present position on.
void start_arcs(const Mechanism& mechanism, const Contact& contact, const std::vector<BodyMotion>& bodies,
                ContactMotion& motion);

}  // namespace higherpair

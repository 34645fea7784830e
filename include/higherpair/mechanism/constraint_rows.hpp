#pragma once

#include "higherpair/contact/common_normal.hpp"
#include "higherpair/mechanism/description.hpp"

#include <array>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// One scalar condition that a joint, contact or driver imposes on at most three bodies. With V = (v_x, v_y,
/// ω) of a body's frame and A = (a_x, a_y, α), in ground:
///     value = 0,     Σ coefficient·V = rate,     Σ coefficient·A + gamma = 0,
/// and the coefficients are the derivatives of `value` by the coordinates (x, y, θ) of the bodies. Every row
/// has the unit of a length: angular conditions are multiplied by a size. What the row passes on to its
/// bodies is λ·coefficient: a force and a torque about the frame's origin, λ in [N].
struct ConstraintRow {
  std::array<int, 3> body{};  ///< indices of Mechanism::bodies; ground where there are fewer
  std::array<Eigen::Vector3d, 3> coefficient{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                             Eigen::Vector3d::Zero()};
  double value = 0;  ///< [m]
  double rate = 0;   ///< [m/s]; not 0 for drivers only
  double gamma = 0;  ///< [m/s²]
};

/// How a contact stands, seen from its first body: 1 is the first, 2 the second body of the file.
struct ContactMotion {
  CommonNormal at;
  double phi = 0;             ///< angle of at.n_W, continuous [rad]
  ContactRates rates;         ///< of the current velocities
  double arc_difference = 0;  ///< rolling: arc of the first less arc of the second curve, held [m]
};

/// Number of rows: revolute and prismatic joints 2, slots, gears and belts 1; slipping contacts 1, rolling
/// ones 2.
[[nodiscard]] int row_count(const Joint& joint);
[[nodiscard]] int row_count(const Contact& contact);

/// The rows of a joint. Revolute: x and y of p_B - p_A. Prismatic: distance of p_B from the line of A, and
/// size· (θ_B - θ_A - relative angle). Slot: that distance. Gears and belts: gear_row.
/// \param size  [m], makes lengths of angles
void append_rows(const Mechanism& mechanism, const Joint& joint, const std::vector<BodyMotion>& bodies,
                 double size, std::vector<ConstraintRow>& rows);

/// The condition of gears or a belt: size·(θ2 - θc - k (θ1 - θc) - relative angle), k the turning ratio.
[[nodiscard]] ConstraintRow gear_row(const Joint& joint, const std::vector<BodyMotion>& bodies, double size);

/// The rows of a contact: the gap along n, and for a rolling one the slip along t (its value: the difference
/// of the arcs travelled). `contact.rates` must be those of the velocities of `bodies`.
void append_rows(const Mechanism& mechanism, const Contact& contact, const ContactMotion& motion,
                 const std::vector<BodyMotion>& bodies, std::vector<ConstraintRow>& rows);

/// Arc of the contact point on the first curve less that on the second, both along t; constant where the
/// bodies roll [m].
[[nodiscard]] double arc_difference(const Mechanism& mechanism, const Contact& contact,
                                    const ContactMotion& motion, const std::vector<BodyMotion>& bodies);

/// The row of a driver that prescribes the coordinate of a joint and its rates.
void append_driver_row(const Mechanism& mechanism, const Joint& joint, double position, double velocity,
                       double acceleration, const std::vector<BodyMotion>& bodies, double size,
                       std::vector<ConstraintRow>& rows);

}  // namespace higherpair

#pragma once

#include "higherpair/mechanism/analyse_mobility.hpp"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// A mechanism and the length by which angles are multiplied.
struct SizedMechanism {
  const Mechanism& mechanism;
  double size = 1;  ///< [m], > 0

  [[nodiscard]] Eigen::Index columns() const {
    return 3 * (static_cast<Eigen::Index>(mechanism.bodies.size()) - 1);
  }
};

/// The first of the three columns of a moving body.
[[nodiscard]] constexpr Eigen::Index column_of(int body) {
  return 3 * (static_cast<Eigen::Index>(body) - 1);
}

/// Conditions as a linear system in the rates (x, y, size·θ) of the moving bodies, body 1 first.
struct LinearConditions {
  Eigen::MatrixXd J;
  Eigen::VectorXd values;
};

/// Which conditions hold in addition to those of joints and contacts.
struct Held {
  bool arcs = true;             ///< the difference of the arcs travelled, for rolling contacts
  std::vector<double> drivers;  ///< coordinates of Mechanism::drivers; empty: free
};

/// The rows of the joints in their order, those of the contacts, then those of the drivers if they are held.
[[nodiscard]] LinearConditions conditions_at(const SizedMechanism& sized, const Held& held,
                                             const MechanismPosition& position);

/// The rows of all drivers.
[[nodiscard]] Eigen::MatrixXd driver_rows(const SizedMechanism& sized, const MechanismPosition& position);

/// Assembles by the Gauss-Newton method from a nearby position; the step has least norm where the conditions
/// leave freedom.
[[nodiscard]] std::optional<MechanismPosition> assemble_from(const SizedMechanism& sized, const Held& held,
                                                             MechanismPosition position);

/// The same from a position beside an assembled one. Conditions that repeat others do so only where the
/// mechanism is assembled: beside it they are nearly dependent, and their differences do not determine a
/// step.
[[nodiscard]] std::optional<MechanismPosition> assemble_beside(const SizedMechanism& sized,
                                                               MechanismPosition position);

/// Assembles a mechanism near its poses, by least steps (Gauss-Newton on all conditions: of least norm where
/// they leave freedom, in the least-squares sense where they repeat each other). None where that does not
/// close to 1e-10 of the size.
/// \param drivers  coordinates of Mechanism::drivers to hold [rad or m]; empty: the drivers are left free
[[nodiscard]] std::optional<MechanismPosition> assemble_near_poses(const Mechanism& mechanism,
                                                                   const std::vector<double>& drivers);

/// Assembles a mechanism from a position that is assembled or nearly so; rolling contacts begin to roll
/// there.
[[nodiscard]] std::optional<MechanismPosition> assemble_near(const Mechanism& mechanism,
                                                             const MechanismPosition& position);

/// Moves the bodies by a step in (x, y, size·θ).
void add_step(const SizedMechanism& sized, const Eigen::VectorXd& step, MechanismPosition& position);

/// The step in (x, y, size·θ) from one position to another.
[[nodiscard]] Eigen::VectorXd step_between(const SizedMechanism& sized, const MechanismPosition& from,
                                           const MechanismPosition& to);

}  // namespace higherpair

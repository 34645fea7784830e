#pragma once

#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/dynamics/statics.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace higherpair {

/// Inverse dynamics of a running analysis: Newton's and Euler's equations of every moving body with gravity,
/// inertia, loads, springs and dampers, solved for the reactions of joints and contacts and the efforts of
/// drivers. Contacts slip without friction. Bodies without mass have no inertia. Idle bodies
/// (Plan::idle_bodies, such as a roller) have no angular acceleration: a moment about their pin, which
/// nothing resists, has no effect on any force; Statics::holding() says what it is.
class InverseDynamics {
public:
  explicit InverseDynamics(const Run& run);

  /// The reactions in run.row. With one driver and no surplus of conditions nothing is allocated.
  /// \param run  the one of the constructor, or a copy
  /// \return a member of this object, which the next call overwrites: copy what is to outlast that
  const Reactions& solve(const Run& run);

  /// The balance of the last row whose reactions are defined.
  [[nodiscard]] const Statics& statics() const { return statics_; }

private:
  void read_joints(const Run& run);
  void read_contacts(const Run& run);
  void read_efforts(const Run& run);
  void add_virtual_power(const Run& run);
  [[nodiscard]] std::optional<double> determined(std::size_t row, double factor) const;
  [[nodiscard]] double power(const std::vector<BodyMotion>& bodies) const;

  Statics statics_;
  std::vector<Wrench> wrenches_;  ///< gravity, loads, springs and inertia of each body
  std::vector<Wrench> left_;      ///< the same, consumed by the balance
  Reactions reactions_;
  State unit_;  ///< motion with a unit rate of one of several drivers
};

}  // namespace higherpair

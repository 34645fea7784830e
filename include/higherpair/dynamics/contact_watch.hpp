#pragma once

#include "higherpair/dynamics/reactions.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace higherpair {

/// Where a contact begins to pull.
struct ContactOpening {
  enum class Kind {
    kRoot,    ///< the contact force passes through 0
    kPole,    ///< it changes its sign by growing beyond all bounds: a dead point, not a lift-off
    kPulled,  ///< it pulls already in the first row of the run, or after a gap of it
  };
  std::size_t contact = 0;
  Kind kind = Kind::kRoot;
  double driver = 0;  ///< coordinate of the first driven joint [rad or m]
};

/// What one preload would have to be for a contact to press at all positions seen: the contact force is
/// linear in it, so that every position bounds it from one side.
struct PreloadNeed {
  std::size_t contact = 0;
  Preload preload;
  double low = -std::numeric_limits<double>::infinity();  ///< [N, or N m on a revolute joint]
  double high = std::numeric_limits<double>::infinity();
  bool opened = false;  ///< the contact pulled somewhere

  /// The smallest preload that keeps the contact closed; none where no constant one does.
  [[nodiscard]] std::optional<double> smallest() const;
};

/// What can press a contact: the first spring that acts on its follower (the body that comes later in the
/// order of solution), else on a body placed together with it, else an effort on the joint that carries
/// these bodies. None where the bodies hang on nothing that comes before.
[[nodiscard]] std::optional<Preload> preload_of(const Run& run, std::size_t contact);

/// Follows the contact forces of a run from row to row, and between rows that lie far apart: it looks every 5
/// degrees of a turning driver, every 1/12 of the size of a sliding one.
class ContactWatch {
public:
  explicit ContactWatch(const Run& run);

  /// To be called once after each row's move_to and solve, with the drivers of that move_to. Returns the
  /// contacts that have begun to pull since the row before, each with the position at which it did: the root
  /// of its force, by running that stretch of the drivers' path again. A contact that opens and closes
  /// between two positions looked at is not seen.
  const std::vector<ContactOpening>& look(const Run& run, const std::vector<DriverMotion>& drivers,
                                          InverseDynamics& dynamics, const Reactions& reactions);

  /// For every contact that something can press.
  [[nodiscard]] const std::vector<PreloadNeed>& needs() const { return needs_; }

private:
  void look_between(const Run& run, const std::vector<DriverMotion>& drivers);
  void look_at(const Run& run, const std::vector<DriverMotion>& drivers, InverseDynamics& dynamics,
               const Reactions& reactions);
  [[nodiscard]] ContactOpening locate(const Run& run, const std::vector<DriverMotion>& drivers,
                                      std::size_t contact, double force) const;
  void bound(const Run& run, InverseDynamics& dynamics, const Reactions& reactions);

  std::vector<PreloadNeed> needs_;
  std::vector<DriverMotion> drivers_before_;
  std::vector<std::optional<double>> forces_before_;  ///< of the contacts, at the position before
  std::vector<bool> pulled_before_;
  std::vector<ContactOpening> openings_;
};

}  // namespace higherpair

#pragma once

#include "higherpair/analysis/state.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// A number of a body, of one of its points, of a contact, a joint or the driver in every row of a run; SI
/// units, ground frame.
struct ChainColumn {
  /// kPressure: angle in [0, π/2] between the normal and the direction in which the joint of the contact's
  /// second body lets its point move. kForceX, kForceY, kMoment: what a joint does to its second body
  /// (JointReaction). kContactForce: what a contact presses with (ContactReaction). kEffort, kEffortByPower:
  /// what drives (DriverEffort).
  enum class Quantity {
    kPressure,
    kX,
    kY,
    kAngle,
    kVx,
    kVy,
    kOmega,
    kAx,
    kAy,
    kAlpha,
    kForceX,
    kForceY,
    kMoment,
    kContactForce,
    kEffort,
    kEffortByPower
  };
  /// Of kPressure and kContactForce: index of Mechanism::contacts; of a joint's: of Mechanism::joints.
  int body = 0;
  std::optional<int> point;  ///< of Body::points; none: the frame's origin
  Quantity quantity = Quantity::kX;
};

/// The rows of linkages that differ in dimensions alone, of each at once: for many variants of one mechanism.
///
/// A linkage of one driver on ground and of dyads (RRR, RRP, RPR), each joined to bodies before it, has its
/// rows in closed form once the mode of every dyad is known. A Run follows the motion to know that the modes
/// stay. Here that is proven: from the rows and from bounds of the second derivatives between them no dyad
/// comes near a limit. Where it cannot be proven there is no answer, and a Run has to be asked.
///
/// Discs that touch, slipping, are such a dyad as well, that of their equivalent linkage; so is a disc on a
/// knife edge. The contact of an ellipse with an ellipse, a disc or an edge is found for many rows at once by
/// Newton's method; each row is held against the one before by the tests that a Run makes of its steps, and
/// where one fails there is no answer either.
///
/// Forces follow from the rows, from the last group to the driver, with weights, inertia, loads, springs and
/// dampers. Where forces are wanted every contact must press on the whole way: where one comes near pulling
/// there is no answer, since a Run has to say where it opens.
///
/// One thread at a time. solve() allocates only where there are contacts, which a Run finds first, or where
/// two assemblies are as near to the poses as each other.
class DyadChain {
public:
  /// None where the mechanism is no such linkage: more or other groups, several drivers, ends of slides,
  /// other contacts, surplus conditions; or where a kPressure is not that of a body on ground that its
  /// contact places, or forces are wanted and there are bodies whose turning nothing sets.
  /// \param rows  the driver in every row, as move_to() would be told
  [[nodiscard]] static std::optional<DyadChain> of(const Mechanism& mechanism, const Plan& plan,
                                                   std::span<const DriverMotion> rows,
                                                   std::vector<ChainColumn> columns);
  DyadChain(DyadChain&& other) noexcept;
  DyadChain& operator=(DyadChain&& other) noexcept;
  ~DyadChain();

  /// Works out the columns. True only where a Run, started at the first row and moved to one after the other,
  /// would have given every row as `ok`, with no event but ends of strokes, at a tolerance of 1e-9 or above;
  /// its numbers are the same to within rounding.
  /// \param mechanism  the one of of() with other coordinates of points and other curves
  [[nodiscard]] bool solve(const Mechanism& mechanism);

  /// Of each row, of the last solve().
  [[nodiscard]] std::span<const double> values(std::size_t column) const;

private:
  struct Impl;
  explicit DyadChain(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace higherpair

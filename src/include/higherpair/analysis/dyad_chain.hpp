#pragma once

#include "higherpair/analysis/state.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// A quantity of a body, one of its points, a contact, a joint or the driver in every row of a run; SI units,
/// ground frame.
struct ChainColumn {
  /// kPressure: angle in [0, π/2] between the normal and the direction in which the joint of the contact's
  /// second body lets its point move. kForceX, kForceY, kMoment: reaction of a joint on its second body
  /// (JointReaction). kContactForce: contact force (ContactReaction). kEffort, kEffortByPower: driving effort
  /// (DriverEffort).
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
  /// What it is of. For kPressure and kContactForce: index of Mechanism::contacts; for a joint's quantity: of
  /// Mechanism::joints; else of Mechanism::bodies.
  int item = 0;
  std::optional<int> point;  ///< of Body::points; none: the frame's origin
  Quantity quantity = Quantity::kX;
};

/// The rows of linkages that differ only in their dimensions, all rows of one linkage at once: for many
/// variants of one mechanism.
///
/// A linkage of one driver on ground and of dyads (RRR, RRP, RPR), each joined to preceding bodies, has its
/// rows in closed form once the mode of every dyad is known. A Run follows the motion to make sure that the
/// modes do not change. Here that is proven: from the rows and from bounds of the second derivatives between
/// them it follows that no dyad comes near a limit. Where this cannot be proven there is no answer, and a Run
/// is required.
///
/// Discs in sliding contact are such a dyad as well, that of their equivalent linkage; so is a disc on a
/// knife edge. The contact of an ellipse with an ellipse, a disc or an edge is found for many rows at once by
/// Newton's method; each row is compared with the one before by the tests that a Run applies to its steps,
/// and where one fails there is no answer either.
///
/// Forces follow from the rows, from the last group to the driver, with weights, inertia, loads, springs and
/// dampers. Where forces are required every contact must press along the whole path: where one comes close to
/// pulling there is no answer, since only a Run can determine where it opens.
///
/// To be used by one thread at a time. solve() allocates only where there are contacts, which a Run finds
/// first, or where two assemblies are equally close to the poses.
class DyadChain {
public:
  /// None where the mechanism is not such a linkage (more or other groups, several drivers, ends of slides,
  /// other contacts, surplus conditions), where a kPressure is not that of a body on ground placed by its
  /// contact, or where forces are required and there are bodies whose rotation is not determined.
  /// \param rows  the driver in every row, as for move_to()
  [[nodiscard]] static std::optional<DyadChain> of(const Mechanism& mechanism, const Plan& plan,
                                                   std::span<const DriverMotion> rows,
                                                   std::vector<ChainColumn> columns);
  DyadChain(DyadChain&& other) noexcept;
  DyadChain& operator=(DyadChain&& other) noexcept;
  ~DyadChain();

  /// Computes the columns. True only where a Run, started at the first row and moved through all rows, would
  /// have given every row as `ok`, with no events but ends of strokes, at a tolerance of 1e-9 or above; its
  /// numbers are the same to within rounding.
  /// \param mechanism  that of of(), possibly with other coordinates of points and other curves
  [[nodiscard]] bool solve(const Mechanism& mechanism);

  /// One value for each row, of the last solve().
  [[nodiscard]] std::span<const double> values(std::size_t column) const;

private:
  struct Impl;
  explicit DyadChain(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace higherpair

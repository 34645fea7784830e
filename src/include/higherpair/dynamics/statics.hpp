#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/dynamics/applied_loads.hpp"

#include <cstddef>
#include <variant>
#include <vector>

#include <Eigen/LU>

namespace higherpair {

/// The static balance of a mechanism at a row of its run: the multipliers λ of all conditions of joints,
/// contacts and drivers (ConstraintRow) for which, on every moving body,
///     Σ λ·coefficient + W = 0
/// with W the other loads on it. Group by group in the reverse order of the plan: the conditions of a group
/// hold its own bodies, and their reactions load the bodies of earlier groups.
///
/// A body whose rotation is not determined (Plan::idle_bodies) keeps its angle in the motion; here an
/// additional condition holds it, with multiplier 0 if no moment acts about its pin.
///
/// More conditions than coordinates make the balance statically indeterminate. Then all bodies are solved at
/// once, by the pseudoinverse of the transposed Jacobian, and the multipliers common to all solutions are
/// marked as determined.
class Statics {
public:
  explicit Statics(const Run& run);

  /// Takes over the conditions of run.row, all of whose bodies must have rates. `run` must be the one of the
  /// constructor, or a copy. Does not allocate where there are no surplus conditions.
  void set_row(const Run& run);

  /// Solves for the multipliers. `wrenches` (of Mechanism::bodies) is consumed. False where there is no
  /// balance: the conditions are dependent here, to within rounding.
  [[nodiscard]] bool balance(std::vector<Wrench>& wrenches);

  /// Selects the flanks of gear teeth that press in the last balance; true where that changes any, so that
  /// set_row() and balance() have to be repeated. This only changes the forces on bearings, not the torques.
  [[nodiscard]] bool choose_flanks(const Mechanism& mechanism);

  [[nodiscard]] std::size_t row_count() const { return rows_.size(); }

  /// The i-th condition, its multiplier [N], and whether the balance determines it.
  [[nodiscard]] const ConstraintRow& row(std::size_t i) const { return rows_[i]; }
  [[nodiscard]] double multiplier(std::size_t i) const { return multipliers_[i]; }
  [[nodiscard]] double largest_multiplier() const;  ///< largest absolute value of all
  [[nodiscard]] bool is_determined(std::size_t i) const { return determined_[i]; }

  /// First row of the conditions of a joint, contact or driver.
  [[nodiscard]] std::size_t joint_row(std::size_t joint) const { return joint_rows_[joint]; }
  [[nodiscard]] std::size_t contact_row(std::size_t contact) const { return contact_rows_[contact]; }
  [[nodiscard]] std::size_t driver_row(std::size_t driver) const { return driver_rows_[driver]; }

  /// The moment about its pin that holds the i-th of the idle bodies, in the order of the groups, and whether
  /// it is more than rounding against the forces on that body: then the body is not in equilibrium.
  struct Holding {
    int body = 0;
    double moment = 0;  ///< [N m]
    bool matters = false;
  };
  [[nodiscard]] std::size_t holding_count() const { return held_rows_.size(); }
  [[nodiscard]] Holding holding(std::size_t i) const;

  /// The size by which angular conditions are multiplied [m].
  [[nodiscard]] double size() const { return size_; }

private:
  using Matrix6d = Eigen::Matrix<double, 6, 6>;
  template <class Matrix>
  using Factors = Eigen::PartialPivLU<Matrix>;

  // Two bodies between three pins: the moments about the outer pins give the force at the inner one.
  struct PinnedDyad {
    struct Pin {
      std::size_t row = 0;   // its condition along x; the one along y follows
      std::size_t side = 0;  // side of the row that belongs to the dyad's body
    };
    std::array<Pin, 2> outer;  // of the two bodies
    std::array<Pin, 2> inner;
  };

  // The conditions and bodies of a group; a square system of equations, transposed.
  struct Block {
    std::size_t first_row = 0;
    std::size_t row_count = 0;
    std::vector<int> bodies;
    std::variant<Factors<Eigen::Matrix3d>, Factors<Matrix6d>, Factors<Eigen::MatrixXd>, PinnedDyad> factors;
  };

  void append_rows_of(const Run& run, std::size_t g);
  void set_layout(const Run& run);
  void set_columns();
  template <class Matrix>
  void factorise(const Block& block, Factors<Matrix>& factors) const;
  template <class Matrix>
  void solve(const Block& block, const Factors<Matrix>& factors, std::vector<Wrench>& wrenches);
  [[nodiscard]] PinnedDyad pinned_dyad(const Block& block) const;
  void solve(const Block& block, const PinnedDyad& dyad, std::vector<Wrench>& wrenches);
  void factorise_all();
  [[nodiscard]] bool solve_all(const std::vector<Wrench>& wrenches);

  double size_ = 1;
  bool contacts_may_part_ = false;  // if open, their condition is that of the joint that holds their body
  bool redundant_ = false;
  std::vector<std::vector<int>> held_;  // idle bodies of each group
  std::vector<std::size_t> held_rows_;
  std::vector<int> flanks_;  // of Mechanism::joints: which flank of gear teeth carries, ±1
  std::vector<ConstraintRow> rows_;
  std::vector<std::array<int, 3>> columns_;  // for each row and body: column of the body in its block, or -1
  std::vector<double> multipliers_;
  std::vector<bool> determined_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> joint_rows_;
  std::vector<std::size_t> contact_rows_;
  std::vector<std::size_t> driver_rows_;
  Eigen::MatrixXd jacobian_;       // of all bodies, if redundant
  Eigen::MatrixXd pseudoinverse_;  // of jacobian_
};

}  // namespace higherpair

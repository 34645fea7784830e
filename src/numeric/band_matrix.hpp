#pragma once

#include "numeric/lu_solver.hpp"

#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// A square matrix that is 0 farther than `width` from its diagonal. If it is cyclic, indices wrap around,
/// and its corners belong to the band.
class BandMatrix {
public:
  /// Zero matrix. \pre size > 3 width if it is cyclic
  BandMatrix(Eigen::Index size, Eigen::Index width, bool cyclic);

  [[nodiscard]] Eigen::Index size() const { return rows_.cols(); }
  [[nodiscard]] Eigen::Index width() const { return (rows_.rows() - 1) / 2; }
  [[nodiscard]] bool cyclic() const { return cyclic_; }

  /// \pre the place is within the band
  void add(Eigen::Index row, Eigen::Index column, double value);
  /// Element of row `row` within the band, -width <= offset <= width: its column is row + offset.
  [[nodiscard]] double at(Eigen::Index row, Eigen::Index offset) const {
    return rows_(width() + offset, row);
  }

  /// this + factor · other, which must have the same shape.
  [[nodiscard]] BandMatrix plus(double factor, const BandMatrix& other) const;
  [[nodiscard]] Eigen::MatrixXd times(const Eigen::MatrixXd& x) const;

private:
  bool cyclic_;
  Eigen::MatrixXd rows_;  // each column holds the band of one row
};

/// How pivots are chosen: the largest one, or without exchanging rows where A is symmetric and positive
/// definite.
enum class Pivoting { kPartial, kNone };

/// Solves A x = b by elimination within the band; the last `width` rows and columns of a cyclic matrix are
/// treated as a border. Cost grows with size · width².
class BandSolver {
public:
  explicit BandSolver(const BandMatrix& A, Pivoting pivoting = Pivoting::kPartial);

  /// False where a pivot is 0 or not a number: there is no solution then.
  [[nodiscard]] bool is_regular() const { return regular_; }
  /// Any number of right-hand sides, as columns. \pre is_regular()
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;

private:
  void eliminate();
  void turn_upper();
  void solve_inner(Eigen::MatrixXd& x) const;

  Eigen::Index inner_;  // rows without the border
  Eigen::Index width_;
  bool exchanges_;
  Eigen::Index reach_;  // number of diagonals of U above the main one
  bool regular_ = true;
  Eigen::MatrixXd band_;     // each column holds a row of U, from its diagonal on
  Eigen::MatrixXd upper_;    // each column holds a column of U, upwards from the diagonal, without it
  Eigen::VectorXd inverse_;  // of the diagonal
  Eigen::MatrixXd lower_;    // each column holds the factors of one elimination step
  std::vector<Eigen::Index> pivots_;
  Eigen::MatrixXd right_, below_;  // the border's columns, solved for, and its rows
  LuSolver corner_;
};

}  // namespace higherpair

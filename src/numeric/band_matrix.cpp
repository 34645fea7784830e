#include "numeric/band_matrix.hpp"

#include "higherpair/numeric/tolerances.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace higherpair {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

// A column of the band; outside of 0 … size - 1 beyond the ends of a matrix that is not cyclic.
Index column_of(Index index, Index size, bool cyclic) {
  return !cyclic ? index : index < 0 ? index + size : index >= size ? index - size : index;
}

}  // namespace

BandMatrix::BandMatrix(Index size, Index width, bool cyclic)
    : cyclic_(cyclic), rows_(MatrixXd::Zero(2 * width + 1, size)) {
  assert(!cyclic || size > 3 * width);
}

void BandMatrix::add(Index row, Index column, double value) {
  Index offset = column - row;
  if (cyclic_ && std::abs(offset) > width()) {
    offset -= offset > 0 ? size() : -size();
  }
  assert(std::abs(offset) <= width());
  rows_(width() + offset, row) += value;
}

BandMatrix BandMatrix::plus(double factor, const BandMatrix& other) const {
  BandMatrix sum = *this;
  sum.rows_ += factor * other.rows_;
  return sum;
}

MatrixXd BandMatrix::times(const MatrixXd& x) const {
  MatrixXd product = MatrixXd::Zero(size(), x.cols());
  for (Index row = 0; row < size(); ++row) {
    for (Index offset = -width(); offset <= width(); ++offset) {
      const Index column = column_of(row + offset, size(), cyclic_);
      if (column >= 0 && column < size()) {
        product.row(row) += at(row, offset) * x.row(column);
      }
    }
  }
  return product;
}

BandSolver::BandSolver(const BandMatrix& A, Pivoting pivoting)
    : inner_(A.size() - (A.cyclic() ? A.width() : 0)),
      width_(A.width()),
      exchanges_(pivoting == Pivoting::kPartial),
      reach_(exchanges_ ? 2 * width_ : width_),
      band_(MatrixXd::Zero(2 * width_ + 1, inner_)),
      lower_(MatrixXd::Zero(width_, inner_)) {
  const Index border = A.size() - inner_;
  right_ = MatrixXd::Zero(inner_, border);
  below_ = MatrixXd::Zero(border, inner_);
  MatrixXd corner = MatrixXd::Zero(border, border);
  for (Index row = 0; row < A.size(); ++row) {
    for (Index offset = -width_; offset <= width_; ++offset) {
      const double value = A.at(row, offset);
      const Index column = column_of(row + offset, A.size(), A.cyclic());
      if (value == 0 || column < 0 || column >= A.size()) {
        continue;
      }
      if (row < inner_ && column < inner_) {
        // The stored row begins at its first entry; elimination shifts it to the diagonal.
        band_(column - std::max<Index>(0, row - width_), row) = value;
      } else {
        (row < inner_      ? right_(row, column - inner_)
         : column < inner_ ? below_(row - inner_, column)
                           : corner(row - inner_, column - inner_)) = value;
      }
    }
  }
  eliminate();
  if (!regular_) {
    return;
  }
  turn_upper();
  if (border > 0) {
    solve_inner(right_);
    corner_.compute(corner - below_ * right_);
    const Eigen::VectorXd pivots = corner_.pivots();
    regular_ = pivots.allFinite() && pivots.cwiseAbs().minCoeff() > 0;
  }
}

void BandSolver::eliminate() {
  pivots_.resize(static_cast<std::size_t>(inner_));
  const Index length = reach_ + 1;
  for (Index k = 0; k < inner_; ++k) {
    // At this point rows k to k + width begin at column k.
    const Index last = std::min(k + width_, inner_ - 1);
    Index pivot = k;
    for (Index row = k + 1; exchanges_ && row <= last; ++row) {
      pivot = std::abs(band_(0, row)) > std::abs(band_(0, pivot)) ? row : pivot;
    }
    pivots_[k] = pivot;
    if (!(std::abs(band_(0, pivot)) > 0) || !std::isfinite(band_(0, pivot))) {
      regular_ = false;
      return;
    }
    if (pivot != k) {
      band_.col(k).swap(band_.col(pivot));
    }
    const double* own = &band_(0, k);
    for (Index row = k + 1; row <= last; ++row) {
      double* other = &band_(0, row);
      const double factor = other[0] / own[0];
      lower_(row - k - 1, k) = factor;
      for (Index j = 1; j < length; ++j) {
        other[j - 1] = other[j] - factor * own[j];
      }
      for (Index j = length; j < band_.rows(); ++j) {
        other[j - 1] = other[j];
      }
      other[band_.rows() - 1] = 0;
    }
  }
}

// Stores U by columns, as back substitution needs it.
void BandSolver::turn_upper() {
  upper_ = MatrixXd::Zero(reach_, inner_);
  for (Index row = 0; row < inner_; ++row) {
    for (Index j = 1; j <= std::min(reach_, inner_ - 1 - row); ++j) {
      upper_(j - 1, row + j) = band_(j, row);
    }
  }
  inverse_ = band_.row(0).cwiseInverse();
}

void BandSolver::solve_inner(MatrixXd& x) const {
  for (Index column = 0; column < x.cols(); ++column) {
    double* b = x.col(column).data();
    for (Index k = 0; k < inner_; ++k) {
      std::swap(b[k], b[pivots_[k]]);
      if (std::abs(b[k]) < kBandNothing) {
        b[k] = 0;
        continue;
      }
      const Index count = std::min(width_, inner_ - 1 - k);
      for (Index i = 0; i < count; ++i) {
        b[k + 1 + i] -= lower_(i, k) * b[k];
      }
    }
    for (Index k = inner_; k-- > 0;) {
      b[k] *= inverse_[k];
      if (std::abs(b[k]) < kBandNothing) {
        b[k] = 0;
        continue;
      }
      const Index count = std::min(reach_, k);
      const double* above = &upper_(0, k);
      for (Index j = 0; j < count; ++j) {
        b[k - 1 - j] -= above[j] * b[k];
      }
    }
  }
}

MatrixXd BandSolver::solve(const MatrixXd& b) const {
  assert(regular_);
  MatrixXd x = b.topRows(inner_);
  solve_inner(x);
  const Index border = right_.cols();
  if (border == 0) {
    return x;
  }
  const MatrixXd end = corner_.solve(b.bottomRows(border) - below_ * x);
  MatrixXd all(b.rows(), b.cols());
  all << x - right_ * end, end;
  return all;
}

}  // namespace higherpair

#pragma once

#include "numeric/band_matrix.hpp"
#include "numeric/spline.hpp"

#include <array>
#include <utility>
#include <vector>

#include <Eigen/Core>

// B-splines over the knots of a SplineTask, and conditions that are linear in their coefficients.

namespace higherpair::spline_basis {

using Eigen::Index;

inline constexpr int kHighest = 5;  // largest degree
using Polynomial = std::array<double, kHighest + 1>;

/// The B-splines that do not vanish on an interval; surplus entries are 0.
using Splines = std::array<Polynomial, kHighest + 1>;

/// B-splines over knots at the points, in units in which the points are 1 apart on average.
class Basis {
public:
  explicit Basis(const SplineTask& task);

  [[nodiscard]] Index intervals() const { return periodic_ ? points_ : points_ - 1; }
  [[nodiscard]] Index size() const { return periodic_ ? points_ : points_ + degree_ - 1; }
  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] bool periodic() const { return periodic_; }
  [[nodiscard]] Index points() const { return points_; }
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] double length(Index interval) const { return at(interval + 1) - at(interval); }

  /// The coefficient of the j-th B-spline of an interval.
  [[nodiscard]] Index index(Index interval, int j) const {
    const Index index = interval + j;
    return index < size() ? index : index % size();
  }

  /// The degree + 1 B-splines that do not vanish on an interval, as powers of t from its beginning; the j-th
  /// belongs to the coefficient index(interval, j).
  [[nodiscard]] const Splines& on(Index interval) const { return splines_[interval]; }

private:
  [[nodiscard]] double at(Index i) const { return knots_[i + degree_]; }
  [[nodiscard]] double knot(const SplineTask& task, int i) const;

  int degree_;
  bool periodic_;
  Index points_;
  double unit_ = 1;
  std::vector<double> knots_;  // starts at index -degree
  std::vector<Splines> splines_;
};

/// A zero matrix for conditions each of which reaches `width` coefficients to either side: banded, but full
/// for so few points that a condition may reach around more than once.
[[nodiscard]] BandMatrix conditions(const Basis& basis, Index width);

/// The contributions of an interval's coefficients to one number.
using Weights = std::array<double, kHighest + 1>;

/// The k-th derivative, over k!, at distance t from the beginning of an interval.
[[nodiscard]] Weights derivative_at(const Basis& basis, Index interval, int k, double t);

/// The k-th derivative, over k!, at a point: an interval that contains it, and the weights there.
[[nodiscard]] std::pair<Index, Weights> derivative_at_point(const Basis& basis, Index point, int k);

/// Numbers that depend linearly on the coefficients of one interval each: the rows of a matrix.
class LocalRows {
public:
  explicit LocalRows(const Basis& basis) : basis_(basis) {}

  void add(Index interval, const Weights& weights) { rows_.push_back({interval, weights}); }

  /// The numbers for the given coefficients, one set per column.
  [[nodiscard]] Eigen::MatrixXd times(const Eigen::MatrixXd& coefficients) const;
  [[nodiscard]] Eigen::MatrixXd transpose_times(const Eigen::MatrixXd& numbers) const;
  /// The matrix of the quadratic form that is the sum of their squares.
  [[nodiscard]] BandMatrix normal_matrix() const;

private:
  template <class F>
  void for_each(const F& f) const;

  struct Row {
    Index interval;
    Weights weights;
  };
  const Basis& basis_;
  std::vector<Row> rows_;
};

}  // namespace higherpair::spline_basis

#include "numeric/spline_basis.hpp"

#include "numeric/b_splines.hpp"

#include <algorithm>

namespace higherpair::spline_basis {
namespace {

using Eigen::MatrixXd;

// The value of a polynomial's k-th derivative at t, over k!.
double taylor(const Polynomial& p, int k, double t) {
  double sum = 0;
  for (int i = kHighest; i >= k; --i) {
    double choose = 1;
    for (int j = 1; j <= k; ++j) {
      choose = choose * (i - k + j) / j;
    }
    sum = sum * t + choose * p[i];
  }
  return sum;
}

}  // namespace

Basis::Basis(const SplineTask& task)
    : degree_(task.degree), periodic_(task.period > 0), points_(static_cast<Index>(task.x.size())) {
  const auto n = task.x.size();
  unit_ = periodic_ ? task.period / static_cast<double>(n)
                    : (task.x.back() - task.x.front()) / static_cast<double>(n - 1);
  for (int i = -degree_; i <= static_cast<int>(intervals()) + degree_; ++i) {
    knots_.push_back(knot(task, i));
  }
  for (Index i = 0; i < intervals(); ++i) {
    splines_.push_back(b_splines_between<kHighest + 1>(knots_, static_cast<std::size_t>(degree_),
                                                       static_cast<std::size_t>(i + degree_)));
  }
}

double Basis::knot(const SplineTask& task, int i) const {
  const auto n = static_cast<int>(task.x.size());
  const double first = task.x.front();
  const auto point = [&](int k) { return (task.x[k] - first) / unit_; };
  if (periodic_) {
    const int turns = i >= 0 ? i / n : -((n - 1 - i) / n);
    return point(i - turns * n) + turns * static_cast<double>(n);
  }
  // Beyond the ends the intervals are as long as the outermost inner ones.
  return i < 0    ? i * point(1)
         : i >= n ? point(n - 1) + (i - n + 1) * (point(n - 1) - point(n - 2))
                  : point(i);
}

BandMatrix conditions(const Basis& basis, Index width) {
  const bool few = basis.size() <= 3 * width;
  return {basis.size(), few ? basis.size() - 1 : width, basis.periodic() && !few};
}

Weights derivative_at(const Basis& basis, Index interval, int k, double t) {
  Weights weights{};
  for (std::size_t j = 0; j < weights.size(); ++j) {
    weights[j] = taylor(basis.on(interval)[j], k, t);
  }
  return weights;
}

std::pair<Index, Weights> derivative_at_point(const Basis& basis, Index point, int k) {
  const Index interval = std::min(point, basis.intervals() - 1);
  return {interval, derivative_at(basis, interval, k, point == interval ? 0 : basis.length(interval))};
}

template <class F>
void LocalRows::for_each(const F& f) const {
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    for (int j = 0; j <= basis_.degree(); ++j) {
      f(static_cast<Index>(row), basis_.index(rows_[row].interval, j), rows_[row].weights[j]);
    }
  }
}

MatrixXd LocalRows::times(const MatrixXd& coefficients) const {
  MatrixXd numbers = MatrixXd::Zero(static_cast<Index>(rows_.size()), coefficients.cols());
  for (Index k = 0; k < coefficients.cols(); ++k) {
    const double* from = coefficients.col(k).data();
    double* to = numbers.col(k).data();
    for_each([&](Index row, Index index, double weight) { to[row] += weight * from[index]; });
  }
  return numbers;
}

MatrixXd LocalRows::transpose_times(const MatrixXd& numbers) const {
  MatrixXd coefficients = MatrixXd::Zero(basis_.size(), numbers.cols());
  for (Index k = 0; k < numbers.cols(); ++k) {
    const double* from = numbers.col(k).data();
    double* to = coefficients.col(k).data();
    for_each([&](Index row, Index index, double weight) { to[index] += weight * from[row]; });
  }
  return coefficients;
}

BandMatrix LocalRows::normal_matrix() const {
  BandMatrix normal = conditions(basis_, basis_.degree());
  for (const auto& [interval, weights] : rows_) {
    for (int i = 0; i <= basis_.degree(); ++i) {
      for (int j = 0; j <= basis_.degree(); ++j) {
        normal.add(basis_.index(interval, i), basis_.index(interval, j), weights[i] * weights[j]);
      }
    }
  }
  return normal;
}

}  // namespace higherpair::spline_basis

#include "numeric/spline.hpp"

#include "numeric/band_matrix.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>

namespace higherpair {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
constexpr int kHighest = 5;
using Polynomial = std::array<double, kHighest + 1>;
using Splines = std::array<Polynomial, kHighest + 1>;

// Weights on smoothness in units in which the points are 1 apart, as powers of ten: from a spline that goes
// through all points, to within rounding, to a polynomial.
constexpr double kLightest = -10;
constexpr double kHeaviest = 16;
constexpr std::uintmax_t kMostTrials = 40;
constexpr int kBitsOfWeight = 20;  // of the power of ten

// B-splines over knots at the points, in units in which the points are 1 apart on average.
class Basis {
public:
  explicit Basis(const SplineTask& task)
      : degree_(task.degree), periodic_(task.period > 0), points_(static_cast<Index>(task.x.size())) {
    const auto n = task.x.size();
    unit_ = periodic_ ? task.period / static_cast<double>(n)
                      : (task.x.back() - task.x.front()) / static_cast<double>(n - 1);
    for (int i = -degree_; i <= static_cast<int>(intervals()) + degree_; ++i) {
      knots_.push_back(knot(task, i));
    }
    for (Index i = 0; i < intervals(); ++i) {
      splines_.push_back(splines_on(i));
    }
  }

  [[nodiscard]] Index intervals() const { return periodic_ ? points_ : points_ - 1; }
  [[nodiscard]] Index size() const { return periodic_ ? points_ : points_ + degree_ - 1; }
  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] bool periodic() const { return periodic_; }
  [[nodiscard]] Index points() const { return points_; }
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] double length(Index interval) const { return at(interval + 1) - at(interval); }
  [[nodiscard]] Index index(Index interval, int j) const {
    const Index index = interval + j;
    return index < size() ? index : index % size();
  }

  // The degree + 1 B-splines that do not vanish on an interval, as powers of t from its begin; the j-th
  // belongs to the coefficient index(interval, j).
  [[nodiscard]] const Splines& on(Index interval) const {
    return splines_[static_cast<std::size_t>(interval)];
  }

private:
  // Cox and de Boor's recursion.
  [[nodiscard]] Splines splines_on(Index interval) const {
    Splines b{};
    b[static_cast<std::size_t>(degree_)][0] = 1;
    const double origin = at(interval);
    for (int k = 1; k <= degree_; ++k) {
      for (int j = degree_ - k; j <= degree_; ++j) {
        const Index i = interval - degree_ + j;
        const auto own = static_cast<std::size_t>(j);
        Polynomial sum{};
        if (j > degree_ - k) {
          const double width = at(i + k) - at(i);
          add(sum, b[own], (origin - at(i)) / width, 1 / width);
        }
        if (j < degree_) {
          const double width = at(i + k + 1) - at(i + 1);
          add(sum, b[own + 1], (at(i + k + 1) - origin) / width, -1 / width);
        }
        b[own] = sum;
      }
    }
    return b;
  }

  static void add(Polynomial& sum, const Polynomial& p, double constant, double slope) {
    for (std::size_t k = 0; k < p.size(); ++k) {
      sum[k] += constant * p[k] + (k > 0 ? slope * p[k - 1] : 0);
    }
  }

  [[nodiscard]] double at(Index i) const { return knots_[static_cast<std::size_t>(i + degree_)]; }

  [[nodiscard]] double knot(const SplineTask& task, int i) const {
    const auto n = static_cast<int>(task.x.size());
    const double first = task.x.front();
    const auto point = [&](int k) { return (task.x[static_cast<std::size_t>(k)] - first) / unit_; };
    if (periodic_) {
      const int turns = i >= 0 ? i / n : -((n - 1 - i) / n);
      return point(i - turns * n) + turns * static_cast<double>(n);
    }
    // Beyond the ends the intervals are as long as the outermost ones.
    return i < 0    ? i * point(1)
           : i >= n ? point(n - 1) + (i - n + 1) * (point(n - 1) - point(n - 2))
                    : point(i);
  }

  int degree_;
  bool periodic_;
  Index points_;
  double unit_ = 1;
  std::vector<double> knots_;  // from -degree
  std::vector<Splines> splines_;
};

// x⁰ to the highest power that a spline has.
Polynomial powers_of(double x) {
  Polynomial powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) {
    powers[k] = powers[k - 1] * x;
  }
  return powers;
}

// The value of a polynomial's k-th derivative at t, over k!.
double taylor(const Polynomial& p, int k, double t) {
  double sum = 0;
  for (int i = kHighest; i >= k; --i) {
    double choose = 1;
    for (int j = 1; j <= k; ++j) {
      choose = choose * (i - k + j) / j;
    }
    sum = sum * t + choose * p[static_cast<std::size_t>(i)];
  }
  return sum;
}

// The conditions of the splines are banded; those of a few points may go round more than once.
BandMatrix conditions(const Basis& basis, Index width) {
  const bool few = basis.size() <= 3 * width;
  return {basis.size(), few ? basis.size() - 1 : width, basis.periodic() && !few};
}

// What the coefficients of an interval contribute to one number.
using Weights = std::array<double, kHighest + 1>;

// The k-th derivative, over k!, at a place of an interval.
Weights derivative_at(const Basis& basis, Index interval, int k, double t) {
  Weights weights{};
  for (std::size_t j = 0; j < weights.size(); ++j) {
    weights[j] = taylor(basis.on(interval)[j], k, t);
  }
  return weights;
}

// Numbers that depend linearly on the coefficients of one interval each.
class LocalRows {
public:
  explicit LocalRows(const Basis& basis) : basis_(basis) {}

  void add(Index interval, const Weights& weights) { rows_.push_back({interval, weights}); }

  [[nodiscard]] MatrixXd times(const MatrixXd& coefficients) const {
    MatrixXd numbers = MatrixXd::Zero(static_cast<Index>(rows_.size()), coefficients.cols());
    for (Index k = 0; k < coefficients.cols(); ++k) {
      const double* from = coefficients.col(k).data();
      double* to = numbers.col(k).data();
      for_each([&](Index row, Index index, double weight) { to[row] += weight * from[index]; });
    }
    return numbers;
  }
  [[nodiscard]] MatrixXd transpose_times(const MatrixXd& numbers) const {
    MatrixXd coefficients = MatrixXd::Zero(basis_.size(), numbers.cols());
    for (Index k = 0; k < numbers.cols(); ++k) {
      const double* from = numbers.col(k).data();
      double* to = coefficients.col(k).data();
      for_each([&](Index row, Index index, double weight) { to[index] += weight * from[row]; });
    }
    return coefficients;
  }
  // Of the sum of their squares.
  [[nodiscard]] BandMatrix normal_matrix() const {
    BandMatrix normal = conditions(basis_, basis_.degree());
    for (const auto& [interval, weights] : rows_) {
      for (int i = 0; i <= basis_.degree(); ++i) {
        for (int j = 0; j <= basis_.degree(); ++j) {
          normal.add(basis_.index(interval, i), basis_.index(interval, j),
                     weights[static_cast<std::size_t>(i)] * weights[static_cast<std::size_t>(j)]);
        }
      }
    }
    return normal;
  }

private:
  template <class F>
  void for_each(const F& f) const {
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (int j = 0; j <= basis_.degree(); ++j) {
        f(static_cast<Index>(row), basis_.index(rows_[row].interval, j),
          rows_[row].weights[static_cast<std::size_t>(j)]);
      }
    }
  }

  struct Row {
    Index interval;
    Weights weights;
  };
  const Basis& basis_;
  std::vector<Row> rows_;
};

// The k-th derivative, over k!, at the i-th point.
std::pair<Index, Weights> derivative_at_point(const Basis& basis, Index point, int k) {
  const Index interval = std::min(point, basis.intervals() - 1);
  return {interval, derivative_at(basis, interval, k, point == interval ? 0 : basis.length(interval))};
}

class Interpolation {
public:
  Interpolation(const Basis& basis, const SplineTask& task)
      : basis_(basis),
        task_(task),
        system_(conditions(basis, basis.degree() + 1)),
        right_(MatrixXd::Zero(basis.size(), task.values.cols())) {}

  [[nodiscard]] MatrixXd solve() {
    // The conditions at the begin come first: the matrix is banded.
    const Index before = basis_.periodic() ? 0 : (basis_.degree() - 1) / 2;
    for (Index i = 0; i < basis_.points(); ++i) {
      add(before + i, derivative_at_point(basis_, i, 0));
      right_.row(before + i) = task_.values.row(i);
    }
    for (Index k = 0; k < before; ++k) {
      const bool outermost = k + 1 == before;
      add_end(k, 0, k, outermost ? task_.first_slope : Eigen::RowVectorXd());
      add_end(basis_.size() - 1 - k, basis_.points() - 1, k,
              outermost ? task_.last_slope : Eigen::RowVectorXd());
    }
    const BandSolver solver(system_);
    if (!solver.is_regular()) {  // numbers have left their range
      return MatrixXd::Constant(right_.rows(), right_.cols(), std::numeric_limits<double>::quiet_NaN());
    }
    MatrixXd solution = solver.solve(right_);
    solution += solver.solve(right_ - system_.times(solution));
    MatrixXd coefficients(solution.rows(), solution.cols());
    for (Index i = 0; i < basis_.size(); ++i) {
      coefficients.row(i) = solution.row(turned(i));
    }
    return coefficients;
  }

private:
  // Of a period the spline that is largest at a point is on the diagonal.
  [[nodiscard]] Index turned(Index index) const {
    return basis_.periodic() ? (index + basis_.size() * basis_.degree() - basis_.degree() / 2) % basis_.size()
                             : index;
  }

  void add(Index row, const std::pair<Index, Weights>& condition, double factor = 1) {
    const auto& [interval, weights] = condition;
    for (int j = 0; j <= basis_.degree(); ++j) {
      system_.add(row, turned(basis_.index(interval, j)), factor * weights[static_cast<std::size_t>(j)]);
    }
  }

  // A condition beside the points at an end: a slope, that there is no knot at a point within, or a
  // derivative 0.
  void add_end(Index row, Index point, Index k, const Eigen::RowVectorXd& slope) {
    if (slope.size() > 0) {
      add(row, derivative_at_point(basis_, point, 1));
      right_.row(row) = basis_.unit() * slope;
    } else if (task_.no_end_knots) {
      const Index within = point == 0 ? k + 1 : point - k - 1;
      add(row, {within - 1, derivative_at(basis_, within - 1, basis_.degree(), 0)}, -1);
      add(row, {within, derivative_at(basis_, within, basis_.degree(), 0)});
    } else {
      add(row, derivative_at_point(basis_, point, (basis_.degree() + 1) / 2 + static_cast<int>(k)));
    }
  }

  const Basis& basis_;
  const SplineTask& task_;
  BandMatrix system_;
  MatrixXd right_;
};

LocalRows values_at_points(const Basis& basis) {
  LocalRows rows(basis);
  for (Index i = 0; i < basis.points(); ++i) {
    const auto [interval, weights] = derivative_at_point(basis, i, 0);
    rows.add(interval, weights);
  }
  return rows;
}

// Rows with Σ (row · c)² = ∫ |s^(m)|² for a spline with coefficients c: its m-th derivative, of degree m - 1,
// at the m points of Gauss' rule in every interval, times the roots of their weights.
LocalRows bending(const Basis& basis) {
  struct Rule {
    std::array<double, 3> place, weight;
  };
  constexpr Rule kTwo{{-0.57735026918962576, 0.57735026918962576, 0}, {1, 1, 0}};
  constexpr Rule kThree{{-0.77459666924148338, 0, 0.77459666924148338}, {5.0 / 9, 8.0 / 9, 5.0 / 9}};
  const int m = (basis.degree() + 1) / 2;
  const Rule& rule = m == 2 ? kTwo : kThree;
  const double factorial = m == 2 ? 2 : 6;
  LocalRows rows(basis);
  for (Index interval = 0; interval < basis.intervals(); ++interval) {
    const double half = basis.length(interval) / 2;
    for (std::size_t g = 0; g < static_cast<std::size_t>(m); ++g) {
      Weights weights = derivative_at(basis, interval, m, half * (1 + rule.place[g]));
      for (double& weight : weights) {
        weight *= factorial * std::sqrt(rule.weight[g] * half);
      }
      rows.add(interval, weights);
    }
  }
  return rows;
}

MatrixXd smoothed(const Basis& basis, const SplineTask& task) {
  const MatrixXd& values = task.values;
  const LocalRows at_points = values_at_points(basis);
  const LocalRows bends = bending(basis);
  const BandMatrix near_points = at_points.normal_matrix();
  const BandMatrix rough = bends.normal_matrix();
  const MatrixXd right = at_points.transpose_times(values);
  std::optional<MatrixXd> best;
  double heaviest = kLightest;  // of those that hold
  // The logarithm of how much of the tolerance a weight takes: it grows with the weight.
  const auto share = [&](double exponent) {
    const double weight = std::pow(10.0, exponent);
    const BandSolver solver(near_points.plus(weight, rough), Pivoting::kNone);
    if (!solver.is_regular()) {
      return kHeaviest;
    }
    // With a heavy weight the condition number is large: what remains of the conditions themselves restores
    // the digits.
    MatrixXd solution = solver.solve(right);
    solution += solver.solve(at_points.transpose_times(values - at_points.times(solution)) -
                             weight * bends.transpose_times(bends.times(solution)));
    const double left = (at_points.times(solution) - values).rowwise().norm().maxCoeff();
    if (left <= task.smoothing && (!best || exponent > heaviest)) {
      heaviest = exponent;
      best = std::move(solution);
    }
    return left > 0 ? std::log(left / task.smoothing) : kLightest;
  };
  const double low = share(kLightest);
  const double high = share(kHeaviest);
  if (low < 0 && high > 0) {
    std::uintmax_t trials = kMostTrials;
    boost::math::tools::toms748_solve(share, kLightest, kHeaviest, low, high,
                                      boost::math::tools::eps_tolerance<double>(kBitsOfWeight), trials);
  }
  return best ? *std::move(best) : Interpolation(basis, task).solve();
}

}  // namespace

MatrixXd spline_powers(const SplineTask& task) {
  assert((task.degree == 3 || task.degree == 5) && task.x.size() >= 3);
  const Basis basis(task);
  const MatrixXd coefficients =
      task.smoothing > 0 ? smoothed(basis, task) : Interpolation(basis, task).solve();
  const Index terms = task.degree + 1;
  MatrixXd powers = MatrixXd::Zero(basis.intervals() * terms, task.values.cols());
  const Polynomial per_unit = powers_of(1 / basis.unit());
  for (Index column = 0; column < coefficients.cols(); ++column) {
    for (Index interval = 0; interval < basis.intervals(); ++interval) {
      Polynomial sum{};
      for (int j = 0; j <= task.degree; ++j) {
        const Polynomial& own = basis.on(interval)[static_cast<std::size_t>(j)];
        const double coefficient = coefficients(basis.index(interval, j), column);
        for (std::size_t k = 0; k < sum.size(); ++k) {
          sum[k] += own[k] * coefficient;
        }
      }
      for (Index k = 0; k < terms; ++k) {
        const auto power = static_cast<std::size_t>(k);
        powers(interval * terms + k, column) = sum[power] * per_unit[power];
      }
    }
  }
  return powers;
}

}  // namespace higherpair

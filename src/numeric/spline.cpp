#include "numeric/spline.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <boost/math/tools/toms748_solve.hpp>

namespace higherpair {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr int kHighest = 5;
using Polynomial = std::array<double, kHighest + 1>;

// Weights on smoothness in units in which the points are 1 apart, as powers of ten: from a spline that goes
// through all points, to within rounding, to a polynomial.
constexpr double kLightest = -10;
constexpr double kHeaviest = 16;
constexpr std::uintmax_t kMostTrials = 40;
constexpr int kBitsOfWeight = 28;  // of the power of ten

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
  }

  [[nodiscard]] Index intervals() const { return periodic_ ? points_ : points_ - 1; }
  [[nodiscard]] Index size() const { return periodic_ ? points_ : points_ + degree_ - 1; }
  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] bool periodic() const { return periodic_; }
  [[nodiscard]] Index points() const { return points_; }
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] double length(Index interval) const { return at(interval + 1) - at(interval); }
  [[nodiscard]] Index index(Index interval, int j) const { return (interval + j) % size(); }

  // The degree + 1 B-splines that do not vanish on an interval, as powers of t from its begin; the j-th
  // belongs to the coefficient index(interval, j). Cox and de Boor's recursion.
  [[nodiscard]] std::array<Polynomial, kHighest + 1> on(Index interval) const {
    std::array<Polynomial, kHighest + 1> b{};
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

private:
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

Sparse matrix(Index rows, Index columns, const Triplets& triplets) {
  Sparse m(rows, columns);
  m.setFromTriplets(triplets.begin(), triplets.end());
  return m;
}

// Row `row`: the k-th derivative, over k!, at the i-th point.
void add_row(const Basis& basis, Index row, Index point, int k, Triplets& triplets) {
  const Index interval = std::min(point, basis.intervals() - 1);
  const double t = point == interval ? 0 : basis.length(interval);
  const auto b = basis.on(interval);
  for (int j = 0; j <= basis.degree(); ++j) {
    triplets.emplace_back(row, basis.index(interval, j), taylor(b[static_cast<std::size_t>(j)], k, t));
  }
}

Sparse values_at_points(const Basis& basis) {
  Triplets triplets;
  for (Index i = 0; i < basis.points(); ++i) {
    add_row(basis, i, i, 0, triplets);
  }
  return matrix(basis.points(), basis.size(), triplets);
}

// Row `row`: the jump of the last derivative at a point within.
void add_jump(const Basis& basis, Index row, Index point, Triplets& triplets) {
  const auto before = basis.on(point - 1);
  const auto after = basis.on(point);
  const auto last = static_cast<std::size_t>(basis.degree());
  for (int j = 0; j <= basis.degree(); ++j) {
    triplets.emplace_back(row, basis.index(point - 1, j), -before[static_cast<std::size_t>(j)][last]);
    triplets.emplace_back(row, basis.index(point, j), after[static_cast<std::size_t>(j)][last]);
  }
}

MatrixXd interpolation(const Basis& basis, const SplineTask& task) {
  const MatrixXd& values = task.values;
  Triplets triplets;
  MatrixXd right = MatrixXd::Zero(basis.size(), values.cols());
  // The conditions at the begin come first: the matrix is banded.
  const Index before = basis.periodic() ? 0 : (basis.degree() - 1) / 2;
  for (Index i = 0; i < basis.points(); ++i) {
    add_row(basis, before + i, i, 0, triplets);
    right.row(before + i) = values.row(i);
  }
  const auto end_condition = [&](Index row, Index point, Index k, const Eigen::RowVectorXd& slope) {
    const bool is_slope = k + 1 == before && slope.size() > 0;
    if (is_slope) {
      add_row(basis, row, point, 1, triplets);
      right.row(row) = basis.unit() * slope;
    } else if (task.no_end_knots) {
      add_jump(basis, row, point == 0 ? k + 1 : point - k - 1, triplets);
    } else {
      add_row(basis, row, point, (basis.degree() + 1) / 2 + static_cast<int>(k), triplets);
    }
  };
  for (Index k = 0; k < before; ++k) {
    end_condition(k, 0, k, task.first_slope);
    end_condition(before + basis.points() + k, basis.points() - 1, k, task.last_slope);
  }
  const Sparse system = matrix(basis.size(), basis.size(), triplets);
  Eigen::SparseLU<Sparse> lu(system);
  MatrixXd solution = lu.solve(right);
  solution += lu.solve(right - system * solution);
  return solution;
}

// ∫ B_i^(m) B_j^(m)
Sparse roughness(const Basis& basis) {
  const int m = (basis.degree() + 1) / 2;
  Triplets triplets;
  for (Index interval = 0; interval < basis.intervals(); ++interval) {
    const auto b = basis.on(interval);
    const auto h = powers_of(basis.length(interval));
    for (int i = 0; i <= basis.degree(); ++i) {
      for (int j = 0; j <= basis.degree(); ++j) {
        double integral = 0;
        for (int k = m; k <= basis.degree(); ++k) {
          for (int l = m; l <= basis.degree(); ++l) {
            double factor = 1;
            for (int f = 0; f < m; ++f) {
              factor *= (k - f) * (l - f);
            }
            const int power = k + l - 2 * m + 1;
            integral += factor * b[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] *
                        b[static_cast<std::size_t>(j)][static_cast<std::size_t>(l)] *
                        h[static_cast<std::size_t>(power)] / power;
          }
        }
        triplets.emplace_back(basis.index(interval, i), basis.index(interval, j), integral);
      }
    }
  }
  return matrix(basis.size(), basis.size(), triplets);
}

MatrixXd smoothed(const Basis& basis, const SplineTask& task) {
  const MatrixXd& values = task.values;
  const Sparse at_points = values_at_points(basis);
  const Sparse normal = at_points.transpose() * at_points;
  // Both parts with the entries of both, so that their sum takes the numbers alone.
  const Sparse rough = roughness(basis) + 0 * normal;
  const Sparse near_points = normal + 0 * rough;
  Sparse sum = near_points;
  const MatrixXd right = at_points.transpose() * values;
  Eigen::SimplicialLDLT<Sparse> solver;
  solver.analyzePattern(sum);
  MatrixXd best = interpolation(basis, task);
  double heaviest = kLightest;  // of those that hold
  // The logarithm of how much of the tolerance a weight takes: it grows with the weight.
  const auto share = [&](double exponent) {
    sum.coeffs() = near_points.coeffs() + std::pow(10.0, exponent) * rough.coeffs();
    solver.factorize(sum);
    if (solver.info() != Eigen::Success) {
      return kHeaviest;
    }
    MatrixXd solution = solver.solve(right);
    const double left = (at_points * solution - values).rowwise().norm().maxCoeff();
    if (left <= task.smoothing && exponent > heaviest) {
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
  return best;
}

}  // namespace

MatrixXd spline_powers(const SplineTask& task) {
  assert((task.degree == 3 || task.degree == 5) && task.x.size() >= 3);
  const Basis basis(task);
  const MatrixXd coefficients = task.smoothing > 0 ? smoothed(basis, task) : interpolation(basis, task);
  const Index terms = task.degree + 1;
  MatrixXd powers = MatrixXd::Zero(basis.intervals() * terms, task.values.cols());
  const Polynomial per_unit = powers_of(1 / basis.unit());
  for (Index interval = 0; interval < basis.intervals(); ++interval) {
    const auto b = basis.on(interval);
    for (int j = 0; j <= task.degree; ++j) {
      for (Index k = 0; k < terms; ++k) {
        powers.row(interval * terms + k) += b[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] *
                                            per_unit[static_cast<std::size_t>(k)] *
                                            coefficients.row(basis.index(interval, j));
      }
    }
  }
  return powers;
}

}  // namespace higherpair

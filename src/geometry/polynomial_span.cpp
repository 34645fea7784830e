#include "polynomial_span.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

using Derivatives = std::array<Vector2d, 4>;  // 0th to 3rd, by the parameter

// Cells of equal length, each with the interval that it begins in: so the interval of a parameter is found
// without a search. A few cells an interval, so that hardly any has more than one break in it.
class Intervals {
public:
  explicit Intervals(std::vector<double> breaks) : breaks_(std::move(breaks)) {
    constexpr std::size_t kCells = 2;
    const std::size_t cells = kCells * (breaks_.size() - 1);
    const double width = (breaks_.back() - breaks_.front()) / static_cast<double>(cells);
    per_cell_ = 1 / width;
    last_ = static_cast<double>(cells - 1);
    std::uint32_t interval = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      while (interval + 2 < breaks_.size() &&
             breaks_[interval + 1] <= breaks_.front() + static_cast<double>(cell) * width) {
        ++interval;
      }
      first_.push_back(interval);
    }
  }

  [[nodiscard]] Bounds range() const { return {breaks_.front(), breaks_.back()}; }
  [[nodiscard]] std::size_t count() const { return breaks_.size() - 1; }
  [[nodiscard]] double begin(std::size_t interval) const { return breaks_[interval]; }

  [[nodiscard]] std::size_t at(double t) const {
    const double cell = std::clamp((t - breaks_.front()) * per_cell_, 0.0, last_);
    std::size_t interval = first_[static_cast<std::size_t>(cell)];
    while (interval + 2 < breaks_.size() && t >= breaks_[interval + 1]) {
      ++interval;
    }
    // The rounding of `cell` may have put a parameter just before a break behind it.
    return interval > 0 && t < breaks_[interval] ? interval - 1 : interval;
  }

private:
  std::vector<double> breaks_;
  std::vector<std::uint32_t> first_;
  double per_cell_ = 1;
  double last_ = 0;
};

// κ = p′ × p″ / v³ with v = |p′|, and by differentiation
//   dκ/ds = (p′ × p‴ / v³ - 3 κ p′·p″ / v²) / v.
SpanPoint point_of(const Derivatives& d) {
  const double square = d[1].squaredNorm();
  const double speed = std::sqrt(square);
  const double inverse = 1 / speed;
  const double cube = inverse * inverse * inverse;
  const double kappa = cross(d[1], d[2]) * cube;
  const double slope =
      (cross(d[1], d[3]) * cube - 3 * kappa * d[1].dot(d[2]) * (inverse * inverse)) * inverse;
  return {d[0], vector_of(d[1].y() * inverse, -d[1].x() * inverse), kappa, slope, speed};
}

// Value and Taylor coefficients up to the 3rd of a polynomial, its highest power first, by Horner's scheme.
template <class T>
std::array<T, 4> taylor(const T* coefficients, int degree, double t) {
  std::array<T, 4> d = {coefficients[0], T(0 * coefficients[0]), T(0 * coefficients[0]),
                        T(0 * coefficients[0])};
  for (int k = 1; k <= degree; ++k) {
    d[3] = d[3] * t + d[2];
    d[2] = d[2] * t + d[1];
    d[1] = d[1] * t + d[0];
    d[0] = d[0] * t + coefficients[k];
  }
  return d;
}

template <bool kRational>
class PolynomialSpan final : public Span {
public:
  PolynomialSpan(std::vector<double> breaks, const Eigen::MatrixXd& powers) : intervals_(std::move(breaks)) {
    const auto terms = powers.rows() / static_cast<Eigen::Index>(intervals_.count());
    degree_ = static_cast<int>(terms) - 1;
    for (Eigen::Index i = 0; i < powers.rows(); ++i) {
      const Eigen::Index row = i / terms * terms + (terms - 1 - i % terms);
      numerators_.emplace_back(powers(row, 0), powers(row, 1));
      if constexpr (kRational) {
        denominators_.push_back(powers(row, 2));
      }
    }
    parts_ = count_parts();
  }

  [[nodiscard]] SpanPoint at(double t) const override { return point_of(derivatives(t)); }
  [[nodiscard]] Bounds range() const override { return intervals_.range(); }
  [[nodiscard]] int parts() const override { return parts_; }

private:
  [[nodiscard]] Derivatives derivatives(double t) const {
    const std::size_t interval = intervals_.at(t);
    const std::size_t first = interval * static_cast<std::size_t>(degree_ + 1);
    const double u = t - intervals_.begin(interval);
    const auto a = taylor(&numerators_[first], degree_, u);
    if constexpr (!kRational) {
      return {a[0], a[1], 2 * a[2], 6 * a[3]};
    }
    // a = p w, term by term of the Taylor series.
    const auto w = taylor(&denominators_[first], degree_, u);
    std::array<Vector2d, 4> p;
    for (std::size_t k = 0; k < p.size(); ++k) {
      p[k] = a[k];
      for (std::size_t i = 0; i < k; ++i) {
        p[k] -= p[i] * w[k - i];
      }
      p[k] /= w[0];
    }
    return {p[0], p[1], 2 * p[2], 6 * p[3]};
  }

  // So many that none turns by more than a tenth of a radian; no more than some an interval, for where the
  // curvature is all noise.
  [[nodiscard]] int count_parts() const {
    constexpr double kTurn = 0.1;
    constexpr int kProbes = 4;
    constexpr int kFewest = 8;
    const auto probes = static_cast<int>(intervals_.count()) * kProbes;
    const Bounds range = intervals_.range();
    double most = 0;
    for (int i = 0; i <= probes; ++i) {
      const SpanPoint point = at(range.low + range.width() * i / probes);
      most = std::max(most, std::abs(point.kappa) * point.speed);
    }
    const double wanted = most * range.width() / kTurn;
    return wanted < kFewest  ? kFewest
           : wanted < probes ? static_cast<int>(wanted)
                             : std::max(probes, kFewest);
  }

  Intervals intervals_;
  int degree_ = 0;
  int parts_ = 0;
  std::vector<Vector2d> numerators_;  // interval by interval, the highest power first
  std::vector<double> denominators_;
};

}  // namespace

SpanPtr polynomial_span(std::vector<double> breaks, const Eigen::MatrixXd& powers) {
  if (powers.cols() == 3) {
    return std::make_shared<PolynomialSpan<true>>(std::move(breaks), powers);
  }
  return std::make_shared<PolynomialSpan<false>>(std::move(breaks), powers);
}

}  // namespace higherpair

#include "polynomial_span.hpp"

#include "higherpair/geometry/curvature_rates.hpp"
#include "higherpair/geometry/pose.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "numeric/interval.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

using Derivatives = std::array<Vector2d, 4>;  // 0th to 3rd, by the parameter

// Cells of equal length, each with the interval in which it begins, so that the interval of a parameter is
// found without a search. There are a few cells per interval, so that hardly any contains more than one
// break.
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
    // Rounding of `cell` may have put a parameter that is just before a break into the cell behind it.
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

// Value and Taylor coefficients up to the N-th of a polynomial, by Horner's scheme from the highest power
// down.
template <std::size_t N = 3, class T>
std::array<T, N + 1> taylor(const T* coefficients, int degree, double t) {
  std::array<T, N + 1> d;
  d.fill(T(0 * coefficients[0]));
  d[0] = coefficients[0];
  for (int k = 1; k <= degree; ++k) {
    for (std::size_t i = N; i > 0; --i) {
      d[i] = d[i] * t + d[i - 1];
    }
    d[0] = d[0] * t + coefficients[k];
  }
  return d;
}

constexpr int kHalvingsOfInterval = 10;  // at most, where a curve turns much or is slow within one interval

// Encloses a polynomial and its first two derivatives over u ± r, from its Taylor coefficients at u and from
// `most`: those, at the end of its interval, of the polynomial with absolute coefficients, which bound its
// derivatives before that.
std::array<Interval, 3> enclosed(const std::array<double, 4>& at, const std::array<double, 4>& most,
                                 double r) {
  const double bend = r * (2 * std::abs(at[2]) + 3 * r * most[3]);
  return {around(at[0], r * (std::abs(at[1]) + bend) + kCoefficientRounding * most[0]),
          around(at[1], bend + kCoefficientRounding * most[1]),
          around(2 * at[2], 6 * r * most[3] + 2 * kCoefficientRounding * most[2])};
}

std::array<double, 4> component(const std::array<Vector2d, 4>& of, int i) {
  return {of[0][i], of[1][i], of[2][i], of[3][i]};
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

  [[nodiscard]] SpanPoint at(double t) const override {
    const auto p = point_at<3>(t);
    return point_of({p[0], p[1], 2 * p[2], 6 * p[3]});
  }
  [[nodiscard]] std::optional<CurvatureRates> curvature_rates(double t) const override {
    const auto p = point_at<CurveSeries::kLast>(t);
    Vector2<CurveSeries> series;
    for (std::size_t k = 0; k < p.size(); ++k) {
      series.x().c[k] = p[k].x();
      series.y().c[k] = p[k].y();
    }
    return rates_of_curvature(series);
  }
  [[nodiscard]] Bounds range() const override { return intervals_.range(); }
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& t) const override {
    std::optional<SpanBounds> all;
    const std::size_t last = intervals_.at(t.high);
    for (std::size_t i = intervals_.at(t.low); i <= last; ++i) {
      const double begin = intervals_.begin(i);
      const double end = std::min(t.high, intervals_.begin(i + 1));
      if (!add_bounds(i, {std::max(t.low, begin) - begin, end - begin}, kHalvingsOfInterval, all)) {
        return std::nullopt;
      }
    }
    return all;
  }
  [[nodiscard]] int parts() const override { return parts_; }
  [[nodiscard]] std::vector<double> breaks() const override {
    std::vector<double> breaks;
    for (std::size_t i = 1; i < intervals_.count(); ++i) {
      breaks.push_back(intervals_.begin(i));
    }
    return breaks;
  }

private:
  [[nodiscard]] std::size_t first_of(std::size_t interval) const {
    return interval * static_cast<std::size_t>(degree_ + 1);
  }

  // Taylor coefficients of the point.
  template <std::size_t N>
  [[nodiscard]] std::array<Vector2d, N + 1> point_at(double t) const {
    const std::size_t interval = intervals_.at(t);
    const std::size_t first = first_of(interval);
    const double u = t - intervals_.begin(interval);
    auto p = taylor<N>(&numerators_[first], degree_, u);
    if constexpr (kRational) {
      // The numerators are p w, term by term of the Taylor series.
      const auto w = taylor<N>(&denominators_[first], degree_, u);
      for (std::size_t k = 0; k < p.size(); ++k) {
        for (std::size_t i = 0; i < k; ++i) {
          p[k] -= p[i] * w[k - i];
        }
        p[k] /= w[0];
      }
    }
    return p;
  }

  // Taylor coefficients, at an interval's end, of the polynomial with the absolute values of its
  // coefficients.
  template <class T, class Size>
  [[nodiscard]] std::array<T, 4> most_of(const std::vector<T>& coefficients, std::size_t interval,
                                         const Size& size) const {
    std::vector<T> sizes(static_cast<std::size_t>(degree_ + 1));
    const auto first = coefficients.begin() + static_cast<std::ptrdiff_t>(first_of(interval));
    std::transform(first, first + degree_ + 1, sizes.begin(), size);
    return taylor(sizes.data(), degree_, intervals_.begin(interval + 1) - intervals_.begin(interval));
  }

  // p′ and p″ over part of an interval.
  [[nodiscard]] std::array<IntervalVector, 2> rates(std::size_t interval, const Bounds& u) const {
    const double middle = (u.low + u.high) / 2;
    const double r = std::max(middle - u.low, u.high - middle);
    auto at = taylor(&numerators_[first_of(interval)], degree_, middle);
    auto most = most_of(numerators_, interval, [](const Vector2d& c) -> Vector2d { return c.cwiseAbs(); });
    if constexpr (!kRational) {
      const auto x = enclosed(component(at, 0), component(most, 0), r);
      const auto y = enclosed(component(at, 1), component(most, 1), r);
      return {{{x[1], y[1]}, {x[2], y[2]}}};
    } else {
      // b = a - w p(u), so that b / w is small.
      const auto w_at = taylor(&denominators_[first_of(interval)], degree_, middle);
      const auto most_weight = most_of(denominators_, interval, [](double w) { return std::abs(w); });
      const Vector2d p = at[0] / w_at[0];
      for (std::size_t k = 0; k < at.size(); ++k) {
        at[k] -= w_at[k] * p;
        most[k] += most_weight[k] * p.cwiseAbs();
      }
      const auto w = enclosed(w_at, most_weight, r);
      std::array<IntervalVector, 2> result;
      for (int i = 0; i < 2; ++i) {
        const auto b = enclosed(component(at, i), component(most, i), r);
        const Interval q = b[0] / w[0];
        const Interval dq = (b[1] - q * w[1]) / w[0];
        const Interval ddq = (b[2] - 2.0 * dq * w[1] - q * w[2]) / w[0];
        (i == 0 ? result[0].x : result[0].y) = dq;
        (i == 0 ? result[1].x : result[1].y) = ddq;
      }
      return result;
    }
  }

  // False where the curve may have a cusp.
  bool add_bounds(std::size_t interval, const Bounds& u, int halvings, std::optional<SpanBounds>& all) const {
    const auto [first, second] = rates(interval, u);
    const Interval square = boost::numeric::square(first.x) + boost::numeric::square(first.y);
    if (!(square.lower() > square.upper() / 4) && halvings > 0) {
      const double middle = (u.low + u.high) / 2;
      return add_bounds(interval, {u.low, middle}, halvings - 1, all) &&
             add_bounds(interval, {middle, u.high}, halvings - 1, all);
    }
    if (!(square.lower() > 0)) {
      return false;
    }
    const Interval turn = (first.x * second.y - first.y * second.x) / square;
    const SpanBounds here{to_bounds(sqrt(square)), to_bounds(turn)};
    all = all ? SpanBounds{hull(all->speed, here.speed), hull(all->turn, here.turn)} : here;
    return true;
  }

  // So many that the curve turns by no more than a tenth of a radian in each, but only a few per interval
  // where the curvature is all noise.
  [[nodiscard]] int count_parts() const {
    constexpr int kProbes = 4;
    constexpr int kFewest = 8;
    const auto probes = static_cast<int>(intervals_.count()) * kProbes;
    const Bounds range = intervals_.range();
    double most = 0;
    for (int i = 0; i <= probes; ++i) {
      const SpanPoint point = at(range.low + range.width() * i / probes);
      most = std::max(most, std::abs(point.kappa) * point.speed);
    }
    const double wanted = most * range.width() / kLargestPartTurn;
    return wanted < kFewest  ? kFewest
           : wanted < probes ? static_cast<int>(wanted)
                             : std::max(probes, kFewest);
  }

  Intervals intervals_;
  int degree_ = 0;
  int parts_ = 0;
  std::vector<Vector2d> numerators_;  // by intervals, the highest power first
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

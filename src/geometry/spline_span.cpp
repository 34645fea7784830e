#include "higherpair/geometry/spline_span.hpp"

#include "higherpair/geometry/tolerances.hpp"
#include "numeric/spline.hpp"
#include "polynomial_span.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <Eigen/Geometry>

namespace higherpair {
namespace {

using Points = std::vector<Vector2d>;

double size_of(const Points& points) {
  Eigen::AlignedBox2d box;
  for (const Vector2d& p : points) {
    box.extend(p);
  }
  return box.diagonal().norm();
}

// The number of steps from each point to the next; a closed curve also has one from the last to the first.
std::size_t step_count(const Points& points, bool closed) {
  return closed ? points.size() : points.size() - 1;
}

Vector2d step(const Points& points, std::size_t i) {
  return points[(i + 1) % points.size()] - points[i];
}

std::optional<SplineFault> fault_of_steps(const Points& points, bool closed) {
  const std::size_t steps = step_count(points, closed);
  const double same = kSameSplinePoint * size_of(points);
  double largest = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    const double distance = step(points, i).norm();
    const std::size_t next = (i + 1) % points.size();
    if (!(distance > same)) {
      return SplineFault{SplineFault::Kind::kRepeated, static_cast<int>(i), static_cast<int>(next)};
    }
    if (next == 0 && distance > kWidestClosingStep * largest) {
      return SplineFault{SplineFault::Kind::kOpen, static_cast<int>(i), 0, distance, distance / largest};
    }
    largest = std::max(largest, distance);
  }
  for (std::size_t i = 0; i + 1 < steps + (closed ? 1 : 0); ++i) {
    const Vector2d before = step(points, i);
    const Vector2d after = step(points, (i + 1) % points.size());
    if (std::abs(angle_from_to(before, after)) > kSharpestSplineTurn) {
      return SplineFault{SplineFault::Kind::kTurnsBack, static_cast<int>((i + 1) % points.size())};
    }
  }
  return std::nullopt;
}

// The parameters at the points, and at the end of a closed curve.
std::vector<double> parameters(const Points& points, const SplineOptions& options) {
  std::vector<double> t = {0};
  for (std::size_t i = 0; i < step_count(points, options.closed); ++i) {
    const double distance = step(points, i).norm();
    t.push_back(t.back() + (options.parameter == SplineParameter::kArc ? distance : std::sqrt(distance)));
  }
  return t;
}

// Derivative by the parameter in a given direction; a unit vector if the parameter is the arc length.
Eigen::RowVectorXd slope(const std::optional<Vector2d>& tangent, SplineParameter parameter,
                         const Vector2d& step, double dt) {
  if (!tangent) {
    return {};
  }
  const double speed = parameter == SplineParameter::kArc ? 1 : step.norm() / dt;
  return tangent->normalized().transpose() * speed;
}

Eigen::MatrixXd powers_of(const Points& points, const SplineOptions& options, const std::vector<double>& t,
                          double smoothing) {
  SplineTask task;
  task.x.assign(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(points.size()));
  task.values.resize(static_cast<Eigen::Index>(points.size()), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    task.values.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  }
  task.degree = options.degree;
  task.period = options.closed ? t.back() : 0;
  task.smoothing = smoothing;
  task.no_end_knots = true;
  if (!options.closed) {
    const std::size_t last = points.size() - 2;
    task.first_slope = slope(options.first_tangent, options.parameter, step(points, 0), t[1] - t[0]);
    task.last_slope =
        slope(options.last_tangent, options.parameter, step(points, last), t[last + 1] - t[last]);
  }
  return spline_powers(task);
}

// Arc lengths of a piecewise polynomial curve at the breaks, by Gauss's rule of four points.
std::vector<double> arc_lengths(const std::vector<double>& t, const Eigen::MatrixXd& powers) {
  constexpr std::array<double, 2> kPlaces = {0.33998104358485626, 0.86113631159405258};
  constexpr std::array<double, 2> kWeights = {0.65214515486254614, 0.34785484513745386};
  const auto intervals = static_cast<Eigen::Index>(t.size()) - 1;
  const Eigen::Index terms = powers.rows() / intervals;
  std::vector<double> s = {0};
  for (Eigen::Index i = 0; i < intervals; ++i) {
    const double half = (t[static_cast<std::size_t>(i) + 1] - t[i]) / 2;
    double sum = 0;
    for (const double side : {-1.0, 1.0}) {
      for (std::size_t g = 0; g < kPlaces.size(); ++g) {
        const double u = half * (1 + side * kPlaces[g]);
        Vector2d velocity = Vector2d::Zero();
        for (Eigen::Index k = terms - 1; k > 0; --k) {
          velocity = velocity * u + static_cast<double>(k) * powers.row(i * terms + k).transpose();
        }
        sum += kWeights[g] * velocity.norm();
      }
    }
    s.push_back(s.back() + half * sum);
  }
  return s;
}

// Where the spline is much slower than its parameter requires, or runs against the order of the points.
std::optional<SplineFault> fault_of_curve(const Span& span, const Points& points,
                                          const std::vector<double>& t) {
  constexpr int kProbes = 4;
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const Vector2d chord = step(points, i);
    const double dt = t[i + 1] - t[i];
    for (int k = 0; k < kProbes; ++k) {
      const SpanPoint point = span.at(t[i] + dt * (k + 0.5) / kProbes);
      const bool forward = point.speed * perp(point.n_B).dot(chord) > -0.5 * point.speed * chord.norm();
      if (!(point.speed * dt > kSlowestSpline * chord.norm()) || !forward) {
        return SplineFault{SplineFault::Kind::kCusp, static_cast<int>(i)};
      }
    }
  }
  return std::nullopt;
}

}  // namespace

tl::expected<SpanPtr, SplineFault> spline_span(const std::vector<Vector2d>& given,
                                               const SplineOptions& options) {
  assert(options.degree == 3 || options.degree == 5);
  Points points = given;
  if (options.closed && points.size() > 1 &&
      (points.back() - points.front()).norm() <= kSameSplinePoint * size_of(points)) {
    points.pop_back();
  }
  if (points.size() < static_cast<std::size_t>(options.degree) + 1) {
    return tl::unexpected(SplineFault{SplineFault::Kind::kTooFew});
  }
  if (const auto fault = fault_of_steps(points, options.closed)) {
    return tl::unexpected(*fault);
  }
  std::vector<double> t = parameters(points, options);
  if (options.parameter == SplineParameter::kArc) {
    // Chords equal arcs up to a relative error of second order; each iteration gains two more orders (Floater
    // and Surazhsky, Parameterization for curve interpolation, 2006).
    constexpr int kTurns = 2;
    for (int turn = 0; turn < kTurns; ++turn) {
      t = arc_lengths(t, powers_of(points, options, t, 0));
    }
  }
  const Eigen::MatrixXd powers = powers_of(points, options, t, options.smoothing);
  SpanPtr span = polynomial_span(t, powers);
  if (const auto fault = fault_of_curve(*span, points, t)) {
    return tl::unexpected(*fault);
  }
  return span;
}

}  // namespace higherpair

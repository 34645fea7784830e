#include "nearest_rows.hpp"

#include "front/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace higherpair {
namespace {

constexpr std::size_t kMostFirstPlaces = 4;  // places tried as the first of a closed path

using Rows = std::vector<std::size_t>;

double squared(const Vector2d& a, const Vector2d& b) {
  return (a - b).squaredNorm();
}

// The rows, in ascending order, that are nearest to the targets by the sum of squares.
struct Assignment {
  Rows rows;
  double cost = kInf;
};

// Assigns targets to places in ascending order, by dynamic programming.
// \param pinned  the first target must be at place 0 \param cost  of target i at place k
template <class F>
Assignment in_order(std::size_t places, std::size_t targets, bool pinned, F cost) {
  std::vector<double> best(places, kInf);
  std::vector<Rows> from(targets, Rows(places, 0));
  for (std::size_t i = 0; i < targets; ++i) {
    double least = i == 0 ? 0 : kInf;
    std::size_t where = 0;
    for (std::size_t k = 0; k < places; ++k) {
      if (i > 0 && best[k] < least) {
        least = best[k];
        where = k;
      }
      from[i][k] = where;
      const bool open = i > 0 || !pinned || k == 0;
      best[k] = open ? least + cost(i, k) : kInf;
    }
  }
  const auto last = std::min_element(best.begin(), best.end());
  Assignment assignment{Rows(targets), *last};
  std::size_t k = static_cast<std::size_t>(last - best.begin());
  for (std::size_t i = targets; i-- > 0;) {
    assignment.rows[i] = k;
    k = from[i][k];
  }
  return assignment;
}

bool is_loop(std::span<const Vector2d> points) {
  double length = 0;
  for (std::size_t k = 1; k < points.size(); ++k) length += (points[k] - points[k - 1]).norm();
  return points.size() > 3 && (points.front() - points.back()).norm() <= kClosedPath * length;
}

// On a closed path the first target may lie anywhere; the others follow within one lap.
Rows around(std::span<const Vector2d> points, std::span<const Vector2d> targets) {
  assert(points.size() > 1);
  const std::size_t n = points.size() - 1;
  const auto far = [&](std::size_t k) { return squared(points[k], targets.front()); };
  Rows begins;
  for (std::size_t k = 0; k < n; ++k) {
    if (far(k) <= far((k + 1) % n) && far(k) < far((k + n - 1) % n)) begins.push_back(k);
  }
  std::sort(begins.begin(), begins.end(), [&](std::size_t a, std::size_t b) { return far(a) < far(b); });
  begins.resize(std::min(begins.size(), kMostFirstPlaces));
  Assignment best;
  std::size_t begin = 0;
  for (const std::size_t k : begins) {
    const Assignment found = in_order(n + 1, targets.size(), true, [&](std::size_t i, std::size_t place) {
      return squared(points[(k + place) % n], targets[i]);
    });
    if (found.cost < best.cost) {
      best = found;
      begin = k;
    }
  }
  for (std::size_t& row : best.rows) row = (row + begin) % n;
  return best.rows.empty() ? Rows(targets.size(), 0) : best.rows;
}

}  // namespace

std::optional<std::size_t> turning_row(std::span<const double> positions) {
  const auto [low, high] = std::minmax_element(positions.begin(), positions.end());
  double last = 0;
  for (std::size_t k = 1; k < positions.size(); ++k) {
    const double step = positions[k] - positions[k - 1];
    if (!(std::abs(step) > kAtPlace * (*high - *low))) continue;
    if (step * last < 0) return k - 1;
    last = step;
  }
  return std::nullopt;
}

bool goes_around(const DesignTask::PointPath& path, std::span<const Vector2d> points,
                 const std::vector<double>& at) {
  return path.closed && is_loop(points) && !turning_row(at) && at.front() != at.back();
}

std::vector<std::size_t> nearest_rows(const DesignTask::PointPath& path, std::span<const Vector2d> points,
                                      const std::vector<double>& at) {
  if (goes_around(path, points, at)) {
    return around(points, path.through);
  }
  if (path.ordered) {
    return in_order(points.size(), path.through.size(), false,
                    [&](std::size_t i, std::size_t k) { return squared(points[k], path.through[i]); })
        .rows;
  }
  Rows rows;
  for (const Vector2d& target : path.through) {
    const auto nearest = std::min_element(
        points.begin(), points.end(),
        [&](const Vector2d& a, const Vector2d& b) { return squared(a, target) < squared(b, target); });
    rows.push_back(static_cast<std::size_t>(nearest - points.begin()));
  }
  return rows;
}

}  // namespace higherpair

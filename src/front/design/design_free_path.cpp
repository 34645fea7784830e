#include "design_free_path.hpp"

#include "front/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

using Complex = PathPlacement::Complex;
using Path = DesignTask::PointPath;

constexpr int kBegins = 36;         // places of a loop tried as that of the first point
constexpr int kParts = 16;          // parts of an open path: stretches begin and end between them
constexpr std::size_t kBest = 3;    // stretches that are refined
constexpr int kMostRowPasses = 10;  // iterations from row to row
constexpr int kMostFits = 40;       // iterations between rows

struct Placing {
  Complex z = 1, shift = 0;
  double cost = 0;  // sum of squares
};

Complex complex(const Vector2d& v) {
  return {v.x(), v.y()};
}

Vector2d vector(const Complex& c) {
  return {c.real(), c.imag()};
}

Placing placing_of(const Path& path, std::span<const Vector2d> places) {
  const PathPlacement placement(path, places);
  return {placement.turn_and_scale(), placement.shift(), placement.misses().squaredNorm()};
}

// The target points in the path's own frame.
Path seen_from(const Placing& placing, const Path& path) {
  std::vector<Vector2d> points;
  for (const Vector2d& point : path.through) {
    points.push_back(vector((complex(point) - placing.shift) / placing.z));
  }
  return with_points(path, std::move(points));
}

// Length along the points from the first to each; for a loop, a last entry is the length back to the first.
std::vector<double> lengths_along(std::span<const Vector2d> points, bool loop) {
  std::vector<double> lengths = {0};
  for (std::size_t k = 1; k < points.size(); ++k) {
    lengths.push_back(lengths.back() + (points[k] - points[k - 1]).norm());
  }
  if (loop) lengths.push_back(lengths.back() + (points.front() - points.back()).norm());
  return lengths;
}

// Lays stretches of the path on its target points, each point at its fraction of the length.
class Stretches {
public:
  Stretches(const Path& path, std::span<const Vector2d> points, bool loop)
      : path_(path), points_(points), along_(lengths_along(points, false)), loop_(loop) {
    const std::vector<double> targets = lengths_along(path.through, loop);
    for (std::size_t i = 0; i < path.through.size(); ++i) shares_.push_back(targets[i] / targets.back());
  }

  // The best stretches.
  [[nodiscard]] std::vector<Placing> best() {
    if (loop_) {
      for (int k = 0; k < kBegins; ++k) lay(double(k) / kBegins, double(k) / kBegins + 1);
    } else {
      for (int from = 0; from < kParts; ++from) {
        for (int to = from + 1; to <= kParts; ++to) lay(double(from) / kParts, double(to) / kParts);
      }
    }
    std::sort(found_.begin(), found_.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
    found_.resize(std::min(found_.size(), kBest));
    return std::move(found_);
  }

private:
  // Forwards, and also backwards where the points have no order.
  void lay(double from, double to) {
    lay_one(from, to);
    if (!path_.ordered) lay_one(to, from);
  }

  void lay_one(double from, double to) {
    std::vector<Vector2d> places;
    for (const double share : shares_) {
      const double at = std::lerp(from, to, share);
      places.push_back(place_at(along_.back() * (loop_ ? at - std::floor(at) : at)));
    }
    found_.push_back(placing_of(path_, places));
  }

  [[nodiscard]] Vector2d place_at(double length) const {
    const auto next = std::upper_bound(along_.begin() + 1, along_.end() - 1, length);
    const auto k = static_cast<std::size_t>(next - along_.begin());
    const double part = along_[k] - along_[k - 1];
    const double share = part > 0 ? std::clamp((length - along_[k - 1]) / part, 0.0, 1.0) : 0;
    return (1 - share) * points_[k - 1] + share * points_[k];
  }

  const Path& path_;
  std::span<const Vector2d> points_;
  std::vector<double> along_;  // lengths along the path in its rows
  std::vector<double> shares_;
  bool loop_;
  std::vector<Placing> found_;
};

// Alternates between nearest rows and best placement, each of which reduces the sum, until the rows stay the
// same.
Placing follow_rows_down(const Path& path, std::span<const Vector2d> points, Placing placing,
                         const std::function<std::vector<std::size_t>(const Path&)>& rows_for) {
  std::vector<std::size_t> last;
  for (int pass = 0; pass < kMostRowPasses && std::abs(placing.z) > kLeastPathScale; ++pass) {
    std::vector<std::size_t> rows = rows_for(seen_from(placing, path));
    if (rows == last) break;
    std::vector<Vector2d> places;
    for (const std::size_t row : rows) places.push_back(points[row]);
    placing = placing_of(path, places);
    last = std::move(rows);
  }
  return placing;
}

// The same between rows, where the places may slide along their tangents.
class Descent {
public:
  Descent(const Path& path, const std::function<std::vector<PathMiss>(const Path&)>& places_for)
      : path_(path), places_for_(places_for) {}

  std::vector<PathMiss> from(const Placing& start) {
    if (!go_to(start)) return std::move(at_.places);
    for (int pass = 0; pass < kMostFits; ++pass) {
      const State before = at_;
      const PathPlacement placement = placement_of(path_, before.places);
      const auto [z, shift] = placement.moved_by_tangents(tangents_of(before.places));
      const bool gains = go_to({z, shift}) && at_.placing.cost <= before.placing.cost;
      if (!gains && !go_to({placement.turn_and_scale(), placement.shift()})) {
        at_ = before;
        break;
      }
      if (change_from(before.placing) <= kSettledPlacement) break;
    }
    return std::move(at_.places);
  }

private:
  struct State {
    Placing placing;
    std::vector<PathMiss> places;
  };

  // False where the path has shrunk to a point.
  bool go_to(const Placing& placing) {
    const bool usable = std::abs(placing.z) > kLeastPathScale;
    at_.placing = usable ? placing : Placing();
    at_.places = places_for_(seen_from(at_.placing, path_));
    at_.placing.cost = 0;
    size_ = 0;
    for (std::size_t i = 0; i < at_.places.size(); ++i) {
      const Complex place = complex(at_.places[i].p_W);
      const Complex off = at_.placing.z * place + at_.placing.shift - complex(path_.through[i]);
      at_.placing.cost += std::norm(off);
      size_ = std::max(size_, std::abs(place));
    }
    return usable;
  }

  [[nodiscard]] double change_from(const Placing& before) const {
    const double turned = std::abs(at_.placing.z - before.z);
    return turned + std::abs(at_.placing.shift - before.shift) / (size_ > 0 ? size_ : 1);
  }

  const Path& path_;
  const std::function<std::vector<PathMiss>(const Path&)>& places_for_;
  State at_;
  double size_ = 0;
};

}  // namespace

DesignTask::PointPath with_points(const DesignTask::PointPath& path, std::vector<Vector2d> points) {
  DesignTask::PointPath other = path;
  other.through = std::move(points);
  return other;
}

std::vector<PathMiss> nearest_when_free(
    const DesignTask::PointPath& path, std::span<const Vector2d> points, bool loop,
    const std::function<std::vector<std::size_t>(const DesignTask::PointPath&)>& rows_for,
    const std::function<std::vector<PathMiss>(const DesignTask::PointPath&)>& places_for) {
  if (points.size() < 2) {
    return places_for(path);
  }
  Placing best;
  best.cost = kInf;
  for (const Placing& stretch : Stretches(path, points, loop).best()) {
    const Placing placing = follow_rows_down(path, points, stretch, rows_for);
    if (placing.cost < best.cost) best = placing;
  }
  return Descent(path, places_for).from(best);
}

}  // namespace higherpair

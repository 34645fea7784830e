#include "design_paths.hpp"

#include "design_free_path.hpp"
#include "front/tolerances.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "nearest_rows.hpp"
#include "numeric/eigen_index.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace higherpair {
namespace {

constexpr int kMostPasses = 12;  // of Newton's method

// The path of one point of a run, anywhere between two positions of the driver.
class PathSearch {
public:
  PathSearch(const DesignTask::PointPath& path, DesignRows& rows, const Vector2d& p_B, double low,
             double high, bool loop)
      : path_(path), rows_(rows), p_B_(p_B), low_(low), high_(high), loop_(loop) {}

  // A place on the path, not wrapped to one lap.
  struct Nearest {
    double t = 0;
    PathMiss miss;
  };

  // The place nearest to `target`, near the driver's position t and no farther from it than `reach`.
  Nearest nearest(double t, double reach, const Vector2d& target) {
    const double from = loop_ ? t - reach : std::max(low_, t - reach);
    const double to = loop_ ? t + reach : std::min(high_, t + reach);
    for (int pass = 0; pass < kMostPasses; ++pass) {
      go_to(t);
      const Vector2d off = here_.p_W - target;
      const double slope = off.dot(here_.v_W);
      const double bend = here_.v_W.squaredNorm() + off.dot(here_.a_W);
      // Where the squared distance is not convex, the step downhill is that for a straight path.
      const double step =
          -slope / (bend > kConvexDistance * here_.v_W.squaredNorm() ? bend : here_.v_W.squaredNorm());
      const double next = std::clamp(t + step, from, to);
      const bool done = !(std::abs(next - t) > kSharpestStep * reach);
      if (done || pass + 1 == kMostPasses) break;
      t = next;
    }
    PathMiss miss;
    miss.p_W = here_.p_W;
    miss.driver = wrapped(t);
    const bool at_end = t <= from || t >= to;  // of the path, or of the range of the search
    if (!at_end && here_.v_W.norm() > 0) miss.along = here_.v_W.normalized();
    return {t, miss};
  }

private:
  [[nodiscard]] double wrapped(double t) const {
    const double turn = high_ - low_;
    return !loop_ || (t >= low_ && t <= high_) ? t : t - turn * std::floor((t - low_) / turn);
  }

  void go_to(double t) { here_ = point_motion(rows_.bodies_at(wrapped(t))[path_.ref.body], p_B_); }

  const DesignTask::PointPath& path_;
  DesignRows& rows_;
  Vector2d p_B_;
  double low_, high_;
  bool loop_;
  PointMotion here_;
};

// Finds the places of an untimed path, starting from the rows next to them, in the order of the targets if
// they have one.
class NearestPlaces {
public:
  NearestPlaces(DesignRows& rows, std::span<const Vector2d> points)
      : rows_(rows), points_(points), between_rows_(rows.missing == 0 && rows.positions.size() > 1) {}

  std::vector<PathMiss> of(const DesignTask::PointPath& path) {
    std::vector<PathMiss> misses = in_rows(nearest_rows(path, points_, rows_.positions));
    if (!between_rows_) {
      return misses;
    }
    const auto [low, high] = std::minmax_element(rows_.positions.begin(), rows_.positions.end());
    const Mechanism& mechanism = rows_.direct ? *rows_.mechanism : rows_.run->mechanism();
    const bool loop = goes_around(path, points_, rows_.positions);
    PathSearch search(path, rows_, point_of(mechanism, path.ref), *low, *high, loop);
    // In the order of driver positions, which keeps the moves of the run short.
    std::vector<std::size_t> order(misses.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return misses[a].driver > misses[b].driver; });
    std::vector<Block> blocks(misses.size());
    const double lap = rows_.positions.back() - rows_.positions.front();
    for (std::size_t i = 0; i < misses.size(); ++i) {
      Block& block = blocks[i];
      block.first = i;
      block.start = misses[i].driver;
      block.reach = kReachOfPlace * widest_step_at(*misses[i].row, loop);
      if (loop && i > 0 && (block.start - blocks[i - 1].start) * lap < 0) block.start += lap;
    }
    for (const std::size_t i : order) {
      blocks[i].place = search.nearest(blocks[i].start, blocks[i].reach, path.through[i]);
    }
    if (loop ? !is_in_one_lap(blocks, lap) : path.ordered && !turning_row(rows_.positions)) {
      const double ends = loop ? lap : 0;
      if (path.is_free()) {
        keep_rows(blocks, ends, misses);
      } else {
        put_in_order(blocks, ends, [&](Block& block) {
          block.place = search.nearest(block.start, block.reach, center_of(block, path.through));
        });
      }
    }
    for (const Block& block : blocks) {
      for (std::size_t i = 0; i < block.count; ++i) {
        PathMiss& miss = misses[(block.first + i) % misses.size()];
        miss = block.place.miss;
        if (block.count > 1) miss.shared = share_of(block, i, path.through);
      }
    }
    return misses;
  }

  [[nodiscard]] std::vector<PathMiss> in_rows(std::span<const std::size_t> nearest) const {
    std::vector<PathMiss> misses;
    for (const std::size_t row : nearest) {
      misses.push_back({points_[row], Vector2d::Zero(), rows_.positions[row], row});
    }
    return misses;
  }

private:
  // Targets that follow one another and share a place.
  struct Block {
    std::size_t first = 0;
    std::size_t count = 1;
    double start = 0;  // driver position of the rows next to the targets: their mean
    double reach = 0;  // of the search from there
    PathSearch::Nearest place;
  };

  // The distance of the row from the farther of its neighbours, but no less than the mean of all steps.
  [[nodiscard]] double widest_step_at(std::size_t row, bool loop) const {
    const std::vector<double>& at = rows_.positions;
    const std::size_t last = at.size() - 1;
    const std::size_t next = std::min(row + 1, last), here = row > 0 ? row : loop ? last : next;
    return std::max({std::abs(at[next] - at[next - 1]), std::abs(at[here] - at[here - 1]),
                     std::abs(at[last] - at[0]) / static_cast<double>(last)});
  }

  static Vector2d center_of(const Block& block, std::span<const Vector2d> targets) {
    Vector2d center = Vector2d::Zero();
    for (std::size_t i = 0; i < block.count; ++i) {
      center += targets[(block.first + i) % targets.size()] / static_cast<double>(block.count);
    }
    return center;
  }

  // With n targets q_i about their mean c, Σ |p - q_i|² = n |p - c|² + Σ |c - q_i|²: the first one takes the
  // first part, the others the rest, which does not change.
  static PathMiss::Shared share_of(const Block& block, std::size_t i, std::span<const Vector2d> targets) {
    PathMiss::Shared share;
    share.center = center_of(block, targets);
    const auto count = static_cast<double>(block.count);
    if (i == 0) {
      share.factor = std::sqrt(count);
      return share;
    }
    for (std::size_t k = 0; k < block.count; ++k) {
      share.rest += (share.center - targets[(block.first + k) % targets.size()]).squaredNorm() / (count - 1);
    }
    share.rest = std::sqrt(share.rest);
    return share;
  }

  // Takes places that have passed each other back to their rows, which are in order: each at most once, and
  // one or more in every pass but the last.
  // \param lap  as in put_in_order
  void keep_rows(std::vector<Block>& blocks, double lap, std::span<const PathMiss> in_rows) const {
    const double sense = rows_.positions.back() > rows_.positions.front() ? 1 : -1;
    const auto keep = [&](std::size_t k) { blocks[k].place = {blocks[k].start, in_rows[k]}; };
    bool passed = true;
    for (std::size_t pass = 0; passed && pass < blocks.size(); ++pass) {
      passed = false;
      for (std::size_t k = 0; k + (lap == 0 ? 1 : 0) < blocks.size(); ++k) {
        const std::size_t next = (k + 1) % blocks.size();
        const double beyond = next > k ? 0 : lap;
        if (sense * (blocks[next].place.t + beyond - blocks[k].place.t) >= 0) continue;
        keep(k);
        keep(next);
        passed = true;
      }
    }
  }

  // Whether all places of a loop follow one another within one lap, wherever it begins.
  static bool is_in_one_lap(const std::vector<Block>& blocks, double lap) {
    double laps = 0;
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      const double on = (blocks[(k + 1) % blocks.size()].place.t - blocks[k].place.t) / lap;
      laps += on - std::floor(on);
    }
    return laps < 1.5;  // a whole number to within rounding
  }

  // Places that have passed each other between rows become one: among places in order, the sum of squares of
  // both targets is least where they share one, the nearest to the mean of the targets.
  // \param lap  of a loop: the last place is at most so far beyond the first; 0: no loop
  template <class F>
  void put_in_order(std::vector<Block>& blocks, double lap, F find) const {
    const double sense = rows_.positions.back() > rows_.positions.front() ? 1 : -1;
    const auto merge = [&](Block& into, const Block& next, double shift) {
      const double both = static_cast<double>(into.count + next.count);
      const double mean = (static_cast<double>(into.count) * into.start +
                           static_cast<double>(next.count) * (next.start + shift)) /
                          both;
      into.reach = std::max(std::abs(into.start - mean) + into.reach,
                            std::abs(next.start + shift - mean) + next.reach);
      into.start = mean;
      into.count += next.count;
      find(into);
    };
    for (std::size_t k = 0; k + 1 < blocks.size();) {
      if (sense * (blocks[k + 1].place.t - blocks[k].place.t) >= 0) {
        ++k;
        continue;
      }
      merge(blocks[k], blocks[k + 1], 0);
      blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      k = k > 0 ? k - 1 : 0;
    }
    while (lap != 0 && blocks.size() > 1 &&
           sense * (blocks.front().place.t + lap - blocks.back().place.t) < 0) {
      merge(blocks.back(), blocks.front(), lap);
      blocks.erase(blocks.begin());
      // What was moved back may have passed the places before it.
      for (std::size_t k = blocks.size(); k-- > 1;) {
        if (sense * (blocks[k].place.t - blocks[k - 1].place.t) >= 0) break;
        merge(blocks[k - 1], blocks[k], 0);
        blocks.pop_back();
      }
    }
  }

  DesignRows& rows_;
  std::span<const Vector2d> points_;
  bool between_rows_;
};

}  // namespace

std::vector<PathMiss> nearest_places(const DesignTask::PointPath& path, DesignRows& rows,
                                     std::span<const Vector2d> points,
                                     std::span<const std::size_t> timed_rows) {
  NearestPlaces places(rows, points);
  if (path.timed) {
    return places.in_rows(timed_rows);
  }
  if (!path.is_free()) {
    return places.of(path);
  }
  return nearest_when_free(
      path, points, goes_around(path, points, rows.positions),
      [&](const DesignTask::PointPath& other) { return nearest_rows(other, points, rows.positions); },
      [&](const DesignTask::PointPath& other) { return places.of(other); });
}

Eigen::Index miss_count(const DesignTask::PointPath& path) {
  return eigen_index(path.through.size()) * (path.timed ? 2 : 1);
}

PathPlacement placement_of(const DesignTask::PointPath& path, std::span<const PathMiss> misses) {
  std::vector<Vector2d> places;
  for (const PathMiss& miss : misses) places.push_back(miss.p_W);
  return {path, places};
}

std::vector<Vector2d> tangents_of(std::span<const PathMiss> misses) {
  std::vector<Vector2d> tangents;
  for (const PathMiss& miss : misses) tangents.push_back(miss.along);
  return tangents;
}

Eigen::VectorXd misses_of(const DesignTask::PointPath& path, std::span<const PathMiss> misses, double unit) {
  if (path.is_free()) {
    const PathPlacement placement = placement_of(path, misses);
    return (path.timed ? placement.misses() : placement.distances(tangents_of(misses))) / unit;
  }
  Eigen::VectorXd numbers(miss_count(path));
  for (std::size_t i = 0; i < misses.size(); ++i) {
    const Vector2d off = (misses[i].p_W - misses[i].compared_with(path.through[i])) / unit;
    const auto k = eigen_index(i);
    if (path.timed) {
      numbers.segment<2>(2 * k) = off;
    } else if (misses[i].shared && misses[i].shared->factor == 0) {
      numbers(k) = misses[i].shared->rest / unit;
    } else {
      const double factor = misses[i].shared ? misses[i].shared->factor : 1;
      numbers(k) = factor * (misses[i].along.isZero() ? off.norm() : cross(misses[i].along, off));
    }
  }
  return numbers;
}

}  // namespace higherpair

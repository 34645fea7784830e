#pragma once

#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/tolerances.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

// Plane curves given by points along them, with a tree of boxes for searches.

namespace higherpair {

/// A point of a boundary's plane curve, scaled to lengths, and the place on the boundary that it belongs to.
struct Feature {
  Vector2d at;
  BoundaryPlace place;
};

using Features = std::vector<Feature>;

[[nodiscard]] inline BoundaryPlace between(const Feature& a, const Feature& b, double share) {
  return {a.place.span, a.place.t + share * (b.place.t - a.place.t)};
}

/// Box around the part from a to b, widened by its slack, or around several parts.
struct PartBox {
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
  Vector2d high = -low;

  PartBox() = default;
  PartBox(const Vector2d& a, const Vector2d& b) : low(a.cwiseMin(b)), high(a.cwiseMax(b)) {
    widen(kSlackOfPart * (b - a).norm());
  }
  void extend(const PartBox& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  void widen(double by) {
    low.array() -= by;
    high.array() += by;
  }
  [[nodiscard]] bool meets(const PartBox& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  /// Box around this one in another frame.
  [[nodiscard]] PartBox moved(const Pose<double>& X) const {
    const Vector2d middle = X * Vector2d((low + high) / 2);
    const Vector2d half = (high - low) / 2;
    const Vector2d x = X.R_WB * Vector2d(half.x(), 0);
    const Vector2d y = X.R_WB * Vector2d(0, half.y());
    const Vector2d reach = x.cwiseAbs() + y.cwiseAbs();
    PartBox box;
    box.low = middle - reach;
    box.high = middle + reach;
    return box;
  }
  [[nodiscard]] double squared_distance_to(const Vector2d& p) const {
    return (low - p).cwiseMax(p - high).cwiseMax(0).squaredNorm();
  }
  [[nodiscard]] double extent() const { return (high - low).sum(); }
};

/// A polyline with a binary tree of boxes around its parts, each between two neighbouring features of one
/// span.
class Polyline {
public:
  explicit Polyline(Features features);

  static constexpr std::size_t kPartsOfLeaf = 4;  ///< at most

  struct Node {
    std::size_t begin = 0, end = 0;  ///< parts
    /// Index of the node of the second half, that of the first half being the next one; 0: a leaf.
    std::size_t second = 0;
    PartBox box;
  };
  [[nodiscard]] const Features& features() const { return features_; }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const Node& node(std::size_t i) const { return nodes_[i]; }
  [[nodiscard]] const Feature& from(std::size_t part) const { return features_[begins_[part]]; }
  [[nodiscard]] const Feature& to(std::size_t part) const { return features_[begins_[part] + 1]; }
  [[nodiscard]] PartBox box_of(std::size_t part) const { return {from(part).at, to(part).at}; }

  /// The place nearest to a point on all parts; of equally near ones, that on the first part.
  [[nodiscard]] Feature nearest(const Vector2d& p) const;

private:
  struct Nearest;

  void look_at(std::size_t index, const Vector2d& p, Nearest& nearest) const;
  [[nodiscard]] Feature foot_on(std::size_t part, const Vector2d& p) const;
  std::size_t add(std::size_t begin, std::size_t end);

  Features features_;
  std::vector<std::size_t> begins_;
  std::vector<Node> nodes_;
};

/// Calls f for the pairs of leaves of two trees that may be wanted.
/// \param may  whether pairs of their parts may be wanted, given the indices of a node of each tree
template <class May, class F>
void for_each_pair_of_leaves(const Polyline& one, const Polyline& two, const May& may, const F& f,
                             std::size_t first = 0, std::size_t second = 0) {
  if (!may(first, second)) {
    return;
  }
  const Polyline::Node& a = one.node(first);
  const Polyline::Node& b = two.node(second);
  const auto go_on = [&](std::size_t i, std::size_t k) { for_each_pair_of_leaves(one, two, may, f, i, k); };
  if (a.second == 0 && b.second == 0) {
    f(a, b);
  } else if (b.second == 0 || (a.second != 0 && a.box.extent() >= b.box.extent())) {
    go_on(first + 1, second);
    go_on(a.second, second);
  } else {
    go_on(first, second + 1);
    go_on(first, b.second);
  }
}

/// Where two polylines cross, or nearly do.
struct PolylineCrossing {
  std::array<std::size_t, 2> parts;
  std::array<BoundaryPlace, 2> places;
};

/// All crossings of one polyline with another placed by X_12, in the order of their parts. The cost grows
/// about in proportion to the numbers of parts and of crossings.
[[nodiscard]] std::vector<PolylineCrossing> polyline_crossings(const Polyline& one, const Polyline& two,
                                                               const Pose<double>& X_12);

}  // namespace higherpair

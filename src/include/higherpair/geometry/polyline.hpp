#pragma once

#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/tolerances.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

// Plane curves given by points along them, with a tree of boxes for searches.

namespace higherpair {

/// A point of a boundary's plane curve, scaled to lengths, and the place on the boundary that it belongs to.
struct Feature {
  Vector2d at;
  BoundaryPlace place;
};

using Features = std::vector<Feature>;

/// The place at this share of the way from a to b, which are on one span.
[[nodiscard]] inline BoundaryPlace between(const Feature& a, const Feature& b, double share) {
  return {a.place.span, a.place.t + share * (b.place.t - a.place.t)};
}

/// A box with sides along the axes.
using PartBox = Eigen::AlignedBox2d;

/// Widened by a length on every side.
[[nodiscard]] inline PartBox widened(const PartBox& box, double by) {
  return {box.min() - Vector2d::Constant(by), box.max() + Vector2d::Constant(by)};
}

/// Around a box in another frame.
[[nodiscard]] inline PartBox moved(const PartBox& box, const Pose<double>& X) {
  const Vector2d middle = X * box.center();
  const Vector2d half = box.sizes() / 2;
  const Vector2d x = X.R_WB * Vector2d(half.x(), 0);
  const Vector2d y = X.R_WB * Vector2d(0, half.y());
  const Vector2d reach = x.cwiseAbs() + y.cwiseAbs();
  return {middle - reach, middle + reach};
}

/// Around the part of a curve between two neighbouring points a and b of it, with its slack.
[[nodiscard]] inline PartBox box_of_part(const Vector2d& a, const Vector2d& b) {
  return widened({a.cwiseMin(b), a.cwiseMax(b)}, kSlackOfPart * (b - a).norm());
}

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
  [[nodiscard]] PartBox box_of(std::size_t part) const { return box_of_part(from(part).at, to(part).at); }

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
  } else if (b.second == 0 || (a.second != 0 && a.box.sizes().sum() >= b.box.sizes().sum())) {
    go_on(first + 1, second);
    go_on(a.second, second);
  } else {
    go_on(first, second + 1);
    go_on(first, b.second);
  }
}

/// Where the segments from a to a + da and from b to b + db cross, as fractions of both, in [-slack, 1 +
/// slack].
[[nodiscard]] std::optional<Vector2d> shares_of_crossing(const Vector2d& a, const Vector2d& da,
                                                         const Vector2d& b, const Vector2d& db, double slack);

/// Where two polylines cross, or nearly do.
struct PolylineCrossing {
  std::array<std::size_t, 2> parts;
  std::array<BoundaryPlace, 2> places;
};

/// Crossings of one polyline with another placed by X_12, in the order of their parts. The cost grows about
/// in proportion to the numbers of parts and of crossings. \param most  if set, the search ends once it has
/// found so many
[[nodiscard]] std::vector<PolylineCrossing> polyline_crossings(
    const Polyline& one, const Polyline& two, const Pose<double>& X_12,
    std::optional<std::size_t> most = std::nullopt);

}  // namespace higherpair

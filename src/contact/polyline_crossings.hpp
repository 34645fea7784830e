#pragma once

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

// Plane curves given by points along them: where two of them cross, or nearly do, and the nearest point.

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

/// Where two short segments cross, or nearly do, as fractions of both.
[[nodiscard]] inline std::optional<Vector2d> shares_of_crossing(const Vector2d& a, const Vector2d& da,
                                                                const Vector2d& b, const Vector2d& db) {
  const double det = cross(da, db);
  if (det == 0) {
    return std::nullopt;
  }
  const Vector2d d = b - a;
  const Vector2d shares(cross(d, db) / det, cross(d, da) / det);
  const bool near = (shares.array() >= -kSlackOfPart).all() && (shares.array() <= 1 + kSlackOfPart).all();
  return near ? std::optional(Vector2d(shares.cwiseMax(0).cwiseMin(1))) : std::nullopt;
}

/// Box around the part from a to b, widened by its slack, or around several parts.
struct PartBox {
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
  Vector2d high = -low;

  PartBox() = default;
  PartBox(const Vector2d& a, const Vector2d& b) : low(a.cwiseMin(b)), high(a.cwiseMax(b)) {
    const double slack = kSlackOfPart * (b - a).norm();
    low.array() -= slack;
    high.array() += slack;
  }
  void extend(const PartBox& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  /// \param shift  of the other box
  [[nodiscard]] bool meets(const PartBox& other, const Vector2d& shift) const {
    return (low.array() <= (other.high + shift).array()).all() &&
           ((other.low + shift).array() <= high.array()).all();
  }
  [[nodiscard]] double squared_distance_to(const Vector2d& p) const {
    return (low - p).cwiseMax(p - high).cwiseMax(0).squaredNorm();
  }
  [[nodiscard]] double extent() const { return (high - low).sum(); }
};

/// Binary tree of boxes around the parts, each between two neighbouring features of one span.
class PartTree {
public:
  explicit PartTree(const Features& features) : features_(features) {
    for (std::size_t i = 1; i < features.size(); ++i) {
      if (features[i - 1].place.span == features[i].place.span) {
        begins_.push_back(i - 1);
      }
    }
    nodes_.reserve(begins_.size());
    add(0, begins_.size());
  }

  struct Node {
    std::size_t begin = 0, end = 0;  ///< parts
    /// Index of the node of the second half, that of the first half being the next one; 0: a leaf.
    std::size_t second = 0;
    PartBox box;
  };
  [[nodiscard]] const Node& node(std::size_t i) const { return nodes_[i]; }
  [[nodiscard]] const Feature& from(std::size_t part) const { return features_[begins_[part]]; }
  [[nodiscard]] const Feature& to(std::size_t part) const { return features_[begins_[part] + 1]; }
  [[nodiscard]] PartBox box_of(std::size_t part) const { return {from(part).at, to(part).at}; }

  /// The place nearest to a point on all parts; of equally near ones, that on the first part.
  [[nodiscard]] Feature nearest(const Vector2d& p) const {
    Nearest nearest;
    look_at(0, p, nearest);
    return nearest.feature;
  }

private:
  struct Nearest {
    Feature feature;
    std::size_t part = 0;
    double distance2 = std::numeric_limits<double>::infinity();
  };

  void look_at(std::size_t index, const Vector2d& p, Nearest& nearest) const {
    const Node& here = nodes_[index];
    if (here.box.squared_distance_to(p) > nearest.distance2) {
      return;
    }
    if (here.second != 0) {
      const bool first_is_nearer =
          nodes_[index + 1].box.squared_distance_to(p) <= nodes_[here.second].box.squared_distance_to(p);
      look_at(first_is_nearer ? index + 1 : here.second, p, nearest);
      look_at(first_is_nearer ? here.second : index + 1, p, nearest);
      return;
    }
    for (std::size_t part = here.begin; part < here.end; ++part) {
      const Feature foot = foot_on(part, p);
      const double distance2 = (foot.at - p).squaredNorm();
      if (distance2 < nearest.distance2 || (distance2 == nearest.distance2 && part < nearest.part)) {
        nearest = {foot, part, distance2};
      }
    }
  }

  // The place of a part that is nearest to a point; its ends without rounding, because neighbours share them.
  [[nodiscard]] Feature foot_on(std::size_t part, const Vector2d& p) const {
    const Vector2d along = to(part).at - from(part).at;
    const double share = along.dot(p - from(part).at) / along.squaredNorm();
    if (!(share > 0)) {
      return from(part);
    }
    return share < 1 ? Feature{from(part).at + share * along, between(from(part), to(part), share)}
                     : to(part);
  }

  static constexpr std::size_t kPartsOfBlock = 4;

  std::size_t add(std::size_t begin, std::size_t end) {
    const std::size_t index = nodes_.size();
    nodes_.push_back({begin, end, 0, {}});
    PartBox box;
    if (end - begin <= kPartsOfBlock) {
      for (std::size_t part = begin; part < end; ++part) {
        box.extend(box_of(part));
      }
    } else {
      const std::size_t middle = begin + (end - begin) / 2;
      box = nodes_[add(begin, middle)].box;
      nodes_[index].second = add(middle, end);
      box.extend(nodes_[nodes_[index].second].box);
    }
    nodes_[index].box = box;
    return index;
  }

  const Features& features_;
  std::vector<std::size_t> begins_;
  std::vector<Node> nodes_;
};

/// Collects the pairs of parts whose boxes meet, those of the second tree shifted.
class MeetingParts {
public:
  MeetingParts(const PartTree& one, const PartTree& two, std::vector<std::array<std::size_t, 2>>& found)
      : one_(one), two_(two), found_(found) {}

  void visit(std::size_t first, std::size_t second, const Vector2d& shift) {
    const PartTree::Node& a = one_.node(first);
    const PartTree::Node& b = two_.node(second);
    if (!a.box.meets(b.box, shift)) {
      return;
    }
    if (a.second == 0 && b.second == 0) {
      for (std::size_t i = a.begin; i < a.end; ++i) {
        for (std::size_t k = b.begin; k < b.end; ++k) {
          if (one_.box_of(i).meets(two_.box_of(k), shift)) {
            found_.push_back({i, k});
          }
        }
      }
    } else if (b.second == 0 || (a.second != 0 && a.box.extent() >= b.box.extent())) {
      visit(first + 1, second, shift);
      visit(a.second, second, shift);
    } else {
      visit(first, second + 1, shift);
      visit(first, b.second, shift);
    }
  }

private:
  const PartTree& one_;
  const PartTree& two_;
  std::vector<std::array<std::size_t, 2>>& found_;
};

/// Calls found(place1, place2) for each crossing of two polylines, in their order. The cost grows about in
/// proportion to the numbers of parts and of crossings. \param period  of the first coordinate; 0: none
template <class F>
void for_each_crossing(const Features& features1, const Features& features2, double period, const F& found) {
  const PartTree one(features1), two(features2);
  const PartBox &box1 = one.node(0).box, &box2 = two.node(0).box;
  const double first = period == 0 ? 0 : std::ceil((box1.low.x() - box2.high.x()) / period);
  const double last = period == 0 ? 0 : std::floor((box1.high.x() - box2.low.x()) / period);
  std::vector<std::array<std::size_t, 2>> pairs;
  for (double turns = first; turns <= last; ++turns) {
    MeetingParts(one, two, pairs).visit(0, 0, Vector2d(turns * period, 0));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& [i, k] : pairs) {
    const Feature &a1 = one.from(i), &b1 = one.to(i), &a2 = two.from(k), &b2 = two.to(k);
    const double turns = period == 0 ? 0 : std::round((a1.at.x() - a2.at.x()) / period);
    const Vector2d shift(turns * period, 0);
    if (const auto shares = shares_of_crossing(a1.at, b1.at - a1.at, a2.at + shift, b2.at - a2.at)) {
      found(between(a1, b1, shares->x()), between(a2, b2, shares->y()));
    }
  }
}

}  // namespace higherpair

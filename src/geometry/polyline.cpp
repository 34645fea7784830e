#include "higherpair/geometry/polyline.hpp"

#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace higherpair {

Polyline::Polyline(Features features) : features_(std::move(features)) {
  for (std::size_t i = 1; i < features_.size(); ++i) {
    if (features_[i - 1].place.span == features_[i].place.span) {
      begins_.push_back(i - 1);
    }
  }
  nodes_.reserve(begins_.size());
  add(0, begins_.size());
}

std::size_t Polyline::add(std::size_t begin, std::size_t end) {
  const std::size_t index = nodes_.size();
  nodes_.push_back({begin, end, 0, {}});
  PartBox box;
  if (end - begin <= kPartsOfLeaf) {
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

struct Polyline::Nearest {
  Feature feature;
  std::size_t part = 0;
  double distance2 = kInf;
};

Feature Polyline::nearest(const Vector2d& p) const {
  Nearest nearest;
  look_at(0, p, nearest);
  return nearest.feature;
}

void Polyline::look_at(std::size_t index, const Vector2d& p, Nearest& nearest) const {
  const Node& here = nodes_[index];
  if (here.box.squaredExteriorDistance(p) > nearest.distance2) {
    return;
  }
  if (here.second != 0) {
    const bool first_is_nearer = nodes_[index + 1].box.squaredExteriorDistance(p) <=
                                 nodes_[here.second].box.squaredExteriorDistance(p);
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
Feature Polyline::foot_on(std::size_t part, const Vector2d& p) const {
  const Vector2d along = to(part).at - from(part).at;
  const double share = along.dot(p - from(part).at) / along.squaredNorm();
  if (!(share > 0)) {
    return from(part);
  }
  return share < 1 ? Feature{from(part).at + share * along, between(from(part), to(part), share)} : to(part);
}

namespace {

// Calls f for the pairs of parts whose boxes meet, until `enough` returns true.
template <class Enough, class F>
void for_meeting_parts(const Polyline& one, const Polyline& two, const Pose<double>& X_12,
                       const Enough& enough, const F& f) {
  const auto may_meet = [&](std::size_t first, std::size_t second) {
    return !enough() && one.node(first).box.intersects(moved(two.node(second).box, X_12));
  };
  for_each_pair_of_leaves(one, two, may_meet, [&](const Polyline::Node& a, const Polyline::Node& b) {
    std::array<PartBox, Polyline::kPartsOfLeaf> boxes;
    for (std::size_t i = a.begin; i < a.end; ++i) {
      boxes[i - a.begin] = one.box_of(i);
    }
    for (std::size_t k = b.begin; k < b.end; ++k) {
      const PartBox box = box_of_part(X_12 * two.from(k).at, X_12 * two.to(k).at);
      for (std::size_t i = a.begin; i < a.end; ++i) {
        if (boxes[i - a.begin].intersects(box)) {
          f(std::array{i, k});
        }
      }
    }
  });
}

std::optional<PolylineCrossing> crossing_of(const Polyline& one, const Polyline& two,
                                            const Pose<double>& X_12,
                                            const std::array<std::size_t, 2>& parts) {
  const auto [i, k] = parts;
  const Vector2d a = one.from(i).at;
  const Vector2d b = X_12 * two.from(k).at;
  const auto found = shares_of_crossing(a, one.to(i).at - a, b, X_12 * two.to(k).at - b, kSlackOfPart);
  if (!found) {
    return std::nullopt;
  }
  const Vector2d shares = found->cwiseMax(0).cwiseMin(1);
  return PolylineCrossing{
      parts, {between(one.from(i), one.to(i), shares.x()), between(two.from(k), two.to(k), shares.y())}};
}

}  // namespace

std::optional<Vector2d> shares_of_crossing(const Vector2d& a, const Vector2d& da, const Vector2d& b,
                                           const Vector2d& db, double slack) {
  const double det = cross(da, db);
  if (det == 0) {
    return std::nullopt;
  }
  const Vector2d d = b - a;
  const Vector2d shares(cross(d, db) / det, cross(d, da) / det);
  const bool on_both = (shares.array() >= -slack).all() && (shares.array() <= 1 + slack).all();
  return on_both ? std::optional(shares) : std::nullopt;
}

std::vector<PolylineCrossing> polyline_crossings(const Polyline& one, const Polyline& two,
                                                 const Pose<double>& X_12, std::optional<std::size_t> most) {
  std::vector<PolylineCrossing> crossings;
  const auto enough = [&] { return most && crossings.size() >= *most; };
  for_meeting_parts(one, two, X_12, enough, [&](const auto& parts) {
    if (const auto crossing = crossing_of(one, two, X_12, parts)) {
      crossings.push_back(*crossing);
    }
  });
  std::sort(crossings.begin(), crossings.end(),
            [](const PolylineCrossing& a, const PolylineCrossing& b) { return a.parts < b.parts; });
  return crossings;
}

}  // namespace higherpair

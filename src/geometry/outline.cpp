#include "higherpair/geometry/outline.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace higherpair {
namespace {

Features points_of(const std::vector<Boundary::Sample>& samples) {
  Features points;
  points.reserve(samples.size());
  for (const Boundary::Sample& sample : samples) {
    points.push_back({sample.point.p_B, sample.place});
  }
  return points;
}

NormalCone cone_around(std::span<const NormalCone> cones) {
  Vector2d sum = Vector2d::Zero();
  for (const NormalCone& cone : cones) {
    sum += cone.middle;
  }
  const double norm = sum.norm();
  if (norm == 0) {
    return {};
  }
  NormalCone all{sum / norm, 0};
  for (const NormalCone& cone : cones) {
    all.chord = std::max(all.chord, (cone.middle - all.middle).norm() + cone.chord);
  }
  return all;
}

}  // namespace

NormalCone cone_between(const Vector2d& a, const Vector2d& b) {
  NormalCone cone = cone_around(std::array{NormalCone{a, 0}, NormalCone{b, 0}});
  cone.chord *= 1 + kSlackOfNormals;
  return cone;
}

Outline::Outline(const std::vector<Boundary::Sample>& samples, std::vector<Polyline> solids)
    : polyline_(points_of(samples)), solids_(std::move(solids)) {
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i - 1].place.span == samples[i].place.span) {
      of_parts_.push_back(cone_between(samples[i - 1].point.n_B, samples[i].point.n_B));
    }
  }
  // The nodes below one come after it.
  of_nodes_.resize(polyline_.nodes().size());
  for (std::size_t i = of_nodes_.size(); i-- > 0;) {
    const Polyline::Node& node = polyline_.node(i);
    of_nodes_[i] = node.second == 0
                       ? cone_around(std::span(of_parts_).subspan(node.begin, node.end - node.begin))
                       : cone_around(std::array{of_nodes_[i + 1], of_nodes_[node.second]});
  }
}

}  // namespace higherpair

#include "boundary_foot.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "polyline_crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace higherpair {
namespace {

// Depth of a point in a body [m], to the nearest place of its boundary; < 0 outside. -∞ beside the ends of an
// open boundary, where it is not defined.
struct Depth {
  double depth = -std::numeric_limits<double>::infinity();
  BoundaryPlace place;
};

// Start of the search for the foot of a point, from the nearest place between samples. At a corner, a point
// in front of none of its normals belongs to the neighbouring span on that side.
BoundaryPlace first_guess(const Boundary& boundary, const Feature& nearest, const Vector2d& p_B) {
  const int span = nearest.place.span;
  if (!boundary.is_corner(nearest.place)) {
    return nearest.place;
  }
  const Bounds range = range_of(boundary, span);
  const double middle = (range.low + range.high) / 2;
  const double turn = nearest_turn(angle_of(p_B - nearest.at) - middle, 0);
  if (std::abs(turn) <= range.width() / 2) {
    return {span, middle + turn};
  }
  const int before = boundary.next_span(span, false);
  const bool forward = boundary.joint_after(before) == SpanJoint::kEnd ||
                       (turn > 0 && boundary.joint_after(span) != SpanJoint::kEnd);
  const int next = forward ? boundary.next_span(span, true) : before;
  return end_of(boundary, next, !forward);
}

Depth depth_in(const Boundary& boundary, const PartTree& samples, const Vector2d& p_B) {
  const auto foot = foot_near(boundary, p_B, first_guess(boundary, samples.nearest(p_B), p_B), kNearFoot);
  if (!foot) {
    return {};
  }
  const SpanPoint point = boundary.at(*foot);
  return {(point.p_B - p_B).dot(point.n_B), *foot};
}

// A body, prepared for queries of how deep points are in it.
class Inside {
public:
  Inside(const Boundary& boundary, const Pose<double>& X_WB)
      : boundary_(boundary), X_WB_(X_WB), points_(features_of(boundary)), samples_(points_) {}

  [[nodiscard]] const Boundary& boundary() const { return boundary_; }
  [[nodiscard]] const Pose<double>& X_WB() const { return X_WB_; }
  /// Its samples, in its frame.
  [[nodiscard]] const Features& points() const { return points_; }
  [[nodiscard]] Depth depth_of(const Vector2d& p_W) const {
    return depth_in(boundary_, samples_, X_WB_.inverse_times(p_W));
  }

private:
  static Features features_of(const Boundary& boundary) {
    Features points;
    for (const auto& [place, point] : boundary.samples()) {
      points.push_back({point.p_B, place});
    }
    return points;
  }

  const Boundary& boundary_;
  const Pose<double>& X_WB_;
  Features points_;
  PartTree samples_;
};

using Places = std::vector<BoundaryPlace>;

// Where the outlines of two bodies cross, as places on each.
std::array<Places, 2> crossings_of(const Inside& one, const Inside& two) {
  const Pose<double> X_12{one.X_WB().R_WB.inverse() * two.X_WB().R_WB,
                          one.X_WB().inverse_times(two.X_WB().p_WB)};
  Features points2 = two.points();
  for (Feature& point : points2) {
    point.at = X_12 * point.at;
  }
  std::array<Places, 2> crossings;
  for_each_crossing(one.points(), points2, 0, [&](const BoundaryPlace& place1, const BoundaryPlace& place2) {
    crossings[0].push_back(place1);
    crossings[1].push_back(place2);
  });
  return crossings;
}

// The samples of a body, and one point of each part into which the other body's outline cuts the boundary
// between two of them: such a part is inside or outside of the other body as a whole, whatever its ends are.
Features points_between(const Inside& own, Places cuts) {
  const auto is_before = [](const BoundaryPlace& a, const BoundaryPlace& b) {
    return a.span != b.span ? a.span < b.span : a.t < b.t;
  };
  std::sort(cuts.begin(), cuts.end(), is_before);
  Features points;
  auto cut = cuts.begin();
  for (const Feature& sample : own.points()) {
    BoundaryPlace from = points.empty() ? sample.place : points.back().place;
    const auto add_up_to = [&](const BoundaryPlace& to) {
      const BoundaryPlace middle{to.span, (from.t + to.t) / 2};
      if (from.span == to.span && from.t < middle.t && middle.t < to.t) {
        points.push_back({own.boundary().at(middle).p_B, middle});
      }
      from = to;
    };
    const auto first = cut;
    for (; cut != cuts.end() && is_before(*cut, sample.place); ++cut) {
      add_up_to(*cut);
    }
    if (cut != first) {
      add_up_to(sample.place);
    }
    points.push_back(sample);
  }
  return points;
}

// Points of a boundary, in order, with their depth in another body; -∞ far from it.
struct PointDepth {
  Feature point;
  Depth depth;
};

std::vector<PointDepth> depths_of(const Inside& own, const Places& cuts, const Inside& other) {
  const Vector2d middle_B = own.X_WB().inverse_times(other.X_WB() * other.boundary().middle_B());
  const double reach = other.boundary().size() * (1 + kBesideBody) + kBesideBody * own.boundary().size();
  std::vector<PointDepth> depths;
  for (const Feature& point : points_between(own, cuts)) {
    const bool near = (point.at - middle_B).squaredNorm() <= reach * reach;
    depths.push_back({point, near ? other.depth_of(own.X_WB() * point.at) : Depth{}});
  }
  return depths;
}

// Calls f for every point that is deeper than its neighbours and near which the curve may be in the other
// body.
template <class F>
void for_deepest(const std::vector<PointDepth>& depths, const F& f) {
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const PointDepth& before = depths[i == 0 ? depths.size() - 1 : i - 1];
    const PointDepth& after = depths[i + 1 == depths.size() ? 0 : i + 1];
    const double depth = depths[i].depth.depth;
    const double spacing =
        std::max((depths[i].point.at - before.point.at).norm(), (depths[i].point.at - after.point.at).norm());
    if (depth >= before.depth.depth && depth >= after.depth.depth && depth > -spacing) {
      f(depths[i]);
    }
  }
}

}  // namespace

Penetration deepest_penetration(const Boundary& boundary1, const Pose<double>& X_W1,
                                const Boundary& boundary2, const Pose<double>& X_W2, double tolerance) {
  const Inside one(boundary1, X_W1);
  const Inside two(boundary2, X_W2);
  Penetration worst;
  worst.depth = tolerance;
  const auto look = [&](double found, const BoundaryPlace& place1, const BoundaryPlace& place2) {
    Penetration here{found, place1, place2};
    const auto normal = find_boundary_normal(boundary1, X_W1, boundary2, X_W2, place1, place2);
    if (normal && -normal->at.gap() > here.depth) {
      // Behind one face of a thin body a point may be out of the body again.
      const double depth = std::min(-normal->at.gap(), one.depth_of(normal->at.p2_W).depth);
      here = depth > here.depth ? Penetration{depth, normal->place1, normal->place2} : here;
    }
    worst = here.depth > worst.depth ? here : worst;
  };
  const auto crossings = crossings_of(one, two);
  for_deepest(depths_of(one, crossings[0], two), [&](const PointDepth& found) {
    look(found.depth.depth, found.point.place, found.depth.place);
  });
  for_deepest(depths_of(two, crossings[1], one), [&](const PointDepth& found) {
    look(found.depth.depth, found.depth.place, found.point.place);
  });
  worst.depth = worst.depth > tolerance ? worst.depth : 0;
  return worst;
}

}  // namespace higherpair

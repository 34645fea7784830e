#include "boundary_foot.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/outline.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace higherpair {
namespace {

// Depth of a point in a body [m], to the nearest place of its boundary; < 0 outside. -∞ beside the ends of an
// open boundary, where it is not defined.
struct Depth {
  double depth = -kInf;
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

// A body in its pose.
struct PlacedBoundary {
  const Boundary& boundary;
  const Pose<double>& X_WB;
};

// To the part of the boundary near a feature.
Depth depth_near(const Feature& nearest, const Boundary& boundary, const Vector2d& p_B) {
  const auto foot = foot_near(boundary, p_B, first_guess(boundary, nearest, p_B), kNearFoot);
  if (!foot) {
    return {};
  }
  const SpanPoint point = boundary.at(*foot);
  return {(point.p_B - p_B).dot(point.n_B), *foot};
}

// Where parts of the body overlap, the depth in the part in which the point is deepest.
Depth depth_in(const PlacedBoundary& body, const Vector2d& p_W) {
  const Outline& outline = outline_of(body.boundary);
  const Vector2d p_B = body.X_WB.inverse_times(p_W);
  Depth deepest = depth_near(outline.polyline().nearest(p_B), body.boundary, p_B);
  for (const Polyline& solid : outline.solids()) {
    if (solid.node(0).box.contains(p_B)) {
      const Depth depth = depth_near(solid.nearest(p_B), body.boundary, p_B);
      deepest = depth.depth > deepest.depth ? depth : deepest;
    }
  }
  return deepest;
}

// One point of each part into which the other body's outline cuts the first or second boundary between two of
// its samples: such a part is inside or outside of the other body as a whole, whatever its ends are.
Features points_beside(const std::vector<PolylineCrossing>& crossings, std::size_t which,
                       const Boundary& own) {
  std::vector<std::pair<std::size_t, double>> cuts;  // part, and parameter on it
  for (const PolylineCrossing& at : crossings) {
    cuts.emplace_back(at.parts[which], at.places[which].t);
  }
  std::sort(cuts.begin(), cuts.end());
  Features points;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const auto [part, t] = cuts[i];
    const BoundaryPlace& begin = outline_of(own).polyline().from(part).place;
    const double end = outline_of(own).polyline().to(part).place.t;
    const auto add = [&](double from, double to) {
      const BoundaryPlace middle{begin.span, (from + to) / 2};
      if (from < middle.t && middle.t < to) {
        points.push_back({own.at(middle).p_B, middle});
      }
    };
    const bool first = i == 0 || cuts[i - 1].first != part;
    const bool last = i + 1 == cuts.size() || cuts[i + 1].first != part;
    add(first ? begin.t : cuts[i - 1].second, t);
    if (last) {
      add(t, end);
    }
  }
  return points;
}

// A point of a boundary with its depth in another body; -∞ far from it.
struct PointDepth {
  Feature point;
  Depth depth;
};

// The samples of a body and points beside its cuts, in order. Once one is deeper than `enough`, the rest keep
// -∞: they are looked at all around the boundary, so that such a point is found early.
std::vector<PointDepth> depths_of(const PlacedBoundary& own, const Features& beside_cuts,
                                  const PlacedBoundary& other, double enough) {
  const Features& samples = outline_of(own.boundary).polyline().features();
  Features points;
  points.reserve(samples.size() + beside_cuts.size());
  std::merge(samples.begin(), samples.end(), beside_cuts.begin(), beside_cuts.end(),
             std::back_inserter(points), [](const Feature& a, const Feature& b) {
               return std::pair(a.place.span, a.place.t) < std::pair(b.place.span, b.place.t);
             });
  const Vector2d middle_B = own.X_WB.inverse_times(other.X_WB * other.boundary.middle_B());
  const double reach = other.boundary.size() * (1 + kBesideBody) + kBesideBody * own.boundary.size();
  std::vector<PointDepth> depths;
  depths.reserve(points.size());
  for (const Feature& point : points) {
    depths.push_back({point, {}});
  }
  constexpr std::size_t kRounds = 16;
  for (std::size_t round = 0; round < kRounds; ++round) {
    for (std::size_t i = round; i < depths.size(); i += kRounds) {
      const Vector2d& at_B = depths[i].point.at;
      if ((at_B - middle_B).squaredNorm() <= reach * reach) {
        depths[i].depth = depth_in(other, own.X_WB * at_B);
      }
      if (depths[i].depth.depth > enough) {
        return depths;
      }
    }
  }
  return depths;
}

bool is_any_deep(const std::vector<PointDepth>& depths, double tolerance) {
  return std::any_of(depths.begin(), depths.end(),
                     [&](const PointDepth& point) { return point.depth.depth > tolerance; });
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

using PointsOfBoth = std::array<Features, 2>;

// \param depths1, depths2  of the points of each body in the other
double find_penetration(const PlacedBoundary& one, const PlacedBoundary& two,
                        const std::vector<PointDepth>& depths1, const std::vector<PointDepth>& depths2,
                        double tolerance) {
  double worst = tolerance;
  const auto look = [&](double found, const BoundaryPlace& place1, const BoundaryPlace& place2) {
    worst = std::max(worst, found);
    const auto normal = find_boundary_normal(one.boundary, one.X_WB, two.boundary, two.X_WB, place1, place2);
    if (normal && -normal->at.gap() > found) {
      // Behind one face of a thin body a point may be out of the body again.
      worst = std::max(worst, std::min(-normal->at.gap(), depth_in(one, normal->at.p2_W).depth));
    }
  };
  for_deepest(depths1, [&](const PointDepth& found) {
    look(found.depth.depth, found.point.place, found.depth.place);
  });
  for_deepest(depths2, [&](const PointDepth& found) {
    look(found.depth.depth, found.depth.place, found.point.place);
  });
  return worst > tolerance ? worst : 0;
}

// Points beside the cuts where the outlines of two bodies cross, all of them or at most so many.
PointsOfBoth points_beside_cuts(const PlacedBoundary& one, const PlacedBoundary& two,
                                std::optional<std::size_t> most = std::nullopt) {
  const Polyline& first = outline_of(one.boundary).polyline();
  const Polyline& second = outline_of(two.boundary).polyline();
  const Pose<double> X_12 = one.X_WB.inverse_times(two.X_WB);
  const auto crossings = polyline_crossings(first, second, X_12, most);
  return {points_beside(crossings, 0, one.boundary), points_beside(crossings, 1, two.boundary)};
}

bool is_any_deep(const PlacedBoundary& one, const PlacedBoundary& two, const PointsOfBoth& points,
                 double tolerance) {
  const auto any = [&](const PlacedBoundary& own, const Features& of_own, const PlacedBoundary& other) {
    return std::any_of(of_own.begin(), of_own.end(), [&](const Feature& point) {
      return depth_in(other, own.X_WB * point.at).depth > tolerance;
    });
  };
  return any(one, points[0], two) || any(two, points[1], one);
}

}  // namespace

double deepest_penetration(const Boundary& boundary1, const Pose<double>& X_W1, const Boundary& boundary2,
                           const Pose<double>& X_W2, double tolerance) {
  const PlacedBoundary one{boundary1, X_W1};
  const PlacedBoundary two{boundary2, X_W2};
  const PointsOfBoth points = points_beside_cuts(one, two);
  return find_penetration(one, two, depths_of(one, points[0], two, kInf),
                          depths_of(two, points[1], one, kInf), tolerance);
}

bool bodies_overlap(const Boundary& boundary1, const Pose<double>& X_W1, const Boundary& boundary2,
                    const Pose<double>& X_W2, double tolerance) {
  const PlacedBoundary one{boundary1, X_W1};
  const PlacedBoundary two{boundary2, X_W2};
  // Bodies that overlap mostly do so at the first places that are found.
  constexpr std::size_t kFirstCuts = 8;
  if (is_any_deep(one, two, points_beside_cuts(one, two, kFirstCuts), tolerance)) {
    return true;
  }
  const PointsOfBoth points = points_beside_cuts(one, two);
  if (is_any_deep(one, two, points, tolerance)) {
    return true;
  }
  const auto depths1 = depths_of(one, points[0], two, tolerance);
  if (is_any_deep(depths1, tolerance)) {
    return true;
  }
  const auto depths2 = depths_of(two, points[1], one, tolerance);
  return is_any_deep(depths2, tolerance) || find_penetration(one, two, depths1, depths2, tolerance) > 0;
}

}  // namespace higherpair

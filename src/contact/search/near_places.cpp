#include "higherpair/contact/near_places.hpp"

#include "boundary_foot.hpp"
#include "common_normals.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kMuchLongerPart = 4;  // than the other one, for a closer look at its normals
constexpr int kMostHalvings = 8;

std::optional<NearPlace> common_normal_near(const Boundary& boundary1, const Pose<double>& X_W1,
                                            const Boundary& boundary2, const Pose<double>& X_W2,
                                            const BoundaryPlace& place1, const BoundaryPlace& place2) {
  const auto found = find_boundary_normal(boundary1, X_W1, boundary2, X_W2, place1, place2);
  if (!found || !is_least_gap(found->at)) {
    return std::nullopt;
  }
  return NearPlace{found->at, found->place1, found->place2, 0};
}

// Whether an end is a corner whose normals include an outward normal: then the contact is one of a common
// normal.
bool is_on_edge(const Boundary& boundary, const BoundaryPlace& end, const Vector2d& n_B) {
  if (!boundary.is_corner(end)) {
    return false;
  }
  const Bounds range = range_of(boundary, end.span);
  return std::abs(nearest_turn(angle_of(n_B) - (range.low + range.high) / 2, 0)) <= range.width() / 2;
}

// Boundary `own`, whose number is `end`, with its ends opposite the boundary `other`.
struct EndOver {
  const Boundary* own;
  const Pose<double>* X_WO;
  const Boundary* other;
  const Pose<double>* X_WC;
  int end;
};

std::optional<NearPlace> end_near(const EndOver& over, const BoundaryPlace& end, const BoundaryPlace& near) {
  const Vector2d p_W = *over.X_WO * over.own->at(end).p_B;
  const auto foot = foot_near(*over.other, over.X_WC->inverse_times(p_W), near, kAtFoot);
  if (!foot) {
    return std::nullopt;
  }
  const SpanPoint point = over.other->at(*foot);
  if (is_on_edge(*over.own, end, over.X_WO->R_WB.inverse() * Vector2d(-(over.X_WC->R_WB * point.n_B)))) {
    return std::nullopt;
  }
  const double rho = radius_of(point, over.other->is_corner(*foot));
  const NearPlace place{{-(over.X_WC->R_WB * point.n_B), p_W, *over.X_WC * point.p_B, 0, rho}, end, *foot, 1};
  if (over.end == 1) {
    return place;
  }
  return NearPlace{place.at.exchanged(), place.place2, place.place1, 2};
}

// Adds the ends of an open boundary that are near the other one.
void add_ends(const EndOver& over, double reach, std::vector<NearPlace>& places) {
  const Boundary& own = *over.own;
  const auto add = [&](const BoundaryPlace& end) {
    const Vector2d p_C = over.X_WC->inverse_times(*over.X_WO * own.at(end).p_B);
    const auto place = end_near(over, end, outline_of(*over.other).polyline().nearest(p_C).place);
    if (place && std::abs(place->at.gap()) <= reach) {
      places.push_back(*place);
    }
  };
  for (int span = 0; span < static_cast<int>(own.spans().size()); ++span) {
    if (own.joint_after(span) == SpanJoint::kEnd) {
      add(end_of(own, span, true));
    }
    if (own.joint_after(own.next_span(span, false)) == SpanJoint::kEnd) {
      add(end_of(own, span, false));
    }
  }
}

// A part between two neighbouring samples, in the frame of body 1.
struct Part {
  const Boundary& boundary;
  const Pose<double>& X_1B;
  Feature from, to;
  NormalCone normals;

  [[nodiscard]] Vector2d middle() const { return (from.at + to.at) / 2; }
  [[nodiscard]] double length() const { return (to.at - from.at).norm(); }
  [[nodiscard]] BoundaryPlace place_nearest(const Vector2d& p) const {
    const Vector2d along = to.at - from.at;
    const double squared = along.squaredNorm();
    return between(from, to, squared > 0 ? std::clamp((p - from.at).dot(along) / squared, 0.0, 1.0) : 0.5);
  }
};

// Whether the line between points of two parts may be along their normal, which is in this cone: where it
// turns within the cone, part of the distance counts as across it.
bool may_be_along(const NormalCone& normals, const Part& a, const Part& b) {
  const Vector2d apart = b.middle() - a.middle();
  const double lengths = a.length() + b.length();
  return std::abs(cross(normals.middle, apart)) <=
         (0.5 + kSlackOfPart) * lengths + normals.chord * apart.norm();
}

// The normals within either half of a part turn less than those of the whole.
std::array<Part, 2> halves_of(const Part& part) {
  const BoundaryPlace place = between(part.from, part.to, 0.5);
  const SpanPoint middle = part.boundary.at(place);
  const Feature at{part.X_1B * middle.p_B, place};
  const auto normals = [&](const Feature& end) {
    const NormalCone cone = cone_between(part.boundary.at(end.place).n_B, middle.n_B);
    return NormalCone{part.X_1B.R_WB * cone.middle, cone.chord};
  };
  return {Part{part.boundary, part.X_1B, part.from, at, normals(part.from)},
          Part{part.boundary, part.X_1B, at, part.to, normals(part.to)}};
}

// Whether two parts, whose normals may be opposed, may have points with a common normal, at most `reach`
// apart. Of a part that is much longer than the other one the halves are looked at, and theirs.
bool may_face(const Part& a, const Part& b, double reach, int halvings = kMostHalvings) {
  if ((b.middle() - a.middle()).norm() > reach + a.length() + b.length() || !may_be_along(a.normals, a, b) ||
      !may_be_along(b.normals, a, b)) {
    return false;
  }
  const bool first = a.length() > kMuchLongerPart * b.length();
  if (halvings == 0 || (!first && b.length() <= kMuchLongerPart * a.length())) {
    return true;
  }
  const std::array<Part, 2> halves = halves_of(first ? a : b);
  return std::any_of(halves.begin(), halves.end(), [&](const Part& half) {
    const Part &one = first ? half : a, &two = first ? b : half;
    return may_be_opposed(one.normals, two.normals, {}) && may_face(one, two, reach, halvings - 1);
  });
}

// Finds the pairs of parts of two boundaries that may have points with a common normal, at most `reach`
// apart.
class FacingParts {
public:
  FacingParts(const Boundary& one, const Boundary& two, const Pose<double>& X_12, double reach)
      : boundary1_(one),
        boundary2_(two),
        one_(outline_of(one)),
        two_(outline_of(two)),
        X_12_(X_12),
        reach_(reach) {}

  /// Calls f with a place on each part.
  template <class F>
  void for_each(const F& f) const {
    const auto may = [&](std::size_t first, std::size_t second) { return nodes_may_face(first, second); };
    for_each_pair_of_leaves(one_.polyline(), two_.polyline(), may,
                            [&](const Polyline::Node& a, const Polyline::Node& b) {
                              for (std::size_t i = a.begin; i < a.end; ++i) {
                                for (std::size_t k = b.begin; k < b.end; ++k) {
                                  visit(i, k, f);
                                }
                              }
                            });
  }

private:
  [[nodiscard]] bool nodes_may_face(std::size_t first, std::size_t second) const {
    const PartBox box = widened(moved(two_.polyline().node(second).box, X_12_), reach_);
    return one_.polyline().node(first).box.intersects(box) &&
           may_be_opposed(one_.normals_of_node(first), two_.normals_of_node(second), X_12_.R_WB);
  }

  template <class F>
  void visit(std::size_t i, std::size_t k, const F& f) const {
    const NormalCone& normals1 = one_.normals_of_part(i);
    const NormalCone& normals2 = two_.normals_of_part(k);
    if (!may_be_opposed(normals1, normals2, X_12_.R_WB)) {
      return;
    }
    const auto moved = [&](const Feature& of2) { return Feature{X_12_ * of2.at, of2.place}; };
    const Part a{boundary1_, X_11_, one_.polyline().from(i), one_.polyline().to(i), normals1};
    const Part b{boundary2_,
                 X_12_,
                 moved(two_.polyline().from(k)),
                 moved(two_.polyline().to(k)),
                 {X_12_.R_WB * normals2.middle, normals2.chord}};
    if (may_face(a, b, reach_)) {
      f(a.place_nearest(b.middle()), b.place_nearest(a.middle()));
    }
  }

  const Boundary& boundary1_;
  const Boundary& boundary2_;
  const Outline& one_;
  const Outline& two_;
  const Pose<double> X_11_;
  const Pose<double>& X_12_;
  double reach_;
};

}  // namespace

std::vector<NearPlace> near_places(const Boundary& boundary1, const Pose<double>& X_W1,
                                   const Boundary& boundary2, const Pose<double>& X_W2, double reach) {
  const Pose<double> X_12 = X_W1.inverse_times(X_W2);
  const double same = kSameNearPlace * (boundary1.size() + boundary2.size());
  std::vector<NearPlace> places;
  const FacingParts facing(boundary1, boundary2, X_12, reach);
  facing.for_each([&](const BoundaryPlace& place1, const BoundaryPlace& place2) {
    const auto found = common_normal_near(boundary1, X_W1, boundary2, X_W2, place1, place2);
    if (!found || std::abs(found->at.gap()) > reach) {
      return;
    }
    const bool known = std::any_of(places.begin(), places.end(), [&](const NearPlace& other) {
      return (other.at.p1_W - found->at.p1_W).norm() + (other.at.p2_W - found->at.p2_W).norm() <= same &&
             (other.at.n_W - found->at.n_W).norm() <= kSameNormalOfPlace;
    });
    if (!known) {
      places.push_back(*found);
    }
  });
  add_ends({&boundary1, &X_W1, &boundary2, &X_W2, 1}, reach, places);
  add_ends({&boundary2, &X_W2, &boundary1, &X_W1, 2}, reach, places);
  return places;
}

std::optional<NearPlace> moved_place(const Boundary& boundary1, const Pose<double>& X_W1,
                                     const Boundary& boundary2, const Pose<double>& X_W2,
                                     const NearPlace& before) {
  switch (before.end) {
    case 1:
      return end_near({&boundary1, &X_W1, &boundary2, &X_W2, 1}, before.place1, before.place2);
    case 2:
      return end_near({&boundary2, &X_W2, &boundary1, &X_W1, 2}, before.place2, before.place1);
    default:
      return common_normal_near(boundary1, X_W1, boundary2, X_W2, before.place1, before.place2);
  }
}

}  // namespace higherpair

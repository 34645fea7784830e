#include "vertex_passage.hpp"

#include "analysis/groups/group_kinds.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "span_ends.hpp"

namespace higherpair {
namespace {

// Both bodies of a contact: the one whose face ends (faced), and the one that touches it with a corner
// (pointed).
struct VertexSides {
  const Boundary& faced;
  const Boundary& pointed;
  const Pose<double>& X_WF;
  const Pose<double>& X_WP;
  BoundaryPlace on_face, on_point;
};

// The place on the corner at `at` that has the normal n_W, if the corner's normals include it.
std::optional<BoundaryPlace> on_same_corner(const Boundary& boundary, const Pose<double>& X_WB,
                                            const BoundaryPlace& at, const Vector2d& n_W) {
  const auto place = place_with_normal(boundary, at, X_WB.R_WB.inverse() * n_W);
  return place && place->span == at.span ? place : std::nullopt;
}

// The touch of two places, with the faced body first.
NearPlace touch_of(const VertexSides& sides, const BoundaryPlace& on_face, const BoundaryPlace& on_point) {
  const SpanPoint face = sides.faced.at(on_face);
  const SpanPoint point = sides.pointed.at(on_point);
  return {
      {sides.X_WF.R_WB * face.n_B, sides.X_WF * face.p_B, sides.X_WP * point.p_B,
       radius_of(face, sides.faced.is_corner(on_face)), radius_of(point, sides.pointed.is_corner(on_point))},
      on_face,
      on_point,
      0};
}

// The passage at the end of the faced body's span that is `high` or not.
std::optional<VertexPassage> passage_over(const VertexSides& sides, bool high) {
  const Boundary& faced = sides.faced;
  const auto joint_at = [&](int span) {
    return faced.joint_after(high ? span : faced.next_span(span, high));
  };
  const bool on_corner = faced.is_corner(sides.on_face);
  if (!is_at_end(faced, sides.on_face, on_corner ? !high : high, kAtSpanEnd)) {
    return std::nullopt;
  }
  const int last = sides.on_face.span;
  const bool notch = joint_at(last) == SpanJoint::kNotch;
  const int corner = on_corner ? last : faced.next_span(last, high);
  if (!notch && (joint_at(last) == SpanJoint::kEnd || !faced.spans()[corner]->is_corner())) {
    return std::nullopt;
  }
  // Behind an edge at the end of the boundary there is no face.
  if (notch || joint_at(corner) != SpanJoint::kEnd) {
    const BoundaryPlace beyond = end_of(faced, notch ? corner : faced.next_span(corner, high), !high);
    const Vector2d n_W = sides.X_WF.R_WB * faced.at(beyond).n_B;
    if (const auto point = on_same_corner(sides.pointed, sides.X_WP, sides.on_point, -n_W)) {
      return VertexPassage{touch_of(sides, beyond, *point), 0, notch};
    }
  }
  const int beside = sides.pointed.next_span(sides.on_point.span, high);
  if (notch || sides.pointed.joint_after(high ? sides.on_point.span : beside) == SpanJoint::kEnd) {
    return std::nullopt;
  }
  const BoundaryPlace face = end_of(sides.pointed, beside, !high);
  const auto on_corner_place = on_same_corner(faced, sides.X_WF, end_of(faced, corner, !high),
                                              -(sides.X_WP.R_WB * sides.pointed.at(face).n_B));
  return on_corner_place ? std::optional(VertexPassage{touch_of(sides, *on_corner_place, face), 0, false})
                         : std::nullopt;
}

}  // namespace

std::optional<VertexPassage> vertex_passage(const Run& run, std::size_t contact) {
  const Contact& touching = run.mechanism().contacts[contact];
  const auto& place = run.at.state.contacts[contact].place;
  const auto pose = [&](std::size_t side) -> const Pose<double>& {
    return run.at.state.bodies[ref_of(touching, side).body].X_WB;
  };
  for (std::size_t side = 0; side < 2; ++side) {
    const VertexSides sides{boundary_at(run, contact, side),
                            boundary_at(run, contact, 1 - side),
                            pose(side),
                            pose(1 - side),
                            place[side],
                            place[1 - side]};
    if (!sides.pointed.is_corner(sides.on_point)) {
      continue;
    }
    for (const bool high : {false, true}) {
      if (auto passage = passage_over(sides, high)) {
        passage->side = side;
        if (side == 1) {
          const NearPlace& seen = passage->beyond;
          passage->beyond = NearPlace{seen.at.exchanged(), seen.place2, seen.place1, 0};
        }
        return passage;
      }
    }
  }
  return std::nullopt;
}

}  // namespace higherpair

#include "link_shapes.hpp"

#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "outline.hpp"
#include "touches.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kBar = 1.6;  // half the width of a bar [units]
constexpr double kTurnOfLine =
    2 * kPi / 96;  // most that an outline turns from one of its lines to the next [rad]

bool is_closed_chain(const NamedCurve& named) {
  return named.curve.kind == CurveKind::kChain && named.boundary && named.boundary->is_closed();
}

// Sign of the direction along a face's axis that points into its material.
double material_sense(const Curve& curve) {
  return curve.side == Side::kOutside ? -1 : 1;
}

bool is_within(const Vector2d& p, const std::vector<Vector2d>& polygon) {
  bool within = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector2d& a = polygon[i];
    const Vector2d& b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
      within = !within;
    }
  }
  return within;
}

// A point within the drawn material of a face or an open conic.
Vector2d middle_of_strip(const Sketch& sketch, int body, std::size_t index) {
  const Curve& curve = sketch.mechanism.bodies[body].curves[index].curve;
  const std::vector<double> path = material(curve, kFace * sketch.unit, touched_range(sketch, body, index));
  const std::size_t front = path.size() / 2 - 2;  // number of points in front; the other two are behind
  const auto at = [&](std::size_t i) { return Vector2d(path[2 * i], path[2 * i + 1]); };
  return (at((front - 1) / 2) + at(front / 2) + at(front) + at(front + 1)) / 4;
}

// A point behind the middle of a chain that is not a plate, such as a tooth flank.
std::optional<Vector2d> middle_behind(const Sketch& sketch, const NamedCurve& named) {
  if (named.curve.kind != CurveKind::kChain || !named.boundary || named.boundary->is_closed()) {
    return std::nullopt;
  }
  const auto& samples = named.boundary->samples();
  const SpanPoint& middle = samples[samples.size() / 2].point;
  if (samples.size() < 3) return (samples.front().point.p_B + samples.back().point.p_B) / 2;
  return middle.p_B - kBar * sketch.unit * middle.n_B;
}

// The end of the bar to a point on a flat face, moved back so that the bar does not project in front of the
// face.
Vector2d behind_faces(const Sketch& sketch, int index, const Vector2d& p_B) {
  const Body& body = sketch.mechanism.bodies[index];
  Vector2d behind = p_B;
  for (std::size_t i = 0; i < body.curves.size(); ++i) {
    const Curve& curve = body.curves[i].curve;
    if (body.curves[i].copy_of >= 0 || !is_line(curve)) continue;
    const auto [low, high] = touched_range(sketch, index, i);
    const Vector2d n = material_sense(curve) * curve.axis_B, away = p_B - curve.vertex_B;
    const double depth = away.dot(n), along = away.dot(perp(curve.axis_B));
    const double missing = kBar * sketch.unit - depth;
    if (missing > 0 && std::abs(depth) <= kFace * sketch.unit && along >= low && along <= high) {
      behind += missing * n;
    }
  }
  return behind;
}

// The distance from the middle of a ring to its inner side in the direction d.
double radius_of(const NamedCurve& ring, const Vector2d& middle, const Vector2d& d) {
  if (is_conic(ring.curve)) {
    const auto [a, b] = semi_axes(ring.curve);
    return 1 / std::hypot(d.dot(ring.curve.axis_B) / a, d.dot(perp(ring.curve.axis_B)) / b);
  }
  double radius = 0;  // that of the last crossing
  const std::vector<Vector2d> outline = drawn_outline(*ring.boundary);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d a = outline[i] - middle, b = outline[(i + 1) % outline.size()] - middle;
    const double before = cross(d, a), after = cross(d, b);
    if ((before > 0) == (after > 0)) continue;
    radius = std::max(radius, d.dot(a + before / (before - after) * (b - a)));
  }
  return radius;
}

// The ends of bars at a ring: one towards each point outside of it, and for a point in its hollow one where
// the ring is least touched.
std::vector<Vector2d> rim_towards(const Sketch& sketch, int index, std::size_t curve,
                                  const Vector2d& middle) {
  const Body& body = sketch.mechanism.bodies[index];
  const NamedCurve& ring = body.curves[curve];
  const double thickness = kFace * sketch.unit;
  // At this depth the round end of a bar is within the ring.
  const double from_outside = kBar * sketch.unit, from_inside = thickness - from_outside;
  const auto on_rim = [&](const Vector2d& d, double depth) {
    return Vector2d(middle + (radius_of(ring, middle, d) + depth) * d);
  };
  std::vector<Vector2d> rim;
  for (const NamedPoint& point : body.points) {
    const Vector2d offset = point.p_B - middle;
    const Vector2d d = offset.norm() > 0 ? Vector2d(offset.normalized()) : Vector2d(Vector2d::UnitX());
    const double radius = radius_of(ring, middle, d);
    if (offset.norm() > radius + thickness) {
      rim.push_back(on_rim(d, from_outside));
    } else if (offset.norm() < radius - thickness) {
      rim.push_back(on_rim(-edge_direction(sketch, index, curve), from_inside));
    }
  }
  return rim;
}

// Where the rails and slots of the body begin, as seen from their points on it; none for one that contains
// its point.
std::vector<Vector2d> ends_of_rails(const Sketch& sketch, int index) {
  std::vector<Vector2d> ends;
  for (const Joint& joint : sketch.mechanism.joints) {
    const bool guides = joint.type == JointType::kPrismatic || joint.type == JointType::kSlot;
    if (!guides || joint.first.body != index || is_rod(sketch, joint)) continue;
    const auto [low, high] = rail_ends(sketch, joint);
    const double nearest = std::clamp(0.0, low, high);
    if (std::abs(nearest) > sketch.unit) {
      ends.emplace_back(point_of(sketch.mechanism, joint.first) + nearest * joint.direction_A);
    }
  }
  return ends;
}

// Whether a closed curve of the body contains all of its anchors, so that the body needs no bar.
bool is_disc(const Sketch& sketch, const Body& body, const std::vector<Vector2d>& anchors) {
  return std::any_of(body.curves.begin(), body.curves.end(), [&](const NamedCurve& named) {
    if (is_plate(named)) {
      const std::vector<Vector2d> polygon = drawn_outline(*named.boundary);
      return std::all_of(anchors.begin(), anchors.end(),
                         [&](const Vector2d& p) { return is_within(p, polygon); });
    }
    const auto middle = middle_of(named.curve);
    if (!middle || !is_conic(named.curve) || named.curve.side == Side::kOutside) {
      return false;
    }
    const double least = semi_axes(named.curve)[1] - sketch.unit;
    return std::all_of(anchors.begin(), anchors.end(),
                       [&](const Vector2d& p) { return (p - *middle).norm() <= least; });
  });
}

}  // namespace

std::vector<Vector2d> drawn_outline(const Boundary& boundary) {
  std::vector<Vector2d> points;
  const auto& samples = boundary.samples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    points.push_back(samples[i].point.p_B);
    if (i + 1 == samples.size() || samples[i + 1].place.span != samples[i].place.span) continue;
    const Span& span = *boundary.spans()[samples[i].place.span];
    if (span.is_corner()) continue;
    const Vector2d& a = samples[i].point.n_B;
    const Vector2d& b = samples[i + 1].point.n_B;
    const double turn = std::abs(angle_from_to(a, b));
    const int parts = static_cast<int>(std::ceil(turn / kTurnOfLine));
    for (int k = 1; k < parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      points.push_back(span.at(std::lerp(samples[i].place.t, samples[i + 1].place.t, share)).p_B);
    }
  }
  return points;
}

bool is_ring(const NamedCurve& named) {
  return is_closed_chain(named) && !is_plate(named);
}

bool is_plate(const NamedCurve& named) {
  if (!is_closed_chain(named)) {
    return false;
  }
  const std::vector<Vector2d> polygon = drawn_outline(*named.boundary);
  double twice_area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice_area += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return twice_area > 0;
}

std::vector<Vector2d> anchors_of(const Sketch& sketch, int index) {
  const Body& body = sketch.mechanism.bodies[index];
  std::vector<Vector2d> anchors;
  for (const NamedPoint& point : body.points) {
    anchors.push_back(behind_faces(sketch, index, point.p_B));
  }
  for (std::size_t i = 0; i < body.curves.size(); ++i) {
    const Curve& curve = body.curves[i].curve;
    if (body.curves[i].copy_of >= 0) continue;
    if (is_plate(body.curves[i])) anchors.push_back(body.curves[i].boundary->middle_B());
    if (const auto behind = middle_behind(sketch, body.curves[i])) anchors.push_back(*behind);
    const auto middle = middle_of(curve);
    if (middle && curve.side == Side::kInside) {
      anchors.push_back(*middle);
    } else if (is_line(curve) || (is_conic(curve) && curve.q <= 0)) {
      anchors.push_back(behind_faces(sketch, index, middle_of_strip(sketch, index, i)));
    } else if (is_point(curve) && is_held(sketch, index, i)) {
      anchors.emplace_back(curve.vertex_B);
    } else if (is_point(curve)) {
      anchors.emplace_back(curve.vertex_B + kWedge * sketch.unit * edge_direction(sketch, index, i));
    } else if (middle) {
      const std::vector<Vector2d> rim = rim_towards(sketch, index, i, *middle);
      anchors.insert(anchors.end(), rim.begin(), rim.end());
    } else if (is_ring(body.curves[i])) {
      const std::vector<Vector2d> rim = rim_towards(sketch, index, i, body.curves[i].boundary->middle_B());
      anchors.insert(anchors.end(), rim.begin(), rim.end());
    }
  }
  const std::vector<Vector2d> rails = index > 0 ? ends_of_rails(sketch, index) : std::vector<Vector2d>();
  anchors.insert(anchors.end(), rails.begin(), rails.end());
  return anchors;
}

void add_link(Sketch& sketch, int index) {
  const Body& body = sketch.mechanism.bodies[index];
  const std::vector<Vector2d> anchors = anchors_of(sketch, index);
  const bool has_length = std::any_of(anchors.begin(), anchors.end(), [&](const Vector2d& p) {
    return (p - anchors.front()).norm() > sketch.unit;
  });
  if (has_length && !is_disc(sketch, body, anchors)) {
    sketch.add(Role::kLink, body.name, index, rounded_hull(anchors, kBar * sketch.unit), true);
  }
}

}  // namespace higherpair

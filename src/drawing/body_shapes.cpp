#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "outline.hpp"
#include "sketch.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kBar = 1.6;   // half the width of a bar [units]
constexpr double kFace = 2.5;  // thickness of faces and rings
constexpr double kRoom = 4;    // beyond the touching points of a face
constexpr double kWedge = 5;   // length of a knife edge
constexpr double kWedgeSlope = 0.35;

// A touching point of a curve, seen from its body: the point, and the outward normal.
struct Touch {
  Vector2d p_B, n_B;
};

template <class F>
void for_each_touch(const Sketch& sketch, int body, std::size_t curve, const F& found) {
  const auto is_it = [&](const CurveRef& ref) {
    const NamedCurve& named = sketch.mechanism.bodies[static_cast<std::size_t>(ref.body)]
                                  .curves[static_cast<std::size_t>(ref.curve)];
    const auto index = static_cast<int>(curve);
    return ref.body == body && (ref.curve == index || named.copy_of == index);
  };
  for (std::size_t i = 0; i < sketch.mechanism.contacts.size(); ++i) {
    const Contact& contact = sketch.mechanism.contacts[i];
    const bool first = is_it(contact.first);
    if (!first && !is_it(contact.second)) {
      continue;
    }
    for (const MotionRow* row : sketch.rows) {
      const CommonNormal& at = row->contacts[i].at;
      const Pose<double>& X_WB = body_in(*row, body).X_WB;
      const Vector2d n_W = first ? at.n_W : Vector2d(-at.n_W);
      if (!found(Touch{X_WB.inverse_times(first ? at.p1_W : at.p2_W), X_WB.R_WB.inverse() * n_W})) {
        return;
      }
    }
  }
}

// From a knife edge into its body: against the mean of the normals.
Vector2d edge_direction(const Sketch& sketch, int body, std::size_t curve) {
  Vector2d sum = Vector2d::Zero();
  for_each_touch(sketch, body, curve, [&](const Touch& touch) {
    sum -= touch.n_B;
    return true;
  });
  return sum.norm() > 0 ? Vector2d(sum.normalized()) : Vector2d(-Vector2d::UnitY());
}

std::vector<Vector2d> outline(const Boundary& boundary) {
  std::vector<Vector2d> points;
  for (const Boundary::Sample& sample : boundary.samples()) {
    points.push_back(sample.point.p_B);
  }
  return points;
}

// A closed chain with its material inside.
bool is_plate(const NamedCurve& named) {
  if (named.curve.kind != CurveKind::kChain || !named.boundary || !named.boundary->is_closed()) {
    return false;
  }
  const std::vector<Vector2d> polygon = outline(*named.boundary);
  double twice_area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice_area += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return twice_area > 0;
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

// What is no plate has a rim of material behind it.
void add_chain(Sketch& sketch, int body, const NamedCurve& named) {
  std::vector<double> path;
  for (const Vector2d& p : outline(*named.boundary)) {
    path.insert(path.end(), {p.x(), p.y()});
  }
  if (!is_plate(named)) {
    const auto& samples = named.boundary->samples();
    for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample) {
      const Vector2d behind = sample->point.p_B - kFace * sketch.unit * sample->point.n_B;
      path.insert(path.end(), {behind.x(), behind.y()});
    }
  }
  sketch.add(Role::kBody, sketch.mechanism.bodies[static_cast<std::size_t>(body)].name, body, path, true);
}

void add_curve(Sketch& sketch, int body, std::size_t index) {
  const NamedCurve& named = sketch.mechanism.bodies[static_cast<std::size_t>(body)].curves[index];
  const Curve& curve = named.curve;
  const double unit = sketch.unit;
  const std::string& name = sketch.mechanism.bodies[static_cast<std::size_t>(body)].name;
  if (curve.kind == CurveKind::kSupport) {
    return;
  }
  if (curve.kind == CurveKind::kChain) {
    add_chain(sketch, body, named);
    return;
  }
  if (is_point(curve)) {
    const Vector2d in = edge_direction(sketch, body, index);
    const Vector2d back = curve.vertex_B + kWedge * unit * in;
    const Vector2d side = kWedgeSlope * kWedge * unit * perp(in);
    const Vector2d a = back + side, b = back - side;
    sketch.add(Role::kBody, name, body, {curve.vertex_B.x(), curve.vertex_B.y(), a.x(), a.y(), b.x(), b.y()},
               true);
    return;
  }
  if (curve.kind == CurveKind::kCircle && curve.side == Side::kInside) {
    sketch.add_circle(Role::kBody, name, body, center(curve), curve.semi_latus);
    return;
  }
  sketch.add(Role::kBody, name, body, material(curve, kFace * unit, touched_range(sketch, body, index)),
             true);
}

// Within the material of a face or an open conic.
Vector2d middle_of_strip(const Sketch& sketch, int body, std::size_t index) {
  const Curve& curve = sketch.mechanism.bodies[static_cast<std::size_t>(body)].curves[index].curve;
  const std::vector<double> path = material(curve, kFace * sketch.unit, touched_range(sketch, body, index));
  const std::size_t front = path.size() / 2 - 2;  // points; the other two are behind
  const auto at = [&](std::size_t i) { return Vector2d(path[2 * i], path[2 * i + 1]); };
  return (at((front - 1) / 2) + at(front / 2) + at(front) + at(front + 1)) / 4;
}

// Where bars from points outside of a ring end in it.
std::vector<Vector2d> rim_towards(const Body& body, const Curve& ring, const Vector2d& middle,
                                  double thickness) {
  const auto [a, b] = semi_axes(ring);
  std::vector<Vector2d> rim;
  for (const NamedPoint& point : body.points) {
    const Vector2d way = point.p_B - middle;
    if (!(way.norm() > a + thickness)) continue;
    const Vector2d d = way.normalized();
    const double radius = 1 / std::hypot(d.dot(ring.axis_B) / a, d.dot(perp(ring.axis_B)) / b);
    rim.emplace_back(middle + (radius + 0.75 * thickness) * d);
  }
  return rim;
}

// The points that a bar or plate holds together: named points, and where the curves are.
std::vector<Vector2d> anchors_of(const Sketch& sketch, int index) {
  const Body& body = sketch.mechanism.bodies[static_cast<std::size_t>(index)];
  std::vector<Vector2d> anchors;
  for (const NamedPoint& point : body.points) {
    anchors.push_back(point.p_B);
  }
  for (std::size_t i = 0; i < body.curves.size(); ++i) {
    const Curve& curve = body.curves[i].curve;
    if (body.curves[i].copy_of >= 0) continue;
    if (is_plate(body.curves[i])) anchors.push_back(body.curves[i].boundary->middle_B());
    const auto middle = middle_of(curve);
    if (middle && curve.side == Side::kInside) {
      anchors.push_back(*middle);
    } else if (is_line(curve) || (is_conic(curve) && curve.q <= 0)) {
      anchors.push_back(middle_of_strip(sketch, index, i));
    } else if (is_point(curve)) {
      anchors.emplace_back(curve.vertex_B + kWedge * sketch.unit * edge_direction(sketch, index, i));
    } else if (middle) {
      const std::vector<Vector2d> rim = rim_towards(body, curve, *middle, kFace * sketch.unit);
      anchors.insert(anchors.end(), rim.begin(), rim.end());
    }
  }
  return anchors;
}

// Whether a closed curve of the body holds all of its points: then it needs no bar.
bool is_disc(const Sketch& sketch, const Body& body, const std::vector<Vector2d>& anchors) {
  return std::any_of(body.curves.begin(), body.curves.end(), [&](const NamedCurve& named) {
    if (is_plate(named)) {
      const std::vector<Vector2d> polygon = outline(*named.boundary);
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

void add_link(Sketch& sketch, int index) {
  const Body& body = sketch.mechanism.bodies[static_cast<std::size_t>(index)];
  const std::vector<Vector2d> anchors = anchors_of(sketch, index);
  const bool has_length = std::any_of(anchors.begin(), anchors.end(), [&](const Vector2d& p) {
    return (p - anchors.front()).norm() > sketch.unit;
  });
  if (has_length && !is_disc(sketch, body, anchors)) {
    sketch.add(Role::kLink, body.name, index, rounded_hull(anchors, kBar * sketch.unit), true);
  }
}

// Whether a body turns about this point of ground: other points of it need no name in a picture.
bool is_pivot(const Mechanism& mechanism, int point) {
  const auto is_it = [&](const PointRef& ref) { return ref.body == 0 && ref.point == point; };
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
    return joint.type == JointType::kRevolute && (is_it(joint.first) || is_it(joint.second));
  });
}

const std::string& shown(const Look& look, const std::string& name) {
  return look.name.empty() ? name : look.name;
}

void add_names(Sketch& sketch, int index) {
  const Body& body = sketch.mechanism.bodies[static_cast<std::size_t>(index)];
  std::vector<Vector2d> anchors = anchors_of(sketch, index);
  if (anchors.empty()) {
    return;
  }
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& p : anchors) {
    middle += p / static_cast<double>(anchors.size());
  }
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    const NamedPoint& point = body.points[i];
    const Look look = sketch.point_look(index, i);
    if (!look.hide && (index > 0 || is_pivot(sketch.mechanism, static_cast<int>(i)))) {
      sketch.add_text(body.name + "." + point.name, shown(look, point.name), index, point.p_B,
                      point.p_B - middle);
    }
  }
  if (index > 0 && !sketch.look(index).hide) {
    sketch.add_text(body.name, shown(sketch.look(index), body.name), index, middle, Vector2d::Zero());
  }
}

}  // namespace

std::array<double, 2> touched_range(const Sketch& sketch, int body, std::size_t index) {
  const Curve& curve = sketch.mechanism.bodies[static_cast<std::size_t>(body)].curves[index].curve;
  const Vector2d across = perp(curve.axis_B);
  double low = INFINITY, high = -INFINITY;
  for_each_touch(sketch, body, index, [&](const Touch& touch) {
    const double t = (touch.p_B - curve.vertex_B).dot(across);
    low = std::min(low, t);
    high = std::max(high, t);
    return true;
  });
  if (!(low <= high)) {
    low = high = 0;
  }
  const double room = kRoom * sketch.unit + 0.1 * (high - low);
  return {low - room, high + room};
}

void add_bodies(Sketch& sketch) {
  const auto count = static_cast<int>(sketch.mechanism.bodies.size());
  for (int body = 1; body < count; ++body) {
    if (sketch.look(body).hide) continue;
    const std::size_t first = sketch.shapes.size();
    add_link(sketch, body);
    sketch.dress(first, sketch.look(body));
  }
  for (int body = 0; body < count; ++body) {
    const auto curves = sketch.mechanism.bodies[static_cast<std::size_t>(body)].curves.size();
    for (std::size_t i = 0; i < curves; ++i) {
      if (sketch.mechanism.bodies[static_cast<std::size_t>(body)].curves[i].copy_of >= 0) continue;
      const Look look = sketch.curve_look(body, i);
      if (look.hide) continue;
      const std::size_t first = sketch.shapes.size();
      add_curve(sketch, body, i);
      sketch.dress(first, look);
    }
  }
  for (int body = 0; body < count; ++body) {
    add_names(sketch, body);
  }
}

}  // namespace higherpair

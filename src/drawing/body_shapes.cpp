#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/geometry/support_chains.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "link_shapes.hpp"
#include "outline.hpp"
#include "sketch.hpp"
#include "touches.hpp"

#include <algorithm>
#include <memory>

namespace higherpair {
namespace {

// Sizes in units.
constexpr double kWedgeSlope = 0.35;
constexpr double kFaceReach = 30;  // where faces without an end are cut off

// A line that encloses a pin from both sides is the centre line of a slot.
void add_slot(Sketch& sketch, int body, const NamedCurve& named) {
  const auto& samples = named.boundary->samples();
  std::vector<double> path;
  const auto add = [&](const SpanPoint& at, double side) {
    append(path, at.p_B + side * kSlotHalf * sketch.unit * at.n_B);
  };
  for (const auto& sample : samples) add(sample.point, 1);
  for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample) add(sample->point, -1);
  sketch.add(Role::kJoint, sketch.mechanism.bodies[body].name, body, path, true);
}

// A chain that is not a plate is drawn as a strip, or a ring, of material behind it.
void add_chain(Sketch& sketch, int body, const NamedCurve& named) {
  std::vector<double> path;
  for (const Vector2d& p : drawn_outline(*named.boundary)) append(path, p);
  if (is_ring(named)) append_break(path);
  if (!is_plate(named)) {
    const auto& samples = named.boundary->samples();
    for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample) {
      append(path, sample->point.p_B - kFace * sketch.unit * sample->point.n_B);
    }
  }
  sketch.add(Role::kBody, sketch.mechanism.bodies[body].name, body, path, true);
}

void add_curve(Sketch& sketch, int body, std::size_t index) {
  const NamedCurve& named = sketch.mechanism.bodies[body].curves[index];
  const Curve& curve = named.curve;
  const double unit = sketch.unit;
  const std::string& name = sketch.mechanism.bodies[body].name;
  if (curve.kind == CurveKind::kSupport) {
    for (const Boundary& chain : support_chains(*curve.support, kFaceReach * unit)) {
      NamedCurve part = named;
      part.curve.kind = CurveKind::kChain;
      part.boundary = std::make_shared<const Boundary>(chain);
      add_chain(sketch, body, part);
    }
    return;
  }
  if (curve.kind == CurveKind::kChain) {
    if (is_held(sketch, body, index) && !named.boundary->is_closed()) {
      add_slot(sketch, body, named);
    } else {
      add_chain(sketch, body, named);
    }
    return;
  }
  if (is_point(curve) && is_held(sketch, body, index)) {
    sketch.add_circle(Role::kJoint, name, body, curve.vertex_B, kPinRadius * unit);
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

// Whether a body turns about this point of ground; only such points of ground have their names in a picture.
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
  const Body& body = sketch.mechanism.bodies[index];
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

void add_bodies(Sketch& sketch) {
  const auto count = static_cast<int>(sketch.mechanism.bodies.size());
  for (int body = 1; body < count; ++body) {
    if (sketch.look(body).hide) continue;
    const std::size_t first = sketch.shapes.size();
    add_link(sketch, body);
    sketch.dress(first, sketch.look(body));
  }
  for (int body = 0; body < count; ++body) {
    const auto curves = sketch.mechanism.bodies[body].curves.size();
    for (std::size_t i = 0; i < curves; ++i) {
      if (sketch.mechanism.bodies[body].curves[i].copy_of >= 0) continue;
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

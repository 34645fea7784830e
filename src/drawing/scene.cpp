#include "higherpair/drawing/scene_maker.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/contains.hpp"
#include "outline.hpp"
#include "sketch.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

namespace higherpair {
namespace {

constexpr double kUnitsAcross = 110;       // along the picture's diagonal
constexpr double kSceneMargin = 3;         // [units]
constexpr double kLinkageRoom = 0.3;       // relative to the longer side: margin for equivalent linkages
constexpr std::size_t kRowsLookedAt = 72;  // to find the room that shapes need

using Extent = Eigen::AlignedBox2d;

void extend(Extent& extent, const Vector2d& p, double radius) {
  extent.extend((p.array() - radius).matrix()).extend((p.array() + radius).matrix());
}

// The extent of points, closed curves and contacts, without symbols.
Extent bare_extent(const Sketch& sketch) {
  Extent extent;
  for (const MotionRow* row : sketch.rows) {
    for (std::size_t i = 0; i < row->bodies.size(); ++i) {
      const Body& body = sketch.mechanism.bodies[i];
      const Pose<double>& X_WB = row->bodies[i].X_WB;
      for (const NamedPoint& point : body.points) {
        extent.extend(X_WB * point.p_B);
      }
      for (const NamedCurve& named : body.curves) {
        if (const auto middle = middle_of(named.curve)) {
          extend(extent, X_WB * *middle, reach_from(named.curve, *middle).value_or(0));
        }
      }
    }
    for (const ContactMotion& contact : row->contacts) {
      if (contact.touches) extent.extend(contact.at.p_W());
    }
  }
  return extent;
}

// The diagonal of an extent; 1 if that is nothing but the rounding of coordinates, in ground or in a body.
double diagonal_of(const Extent& bare, const Mechanism& mechanism) {
  double largest = std::max(bare.min().norm(), bare.max().norm());
  for (const Body& body : mechanism.bodies) {
    for (const NamedPoint& point : body.points) largest = std::max(largest, point.p_B.norm());
    for (const NamedCurve& named : body.curves) {
      if (const auto middle = middle_of(named.curve)) largest = std::max(largest, middle->norm());
    }
  }
  const double diagonal = bare.sizes().norm();
  return diagonal > kNoExtent * largest ? diagonal : 1;
}

void add_shape(Extent& extent, const Shape& shape, const Pose<double>& X_WB) {
  const std::vector<double>& n = shape.numbers;
  if (shape.kind == Shape::Kind::kCircle) {
    extend(extent, X_WB * Vector2d(n[0], n[1]), n[2]);
    return;
  }
  const std::size_t count = shape.kind == Shape::Kind::kText ? 2 : n.size();
  for (std::size_t i = 0; i + 1 < count; i += 2) {
    if (!std::isnan(n[i])) {
      extent.extend(X_WB * Vector2d(n[i], n[i + 1]));
    }
  }
}

// None for a spring on a pivot.
std::optional<StraightSpring> straight_spring(const Sketch& sketch, const Spring& spring) {
  const Mechanism& mechanism = sketch.mechanism;
  if (!spring.joint) {
    return StraightSpring{spring.first.body, spring.second.body, point_of(mechanism, spring.first),
                          point_of(mechanism, spring.second)};
  }
  const Joint& joint = mechanism.joints[*spring.joint];
  return joint.type == JointType::kRevolute ? std::nullopt : std::optional(spring_along(sketch, joint));
}

Extent full_extent(const Sketch& sketch) {
  Extent extent;
  const std::size_t stride = sketch.rows.size() / kRowsLookedAt + 1;
  for (std::size_t k = 0; k < sketch.rows.size(); k += stride) {
    for (const Shape& shape : sketch.shapes) {
      add_shape(extent, shape, sketch.rows[k]->bodies[shape.body].X_WB);
    }
    for (const Spring& spring : sketch.mechanism.springs) {
      if (const auto ends = straight_spring(sketch, spring)) {
        extent.extend(sketch.rows[k]->bodies[ends->first_body].X_WB * ends->first);
        extent.extend(sketch.rows[k]->bodies[ends->second_body].X_WB * ends->second);
      }
    }
  }
  return extent;
}

// The extent of the centres of curvature of a contact in all rows; none if one leaves the box `allowed`.
std::optional<Extent> linkage_extent(const Sketch& sketch, std::size_t contact, const Extent& allowed) {
  Extent extent;
  for (const MotionRow* row : sketch.rows) {
    const CommonNormal& at = row->contacts[contact].at;
    if (!row->contacts[contact].touches) continue;
    for (const auto& [p_W, rho] : {std::pair(at.p1_W, at.rho1), std::pair(at.p2_W, -at.rho2)}) {
      if (std::isinf(rho)) continue;  // a flat face
      const Vector2d center = p_W - rho * at.n_W;
      if (!allowed.contains(center)) return std::nullopt;
      extend(extent, center, sketch.unit);
    }
  }
  return extent;
}

// Enlarges the picture to show equivalent linkages completely, unless they extend too far beyond it.
void add_linkages(Extent& extent, const Sketch& sketch) {
  Extent allowed = extent;
  const double room = kLinkageRoom * extent.sizes().maxCoeff();
  extend(allowed, extent.min(), room);
  extend(allowed, extent.max(), room);
  for (std::size_t i = 0; i < sketch.mechanism.contacts.size(); ++i) {
    if (const auto own = linkage_extent(sketch, i, allowed)) extent.extend(*own);
  }
}

bool is_joined(const Mechanism& mechanism, int body, int point) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
    return (joint.first.body == body && joint.first.point == point) ||
           (joint.second.body == body && joint.second.point == point);
  });
}

// In pieces where rows without a position are between.
void add_trace(Sketch& sketch, const PointRef& ref) {
  const Body& body = sketch.mechanism.bodies[ref.body];
  const NamedPoint& point = body.points[ref.point];
  std::vector<double> path;
  for (std::size_t i = 0; i < sketch.rows.size(); ++i) {
    append(path, sketch.rows[i]->bodies[ref.body].X_WB * point.p_B);
    if (i + 1 == sketch.rows.size() || sketch.rows[i + 1] != sketch.rows[i] + 1) {
      sketch.add(Role::kTrace, body.name + "." + point.name, 0, std::exchange(path, {}));
      sketch.shapes.back().colour = sketch.point_look(ref.body, static_cast<std::size_t>(ref.point)).colour;
    }
  }
}

void add_traces(Sketch& sketch, const std::vector<PointRef>& wanted) {
  for (std::size_t b = 1; b < sketch.mechanism.bodies.size(); ++b) {
    for (std::size_t p = 0; p < sketch.mechanism.bodies[b].points.size(); ++p) {
      const PointRef ref{static_cast<int>(b), static_cast<int>(p)};
      const bool asked = contains(wanted, ref);
      if (!asked && sketch.point_look(ref.body, p).hide) continue;
      if (asked || !is_joined(sketch.mechanism, ref.body, ref.point)) {
        add_trace(sketch, ref);
      }
    }
  }
}

}  // namespace

bool has_place(const MotionRow& row) {
  return row.status != RowStatus::kNotAssemblable && std::isfinite(row.residual);
}

Shape& Sketch::add(Role role, const std::string& name, int body, std::vector<double> numbers, bool closed,
                   Shape::Kind kind) {
  shapes.push_back({role, kind, name, body, closed, "", std::move(numbers), "", false});
  return shapes.back();
}

void Sketch::add_circle(Role role, const std::string& name, int body, const Vector2d& center, double radius) {
  add(role, name, body, {center.x(), center.y(), radius}, true, Shape::Kind::kCircle);
}

void Sketch::add_text(const std::string& name, const std::string& text, int body, const Vector2d& at,
                      const Vector2d& away) {
  add(Role::kLabel, name, body, {at.x(), at.y(), away.x(), away.y()}, false, Shape::Kind::kText).text = text;
}

Look Sketch::look(int body) const {
  return looks.empty() ? Look() : looks[body].body;
}

Look Sketch::point_look(int body, std::size_t point) const {
  return looks.empty() ? Look() : looks[body].points[point];
}

// A look given for the body also holds for its curves.
Look Sketch::curve_look(int body, std::size_t curve) const {
  if (looks.empty()) {
    return {};
  }
  const Look whole = look(body);
  Look own = looks[body].curves[curve];
  if (own.colour.empty()) own.colour = whole.colour;
  own.hide = own.hide || whole.hide;
  own.outline = own.outline || whole.outline;
  return own;
}

void Sketch::dress(std::size_t first, const Look& look) {
  for (std::size_t i = first; i < shapes.size(); ++i) {
    shapes[i].colour = look.colour;
    shapes[i].outline = look.outline;
  }
}

SceneMaker::SceneMaker(const Mechanism& mechanism, const std::vector<MotionRow>& rows,
                       const std::vector<PointRef>& traces, const std::vector<Reactions>& reactions,
                       const Looks& looks)
    : mechanism_(&mechanism), forces_(!reactions.empty()) {
  Sketch sketch{mechanism, {}, 1, {}, looks};
  for (const MotionRow& row : rows) {
    if (has_place(row)) {
      sketch.rows.push_back(&row);
    }
  }
  assert(!sketch.rows.empty());
  const Extent bare = bare_extent(sketch);
  sketch.unit = diagonal_of(bare, mechanism) / kUnitsAcross;
  add_bodies(sketch);
  add_joints(sketch);
  for (const Spring& spring : mechanism.springs) {
    springs_.push_back(straight_spring(sketch, spring));
  }
  add_spring_walls(sketch, springs_);
  add_traces(sketch, traces);
  // Draw pins over blocks, and short bars over long ones.
  const auto rank = [](const Shape& shape) {
    Extent extent;
    if (shape.role == Role::kLink) add_shape(extent, shape, {});
    const double size = shape.role == Role::kLink ? extent.sizes().norm() : 0;
    return std::tuple(shape.role, shape.role == Role::kJoint && shape.kind == Shape::Kind::kCircle, -size);
  };
  std::stable_sort(sketch.shapes.begin(), sketch.shapes.end(),
                   [&](const Shape& a, const Shape& b) { return rank(a) < rank(b); });
  Extent full = full_extent(sketch);
  add_linkages(full, sketch);
  const double margin = kSceneMargin * sketch.unit;
  scene_.unit = sketch.unit * kMillimetresPerMetre;
  scene_.view = {(full.min().array() - margin).matrix() * kMillimetresPerMetre,
                 (full.max().array() + margin).matrix() * kMillimetresPerMetre};
  largest_ = 1.5 * scene_.view.size().norm();
  scene_.fixed = std::move(sketch.shapes);
  for (Shape& shape : scene_.fixed) {
    for (double& number : shape.numbers) {
      number *= kMillimetresPerMetre;
    }
  }
  scene_.places.resize(mechanism.bodies.size());
  set_arrow_scales(sketch, scene_);
  set_force_scales(mechanism, reactions, scene_);
  for (const MotionRow* row : sketch.rows) {
    at(*row, forces_ ? &reactions[static_cast<std::size_t>(row - rows.data())] : nullptr);
    add_arrow_rooms(scene_);
  }
  const auto first = static_cast<std::size_t>(sketch.rows.front() - rows.data());
  at(rows[first], forces_ ? &reactions[first] : nullptr);
}

}  // namespace higherpair

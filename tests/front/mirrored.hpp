#pragma once

#include "higherpair/geometry/edges.hpp"
#include "higherpair/higherpair.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace higherpair::testing {

inline Vector2d mirrored(const Vector2d& v) {
  return {v.x(), -v.y()};
}

/// A span mirrored at the x axis, traversed in the opposite sense so that its material stays on the left.
class MirroredSpan final : public Span {
public:
  explicit MirroredSpan(SpanPtr span) : span_(std::move(span)) {}

  [[nodiscard]] SpanPoint at(double t) const override {
    const SpanPoint point = span_->at(-t);
    return {mirrored(point.p_B), mirrored(point.n_B), point.kappa, -point.slope, point.speed};
  }
  [[nodiscard]] Bounds range() const override { return {-span_->range().high, -span_->range().low}; }
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& t) const override {
    return span_->bounds({-t.high, -t.low});
  }
  [[nodiscard]] int parts() const override { return span_->parts(); }

private:
  SpanPtr span_;
};

/// Mirrors chain by chain, each traversed in the opposite sense; corners and edges at ends are created again.
inline Boundary mirrored(const Boundary& boundary) {
  std::vector<Boundary> chains;
  std::vector<SpanPtr> spans;
  int first = 0;
  bool has_edges = false;
  for (int i = 0; i < static_cast<int>(boundary.spans().size()); ++i) {
    const SpanPtr& span = boundary.spans()[i];
    has_edges = has_edges || is_edge(boundary, i);
    if (!span->is_corner()) {
      spans.push_back(std::make_shared<MirroredSpan>(span));
    }
    if (boundary.next_span(i, true) != first) {
      continue;
    }
    std::reverse(spans.begin(), spans.end());
    const bool is_point = spans.empty();
    chains.push_back(is_point
                         ? boundary_of(make_point(mirrored(span->at(span->range().low).p_B)).value(), 1)
                         : Boundary::make(std::exchange(spans, {}),
                                          boundary.joint_after(i) != SpanJoint::kEnd, 1e-5 * boundary.size())
                               .value());
    chains.back() = std::exchange(has_edges, false) ? with_edges(chains.back()) : chains.back();
    first = i + 1;
  }
  return Boundary::of_parts(chains);
}

inline NamedCurve mirrored(NamedCurve curve) {
  curve.curve.vertex_B = mirrored(curve.curve.vertex_B);
  curve.curve.axis_B = mirrored(curve.curve.axis_B);
  if (curve.boundary) {
    curve.boundary = std::make_shared<const Boundary>(mirrored(*curve.boundary));
  }
  return curve;
}

/// The mirror image, at ground's x axis, of a mechanism of pins, slides, contacts, springs and loads.
inline Mechanism mirrored(Mechanism mechanism) {
  mechanism.gravity_W = mirrored(mechanism.gravity_W);
  for (Body& body : mechanism.bodies) {
    body.guess_p_WB = mirrored(body.guess_p_WB);
    body.guess_theta *= -1;
    for (NamedPoint& point : body.points) {
      point.p_B = mirrored(point.p_B);
    }
    for (NamedCurve& curve : body.curves) {
      curve = mirrored(curve);
    }
    if (body.mass) {
      body.mass->center_of_mass_B = mirrored(body.mass->center_of_mass_B);
    }
  }
  std::vector<bool> turns(mechanism.bodies.size());
  for (Joint& joint : mechanism.joints) {
    joint.direction_A = mirrored(joint.direction_A);
    joint.relative_angle *= -1;
    turns[joint.second.body] = joint.type == JointType::kRevolute;
  }
  for (Contact& contact : mechanism.contacts) {
    if (contact.approach != Approach::kNearest && turns[contact.second.body]) {
      contact.approach = contact.approach == Approach::kPositive ? Approach::kNegative : Approach::kPositive;
    }
  }
  for (Load& load : mechanism.loads) {
    load.p_B = mirrored(load.p_B);
    load.force = mirrored(load.force);
    load.torque *= -1;
  }
  for (Spring& spring : mechanism.springs) {
    const bool is_angle = spring.joint && has_angle(mechanism.joints[*spring.joint].type);
    spring.free *= is_angle ? -1 : 1;
  }
  return mechanism;
}

/// The mirror image of a model whose drivers turn, in degrees, or slide without following a law.
inline Model mirrored(const Model& model) {
  const Profile& profile = model.profile();
  std::vector<DriverProgram> programs = profile.programs;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const int joint = profile.mechanism.drivers[i].joint;
    if (profile.mechanism.joints[joint].type == JointType::kRevolute) {
      DriverProgram& program = programs[i];
      program.start *= -1;
      program.end = -program.end.value_or(360 - program.start);
      for (double& position : program.positions) {
        position *= -1;
      }
      program.velocity *= -1;
      program.acceleration *= -1;
    }
  }
  auto copy = Model::from(mirrored(profile.mechanism), profile.units, std::move(programs));
  if (!copy) {
    throw std::runtime_error(to_string(copy.error()));
  }
  return *std::move(copy);
}

}  // namespace higherpair::testing

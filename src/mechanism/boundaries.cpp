#include "higherpair/mechanism/boundaries.hpp"

#include "higherpair/geometry/edges.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "higherpair/mechanism/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace higherpair {
namespace {

double size_with_boundaries(const Mechanism& mechanism) {
  double size = size_of(mechanism);
  for (const Body& body : mechanism.bodies) {
    for (const NamedCurve& curve : body.curves) {
      size =
          curve.boundary ? std::max(size, curve.boundary->middle_B().norm() + curve.boundary->size()) : size;
    }
  }
  return size;
}

// How the curves of a contact become boundaries.
struct BoundaryRules {
  double reach = 0;  // how far unbounded curves are followed
  // Whether open curves get edges at their ends. A middle line with a wall on either side has no material
  // side: it just ends.
  bool has_edges = true;
};

std::shared_ptr<const Boundary> boundary_of(const NamedCurve& curve, const BoundaryRules& rules) {
  const auto boundary =
      curve.boundary ? curve.boundary
                     : std::make_shared<const Boundary>(higherpair::boundary_of(curve.curve, rules.reach));
  const bool has_ends = (curve.boundary || curve.curve.support != nullptr) && !boundary->is_closed();
  return rules.has_edges && has_ends ? std::make_shared<const Boundary>(with_edges(*boundary)) : boundary;
}

// Joins several curves of a body into one.
Boundary joined(const Body& body, const std::vector<int>& curves, const BoundaryRules& rules) {
  std::vector<Boundary> parts;
  for (const int index : curves) {
    parts.push_back(*boundary_of(body.curves[index], rules));
  }
  return Boundary::of_parts(parts);
}

void make_own(Mechanism& mechanism, CurveRef& ref, const BoundaryRules& rules) {
  Body& body = mechanism.bodies[ref.body];
  NamedCurve own = described_curve(mechanism, ref);
  if (!own.parts.empty()) {
    own.boundary = std::make_shared<const Boundary>(joined(body, own.parts, rules));
    body.curves[ref.curve] = std::move(own);
    return;
  }
  own.name.clear();
  own.copy_of = ref.curve;
  own.boundary = boundary_of(own, rules);
  ref.curve = static_cast<int>(body.curves.size());
  body.curves.push_back(std::move(own));
}

bool is_copy(const NamedCurve& curve) {
  return curve.copy_of >= 0 && curve.parts.empty();
}

void move(int& index, const std::vector<int>& now) {
  const bool there = index >= 0 && index < static_cast<int>(now.size());
  index = there ? now[static_cast<std::size_t>(index)] : index;  // what refers to nothing is reported later
}

// Drops the copies; returns the new index of each curve, for a copy that of its original.
std::vector<int> drop_copies(Body& body) {
  std::vector<int> now;
  int kept = 0;
  for (const NamedCurve& curve : body.curves) {
    now.push_back(is_copy(curve) ? -1 : kept++);
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (is_copy(body.curves[i])) {
      now[i] = body.curves[i].copy_of;
      move(now[i], now);
    }
  }
  std::erase_if(body.curves, is_copy);
  return now;
}

}  // namespace

void undo_boundaries(Mechanism& mechanism) {
  std::vector<std::vector<int>> now;  // by body
  for (Body& body : mechanism.bodies) {
    now.push_back(drop_copies(body));
    for (NamedCurve& curve : body.curves) {
      curve.boundary = curve.parts.empty() ? curve.boundary : nullptr;
      move(curve.copy_of, now.back());
      std::for_each(curve.parts.begin(), curve.parts.end(), [&](int& part) { move(part, now.back()); });
    }
  }
  for (Contact& contact : mechanism.contacts) {
    contact.by_boundary = false;
    for (CurveRef* ref : {&contact.first, &contact.second}) {
      const auto body = static_cast<std::size_t>(ref->body);
      if (body < now.size()) move(ref->curve, now[body]);
    }
  }
}

bool needs_boundaries(const Mechanism& mechanism, const Contact& contact) {
  const auto is_chain = [&](const CurveRef& ref) {
    return described_curve(mechanism, ref).curve.kind == CurveKind::kChain;
  };
  return !contact.by_boundary &&
         (contact.keep != Keep::kTouching || is_chain(contact.first) || is_chain(contact.second));
}

void use_boundaries(Mechanism& mechanism) {
  std::optional<double> reach;
  for (Contact& contact : mechanism.contacts) {
    if (!needs_boundaries(mechanism, contact)) {
      continue;
    }
    // Of the description alone: the boundaries made below are as long as this reach. It is a power of two, as
    // the size of a sampled boundary is no smooth function of the numbers it is made from.
    if (!reach) {
      reach = std::exp2(std::ceil(std::log2(kReachOfOpenCurves * size_with_boundaries(mechanism))));
    }
    const BoundaryRules rules{*reach, !contact.both_sides};
    make_own(mechanism, contact.first, rules);
    make_own(mechanism, contact.second, rules);
    contact.by_boundary = true;
  }
}

}  // namespace higherpair

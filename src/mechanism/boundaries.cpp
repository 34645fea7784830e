#include "higherpair/mechanism/boundaries.hpp"

#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <algorithm>
#include <utility>

namespace higherpair {
namespace {

constexpr double kReach = 10;  // of the size of the mechanism: how far lines and open conics are followed

NamedCurve& named(Mechanism& mechanism, const CurveRef& ref) {
  return mechanism.bodies[static_cast<std::size_t>(ref.body)].curves[static_cast<std::size_t>(ref.curve)];
}

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

std::shared_ptr<const Boundary> boundary_of(const NamedCurve& curve, double reach) {
  return curve.boundary ? curve.boundary
                        : std::make_shared<const Boundary>(higherpair::boundary_of(curve.curve, reach));
}

// Several curves of a body as one.
Boundary joined(const Body& body, const std::vector<int>& curves, double reach) {
  std::vector<Boundary> parts;
  for (const int index : curves) {
    parts.push_back(*boundary_of(body.curves[static_cast<std::size_t>(index)], reach));
  }
  return Boundary::of_parts(parts);
}

void make_own(Mechanism& mechanism, CurveRef& ref, double reach) {
  Body& body = mechanism.bodies[static_cast<std::size_t>(ref.body)];
  NamedCurve own = named(mechanism, ref);
  if (!own.parts.empty()) {
    own.boundary = std::make_shared<const Boundary>(joined(body, own.parts, reach));
    body.curves[static_cast<std::size_t>(ref.curve)] = std::move(own);
    return;
  }
  own.name.clear();
  own.copy_of = ref.curve;
  own.boundary = boundary_of(own, reach);
  ref.curve = static_cast<int>(body.curves.size());
  body.curves.push_back(std::move(own));
}

// Whether conics, lines and points do, in closed form.
bool is_of_whole_curves(Mechanism& mechanism, const Contact& contact) {
  const auto is_whole = [&](const CurveRef& ref) {
    return named(mechanism, ref).curve.kind != CurveKind::kChain;
  };
  return contact.keep == Keep::kTouching && is_whole(contact.first) && is_whole(contact.second);
}

}  // namespace

void use_boundaries(Mechanism& mechanism) {
  for (Contact& contact : mechanism.contacts) {
    if (contact.by_boundary || is_of_whole_curves(mechanism, contact)) {
      continue;
    }
    const double reach = kReach * size_with_boundaries(mechanism);
    make_own(mechanism, contact.first, reach);
    make_own(mechanism, contact.second, reach);
    contact.by_boundary = true;
  }
}

}  // namespace higherpair

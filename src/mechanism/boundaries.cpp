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

void make_own(Mechanism& mechanism, CurveRef& ref, double reach) {
  NamedCurve own = named(mechanism, ref);
  own.name.clear();
  own.copy_of = ref.curve;
  if (!own.boundary) {
    own.boundary = std::make_shared<const Boundary>(boundary_of(own.curve, reach));
  }
  auto& curves = mechanism.bodies[static_cast<std::size_t>(ref.body)].curves;
  ref.curve = static_cast<int>(curves.size());
  curves.push_back(std::move(own));
}

}  // namespace

void use_boundaries(Mechanism& mechanism) {
  for (Contact& contact : mechanism.contacts) {
    const bool whole =
        !named(mechanism, contact.first).boundary && !named(mechanism, contact.second).boundary;
    if (whole || contact.by_boundary) {
      continue;
    }
    const double reach = kReach * size_with_boundaries(mechanism);
    make_own(mechanism, contact.first, reach);
    make_own(mechanism, contact.second, reach);
    contact.by_boundary = true;
  }
}

}  // namespace higherpair

#include "group_system.hpp"

#include "analysis/rates/series_motion.hpp"
#include "group_kinds.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/edges.hpp"
#include "higherpair/numeric/contains.hpp"

namespace higherpair {

Eigen::VectorXd coordinates_of(const Planned& model, const Group& group, const State& state) {
  const double size = model.plan.size;
  const auto bodies = static_cast<Eigen::Index>(group.bodies.size());
  Eigen::VectorXd x(3 * bodies + static_cast<Eigen::Index>(group.contacts.size()));
  for (Eigen::Index i = 0; i < bodies; ++i) {
    const BodyMotion& body = state.bodies[group.bodies[i]];
    x.segment<2>(3 * i) = body.X_WB.p_WB;
    x(3 * i + 2) = size * body.theta;
  }
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    x(3 * bodies + static_cast<Eigen::Index>(i)) = size * state.contacts[group.contacts[i]].phi;
  }
  return x;
}

void set_coordinates(const Planned& model, const Group& group, const State& from, const Eigen::VectorXd& x,
                     State& state) {
  const double size = model.plan.size;
  const auto bodies = static_cast<Eigen::Index>(group.bodies.size());
  for (Eigen::Index i = 0; i < bodies; ++i) {
    const int index = group.bodies[i];
    BodyMotion& body = state.bodies[index];
    body.theta = x(3 * i + 2) / size;
    body.X_WB = {Rotation<double>::from_angle(body.theta), x.segment<2>(3 * i)};
  }
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const auto index = static_cast<std::size_t>(group.contacts[i]);
    ContactMotion& motion = state.contacts[index];
    motion = from.contacts[index];
    motion.phi = x(3 * bodies + static_cast<Eigen::Index>(i)) / size;
    motion.at.n_W = unit_vector(motion.phi);
  }
}

namespace {

using Moving = PowerSeries<double, 1>;

// Finds where a contact by_boundary has its normal, and the curves that agree with its boundaries there;
// false if there is no such place nearby.
bool set_local_curves(const Planned& model, const Contact& contact, const State& state, ContactMotion& motion,
                      Dimensions<double>::Contact& dimensions) {
  const auto set = [&](const CurveRef& ref, const Vector2d& n_W, BoundaryPlace& place,
                       CurveDimensions<double>& curve) {
    const Boundary& boundary = boundary_of(model.mechanism, ref);
    const bool face = is_flat(boundary, place);
    if (!face) {  // a face has only one normal, which is a condition of its own
      const auto found = place_with_normal(boundary, place, state.bodies[ref.body].X_WB.R_WB.inverse() * n_W);
      // An edge is the same point for all normals: its conditions go on beyond its last one, where the limit
      // at which a body slips off may be.
      if (!found && !is_edge(boundary, place.span)) {
        return false;
      }
      place = found.value_or(place);
    }
    curve = dimensions_of(local_curve(boundary.at(place), boundary.is_corner(place)));
    return true;
  };
  return set(contact.first, motion.at.n_W, motion.place[0], dimensions.curve1) &&
         set(contact.second, -motion.at.n_W, motion.place[1], dimensions.curve2);
}

}  // namespace

bool group_system(const Planned& model, const Group& group, const std::vector<DriverMotion>& drivers,
                  State& state, Eigen::VectorXd& F, Eigen::MatrixXd& J, Eigen::VectorXd& F_s) {
  Dimensions<double> dimensions = dimensions_of(model.mechanism);
  Coordinates<double> at = coordinates_of(model.mechanism, state.bodies, state.contacts);
  Coordinates<Moving> known = constant<Moving>(at);
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    const bool is_known = !contains(group.bodies, static_cast<int>(i));
    known.bodies[i] = is_known ? series_of_body<1>(state.bodies[i]) : known.bodies[i];
  }
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    at.drivers[i] = drivers[i].position;
    known.drivers[i] = series_of_driver<1>(drivers[i]);
  }
  for (const int index : group.contacts) {
    const auto i = static_cast<std::size_t>(index);
    auto& contact = dimensions.contacts[i];
    const Contact& described = model.mechanism.contacts[i];
    if (!state.contacts[i].touches) {
      return false;
    }
    if (described.by_boundary && !set_local_curves(model, described, state, state.contacts[i], contact)) {
      return false;
    }
    const auto touch = facing_at(contact, at.bodies[contact.first], at.bodies[contact.second], at.phi[i]);
    if (!touch) {
      return false;
    }
    state.contacts[i].at = *touch;
  }
  const ConditionSystem system(dimensions, condition_set(model.plan, group), model.plan.size);
  std::vector<Moving> rates;
  if (!system.evaluate(at, F, J) ||
      !append_conditions(dimensions, system.set(), known, model.plan.size, rates)) {
    return false;
  }
  F_s.resize(F.size());
  for (std::size_t i = 0; i < rates.size(); ++i) {
    F_s(static_cast<Eigen::Index>(i)) = rates[i].c[1];
  }
  return true;
}

}  // namespace higherpair

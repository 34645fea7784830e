#include "series_motion.hpp"

#include "group_series.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "numeric/least_norm.hpp"

#include <algorithm>
#include <utility>

namespace higherpair {

bool is_regular(const Eigen::MatrixXd& J) {
  return J.allFinite() && LeastNormSolver(J, kRepeatedConditions).rank() == J.cols();
}

ConditionSet condition_set(const Plan& plan, const Group& group) {
  return {group, idle_bodies_of(plan, group)};
}

Coordinates<double> coordinates_of(const Mechanism& mechanism, const std::vector<BodyMotion>& bodies,
                                   const std::vector<ContactMotion>& contacts) {
  Coordinates<double> at;
  for (const BodyMotion& body : bodies) {
    at.bodies.push_back({body.X_WB, body.theta});
    at.held_angles.push_back(body.theta);
  }
  for (const ContactMotion& contact : contacts) {
    at.phi.push_back(contact.phi);
    at.arcs.push_back(contact.arc_difference);
  }
  for (const Driver& driver : mechanism.drivers) {
    const Joint& joint = mechanism.joints[driver.joint];
    at.drivers.push_back(joint_motion(mechanism, joint, bodies).position);
  }
  return at;
}

Coordinates<double> row_coordinates(const Run& run) {
  Coordinates<double> at = coordinates_of(run.mechanism(), run.row.bodies, run.row.contacts);
  for (std::size_t i = 0; const auto& contact : dimensions_of(run.mechanism()).contacts) {
    at.arcs[i] = arc_difference(contact, at.bodies, at.phi[i]);
    ++i;
  }
  return at;
}

template <class D, int N>
SeriesMotion<D, N> solve_series(const Plan& plan, const Dimensions<double>& values,
                                const Dimensions<D>& dimensions, Coordinates<PowerSeries<D, N>> at,
                                const SeriesOptions& options) {
  SeriesMotion<D, N> motion{std::move(at), std::vector<bool>(dimensions.bodies, false)};
  solve_groups(plan, values, dimensions, options, motion,
               [&](const Group& group, const ConditionSystem& system, const Dimensions<D>& of) {
                 GroupSeries<D, N> series(system, of, motion.at);
                 const bool solved = series.solve(options.last);
                 if (traits_of(group).can_cross) {
                   motion.least_sine = std::min(motion.least_sine, series.least_sine());
                 }
                 return solved;
               });
  return motion;
}

template SeriesMotion<double, 3> solve_series(const Plan&, const Dimensions<double>&,
                                              const Dimensions<double>&, Coordinates<PowerSeries<double, 3>>,
                                              const SeriesOptions&);
template SeriesMotion<double, kHighestDerivative> solve_series(
    const Plan&, const Dimensions<double>&, const Dimensions<double>&,
    Coordinates<PowerSeries<double, kHighestDerivative>>, const SeriesOptions&);
template SeriesMotion<Partials<double, 1>, 2> solve_series(const Plan&, const Dimensions<double>&,
                                                           const Dimensions<Partials<double, 1>>&,
                                                           Coordinates<PowerSeries<Partials<double, 1>, 2>>,
                                                           const SeriesOptions&);

}  // namespace higherpair

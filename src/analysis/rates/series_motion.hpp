#pragma once

#include "analysis/tolerances.hpp"
#include "higherpair/analysis/derivatives.hpp"
#include "higherpair/geometry/body_jerk.hpp"
#include "higherpair/mechanism/condition_system.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace higherpair {

inline constexpr std::array<double, 7> kFactorials{1, 1, 2, 6, 24, 120, 720};
static_assert(kFactorials.size() > kHighestDerivative);

/// A motion as power series in time, from the instant t = 0.
template <class D, int N>
struct SeriesMotion {
  Coordinates<PowerSeries<D, N>> at;
  std::vector<bool> known;  ///< of the bodies: whether their series have been solved
  /// How near the conditions of a group that can cross are to losing their rank (LeastNormSolver).
  double least_sine = 1;
  bool diverges = false;  ///< of partials: changing the parameter removes the change point near the row

  [[nodiscard]] bool all_known() const { return std::find(known.begin(), known.end(), false) == known.end(); }
};

/// Options that limit solve_series().
struct SeriesOptions {
  bool surplus_slip = true;  ///< false: the slip conditions of groups that have conditions in surplus
  const std::vector<bool>* has_rates = nullptr;  ///< if set: stop at a body without rates
  std::size_t last = kHighestDerivative;         ///< orders above it are left as they are
  bool regular = false;                          ///< no change point is near: none is looked for
};

/// The coordinates of run.row. Rolling contacts keep the arc difference, and idle bodies the angle, that they
/// have there.
[[nodiscard]] Coordinates<double> row_coordinates(const Run& run);

/// The coordinates of bodies and contacts; drivers take the coordinates of their joints, and idle bodies keep
/// their angles.
[[nodiscard]] Coordinates<double> coordinates_of(const Mechanism& mechanism,
                                                 const std::vector<BodyMotion>& bodies,
                                                 const std::vector<ContactMotion>& contacts);

/// The bodies and conditions of a group of the plan.
[[nodiscard]] ConditionSet condition_set(const Plan& plan, const Group& group);

/// Raises coordinates that hold at t = 0 to series in time, group by group. With every coordinate a power
/// series the conditions hold order by order,
///     J x_k = -(what lower orders leave of the conditions at order k),
/// with the same Jacobian J in each; where the dimensions are Partials by a parameter, the same holds for the
/// partials of every order from the 0th. Uses least squares where there are surplus conditions; stops at the
/// first group whose conditions do not determine it, as later ones may depend on it.
/// \param values  of the dimensions
/// \param at      constant except for the drivers
template <class D, int N>
[[nodiscard]] SeriesMotion<D, N> solve_series(const Plan& plan, const Dimensions<double>& values,
                                              const Dimensions<D>& dimensions,
                                              Coordinates<PowerSeries<D, N>> at,
                                              const SeriesOptions& options = {});

/// The plan of a row in which contacts are open: the joint that holds the body of each becomes a further
/// driver, at rest, in place of the contact. None if no contact is open. Adds these drivers to `dimensions`
/// and `at`.
template <class Series>
[[nodiscard]] std::optional<Plan> plan_with_held_joints(const Run& run, Dimensions<double>& dimensions,
                                                        Coordinates<Series>& at) {
  std::optional<Plan> plan;
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    const auto* touching = std::get_if<TouchingBody>(&run.plan().groups[g].kind);
    if (touching == nullptr || run.row.contacts[touching->contact].touches) {
      continue;
    }
    plan = plan ? std::move(plan) : run.plan();
    Group& group = plan->groups[g];
    group.contacts.clear();
    group.drivers.push_back(static_cast<int>(dimensions.drivers.size()));
    const int joint = group.joints.front();
    dimensions.drivers.push_back(joint);
    at.drivers.push_back(
        Series(joint_motion(run.mechanism(), run.mechanism().joints[joint], run.row.bodies).position));
  }
  return plan;
}

/// solve_series() for run.row, except next to a change point. There the conditions divide rounding by the
/// k-th power of the distance at order k; series through the change point itself do not (ChangePoint). They
/// are along the path of a single driver; of several drivers along their motion in time, if that has no terms
/// beyond the second order. Bodies for which neither series is accurate are marked unknown.
/// \param plan  of the run, or with held joints
/// \param at    constant except for the drivers
template <class D, int N>
[[nodiscard]] SeriesMotion<D, N> row_series(const Run& run, const Plan& plan,
                                            const Dimensions<double>& values, const Dimensions<D>& dimensions,
                                            Coordinates<PowerSeries<D, N>> at,
                                            const SeriesOptions& options = {});

/// Whether row_series() takes the series through a change point; if not, `regular` changes nothing.
/// Independent of parameters of the dimensions.
[[nodiscard]] bool meets_change_point(const Run& run, const Dimensions<double>& values,
                                      Coordinates<PowerSeries<double, 3>> at, const SeriesOptions& options);

/// Whether rounding, which each order divides by the sine once more, exceeds what is tolerated in the
/// last of them.
[[nodiscard]] bool rounding_shows(double sine, std::size_t order, double tolerated = kRoundingOfSeries);

/// Whether a Jacobian leaves no freedom.
[[nodiscard]] bool is_regular(const Eigen::MatrixXd& J);

/// The series of a coordinate from its derivatives; those of too high an order are dropped.
template <int N, std::size_t kCount>
[[nodiscard]] PowerSeries<double, N> series_of(const std::array<double, kCount>& derivatives) {
  PowerSeries<double, N> series;
  for (std::size_t k = 0; k <= N && k < kCount; ++k) {
    series.c[k] = derivatives[k] / kFactorials[k];
  }
  return series;
}

/// The series of a driver whose acceleration is constant.
template <int N>
[[nodiscard]] PowerSeries<double, N> series_of_driver(const DriverMotion& driver) {
  return series_of<N>(std::array{driver.position, driver.velocity, driver.acceleration});
}

/// The series of a body from its motion, up to the N-th order of time.
template <int N>
[[nodiscard]] BodyAt<PowerSeries<double, N>> series_of_body(const BodyMotion& body,
                                                            const BodyJerk& jerk = {}) {
  const auto coordinate = [&](Eigen::Index i) {
    return series_of<N>(std::array{body.X_WB.p_WB(i), body.v_WB(i), body.a_WB(i), jerk.j_WB(i)});
  };
  const auto theta = series_of<N>(std::array{body.theta, body.omega, body.alpha, jerk.angular});
  const auto& [c, s] = body.X_WB.R_WB;
  const auto [cosine, sine] = cosine_and_sine(theta, c, s);
  return {{{cosine, sine}, {coordinate(0), coordinate(1)}}, theta};
}

}  // namespace higherpair

#pragma once

#include "group_expansion.hpp"
#include "higherpair/mechanism/condition_system.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "numeric/least_norm.hpp"
#include "series_motion.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <Eigen/Core>

namespace higherpair {

/// Solves for the series of one group order by order, with one decomposition of its Jacobian.
template <class D, int N>
class GroupSeries {
public:
  GroupSeries(const ConditionSystem& system, const Dimensions<D>& dimensions,
              Coordinates<PowerSeries<D, N>>& at)
      : group_(system, dimensions, at) {}

  /// Solves up to the order `last`. False where the conditions leave freedom.
  bool solve(std::size_t last) {
    const bool solved = solve_orders(last);
    group_.complete();
    return solved;
  }

  [[nodiscard]] double least_sine() const { return least_sine_; }

private:
  bool solve_orders(std::size_t last) {
    Eigen::MatrixXd J;
    if (!group_.jacobian(J)) {
      return false;
    }
    solver_.compute(J);
    least_sine_ = solver_.least_sine(J);
    if (solver_.rank() < J.cols()) {
      return false;
    }
    for (std::size_t k = 0; k <= std::min<std::size_t>(last, N); ++k) {
      for (std::size_t i = k == 0 ? 1 : 0; i < kParts<D>; ++i) {
        const Eigen::VectorXd x = solver_.solve(-group_.conditions(k, i));
        if (!x.allFinite()) {
          return false;
        }
        group_.add(k, i, x);
      }
    }
    return true;
  }

  GroupExpansion<D, N> group_;
  LeastNormSolver solver_{kRepeatedConditions};
  double least_sine_ = 0;
};

/// Leaves out the slip conditions of a set.
template <class D>
void drop_slip(const ConditionSet& set, Dimensions<D>& dimensions) {
  for (const int contact : set.contacts) {
    dimensions.contacts[contact].rolling = false;
  }
}

/// Solves the groups of a plan one after the other, up to the first that does not succeed.
/// \param solve  of a group, its conditions and the dimensions
template <class D, int N, class F>
void solve_groups(const Plan& plan, const Dimensions<double>& values, const Dimensions<D>& dimensions,
                  const SeriesOptions& options, SeriesMotion<D, N>& motion, F solve) {
  motion.known.front() = true;
  for (const Group& group : plan.groups) {
    if (options.has_rates != nullptr && !std::all_of(group.bodies.begin(), group.bodies.end(),
                                                     [&](int body) { return (*options.has_rates)[body]; })) {
      break;
    }
    const ConditionSet set = condition_set(plan, group);
    ConditionSystem system(values, set, plan.size);
    std::optional<Dimensions<D>> slipping;
    if (!options.surplus_slip && system.row_count() > system.column_count()) {
      Dimensions<double> slipping_values = values;
      drop_slip(set, slipping_values);
      slipping = dimensions;
      drop_slip(set, *slipping);
      system = ConditionSystem(std::move(slipping_values), set, plan.size);
    }
    if (!solve(group, system, slipping ? *slipping : dimensions)) {
      break;
    }
    for (const int body : group.bodies) {
      motion.known[body] = true;
    }
  }
}

}  // namespace higherpair

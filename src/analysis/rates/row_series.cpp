// The series of rows, next to change points too.
#include "analysis/tolerances.hpp"
#include "change_point.hpp"
#include "group_series.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "series_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace higherpair {
namespace {

// Order of the series of a row next to a change point. The terms fall as the powers of its distance in units
// of the series' reach: where they do not fall fast enough, the row is so far from it that rounding is not
// amplified much.
constexpr int kOrderOfChangePoint = 24;

// A row's motion as series of high order along its path: per unit of a single driver, else in time.
template <class D>
class LongSeries {
public:
  static constexpr int N = kOrderOfChangePoint;
  using Series = PowerSeries<D, N>;

  // \param at  of the row: values, with the drivers in time
  template <int M>
  LongSeries(const Run& run, const Coordinates<PowerSeries<D, M>>& at)
      : run_(run), by_driver_(run.mechanism().drivers.size() == 1) {
    motion_.known.assign(at.bodies.size(), false);
    motion_.at = constant<Series>(values_of(at));
    const auto take = [](const std::vector<PowerSeries<D, M>>& given, std::ptrdiff_t terms,
                         std::vector<Series>& longer) {
      for (std::size_t i = 0; i < given.size(); ++i) {
        std::copy_n(given[i].c.begin(), terms, longer[i].c.begin());
      }
    };
    take(at.arcs, 1, motion_.at.arcs);
    take(at.held_angles, 1, motion_.at.held_angles);
    take(at.drivers, M + 1, motion_.at.drivers);
    if (by_driver_) {
      Series& driver = motion_.at.drivers.front();
      driver = Series(driver.c[0]);
      driver.c[1] = D(1.0);
    }
  }

  // False where no change point matters: then the series of the row itself are as good.
  bool solve(const Plan& plan, const Dimensions<double>& values, const Dimensions<D>& dimensions,
             const SeriesOptions& options, std::size_t order) {
    solve_groups(plan, values, dimensions, options, motion_,
                 [&](const Group& group, const ConditionSystem& system, const Dimensions<D>& of) {
                   return solve_group(group, system, of, order);
                 });
    return matters_;
  }

  // In time. \param drivers  in time
  template <int M>
  [[nodiscard]] SeriesMotion<D, M> in_time(const std::vector<PowerSeries<D, M>>& drivers) const {
    PowerSeries<D, M> t;
    t.c[1] = D(1.0);
    if (by_driver_) {
      t = drivers.front();
      t.c[0] = D(0.0);
    }
    SeriesMotion<D, M> motion;
    motion.known = motion_.known;
    motion.diverges = motion_.diverges;
    for (const BodyAt<Series>& body : motion_.at.bodies) {
      const PowerSeries<D, M> theta = composed(body.theta, t);
      motion.at.bodies.push_back({{Rotation<PowerSeries<D, M>>::from_angle(theta),
                                   {composed(body.X_WB.p_WB.x(), t), composed(body.X_WB.p_WB.y(), t)}},
                                  theta});
    }
    const auto all = [&](const std::vector<Series>& from) {
      std::vector<PowerSeries<D, M>> to;
      for (const Series& one : from) to.push_back(composed(one, t));
      return to;
    };
    motion.at.phi = all(motion_.at.phi);
    motion.at.arcs = all(motion_.at.arcs);
    motion.at.held_angles = all(motion_.at.held_angles);
    motion.at.drivers = drivers;
    return motion;
  }

private:
  bool solve_group(const Group& group, const ConditionSystem& system, const Dimensions<D>& dimensions,
                   std::size_t order) {
    Coordinates<Series> beside = motion_.at;
    GroupSeries<D, N> regular(system, dimensions, motion_.at);
    const bool solved = regular.solve(N);
    if (!traits_of(group).can_cross || !rounding_shows(regular.least_sine(), order)) {
      return solved;
    }
    set_rates(group, beside);
    ChangePoint<D, N> point(system, dimensions, beside, is_exact(group));
    using Outcome = typename ChangePoint<D, N>::Outcome;
    const Outcome outcome = point.solve();
    const bool spoilt = rounding_shows(regular.least_sine(), order, kSpoiltSeries);
    if (outcome == Outcome::kNone || (outcome != Outcome::kReached && !spoilt)) {
      return solved;
    }
    matters_ = true;
    motion_.at = std::move(beside);
    motion_.diverges = motion_.diverges || outcome == Outcome::kDestroyed;
    return outcome == Outcome::kReached;
  }

  // The series x of t, of which t has no constant term.
  template <int M>
  [[nodiscard]] static PowerSeries<D, M> composed(const Series& x, const PowerSeries<D, M>& t) {
    PowerSeries<D, M> sum(x.c[M]);
    for (std::size_t k = M; k-- > 0;) {
      sum = sum * t + x.c[k];
    }
    return sum;
  }

  // Sets the first rates of a group as the row has them.
  void set_rates(const Group& group, Coordinates<Series>& at) const {
    const State& path = run_.at.shown();
    const auto& bodies = by_driver_ ? path.bodies : run_.row.bodies;
    const auto& contacts = by_driver_ ? path.contacts : run_.row.contacts;
    for (const int index : group.bodies) {
      BodyAt<Series>& body = at.bodies[index];
      body.X_WB.p_WB.x().c[1] = D(bodies[index].v_WB.x());
      body.X_WB.p_WB.y().c[1] = D(bodies[index].v_WB.y());
      body.theta.c[1] = D(bodies[index].omega);
      body.X_WB.R_WB = Rotation<Series>::from_angle(body.theta);
    }
    for (const int index : group.contacts) {
      at.phi[index].c[1] = D(contacts[index].rates.phi_dot);
    }
  }

  // Whether the dimensions hold elsewhere on the path, and the drivers are polynomials there.
  [[nodiscard]] bool is_exact(const Group& group) const {
    const auto& drivers = motion_.at.drivers;
    const bool smooth = std::all_of(drivers.begin(), drivers.end(), [](const Series& driver) {
      return std::all_of(driver.c.begin() + 3, driver.c.end(), [](const D& c) { return value_of(c) == 0; });
    });
    return smooth && std::none_of(group.contacts.begin(), group.contacts.end(), [&](int contact) {
             return run_.mechanism().contacts[contact].by_boundary;
           });
  }

  const Run& run_;
  bool by_driver_;
  SeriesMotion<D, N> motion_;
  bool matters_ = false;
};

}  // namespace

bool rounding_shows(double sine, std::size_t order, double tolerated) {
  const double rounding = std::numeric_limits<double>::epsilon();
  return rounding > tolerated * std::pow(sine, static_cast<double>(order + 1));
}

template <class D, int N>
SeriesMotion<D, N> row_series(const Run& run, const Plan& plan, const Dimensions<double>& values,
                              const Dimensions<D>& dimensions, Coordinates<PowerSeries<D, N>> at,
                              const SeriesOptions& options) {
  SeriesMotion<D, N> motion = solve_series(plan, values, dimensions, std::move(at), options);
  const std::size_t order = std::min<std::size_t>(options.last, N);
  if (!options.regular && rounding_shows(motion.least_sine, order)) {
    LongSeries<D> series(run, motion.at);
    if (series.solve(plan, values, dimensions, options, order)) {
      return series.in_time(motion.at.drivers);
    }
  }
  return motion;
}

bool meets_change_point(const Run& run, const Dimensions<double>& values,
                        Coordinates<PowerSeries<double, 3>> at, const SeriesOptions& options) {
  const auto motion = solve_series(run.plan(), values, values, std::move(at), options);
  return rounding_shows(motion.least_sine, options.last) &&
         LongSeries<double>(run, motion.at).solve(run.plan(), values, values, options, options.last);
}

template SeriesMotion<double, 3> row_series(const Run&, const Plan&, const Dimensions<double>&,
                                            const Dimensions<double>&, Coordinates<PowerSeries<double, 3>>,
                                            const SeriesOptions&);
template SeriesMotion<double, kHighestDerivative> row_series(
    const Run&, const Plan&, const Dimensions<double>&, const Dimensions<double>&,
    Coordinates<PowerSeries<double, kHighestDerivative>>, const SeriesOptions&);
template SeriesMotion<Partials<double, 1>, 2> row_series(const Run&, const Plan&, const Dimensions<double>&,
                                                         const Dimensions<Partials<double, 1>>&,
                                                         Coordinates<PowerSeries<Partials<double, 1>, 2>>,
                                                         const SeriesOptions&);

}  // namespace higherpair

#include "series_motion.hpp"

#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "numeric/least_norm.hpp"

#include <algorithm>

namespace higherpair {
namespace {

using Parametric = Partials<double, 1>;

// The parts of a coefficient, which are solved for one after the other: the number, and its partial.
template <class D>
constexpr std::size_t kParts = 1;
template <>
constexpr std::size_t kParts<Parametric> = 2;

double& part(double& coefficient, std::size_t /*i*/) {
  return coefficient;
}
double& part(Parametric& coefficient, std::size_t i) {
  return coefficient.c[i];
}

template <class D, int N>
class GroupSeries {
public:
  using Series = PowerSeries<D, N>;

  GroupSeries(const ConditionSystem& system, const Dimensions<D>& dimensions, Coordinates<Series>& at)
      : system_(system), dimensions_(dimensions), at_(at) {}

  // Solves up to the order `last` of time. False where the conditions leave freedom.
  bool solve(std::size_t last) {
    Eigen::VectorXd values;
    Eigen::MatrixXd J;
    system_.evaluate(start(), values, J);
    if (!J.allFinite()) {
      return false;
    }
    solver_.compute(J);
    if (solver_.rank() < J.cols()) {
      return false;
    }
    for (std::size_t k = 0; k <= std::min<std::size_t>(last, Series::kLast); ++k) {
      for (std::size_t i = k == 0 ? 1 : 0; i < kParts<D>; ++i) {
        if (!solve_part(k, i)) {
          return false;
        }
      }
    }
    return true;
  }

private:
  [[nodiscard]] Coordinates<double> start() const {
    Coordinates<double> start;
    const auto values = [](const std::vector<Series>& series) {
      std::vector<double> numbers;
      for (const Series& one : series) {
        numbers.push_back(value_of(one));
      }
      return numbers;
    };
    for (const BodyAt<Series>& body : at_.bodies) {
      const auto& [R_WB, p_WB] = body.X_WB;
      start.bodies.push_back(
          {{{value_of(R_WB.cos), value_of(R_WB.sin)}, {value_of(p_WB.x()), value_of(p_WB.y())}},
           value_of(body.theta)});
    }
    start.phi = values(at_.phi);
    start.arcs = values(at_.arcs);
    start.drivers = values(at_.drivers);
    start.held_angles = values(at_.held_angles);
    return start;
  }

  bool solve_part(std::size_t k, std::size_t i) {
    values_.clear();
    append_conditions(dimensions_, system_.set(), at_, system_.size(), values_);
    Eigen::VectorXd left(system_.row_count());
    for (Eigen::Index row = 0; row < left.size(); ++row) {
      left(row) = part(values_[row].c[k], i);
    }
    const Eigen::VectorXd x = solver_.solve(-left);
    if (!x.allFinite()) {
      return false;
    }
    const double size = system_.size();
    for (const int index : system_.set().bodies) {
      BodyAt<Series>& body = at_.bodies[index];
      const Eigen::Index column = system_.body_column(index);
      part(body.X_WB.p_WB.x().c[k], i) = x(column);
      part(body.X_WB.p_WB.y().c[k], i) = x(column + 1);
      part(body.theta.c[k], i) = x(column + 2) / size;
      body.X_WB.R_WB = Rotation<Series>::from_angle(body.theta);
    }
    for (const int contact : system_.set().contacts) {
      part(at_.phi[contact].c[k], i) = x(system_.contact_column(contact)) / size;
    }
    return true;
  }

  const ConditionSystem& system_;
  const Dimensions<D>& dimensions_;
  Coordinates<Series>& at_;
  LeastNormSolver solver_{kRepeatedConditions};
  std::vector<Series> values_;
};

template <class D>
void drop_slip(const ConditionSet& set, Dimensions<D>& dimensions) {
  for (const int contact : set.contacts) {
    dimensions.contacts[contact].rolling = false;
  }
}

}  // namespace

bool is_regular(const Eigen::MatrixXd& J) {
  return J.allFinite() && LeastNormSolver(J, kRepeatedConditions).rank() == J.cols();
}

ConditionSet condition_set(const Plan& plan, const Group& group) {
  return {group.bodies, group.joints, group.contacts, group.drivers, idle_bodies_of(plan, group)};
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
    const BodyAt<double>& first = at.bodies[contact.first];
    const BodyAt<double>& second = at.bodies[contact.second];
    at.arcs[i] = arc_difference(contact.curve1, first, contact.curve2, second,
                                facing_points(contact.curve1, first, contact.curve2, second, at.phi[i]));
    ++i;
  }
  return at;
}

template <class D, int N>
SeriesMotion<D, N> solve_series(const Plan& plan, const Dimensions<double>& values,
                                const Dimensions<D>& dimensions, Coordinates<PowerSeries<D, N>> at,
                                const SeriesOptions& options) {
  SeriesMotion<D, N> motion{std::move(at), std::vector<bool>(dimensions.bodies, false)};
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
    if (!GroupSeries<D, N>(system, slipping ? *slipping : dimensions, motion.at).solve(options.last)) {
      break;
    }
    for (const int body : group.bodies) {
      motion.known[body] = true;
    }
  }
  return motion;
}

template SeriesMotion<double, 3> solve_series(const Plan&, const Dimensions<double>&,
                                              const Dimensions<double>&, Coordinates<PowerSeries<double, 3>>,
                                              const SeriesOptions&);
template SeriesMotion<double, kHighestDerivative> solve_series(
    const Plan&, const Dimensions<double>&, const Dimensions<double>&,
    Coordinates<PowerSeries<double, kHighestDerivative>>, const SeriesOptions&);
template SeriesMotion<Parametric, 2> solve_series(const Plan&, const Dimensions<double>&,
                                                  const Dimensions<Parametric>&,
                                                  Coordinates<PowerSeries<Parametric, 2>>,
                                                  const SeriesOptions&);

}  // namespace higherpair

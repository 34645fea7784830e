#include "higherpair/analysis/sensitivity.hpp"

#include "higherpair/geometry/stencil.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/numbers.hpp"
#include "series_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Core>

namespace higherpair {
namespace {

using Parametric = Partials<double, 1>;
using ParametricSeries = PowerSeries<Parametric, 2>;

// Largest displacement of a row for differences: what they leave, of its eighth power, is below rounding, and
// rounding is not enlarged much.
constexpr double kDisplacement = 4e-3;

// A jump between the samples next to 0 makes most of the difference of those farthest from it, and is more
// than this of their size.
constexpr double kJump = 0.6;
constexpr double kJumpOf = 1e-2;

// Slip, in the mechanism's size, by a unit change of a coordinate: one that does not matter.
constexpr double kNoInfluence = 1e-9;

// Share by which differences of two steps may disagree before the dimensions count as not smooth.
constexpr double kNotSmooth = 1e-6;

Parametric parametric(double value, double derivative) {
  Parametric number(value);
  number.c[1] = derivative;
  return number;
}

double partial(const ParametricSeries& series, std::size_t k) {
  return series.c[k].c[1];
}

// The coordinate of a joint in the poses of the description.
Parametric posed_coordinate(const Mechanism& mechanism, const Mechanism& derivative,
                            const Dimensions<Parametric>::Joint& joint) {
  const auto posed = [&](int index) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(index)];
    const Body by_p = index == 0 ? Body() : derivative.bodies[static_cast<std::size_t>(index)];
    const Parametric theta = parametric(body.guess_theta, by_p.guess_theta);
    return BodyAt<Parametric>{{Rotation<Parametric>::from_angle(theta),
                               {parametric(body.guess_p_WB.x(), by_p.guess_p_WB.x()),
                                parametric(body.guess_p_WB.y(), by_p.guess_p_WB.y())}},
                              theta};
  };
  return joint_coordinate(joint.of, posed(joint.first), posed(joint.second), posed(joint.carrier));
}

// The position in which a run is started: nothing is held by rolling yet.
struct Start {
  Plan plan;
  Dimensions<double> values;
  Dimensions<Parametric> dimensions;
  Coordinates<double> numbers;
  Coordinates<ParametricSeries> at;
};

bool is_placed(const Start& start, const Group& group) {
  const ConditionSystem system(start.values, condition_set(start.plan, group), start.plan.size);
  Eigen::VectorXd values;
  Eigen::MatrixXd J;
  system.evaluate(start.numbers, values, J);
  return is_regular(J);
}

// A follower that its contact does not place to first order, held as if it were driven.
struct HeldFollower {
  std::size_t driver = 0;  // of Start::at
  const TrackedPair* pair = nullptr;
  double by_pose = 0;  // derivative of its coordinate in its pose
};

std::vector<HeldFollower> hold_loose_followers(const Mechanism& mechanism, const Mechanism& derivative,
                                               Start& start) {
  std::vector<HeldFollower> held;
  for (Group& group : start.plan.groups) {
    const auto* tracked = std::get_if<TrackedPair>(&group.kind);
    if (tracked == nullptr || !mechanism.contacts[static_cast<std::size_t>(tracked->contact)].rolling ||
        is_placed(start, group)) {
      continue;
    }
    const int joint = group.joints.front();
    const Parametric posed =
        posed_coordinate(mechanism, derivative, start.dimensions.joints[static_cast<std::size_t>(joint)]);
    held.push_back({start.values.drivers.size(), tracked, posed.c[1]});
    group.drivers.push_back(static_cast<int>(start.values.drivers.size()));
    start.values.drivers.push_back(joint);
    start.dimensions.drivers.push_back(joint);
    start.at.drivers.emplace_back(posed);
    start.numbers.drivers.push_back(posed.c[0]);
  }
  return held;
}

// Velocity of a point in ground for a unit rate of a joint to ground, lengths by the size.
Vector2<ParametricSeries> velocity_per_coordinate(const Start& start, const Coordinates<ParametricSeries>& at,
                                                  int joint, const Vector2<ParametricSeries>& p_W) {
  const auto& of = start.dimensions.joints[static_cast<std::size_t>(joint)];
  const BodyAt<ParametricSeries>& first = at.bodies[static_cast<std::size_t>(of.first)];
  if (of.of.type == JointType::kRevolute) {
    return perp(Vector2<ParametricSeries>(p_W - first.point(of.of.p_A))) / ParametricSeries(start.plan.size);
  }
  return first.vector(of.of.direction_A);
}

// How fast, with p, the material points at the contact cease to be able to have one velocity.
double rate_of_slip(const Mechanism& mechanism, const Start& start, const HeldFollower& held,
                    const Coordinates<ParametricSeries>& at) {
  const auto index = static_cast<std::size_t>(held.pair->contact);
  const auto& contact = start.dimensions.contacts[index];
  const FacingPoints<ParametricSeries> facing =
      facing_points(contact.curve1, at.bodies[static_cast<std::size_t>(contact.first)], contact.curve2,
                    at.bodies[static_cast<std::size_t>(contact.second)], at.phi[index]);
  const bool flat1 = contact.curve1.kind == CurveKind::kLine;
  const Vector2<ParametricSeries>& p_W = flat1 ? facing.p2_W : facing.p1_W;
  const int driver = mechanism.drivers[static_cast<std::size_t>(held.pair->driver)].joint;
  return partial(cross(velocity_per_coordinate(start, at, driver, p_W),
                       velocity_per_coordinate(start, at, start.values.drivers[held.driver], p_W)),
                 0);
}

// What every body keeps that keeps the angle of its pose.
void set_held_angles(const Mechanism& derivative, Coordinates<ParametricSeries>& at) {
  for (std::size_t i = 0; i < at.held_angles.size(); ++i) {
    at.held_angles[i].c[0].c[1] = derivative.bodies[i].guess_theta;
  }
}

Start start_of(const Run& run, const Mechanism& derivative, const std::vector<double>& drivers) {
  Start start{run.plan(),
              dimensions_of(run.mechanism()),
              dimensions_of(run.mechanism(), derivative),
              row_coordinates(run),
              {}};
  start.at = constant<ParametricSeries>(start.numbers);
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    start.at.drivers[i].c[0].c[1] = drivers[i];
  }
  set_held_angles(derivative, start.at);
  start.plan.idle_bodies.insert(start.plan.idle_bodies.end(), run.plan().phase_bodies.begin(),
                                run.plan().phase_bodies.end());
  for (std::size_t i = 0; i < start.values.contacts.size(); ++i) {
    start.values.contacts[i].rolling = start.dimensions.contacts[i].rolling = false;
  }
  return start;
}

bool all_known(const SeriesMotion<Parametric, 2>& motion) {
  return std::all_of(motion.known.begin(), motion.known.end(), [](bool known) { return known; });
}

// Largest of all displacements for a unit of p: angles, lengths by the size, speeds by the largest.
double displacement_of(const Run& run, const Sensitivity& by, const RowSensitivity& of_row) {
  const double size = run.plan().size;
  double speed = 0, acceleration = 0, displaced = 0, faster = 0, accelerated = 0;
  for (std::size_t i = 0; i < of_row.bodies.size(); ++i) {
    const BodyMotion& body = run.row.bodies[i];
    const BodyMotion& change = of_row.bodies[i];
    speed = std::max({speed, body.v_WB.norm(), size * std::abs(body.omega)});
    acceleration = std::max({acceleration, body.a_WB.norm(), size * std::abs(body.alpha)});
    displaced = std::max({displaced, change.X_WB.p_WB.norm() / size, std::abs(change.theta)});
    faster = std::max({faster, change.v_WB.norm(), size * std::abs(change.omega)});
    accelerated = std::max({accelerated, change.a_WB.norm(), size * std::abs(change.alpha)});
  }
  for (const double phi : of_row.phi) {
    displaced = std::max(displaced, std::abs(phi));
  }
  for_each_number(by.derivative(), [&](double change, NumberKind kind) {
    if (kind != NumberKind::kLoad) {
      displaced = std::max(displaced, std::abs(change) / (kind == NumberKind::kLength ? size : 1));
    }
  });
  // Where a speed is largest there may be no acceleration, and the other way round.
  const double fast = std::max(speed, std::sqrt(acceleration * size));
  const double strong = std::max(acceleration, speed * speed / size);
  return std::max({displaced, fast > 0 ? faster / fast : 0, strong > 0 ? accelerated / strong : 0});
}

// The points at each contact need not coincide.
void displace(const RowSensitivity& by_p, double h, const Mechanism& mechanism, MotionRow& row) {
  for (std::size_t i = 1; i < row.bodies.size(); ++i) {
    BodyMotion& body = row.bodies[i];
    const BodyMotion& change = by_p.bodies[i];
    body.theta += h * change.theta;
    body.X_WB = {Rotation<double>::from_angle(body.theta), body.X_WB.p_WB + h * change.X_WB.p_WB};
    body.v_WB += h * change.v_WB;
    body.omega += h * change.omega;
    body.a_WB += h * change.a_WB;
    body.alpha += h * change.alpha;
  }
  const Dimensions<double> dimensions = dimensions_of(mechanism);
  for (std::size_t i = 0; i < row.contacts.size(); ++i) {
    const auto& contact = dimensions.contacts[i];
    const BodyMotion& body1 = row.bodies[static_cast<std::size_t>(contact.first)];
    const BodyMotion& body2 = row.bodies[static_cast<std::size_t>(contact.second)];
    ContactMotion& motion = row.contacts[i];
    motion.phi += h * by_p.phi[i];
    motion.arc_difference += h * by_p.arcs[i];
    motion.at = facing_at(contact, {body1.X_WB, body1.theta}, {body2.X_WB, body2.theta}, motion.phi)
                    .value_or(motion.at);
    motion.rates = contact_rates(
        equivalent_link(is_line(curve_of(mechanism, mechanism.contacts[i].first)), motion.at.rho1,
                        is_line(curve_of(mechanism, mechanism.contacts[i].second)), motion.at.rho2),
        motion.at, body1, body2);
  }
}

// Where no coordinate changes everything is a polynomial of the loads.
double step_of_loads(const Run& run, const Sensitivity& by) {
  double largest = 1;
  std::vector<double> numbers;
  for_each_number(run.mechanism(), [&](double number) { numbers.push_back(number); });
  for_each_number(by.derivative(), [&, i = std::size_t{0}](double change) mutable {
    const double number = numbers[i++];
    largest = change != 0 ? std::max(largest, std::abs(number / change)) : largest;
  });
  return largest;
}

// Where the samples of the two sides of 0 are apart by more than a smooth function can be, that of the side
// to which 0 belongs: an arc begins elsewhere, by a turn, where its curve's axis turns through an angle of π.
// \param at  (0: +, 1: -; number of steps)
template <class F>
double derivative_of_samples(F at, double h) {
  const double near = std::abs(at(0, 1) - at(1, 1));
  const double far = std::abs(at(0, 4) - at(1, 4));
  const bool jumps = near > kJump * far && near > kJumpOf * (std::abs(at(0, 1)) + std::abs(at(1, 1)));
  if (!jumps) {
    return eighth_order_difference(
        [&](double step) {
          const double k = std::round(step / h);
          return at(k > 0 ? 0 : 1, static_cast<std::size_t>(std::abs(k)));
        },
        h);
  }
  const std::size_t side = std::abs(at(0, 1) - at(0, 0)) < std::abs(at(1, 1) - at(1, 0)) ? 0 : 1;
  const double slope =
      -25 * at(side, 0) + 48 * at(side, 1) - 36 * at(side, 2) + 16 * at(side, 3) - 3 * at(side, 4);
  return slope / (side == 0 ? 12 * h : -12 * h);
}

}  // namespace

std::optional<Sensitivity> Sensitivity::at_start(const Run& run, const Mechanism& derivative,
                                                 const std::vector<double>& drivers) {
  // The numbers that a boundary was made from are not among those of the mechanism.
  if (std::any_of(run.mechanism().contacts.begin(), run.mechanism().contacts.end(),
                  [](const Contact& contact) { return contact.by_boundary; })) {
    return std::nullopt;
  }
  Start start = start_of(run, derivative, drivers);
  const auto solved = [&] { return solve_series(start.plan, start.values, start.dimensions, start.at); };
  // Their contact point has to be where both joints let it have one velocity; discs about their centres, for
  // which that is so in any position, keep the one of the pose.
  for (const HeldFollower& held : hold_loose_followers(run.mechanism(), derivative, start)) {
    const auto rate_with = [&](double by_p) {
      start.at.drivers[held.driver].c[0].c[1] = by_p;
      return rate_of_slip(run.mechanism(), start, held, solved().at);
    };
    const double without = rate_with(0);
    const double change = rate_with(1) - without;
    start.at.drivers[held.driver].c[0].c[1] =
        std::abs(change) > kNoInfluence ? -without / change : held.by_pose;
  }
  const auto motion = solved();
  if (!all_known(motion)) {
    return std::nullopt;
  }
  Sensitivity sensitivity;
  sensitivity.derivative_ = derivative;
  for (std::size_t i = 0; i < run.mechanism().contacts.size(); ++i) {
    const auto& contact = start.dimensions.contacts[i];
    const BodyAt<ParametricSeries>& body1 = motion.at.bodies[static_cast<std::size_t>(contact.first)];
    const BodyAt<ParametricSeries>& body2 = motion.at.bodies[static_cast<std::size_t>(contact.second)];
    const ParametricSeries arcs =
        !run.mechanism().contacts[i].rolling
            ? ParametricSeries()
            : arc_difference(contact.curve1, body1, contact.curve2, body2,
                             facing_points(contact.curve1, body1, contact.curve2, body2, motion.at.phi[i]));
    sensitivity.arcs_.push_back(partial(arcs, 0));
  }
  return sensitivity;
}

std::optional<RowSensitivity> Sensitivity::of_row(const Run& run, const std::vector<DriverMotion>& motions,
                                                  const std::vector<DriverMotion>& derivatives) const {
  if (run.row.status == RowStatus::kNotAssemblable || !run.row.all_rates) {
    return std::nullopt;
  }
  Coordinates<ParametricSeries> at = constant<ParametricSeries>(row_coordinates(run));
  for (std::size_t i = 0; i < motions.size(); ++i) {
    at.drivers[i].c = {parametric(motions[i].position, derivatives[i].position),
                       parametric(motions[i].velocity, derivatives[i].velocity),
                       parametric(motions[i].acceleration / 2, derivatives[i].acceleration / 2)};
  }
  for (std::size_t i = 0; i < at.arcs.size(); ++i) {
    at.arcs[i].c[0].c[1] = arcs_[i];
  }
  set_held_angles(derivative_, at);
  const auto motion = solve_series(run.plan(), dimensions_of(run.mechanism()),
                                   dimensions_of(run.mechanism(), derivative_), std::move(at));
  if (!all_known(motion)) {
    return std::nullopt;
  }
  RowSensitivity of_row;
  for (const BodyAt<ParametricSeries>& body : motion.at.bodies) {
    const auto vector = [&](std::size_t k) {
      return Vector2d(partial(body.X_WB.p_WB.x(), k), partial(body.X_WB.p_WB.y(), k));
    };
    of_row.bodies.push_back({{{}, vector(0)},
                             partial(body.theta, 0),
                             vector(1),
                             partial(body.theta, 1),
                             2 * vector(2),
                             2 * partial(body.theta, 2)});
  }
  for (const ParametricSeries& phi : motion.at.phi) {
    of_row.phi.push_back(partial(phi, 0));
    of_row.phi_dot.push_back(partial(phi, 1));
  }
  of_row.arcs = arcs_;
  return of_row;
}

std::vector<double> derivative_along(const Run& run, const Sensitivity& by, const RowSensitivity& of_row,
                                     const std::function<std::vector<double>(const Run&, double)>& f) {
  const double displacement = displacement_of(run, by, of_row);
  const double h = displacement > 0 ? kDisplacement / displacement : step_of_loads(run, by);
  const auto values_at = [&](double step) -> Eigen::VectorXd {
    Run displaced_run = run;
    Mechanism mechanism = displaced(run.mechanism(), by.derivative(), step);
    displace(of_row, step, mechanism, displaced_run.row);
    displaced_run.local = std::move(mechanism);
    const std::vector<double> values = f(displaced_run, step);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  };
  // Of 0 … 4 steps to either side.
  std::array<std::array<Eigen::VectorXd, 5>, 2> samples;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t k = 0; k < 5; ++k) {
      samples[side][k] = values_at((side == 0 ? h : -h) * static_cast<double>(k));
    }
  }
  std::vector<double> derivatives;
  for (Eigen::Index i = 0; i < samples[0][0].size(); ++i) {
    derivatives.push_back(
        derivative_of_samples([&](std::size_t side, std::size_t k) { return samples[side][k](i); }, h));
  }
  return derivatives;
}

Mechanism displaced(Mechanism mechanism, const Mechanism& derivative, double h) {
  std::vector<double> changes;
  for_each_number(derivative, [&](double change) { changes.push_back(h * change); });
  for_each_number(mechanism, [&, i = std::size_t{0}](double& number) mutable { number += changes[i++]; });
  return mechanism;
}

std::optional<Mechanism> mechanism_derivative(const std::function<std::optional<Mechanism>(double)>& at,
                                              double h) {
  std::optional<Mechanism> derivative = at(0);
  if (!derivative) {
    return std::nullopt;
  }
  Eigen::Index count = 0;
  for_each_number(*derivative, [&](double /*number*/) { ++count; });
  bool made = true;
  const auto numbers_at = [&](double step) {
    Eigen::VectorXd numbers = Eigen::VectorXd::Zero(count);
    if (const auto mechanism = at(step)) {
      for_each_number(*mechanism, [&, i = Eigen::Index{0}](double number) mutable { numbers(i++) = number; });
    } else {
      made = false;
    }
    return numbers;
  };
  const Eigen::VectorXd wide = eighth_order_difference(numbers_at, h);
  const Eigen::VectorXd narrow = eighth_order_difference(numbers_at, h / 2);
  if (!made || (wide - narrow).lpNorm<Eigen::Infinity>() > kNotSmooth * wide.lpNorm<Eigen::Infinity>()) {
    return std::nullopt;
  }
  for_each_number(*derivative, [&, i = Eigen::Index{0}](double& number) mutable { number = wide(i++); });
  return derivative;
}

}  // namespace higherpair

#include "higherpair/analysis/displaced.hpp"

#include "higherpair/geometry/stencil.hpp"
#include "higherpair/mechanism/condition_system.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Core>

namespace higherpair {
namespace {

// Largest displacement of a row for differences: what they leave, of its eighth power, is below rounding, and
// rounding is not enlarged much.
constexpr double kDisplacement = 4e-3;

// A jump between the samples next to 0 makes most of the difference of those farthest from it, and is more
// than this of their size.
constexpr double kJump = 0.6;
constexpr double kJumpOf = 1e-2;

// Share by which differences of two steps may disagree before the dimensions count as not smooth.
constexpr double kNotSmooth = 1e-6;

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

#include "higherpair/analysis/displaced.hpp"

#include "higherpair/geometry/stencil.hpp"
#include "higherpair/mechanism/condition_system.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/numbers.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Core>

namespace higherpair {
namespace {

// Largest displacement of a row for a unit of p: angles, lengths relative to the size, speeds and
// accelerations relative to the largest.
double displacement_of(const Run& run, const Mechanism& derivative, const RowSensitivity& of_row) {
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
  for_each_number(derivative, [&](double change, NumberKind kind) {
    if (kind != NumberKind::kLoad) {
      const double unit = kind == NumberKind::kLength ? size
                          : kind == NumberKind::kBend ? 1 / (size * size)
                                                      : 1;
      displaced = std::max(displaced, std::abs(change) / unit);
    }
  });
  // Speed and acceleration are each estimated from the other, too, as either may be 0 in this row.
  const double fast = std::max(speed, std::sqrt(acceleration * size));
  const double strong = std::max(acceleration, speed * speed / size);
  return std::max({displaced, fast > 0 ? faster / fast : 0, strong > 0 ? accelerated / strong : 0});
}

// Displaces a row by h of p. The two points of each contact need not coincide afterwards.
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
    const BodyMotion& body1 = row.bodies[contact.first];
    const BodyMotion& body2 = row.bodies[contact.second];
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

// The step if p changes no coordinate: everything is then a polynomial of the loads.
double step_of_loads(const Run& run, const Mechanism& derivative) {
  double largest = 1;
  std::vector<double> numbers;
  for_each_number(run.mechanism(), [&](double number) { numbers.push_back(number); });
  for_each_number(derivative, [&, i = std::size_t{0}](double change) mutable {
    const double number = numbers[i++];
    largest = change != 0 ? std::max(largest, std::abs(number / change)) : largest;
  });
  return largest;
}

// Derivative at 0 from samples on both sides. If the slopes of the two sides differ by more than a smooth
// function allows, there is a kink or a jump: at 0 itself if both sides are smooth, as that of a size |x| at
// x = 0, and then each side has its own slope. Otherwise it is beside 0, and the slope is that of the side
// without it: an angle's size has its kink nearby, and an arc starts elsewhere, a full turn away, when its
// curve's axis turns through an angle of π. \param at  (0: +, 1: -; number of steps)
template <class F>
SidedSlope slope_of_samples(F at, double h) {
  std::array<double, 2> slope{}, bend{};
  double largest = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto f = [&](std::size_t k) { return at(side, k); };
    slope[side] =
        (-25 * f(0) + 48 * f(1) - 36 * f(2) + 16 * f(3) - 3 * f(4)) / (side == 0 ? 12 * h : -12 * h);
    bend[side] = std::abs(f(0) - 4 * f(1) + 6 * f(2) - 4 * f(3) + f(4));
    largest = std::max({largest, std::abs(f(0)), std::abs(f(4))});
  }
  const std::size_t smooth = bend[0] <= bend[1] ? 0 : 1;
  const double apart = h * std::abs(slope[0] - slope[1]);
  const double none = kKinkOfBends * bend[smooth] +
                      kKinkOfSlopes * h * std::max(std::abs(slope[0]), std::abs(slope[1])) +
                      kKinkOfValues * largest;
  const bool kink = apart > none;
  if (kink && bend[1 - smooth] > none) {
    return {slope[smooth], slope[smooth]};
  }
  const bool mirrored = h * std::abs(slope[0] + slope[1]) <= none;
  if (kink && !mirrored) {
    return {slope[1], slope[0]};
  }
  // With its sign a size is smooth.
  const double down = kink ? -1 : 1;
  const double both = eighth_order_difference(
      [&](double step) {
        const double k = std::round(step / h);
        const double change = at(k > 0 ? 0 : 1, static_cast<std::size_t>(std::abs(k))) - at(0, 0);
        return k > 0 ? change : down * change;
      },
      h);
  return {down * both, both};
}

// Largest relative change of a radius of curvature by a displacement: the radii of nearly flat curves change
// faster than all other numbers.
double change_of_radii(const MotionRow& row, const MotionRow& displaced) {
  double change = 0;
  for (std::size_t i = 0; i < row.contacts.size(); ++i) {
    for (const auto rho : {&CommonNormal::rho1, &CommonNormal::rho2}) {
      const double own = row.contacts[i].at.*rho;
      const double off = std::abs(displaced.contacts[i].at.*rho - own);
      change = own != 0 && std::isfinite(off) ? std::max(change, off / std::abs(own)) : change;
    }
  }
  return change;
}

}  // namespace

std::vector<SidedSlope> slopes_along(const Run& run, const Sensitivity& by, const RowSensitivity& of_row,
                                     const std::function<std::vector<double>(const Run&, double)>& f) {
  const Mechanism derivative = by.derivative_at(run, &of_row);
  const double displacement = displacement_of(run, derivative, of_row);
  double h = displacement > 0 ? kLargestDisplacement / displacement : step_of_loads(run, derivative);
  const auto run_at = [&](double step) {
    Run displaced_run = run;
    Mechanism mechanism = displaced(run.mechanism(), derivative, step);
    displace(of_row, step, mechanism, displaced_run.row);
    displaced_run.local = std::move(mechanism);
    return displaced_run;
  };
  const double radii = change_of_radii(run.row, run_at(kRadiiProbe * h).row) / kRadiiProbe;
  h *= radii > kLargestDisplacement ? kLargestDisplacement / radii : 1;
  const auto values_at = [&](double step) -> Eigen::VectorXd {
    const Run displaced_run = run_at(step);
    const std::vector<double> values = f(displaced_run, step);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  };
  // Values at 0 … 4 steps to either side.
  std::array<std::array<Eigen::VectorXd, 5>, 2> samples;
  samples[0][0] = samples[1][0] = values_at(0);
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t k = 1; k < 5; ++k) {
      samples[side][k] = values_at((side == 0 ? h : -h) * static_cast<double>(k));
    }
  }
  std::vector<SidedSlope> slopes;
  for (Eigen::Index i = 0; i < samples[0][0].size(); ++i) {
    slopes.push_back(
        slope_of_samples([&](std::size_t side, std::size_t k) { return samples[side][k](i); }, h));
  }
  return slopes;
}

std::vector<double> derivative_along(const Run& run, const Sensitivity& by, const RowSensitivity& of_row,
                                     const std::function<std::vector<double>(const Run&, double)>& f) {
  std::vector<double> derivatives;
  for (const SidedSlope& slope : slopes_along(run, by, of_row, f)) {
    derivatives.push_back((slope.down + slope.up) / 2);
  }
  return derivatives;
}

Mechanism displaced(Mechanism mechanism, const Mechanism& derivative, double h) {
  std::vector<double> changes;
  for_each_number(derivative, [&](double change) { changes.push_back(h * change); });
  for_each_number(mechanism, [&, i = std::size_t{0}](double& number) mutable { number += changes[i++]; });
  return mechanism;
}

std::optional<MechanismDerivative> mechanism_derivative(
    const std::function<std::optional<Mechanism>(double)>& at, double h, double scale) {
  std::array<std::optional<Mechanism>, 9> made;  // index: number of steps + 4
  for (const int steps : {0, 4, -4, 3, -3, 2, -2, 1, -1}) {
    auto& mechanism = made[steps + 4] = at(steps * h);
    if (!mechanism) {
      return std::nullopt;
    }
  }
  const auto numbers_at = [&](double step) -> Eigen::VectorXd {
    const std::vector<double> numbers = numbers_of(*made[std::lround(step / h) + 4]);
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  };
  const Eigen::VectorXd slopes = eighth_order_difference(numbers_at, h);
  const Eigen::VectorXd coarse = sixth_order_difference(numbers_at, h);
  if ((slopes - coarse).lpNorm<Eigen::Infinity>() > kDimensionsNotSmooth * slopes.lpNorm<Eigen::Infinity>()) {
    return std::nullopt;
  }
  BoundaryDerivatives::Family family;
  std::transform(made.begin(), made.end(), family.begin(), [](const auto& mechanism) { return &*mechanism; });
  auto boundaries = BoundaryDerivatives::of(family, h);
  if (!boundaries) {
    return std::nullopt;
  }
  MechanismDerivative derivative;
  derivative.step = h;
  derivative.error = boundaries->error(scale);
  if (!(derivative.error <= kBoundariesDisagree)) {
    return std::nullopt;
  }
  if (boundaries->largest(scale) > kBoundariesStandStill) {
    derivative.boundaries = std::make_shared<const BoundaryDerivatives>(*std::move(boundaries));
  }
  derivative.numbers = *std::move(made[4]);
  for_each_number(derivative.numbers,
                  [&, i = Eigen::Index{0}](double& number) mutable { number = slopes(i++); });
  return derivative;
}

std::optional<MechanismDerivative> mechanism_derivative(
    const std::function<std::optional<Mechanism>(double)>& at, double scale) {
  std::optional<MechanismDerivative> best;
  for (const double share : kParameterSteps) {
    auto derivative = mechanism_derivative(at, share * scale, scale);
    if (derivative && (!best || derivative->error < best->error)) {
      best = std::move(derivative);
    }
    if (best && best->error <= kBoundariesAgree) {
      break;
    }
  }
  return best;
}

}  // namespace higherpair

#include "higherpair/analysis/displaced.hpp"

#include "analysis/boundaries/span_ends.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/mechanism/condition_system.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/numbers.hpp"
#include "higherpair/numeric/stencil.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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
      displaced = std::max(displaced, std::abs(change) / (kind == NumberKind::kLength ? size : 1));
    }
  });
  // Speed and acceleration are each estimated from the other, too, as either may be 0 in this row.
  const double fast = std::max(speed, std::sqrt(acceleration * size));
  const double strong = std::max(acceleration, speed * speed / size);
  return std::max({displaced, fast > 0 ? faster / fast : 0, strong > 0 ? accelerated / strong : 0});
}

bool is_on_boundaries(const Run& run, std::size_t contact) {
  return run.mechanism().contacts[contact].by_boundary && run.row.contacts[contact].touches;
}

// A run that can be displaced along its sensitivity to p.
class Displaceable {
public:
  Displaceable(const Run& run, const Sensitivity& by, const RowSensitivity& of_row)
      : run_(run), derivative_(by.derivative()), of_row_(of_row), places_(run.row.contacts.size()) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (is_on_boundaries(run, i)) {
        places_[i] = by.of_places(run, of_row, i);
      }
    }
  }

  // The run displaced by h of p. The two points of each contact need not coincide afterwards.
  [[nodiscard]] Run by(double h) const {
    Run other = run_;
    other.local = displaced(run_.mechanism(), derivative_, h);
    other.is_displaced = true;
    displace_bodies(h, other.row);
    const Dimensions<double> dimensions = dimensions_of(other.mechanism());
    for (std::size_t i = 0; i < other.row.contacts.size(); ++i) {
      displace_contact(i, h, dimensions.contacts[i], other);
    }
    return other;
  }

private:
  void displace_bodies(double h, MotionRow& row) const {
    for (std::size_t i = 1; i < row.bodies.size(); ++i) {
      BodyMotion& body = row.bodies[i];
      const BodyMotion& change = of_row_.bodies[i];
      body.theta += h * change.theta;
      body.X_WB = {Rotation<double>::from_angle(body.theta), body.X_WB.p_WB + h * change.X_WB.p_WB};
      body.v_WB += h * change.v_WB;
      body.omega += h * change.omega;
      body.a_WB += h * change.a_WB;
      body.alpha += h * change.alpha;
    }
  }

  void displace_contact(std::size_t i, double h, const Dimensions<double>::Contact& dimensions,
                        Run& other) const {
    const Contact& contact = other.mechanism().contacts[i];
    const BodyMotion& body1 = other.row.bodies[contact.first.body];
    const BodyMotion& body2 = other.row.bodies[contact.second.body];
    ContactMotion& motion = other.row.contacts[i];
    motion.phi += h * of_row_.phi[i];
    motion.arc_difference += h * of_row_.arcs[i];
    if (is_on_boundaries(run_, i)) {
      motion.at.n_W = unit_vector(motion.phi);
      displace_place(i, 0, h, other, motion.at.p1_W, motion.at.rho1);
      displace_place(i, 1, h, other, motion.at.p2_W, motion.at.rho2);
    } else {
      motion.at = facing_at(dimensions, {body1.X_WB, body1.theta}, {body2.X_WB, body2.theta}, motion.phi)
                      .value_or(motion.at);
    }
    motion.rates =
        contact_rates(equivalent_link(is_line(curve_of(other.mechanism(), contact.first)), motion.at.rho1,
                                      is_line(curve_of(other.mechanism(), contact.second)), motion.at.rho2),
                      motion.at, body1, body2);
  }

  // Where a contact is on a boundary. Its curvature changes linearly; its radius has a pole at an inflection.
  void displace_place(std::size_t i, std::size_t side, double h, Run& other, Vector2d& p_W,
                      double& rho) const {
    const CurveRef& ref = ref_of(other.mechanism().contacts[i], side);
    const Boundary& boundary = boundary_at(run_, i, side);
    const BoundaryPlace& place = run_.row.contacts[i].place[side];
    const PlaceDerivative& by = places_[i][side];
    const bool corner = boundary.is_corner(place);
    SpanPoint point = boundary.at(place);
    point.p_B += h * by.p_B;
    point.n_B = Rotation<double>::from_angle(h * cross(point.n_B, by.n_B)) * point.n_B;
    point.kappa += h * by.kappa;
    point.slope += h * by.slope;
    other.local->bodies[ref.body].curves[ref.curve].curve =
        local_curve(point, corner, boundary.is_arc(place.span));
    p_W = other.row.bodies[ref.body].X_WB * point.p_B;
    rho = radius_of(point, corner);
  }

  const Run& run_;
  const Mechanism& derivative_;
  const RowSensitivity& of_row_;
  std::vector<std::array<PlaceDerivative, 2>> places_;  // of contacts on boundaries
};

// The step if p changes no coordinate: everything is then a polynomial of the loads.
double step_of_loads(const Run& run, const Mechanism& derivative) {
  double largest = 1;
  const std::vector<double> numbers = numbers_of(run.mechanism());
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

// Curvatures at a contact; those of points are infinite.
std::array<double, 2> curvatures_at(const Run& run, std::size_t contact) {
  const auto of = [&](const CurveRef& ref, double rho) {
    return is_line(curve_of(run.mechanism(), ref)) ? 0 : 1 / rho;
  };
  const Contact& described = run.mechanism().contacts[contact];
  const CommonNormal& at = run.row.contacts[contact].at;
  return {of(described.first, at.rho1), of(described.second, at.rho2)};
}

// Largest relative changes of curvatures by a displacement.
struct CurvatureChange {
  double sums = 0;    // of the sums of the two curvatures of contacts, on which velocities depend
  double single = 0;  // of single curvatures, on which radii and centres depend
};

CurvatureChange curvature_change(const Run& run, const Run& displaced) {
  const auto relative = [](double own, double other) {
    const double change = own != 0 ? std::abs(other / own - 1) : 0;
    return std::isfinite(change) ? change : 0;
  };
  CurvatureChange change;
  for (std::size_t i = 0; i < run.row.contacts.size(); ++i) {
    const auto own = curvatures_at(run, i), other = curvatures_at(displaced, i);
    change.sums = std::max(change.sums, relative(own[0] + own[1], other[0] + other[1]));
    change.single = std::max({change.single, relative(own[0], other[0]), relative(own[1], other[1])});
  }
  return change;
}

// Values of functions at 0 … 4 steps to either side (0: +, 1: -).
struct Samples {
  double h = 0;
  std::array<std::array<Eigen::VectorXd, 5>, 2> values;

  [[nodiscard]] SidedSlope slope(Eigen::Index i) const {
    return slope_of_samples([&](std::size_t side, std::size_t k) { return values[side][k](i); }, h);
  }

  // An estimate of the error of the slope: the eighth difference, in which poles, kinks and jumps between the
  // samples show, and rounding.
  [[nodiscard]] double doubt(Eigen::Index i) const {
    return (std::abs(eighth_difference(i)) + std::numeric_limits<double>::epsilon() * largest(i)) / h;
  }

  // Whether the eighth difference is more than rounding, and not small beside the slope. Of numbers that are
  // nothing but rounding, and change sign from sample to sample, it is larger than of any function.
  [[nodiscard]] bool is_doubtful(Eigen::Index i) const {
    const double difference = std::abs(eighth_difference(i));
    const double slope = std::abs(values[0][1](i) - values[1][1](i)) / 2;
    return difference > kDoubtfulDifference * slope && difference > kSureDifference * largest(i) &&
           difference < kRoundingDifference * largest(i);
  }

private:
  [[nodiscard]] double eighth_difference(Eigen::Index i) const {
    constexpr std::array kBinomials = {70.0, -56.0, 28.0, -8.0, 1.0};
    double difference = kBinomials[0] * values[0][0](i);
    for (std::size_t k = 1; k < kBinomials.size(); ++k) {
      difference += kBinomials[k] * (values[0][k](i) + values[1][k](i));
    }
    return difference;
  }

  [[nodiscard]] double largest(Eigen::Index i) const {
    double largest = 0;
    for (const auto& side : values) {
      for (const Eigen::VectorXd& at : side) largest = std::max(largest, std::abs(at(i)));
    }
    return largest;
  }
};

// Of samples with shorter and shorter steps, those with the least doubt about each function.
class BestSamples {
public:
  explicit BestSamples(Samples first) : of_(static_cast<std::size_t>(first.values[0][0].size()), 0) {
    all_.push_back(std::move(first));
  }

  // Returns whether they are better for a function that was doubtful.
  bool add(Samples shorter) {
    all_.push_back(std::move(shorter));
    bool helped = false;
    for (std::size_t i = 0; i < of_.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const Samples& best = all_[of_[i]];
      if (!(best.doubt(column) <= kWorthShorterStep * all_.back().doubt(column))) {
        helped = helped || best.is_doubtful(column);
        of_[i] = all_.size() - 1;
      }
    }
    return helped;
  }

  [[nodiscard]] bool has_doubts() const {
    for (std::size_t i = 0; i < of_.size(); ++i) {
      if (all_[of_[i]].is_doubtful(static_cast<Eigen::Index>(i))) return true;
    }
    return false;
  }

  [[nodiscard]] double shortest() const { return all_.back().h; }

  [[nodiscard]] std::vector<SidedSlope> slopes() const {
    std::vector<SidedSlope> slopes;
    for (std::size_t i = 0; i < of_.size(); ++i) {
      slopes.push_back(all_[of_[i]].slope(static_cast<Eigen::Index>(i)));
    }
    return slopes;
  }

private:
  std::vector<Samples> all_;
  std::vector<std::size_t> of_;  // each function's, of all
};

}  // namespace

std::vector<SidedSlope> slopes_along(const Run& run, const Sensitivity& by, const RowSensitivity& of_row,
                                     const std::function<std::vector<double>(const Run&, double)>& f) {
  const double displacement = displacement_of(run, by.derivative(), of_row);
  double h = displacement > 0 ? kLargestDisplacement / displacement : step_of_loads(run, by.derivative());
  const Displaceable displaceable(run, by, of_row);
  const CurvatureChange probed = curvature_change(run, displaceable.by(kCurvatureProbe * h));
  const auto shortened = [&](double change) {
    const double in_step = change / kCurvatureProbe;
    return h * (in_step > kLargestDisplacement ? kLargestDisplacement / in_step : 1);
  };
  const double by_sums = shortened(probed.sums), by_single = shortened(probed.single);
  const auto values_at = [&](double to) -> Eigen::VectorXd {
    const std::vector<double> values = f(displaceable.by(to), to);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  };
  const auto samples_with = [&, here = values_at(0)](double step) {
    Samples samples{step, {}};
    samples.values[0][0] = samples.values[1][0] = here;
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t k = 1; k < 5; ++k) {
        samples.values[side][k] = values_at((side == 0 ? step : -step) * static_cast<double>(k));
      }
    }
    return samples;
  };
  // Where a curve is nearly straight, radii take a much shorter step than all that is finite there.
  const bool straight = by_single < kMuchShorterStep * by_sums;
  BestSamples best(samples_with(straight ? by_sums : std::min(by_single, by_sums)));
  bool helped = true;
  if (straight) {
    (void)best.add(samples_with(by_single));
  }
  // A distance that is short beside the step, as of a centre of curvature next to a pivot, takes a shorter
  // one.
  for (int i = 0; i < kMostShorterSteps && helped && best.has_doubts(); ++i) {
    helped = best.add(samples_with(kShorterStep * best.shortest()));
  }
  return best.slopes();
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

#include "higherpair/analysis/jerk.hpp"

#include "ground_jerks.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "series_motion.hpp"

#include <cmath>

namespace higherpair {
namespace {

using JerkSeries = PowerSeries<double, 3>;
using Jerks = std::vector<std::optional<BodyJerk>>;

// The circle of curvature of a conic, fixed in its body, in vertex form with its vertex at the contact point.
CurveDimensions<double> circle_of_curvature(const BodyMotion& body, const Vector2d& p_W, const Vector2d& n_W,
                                            double rho) {
  const double side = rho < 0 ? -1 : 1;
  const Vector2d n_B = body.X_WB.R_WB.inverse() * n_W;
  return {CurveKind::kCircle, side, body.X_WB.inverse_times(p_W), -side * n_B, std::abs(rho), 1};
}

// The dimensions with curves replaced by their circles of curvature: the equivalent linkage frozen at this
// instant.
Dimensions<double> frozen(const Run& run, Dimensions<double> dimensions) {
  for (std::size_t i = 0; i < dimensions.contacts.size(); ++i) {
    auto& contact = dimensions.contacts[i];
    const CommonNormal& at = run.row.contacts[i].at;
    const auto replace = [&](int body, const Vector2d& p_W, const Vector2d& n_W, double rho,
                             CurveDimensions<double>& curve) {
      if (curve.kind != CurveKind::kLine && curve.kind != CurveKind::kPoint) {
        curve = circle_of_curvature(run.row.bodies[body], p_W, n_W, rho);
      }
    };
    replace(contact.first, at.p1_W, at.n_W, at.rho1, contact.curve1);
    replace(contact.second, at.p2_W, -at.n_W, at.rho2, contact.curve2);
  }
  return dimensions;
}

Jerks jerks_with(const Run& run, Dimensions<double> dimensions, std::span<const HigherRates> higher,
                 bool surplus_slip) {
  const Mechanism& mechanism = run.mechanism();
  Coordinates<JerkSeries> at = constant<JerkSeries>(row_coordinates(run));
  for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
    const JointMotion driver = joint_motion(mechanism, driven_joint(mechanism, i), run.row.bodies);
    at.drivers[i] = series_of<3>(std::array{driver.position, driver.velocity, driver.acceleration,
                                            higher.empty() ? 0.0 : higher[i][0]});
  }
  const auto held = plan_with_held_joints(run, dimensions, at);
  const auto motion = row_series(run, held ? *held : run.plan(), dimensions, dimensions, std::move(at),
                                 {surplus_slip, &run.row.has_rates});
  Jerks jerks(motion.known.size());
  for (std::size_t i = 0; i < jerks.size(); ++i) {
    if (motion.known[i]) {
      const BodyAt<JerkSeries>& body = motion.at.bodies[i];
      jerks[i] =
          BodyJerk{6 * Vector2d(body.X_WB.p_WB.x().c[3], body.X_WB.p_WB.y().c[3]), 6 * body.theta.c[3]};
    }
  }
  return jerks;
}

// Jerk of the coordinate of a pin, or of a slide on ground.
std::optional<double> simple_joint_jerk(const Run& run, const Joint& joint, const Jerks& bodies) {
  const auto& first = bodies[joint.first.body];
  const auto& second = bodies[joint.second.body];
  if (!first || !second) {
    return std::nullopt;
  }
  if (joint.type == JointType::kRevolute) {
    return second->angular - first->angular;
  }
  const BodyMotion& body = run.row.bodies[joint.second.body];
  return point_jerk(body, *second, point_of(run.mechanism(), joint.second)).dot(joint.direction_A);
}

}  // namespace

JerkRow jerks_of(const Run& run, std::span<const HigherRates> higher) {
  if (run.row.status == RowStatus::kNotAssemblable) {
    const Jerks none(run.row.bodies.size());
    return {none, none};
  }
  const Dimensions<double> dimensions = dimensions_of(run.mechanism());
  JerkRow jerks{jerks_with(run, dimensions, higher, true), {}};
  // With two joints to ground and a rolling contact there are surplus conditions, which only the curves
  // themselves satisfy. The link replaces the condition along n; the slip condition is left out.
  jerks.linkage = run.mechanism().contacts.empty() ? jerks.bodies
                                                   : jerks_with(run, frozen(run, dimensions), higher, false);
  return jerks;
}

Jerks true_jerks_of(const Run& run, std::span<const HigherRates> higher) {
  if (run.row.status == RowStatus::kNotAssemblable) {
    return Jerks(run.row.bodies.size());
  }
  if (auto direct = jerks_on_ground(run, higher)) {
    return *std::move(direct);
  }
  return jerks_with(run, dimensions_of(run.mechanism()), higher, true);
}

std::optional<double> joint_jerk(const Run& run, int joint, const Jerks& bodies) {
  const Joint& named = run.mechanism().joints[joint];
  if (named.type == JointType::kRevolute || (named.type == JointType::kPrismatic && named.first.body == 0)) {
    return simple_joint_jerk(run, named, bodies);
  }
  const Dimensions<double> dimensions = dimensions_of(run.mechanism());
  const auto& at = dimensions.joints[joint];
  std::array<BodyAt<JerkSeries>, 3> series;
  for (std::size_t i = 0; const int body : {at.first, at.second, at.carrier}) {
    const auto index = static_cast<std::size_t>(body);
    if (!bodies[index]) {
      return std::nullopt;
    }
    series[i++] = series_of_body<3>(run.row.bodies[index], *bodies[index]);
  }
  return 6 * joint_coordinate(at.of, series[0], series[1], series[2]).c[3];
}

}  // namespace higherpair

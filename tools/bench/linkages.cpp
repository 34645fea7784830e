#include "linkages.hpp"

#include "cases.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/io/profile_reader.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace higherpair::bench {
namespace {

constexpr int kChecks = 360;

Run started(const std::string& name) {
  const auto profile = read_profile_file(std::string(HIGHERPAIR_PROFILES) + "/" + name + ".toml");
  require(profile.has_value(), profile ? "" : to_string(profile.error().front()));
  auto run = start_run(profile->mechanism, {profile->programs.front().start});
  require(run.has_value(), run ? "" : name + ": " + run.error().reason);
  return *run;
}

const BodyMotion& body_of(const Run& run, const std::string& name) {
  const auto& bodies = run.mechanism().bodies;
  const auto found =
      std::find_if(bodies.begin(), bodies.end(), [&](const Body& body) { return body.name == name; });
  require(found != bodies.end(), "no body " + name);
  return run.row.bodies[found - bodies.begin()];
}

void require_turn(const Run& run, const std::string& name, double theta, double omega, double alpha) {
  const BodyMotion& body = body_of(run, name);
  require(run.row.status == RowStatus::kOk && angle_difference(body.theta, theta) <= 1e-13 &&
              std::abs(body.omega - omega) <= 1e-12 && std::abs(body.alpha - alpha) <= 1e-11,
          fmt::format("{} differs from the motion by hand", name));
}

SixBarByHand sixbar() {
  SixBarByHand bar;
  bar.crank = 0.040;
  bar.coupler = 0.100;
  bar.triangle = 0.095;
  bar.link = 0.120;
  bar.rocker = 0.145;
  bar.E_W = {0.095, 0};
  bar.F_W = {0.280, 0};
  bar.H_B = {0.072763157894736842, -0.061078006296748048};
  bar.sigma1 = 1;
  bar.sigma2 = 1;
  bar.gravity = 9.80665;
  bar.loads[SixBarByHand::kCrank] = {0.040, 5.33333333333333333e-6, {0.02, 0}, {0, 0}, 0};
  bar.loads[SixBarByHand::kCoupler] = {0.100, 8.33333333333333333e-5, {0.05, 0}, {-200, 0}, 0};
  bar.loads[SixBarByHand::kTriangle] = {0.00290120529909553281,
                                        1.79512077881536093e-6,
                                        {0.055921052631578947, -0.020359335432249349},
                                        {0, 200},
                                        0};
  bar.loads[SixBarByHand::kLink] = {0.120, 0.000144, {0.06, 0}, {0, 0}, 0};
  bar.loads[SixBarByHand::kRocker] = {0.145, 0.000254052083333333333, {0.0725, 0}, {-200, 0}, 20};
  return bar;
}

void check_sixbar_forces(const SixBarByHand& bar, const SixBarByHand::Motion& hand, const Run& run,
                         const Reactions& reactions) {
  const SixBarByHand::Forces forces = bar.forces_of(hand);
  static const char* const kNames[] = {"A", "B", "C", "E", "H", "D", "F"};
  for (std::size_t i = 0; i < forces.pins.size(); ++i) {
    const auto& joints = run.mechanism().joints;
    const auto found = std::find_if(joints.begin(), joints.end(),
                                    [&](const Joint& joint) { return joint.name == kNames[i]; });
    require(found != joints.end(), "no such pin");
    const JointReaction& pin = reactions.joints[found - joints.begin()];
    require((Vector2d(pin.fx.value(), pin.fy.value()) - forces.pins[i]).norm() <= 1e-9,
            fmt::format("the force at pin {} differs from the one by hand", kNames[i]));
  }
  const DriverEffort& effort = reactions.drivers.front();
  require(std::abs(effort.effort.value() - forces.torque) <= 1e-10 &&
              std::abs(effort.by_power.value() - forces.torque) <= 1e-10,
          "the driving torque differs from the one by hand");
}

}  // namespace

LinkageCase<FourBarByHand> checked_four_bar() {
  LinkageCase<FourBarByHand> reference{{0.01, 0.02, 0.035, 0.04, -1}, started("four_bar")};
  Run run = reference.run;
  for (int i = 0; i < kChecks; ++i) {
    const double theta = 2 * kPi * i / kChecks;
    const FourBarByHand::Motion hand = reference.by_hand.at(theta);
    move_to(run, {{theta, 1, 0}});
    require_turn(run, "coupler", hand.theta3, hand.omega3, hand.alpha3);
    require_turn(run, "rocker", hand.theta4, hand.omega4, hand.alpha4);
  }
  return reference;
}

LinkageCase<SixBarByHand> checked_watt_sixbar() {
  LinkageCase<SixBarByHand> reference{sixbar(), started("watt_sixbar_forces")};
  Run run = reference.run;
  InverseDynamics dynamics(run);
  const double start = run.at.inputs.front();
  for (int i = 0; i < kChecks; ++i) {
    const double theta = start + 2 * kPi * i / kChecks;
    const SixBarByHand::Motion hand = reference.by_hand.motion_at(theta);
    move_to(run, {{theta, 1, 0}});
    const auto& [coupler, triangle] = std::tie(hand.front.first, hand.front.second);
    const auto& [link, rocker] = std::tie(hand.rear.first, hand.rear.second);
    require_turn(run, "coupler", coupler.theta, coupler.omega, coupler.alpha);
    require_turn(run, "triangle", triangle.theta, triangle.omega, triangle.alpha);
    // The link's frame is at D.
    require_turn(run, "link", link.theta + kPi, link.omega, link.alpha);
    require_turn(run, "rocker", rocker.theta + kPi, rocker.omega, rocker.alpha);
    check_sixbar_forces(reference.by_hand, hand, run, dynamics.solve(run));
  }
  return reference;
}

}  // namespace higherpair::bench

#include "packs.hpp"

#include "checks.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "linkages.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include <fmt/core.h>

namespace higherpair::bench {
namespace {

using Quantity = ChainColumn::Quantity;

constexpr std::array kQuantities{Quantity::kAngle, Quantity::kOmega, Quantity::kAlpha};

// \param append  appends the numbers of the columns for a row of the run
template <class Append>
PackCase checked(const std::string& name, const Run& start, const std::vector<ChainColumn>& columns,
                 double tolerance, const Append& append) {
  std::vector<DriverMotion> drivers;
  for (int step = 0; step < kStepsPerTurn; ++step) {
    drivers.push_back({start.at.inputs.front() + driver_position(step), 1, 0});
  }
  auto chain = DyadChain::of(start.mechanism(), start.plan(), drivers, columns);
  require(chain.has_value() && chain->solve(start.mechanism()), name + ": rows are not proven");
  Run run = start;
  for (std::size_t k = 0; k < drivers.size(); ++k) {
    move_to(run, {drivers[k]});
    std::vector<double> expected;
    append(run, expected);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      require(std::abs(chain->values(c)[k] - expected[c]) <= tolerance,
              fmt::format("{}: rows at a time differ from those one by one", name));
    }
  }
  return {name, start.mechanism(), *std::move(chain)};
}

}  // namespace

PackCase checked_packs(const std::string& name, const Run& start) {
  const auto last = static_cast<int>(start.mechanism().bodies.size()) - 1;
  std::vector<ChainColumn> columns;
  for (const int body : {last - 1, last}) {
    for (const Quantity quantity : kQuantities) {
      columns.push_back({body, std::nullopt, quantity});
    }
  }
  return checked(name, start, columns, 1e-10, [&](const Run& run, std::vector<double>& expected) {
    for (const int body : {last - 1, last}) {
      const BodyMotion& motion = run.row.bodies[body];
      expected.insert(expected.end(), {motion.theta, motion.omega, motion.alpha});
    }
  });
}

PackCase checked_packs_with_forces(const std::string& name, const Run& start) {
  const auto joints = static_cast<int>(start.mechanism().joints.size());
  std::vector<ChainColumn> columns;
  for (int joint = 0; joint < joints; ++joint) {
    columns.push_back({joint, std::nullopt, Quantity::kForceX});
    columns.push_back({joint, std::nullopt, Quantity::kForceY});
  }
  columns.push_back({0, std::nullopt, Quantity::kEffort});
  columns.push_back({0, std::nullopt, Quantity::kEffortByPower});
  InverseDynamics dynamics(start);
  return checked(name, start, columns, 1e-9, [&](const Run& run, std::vector<double>& expected) {
    const Reactions& reactions = dynamics.solve(run);
    for (const JointReaction& joint : reactions.joints) {
      expected.insert(expected.end(), {joint.fx.value(), joint.fy.value()});
    }
    const DriverEffort& driver = reactions.drivers.front();
    expected.insert(expected.end(), {driver.effort.value(), driver.by_power.value()});
  });
}

VectorFourBar checked_vector_floor() {
  std::vector<double> positions;
  for (int step = 0; step < kStepsPerTurn; ++step) {
    positions.push_back(driver_position(step));
  }
  VectorFourBar floor(kFourBar, positions);
  floor.work_out();
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const FourBarByHand::Motion hand = kFourBar.at(positions[k]);
    require(std::abs(floor.output(VectorFourBar::kSin3)[k] - std::sin(hand.theta3)) <= 1e-14 &&
                std::abs(floor.output(VectorFourBar::kCos4)[k] - std::cos(hand.theta4)) <= 1e-14 &&
                std::abs(floor.output(VectorFourBar::kAlpha3)[k] - hand.alpha3) <= 1e-13 &&
                std::abs(floor.output(VectorFourBar::kAlpha4)[k] - hand.alpha4) <= 1e-13,
            "the vector floor differs from the four-bar by hand");
  }
  return floor;
}

double measure(VectorFourBar& floor) {
  double best = INFINITY;
  for (int turn = 0; turn < 2000; ++turn) {
    const auto start = std::chrono::steady_clock::now();
    floor.work_out();
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count() / kStepsPerTurn);
  }
  return best;
}

}  // namespace higherpair::bench

#include "packs.hpp"

#include "checks.hpp"
#include "linkages.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

namespace higherpair::bench {
namespace {

using Quantity = ChainColumn::Quantity;

constexpr std::array kQuantities{Quantity::kAngle, Quantity::kOmega, Quantity::kAlpha};

}  // namespace

PackCase checked_packs(const std::string& name, const Run& start) {
  const auto last = static_cast<int>(start.mechanism().bodies.size()) - 1;
  std::vector<ChainColumn> columns;
  for (const int body : {last - 1, last}) {
    for (const Quantity quantity : kQuantities) {
      columns.push_back({body, std::nullopt, quantity});
    }
  }
  std::vector<DriverMotion> drivers;
  for (int step = 0; step < kStepsPerTurn; ++step) {
    drivers.push_back({start.at.drivers.front() + driver_position(step), 1, 0});
  }
  auto chain = DyadChain::of(start.mechanism(), start.plan(), drivers, columns);
  require(chain.has_value() && chain->solve(start.mechanism()), name + ": rows are not proven");
  Run run = start;
  for (std::size_t k = 0; k < drivers.size(); ++k) {
    move_to(run, {drivers[k]});
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const BodyMotion& body = run.row.bodies[static_cast<std::size_t>(columns[c].body)];
      const std::array expected{body.theta, body.omega, body.alpha};
      require(std::abs(chain->values(c)[k] - expected[c % expected.size()]) <= 1e-10,
              fmt::format("{}: rows at a time differ from those one by one", name));
    }
  }
  return {name, start.mechanism(), *std::move(chain)};
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

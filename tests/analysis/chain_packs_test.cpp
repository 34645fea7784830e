// Rows have the same bits whatever the width of the packs.
#include "analysis/packs/chain_loop.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair::testing {
namespace {

using Quantity = ChainColumn::Quantity;

constexpr std::size_t kRowCount = 4 * kChainRows;
constexpr int kCrank = 1, kCoupler = 2, kRocker = 3, kFollower = 4, kLink = 5, kBodies = 6;

OneFreedom pivot(const Vector2d& p_W) {
  OneFreedom freedom;
  freedom.p_WO = p_W;
  return freedom;
}

// A crank that drives a four-bar, and an oval on the crank that turns the oval of a follower.
std::vector<ChainGroup> groups() {
  const DrivenBody driven{0, {kCrank, 0, pivot({0, 0}), 1}};
  RrrDyad dyad;
  dyad.A = {kCrank, Vector2d(2, 0)};
  dyad.B = {0, Vector2d(1, 0)};
  dyad.link_a = kCoupler;
  dyad.link_b = kRocker;
  dyad.a_pC = Vector2d(3.5, 0);
  dyad.b_pC = Vector2d(4, 0);
  dyad.length_a = 3.5;
  dyad.length_b = 4;
  const ChainTouch touch{0, kLink, 0, kCrank, kFollower, 0, pivot({8, 0})};
  const OvalContact ovals{touch,
                          {{0.3, 0.1}, Rotation<double>::from_angle(0.4), 2, 1.5},
                          {{-6, 0.2}, Rotation<double>::from_angle(-0.7), 1.2, 0.8}};
  return {{driven, false, {}}, {dyad, true, {}}, {ovals, false, {}}};
}

ChainSchedule schedule() {
  ChainSchedule schedule;
  for (std::size_t k = 0; k < kRowCount; ++k) {
    const double position = 0.03 * static_cast<double>(k);
    schedule.position.push_back(position);
    schedule.cosine.push_back(std::cos(position));
    schedule.sine.push_back(std::sin(position));
    schedule.velocity.push_back(1.3 - position);
    schedule.acceleration.push_back(0.4);
  }
  return schedule;
}

ChainSupport support(int joint, double sign) {
  return {joint, sign, {}};
}

// The angle column of a body, in a mechanism where every body turns.
ChainAngle turning(int body) {
  return {0, body, 0};
}

// Weights, a load and springs, with reactions at the pins of the crank, the dyad and the follower.
ChainStatics statics() {
  ChainStatics statics;
  statics.loads.gravity_W = Vector2d(0.3, -9.8);
  statics.loads.masses = {{kCrank, {1.3, {0.7, 0.1}, 0.2}},
                          {kCoupler, {0.9, {1.4, -0.2}, 0.3}},
                          {kFollower, {0.6, {-3, 0.5}, 0.1}}};
  statics.loads.forces = {{{kRocker, {2.2, 0.4}}, {3.1, -7}, 0.6, true}};
  statics.loads.point_springs = {{{0, {-1, 3}}, {kCoupler, {3, 1}}, {20, 0.4, 0.7}}};
  statics.loads.pin_springs = {{{kCoupler, kRocker, {9, 0.2, 0.1}}, turning(kCoupler), turning(kRocker)}};
  statics.supports = {{{support(0, 1), {}}, {}},
                      {{support(1, 1), support(2, -1)}, support(3, -1)},
                      {{support(4, 1), {}}, {}}};
  statics.joints = 5;
  statics.contacts = 1;
  return statics;
}

// The columns, one after another.
template <class Fill>
std::vector<double> numbers_by(const Fill& fill) {
  const std::vector<ChainGroup> all = groups();
  const ChainSchedule rows = schedule();
  std::vector<ChainTask> tasks;
  const auto add = [&](const ChainColumn& column, const ChainAngle& angle) {
    ChainTask& task = tasks.emplace_back();
    task.column = column;
    task.angle = angle;
    task.touch = std::get<OvalContact>(all[2].kind).touch;
    task.values.resize(kRowCount);
  };
  for (const int body : {kRocker, kFollower}) {
    const ChainAngle angle = turning(body);
    for (const Quantity quantity : {Quantity::kX, Quantity::kAngle, Quantity::kOmega, Quantity::kAlpha}) {
      add({body, std::nullopt, quantity}, angle);
    }
  }
  add({0, std::nullopt, Quantity::kPressure}, {});
  add({0, std::nullopt, Quantity::kContactForce}, {});
  for (const Quantity quantity : {Quantity::kForceX, Quantity::kForceY, Quantity::kEffortByPower}) {
    add({2, std::nullopt, quantity}, {});
  }
  ChainStatics balanced = statics();
  const std::vector<double> modes{1, 1, 1};
  const std::vector<char> placed(kBodies, 1);
  std::vector<ChainTurning> turnings(kBodies);
  for (int body = 0; body < kBodies; ++body) {
    turnings[body] = {body, body == kCoupler || body == kRocker, 3.0 * body, 0};
  }
  std::vector<ChainWatch<double>> watches(all.size());
  std::vector<OvalRow> ovals(all.size());
  ovals[2].turn = Rotation<double>::from_angle(-0.6);
  ovals[2].n_W = Vector2d(0.8, 0.6);
  fill(ChainRowsJob{all, modes, rows, ChainRates::kAccelerations, placed, 8, tasks, turnings, watches, ovals,
                    &balanced});
  std::vector<double> numbers;
  for (const ChainTask& task : tasks) {
    numbers.insert(numbers.end(), task.values.begin(), task.values.end());
  }
  for (const ChainWatch<double>& watch : watches) {
    numbers.push_back(watch.margin);
  }
  for (const ChainTurning& one : turnings) {
    numbers.push_back(one.first_angle);
  }
  numbers.push_back(balanced.shortest2);
  return numbers;
}

TEST(ChainPacks, RowsHaveTheSameBitsWhateverTheirWidth) {
  const auto two = numbers_by([](const ChainRowsJob& job) { chain_loop::fill<PackPair<2>>(job); });
  const auto four = numbers_by([](const ChainRowsJob& job) { chain_loop::fill<PackPair<4>>(job); });
  const auto eight = numbers_by([](const ChainRowsJob& job) { chain_loop::fill<PackPair<8>>(job); });
  const auto widest = numbers_by([](const ChainRowsJob& job) { fill_chain_rows(job); });
  for (const double number : two) {
    ASSERT_FALSE(std::isnan(number));
  }
  EXPECT_EQ(two, four);
  EXPECT_EQ(two, eight);
  EXPECT_EQ(two, widest);
}

}  // namespace
}  // namespace higherpair::testing

#pragma once

#include "chain_angles.hpp"
#include "chain_rows.hpp"
#include "chain_statics.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/arctangent.hpp"
#include "numeric/pack.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>

// The rows of a chain in packs T. Each width is compiled separately, for the instruction set that has such
// registers; the results agree to the last bit.

namespace higherpair::chain_loop {

using Quantity = ChainColumn::Quantity;

// Uninitialised storage for at most kMost items, of which only `count` are constructed: packs are large.
template <class Item, std::size_t kMost>
class Room {
public:
  explicit Room(std::size_t count) { std::uninitialized_default_construct_n(data(), count); }

  [[nodiscard]] Item* data() { return reinterpret_cast<Item*>(bytes_.data()); }
  [[nodiscard]] Item& operator[](std::size_t i) { return data()[i]; }

private:
  static_assert(std::is_trivially_destructible_v<Item>);
  alignas(Item) std::array<std::byte, kMost * sizeof(Item)> bytes_;
};

// The acute angle between the normal and the path of the contact point on the body that the contact places.
template <class T>
[[nodiscard]] inline T pressure_of_rows(const ChainTouch& touch, const ChainBody<T>* bodies) {
  using std::abs;
  const Rotation<T>& n = bodies[touch.link].R_WB;
  const OneFreedom& freedom = touch.freedom;
  if (!freedom.turns) {
    const Rotation<T> turn =
        n.inverse() * all_lanes<T>(Rotation<double>{freedom.direction_W.x(), freedom.direction_W.y()});
    return arctangent(abs(turn.sin), abs(turn.cos));
  }
  const ChainPoint<T> p = chain_point<ChainRates::kNone>(bodies[touch.link], Vector2d(touch.p_x, 0));
  const Vector2<T> arm =
      n.inverse() * Vector2<T>(p.p_W.x() - T(freedom.p_WO.x()), p.p_W.y() - T(freedom.p_WO.y()));
  return arctangent(abs(arm.x()), abs(arm.y()));
}

// Adding 0 turns -0 into 0, as is written elsewhere for what a joint cannot transmit.
template <class T>
[[nodiscard]] inline T force_of_rows(const ChainColumn& column, const ChainReaction<T>* reactions,
                                     const T* presses, const ChainEffort<T>& effort) {
  switch (column.quantity) {
    case Quantity::kForceX:
      return reactions[column.item].force.x() + T(0);
    case Quantity::kForceY:
      return reactions[column.item].force.y() + T(0);
    case Quantity::kMoment:
      return reactions[column.item].moment + T(0);
    case Quantity::kContactForce:
      return presses[column.item] + T(0);
    case Quantity::kEffort:
      return effort.effort + T(0);
    default:
      return effort.by_power + T(0);
  }
}

template <ChainRates kRates, class T>
[[nodiscard]] inline T value_of_rows(const ChainTask& task, std::span<const ChainTurning> turnings,
                                     const T& position, const DriverRates<T>& rates,
                                     const ChainBody<T>* bodies) {
  const Quantity quantity = task.column.quantity;
  if (quantity == Quantity::kPressure) {
    return pressure_of_rows(task.touch, bodies);
  }
  const ChainBody<T>& body = bodies[task.column.item];
  if (quantity == Quantity::kAngle) {
    return angle_of_rows(task.angle, turnings, position, bodies);
  }
  if (quantity == Quantity::kOmega) {
    return rates.first(body.omega);
  }
  if (quantity == Quantity::kAlpha) {
    return rates.second(body.omega, body.alpha);
  }
  const ChainPoint<T> point = chain_point<kRates>(body, task.p_B);
  if (quantity <= Quantity::kY) {
    return quantity == Quantity::kX ? point.p_W.x() : point.p_W.y();
  }
  if constexpr (kRates >= ChainRates::kVelocities) {
    if (quantity == Quantity::kVx || quantity == Quantity::kVy) {
      return rates.first(quantity == Quantity::kVx ? point.v_W.x() : point.v_W.y());
    }
  }
  if constexpr (kRates >= ChainRates::kAccelerations) {
    return quantity == Quantity::kAx ? rates.second(point.v_W.x(), point.a_W.x())
                                     : rates.second(point.v_W.y(), point.a_W.y());
  }
  return T(0);
}

// Makes angles continuous over all rows and reduces each watch to one lane.
template <class T>
inline void finish(const ChainRowsJob& job, const ChainWatch<T>* watches, const T& shortest) {
  for (ChainTask& task : job.tasks) {
    if (task.column.quantity == Quantity::kAngle && task.angle.turning >= 0) {
      unwind<T>(task, job.turnings[task.angle.turning]);
    }
  }
  for (std::size_t g = 0; g < job.groups.size(); ++g) {
    const double sum = sum_of_lanes(watches[g].sum);
    job.watches[g] = {std::isnan(sum) ? sum : largest_lane(watches[g].margin), sum,
                      largest_lane(watches[g].far2)};
  }
  if (job.statics != nullptr) {
    job.statics->shortest2 = -largest_lane(shortest);
  }
}

// Reads the drivers of the rows from k on.
template <class T, std::size_t kPacks>
inline void load_drivers(const ChainSchedule& schedule, std::size_t k,
                         std::array<ChainDriver<T>, kPacks>& driver,
                         std::array<DriverRates<T>, kPacks>& rates) {
  for (std::size_t i = 0; i < kPacks; ++i) {
    const std::size_t at = k + i * T::kLanes;
    driver[i] = {T::load(&schedule.position[at]),
                 {T::load(&schedule.cosine[at]), T::load(&schedule.sine[at])}};
    rates[i] = {T::load(&schedule.velocity[at]), T::load(&schedule.acceleration[at])};
  }
}

template <ChainRates kRates, class T>
inline void fill(const ChainRowsJob& job) {
  constexpr std::size_t kPacks = kChainRows / T::kLanes;
  const std::size_t bodies = job.placed.size();
  const std::size_t groups = job.groups.size();
  Room<ChainBody<T>, kPacks * kMostChainBodies> room(kPacks * bodies);
  for (std::size_t i = 0; i < kPacks * bodies; ++i) {
    room[i].placed = job.placed[i % bodies] != 0;
  }
  Room<ChainWatch<T>, kMostChainGroups> watches(groups);
  const std::size_t joints = job.statics != nullptr ? job.statics->joints : 0;
  Room<ChainReaction<T>, kPacks * kMostChainJoints> reactions(kPacks * joints);
  Room<ChainWrench<T>, kMostChainBodies> wrenches(job.statics != nullptr ? bodies : 0);
  const std::size_t contacts = job.statics != nullptr ? job.statics->contacts : 0;
  Room<T, kPacks * kMostChainBodies> presses(kPacks * contacts);
  const std::size_t turnings = job.turnings.size();
  Room<T, kPacks * kMostChainBodies> angles(kPacks * turnings);
  Room<Winding, kMostChainBodies> windings(turnings);
  T shortest(-kInf);
  std::array<ChainEffort<T>, kPacks> effort{};
  const ChainSchedule& schedule = job.schedule;
  for (std::size_t k = 0; k < schedule.position.size(); k += kChainRows) {
    std::array<ChainDriver<T>, kPacks> driver;
    std::array<DriverRates<T>, kPacks> rates;
    load_drivers(schedule, k, driver, rates);
    for (std::size_t g = 0; g < groups; ++g) {
      if (const auto* ovals = std::get_if<OvalContact>(&job.groups[g].kind)) {
        solve_ovals(*ovals, driver, job.size, job.ovals[g], room.data(), bodies, watches[g]);
        continue;
      }
      for (std::size_t i = 0; i < kPacks; ++i) {
        solve_group<kRates>(job.groups[g], job.modes[g], driver[i], room.data() + i * bodies, watches[g]);
      }
    }
    if constexpr (kRates == ChainRates::kAccelerations) {
      if (job.statics != nullptr) {
        turn_springs<T, kPacks>(job.turnings, room.data(), bodies, k == 0, windings.data(), angles.data());
      }
      for (std::size_t i = 0; i < kPacks && job.statics != nullptr; ++i) {
        balance_chain<T>(
            job.groups, *job.statics, bodies,
            {driver[i], rates[i], room.data() + i * bodies, wrenches.data(), reactions.data() + i * joints,
             presses.data() + i * contacts, angles.data() + i * turnings, &shortest},
            effort[i]);
      }
    }
    for (ChainTask& task : job.tasks) {
      for (std::size_t i = 0; i < kPacks; ++i) {
        const T values = is_force(task.column.quantity)
                             ? force_of_rows(task.column, reactions.data() + i * joints,
                                             presses.data() + i * contacts, effort[i])
                             : value_of_rows<kRates>(task, job.turnings, driver[i].position, rates[i],
                                                     room.data() + i * bodies);
        values.store(&task.values[k + i * T::kLanes]);
      }
    }
  }
  finish(job, watches.data(), shortest);
}

template <class T>
inline void fill(const ChainRowsJob& job) {
  switch (job.rates) {
    case ChainRates::kNone:
      return fill<ChainRates::kNone, T>(job);
    case ChainRates::kVelocities:
      return fill<ChainRates::kVelocities, T>(job);
    case ChainRates::kAccelerations:
      return fill<ChainRates::kAccelerations, T>(job);
  }
}

}  // namespace higherpair::chain_loop

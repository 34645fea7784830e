#include "crossing.hpp"

#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "tolerances.hpp"

#include <cmath>

namespace higherpair {
namespace {

bool modes_differ(const State& a, const State& b) {
  for (std::size_t g = 0; g < a.groups.size(); ++g) {
    if (a.groups[g].mode != b.groups[g].mode) {
      return true;
    }
  }
  return false;
}

// Value, first and second derivative of a quintic in the middle of an interval of width h, from those at its
// ends.
template <class V>
struct Jet {
  V value, first, second;
};

template <class V>
Jet<V> middle(const Jet<V>& a, const Jet<V>& b, double h) {
  const V rise = b.value - a.value;
  const V bend = b.first - a.first;
  const V twist = b.second - a.second;
  return {a.value + rise / 2 - 5 * h / 32 * bend + h * h / 64 * (a.second + b.second),
          15 / (8 * h) * rise - 7.0 / 16 * (a.first + b.first) + h / 32 * twist,
          3 / (2 * h) * bend - (a.second + b.second) / 4};
}

void interpolate(const Run& run, const State& a, double h, State& b) {
  for (std::size_t i = 1; i < b.bodies.size(); ++i) {
    const BodyMotion& before = a.bodies[i];
    BodyMotion& body = b.bodies[i];
    const auto angle =
        middle<double>({before.theta, before.omega, before.alpha}, {body.theta, body.omega, body.alpha}, h);
    const auto place = middle<Vector2d>({before.X_WB.p_WB, before.v_WB, before.a_WB},
                                        {body.X_WB.p_WB, body.v_WB, body.a_WB}, h);
    body.theta = angle.value;
    body.omega = angle.first;
    body.alpha = angle.second;
    body.X_WB = {Rotation<double>::from_angle(angle.value), place.value};
    body.v_WB = place.first;
    body.a_WB = place.second;
  }
  for (std::size_t i = 0; i < b.contacts.size(); ++i) {
    const Contact& contact = run.mechanism().contacts[i];
    ContactMotion& motion = b.contacts[i];
    const double phi =
        (a.contacts[i].phi + motion.phi) / 2 + h / 8 * (a.contacts[i].rates.phi_dot - motion.rates.phi_dot);
    motion.at.n_W = unit_vector(phi);
    motion.phi = phi;
    (void)place_contact(run.mechanism(), contact, b.bodies, motion);
    set_contact_rates(model_of(run), static_cast<int>(i), b);
  }
  for (std::size_t g = 0; g < b.groups.size(); ++g) {
    if (traits_of(run.plan().groups[g]).can_cross) {
      b.groups[g].sine = sine_of(model_of(run), g, b);
      b.groups[g].noise = traits_of(run.plan().groups[g]).sine_noise * b.groups[g].lever;
    }
  }
}

}  // namespace

bool is_near_crossing(const Run& run, const State& state) {
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    if (std::abs(state.groups[g].sine) < kNearCrossing * state.groups[g].lever &&
        traits_of(run.plan().groups[g]).can_cross) {
      return true;
    }
  }
  return false;
}

bool stop_near_crossing(Run& run, const Path& path, double s, double rest) {
  const double reach = std::copysign(kCrossingReach * unit_of(run, path), path.length);
  StateAside direct(run.work.trial);
  // If run.at.state is already nearer than `reach`, the step goes backward and may lead across the crossing.
  const double h = rest - reach;
  bool crosses =
      h * reach < 0 ? try_step(run, path, s, h).kind == StepResult::kOk : solve_at(run, path, s, h);
  if (crosses) {
    const StateAside start(run.at.state);
    const State before = run.work.trial;
    run.at.state = before;
    crosses = try_step(run, path, path.length - reach, 2 * reach).kind == StepResult::kOk &&
              modes_differ(before, run.work.trial);
    if (crosses) {
      interpolate(run, before, 2 * reach, run.work.trial);
    }
  }
  if (crosses) {
    direct.commit();
    run.at.beside = run.work.trial;
    path.positions(s, run.at.drivers);
  }
  return crosses;
}

}  // namespace higherpair

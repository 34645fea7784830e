#include "crossing.hpp"

#include "analysis/tolerances.hpp"
#include "higherpair/mechanism/group_traits.hpp"

#include <algorithm>
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

// Value, first and second derivative.
template <class V>
struct Jet {
  V value, first, second;
};

// The quintic that has the jets a and b at the ends of an interval of width h, at the fraction t of it
// (Hermite).
template <class V>
Jet<V> between(const Jet<V>& a, const Jet<V>& b, double h, double t) {
  const V rise = b.value - a.value - h * a.first - h * h / 2 * a.second;
  const V bend = h * (b.first - a.first) - h * h * a.second;
  const V twist = h * h * (b.second - a.second);
  const V c3 = 10 * rise - 4 * bend + twist / 2;
  const V c4 = -15 * rise + 7 * bend - twist;
  const V c5 = 6 * rise - 3 * bend + twist / 2;
  const V value = a.value + t * (h * a.first + t * (h * h / 2 * a.second + t * (c3 + t * (c4 + t * c5))));
  const V first = a.first + t * (h * a.second + t * (3 * c3 + t * (4 * c4 + t * 5 * c5)) / h);
  const V second = a.second + t * (6 * c3 + t * (12 * c4 + t * 20 * c5)) / (h * h);
  return {value, first, second};
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

double crossing_reach(const Run& run, const Path& path, const State& state) {
  return std::min(kCrossingReach * unit_of(run, path), kCrossingTurn / fastest_body(run, state));
}

void interpolate(const Run& run, const State& a, double h, double t, State& b) {
  for (std::size_t i = 1; i < b.bodies.size(); ++i) {
    const BodyMotion& before = a.bodies[i];
    BodyMotion& body = b.bodies[i];
    const auto angle = between<double>({before.theta, before.omega, before.alpha},
                                       {body.theta, body.omega, body.alpha}, h, t);
    const auto place = between<Vector2d>({before.X_WB.p_WB, before.v_WB, before.a_WB},
                                         {body.X_WB.p_WB, body.v_WB, body.a_WB}, h, t);
    body.theta = angle.value;
    body.omega = angle.first;
    body.alpha = angle.second;
    body.X_WB = {Rotation<double>::from_angle(angle.value), place.value};
    body.v_WB = place.first;
    body.a_WB = place.second;
  }
  for (std::size_t i = 0; i < b.contacts.size(); ++i) {
    const ContactMotion& before = a.contacts[i];
    ContactMotion& motion = b.contacts[i];
    const double rise = motion.phi - before.phi;
    const double v0 = h * before.rates.phi_dot - rise, v1 = h * motion.rates.phi_dot - rise;
    motion.phi = std::lerp(before.phi, motion.phi, t) + t * (1 - t) * ((1 - t) * v0 - t * v1);
    motion.at.n_W = unit_vector(motion.phi);
    (void)place_contact(run.mechanism(), run.mechanism().contacts[i], b.bodies, motion);
    set_contact_rates(model_of(run), static_cast<int>(i), b);
  }
  for (std::size_t g = 0; g < b.groups.size(); ++g) {
    if (traits_of(run.plan().groups[g]).can_cross) {
      b.groups[g].sine = sine_of(model_of(run), g, b);
      b.groups[g].noise = traits_of(run.plan().groups[g]).sine_noise * b.groups[g].lever;
    }
  }
}

bool stop_near_crossing(Run& run, const Path& path, double s, double rest) {
  const double reach = std::copysign(crossing_reach(run, path, run.at.state), path.length);
  const bool crosses = change_trial(run, [&] {
    // If run.at.state is already nearer than `reach`, the step goes backward and may lead across the
    // crossing.
    const double h = rest - reach;
    if (h * reach < 0 ? try_step(run, path, s, h).has_value() : !solve_at(run, path, s, h)) {
      return false;
    }
    const StateAside start(run.at.state);
    const State before = run.work.trial;
    run.at.state = before;
    if (try_step(run, path, path.length - reach, 2 * reach) || !modes_differ(before, run.work.trial)) {
      return false;
    }
    interpolate(run, before, 2 * reach, 0.5, run.work.trial);
    return true;
  });
  if (crosses) {
    rest_beside(run, path, s);
  }
  return crosses;
}

}  // namespace higherpair

#include "force_watch.hpp"

#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/chebyshev.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

constexpr std::array<double, ForcePiece::kParts> kAllParts = {1, 1, 1};

ForceSeries negative(ForceSeries p) {
  for (double& c : p) {
    c = -c;
  }
  return p;
}

// The zero just before `below`, which is the first place after `from` where p < 0.
double zero_before(const ForceSeries& p, double from, double below) {
  double low = below;
  for (double step = kStepToZero; low > from && value_at(p, low) < 0; step *= 4) {
    low = std::max(from, below - step);
  }
  const double at_low = value_at(p, low);
  const double at_below = value_at(p, below);
  if (!(at_low > 0) || !(at_below < 0)) {
    return low;
  }
  return low + root_between([&](double t) { return value_at(p, low + t); }, at_low, below - low, at_below)
                   .value_or(0);
}

}  // namespace

void ForceWatch::pass(const ForceFitter::Position& before, const ForcePiece& piece,
                      std::optional<double> behind) {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (piece.known[i]) {
      const ForceSeries force = weighted_force(piece, i, kAllParts);
      find_openings(before, piece, i, force, behind);
      find_lowest(piece, i, force);
      contacts_[i].end = value_at(force, 1);
      contacts_[i].least = std::min(contacts_[i].least, bound_of(force));
    } else {
      contacts_[i].state = State::kUnknown;
    }
  }
}

void ForceWatch::forget() {
  for (Watched& contact : contacts_) {
    contact.state = State::kUnknown;
  }
}

void ForceWatch::find_openings(const ForceFitter::Position& before, const ForcePiece& piece, std::size_t i,
                               const ForceSeries& force, std::optional<double> behind) {
  using Kind = ContactOpening::Kind;
  Watched& contact = contacts_[i];
  const double level = -piece.noise;
  const double begin = value_at(force, -1);
  if (contact.state != State::kOpen && begin < level) {
    const bool jumps = contact.end > kJumpOfForce * bound_of(force) + piece.noise;
    const bool grown = behind && contact.end > kGrownForce * contact.least;
    add_opening(i, behind.value_or(piece.from),
                contact.state == State::kUnknown ? Kind::kPulled
                : grown                          ? Kind::kPole
                : jumps                          ? Kind::kPulled
                                                 : Kind::kRoot);
    contact.state = State::kOpen;
  } else if (contact.state != State::kOpen || begin > piece.noise) {
    contact.state = State::kPressing;
  }
  const ForceSeries pull = negative(force);
  for (double t = -1;;) {
    const bool open = contact.state == State::kOpen;
    const auto next = first_below(open ? pull : force, level, t);
    if (!next) {
      return;
    }
    if (!open) {
      const double zero = parameter(piece, zero_before(force, t, *next));
      add_opening(i, polished(before, piece, i, force, zero), Kind::kRoot);
    }
    contact.state = open ? State::kPressing : State::kOpen;
    t = *next;
  }
}

// Newton's method with the force itself and the slope of its series, from the series' zero.
double ForceWatch::polished(const ForceFitter::Position& before, const ForcePiece& piece, std::size_t i,
                            const ForceSeries& force, double zero) {
  const ForceSeries slope = derivative(force);
  const double half_length = (piece.to - piece.from) / 2;
  Run probe = before.run;
  double at = zero;
  double was = before.at;
  for (int pass = 0; pass < 2 && half_length > 0 && at > before.at; ++pass) {
    path_.move(probe, was, at);
    was = at;
    if (!fitter_.columns().solve(probe) || !fitter_.columns().is_known(i)) {
      return zero;
    }
    double value = 0;
    for (std::size_t part = 0; part < ForcePiece::kParts; ++part) {
      value += fitter_.columns().value(i, part);
    }
    const double t = (at - piece.from) / half_length - 1;
    const double step = -value / value_at(slope, t) * half_length;
    if (!(std::abs(step) < kNearZero * half_length)) {
      return zero;
    }
    at = std::clamp(at + step, piece.from, piece.to);
  }
  return at;
}

void ForceWatch::add_opening(std::size_t contact, double at, ContactOpening::Kind kind) {
  forces_.openings.push_back({contact, kind, at, driver_at(at)});
}

void ForceWatch::find_lowest(const ForcePiece& piece, std::size_t i, const ForceSeries& force) {
  std::optional<LowestForce>& lowest = forces_.lowest[i];
  if (lowest && !(force[0] - spread(force) < lowest->force - piece.noise)) {
    return;
  }
  LowestValue best{-1, value_at(force, -1)};
  const bool constant = spread(force) <= piece.noise;  // but for rounding, as in a dwell
  if (!constant) {
    find_lower(force, kLowestForce * bound_of(force), best);
  }
  if (!lowest || best.value < lowest->force - piece.noise) {
    const double t = constant ? best.t : settled_minimum(force, best.t);
    const double at = parameter(piece, t);
    lowest = LowestForce{value_at(force, t), at, driver_at(at)};
  }
}

double ForceWatch::driver_at(double at) const {
  return path_.at(at).front().position;
}

}  // namespace higherpair

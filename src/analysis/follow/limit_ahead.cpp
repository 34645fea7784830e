#include "limit_ahead.hpp"

#include "analysis/groups/coupled_system.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "analysis/groups/group_solver.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/contact/critical_positions.hpp"
#include "higherpair/contact/step_length.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "limit_events.hpp"
#include "reduction.hpp"
#include "step.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

// How much of the path is left to where something runs off to infinity, and the largest distance for which
// that extrapolation is right to within rounding.
struct Rest {
  double left = kInf;
  double most = 0;  // as a fraction of the driver's scale
};

std::vector<int> bodies_up_to(const Plan& plan, std::size_t g) {
  std::vector<int> bodies;
  for (std::size_t i = 0; i <= g; ++i) {
    bodies.insert(bodies.end(), plan.groups[i].bodies.begin(), plan.groups[i].bodies.end());
  }
  return bodies;
}

// The root of 1 - slope x + bend x²/2 that is near 1/slope; NaN if there is none.
double root_of_taylor(double slope, double bend) {
  return 2 / (slope + std::copysign(std::sqrt(slope * slope - 2 * bend), slope));
}

// Distance to infinity, for bodies of the group, or of one before it, that are already far away: their
// distance grows as the -p-th power of what is left of the path, p a multiple of 1/2, and their speed as the
// -(p + 1)-th.
Rest left_to_infinity(const Run& run, std::size_t g) {
  const Vector2d ground = place_of_ground(run.mechanism());
  double farthest = kFarAway * run.plan().size;
  Rest rest;
  for (const int index : bodies_up_to(run.plan(), g)) {
    const BodyMotion& body = run.at.state.bodies[index];
    const Vector2d away = body.X_WB.p_WB - ground;
    const double distance = away.norm();
    if (!(distance > farthest)) {
      continue;
    }
    farthest = distance;
    const double speed = body.v_WB.norm();
    const double per_speed = body.v_WB.dot(body.a_WB) / (speed * speed);
    const double p = std::round(2 / (distance * std::abs(per_speed) / speed - 1)) / 2;
    if (p != std::round(p)) {
      // The speed, unlike the distance, does not depend on the origin.
      rest = {(p + 1) / per_speed, kNearLimit};
      continue;
    }
    // y^(-1/p), with y the distance in the direction of motion, is smooth: find the root of its Taylor
    // polynomial.
    const Vector2d direction = body.v_WB / speed;
    const double y = away.dot(direction);
    const double slope = speed / y / p;
    const double bend = (1 / p + 1) * p * slope * slope - body.a_WB.dot(direction) / y / p;
    rest = {root_of_taylor(slope, bend), kNearPole};
  }
  return rest;
}

// A line fixed in a body: the asymptote of its curve nearest to a point far out.
struct Asymptote {
  const BodyMotion* body = nullptr;
  Opening opening;
};

std::optional<Asymptote> asymptote_near(const Run& run, const State& state, const CurveRef& ref,
                                        const Vector2d& p_W) {
  const BodyMotion& body = state.bodies[ref.body];
  std::optional<Asymptote> best;
  double least = kInf;
  for (const Opening& opening : openings_of(curve_of(run.mechanism(), ref))) {
    const double off =
        std::abs(cross(opening.direction_B, Vector2d(body.X_WB.inverse_times(p_W) - opening.point_B)));
    if (opening.has_asymptote && off < least) {
      best = Asymptote{&body, opening};
      least = off;
    }
  }
  return best;
}

// The asymptotes that a contact is near; none if it is not far out, or if a curve has none.
struct Asymptotes {
  Asymptote one, two;
};

std::optional<Asymptotes> asymptotes_of(const Run& run, const State& state, int contact_index) {
  const Contact& contact = run.mechanism().contacts[contact_index];
  const ContactMotion& motion = state.contacts[contact_index];
  const Vector2d p_W = motion.at.p_W();
  const double distance = (p_W - place_of_ground(run.mechanism())).norm();
  if (contact.by_boundary || !motion.touches || !(distance > kFarAway * run.plan().size)) {
    return std::nullopt;
  }
  const auto one = asymptote_near(run, state, contact.first, p_W);
  const auto two = asymptote_near(run, state, contact.second, p_W);
  return one && two ? std::optional(Asymptotes{*one, *two}) : std::nullopt;
}

// The distance between the two asymptotes, at points fixed on them, and its first two time derivatives.
std::array<double, 3> distance_of(const Asymptotes& asymptotes) {
  const auto& [body, opening] = asymptotes.one;
  const Vector2d n = perp(Vector2d(body->X_WB.R_WB * opening.direction_B));
  const PointMotion from = point_motion(*body, opening.point_B);
  const PointMotion to = point_motion(*asymptotes.two.body, asymptotes.two.opening.point_B);
  const Vector2d d = to.p_W - from.p_W, v = to.v_W - from.v_W, a = to.a_W - from.a_W;
  const Vector2d n_dot = body->omega * perp(n);
  const Vector2d n_ddot = body->alpha * perp(n) - body->omega * body->omega * n;
  return {n.dot(d), n.dot(v) + n_dot.dot(d), n.dot(a) + 2 * n_dot.dot(v) + n_ddot.dot(d)};
}

// How much is left to where the asymptotes of both curves coincide: their contact is at infinity there. Their
// distance falls to 0 as a power p of what is left, with p = 1/2 where it depends on the bodies' angles
// alone. Not finite where it does not fall.
double left_until_they_coincide(const Asymptotes& asymptotes) {
  const auto [w, w_dot, w_ddot] = distance_of(asymptotes);
  if (w == 0) {
    return 0;
  }
  const double rate = w_dot / w;
  const double second = w_ddot / w;
  const double p = second < -0.5 * rate * rate ? 0.5 : 1;
  return root_of_taylor(-rate / p, (1 / p - 1) / p * rate * rate + second / p);
}

}  // namespace

bool place_at_limit(Run& run, const Path& path, const PathLimit& limit, double s) {
  const double near = kSameLimit * unit_of(run, path);
  Reduction reduction(run, path, limit.group, s);
  auto found = reduction.limit_ahead(limit.s - s);
  if (!found) {  // from next to it, where the branch is no parabola any more
    found = reduction.singular_point(std::abs(limit.s - s) + near);
  }
  if (!found || std::abs(s + found->ahead - limit.s) > near) {
    return false;
  }
  reduction.place_limit(*found, s + found->ahead);
  return true;
}

double LimitAhead::longest_step(double s) const {
  return limit_ ? kShareToLimit * std::abs(limit_->s - s) : kInf;
}

bool LimitAhead::is_within(double share, double s) const {
  return limit_ && std::abs(limit_->s - s) <= share * scale_;
}

bool LimitAhead::is_near(double s) const {
  return is_within(kNearLimit, s);
}

// Steps of a group that depends on the one at its limit may fail because rates are too inexact there; but
// then it can be placed.
std::optional<std::size_t> LimitAhead::lost_before(double s) const {
  const double ahead = kNearlyAtLimit * (limit_->s - s);
  for (std::size_t g = 0; g < run_.plan().groups.size(); ++g) {
    if (!solve_before(run_, path_, g + 1, s, ahead)) {
      return g == limit_->group ? std::nullopt : std::optional(g);
    }
  }
  return std::nullopt;
}

bool LimitAhead::is_on_path() const {
  return (path_.length - limit_->s) * path_.length >= 0;
}

bool LimitAhead::look_for(std::size_t g, double s, double h) {
  if (limit_ && limit_->group == g) {
    return false;
  }
  Reduction reduction(run_, path_, g, s);
  const auto found = reduction.limit_ahead(h);
  if (!found) {
    return false;
  }
  const double at = s + found->ahead;
  if (std::abs(path_.length - at) <= kOnLimit * (scale_ + size_at(run_, path_, at))) {
    report_limit(run_, path_, limit_event(run_, g, path_, path_.length));
    reduction.place_limit(*found, path_.length);
    rest_beside(run_, path_, s);
    return true;
  }
  if (!limit_ || std::abs(at - s) < std::abs(limit_->s - s)) {
    limit_ = PathLimit{g, at};
  }
  return false;
}

void LimitAhead::look_how_far(double s) {
  const Vector2d ground = place_of_ground(run_.mechanism());
  double farthest = 0;
  for (std::size_t i = 0; i < run_.mechanism().contacts.size(); ++i) {
    const ContactMotion& motion = run_.at.state.contacts[i];
    const bool counts = motion.touches && !run_.mechanism().contacts[i].by_boundary;
    farthest = std::max(farthest, counts ? (motion.at.p_W() - ground).norm() : 0.0);
  }
  farthest = std::max(farthest, farthest_coupled(model_of(run_), run_.at.state));
  if (!(farthest > kFarAway * run_.plan().size)) {
    far_.reset();
  } else if (!far_ || farthest < kTooFar * run_.plan().size) {
    far_ = Far{run_.at.state, s};
  }
}

std::optional<double> LimitAhead::go_back_from_far() {
  if (!far_) {
    return std::nullopt;
  }
  run_.at.state = far_->state;
  return far_->s;
}

bool LimitAhead::rests_before(double s) {
  if (std::abs(limit_->s - path_.length) > kBesideLimit * scale_ ||
      !solve_at(run_, path_, s, path_.length - s)) {
    return false;
  }
  rest_beside(run_, path_, s);
  return true;
}

// By a rounding of the contact's place, steps may pass coinciding asymptotes, or end before them.
std::optional<PathLimit> LimitAhead::asymptotes_coincide(std::size_t g, double s) const {
  const State& state = far_ ? far_->state : run_.at.state;
  const double from = far_ ? far_->s : s;
  std::optional<PathLimit> nearest;
  for (std::size_t group = 0; group <= g; ++group) {
    for (const int contact : run_.plan().groups[group].contacts) {
      const auto asymptotes = asymptotes_of(run_, state, contact);
      const double left = asymptotes ? left_until_they_coincide(*asymptotes) : kInf;
      const double off = std::abs(from + left - s);
      const bool is_there =
          std::isfinite(left) && off <= std::max(kNearLimit * scale_, kShareToLimit * std::abs(left));
      if (is_there && (!nearest || off < std::abs(nearest->s - s))) {
        nearest = PathLimit{group, from + left};
      }
    }
  }
  return nearest;
}

PathLimit LimitAhead::assumed(std::size_t g, double s) const {
  const Rest infinity = left_to_infinity(run_, g);
  if (std::abs(infinity.left) <= infinity.most * scale_ && infinity.left * path_.length > 0) {
    return {g, s + infinity.left};
  }
  if (const auto limit = asymptotes_coincide(g, s)) {
    return *limit;
  }
  return {g, s + std::copysign(shortest_step(scale_, size_at(run_, path_, s)), path_.length)};
}

}  // namespace higherpair

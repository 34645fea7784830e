#include "step.hpp"

#include "analysis/groups/coupled_bodies.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "analysis/tolerances.hpp"
#include "crossing.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "joint_ends.hpp"
#include "reduction.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// Sets the contacts of run.work.trial to the places of run.at.state, so that after a step those that have
// left their spans can be recognised.
void mark_places(Run& run) {
  for (std::size_t i = 0; i < run.mechanism().contacts.size(); ++i) {
    if (run.mechanism().contacts[i].by_boundary) {
      run.work.trial.contacts[i].place = run.at.state.contacts[i].place;
    }
  }
}

// Whether a group has only one branch, or keeps to it by itself.
bool keeps_branch(const Run& run, std::size_t g) {
  return traits_of(run.plan().groups[g]).one_branch ||
         std::holds_alternative<RollingTrack>(run.at.state.tracks[g]) ||
         std::holds_alternative<DwellContact>(run.at.state.tracks[g]);
}

// How far a group has moved in a step, and how far that is from what the velocities and accelerations at both
// ends predict. Over a step h of a smooth coordinate x
//     x1 - x0 = h/2 (v0 + v1) - h²/12 (a1 - a0) + O(h⁵),     v1 - v0 = h/2 (a0 + a1) + O(h³):
// a step onto another branch, or over a limit into a part of the branch beyond it, would have to agree in all
// of these at once. Angles, and lengths relative to the size.
class Smoothness {
public:
  Smoothness(double h, double size)
      : per_size_(1 / size), half_(h / 2), twelfth_(h * h / 12), step_(std::abs(h)) {}

  void add(const BodyMotion& a, const BodyMotion& b) {
    const double turn = b.theta - a.theta;
    const double dx = b.X_WB.p_WB.x() - a.X_WB.p_WB.x();
    const double dy = b.X_WB.p_WB.y() - a.X_WB.p_WB.y();
    change_ += std::abs(turn) + per_size_ * (std::abs(dx) + std::abs(dy));
    farthest_turn_ = std::max(farthest_turn_, std::abs(turn));
    mismatch_ += mismatch(turn, a.omega, b.omega, a.alpha, b.alpha) +
                 per_size_ * (mismatch(dx, a.v_WB.x(), b.v_WB.x(), a.a_WB.x(), b.a_WB.x()) +
                              mismatch(dy, a.v_WB.y(), b.v_WB.y(), a.a_WB.y(), b.a_WB.y()));
    // Where the motion turns back within the step, it covers more than the change.
    bend_ += std::abs(b.omega - a.omega) +
             per_size_ * (std::abs(b.v_WB.x() - a.v_WB.x()) + std::abs(b.v_WB.y() - a.v_WB.y()));
  }

  void add(const ContactMotion& a, const ContactMotion& b) {
    const double turn = b.phi - a.phi;
    change_ += std::abs(turn);
    mismatch_ += std::abs(turn - half_ * (a.rates.phi_dot + b.rates.phi_dot));
  }

  // A body's contact point, which may jump to another place of two nearly flat curves where the bodies hardly
  // feel it.
  // \param travel  from the step's beginning to its end along the boundary
  void add_travel(double travel, double v0, double v1) {
    const double mismatch = per_size_ * std::abs(travel - half_ * (v0 + v1));
    const double longest = per_size_ * (std::abs(travel) + std::abs(half_) * (std::abs(v0) + std::abs(v1)));
    jumps_ = jumps_ || mismatch > kSmoothTravel * longest + kLeastJump;
  }

  // \param kinks  whether a contact may have begun the step at a joint with a kink too small for a corner
  [[nodiscard]] bool holds(bool kinks) const {
    const double rest = kNoMismatch + (kinks ? kTurnOfKink + kVelocityOfKink * step_ : 0);
    return !jumps_ && mismatch_ <= kSmoothStep * (change_ + step_ / 8 * bend_) + rest &&
           farthest_turn_ <= kFarthestBodyTurn;
  }

private:
  [[nodiscard]] double mismatch(double rise, double v0, double v1, double a0, double a1) const {
    return std::abs(rise - half_ * (v0 + v1) + twelfth_ * (a1 - a0)) +
           step_ * std::abs((v1 - v0) - half_ * (a0 + a1));
  }

  double per_size_;
  double half_;     // h/2
  double twelfth_;  // h²/12
  double step_;     // |h|
  double change_ = 0;
  double mismatch_ = 0;
  double bend_ = 0;           // change of velocities
  double farthest_turn_ = 0;  // of one body
  bool jumps_ = false;        // whether a contact point does
};

// How far a contact's point travels along one of its bodies in a step, positive to the left of the normal.
// \param point  of the contact, on the body
double travel_of(const BodyMotion& from, const CommonNormal& a, const BodyMotion& to, const CommonNormal& b,
                 Vector2d CommonNormal::*point) {
  const Vector2d p_B = to.X_WB.inverse_times(b.*point) - from.X_WB.inverse_times(a.*point);
  const Vector2d n_B = from.X_WB.R_WB.inverse() * a.n_W + to.X_WB.R_WB.inverse() * b.n_W;
  return p_B.dot(perp(n_B)) / n_B.norm();
}

bool is_smooth(const Run& run, const Group& group, double h) {
  const State& from = run.at.state;
  const State& to = run.work.trial;
  Smoothness smoothness(h, run.plan().size);
  for (const int body : group.bodies) {
    const auto i = static_cast<std::size_t>(body);
    smoothness.add(from.bodies[i], to.bodies[i]);
  }
  for (const int contact : group.contacts) {
    const auto i = static_cast<std::size_t>(contact);
    const ContactMotion &a = from.contacts[i], &b = to.contacts[i];
    smoothness.add(a, b);
    const Contact& pair = run.mechanism().contacts[i];
    if (pair.by_boundary && a.touches && b.touches) {
      const int one = pair.first.body, two = pair.second.body;
      smoothness.add_travel(travel_of(from.bodies[one], a.at, to.bodies[one], b.at, &CommonNormal::p1_W),
                            a.rates.along1, b.rates.along1);
      smoothness.add_travel(travel_of(from.bodies[two], a.at, to.bodies[two], b.at, &CommonNormal::p2_W),
                            a.rates.along2, b.rates.along2);
    }
  }
  return smoothness.holds(run.local.has_value());
}

// Needed because a body that jumped to a neighbouring contact would hardly move.
bool keeps_contacts(const Run& run, const Group& group) {
  return std::all_of(group.contacts.begin(), group.contacts.end(), [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    const Contact& contact = run.mechanism().contacts[i];
    const CommonNormal& from = run.at.state.contacts[i].at;
    const CommonNormal& to = run.work.trial.contacts[i].at;
    return contact.by_boundary ||
           same_curvature(curve_of(run.mechanism(), contact.first), curve_of(run.mechanism(), contact.second),
                          from.rho1 + from.rho2, to.rho1 + to.rho2);
  });
}

// Whether the motion of a group in run.work.trial continues that in run.at.state.
bool goes_on(const Run& run, std::size_t g, double h) {
  const Group& group = run.plan().groups[g];
  return keeps_branch(run, g) || (is_smooth(run, group, h) && keeps_contacts(run, group));
}

// The mode of a group at s: that of `from`, reversed beyond a change point of the present step.
int mode_at(const Run& run, const State& from, std::size_t g, double s, double step) {
  int mode = from.groups[g].mode;
  for (const Crossing& crossing : run.work.crossings) {
    if (crossing.group == g && (s - crossing.s) * step > 0) {
      mode = -mode;
    }
  }
  return mode;
}

// Places the groups before `end` and sets their rates in run.work.trial, `x` beyond `from`, which is at s on
// the path; does not check that the motion leads there.
bool solve_groups(Run& run, const State& from, const Path& path, std::size_t end, double s, double x) {
  path.motions(s + x, run.work.motions);
  for (std::size_t g = 0; g < end; ++g) {
    run.work.trial.groups[g].mode = mode_at(run, from, g, s + x, path.length);
    if (place_group(model_of(run), g, from, x, run.work.motions, run.work.trial) != GroupStatus::kOk) {
      return false;
    }
  }
  for (std::size_t g = 0; g < end; ++g) {
    set_group_rates(model_of(run), g, run.work.motions, run.work.trial);
  }
  return true;
}

// Places a group in run.work.trial on the branch `mode` and sets its rates; kOk only if that continues
// run.at.state smoothly.
GroupStatus step_group(Run& run, std::size_t g, int mode, double h) {
  run.work.trial.groups[g].mode = mode;
  const GroupStatus status = place_group(model_of(run), g, run.at.state, h, run.work.motions, run.work.trial);
  if (status != GroupStatus::kOk) {
    return status;
  }
  set_group_rates(model_of(run), g, run.work.motions, run.work.trial);
  return goes_on(run, g, h) ? GroupStatus::kOk : GroupStatus::kNotConverged;
}

// Whether the group, which is beyond a change point in run.work.trial, gets there straight through it: if the
// branches only come near each other, the step has jumped.
bool crosses(Run& run, const Path& path, std::size_t g, double s, double h) {
  const auto at = [&] {
    const StateAside aside(run.work.trial);
    return Reduction(run, path, g, s).crossing_within(h);
  }();
  path.motions(s + h, run.work.motions);
  if (at) {
    run.work.crossings.push_back({g, s + at->ahead});
  }
  return at.has_value();
}

GroupStatus step_on_branch(Run& run, const Path& path, std::size_t g, double s, double h) {
  const GroupState& before = run.at.state.groups[g];
  if (!traits_of(run.plan().groups[g]).can_cross) {
    return step_group(run, g, before.mode, h);
  }
  if (traits_of(run.plan().groups[g]).finds_mode) {
    // Newton's method may arrive on either side of a change point, and two slides pass through parallel: the
    // sign of the determinant decides which side it is.
    const GroupStatus status = step_group(run, g, before.mode, h);
    const bool same = run.work.trial.groups[g].mode == before.mode;
    return status != GroupStatus::kOk || same || crosses(run, path, g, s, h) ? status
                                                                             : GroupStatus::kNotConverged;
  }
  const bool may_cross = (before.sine + h * before.sine_rate) * before.sine < 0;
  if (may_cross && step_group(run, g, -before.mode, h) == GroupStatus::kOk && crosses(run, path, g, s, h)) {
    return GroupStatus::kOk;
  }
  return step_group(run, g, before.mode, h);
}

}  // namespace

void set_rates(const Run& run, const std::vector<DriverMotion>& drivers, State& state) {
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    set_group_rates(model_of(run), g, drivers, state);
  }
}

void set_rates_on(Run& run, const Path& path, double s, State& state) {
  path.motions(s, run.work.motions);
  set_rates(run, run.work.motions, state);
}

void begin_path(Run& run, const Path& path) {
  if (path.curve || !path.is_single()) {  // else they are those for a unit rate already
    set_rates_on(run, path, 0, run.at.state);
  }
}

double fastest_body(const Run& run, const State& state) {
  double speed = 0;
  for (const BodyMotion& body : state.bodies) {
    speed = std::max({speed, std::abs(body.omega), body.v_WB.norm() / run.plan().size});
  }
  return speed;
}

std::optional<std::size_t> try_step(Run& run, const Path& path, double s, double h) {
  run.work.crossings.clear();
  mark_places(run);
  path.motions(s + h, run.work.motions);
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    if (step_on_branch(run, path, g, s, h) != GroupStatus::kOk) {
      return g;
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> broken_off(const Run& run, double h) {
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    if (!goes_on(run, g, h)) {
      return g;
    }
  }
  return std::nullopt;
}

bool solve_at(Run& run, const Path& path, double s, double x) {
  return solve_from(run, run.at.state, path, s, x);
}

bool solve_from_spans(Run& run, const Path& path, double s, double x) {
  mark_places(run);
  return solve_at(run, path, s, x);
}

bool solve_from(Run& run, const State& from, const Path& path, double s, double x) {
  return solve_groups(run, from, path, run.plan().groups.size(), s, x);
}

bool settle(Run& run, const Path& path, double s, const State& from) {
  if (!solve_from(run, from, path, s, 0)) {
    return false;
  }
  run.at.state = run.work.trial;
  return true;
}

void rest_beside(Run& run, const Path& path, double s) {
  run.at.beside = run.work.trial;
  path.inputs(s, run.at.inputs);
}

// Next to a change point at which one of these groups crosses in the present step they are interpolated: a
// group that depends on them may cross at the same place, and needs the digits that they lose there.
bool solve_before(Run& run, const Path& path, std::size_t end, double s, double x) {
  const auto& crossings = run.work.crossings;
  const auto own = std::find_if(crossings.begin(), crossings.end(),
                                [&](const Crossing& crossing) { return crossing.group < end; });
  const double reach = own == crossings.end() ? 0 : crossing_reach(run, path, run.at.state);
  if (reach == 0 || std::abs(s + x - own->s) >= reach) {
    return solve_groups(run, run.at.state, path, end, s, x);
  }
  const double begin = own->s - reach;
  if (!solve_groups(run, run.at.state, path, end, s, begin - s)) {
    return false;
  }
  const State before = run.work.trial;
  if (!solve_groups(run, run.at.state, path, end, s, begin + 2 * reach - s)) {
    return false;
  }
  interpolate(run, before, 2 * reach, (s + x - begin) / (2 * reach), run.work.trial);
  return true;
}

Placeable place_anew(Run& run, const std::vector<double>& inputs) {
  State& to = run.work.trial;
  set_unit_motions(run, inputs, run.work.motions);
  const State& nearest = run.at.lost.nearest ? run.at.lost.nearest->state : run.at.state;
  if (run.plan().couples) {
    to = nearest;
    run.work.continuations.assign(run.plan().groups.size(), std::nullopt);
    if (run.at.lost.nearest) {
      run.work.continuations = run.at.lost.nearest->continuations;
    }
  }
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    to.groups[g].mode = run.at.state.groups[g].mode;
    const bool coupled = traits_of(run.plan().groups[g]).coupled;
    const GroupStatus status =
        coupled
            ? place_coupled_anew(model_of(run), g, nearest, run.work.motions, to, run.work.continuations[g])
            : place_group_anew(model_of(run), g, run.at.state, run.work.motions, to);
    if (status != GroupStatus::kOk) {
      const double reach = reach_of(model_of(run), g, to);
      return reach >= 0 ? Placeable{false, 2 * g + 1, room_to_end(model_of(run), g, to)}
                        : Placeable{false, 2 * g, reach};
    }
  }
  set_rates(run, run.work.motions, to);
  return {true, 2 * run.plan().groups.size(), 0};
}

}  // namespace higherpair

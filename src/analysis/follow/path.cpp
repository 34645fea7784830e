#include "path.hpp"

#include "analysis/boundaries/contact_changes.hpp"
#include "analysis/boundaries/span_joints.hpp"
#include "analysis/tolerances.hpp"
#include "crossing.hpp"
#include "events.hpp"
#include "higherpair/contact/step_length.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "joint_ends.hpp"
#include "limit_events.hpp"
#include "path_events.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr int kHalvingsToLimit = 3;  // consecutive refused steps before a limit is looked for
constexpr double kMostSteps = 2e5;   // inner steps in addition to the least number that the path takes
// Most events on one path, of 400 bytes each. More result from a mistake, e.g. in a driver's end, and would
// fill the memory.
constexpr std::size_t kMostEvents = 250'000;

bool moves_on_boundaries(const Run& run, std::size_t g) {
  const std::vector<int>& contacts = run.plan().groups[g].contacts;
  return std::any_of(contacts.begin(), contacts.end(),
                     [&](int contact) { return run.mechanism().contacts[contact].by_boundary; });
}

// Follows a path with the inputs as parameter, in steps each of which continues the motion smoothly (see
// step.cpp). A step
//   - is as long as the last ones allow (StepLength), and before a known limit covers only a fraction of the
//     distance to it, so that a limit of another group that comes first is not passed over;
//   - ends early where a contact by boundaries changes (contact_changes.hpp);
//   - is halved where it does not continue the motion. After some refusals the limit itself is solved for
//     (LimitAhead), so that its position does not depend on the preceding steps;
//   - does not end next to a change point, where rates lose their digits: a row there is interpolated across.
// Step control: E. L. Allgower and K. Georg, Introduction to Numerical Continuation Methods, 2003, chapter 6;
// limits and change points: chapter 8, and reduction.hpp.
class Follower {
public:
  Follower(Run& run, const Path& path, double first_step)
      : Follower(run, path, first_step, least_steps(run, path)) {
    run.at.beside.reset();
  }

  bool follow() {
    while (at_.s != path_.length) {
      if (is_stopped(run_)) {
        return false;
      }
      if (run_.events.size() >= kMostEvents) {
        return give_up(fmt::format("{} events lie between two rows", kMostEvents));
      }
      if (--steps_left_ < 0) {
        return give_up("the steps that the motion allows here are too short to come to the next row");
      }
      const Outcome outcome = next();
      if (outcome != Outcome::kGoesOn) {
        return outcome == Outcome::kArrived;
      }
    }
    run_.at.inputs = path_.to;
    return true;
  }

private:
  enum class Outcome { kGoesOn, kArrived, kLost };

  Follower(Run& run, const Path& path, double first_step, double parts)
      : run_(run),
        path_(path),
        largest_(std::abs(path.length) / parts),
        at_(run, path),
        length_(largest_),
        limit_(run, path, at_.scale),
        steps_left_(kMostSteps + 4 * parts) {
    if (first_step < largest_) {
      length_.refused(2 * first_step);
    }
  }

  Outcome next() {
    aim();
    const auto broken = try_step(run_, path_, at_.s, step_);
    const bool ok = !broken;
    if (ok && close_open_contact(at_, step_)) {
      return Outcome::kGoesOn;
    }
    const auto passage = joint_within(run_, path_, at_.s, step_);
    if (passage) {
      if (const auto outcome = pass(*passage)) {
        return *outcome;
      }
    }
    passed_unseen_ = ok && !passage && passes_unseen(run_, path_, at_.s, step_);
    near_crossing_ = ok && is_near_crossing(run_, run_.work.trial);
    if (const auto shorter = better_length(ok)) {
      length_.shorten(*shorter);
      return Outcome::kGoesOn;
    }
    if (const auto beyond = ok ? end_passed_within(run_, path_, at_.s, step_) : std::nullopt) {
      length_.shorten(std::abs(*beyond));
      return Outcome::kGoesOn;
    }
    return ok ? take() : refuse(*broken);
  }

  void aim() {
    const double while_open = at_.open ? kOpenShare * largest_ : largest_;
    const Stride stride = length_.next(rest(), std::min(while_open, limit_.longest_step(at_.s)));
    step_ = stride.step;
    last_ = stride.last;
  }

  [[nodiscard]] double rest() const { return path_.length - at_.s; }

  // A better length for a step that should end elsewhere, though it need not have failed.
  [[nodiscard]] std::optional<double> better_length(bool ok) const {
    if (passed_unseen_ && std::abs(step_) > kShortPassing * at_.scale) {
      return std::abs(step_) / 2;
    }
    if (near_crossing_ && !last_ && !limit_.is_known() && std::abs(step_) > kLongStep * at_.scale) {
      return kShorterByCrossing * std::abs(step_);
    }
    if (last_ && (near_crossing_ || !ok)) {
      // End at a position to interpolate from, near enough to be certainly on the same branch.
      const double near = crossing_reach(run_, path_, run_.at.state);
      if (std::abs(rest()) > 2 * near) return std::abs(rest()) - 1.5 * near;
    }
    return std::nullopt;
  }

  // None where the contact stays on the joint.
  std::optional<Outcome> pass(const JointPassage& passage) {
    const JointOutcome outcome = pass_joint(at_, passage, step_);
    switch (outcome.kind) {
      case JointOutcome::kRests:
        return std::nullopt;
      case JointOutcome::kBroken:
        return refuse(outcome.group);
      case JointOutcome::kEnds:
        return lose({outcome.group, at_.s});
      case JointOutcome::kDiverted:
        return go_on_anew();
      case JointOutcome::kPassed:
        limit_.forget();  // that of the spans behind
        break;
    }
    return Outcome::kGoesOn;
  }

  Outcome go_on_anew() {
    limit_.forget();
    refused_ = 0;
    first_refused_ = 0;
    length_ = StepLength(largest_);
    return Outcome::kGoesOn;
  }

  Outcome take() {
    if (last_ && near_crossing_ && stop_near_crossing(run_, path_, at_.s, rest())) {
      return rest_beside_crossing();
    }
    if (meet_elsewhere(at_, step_)) {
      return go_on_anew();
    }
    advance(at_, step_);
    if (last_) {
      at_.s = path_.length;
    }
    length_.taken();
    if (limit_.is_known()) {
      limit_.look_how_far(at_.s);
    }
    if (std::abs(step_) > first_refused_ / 2) {
      refused_ = 0;
      first_refused_ = 0;
    }
    return arrives_at_limit();
  }

  // The row is next to a change point, possibly beyond it; run.at.state remains before it.
  Outcome rest_beside_crossing() {
    // At a break of a curve another path begins: a change point at the break is reported on this one.
    const double rounding =
        path_.share_to < 1 ? std::copysign(kSameChangePoint * at_.scale, path_.length) : 0;
    note_crossings(run_, path_, at_.s, path_.length + rounding);
    return Outcome::kArrived;
  }

  Outcome arrives_at_limit() {
    const bool at_limit = at_.s != path_.length && limit_.is_reached(at_.s) && limit_.is_on_path();
    return at_limit ? lose(limit_.known()) : Outcome::kGoesOn;
  }

  Outcome refuse(std::size_t g) {
    if (last_ && stop_near_crossing(run_, path_, at_.s, rest())) {
      return rest_beside_crossing();
    }
    limit_.look_how_far(at_.s);
    const bool near = limit_.is_near(at_.s);
    const auto lost_before = near ? limit_.lost_before(at_.s) : std::nullopt;
    const bool exhausted = near && !lost_before;
    if (exhausted && limit_.is_on_path()) {
      return lose(limit_.known());
    }
    length_.refused(step_);
    first_refused_ = refused_ == 0 ? std::abs(step_) : first_refused_;
    if (++refused_ % kHalvingsToLimit == 0 && limit_.look_for(g, at_.s, step_)) {
      return Outcome::kArrived;
    }
    if (length_.value() < shortest_step(at_.scale, size_at(run_, path_, at_.s))) {
      if (exhausted && limit_.rests_before(at_.s)) {
        return Outcome::kArrived;
      }
      return lose(exhausted ? limit_.known() : limit_.assumed(lost_before.value_or(g), at_.s));
    }
    return Outcome::kGoesOn;
  }

  // Continues beyond what looks like a limit but is a joint of spans: where two flat parts meet face to face
  // the contact has no curvature to continue with, but it does continue beyond them.
  std::optional<Outcome> look_beyond(const PathLimit& limit) {
    if (limit.s == last_looked_ || !moves_on_boundaries(run_, limit.group)) {
      return std::nullopt;
    }
    last_looked_ = limit.s;
    const double left = std::abs(limit.s - at_.s);
    const double ahead = std::max(2 * left, left + kReachesLimit * at_.scale);
    step_ = std::copysign(std::min(ahead, std::abs(rest())), path_.length);
    last_ = step_ == rest();
    (void)try_step(run_, path_, at_.s, step_);
    const auto passage = joint_within(run_, path_, at_.s, step_);
    return passage ? pass(*passage) : std::nullopt;
  }

  // Ends the motion, unless it goes on in another way.
  Outcome lose(const PathLimit& limit) {
    if (pass_vertex(at_, limit) || hand_over(at_, limit.group)) {
      return go_on_anew();
    }
    if (const auto outcome = look_beyond(limit)) {
      return *outcome;
    }
    if (part_contact(at_, limit)) {
      return go_on_anew();
    }
    RunEvent event = limit_event(run_, limit.group, path_, limit.s);
    const double behind_end = (limit.s - path_.length) * (path_.length < 0 ? -1 : 1);
    const bool is_beyond_row = behind_end > kNearLimit * at_.scale;
    if (is_beyond_row) {
      place_event(event, path_, limit.s);
      event.cause += ", which is at infinity: the row is before it, but so near that it cannot be computed";
    }
    // A limit at infinity may have been passed by a rounding.
    const double least = std::copysign(shortest_step(at_.scale, size_at(run_, path_, at_.s)), path_.length);
    // The motion can be resumed from where rates still have their digits.
    at_.s = limit_.go_back_from_far().value_or(at_.s);
    const bool is_ahead = (limit.s - at_.s) * path_.length > 0;
    forget_beside(event);
    end(event, is_ahead ? at_.s : limit.s - least, limit.s);
    run_.at.lost.is_beyond_row = is_beyond_row;
    return Outcome::kLost;
  }

  // Removes the events found next to a limit that are not certain there: rates and curvatures are too inexact
  // to show whether a joint reverses or curves conform, and a contact that ends there may change to and fro.
  void forget_beside(const RunEvent& limit) {
    const double per_unit = at_.scale * std::abs((path_.share_to - path_.share_from) / path_.length);
    std::erase_if(run_.events, [&](const RunEvent& event) {
      const double apart = std::abs(event.share - limit.share);
      const bool inexact = event.type == EventType::kStrokeEnd || event.type == EventType::kConforming;
      const bool same_contact = event.contact && event.contact == limit.contact &&
                                (event.type == EventType::kEnd || event.type == EventType::kCorner);
      return (inexact && apart <= kNearLimit * per_unit) || (same_contact && apart <= kSameLimit * per_unit);
    });
  }

  // Ends a path that would take too long. Returns false, as follow() does where the motion is lost.
  bool give_up(const std::string& why) {
    const std::string cause = why +
                              ", and this path is not followed further; let the drivers go less far, or take "
                              "more rows (driver.samples; in time a shorter driver.time_step)";
    end(event_at(EventType::kEnd, path_, at_.s, cause), at_.s, at_.s);
    run_.at.lost.for_good = true;
    return false;
  }

  // The motion is lost at s = `at`; s = `from` is the last position before.
  void end(const RunEvent& event, double from, double at) {
    run_.at.lost.event = event;
    path_.inputs(from, run_.at.lost.from);
    path_.inputs(at, run_.at.lost.at);
    run_.at.lost.looked_to.reset();
    run_.at.lost.other.reset();
    run_.at.lost.nearest.reset();
    run_.at.lost.is_beyond_row = false;
    report_limit(run_, path_, event);
    run_.at.on_branch = false;
    run_.at.inputs = path_.to;
  }

  Run& run_;
  const Path& path_;
  double largest_;              // largest step
  OnPath at_;                   // progress of run.at.state on the path
  double step_ = 0;             // the step that is tried
  bool last_ = false;           // whether it leads to the end
  bool near_crossing_ = false;  // whether it could be taken and leads next to where branches may cross
  bool passed_unseen_ = false;  // whether it could be taken and passes joints none of which is found: a
                                // contact is at other spans in between
  StepLength length_;           // the largest step that may be tried
  LimitAhead limit_;            // the first known limit
  int refused_ = 0;             // steps refused, until one as long as the first of them is taken
  double first_refused_ = 0;
  double last_looked_ = kNoValue;  // s of the last limit looked beyond
  double steps_left_;
};

// The first break on the way from one time to another, or where that way ends.
double next_break(const DriverCurve& curve, double from, double to) {
  const auto [before, after] = std::equal_range(curve.breaks.begin(), curve.breaks.end(), from);
  if (to > from) {
    return after == curve.breaks.end() ? to : std::min(*after, to);
  }
  return before == curve.breaks.begin() ? to : std::max(before[-1], to);
}

// Follows a path on which the drivers' rates do not jump.
bool follow_piece(Run& run, const Path& path, double first_step) {
  begin_path(run, path);
  return Follower(run, path, first_step).follow();
}

}  // namespace

bool follow(Run& run, const Path& path, double first_step) {
  if (!path.curve) {
    return follow_piece(run, path, first_step);
  }
  Path piece;
  double at = path.from[0];
  do {
    set_part(run, piece, {at}, {next_break(*path.curve, at, path.to[0])});
    if (!follow_piece(run, piece, first_step)) {
      return false;
    }
    first_step = kInf;
    at = piece.to[0];
    if (at != path.to[0] && run.at.inputs[0] != at) {
      // Next to a change point, where rates lose their digits, the state has not come to the break.
      const double beyond = at + std::copysign(kOverBreak * unit_of(run, path), path.length);
      at = std::abs(beyond - at) < std::abs(path.to[0] - at) ? beyond : path.to[0];
      set_part(run, piece, run.at.inputs, {at});
      piece.is_chord = true;
      if (!follow_piece(run, piece, kInf)) {
        return false;
      }
    }
  } while (at != path.to[0]);
  return true;
}

}  // namespace higherpair

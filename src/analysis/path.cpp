#include "path.hpp"

#include "crossing.hpp"
#include "events.hpp"
#include "flat_contacts.hpp"
#include "gap_contacts.hpp"
#include "higherpair/contact/step_length.hpp"
#include "limit_ahead.hpp"
#include "limit_events.hpp"
#include "overlap.hpp"
#include "shared_places.hpp"
#include "span_joints.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr double kMaxSlide = 1.0 / 6;   // of a driver in one inner step, of the size
constexpr int kHalvingsToLimit = 3;     // refused steps, one after the other, before a limit is looked for
constexpr double kBesideLimit = 1e-12;  // of the driver's scale: as near before a limit a row needs no step
constexpr double kLongStep = 0.02;      // of the driver's scale: one that may as well end elsewhere
constexpr double kOpenShare = 0.2;      // of the largest step: while a contact is open
constexpr double kMostSteps = 2e5;      // inner steps besides those that the path takes at least

// Of how many inner steps a path is at least.
double parts_of(const Run& run, const Path& path) {
  double parts = 1;
  for (std::size_t i = 0; i < path.from.size(); ++i) {
    const Joint& joint = run.mechanism().joints[static_cast<std::size_t>(run.mechanism().drivers[i].joint)];
    const double largest =
        joint.type == JointType::kRevolute ? kLargestTurn : kMaxSlide * driver_scale(run, i);
    parts = std::max(parts, std::abs(path.to[i] - path.from[i]) / largest);
  }
  return parts;
}

void accept(Run& run) {
  std::swap(run.at.state, run.work.trial);
}

// Follows a path with the drivers as parameter, in steps each of which continues the motion smoothly
// (step.cpp says what that takes). A step
//   - is as long as the last ones allow (StepLength), and before a known limit covers only a share of what is
//     left, so that a limit of another group that comes first is not passed over;
//   - ends early where a contact by boundaries changes: it closes, comes to a joint of spans, or the bodies
//     meet elsewhere;
//   - is halved where it does not continue the motion. After some refusals the limit itself is solved for
//     (LimitAhead), so that its place does not depend on the steps that led up to it;
//   - does not end next to a change point, where rates lose their digits: a row there is interpolated across.
// Step control: E. L. Allgower and K. Georg, Introduction to Numerical Continuation Methods, 2003, chapter 6;
// limits and change points: chapter 8, and reduction.hpp.
class Follower {
public:
  Follower(Run& run, const Path& path, double first_step)
      : Follower(run, path, first_step, parts_of(run, path)) {
    run.at.beside.reset();
  }

  bool follow() {
    while (s_ != path_.length) {
      if (is_stopped(run_)) {
        return false;
      }
      const Outcome outcome = next();
      if (outcome != Outcome::kGoesOn) {
        return outcome == Outcome::kArrived;
      }
    }
    run_.at.drivers = path_.to;
    return true;
  }

private:
  enum class Outcome { kGoesOn, kArrived, kLost };

  Follower(Run& run, const Path& path, double first_step, double parts)
      : run_(run),
        path_(path),
        largest_(std::abs(path.length) / parts),
        scale_(path.is_single() ? driver_scale(run, 0) : 1),
        near_(kCrossingReach * (path.is_single() ? scale_ : unit_of(run, path))),
        length_(largest_),
        limit_(run, path, scale_),
        open_(has_open_contact(run.at.state)),
        steps_left_(kMostSteps + 4 * parts) {
    if (first_step < largest_) {
      length_.refused(2 * first_step);
    }
  }

  Outcome next() {
    if (--steps_left_ < 0) {
      return lose({run_.plan().groups.size() - 1, s_});
    }
    aim();
    const StepResult result = try_step(run_, path_, s_, step_);
    if (open_ && result.kind == StepResult::kOk && close()) {
      return Outcome::kGoesOn;
    }
    if (const auto passage = joint_within(run_, path_, s_, step_)) {
      if (const auto outcome = pass(*passage)) {
        return *outcome;
      }
    }
    const bool ok = result.kind == StepResult::kOk;
    near_crossing_ = ok && is_near_crossing(run_, run_.work.trial);
    if (const auto shorter = better_length(ok)) {
      length_.shorten(*shorter);
      return Outcome::kGoesOn;
    }
    return ok ? take() : refuse(result.group);
  }

  void aim() {
    const double while_open = open_ ? kOpenShare * largest_ : largest_;
    const Stride stride = length_.next(rest(), std::min(while_open, limit_.longest_step(s_)));
    step_ = stride.step;
    last_ = stride.last;
  }

  [[nodiscard]] double rest() const { return path_.length - s_; }

  // Of a step that should end elsewhere, though it need not have failed.
  [[nodiscard]] std::optional<double> better_length(bool ok) const {
    if (near_crossing_ && !last_ && !limit_.is_known() && std::abs(step_) > kLongStep * scale_) {
      return 0.618 * std::abs(step_);
    }
    if (last_ && std::abs(rest()) > 2 * near_ && (near_crossing_ || !ok)) {
      // A position to interpolate from, near enough to be on the same branch for certain.
      return std::abs(rest()) - 1.5 * near_;
    }
    return std::nullopt;
  }

  // Ends the step where an open contact closes, unless another contact comes to a joint of spans before that.
  bool close() {
    const auto engagement = engagement_within(run_, path_, s_, step_);
    if (!engagement) {
      return false;
    }
    StateAside aside(run_.work.trial);
    if (const auto passage = joint_within(run_, path_, s_, step_);
        passage && std::abs(passage->x) < std::abs(engagement->x)) {
      return false;
    }
    const auto x = engage(run_, path_, s_, *engagement);
    if (!x) {
      return false;
    }
    aside.commit();
    s_ += *x;
    open_ = has_open_contact(run_.at.state);
    return true;
  }

  // Instead of ending, the motion goes on without a contact that may part.
  bool part(std::size_t g) {
    const auto reason = s_ == parted_at_ ? std::nullopt : why_parting(run_, g);
    if (!reason) {
      return false;
    }
    release(run_, path_, s_, g, *reason);
    parted_at_ = s_;
    open_ = true;
    go_on_anew();
    return true;
  }

  // Ends the step at a joint of spans, where accelerations may jump, and begins the next one beyond it; none
  // where it rests on the joint.
  std::optional<Outcome> pass(const JointPassage& passage) {
    const bool again = passage.contact == passed_.contact && passage.side == passed_.side &&
                       passage.after.span == passed_.before.span &&
                       std::abs(s_ + passage.x - passed_.x) <= shortest_step(scale_, 0);
    if (again || !place_at_joint(run_, path_, s_, passage)) {
      // It rests on the joint, to within rounding: either span will do.
      (void)try_step(run_, path_, s_, step_);
      return std::nullopt;
    }
    if (const auto group = broken_off(run_, passage.x)) {
      (void)try_step(run_, path_, s_, step_);
      return refuse(*group);
    }
    if (meet(passage.x)) {
      return Outcome::kGoesOn;
    }
    if (passage.x != 0) {
      note_events(run_, path_, s_, passage.x);
      watch_overlaps(run_, path_, s_, passage.x);
      accept(run_);
    }
    s_ += passage.x;
    passed_ = passage;
    passed_.x = s_;
    // At an edge another place at which the bodies touch takes over, if there is one.
    if (is_on_edge(run_, passage.contact, passage.side, passage.after) &&
        hand_over(group_of_contact(passage.contact))) {
      return Outcome::kGoesOn;
    }
    if (!lies_flat_behind(run_, passage)) {
      go_over_joint(run_, path_, s_, passage);
      return Outcome::kGoesOn;
    }
    const auto rests = go_over_flat(run_, path_, s_, passage);
    if (!rests) {
      return lose({group_of_contact(passage.contact), s_});
    }
    passed_ = *rests;
    passed_.x = s_;
    go_on_anew();
    return Outcome::kGoesOn;
  }

  [[nodiscard]] std::size_t group_of_contact(std::size_t contact) const {
    const auto& groups = run_.plan().groups;
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return std::find(group.contacts.begin(), group.contacts.end(), static_cast<int>(contact)) !=
             group.contacts.end();
    });
    return static_cast<std::size_t>(found - groups.begin());
  }

  // Ends a step, which leads to run.work.trial, where touching boundaries meet elsewhere.
  bool meet(double h) {
    const Meetings meetings = meetings_elsewhere(run_, path_, s_, h);
    const auto& meeting = meetings.first;
    if (!meeting) {
      for (const SharedTouch& touch : meetings.sharing) {
        note_shared_places(run_, path_, touch, s_, h);
      }
      return false;
    }
    if (meeting->x != 0) {
      StateAside aside(run_.work.trial);
      if (!solve_at(run_, path_, s_, meeting->x)) {
        return false;
      }
      aside.commit();
      for (const SharedTouch& touch : meetings.sharing) {
        note_shared_places_until(run_, path_, touch, s_, meeting->x);
      }
      note_events(run_, path_, s_, meeting->x);
      watch_overlaps(run_, path_, s_, meeting->x);
      accept(run_);
    }
    // Where they meet again at once neither contact can be kept.
    const bool again = s_ + meeting->x == met_at_;
    s_ += meeting->x;
    go_over_to(run_, path_, s_, *meeting, !again);
    met_at_ = s_;
    go_on_anew();
    return true;
  }

  // Where a contact ends another place at which the same bodies touch takes over.
  bool hand_over(std::size_t g) {
    if (s_ == taken_over_at_ || !take_over(run_, path_, s_, g)) {
      return false;
    }
    taken_over_at_ = s_;
    go_on_anew();
    return true;
  }

  // What looks like a limit may be where two corners meet, which have no normal to go on with.
  bool pass_vertex(const PathLimit& limit) {
    if (limit.s == taken_over_at_ || std::abs(limit.s) > std::abs(path_.length) ||
        !go_over_vertex(run_, path_, limit.s, limit.group)) {
      return false;
    }
    s_ = limit.s;
    taken_over_at_ = s_;
    go_on_anew();
    return true;
  }

  void go_on_anew() {
    limit_.forget();
    refused_ = 0;
    first_refused_ = 0;
    length_ = StepLength(largest_);
  }

  Outcome take() {
    if (last_ && near_crossing_ && stop_near_crossing(run_, path_, s_, rest())) {
      return rest_beside_crossing();
    }
    if (meet(step_)) {
      return Outcome::kGoesOn;
    }
    note_events(run_, path_, s_, step_);
    watch_overlaps(run_, path_, s_, step_);
    accept(run_);
    s_ = last_ ? path_.length : s_ + step_;
    length_.taken();
    if (std::abs(step_) > first_refused_ / 2) {
      refused_ = 0;
      first_refused_ = 0;
    }
    return arrives_at_limit();
  }

  // The row is next to a change point, maybe beyond it; run.at.state remains before it.
  Outcome rest_beside_crossing() {
    note_crossings(run_, path_, s_, path_.length);
    return Outcome::kArrived;
  }

  // A row just before a limit, to which no step can be judged; run.at.state remains before it.
  bool rest_beside_limit() {
    if (std::abs(limit_.known().s - path_.length) > kBesideLimit * scale_ ||
        !solve_at(run_, path_, s_, rest())) {
      return false;
    }
    run_.at.beside = run_.work.trial;
    path_.positions(s_, run_.at.drivers);
    return true;
  }

  Outcome arrives_at_limit() {
    const bool at_limit = s_ != path_.length && limit_.is_reached(s_) && limit_.is_on_path();
    return at_limit ? lose(limit_.known()) : Outcome::kGoesOn;
  }

  Outcome refuse(std::size_t g) {
    if (last_ && stop_near_crossing(run_, path_, s_, rest())) {
      return rest_beside_crossing();
    }
    const bool exhausted = limit_.is_near(s_);
    if (exhausted && limit_.is_on_path()) {
      return lose(limit_.known());
    }
    length_.refused(step_);
    first_refused_ = refused_ == 0 ? std::abs(step_) : first_refused_;
    if (++refused_ % kHalvingsToLimit == 0 && limit_.look_for(g, s_, step_)) {
      return Outcome::kArrived;
    }
    if (length_.value() < shortest_step(scale_, driver_at(path_, s_))) {
      if (exhausted && rest_beside_limit()) {
        return Outcome::kArrived;
      }
      return lose(exhausted ? limit_.known() : limit_.assumed(g, s_));
    }
    return Outcome::kGoesOn;
  }

  // What looks like a limit may be a joint of spans: where two flat parts come to lie on each other a contact
  // has no curvature to go on with, but goes on beyond them.
  std::optional<Outcome> pass_instead(const PathLimit& limit) {
    if (limit.s == last_looked_ || !moves_on_boundaries(limit.group)) {
      return std::nullopt;
    }
    last_looked_ = limit.s;
    const double ahead =
        std::max(2 * std::abs(limit.s - s_), std::abs(limit.s - s_) + kReachesLimit * scale_);
    step_ = std::copysign(std::min(ahead, std::abs(rest())), path_.length);
    last_ = step_ == rest();
    (void)try_step(run_, path_, s_, step_);
    const auto passage = joint_within(run_, path_, s_, step_);
    return passage ? pass(*passage) : std::nullopt;
  }

  [[nodiscard]] bool moves_on_boundaries(std::size_t g) const {
    const std::vector<int>& contacts = run_.plan().groups[g].contacts;
    return std::any_of(contacts.begin(), contacts.end(), [&](int contact) {
      return run_.mechanism().contacts[static_cast<std::size_t>(contact)].by_boundary;
    });
  }

  Outcome lose(const PathLimit& limit) {
    if (pass_vertex(limit) || hand_over(limit.group)) {
      return Outcome::kGoesOn;
    }
    if (const auto outcome = pass_instead(limit)) {
      return *outcome;
    }
    if (part(limit.group)) {
      return Outcome::kGoesOn;
    }
    run_.at.lost.event = limit_event(run_, limit.group, path_, limit.s);
    path_.positions(s_, run_.at.lost.from);
    path_.positions(limit.s, run_.at.lost.at);
    report_limit(run_, path_, run_.at.lost.event);
    run_.at.held = false;
    run_.at.drivers = path_.to;
    return Outcome::kLost;
  }

  Run& run_;
  const Path& path_;
  double largest_;              // step
  double scale_;                // of the driver
  double near_;                 // how far from a crossing places are interpolated from
  double s_ = 0;                // of run.at.state
  double step_ = 0;             // that is tried
  bool last_ = false;           // it leads to the end
  bool near_crossing_ = false;  // it could be taken and leads next to where branches may cross
  StepLength length_;           // of the largest step that may be tried
  LimitAhead limit_;            // the first known
  int refused_ = 0;             // steps, until one as long as the first of them is taken
  double first_refused_ = 0;
  bool open_;                                                        // a contact is
  double parted_at_ = std::numeric_limits<double>::quiet_NaN();      // s of the last contact that parted
  double taken_over_at_ = std::numeric_limits<double>::quiet_NaN();  // s of the last place that took over
  double met_at_ = std::numeric_limits<double>::quiet_NaN();         // s of the last meeting elsewhere
  double last_looked_ = std::numeric_limits<double>::quiet_NaN();    // s of the last limit looked beyond
  JointPassage passed_;                                              // the last one, at s_ = passed_.x
  double steps_left_;
};

}  // namespace

bool follow(Run& run, const Path& path, double first_step) {
  return Follower(run, path, first_step).follow();
}

}  // namespace higherpair

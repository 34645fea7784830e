#include "path.hpp"

#include "crossing.hpp"
#include "events.hpp"
#include "flat_contacts.hpp"
#include "gap_contacts.hpp"
#include "higherpair/contact/step_agreement.hpp"
#include "higherpair/geometry/roots.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "limit_events.hpp"
#include "overlap.hpp"
#include "reduction.hpp"
#include "shared_places.hpp"
#include "short_way.hpp"
#include "span_joints.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr double kMaxStepTurn = kPi / 18;  // of a driver in one inner step [rad]
constexpr double kMaxSlide = 1.0 / 6;      // of a driver in one inner step, of the size
constexpr double kSmallestStep = 1e-14;    // of the driver's scale
constexpr int kHalvingsToLimit = 3;        // refused steps, one after the other, before a limit is looked for
constexpr double kShareToLimit = 0.5;      // of what is left to a limit: the next step
constexpr double kAtLimit = 1e-9;          // of the driver's scale: as near as this a limit is reached
constexpr double kNearLimit = 1e-6;        // of the driver's scale: nearer, rates may be too inexact to go on
constexpr double kBesideLimit = 1e-12;  // of the driver's scale: as near before a limit a row needs no step
constexpr double kOnLimit = 1e-14;      // of the driver's scale: a row that is at the limit itself
constexpr double kLongStep = 0.02;      // of the driver's scale: one that may as well end elsewhere
constexpr double kOpenShare = 0.2;      // of the largest step: while a contact is open
constexpr double kProbe = kPi / 144;    // of the driver's scale: where a branch that was lost is looked for
constexpr double kMostProbes = 1e4;
constexpr double kMostSteps = 2e5;  // inner steps besides those that the path takes at least

// Of how many inner steps a path is at least.
double parts_of(const Run& run, const Path& path) {
  double parts = 1;
  for (std::size_t i = 0; i < path.from.size(); ++i) {
    const Joint& joint = run.mechanism().joints[static_cast<std::size_t>(run.mechanism().drivers[i].joint)];
    const double largest =
        joint.type == JointType::kRevolute ? kMaxStepTurn : kMaxSlide * driver_scale(run, i);
    parts = std::max(parts, std::abs(path.to[i] - path.from[i]) / largest);
  }
  return parts;
}

void accept(Run& run) {
  std::swap(run.at.state, run.work.trial);
}

// A row at a limit: in run.work.trial, with positions only; run.at.state remains short of it.
void stop_at_limit(Run& run, const Path& path, std::size_t g, Reduction& reduction,
                   const Reduction::Point& limit, double s) {
  reduction.place(limit);
  run.work.trial.groups[g].sine = 0;
  run.work.trial.groups[g].sine_rate = 0;
  for (std::size_t later = g + 1; later < run.plan().groups.size(); ++later) {
    run.work.trial.groups[later].mode = run.at.state.groups[later].mode;
    (void)place_group(model_of(run), later, run.at.state, limit.ahead, path.to, run.work.trial);
  }
  run.at.beside = run.work.trial;
  path.positions(s, run.at.drivers);
}

// Follows a path in steps that continue the motion smoothly. Before a limit the steps end at a share of what
// is left, so that a limit of another group that comes first is not passed over.
class Follower {
public:
  Follower(Run& run, const Path& path) : Follower(run, path, parts_of(run, path)) { run.at.beside.reset(); }

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

  struct Limit {
    std::size_t group = 0;
    double s = 0;
  };

  Follower(Run& run, const Path& path, double parts)
      : run_(run),
        path_(path),
        largest_(std::abs(path.length) / parts),
        scale_(path.is_single() ? driver_scale(run, 0) : 1),
        near_(kCrossingReach * (path.is_single() ? scale_ : unit_of(run, path))),
        h_(largest_),
        open_(has_open_contact(run.at.state)),
        steps_left_(kMostSteps + 4 * parts) {}

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
      longest_ = std::max(longest_, h_);
      h_ = *shorter;
      return Outcome::kGoesOn;
    }
    return ok ? take() : refuse(result.group);
  }

  void aim() {
    const double rest = path_.length - s_;
    double h = h_;
    if (open_) {
      h = std::min(h, kOpenShare * largest_);
    }
    if (limit_) {
      h = std::min(h, kShareToLimit * std::abs(limit_->s - s_));
    }
    last_ = std::abs(rest) <= kAlmostThere * h;
    step_ = last_ ? rest : std::copysign(h, rest);
  }

  [[nodiscard]] double rest() const { return path_.length - s_; }

  // Of a step that should end elsewhere, though it need not have failed.
  [[nodiscard]] std::optional<double> better_length(bool ok) const {
    if (near_crossing_ && !last_ && !limit_ && std::abs(step_) > kLongStep * scale_) {
      return 0.618 * std::abs(step_);
    }
    if (last_ && std::abs(rest()) > 2 * near_ && (near_crossing_ || !ok)) {
      // A place to interpolate from, near enough to be on the same branch surely.
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
    const State kept = run_.work.trial;
    if (const auto passage = joint_within(run_, path_, s_, step_);
        passage && std::abs(passage->x) < std::abs(engagement->x)) {
      run_.work.trial = kept;
      return false;
    }
    const auto x = engage(run_, path_, s_, *engagement);
    if (!x) {
      run_.work.trial = kept;
      return false;
    }
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
                       std::abs(s_ + passage.x - passed_.x) <= kSmallestStep * scale_;
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
    const State kept = run_.work.trial;
    if (meeting->x != 0) {
      if (!solve_at(run_, path_, s_, meeting->x)) {
        run_.work.trial = kept;
        return false;
      }
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

  void go_on_anew() {
    limit_.reset();
    refused_ = 0;
    first_refused_ = longest_ = 0;
    h_ = largest_;
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
    h_ = std::max(longest_, std::min(2 * h_, largest_));
    longest_ = 0;
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
    if (std::abs(limit_->s - path_.length) > kBesideLimit * scale_ || !solve_at(run_, path_, s_, rest())) {
      return false;
    }
    run_.at.beside = run_.work.trial;
    path_.positions(s_, run_.at.drivers);
    return true;
  }

  // A limit is reached when nothing is left but a rounding of the driver's coordinate.
  Outcome arrives_at_limit() {
    const bool at_limit = limit_ && s_ != path_.length && std::abs(limit_->s - s_) <= kAtLimit * scale_ &&
                          (path_.length - limit_->s) * path_.length >= 0;
    return at_limit ? lose(*limit_) : Outcome::kGoesOn;
  }

  Outcome refuse(std::size_t g) {
    if (last_ && stop_near_crossing(run_, path_, s_, rest())) {
      return rest_beside_crossing();
    }
    const bool exhausted = limit_ && std::abs(limit_->s - s_) <= kNearLimit * scale_;
    if (exhausted && (path_.length - limit_->s) * path_.length >= 0) {
      return lose(*limit_);
    }
    h_ = std::abs(step_) / 2;
    longest_ = 0;
    first_refused_ = refused_ == 0 ? std::abs(step_) : first_refused_;
    if (++refused_ % kHalvingsToLimit == 0) {
      if (const auto outcome = look_for_limit(g)) {
        return *outcome;
      }
    }
    if (h_ < smallest()) {
      if (exhausted && rest_beside_limit()) {
        return Outcome::kArrived;
      }
      return lose(exhausted ? *limit_ : Limit{g, s_ + left_by(g)});
    }
    return Outcome::kGoesOn;
  }

  // Where the group's own limit lies, and whether it comes before the one known.
  std::optional<Outcome> look_for_limit(std::size_t g) {
    if (limit_ && limit_->group == g) {
      return std::nullopt;
    }
    Reduction reduction(run_, path_, g, s_);
    const auto found = reduction.limit_ahead(step_);
    if (!found) {
      return std::nullopt;
    }
    const double s = s_ + found->ahead;
    if (std::abs(path_.length - s) <= kOnLimit * (scale_ + std::abs(driver_at(path_, s)))) {
      report_limit(run_, path_, limit_event(run_, g, path_, path_.length));
      stop_at_limit(run_, path_, g, reduction, *found, s_);
      return Outcome::kArrived;
    }
    if (!limit_ || std::abs(s - s_) < std::abs(limit_->s - s_)) {
      limit_ = Limit{g, s};
    }
    return std::nullopt;
  }

  [[nodiscard]] double smallest() const {
    return kSmallestStep * scale_ * (1 + std::abs(driver_at(path_, s_)) / scale_);
  }

  // Where bodies run off to infinity there is no last position; what goes to 0 there says how far it is. At
  // an end of a curve or a guide nothing is left but the smallest step.
  [[nodiscard]] double left_by(std::size_t g) const {
    const GroupState& group = run_.at.state.groups[g];
    const double left = group.sine_rate == 0 ? 0 : -group.sine / group.sine_rate;
    return std::abs(left) <= kNearLimit * scale_ && left * path_.length > 0
               ? left
               : std::copysign(smallest(), path_.length);
  }

  // What looks like a limit may be a joint of spans: where two flat parts come to lie on each other a contact
  // has no curvature to go on with, but goes on beyond them.
  std::optional<Outcome> pass_instead(const Limit& limit) {
    if (limit.s == last_looked_ || !moves_on_boundaries(limit.group)) {
      return std::nullopt;
    }
    last_looked_ = limit.s;
    const double ahead = std::max(2 * std::abs(limit.s - s_), std::abs(limit.s - s_) + kAtLimit * scale_);
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

  Outcome lose(const Limit& limit) {
    if (hand_over(limit.group)) {
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
  double h_;                    // largest step that may be tried
  double longest_ = 0;  // where a step was shortened though it need not have failed: what it was before
  int refused_ = 0;     // steps, until one as long as the first of them is taken
  double first_refused_ = 0;
  bool open_;                                                        // a contact is
  double parted_at_ = std::numeric_limits<double>::quiet_NaN();      // s of the last contact that parted
  double taken_over_at_ = std::numeric_limits<double>::quiet_NaN();  // s of the last place that took over
  double met_at_ = std::numeric_limits<double>::quiet_NaN();         // s of the last meeting elsewhere
  double last_looked_ = std::numeric_limits<double>::quiet_NaN();    // s of the last limit looked beyond
  JointPassage passed_;                                              // the last one, at s_ = passed_.x
  std::optional<Limit> limit_;                                       // the first known
  double steps_left_;
};

bool has_track(const Run& run) {
  return std::any_of(run.at.state.tracks.begin(), run.at.state.tracks.end(),
                     [](const PairTrack& track) { return std::holds_alternative<ContactTrack>(track); });
}

// Whether the drivers are at the limit, to within half of what a row there may be off, or back from it, as
// seen from where the motion came.
bool has_come_back(const Run& run, const std::vector<double>& drivers) {
  double beyond = 0;
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    const double ahead = run.at.lost.at[i] - run.at.lost.from[i];
    const double near = kOnLimit / 2 * (driver_scale(run, i) + std::abs(drivers[i]));
    beyond += (drivers[i] - run.at.lost.at[i]) * ahead - near * std::abs(ahead);
  }
  return beyond <= 0;
}

// Back from the limit the motion goes on from where it was lost.
bool come_back(Run& run, const std::vector<double>& drivers) {
  Path path;
  set_path(path, run.at.lost.from, drivers);
  if (!path.is_single()) {
    path.motions(0, run.work.motions);
    set_rates(run, run.work.motions, run.at.state);
  }
  renew_overlaps(run);
  run.at.held = true;
  report_limit(run, path, run.at.lost.event);
  return follow(run, path);
}

}  // namespace

void name_item(const Run& run, std::size_t g, RunEvent& event) {
  const Group& group = run.plan().groups[g];
  if (!group.contacts.empty()) {
    event.contact = group.contacts.front();
  } else if (!group.joints.empty()) {
    event.joint = group.joints.front();
  }
}

RunEvent event_at(EventType type, const Path& path, double s, std::string_view cause) {
  RunEvent event;
  event.type = type;
  set_place(event, path, s);
  event.cause = cause;
  return event;
}

void set_place(RunEvent& event, const Path& path, double s) {
  event.driver = driver_at(path, s);
  event.share = path.length == 0 ? 1 : s / path.length;
}

double driver_at(const Path& path, double s) {
  return path.is_single() ? path.from[0] + s : path.from[0] + s * (path.to[0] - path.from[0]);
}

void Path::positions(double s, std::vector<double>& out) const {
  out.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    out[i] = s == length ? to[i] : from[i] + s * (is_single() ? 1 : to[i] - from[i]);
  }
}

void Path::motions(double s, std::vector<DriverMotion>& out) const {
  out.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double rate = is_single() ? 1 : to[i] - from[i];
    out[i] = {s == length ? to[i] : from[i] + s * rate, rate, 0};
  }
}

void set_path(Path& path, const std::vector<double>& from, const std::vector<double>& to) {
  path.from.resize(from.size());
  path.to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {  // a few numbers: a loop costs less than copying blocks
    path.from[i] = from[i];
    path.to[i] = to[i];
  }
  path.length = path.is_single() ? to[0] - from[0] : 1;
}

bool follow(Run& run, const Path& path) {
  return Follower(run, path).follow();
}

namespace {

// Takes the branch up again at the drivers' positions, if it is there; an event says where the stretch
// begins: at the limit on the way back to `from`.
bool take_up(Run& run, const std::vector<double>& drivers, const std::vector<double>& from) {
  if (!place_anew(run, drivers)) {
    return false;
  }
  const State lost = run.at.state;
  Run back = run;
  accept(back);
  back.events.clear();
  back.at.held = true;
  back.at.beside.reset();
  back.at.drivers = drivers;
  Path path_back;
  set_path(path_back, drivers, from);
  if (follow(back, path_back) && has_track(run)) {
    return false;  // without a limit on the way back it is a contact that the follower cannot have come to
  }
  accept(run);
  renew_overlaps(run);
  run.at.held = true;
  run.at.beside.reset();
  run.at.drivers = drivers;
  Path path;
  set_path(path, from, drivers);
  for (RunEvent& event : back.events) {
    // Where a curve ends the motion may have gone on over the edge.
    const bool is_last = &event == &back.events.back();
    if (event.type == EventType::kLimitPosition || (event.type == EventType::kEnd && is_last)) {
      event.share = 1 - event.share;
      report_limit(run, path, std::move(event));
    }
  }
  if (!back.at.held) {
    take_short_way(run, lost, back.at.state);
  }
  return true;
}

// Where a branch that was lost is looked for between `from` and `to`: every kProbe of the driver from the
// limit, so that it is found again at the same place whatever the rows.
std::vector<double> probes(const Run& run, double from, double to) {
  const double step = std::copysign(kProbe * driver_scale(run, 0), to - from);
  const double first = std::max(1.0, std::ceil((from - run.at.lost.at[0]) / step));
  const double last = std::min((to - run.at.lost.at[0]) / step, first + kMostProbes);
  std::vector<double> found;
  for (double k = first; k < last; ++k) {
    found.push_back(run.at.lost.at[0] + k * step);
  }
  return found;
}

}  // namespace

bool resume(Run& run, const std::vector<double>& drivers, const std::vector<double>& from) {
  if (is_stopped(run)) {
    return false;
  }
  if (has_come_back(run, drivers)) {
    return come_back(run, drivers);
  }
  if (run.plan().couples) {
    return false;  // their branch beyond the limit has no label to ask for
  }
  if (drivers.size() > 1) {
    return take_up(run, drivers, from);
  }
  for (const double probe : probes(run, from[0], drivers[0])) {
    if (is_stopped(run)) {
      return false;
    }
    const std::vector<double> at{probe};
    if (take_up(run, at, run.at.lost.at)) {
      Path path;
      set_path(path, at, drivers);
      return follow(run, path) || resume(run, drivers, run.at.lost.at);
    }
  }
  return take_up(run, drivers, run.at.lost.at);
}

}  // namespace higherpair

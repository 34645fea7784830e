#include "resume.hpp"

#include "analysis/boundaries/overlap.hpp"
#include "analysis/groups/coupled_system.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "limit_events.hpp"
#include "line_ahead.hpp"
#include "outlook.hpp"
#include "path.hpp"
#include "reduction.hpp"
#include "short_way.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

// Resumes the motion beyond the limit where it was lost. A stretch is a range of the drivers in which
// the branch can be assembled.

namespace higherpair {
namespace {

constexpr int kFirstProbes = 4;  // further probes near the limit, spaced by factors of 4
constexpr double kMostProbes = 4e4;

// Most stretches that meet at poles, one after another; more would be made and ended by rounding alone.
constexpr int kMostPoles = 16;

// Whether some contact is found again from a list of all contacts, of which more than one may be on the
// branch.
bool has_listed_contact(const Run& run) {
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    const auto* touching = std::get_if<TouchingBody>(&run.plan().groups[g].kind);
    const bool touches_on_conics =
        touching != nullptr && !run.mechanism().contacts[touching->contact].by_boundary;
    if (touches_on_conics || std::holds_alternative<ContactTrack>(run.at.state.tracks[g])) {
      return true;
    }
  }
  return false;
}

// Whether a contact comes from infinity.
bool has_contact_far_out(const Run& run) {
  const Vector2d ground = place_of_ground(run.mechanism());
  return std::any_of(
      run.at.state.contacts.begin(), run.at.state.contacts.end(), [&](const ContactMotion& contact) {
        return contact.touches && (contact.at.p_W() - ground).norm() > kFarOut * run.plan().size;
      });
}

// Whether coupled bodies or their contacts have run off to infinity: no iteration leads across it.
bool has_coupled_far_out(const Run& run) {
  return farthest_coupled(model_of(run), run.at.state) > kCoupledFarOut * run.plan().size;
}

// How far beyond the limit the inputs are, in the sense of the motion at it; not above 0 where they are at
// the limit to within half of the tolerance of a row there.
double distance_beyond(const Run& run, const std::vector<double>& inputs) {
  double beyond = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double scale = input_scale(run, i);
    const double ahead = (run.at.lost.at[i] - run.at.lost.from[i]) / scale;
    const double near = kOnLimit / 2 * (1 + std::abs(inputs[i]) / scale);
    beyond += (inputs[i] - run.at.lost.at[i]) / scale * ahead - near * std::abs(ahead);
  }
  return beyond;
}

// Whether the inputs are at the limit, or have reversed away from it.
bool has_come_back(const Run& run, const std::vector<double>& inputs) {
  return distance_beyond(run, inputs) <= 0;
}

// Whether the inputs come from a row before a limit at infinity and still approach it.
bool approaches_infinity(const Run& run, const std::vector<double>& inputs) {
  return run.at.lost.is_beyond_row && has_come_back(run, inputs) &&
         distance_beyond(run, inputs) >= distance_beyond(run, run.work.row_before);
}

// The motion is resumed beyond a gap, in which arcs along the curves are not measured.
void hold_again(Run& run) {
  renew_overlaps(run);
  for (OverlapWatch& watch : run.at.watches) {
    watch.interrupted = true;
  }
  run.at.on_branch = true;
}

// Continues the motion from where it was lost, after the drivers have reversed away from the limit.
bool come_back(Run& run, const std::vector<double>& inputs) {
  const Path path = part_of_path(run, run.at.lost.from, inputs);
  hold_again(run);
  if (!has_come_back(run, run.work.row_before)) {
    report_limit(run, path, run.at.lost.event);
  }
  const double to_limit = distance_between(run, run.at.lost.from, run.at.lost.at);
  return follow(run, path, std::max(to_limit, kShortestFirstStep) * unit_of(run, path));
}

// Whether the drivers are at a time, on a curve, on that side of the limit from which they came: before the
// straight line, or plane, through the limit at right angles to their motion there.
bool are_on_near_side(const Run& run, double time) {
  std::vector<DriverMotion> limit, here;
  set_unit_motions(run, run.at.lost.at, limit);
  set_unit_motions(run, {time}, here);
  double beyond = 0;
  for (std::size_t i = 0; i < limit.size(); ++i) {
    const double scale = driver_scale(run, i);
    beyond += (here[i].position - limit[i].position) / scale * limit[i].velocity / scale;
  }
  return beyond <= 0;
}

// Goes straight from where the motion was lost to the drivers of a time on the curve; places the branch in
// run.work.trial.
bool come_straight_to(Run& run, double time) {
  Run back = run;
  back.at.targets = {time};
  leave_curve(back);
  back.at.inputs = back.at.lost.from;
  back.work.row_before = back.at.lost.from;
  hold_again(back);
  back.at.beside.reset();
  if (!follow(back, part_of_path(back, back.at.inputs, back.at.targets)) || back.at.beside) {
    return false;
  }
  run.work.trial = back.at.state;
  return true;
}

// Whether a group is so near to its limit that its position is known to only half the digits. At a degenerate
// limit (a pressure angle of 90 degrees where the follower is at rest) rounding makes and removes thousands
// of such positions.
bool is_beside_limit(const State& state) {
  return std::any_of(state.groups.begin(), state.groups.end(), [](const GroupState& group) {
    return std::abs(group.sine) <= kTooNearLimit * group.lever;
  });
}

std::vector<double> inputs_of(const Run& run, const RunEvent& event) {
  if (run.at.curve) {
    return {std::lerp(run.work.row_before[0], run.at.targets[0], event.share)};
  }
  std::vector<double> inputs{event.driver};
  inputs.insert(inputs.end(), event.further_drivers.begin(), event.further_drivers.end());
  return inputs;
}

// Whether an event of the present path is the limit at which the motion was lost.
bool is_where_lost(const Run& run, const RunEvent& event) {
  const std::vector<double> inputs = inputs_of(run, event);
  bool same = is_same_item(event, run.at.lost.event);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double near = kSameLimit * (input_scale(run, i) + std::abs(inputs[i]));
    same = same && std::abs(inputs[i] - run.at.lost.at[i]) <= near;
  }
  return same;
}

// The branch at these inputs, placed in run.work.trial, followed back as far as `to`.
Run followed_to(Run& run, const std::vector<double>& at, const std::vector<double>& to) {
  std::vector<RunEvent> events = std::exchange(run.events, {});  // not to copy as many as there may be
  Run back = run;
  run.events = std::move(events);
  std::swap(back.at.state, back.work.trial);
  back.at.on_branch = true;
  back.at.beside.reset();
  back.at.inputs = at;
  renew_overlaps(back);
  (void)follow(back, part_of_path(run, at, to));
  return back;
}

// The same, to where this stretch of it begins: at a limit, or where the bodies come apart that overlap
// before.
Run followed_back(Run& run, const std::vector<double>& at, const std::vector<double>& from) {
  Run back = followed_to(run, at, from);
  const auto overlap = std::find_if(back.events.begin(), back.events.end(),
                                    [](const RunEvent& event) { return event.type == EventType::kOverlap; });
  if (overlap == back.events.end()) {
    return back;
  }
  RunEvent event = *overlap;
  event.type = EventType::kLimitPosition;
  event.cause = "before this position of the driver the two bodies overlap elsewhere on their boundaries";
  const std::vector<double> apart = inputs_of(run, event);
  back = followed_to(run, at, apart);
  if (back.at.on_branch) {
    back.at.on_branch = false;
    back.at.lost.from = apart;
    back.at.lost.at = apart;
    back.at.lost.event = event;
    back.events.push_back(std::move(event));
  }
  return back;
}

// Whether the branch followed back is another one: the motion cannot have come to it if there was no limit on
// the way back. That can happen where a contact is found again from a list of all, or with coupled bodies.
bool is_another_branch(const Run& back) {
  return back.at.on_branch && (back.plan().couples || has_listed_contact(back)) && !has_contact_far_out(back);
}

enum class Taken {
  kNot,      // there is no stretch that the motion could be on
  kNotYet,   // the stretch begins beyond the row
  kArrived,  // the motion goes on up to the row
  kLost,     // the motion is lost again before the row
};

// Rounds the positions from which a long search goes on: it would magnify the rounding errors in which runs
// with other rows differ.
void round_to_grid(const Run& run, State& state) {
  const double size = run.plan().size;
  for (BodyMotion& motion : state.bodies) {
    motion.theta = on_search_grid(motion.theta, 1);
    const Vector2d& p_W = motion.X_WB.p_WB;
    motion.X_WB = {Rotation<double>::from_angle(motion.theta),
                   {on_search_grid(p_W.x(), size), on_search_grid(p_W.y(), size)}};
  }
  for (ContactMotion& motion : state.contacts) {
    motion.phi = on_search_grid(motion.phi, 1);
    motion.at.n_W = unit_vector(on_search_grid(angle_of(motion.at.n_W), 1));
    for (BoundaryPlace& place : motion.place) {
      place.t = on_search_grid(place.t, 1);
    }
  }
  for (const Group& group : run.plan().groups) {
    if (traits_of(group).coupled) {
      (void)place_contacts(model_of(run), group, state);
    }
  }
}

// Positions on a line at which a lost branch is looked for: the limit, a few close to it, and then every
// kLostBranchProbe. They do not depend on the rows, so neither does what is found at them.
class Probes {
public:
  /// \param rounded  from a position beyond the limit on the grid of the search
  Probes(const LineAhead& line, bool rounded) : step_(line.sense() * kLostBranchProbe * line.scale()) {
    limit_ = line.x_of(line.begin());
    if (rounded) {
      const double grid = line.sense() * kSearchGrid * line.scale();
      limit_ = std::ceil(limit_ / grid) * grid;
    }
  }

  [[nodiscard]] double at(double k) const {
    return k > kFirstProbes ? limit_ + (k - kFirstProbes) * step_
           : k > 0          ? limit_ + std::pow(4, k - kFirstProbes) / 4 * step_
                            : limit_;
  }
  /// Index of the first probe that is not before x; at least 1.
  [[nodiscard]] double first_from(double x) const {
    double k = std::max(1.0, std::ceil((x - limit_) / step_) + kFirstProbes);
    while (k > 1 && (at(k - 1) - x) * step_ >= 0) {
      --k;
    }
    return k;
  }

private:
  double limit_, step_;
};

// Looks for a branch on a line and takes it up where it is found.
class StretchSearch {
public:
  /// \param inputs  of the row, at the end of the line
  StretchSearch(Run& run, const LineAhead& line, const std::vector<double>& inputs)
      : run_(run),
        line_(line),
        inputs_(inputs),
        probes_(line, run.plan().couples),
        couples_(run.plan().couples),
        to_(line.x_of(inputs)),
        searched_to_(line.x_of(line.begin())) {}

  /// Resumes at the beginning of the stretch that contains x, if that is before the row, and follows the
  /// stretch to the row.
  /// `poles` limits how many other stretches may be looked for before it.
  Taken take_up(double x, int poles = kMostPoles);

  /// The same with the first stretch found beyond `from`, then with that of the row itself.
  Taken take_up_first(double from);

private:
  [[nodiscard]] bool is_before(double a, double b) const { return (b - a) * line_.sense() > 0; }
  [[nodiscard]] std::vector<double> inputs_at(double x) const { return x == to_ ? inputs_ : line_.at(x); }
  [[nodiscard]] double x_of(const std::vector<double>& inputs) const { return line_.x_of(inputs); }

  [[nodiscard]] double first_probe(double from) const;
  [[nodiscard]] bool return_at(double k) const;
  bool place(double x);
  Outlook outlook(double k);
  std::optional<double> placed_up_to(double k, const std::optional<Outlook>& before, const Outlook& here);
  Taken take_up_row();
  bool come_to_beginning(double x);
  std::optional<Run> followed_back_from(double x);
  Taken take_up_across(double pole, double begin, int poles);
  Taken follow_stretch(const Run& back, double begin, const State& found, double x);
  void go_on_from(const Run& back, const State& state, double from);
  bool follow_from(double from, double first_step);

  Run& run_;
  const LineAhead& line_;
  const std::vector<double>& inputs_;
  Probes probes_;
  bool couples_;                                    // whether bodies are coupled
  double to_;                                       // x of the row
  double searched_to_;                              // no stretch of the branch begins before this x
  std::optional<double> begins_ahead_ = {};         // x beyond the row where one begins
  std::vector<RunEvent> events_at_beginning_ = {};  // the events where it begins
  std::optional<double> returned_at_ = {};          // x where drivers are back from beyond the limit
};

// Continues from a state of the stretch, at x = `from`. Adds the event of the limit at which the stretch
// begins.
void StretchSearch::go_on_from(const Run& back, const State& state, double from) {
  const State lost = std::exchange(run_.at.state, state);
  hold_again(run_);
  run_.at.beside.reset();
  run_.at.inputs = inputs_at(from);
  const Path path = part_of_path(run_, line_.begin(), inputs_);
  for (const RunEvent& event : back.events) {
    // At the end of a curve the motion may have gone on over the edge.
    const bool is_last = &event == &back.events.back();
    const bool is_limit =
        event.type == EventType::kLimitPosition || (event.type == EventType::kEnd && is_last);
    if (is_limit && !is_where_lost(run_, event)) {
      report_limit(run_, path, event);
    }
  }
  if (!back.at.on_branch) {
    take_short_way(run_, lost, back.at.state);
  }
}

// For a row next to the limit where a stretch begins. Placed directly, a position there has half its digits
// only. It is therefore taken from the limit as solved for when the branch is followed back from within the
// stretch; run.at.state then remains within.
bool StretchSearch::come_to_beginning(double x) {
  const double within = x + line_.sense() * kInsideLimit * line_.scale();
  if (!place_anew(run_, line_.at(within)).complete || is_beside_limit(run_.work.trial)) {
    return false;
  }
  Run inside = followed_back(run_, line_.at(within), inputs_at(x));
  if (!inside.at.on_branch || (!couples_ && (!inside.at.beside || is_another_branch(inside)))) {
    return false;
  }
  if (begins_ahead_) {
    inside.events = events_at_beginning_;
  }
  const State lost = run_.at.state;
  const State& begin = inside.at.shown();
  go_on_from(inside, begin, x);
  run_.at.inputs = inside.at.inputs;
  take_short_way(run_, lost, begin);
  if (inside.at.beside) {
    run_.at.beside = std::exchange(run_.at.state, inside.at.state);
    take_short_way(run_, lost, begin);
  }
  return true;
}

// \param first_step  in x
bool StretchSearch::follow_from(double from, double first_step) {
  const Path path = part_of_path(run_, inputs_at(from), inputs_);
  const double per_x = path.is_single() ? 1 : path.length / std::abs(to_ - from);
  return follow(run_, path, from == to_ ? first_step : first_step * per_x);
}

// At a pole one stretch ends where another begins, at `begin`. Resumes on the former, from as near to the
// pole as it can be followed from.
Taken StretchSearch::take_up_across(double pole, double begin, int poles) {
  for (double x = 2 * pole - begin; is_before(searched_to_, x) && is_before(x, begin);
       x = pole + 4 * (x - pole)) {
    if (std::abs(x - pole) > kAcrossPole * line_.scale() || !place_anew(run_, line_.at(x)).complete) {
      return Taken::kNot;
    }
    if (!is_beside_limit(run_.work.trial)) {
      return take_up(x, poles);
    }
  }
  return Taken::kNot;
}

// The branch placed at x, followed back to where this stretch of it begins; none if it is another branch. One
// that has been found to be another is followed no farther than to there: else every probe along it would
// follow all of it.
std::optional<Run> StretchSearch::followed_back_from(double x) {
  std::optional<OtherBranch> unused;
  std::optional<OtherBranch>& other = line_.is_from_limit() ? run_.at.lost.other : unused;
  const auto is_other = [&](const Run& back) {
    return is_another_branch(back) &&
           have_same_poses(back.at.state, other->state, run_.plan().size, kSameRunPosition);
  };
  if (other && is_before(other->x, x) && is_other(followed_back(run_, inputs_at(x), inputs_at(other->x)))) {
    other = {x, run_.work.trial};
    return std::nullopt;
  }
  // Drivers that return may come to a stretch that the search has passed over.
  const double from = returned_at_ == x ? x_of(line_.begin()) : searched_to_;
  Run back = followed_back(run_, inputs_at(x), inputs_at(from));
  if (is_another_branch(back)) {
    other = {x, run_.work.trial};
    return std::nullopt;
  }
  return back;
}

// Whether the drivers of a curve come back from beyond the limit between the probe before k and probe k.
bool StretchSearch::return_at(double k) const {
  return run_.at.curve && are_on_near_side(run_, probes_.at(k)) && !are_on_near_side(run_, probes_.at(k - 1));
}

// Places the branch at x in run.work.trial.
bool StretchSearch::place(double x) {
  return place_anew(run_, inputs_at(x)).complete || (returned_at_ == x && come_straight_to(run_, x));
}

Taken StretchSearch::take_up(double x, int poles) {
  if (!place(x)) {
    return Taken::kNot;
  }
  if (is_beside_limit(run_.work.trial)) {
    if (x != to_) {
      return Taken::kNot;
    }
    if (come_to_beginning(x)) {
      return Taken::kArrived;
    }
    (void)place(x);
  }
  const std::optional<Run> back = followed_back_from(x);
  if (!back) {
    return Taken::kNot;
  }
  const State found = run_.work.trial;
  const double begin = x_of(back->at.on_branch ? back->at.inputs : back->at.lost.from);
  if (!back->at.on_branch && poles > 0) {
    const Taken taken = take_up_across(x_of(back->at.lost.at), begin, poles - 1);
    if (taken == Taken::kArrived || taken == Taken::kLost) {
      return taken;
    }
  }
  if (is_before(to_, begin)) {
    begins_ahead_ = begin;
    events_at_beginning_ = back->events;
    return Taken::kNotYet;
  }
  return follow_stretch(*back, begin, found, x);
}

// Follows a stretch from its beginning to the row; if that fails at once, as next to a pole, from x, where
// the stretch was found.
Taken StretchSearch::follow_stretch(const Run& back, double begin, const State& found, double x) {
  const RunPosition before = run_.at;
  const std::size_t events = run_.events.size();
  go_on_from(back, back.at.state, begin);
  const double to_limit = back.at.on_branch ? kInf
                                            : std::max(std::abs(x_of(back.at.lost.at) - begin),
                                                       kShortestFirstStep * line_.scale());
  if (follow_from(begin, to_limit)) {
    return Taken::kArrived;
  }
  const double lost = x_of(run_.at.lost.at);
  if (!is_before(lost, x) || std::abs(lost - begin) > kAtBeginning * line_.scale()) {
    return Taken::kLost;
  }
  run_.at = before;
  run_.events.resize(events);
  go_on_from(back, found, x);
  return follow_from(x, kInf) ? Taken::kArrived : Taken::kLost;
}

// Index of the first probe to look at.
double StretchSearch::first_probe(double from) const {
  const double first = probes_.first_from(from);
  const std::optional<double>& looked_to = run_.at.lost.looked_to;
  return looked_to && line_.is_from_limit() ? std::max(first, probes_.first_from(*looked_to) + 1) : first;
}

Outlook StretchSearch::outlook(double k) {
  return outlook_at(run_, line_, probes_.at(k), probes_.at(k + 1) - probes_.at(k));
}

// Where the branch can be placed, at probe k or between the one before it and it.
std::optional<double> StretchSearch::placed_up_to(double k, const std::optional<Outlook>& before,
                                                  const Outlook& here) {
  if (here.placing.complete) {
    return here.x;
  }
  // For contacts it is unknown how much is lacking (room is not finite): next to a contact's limit it takes
  // long to find out that it cannot be placed.
  if (!std::isfinite(here.placing.room)) {
    return std::nullopt;
  }
  return placed_between(run_, line_, before ? *before : outlook(k - 1), here);
}

Taken StretchSearch::take_up_first(double from) {
  const double first = first_probe(from);
  const double last = std::min(probes_.first_from(to_), first + kMostProbes);
  if (couples_ && first > 1) {
    searched_to_ = probes_.at(first - 1);
  }
  std::optional<Nearest> nearest_in_vain = run_.at.lost.nearest;
  bool in_vain = line_.is_from_limit();
  std::optional<Outlook> before;
  for (double k = first; k <= last && !is_stopped(run_); ++k) {
    const Outlook here = outlook(k);
    // A stretch of coupled bodies that begins at this position itself is followed back from the next one.
    const bool at_begin = couples_ && here.placing.complete && is_beside_limit(run_.work.trial);
    if (couples_) {
      run_.at.lost.nearest = Nearest{run_.work.trial, run_.work.continuations};
      round_to_grid(run_, run_.at.lost.nearest->state);
    }
    std::optional<double> x = placed_up_to(k, before, here);
    if (!x && return_at(k)) {
      returned_at_ = here.x;
      x = here.x;
    }
    const Taken taken = x ? take_up(*x) : Taken::kNot;
    if (taken == Taken::kArrived || taken == Taken::kLost) {
      return taken;
    }
    in_vain = in_vain && taken == Taken::kNot;
    if (in_vain && !at_begin) {
      run_.at.lost.looked_to = here.x;
      nearest_in_vain = run_.at.lost.nearest;
    }
    if (couples_ && !at_begin) {
      searched_to_ = here.x;
    }
    before = here;
  }
  if (is_stopped(run_)) {
    return Taken::kNot;
  }
  const Taken taken = take_up_row();
  if (couples_ && line_.is_from_limit()) {
    run_.at.lost.nearest = std::move(nearest_in_vain);
  }
  return taken;
}

// Coupled bodies are followed through the probes, whatever the rows are; a row may be where the stretch
// begins.
Taken StretchSearch::take_up_row() {
  if (!couples_) {
    return take_up(to_);
  }
  const bool at_beginning = begins_ahead_ && std::abs(*begins_ahead_ - to_) <= kAtBeginning * line_.scale();
  return at_beginning && come_to_beginning(to_) ? Taken::kArrived : Taken::kNot;
}

// Has coupled bodies looked for from the limit at which they were lost: how near to it the steps have come
// depends on the rows, and with it where their conditions could be led to.
void look_from_limit(Run& run) {
  const Path path = part_of_path(run, run.at.lost.from, run.at.lost.at);
  begin_path(run, path);
  const std::vector<Group>& groups = run.plan().groups;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!traits_of(groups[g]).coupled) {
      continue;
    }
    Reduction reduction(run, path, g, 0);
    const auto limit = reduction.limit_ahead(path.length);
    if (limit && std::abs(limit->ahead - path.length) <= kSameLimit * unit_of(run, path)) {
      reduction.place_limit(*limit, path.length);
      round_to_grid(run, run.work.trial);
      run.at.lost.nearest =
          Nearest{run.work.trial, std::vector<std::optional<LeastViolation>>(groups.size())};
      return;
    }
  }
}

// Resumes the motion at the first possible position beyond `from`.
Taken take_up_again(Run& run, const std::vector<double>& inputs, const std::vector<double>& from) {
  if (is_stopped(run) || run.at.lost.for_good || approaches_infinity(run, inputs)) {
    return Taken::kNot;
  }
  const bool comes_back = has_come_back(run, inputs);
  if (comes_back && come_back(run, inputs)) {
    return Taken::kArrived;
  }
  // The motion may have been lost again on the way to the drivers, or at once.
  if ((comes_back && has_come_back(run, inputs)) || has_coupled_far_out(run)) {
    return Taken::kNot;
  }
  if (run.plan().couples && !run.at.lost.nearest) {
    look_from_limit(run);
  }
  const std::vector<double> behind = comes_back || has_come_back(run, from) ? run.at.lost.at : from;
  const LineAhead line(run, behind, inputs);
  return StretchSearch(run, line, inputs).take_up_first(line.x_of(behind));
}

}  // namespace

bool resume(Run& run, const std::vector<double>& inputs, const std::vector<double>& from) {
  Taken taken = take_up_again(run, inputs, from);
  while (taken == Taken::kLost) {
    taken = take_up_again(run, inputs, run.at.lost.at);
  }
  return taken == Taken::kArrived;
}

}  // namespace higherpair

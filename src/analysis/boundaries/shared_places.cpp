#include "shared_places.hpp"

#include "analysis/follow/path_events.hpp"
#include "analysis/follow/step.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/analysis/touching_places.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/outline.hpp"
#include "meetings.hpp"
#include "other_place.hpp"
#include "passings.hpp"
#include "span_ends.hpp"
#include "vertex_passage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

namespace higherpair {
namespace {

// The two bodies of a contact in a state.
struct Bodies {
  const Boundary& boundary1;
  const Boundary& boundary2;
  const Pose<double>& X_W1;
  const Pose<double>& X_W2;
  std::optional<CommonNormal> own;

  [[nodiscard]] double size() const { return boundary1.size() + boundary2.size(); }
};

Bodies bodies_in(const Run& run, std::size_t i, const State& state) {
  const Contact& contact = run.mechanism().contacts[i];
  const ContactMotion& motion = state.contacts[i];
  return {boundary_of(run.mechanism(), contact.first), boundary_of(run.mechanism(), contact.second),
          state.bodies[contact.first.body].X_WB, state.bodies[contact.second.body].X_WB,
          motion.touches ? std::optional(motion.at) : std::nullopt};
}

// Whether two smooth parts touch at a place other than the contact itself.
bool is_touch(const Bodies& bodies, const NearPlace& place, double depth) {
  return is_smooth_touch(place) && std::abs(place.at.gap()) <= depth &&
         !(bodies.own && is_place_of(*bodies.own, place, bodies.size()));
}

// Whether a place is the other end of two flat parts that lie on each other at the contact: the point halfway
// is on both boundaries.
bool is_end_of_flat(const Bodies& bodies, const NearPlace& place) {
  if (!bodies.own) {
    return false;
  }
  const Vector2d halfway_W = (bodies.own->p_W() + place.at.p_W()) / 2;
  const auto is_on = [&](const Boundary& boundary, const Pose<double>& X_WB) {
    const Vector2d p_B = X_WB.inverse_times(halfway_W);
    return (outline_of(boundary).polyline().nearest(p_B).at - p_B).norm() <= kSameMeeting * bodies.size();
  };
  return is_on(bodies.boundary1, bodies.X_W1) && is_on(bodies.boundary2, bodies.X_W2);
}

// Keeps only places that push the follower in the same sense as the contact: teeth without play touch with
// their backs as well, which take no part in the motion.
void keep_those_that_push(const Run& run, std::size_t i, const State& state, std::vector<NearPlace>& places) {
  const auto g = group_of_placing(run, static_cast<int>(i));
  if (!g || !state.contacts[i].touches) {
    return;
  }
  const TouchingBody& touching = touching_of(run, *g);
  const double own = touching_sine(model_of(run), touching, state);
  std::erase_if(places, [&](const NearPlace& place) {
    return own * gap_per_q(model_of(run), touching, state, place.at) < 0;
  });
}

std::vector<NearPlace> shared_places(const Run& run, std::size_t i, const State& state, double depth) {
  const Bodies bodies = bodies_in(run, i, state);
  auto places = near_places(bodies.boundary1, bodies.X_W1, bodies.boundary2, bodies.X_W2, 2 * depth);
  std::erase_if(places, [&](const NearPlace& place) { return !is_touch(bodies, place, depth); });
  keep_those_that_push(run, i, state, places);
  return places;
}

// The one of the places of touch in another state that is the same place; else null.
const NearPlace* same_among(const std::vector<NearPlace>& places, const Bodies& there,
                            const NearPlace& place) {
  const auto moved = moved_place(there.boundary1, there.X_W1, there.boundary2, there.X_W2, place);
  const auto found = std::find_if(places.begin(), places.end(), [&](const NearPlace& other) {
    return moved && is_place_of(other.at, *moved, there.size());
  });
  return found == places.end() ? nullptr : &*found;
}

// Those ends of the two spans of a place at which the boundary does not continue smoothly.
std::vector<Passing> ends_around(const Run& run, const Contact& contact, const NearPlace& place) {
  std::vector<Passing> ends;
  const auto is_seam = [](SpanJoint joint) { return joint != SpanJoint::kSmooth; };
  append_passings(run, contact.first, contact.second, place.place1.span, is_seam, ends);
  append_passings(run, contact.second, contact.first, place.place2.span, is_seam, ends);
  return ends;
}

// A place that begins or ends within a step.
struct Change {
  double x = 0;  // beyond run.at.state
  bool begins = false;
};

// Where one curve passes an end of the other while the bodies touch there. Rounding may have put a row that
// is at the end itself on either side of it.
std::optional<double> touching_passing(Run& run, const Path& path, double s, double h, const Passing& passing,
                                       const BoundaryPlace& near) {
  const auto passing_in = [&](const State& state) { return passing_at(run, passing, state, near); };
  const auto is_in = [&](const State& state) {
    const auto there = passing_in(state);
    return there && std::abs(there->beyond) <= kJustLeft * boundary_of(run.mechanism(), passing.own).size();
  };
  const auto touches = [&](const State& state) {
    const auto there = passing_in(state);
    return there && std::abs(there->beside) <= kOverlapDepth * run.plan().size;
  };
  if (const auto x = passing_within(run, path, s, h, passing, near)) {
    return with_trial<bool>(run, path, s, *x, touches).value_or(false) ? x : std::nullopt;
  }
  if (is_in(run.at.state)) {
    return touches(run.at.state) ? std::optional(0.0) : std::nullopt;
  }
  return is_in(run.work.trial) && touches(run.work.trial) ? std::optional(h) : std::nullopt;
}

// Where the contact, coming into the two spans of a place of run.work.trial, passes the last of their ends,
// or, leaving those of a place of run.at.state, the first. None where the bodies do not touch there: the gap
// then opens or closes at another position, where the contact itself changes.
std::optional<Change> change_of(Run& run, const Path& path, std::size_t i, double s, double h,
                                const NearPlace& place, bool begins) {
  const Contact& contact = run.mechanism().contacts[i];
  std::optional<Change> change;
  for (const Passing& passing : ends_around(run, contact, place)) {
    const bool own_is_first = passing.own == contact.first;
    const auto x = touching_passing(run, path, s, h, passing, own_is_first ? place.place2 : place.place1);
    if (x && (!change || (std::abs(*x) > std::abs(change->x)) == begins)) {
      change = Change{*x, begins};
    }
  }
  return change;
}

// Whether a place is at an end of its spans, which it may reach just at the end of a step.
bool is_at_end_of_spans(const Bodies& bodies, const NearPlace& place) {
  return is_at_an_end(bodies.boundary1, place.place1, kJustLeft) ||
         is_at_an_end(bodies.boundary2, place.place2, kJustLeft);
}

// The body that a group's contact places, where that contact may go on at another place of its curves; else
// null.
const TouchingBody* free_to_go_on(const Run& run, std::size_t g) {
  const auto* touching = std::get_if<TouchingBody>(&run.plan().groups[g].kind);
  if (touching == nullptr || run.at.state.groups[g].open) {
    return nullptr;
  }
  const Contact& contact = run.mechanism().contacts[touching->contact];
  return contact.by_boundary && contact.jump && !contact.both_sides ? touching : nullptr;
}

}  // namespace

void note_shared_places(Run& run, const Path& path, SharedTouch touch, double s, double h) {
  const std::size_t contact = touch.contact;
  keep_those_that_push(run, contact, run.at.state, touch.before);
  keep_those_that_push(run, contact, run.work.trial, touch.after);
  const Bodies before = bodies_in(run, contact, run.at.state);
  const State after_state = run.work.trial;
  const Bodies after = bodies_in(run, contact, after_state);
  std::erase_if(touch.before, [&](const NearPlace& place) { return is_end_of_flat(before, place); });
  std::erase_if(touch.after, [&](const NearPlace& place) { return is_end_of_flat(after, place); });
  const double just_left = kJustLeft * unit_of(run, path);
  std::vector<Change> changes;
  std::size_t places = 1;  // before the first change
  for (const NearPlace& place : touch.before) {
    const NearPlace* later = same_among(touch.after, after, place);
    if (later != nullptr && !is_at_end_of_spans(after, *later)) {
      ++places;
      continue;
    }
    const auto change = change_of(run, path, contact, s, h, place, false);
    const bool leaves = change && (later == nullptr || std::abs(h - change->x) <= just_left);
    if (leaves ? std::abs(change->x) > just_left : later != nullptr) {
      ++places;
      if (leaves) {
        changes.push_back(*change);
      }
    }
  }
  for (const NearPlace& place : touch.after) {
    if (same_among(touch.before, before, place) == nullptr) {
      if (const auto change = change_of(run, path, contact, s, h, place, true)) {
        changes.push_back(*change);
      }
    }
  }
  std::sort(changes.begin(), changes.end(),
            [](const Change& a, const Change& b) { return std::abs(a.x) < std::abs(b.x); });
  for (const Change& change : changes) {
    change.begins ? ++places : --places;
    report_contact(run, change.begins ? EventType::kEngage : EventType::kRelease, path, s + change.x, contact,
                   change.begins
                       ? fmt::format("the two bodies begin to touch at a further place, now at {}", places)
                       : fmt::format("the two bodies part at one of several places, {} left", places));
  }
}

void note_shared_places_until(Run& run, const Path& path, SharedTouch touch, double s, double h) {
  touch.after = shared_places(run, touch.contact, run.work.trial, kOverlapDepth * run.plan().size);
  note_shared_places(run, path, touch, s, h);
}

void report_change_of_place(Run& run, const Path& path, double s, std::size_t contact) {
  RunEvent& event =
      report_contact(run, EventType::kRelease, path, s, contact,
                     "the contact goes on at another place where the two bodies touch, and they "
                     "part at the one before, without a jump of velocity");
  if (run.events.size() > 1) {
    const auto last = run.events.end() - 2;
    if (last->type == EventType::kCorner && last->contact == event.contact &&
        is_at_same_drivers(run, *last, event, kAtCorner)) {
      event.driver = last->driver;
      event.further_drivers = last->further_drivers;
      event.share = last->share;
      run.events.erase(last);
    }
  }
  run.at.watches[contact].interrupt();
}

bool yield_to_shared_place(Run& run, const Path& path, double s, std::size_t g) {
  const TouchingBody* touching = free_to_go_on(run, g);
  if (touching == nullptr || !run.at.watches[touching->contact].needed) {
    return false;
  }
  const auto i = static_cast<std::size_t>(touching->contact);
  const auto places = shared_places(run, i, run.at.state, kOverlapDepth * run.plan().size);
  // Per unit of the driver, of the follower's unit.
  const double unit = unit_of(run, path);
  const double scale = unit * unit / (touching->follower.freedom.turns ? 1 : run.plan().size);
  const auto acceleration = [&] { return scale * follower_acceleration(run.at.state, touching->follower); };
  const int mode = run.at.state.groups[g].mode;
  bool yields = false;
  double kept = acceleration();
  for (const NearPlace& place : places) {
    StateAside aside(run.at.state);
    const auto change = go_on_at(run, path, g, s, place);
    if (!change || jump_size(run, path, touching->follower, *change) > kSameRates) {
      continue;
    }
    // This times |gap per q| is the acceleration of the gap at the place if the contact stays where it is.
    const double there = acceleration();
    const double opens = mode * (kept - there);
    if (opens < -kSameAcceleration * (1 + std::max(std::abs(kept), std::abs(there)))) {
      aside.commit();
      kept = there;
      yields = true;
    }
  }
  if (yields) {
    report_change_of_place(run, path, s, i);
  }
  return yields;
}

std::size_t touching_places(const Run& run, std::size_t contact) {
  if (!run.at.state.contacts[contact].touches) {
    return 0;
  }
  return run.mechanism().contacts[contact].by_boundary
             ? 1 + shared_places(run, contact, run.at.state, kOverlapDepth * run.plan().size).size()
             : 1;
}

bool take_over(Run& run, const Path& path, double s, std::size_t g) {
  const TouchingBody* touching = free_to_go_on(run, g);
  if (touching == nullptr) {
    return false;
  }
  const auto i = static_cast<std::size_t>(touching->contact);
  const auto places = shared_places(run, i, run.at.state, kOverlapOfBoundaries * run.plan().size);
  for (const NearPlace& place : places) {
    if (const auto change = go_on_at(run, path, g, s, place)) {
      run.at.watches[i].interrupted = true;
      RunEvent& event = report_contact(
          run, EventType::kRelease, path, s, i,
          fmt::format(
              "the contact leaves the end of a curve and goes on at another place where the two bodies "
              "touch, {} left",
              places.size()));
      add_rate_jump(run, path, touching->follower, *change, event);
      return true;
    }
  }
  return false;
}

bool go_over_vertex(Run& run, const Path& path, double s, std::size_t g) {
  const TouchingBody* touching = free_to_go_on(run, g);
  if (touching == nullptr) {
    return false;
  }
  const auto i = static_cast<std::size_t>(touching->contact);
  const auto passage = vertex_passage(run, i);
  const auto before = run.at.state.contacts[i].place;
  std::optional<RateJump> change;
  // By rounding the contact may still be just before the part beyond.
  for (std::size_t k = 0; passage && !change && k < kBeyondVertex.size(); ++k) {
    const double ahead = std::copysign(kBeyondVertex[k] * unit_of(run, path), path.length);
    change = go_on_at(run, path, g, s + ahead, passage->beyond);
  }
  if (!change) {
    return false;
  }
  run.at.watches[i].interrupted = run.at.watches[i].interrupted || passage->notch;
  const std::string& body = body_of_side(run, i, passage->side);
  const auto& place = run.at.state.contacts[i].place[passage->side];
  const bool onto_edge =
      is_on_edge(run, i, passage->side, place) && !is_on_edge(run, i, passage->side, before[passage->side]);
  RunEvent& event =
      onto_edge
          ? report_contact(run, EventType::kEnd, path, s, i, onto_edge_text(run, i, passage->side))
          : report_contact(
                run, passage->notch ? EventType::kSecondContact : EventType::kCorner, path, s, i,
                fmt::format("the contact {} of {}",
                            passage->notch ? "goes on beyond a concave corner" : "goes over a corner", body));
  add_rate_jump(run, path, touching->follower, *change, event);
  return true;
}

}  // namespace higherpair

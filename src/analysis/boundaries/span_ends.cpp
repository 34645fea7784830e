#include "span_ends.hpp"

#include "analysis/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/edges.hpp"

#include <fmt/core.h>

namespace higherpair {
namespace {

// The first result of `of` for the sides of a group's contacts that touch.
template <class F>
auto first_of_sides(const Run& run, std::size_t g, const F& of)
    -> decltype(of(std::size_t{}, std::size_t{})) {
  for (const int index : run.plan().groups[g].contacts) {
    const auto i = static_cast<std::size_t>(index);
    if (!run.mechanism().contacts[i].by_boundary || !run.at.state.contacts[i].touches) {
      continue;
    }
    for (std::size_t side = 0; side < 2; ++side) {
      if (auto found = of(i, side)) {
        return found;
      }
    }
  }
  return {};
}

// What a contact has reached.
enum class Stop { kEnd, kEdge, kNotch };

std::optional<Stop> stop_at(const Run& run, std::size_t contact, std::size_t side) {
  const Boundary& boundary = boundary_at(run, contact, side);
  const BoundaryPlace& place = run.at.state.contacts[contact].place[side];
  for (const bool high : {false, true}) {
    if (!is_at_end(boundary, place, high, kAtSpanEnd)) {
      continue;
    }
    const int next = boundary.next_span(place.span, high);
    const SpanJoint joint = boundary.joint_after(high ? place.span : next);
    if (joint == SpanJoint::kNotch || (joint == SpanJoint::kEnd && !is_edge(boundary, place.span))) {
      return joint == SpanJoint::kEnd ? Stop::kEnd : Stop::kNotch;
    }
    if (joint != SpanJoint::kEnd && is_edge(boundary, next)) {
      return Stop::kEdge;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<ContactEnd> end_reached(const Run& run, std::size_t g) {
  return first_of_sides(run, g, [&](std::size_t i, std::size_t side) -> std::optional<ContactEnd> {
    const auto stop = stop_at(run, i, side);
    // Two corners, and an edge is one, have no common normal to go on with.
    const bool blunt = !boundary_at(run, i, 1 - side).is_corner(run.at.state.contacts[i].place[1 - side]);
    if (!stop || (stop == Stop::kEdge && blunt)) {
      return std::nullopt;
    }
    const std::string& body = body_of_side(run, i, side);
    return ContactEnd{
        i,
        stop == Stop::kNotch
            ? fmt::format("the contact reaches a concave corner of {} here, where it would need a second "
                          "contact to go on",
                          body)
            : fmt::format("the contact reaches the end of the curve of {} here and is lost beyond it", body)};
  });
}

bool is_at_edge(const Run& run, std::size_t g) {
  return first_of_sides(
      run, g, [&](std::size_t i, std::size_t side) { return stop_at(run, i, side) == Stop::kEdge; });
}

bool is_at_ends_of_both(const Run& run, std::size_t g) {
  const auto at_end = [&](std::size_t i, std::size_t side) {
    return is_at_an_end(boundary_at(run, i, side), run.at.state.contacts[i].place[side], kAtSpanEnd);
  };
  return first_of_sides(
      run, g, [&](std::size_t i, std::size_t side) { return at_end(i, side) && at_end(i, 1 - side); });
}

bool is_on_edge(const Run& run, std::size_t contact, std::size_t side, const BoundaryPlace& place) {
  return is_edge(boundary_at(run, contact, side), place.span);
}

std::string onto_edge_text(const Run& run, std::size_t contact, std::size_t side) {
  return fmt::format("the contact reaches the end of the curve of {} and goes on at the edge there",
                     body_of_side(run, contact, side));
}

void note_edge(Run& run, const Path& path, double s, std::size_t contact,
               const std::array<BoundaryPlace, 2>& before) {
  for (std::size_t side = 0; side < 2; ++side) {
    if (is_on_edge(run, contact, side, run.at.state.contacts[contact].place[side]) &&
        !is_on_edge(run, contact, side, before[side])) {
      report_contact(run, EventType::kEnd, path, s, contact,
                     fmt::format("the contact goes on at the edge at the end of the curve of {}",
                                 body_of_side(run, contact, side)));
    }
  }
}

std::optional<ContactEnd> slipped_off(const Run& run, std::size_t g) {
  const auto slipped = [&](bool at_end) {
    return first_of_sides(run, g, [&](std::size_t i, std::size_t side) -> std::optional<ContactEnd> {
      const Boundary& boundary = boundary_at(run, i, side);
      const BoundaryPlace& place = run.at.state.contacts[i].place[side];
      if (!is_edge(boundary, place.span) || (at_end && !is_at_an_end(boundary, place, kAtSpanEnd))) {
        return std::nullopt;
      }
      return ContactEnd{i,
                        fmt::format("the contact slips off the edge at the end of the curve of {} here and "
                                    "is lost beyond it",
                                    body_of_side(run, i, side))};
    });
  };
  auto found = slipped(true);
  return found ? found : slipped(false);
}

void set_local_curves(Run& run) {
  if (!run.local) {
    return;
  }
  for (const auto [contact, side] : BoundarySides(*run.local)) {
    const CurveRef& ref = ref_of(run.local->contacts[contact], side);
    const Boundary& boundary = boundary_of(*run.local, ref);
    const ContactMotion& motion = run.row.contacts[contact];
    const BoundaryPlace& place = motion.place[side];
    // While the contact is open nothing depends on the curve's shape.
    run.local->bodies[ref.body].curves[ref.curve].curve =
        motion.touches
            ? local_curve(boundary.at(place), boundary.is_corner(place), boundary.is_arc(place.span))
            : Curve{};
  }
}

}  // namespace higherpair

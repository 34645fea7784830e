#pragma once

#include "analysis/follow/path_events.hpp"
#include "higherpair/contact/boundary_contact.hpp"

#include <array>
#include <optional>
#include <string>

// Contacts that may part (Keep::kGap). While such a contact is open, its body stays where it is on its joint.
// It parts where it reaches the end of a curve or slips off the edge there, or where its body reaches the end
// of its guide. It closes where the bodies would overlap, or where the other curve passes an end of an open
// curve, as a pin enters a slot. A pin that comes to the middle line of a slot elsewhere strikes its wall.

namespace higherpair {

/// Whether a contact that may part is open.
[[nodiscard]] bool has_open_contact(const State& state);

/// Where a contact closes.
struct Engagement {
  std::size_t group = 0;
  double x = 0;                        ///< distance beyond run.at.state on the path
  std::array<BoundaryPlace, 2> place;  ///< on the contact's first and second curve
  /// At the end of a curve that has no edge there, or through a wall of both_sides: the contact cannot hold.
  bool strikes = false;
};

/// The first contact that closes between run.at.state, which is at s, and run.work.trial, h beyond it. Leaves
/// run.work.trial unchanged.
[[nodiscard]] std::optional<Engagement> engagement_within(Run& run, const Path& path, double s, double h);

/// Moves run.at.state to where a contact closes, and closes it there. Returns the length of path that this
/// takes, or nothing where the curves do not meet. A contact that cannot hold stays open, and its bodies are
/// marked as overlapping. Adds an event.
[[nodiscard]] std::optional<double> engage(Run& run, const Path& path, double s, const Engagement& at);

/// Why a contact may part.
struct Parting {
  std::string reason;
  bool may_jam = false;  ///< the bodies part only if the gap then opens
};

/// Why a contact of group g that may part does so in run.at.state, where its motion cannot go on; none if it
/// is not such a contact, or at no end.
[[nodiscard]] std::optional<Parting> why_parting(const Run& run, std::size_t g);

/// Opens the contact of group g in run.at.state, which is at s on the path, and adds an event. Returns false
/// and changes nothing if the other body would push on.
/// \param has_rates  whether the rates of run.at.state are bounded
[[nodiscard]] bool release(Run& run, const Path& path, double s, std::size_t g, const Parting& parting,
                           bool has_rates);

/// Whether the contact of a touching body starts open: in its pose, at the coordinate `posed`, the body
/// neither touches nor overlaps. Between two walls only if no contact is possible.
/// \param nearest  coordinate of the nearest contact; none if there is no contact
/// \param guide  coordinates between the ends of the body's joint: beyond them it cannot touch
[[nodiscard]] bool starts_open(const BoundaryPair& pair, double u, double posed,
                               std::optional<double> nearest, const Bounds& guide, const Contact& contact,
                               double size);

}  // namespace higherpair

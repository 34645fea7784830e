#pragma once

#include "higherpair/contact/boundary_contact.hpp"
#include "straight_path.hpp"

#include <array>
#include <optional>
#include <string>

// Contacts that may part (Keep::kGap). While one is open, its body stays where it is on its joint. It parts
// where it comes to the end of a curve or slips off the edge there, or its body comes to the end of its
// guide; it closes where the bodies would get into each other, or the other curve passes an end of an open
// one, as a pin enters a slot.

namespace higherpair {

/// Whether a contact that may part is open.
[[nodiscard]] bool has_open_contact(const State& state);

/// Where a contact closes.
struct Engagement {
  std::size_t group = 0;
  double x = 0;                        ///< beyond run.at.state on the path
  std::array<BoundaryPlace, 2> place;  ///< on the contact's first and second curve
  bool strikes = false;  ///< at the end of a curve that is no edge there, so that it cannot hold
};

/// The first contact that closes between run.at.state, which is at s, and run.work.trial, h beyond it.
/// run.work.trial is left as it is.
[[nodiscard]] std::optional<Engagement> engagement_within(Run& run, const Path& path, double s, double h);

/// Moves run.at.state to where a contact closes, and closes it there; the way that this takes, or nothing
/// where the curves do not meet. Where it cannot hold it stays open, and the bodies are marked as in each
/// other. Adds an event.
[[nodiscard]] std::optional<double> engage(Run& run, const Path& path, double s, const Engagement& at);

/// Why a contact of group g that may part does so in run.at.state, where its motion cannot go on; none if it
/// is no such contact, or at no end.
[[nodiscard]] std::optional<std::string> why_parting(const Run& run, std::size_t g);

/// Opens the contact of group g in run.at.state, which is at s. Adds an event.
void release(Run& run, const Path& path, double s, std::size_t g, const std::string& reason);

/// Whether the contact of a touching body starts open: in its pose, at the coordinate `posed`, it does not
/// touch, nor overlap. Between two walls only where no contact is possible.
/// \param nearest  coordinate of the nearest contact; none: there is none
[[nodiscard]] bool starts_open(const BoundaryPair& pair, double u, double posed,
                               std::optional<double> nearest, const Contact& contact, double size);

}  // namespace higherpair

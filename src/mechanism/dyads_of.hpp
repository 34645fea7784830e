#pragma once

#include "higherpair/mechanism/joint_sides.hpp"

#include <optional>
#include <span>

// Builds the closed-form groups of a plan from the joints of their bodies.

namespace higherpair {

/// The three joints of a dyad of bodies a and b: the one between them, and those to known bodies.
struct OuterJoints {
  int inner = 0;
  int on_a = 0;
  int on_b = 0;
};

/// None if the joints are not one of each.
/// \param joints  indices of Mechanism::joints
[[nodiscard]] std::optional<OuterJoints> sort_joints(const Mechanism& mechanism, std::span<const int> joints,
                                                     int a, int b);

/// A body on a pin and a slot; the slot is on the known body, or on the body itself. None if the point in the
/// slot is the pin.
[[nodiscard]] std::optional<GroupKind> pin_and_slot(const Mechanism& mechanism, const Joint& pin,
                                                    const Joint& slot, int body);
/// A body on a slide and a slot (a yoke); the slot is on the known body, or on the body itself.
[[nodiscard]] GroupKind slide_and_slot(const Mechanism& mechanism, const Joint& slide, const Joint& slot,
                                       int body);

/// Three pins. None if a link has no length.
[[nodiscard]] std::optional<GroupKind> rrr_dyad_of(const Mechanism& mechanism, const OuterJoints& joints,
                                                   int a, int b);
/// a is pinned to a known body, b slides on one, and a pin joins a and b. None if a has no length.
[[nodiscard]] std::optional<GroupKind> rrp_dyad_of(const Mechanism& mechanism, const OuterJoints& joints,
                                                   int a, int b);
/// Both bodies are pinned to known ones and slide on each other.
[[nodiscard]] GroupKind rpr_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b);
/// Both bodies slide on known ones and a pin joins them.
[[nodiscard]] GroupKind prp_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b);
/// a is pinned at A and slides on b, which slides on a known body.
[[nodiscard]] GroupKind rpp_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b);

}  // namespace higherpair

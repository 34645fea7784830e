#pragma once

#include "higherpair/mechanism/plan.hpp"
#include "higherpair/mechanism/tolerances.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

namespace higherpair {

/// Properties of a kind of group that the solver needs, apart from its solution.
struct GroupTraits {
  bool two_modes = false;   ///< its closed form has two assembly modes, σ = ±1
  bool can_cross = false;   ///< its branches are distinguished by the sign of a sine, and can cross
  bool one_branch = false;  ///< it has no other branch that a step could jump to
  bool direct = false;      ///< placed in closed form by the groups before it, with no search or start
  bool long_sine = false;   ///< its sine is a length [m]
  bool finds_mode = false;  ///< it has one assembly: placing it sets its mode, to the sign of its sine
  bool coupled = false;     ///< solved by Newton's method, which may converge to any branch
  double sine_noise = 0;    ///< rounding of an interpolated sine, relative to its lever
  /// Why it cannot go on beyond a limit position.
  std::string_view limit =
      "the bodies cannot be put together on this branch beyond this position of the driver";
};

namespace group_traits {

template <class Kind>
inline constexpr GroupTraits kOf = Kind::has_no_traits;  // does not compile
template <>
inline constexpr GroupTraits kOf<DrivenBody>{.one_branch = true, .direct = true};
template <>
inline constexpr GroupTraits kOf<RrrDyad>{
    .two_modes = true,
    .can_cross = true,
    .direct = true,
    .sine_noise = kDyadNoise,
    .limit = "the links are in line here: beyond this position of the driver they cannot reach each other"};
template <>
inline constexpr GroupTraits kOf<RrpDyad>{.two_modes = true,
                                          .can_cross = true,
                                          .direct = true,
                                          .sine_noise = kDyadNoise,
                                          .limit =
                                              "the link is perpendicular to its slide here: beyond this "
                                              "position of the driver it cannot reach it"};
template <>
inline constexpr GroupTraits kOf<RprDyad>{.two_modes = true,
                                          .can_cross = true,
                                          .direct = true,
                                          .long_sine = true,
                                          .sine_noise = kDyadNoise,
                                          .limit =
                                              "the pins are only as far apart as the slide's offset "
                                              "here: beyond this position of the driver the slide "
                                              "line cannot pass through both"};
template <>
inline constexpr GroupTraits kOf<SlideDyad>{
    .can_cross = true,
    .direct = true,
    .finds_mode = true,
    .sine_noise = kDyadNoise,
    .limit = "the two slides are parallel here: the point where they meet runs off to infinity"};
template <>
inline constexpr GroupTraits kOf<TrackedPair>{.can_cross = true, .sine_noise = kTouchNoise};
template <>
inline constexpr GroupTraits kOf<TouchingBody>{.can_cross = true, .sine_noise = kTouchNoise};
template <>
inline constexpr GroupTraits kOf<IdleBody>{.one_branch = true, .direct = true};
template <>
inline constexpr GroupTraits kOf<GearedBody>{.one_branch = true};
template <>
inline constexpr GroupTraits kOf<CoupledBodies>{
    .can_cross = true, .finds_mode = true, .coupled = true, .sine_noise = kCoupledNoise};

inline constexpr auto kTable = []<std::size_t... I>(std::index_sequence<I...>) {
  return std::array<GroupTraits, sizeof...(I)>{kOf<std::variant_alternative_t<I, GroupKind>>...};
}
(std::make_index_sequence<std::variant_size_v<GroupKind>>{});

}  // namespace group_traits

/// The traits of a group, by its kind.
[[nodiscard]] inline const GroupTraits& traits_of(const Group& group) {
  return group_traits::kTable[group.kind.index()];
}

/// Why a group cannot go on beyond a limit position.
[[nodiscard]] inline std::string_view limit_cause(const Group& group) {
  return group.contacts.empty()
             ? traits_of(group).limit
             : "the two bodies cannot be kept in contact on this branch beyond this position of the driver";
}

/// The contact that places a body of the group by itself, and that body; none for other kinds of groups.
struct PlacingContact {
  int contact = 0;
  const CarriedBody* follower = nullptr;
};
[[nodiscard]] inline std::optional<PlacingContact> placing_contact(const Group& group) {
  if (const auto* tracked = std::get_if<TrackedPair>(&group.kind)) {
    return PlacingContact{tracked->contact, &tracked->follower};
  }
  const auto* touching = std::get_if<TouchingBody>(&group.kind);
  return touching == nullptr ? std::nullopt
                             : std::optional(PlacingContact{touching->contact, &touching->follower});
}

/// The joint on which a contact moves a body by itself; none where more conditions place the body.
[[nodiscard]] inline std::optional<int> moved_joint(const Plan& plan, int contact) {
  for (const Group& group : plan.groups) {
    const auto placing = placing_contact(group);
    if (placing && placing->contact == contact) return group.joints.front();
  }
  return std::nullopt;
}

}  // namespace higherpair

#include "higherpair/drawing/picture.hpp"

#include <algorithm>

namespace higherpair {
namespace {

constexpr std::array<std::string_view, kRoleCount> kNames{
    "link",    "body",    "gear",   "spring", "ground",   "joint",        "curvature", "tangent", "normal",
    "linkage", "contact", "center", "trace",  "velocity", "acceleration", "force",     "driver",  "label"};

}  // namespace

std::string_view name_of(Role role) {
  return kNames[static_cast<std::size_t>(role)];
}

std::optional<Role> role_of(std::string_view name) {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  return found == kNames.end() ? std::nullopt : std::optional(static_cast<Role>(found - kNames.begin()));
}

}  // namespace higherpair

#include "higherpair/analysis/status.hpp"

#include <array>
#include <cstddef>

namespace higherpair {

std::string_view name_of(RowStatus status) {
  static constexpr std::array<std::string_view, 6> kNames = {"ok",      "not_assemblable", "singular",
                                                             "overlap", "not_converged",   "contact_open"};
  static_assert(kNames.size() == static_cast<std::size_t>(RowStatus::kContactOpen) + 1);
  return kNames[static_cast<std::size_t>(status)];
}

std::string_view name_of(EventType type) {
  static constexpr std::array<std::string_view, 13> kNames = {
      "limit_position", "dead_point", "stroke_end", "conforming", "second_contact", "overlap", "contact_open",
      "curvature_jump", "corner",     "end",        "engage",     "release",        "law_jump"};
  static_assert(kNames.size() == static_cast<std::size_t>(EventType::kLawJump) + 1);
  return kNames[static_cast<std::size_t>(type)];
}

}  // namespace higherpair

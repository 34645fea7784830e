#pragma once

#include "higherpair/mechanism/plan.hpp"

#include <span>
#include <string>
#include <vector>

namespace higherpair {

/// The names of some of the bodies, joints or contacts of a mechanism, "coupler, rocker".
template <class Item>
[[nodiscard]] std::string names_of(const std::vector<Item>& items, std::span<const int> indices) {
  std::string names;
  for (const int index : indices) {
    names.append(names.empty() ? "" : ", ").append(items[index].name);
  }
  return names;
}

/// A group in words, with the names of the description: "crank: driven at crank_pivot", "coupler, rocker:
/// dyad RRR, two links between pins", "a, b, c: coupled bodies, solved together by Newton's method".
[[nodiscard]] std::string describe(const Mechanism& mechanism, const Group& group);

}  // namespace higherpair

#pragma once

#include "../extended.hpp"
#include "higherpair/contact/contact_pair.hpp"

#include <array>
#include <optional>
#include <vector>

namespace higherpair {

/// What exact signs say at one real root of the contact polynomial.
struct Decision {
  int contacts = 0;  ///< 0: complex, at infinity or on the other branch; 2: two at one position
  bool opposed = false;
  std::optional<bool> free;  ///< none: not decided here
  bool degenerate =
      false;  ///< coincident curves, or two contacts whose branches of hyperbolas are not decided
};

struct DecidedRoot {
  std::array<double, 2> q = {};  ///< the root lies between, rounded outwards [rad or m]
  Extended middle = 0;           ///< of a much narrower interval
  int multiplicity = 1;          ///< in the contact polynomial
  Decision decision;
};

/// All real roots of the pair's contact polynomial and what is decided at them, in whole numbers; none if the
/// polynomial vanishes.
[[nodiscard]] std::optional<std::vector<DecidedRoot>> decide_roots(const ContactPair& pair, double u);

}  // namespace higherpair

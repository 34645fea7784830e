#pragma once

#include "contact/algebra/extended.hpp"
#include "higherpair/contact/contact_pair.hpp"

#include <array>
#include <optional>
#include <vector>

namespace higherpair {

/// What exact signs decide at one real root of the contact polynomial.
struct Decision {
  int contacts = 0;  ///< 0: complex, at infinity or on a hyperbola's other branch; 2: two at one position
  bool opposed = false;
  std::optional<bool> free;  ///< none: not decided here
  /// Coincident curves, or two contacts for which the branches of hyperbolas are not decided.
  bool degenerate = false;
};

struct DecidedRoot {
  std::array<double, 2> q = {};  ///< bounds of the root, rounded outwards [rad or m]
  Extended middle = 0;           ///< of a much narrower interval around the root
  int multiplicity = 1;          ///< in the contact polynomial
  Decision decision;
};

/// All real roots of the pair's contact polynomial and the decisions at them, in integer arithmetic; none if
/// the polynomial vanishes.
[[nodiscard]] std::optional<std::vector<DecidedRoot>> decide_roots(const ContactPair& pair, double u);

}  // namespace higherpair

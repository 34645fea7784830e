#pragma once

#include "contact/subdivision/sheet_curves.hpp"
#include "higherpair/contact/contact_map.hpp"

#include <vector>

namespace higherpair {

/// A part of a step along which u is monotonic, with u_a <= u_b.
struct TraceLeg {
  SheetStep step;
  double share_a = 0, share_b = 1;
  double u_a = 0, u_b = 0;  ///< continuous along a branch
  double q_a = 0, q_b = 0;
};

/// The course of one branch.
struct TracePath {
  bool opposed = true;
  std::vector<TraceLeg> legs;       ///< by rising u
  double turn_u = 0, turn_q = 0;    ///< of a closed path: increments of u and q per round; else 0
  double shift_u = 0, shift_q = 0;  ///< whole turns added to the coordinates of the legs

  [[nodiscard]] double begin_u() const { return legs.front().u_a + shift_u; }
};

/// Two boundaries and the paths of their contacts, from which every point of a map can be computed.
class BoundaryTrace {
public:
  explicit BoundaryTrace(const BoundaryPair& pair) : opposed_(pair, true), equal_(pair, false) {}

  [[nodiscard]] const TangencySheet& sheet(bool opposed) const { return opposed ? opposed_ : equal_; }

  /// The tangency of a path at u, with q continuous along it; beyond an end, that of the end; none if no
  /// point is found.
  [[nodiscard]] std::optional<SheetPoint> at(const TracePath& path, double u) const;
  /// At a fraction of a leg, continuous with its ends and shifted as its path is.
  [[nodiscard]] std::optional<SheetPoint> at(const TracePath& path, const TraceLeg& leg, double share) const;

  /// Whether the interiors of the bodies are disjoint.
  [[nodiscard]] bool is_free(bool opposed, const SheetPoint& at) const;

  std::vector<TracePath> paths;  ///< of the branches

private:
  TangencySheet opposed_, equal_;
};

}  // namespace higherpair

#pragma once

#include "force_columns.hpp"
#include "higherpair/dynamics/contact_forces.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace higherpair {

/// A stretch of the path to be resolved.
struct ForceStretch {
  double from = 0;
  double to = 0;
  bool breaks_at_end = false;  ///< where forces may be discontinuous, so that no row belongs there
  double tail = std::numeric_limits<double>::infinity();  ///< of the stretch that it is a half of
};

/// The contact forces on a stretch as series in Chebyshev polynomials.
struct ForceFit {
  ForcePiece piece;
  std::size_t defined = 0;      ///< at how many nodes there are forces
  double tail = 0;              ///< last coefficients, relative to the largest multiplier
  std::optional<double> event;  ///< a break strictly within: behind it nothing has been looked at
};

/// The parameter of a path's piece at t, from -1 to 1.
[[nodiscard]] double parameter(const ForcePiece& piece, double t);

/// Takes contact forces at the nodes of pieces of a path, along which it moves a run.
class ForceFitter {
public:
  /// Resolves forces relative to the largest in their piece, but no smaller than a share of what they are on
  /// most of the path: in a dwell they may be nothing but rounding, which no series resolves.
  ForceFitter(const Run& start, const DriverPath& path, const std::vector<Preload>& preloads);

  /// Where it is on the path, to go back to.
  struct Position {
    Run run;
    double at = 0;
  };
  [[nodiscard]] const Position& position() const { return position_; }
  void go_back(const Position& position) { position_ = position; }

  [[nodiscard]] ForceColumns& columns() { return columns_; }
  /// What events and shortest pieces are relative to: the length of this stretch's first pieces.
  void set_longest(double longest) { longest_ = longest; }
  /// Where the last break was found; none: nowhere.
  [[nodiscard]] std::optional<double> last_break() const;

  /// The forces on a stretch, in front of which it is.
  [[nodiscard]] ForceFit fit(const ForceStretch& stretch);
  /// The forces at the position itself, as a piece of length 0; none where they are not defined.
  [[nodiscard]] std::optional<ForcePiece> here();

private:
  void set_floor();
  [[nodiscard]] ForceFit start_fit(const ForceStretch& stretch);
  void converge(ForceFit& fit);
  void move(double to, ForceFit& fit);
  [[nodiscard]] double place_of(double share, double to);
  [[nodiscard]] bool sample(double at, ForceFit& fit);

  const DriverPath& path_;
  Position position_;
  ForceColumns columns_;
  std::size_t contacts_;
  double longest_ = 0;
  std::optional<EventType> last_break_;
  double last_break_at_ = 0;
  std::vector<double> floor_;   // least of `scales_`
  std::vector<double> scales_;  // of the columns of a fit
  std::vector<DriverMotion> drivers_;
  std::vector<DriverMotion> was_;
};

}  // namespace higherpair

#pragma once

#include "force_columns.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/dynamics/contact_forces.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace higherpair {

/// A stretch of the path to be resolved.
struct ForceStretch {
  double from = 0;
  double to = 0;
  bool breaks_at_end = false;  ///< forces may be discontinuous there: no row belongs there
  double tail = kInf;          ///< ForceFit::tail of the double stretch
};

/// A part of a boundary on which all derivatives are continuous: its span, and its number within the span.
using SmoothPart = std::pair<int, std::ptrdiff_t>;

/// A contact passes to another smooth part of one of its curves. If the curvature is continuous there it is
/// not an event, but some derivative of the forces jumps.
struct SmoothJoint {
  std::size_t contact = 0;
  std::size_t side = 0;
  bool between_spans = false;
  SmoothPart before;
  double from = 0;  ///< it does so between these places of the path
  double to = 0;
};

/// The contact forces on a stretch as series in Chebyshev polynomials.
struct ForceFit {
  ForcePiece piece;
  std::size_t defined = 0;           ///< number of nodes at which forces are defined
  double tail = 0;                   ///< last coefficients, relative to the largest multiplier
  std::optional<double> event;       ///< a break strictly within; the stretch beyond it has not been examined
  std::optional<SmoothJoint> joint;  ///< one between spans, if there is one, and nearest to the middle
};

/// The path's parameter at t of a piece, with t from -1 to 1.
[[nodiscard]] double parameter(const ForcePiece& piece, double t);

/// Moves a run along a path and fits contact forces at the nodes of its pieces.
class ForceFitter {
public:
  /// Forces are resolved relative to the largest in their piece, but no finer than relative to a fraction of
  /// what they are on most of the path: in a dwell they may be only rounding, which no series resolves.
  ForceFitter(const Run& start, const DriverPath& path, const std::vector<Preload>& preloads);

  /// A position on the path that the fitter can go back to.
  struct Position {
    Run run;
    double at = 0;
  };
  [[nodiscard]] const Position& position() const { return position_; }
  void go_back(const Position& position) { position_ = position; }

  [[nodiscard]] ForceColumns& columns() { return columns_; }
  /// Sets the length of this stretch's first pieces, which the positions of events and the shortest pieces
  /// are relative to.
  void set_longest(double longest) { longest_ = longest; }
  /// Where the last break was found; none if there was none.
  [[nodiscard]] std::optional<double> last_break() const;

  /// The forces on a stretch. \pre the fitter is at or before its start
  [[nodiscard]] ForceFit fit(const ForceStretch& stretch);
  /// The place of a joint, if it is strictly within a piece. \pre `before` is at or before its start
  [[nodiscard]] std::optional<double> place_of(const SmoothJoint& joint, const ForceFit& fit,
                                               Position before) const;
  /// The forces at the position itself, as a piece of length 0; none where they are not defined.
  [[nodiscard]] std::optional<ForcePiece> here();

private:
  void set_floor();
  [[nodiscard]] ForceFit start_fit(const ForceStretch& stretch);
  void converge(ForceFit& fit);
  void move(double to, ForceFit& fit);
  void note_joints(double from, ForceFit& fit) const;
  [[nodiscard]] SmoothPart part_of(const Run& run, std::size_t contact, std::size_t side) const;
  [[nodiscard]] bool sample(double at, ForceFit& fit);

  const DriverPath& path_;
  Position position_;
  ForceColumns columns_;
  std::size_t contacts_;
  double longest_ = 0;
  std::optional<EventType> last_break_;
  double last_break_at_ = 0;
  std::vector<double> floor_;   // lower bounds of `scales_`
  std::vector<double> scales_;  // largest values of the columns in a fit
  /// Of every contact by_boundary, side and span: Span::breaks.
  std::vector<std::array<std::vector<std::vector<double>>, 2>> breaks_;
  std::vector<std::array<SmoothPart, 2>> parts_;  // of the contacts, before the last move
};

}  // namespace higherpair

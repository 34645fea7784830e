// A contour from a drawing whose numbers are rounded: joints that were smooth before are made smooth again.
#include "higherpair/geometry/contour.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "numeric/band_matrix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace higherpair {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A line or arc by its ends and the angle through which it turns, 0 for a line.
struct Bow {
  Vector2d from = Vector2d::Zero();
  Vector2d to = Vector2d::Zero();
  double sweep = 0;
  double rounding = 0;  // of the sweep [rad]
  bool circle = false;  // an arc of a circle that is as drawn
  bool fixed = false;   // another curve, or too short to have a direction
};

double chord_length(const Bow& bow) {
  return (bow.to - bow.from).norm();
}

Bow bow_of(const ContourPiece& piece, double length, const SweepRounding& rounding) {
  const auto* arc = std::get_if<ArcPiece>(&piece);
  Bow bow = {begin_of(piece).p_B, end_of(piece).p_B, arc ? arc->sweep : 0, arc ? rounding.error : 0,
             arc && rounding.of_circle};
  bow.fixed = std::holds_alternative<SpanPtr>(piece) || chord_length(bow) < kShortPiece * length;
  return bow;
}

// From the direction at the end of one to that at the beginning of the next.
double turn_between(const Bow& before, const Bow& after) {
  const Vector2d a = before.to - before.from;
  const Vector2d b = after.to - after.from;
  return std::remainder(angle_from_to(a, b) - (before.sweep + after.sweep) / 2, 2 * kPi);
}

// A circle with a radius > 0 where the path goes round it counter-clockwise; a point has none.
struct Round {
  Vector2d center = Vector2d::Zero();
  double radius = 0;
};

Round round_at(const ContourPiece& piece, bool smooth, const Vector2d& end) {
  const auto* arc = std::get_if<ArcPiece>(&piece);
  return smooth && arc ? Round{arc->center, std::copysign(arc->radius, arc->sweep)} : Round{end, 0};
}

// The line that leaves the first and reaches the second as a tangent: n · (c₂ - c₁) = r₂ - r₁ with its normal
// n to the left. None if there is none.
std::optional<LinePiece> tangent_of(const Round& first, const Round& second) {
  const Vector2d apart = second.center - first.center;
  const double s = (second.radius - first.radius) / apart.norm();
  if (!(std::abs(s) < 1)) {
    return std::nullopt;
  }
  const Vector2d n = perp(unit_vector(angle_of(apart) - std::asin(s)));
  return LinePiece{first.center - first.radius * n, second.center - second.radius * n};
}

// The same arc of its circle between other ends near its own.
ArcPiece between(const ArcPiece& arc, const Vector2d& from, const Vector2d& to) {
  const double begin = nearest_turn(angle_of(Vector2d(from - arc.center)), arc.from);
  const double end = nearest_turn(angle_of(Vector2d(to - arc.center)), arc.from + arc.sweep);
  return {arc.center, arc.radius, begin, end - begin};
}

// Numbers joints as the pieces that end at them.
class RoundedContour {
public:
  RoundedContour(const std::vector<ContourPiece>& pieces, bool closed, double length,
                 std::span<const SweepRounding> sweeps)
      : joints_(closed ? pieces.size() : pieces.size() - 1), length_(length) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      bows_.push_back(bow_of(pieces[i], length, sweeps[i]));
    }
    for (std::size_t joint = 0; joint < bows_.size(); ++joint) {
      bent_.push_back(joint < joints_ && may_be_bent(joint) ? 1 : 0);
    }
    for (std::size_t joint = 0; joint < joints_; ++joint) {
      Bow& after = bows_[(joint + 1) % bows_.size()];
      if (bent_[joint]) bows_[joint].to = after.from = (bows_[joint].to + after.from) / 2;
    }
  }

  // Newton's method with the smallest change of the numbers, each relative to its rounding: A W Aᵀ λ =
  // -turns, where A holds the derivatives of the turns by the numbers and W the squares of their roundings.
  // False where there is no change of their size.
  bool undo() {
    constexpr int kPasses = 4;  // the error is squared in each
    const std::vector<Bow> drawn = bows_;
    const auto count = static_cast<Index>(bows_.size());
    const bool cyclic = count > 6;  // a joint shares numbers with the second next
    for (int pass = 0; pass < kPasses; ++pass) {
      BandMatrix normal(count, cyclic ? 2 : count - 1, cyclic);
      VectorXd turns = VectorXd::Zero(count);
      for (Index i = 0; i < count; ++i) {
        const auto joint = static_cast<std::size_t>(i);
        if (!bent_[joint]) {
          normal.add(i, i, 1);
          continue;
        }
        turns(i) = turn_between(bows_[joint], next(joint));
        for (const std::size_t other : coupled(joint)) {
          if (bent_[other]) normal.add(i, static_cast<Index>(other), product(joint, other));
        }
      }
      if (turns.cwiseAbs().maxCoeff() <= kSmoothAgain) break;
      const BandSolver solver(normal, Pivoting::kNone);
      if (!solver.is_regular()) return false;
      move(solver.solve(-turns));
    }
    return std::equal(bows_.begin(), bows_.end(), drawn.begin(), [&](const Bow& now, const Bow& before) {
      return std::max((now.from - before.from).norm(), (now.to - before.to).norm()) <= kFarMoved * length_;
    });
  }

  // Whether lines meet arcs of drawn circles at all joints that are bent: the circles can then stay.
  [[nodiscard]] bool is_of_tangents() const {
    for (std::size_t joint = 0; joint < bows_.size(); ++joint) {
      const bool line = bows_[joint].sweep == 0 || next(joint).sweep == 0;
      const bool circle = bows_[joint].circle || next(joint).circle;
      if (bent_[joint] && !(line && circle)) return false;
    }
    return true;
  }

  // Replaces lines by tangents of the circles that they meet.
  void lay_tangents(std::vector<ContourPiece>& pieces) const {
    const std::size_t count = pieces.size();
    const std::vector<ContourPiece> drawn = pieces;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t before = (i + count - 1) % count, after = (i + 1) % count;
      if (!std::holds_alternative<LinePiece>(drawn[i]) || !(bent_[before] || bent_[i])) continue;
      const auto line = tangent_of(round_at(drawn[before], bent_[before], bows_[i].from),
                                   round_at(drawn[after], bent_[i], bows_[i].to));
      if (!line) continue;
      pieces[i] = *line;
      if (bent_[before]) {
        const auto& arc = std::get<ArcPiece>(pieces[before]);
        pieces[before] = between(arc, begin_of(arc).p_B, line->from);
      }
      if (bent_[i]) {
        const auto& arc = std::get<ArcPiece>(pieces[after]);
        pieces[after] = between(arc, line->to, end_of(arc).p_B);
      }
    }
  }

  [[nodiscard]] ContourPiece piece(std::size_t i, const ContourPiece& drawn) const {
    const Bow& bow = bows_[i];
    const Bow before = bow_of(drawn, length_, {});
    const bool same =
        bow.fixed || (bow.from == before.from && bow.to == before.to && bow.sweep == before.sweep);
    return same ? drawn : bow_piece(bow.from, bow.to, bow.sweep);
  }

private:
  [[nodiscard]] const Bow& next(std::size_t joint) const { return bows_[(joint + 1) % bows_.size()]; }

  // How far rounding may turn the directions at the ends of a piece.
  [[nodiscard]] double turn_by_rounding(const Bow& bow) const {
    return kRoundingAtEnds * length_ / chord_length(bow) + bow.rounding;
  }

  // Whether a joint at an arc is smooth to within the rounding, and not exactly. Two lines meet in a corner.
  [[nodiscard]] bool may_be_bent(std::size_t joint) const {
    const Bow& before = bows_[joint];
    const Bow& after = next(joint);
    if (before.fixed || after.fixed || (before.sweep == 0 && after.sweep == 0) ||
        (after.from - before.to).norm() > kRoundingAtEnds * length_) {
      return false;
    }
    const double turn = std::abs(turn_between(before, after));
    return turn <= std::min(turn_by_rounding(before) + turn_by_rounding(after), kMostTurnByRounding);
  }

  // The joints whose turns share numbers with this one's.
  [[nodiscard]] std::vector<std::size_t> coupled(std::size_t joint) const {
    const std::size_t count = bows_.size();
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < std::min<std::size_t>(count, 5); ++k) {
      found.push_back((joint + k + count - std::min<std::size_t>(2, count / 2)) % count);
    }
    return found;
  }

  // Derivatives of a joint's turn, times the roundings: by the positions of the three vertices that its two
  // pieces join, and by their sweeps.
  struct Slopes {
    std::array<std::size_t, 3> vertex;  // the joint there
    std::array<Vector2d, 3> by_vertex;
    std::array<std::size_t, 2> piece;
    std::array<double, 2> by_sweep;
  };
  [[nodiscard]] Slopes slopes(std::size_t joint) const {
    const std::size_t count = bows_.size();
    const Bow& before = bows_[joint];
    const Bow& after = next(joint);
    const auto by_end = [&](const Bow& bow) {
      const Vector2d chord = bow.to - bow.from;
      return Vector2d(length_ * perp(chord) / chord.squaredNorm());
    };
    const Vector2d a = by_end(before), b = by_end(after);
    Slopes by = {{(joint + count - 1) % count, joint, (joint + 1) % count},
                 {a, -a - b, b},
                 {joint, (joint + 1) % count},
                 {-before.rounding / 2, -after.rounding / 2}};
    for (std::size_t i = 0; i < 3; ++i) {
      if (bows_[by.vertex[i]].fixed || next(by.vertex[i]).fixed) by.by_vertex[i].setZero();
    }
    return by;
  }

  // A row of A W times another row of A.
  [[nodiscard]] double product(std::size_t joint, std::size_t other) const {
    const Slopes a = slopes(joint), b = slopes(other);
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (a.vertex[i] == b.vertex[k]) sum += a.by_vertex[i].dot(b.by_vertex[k]);
      }
    }
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        if (a.piece[i] == b.piece[k]) sum += a.by_sweep[i] * b.by_sweep[k];
      }
    }
    return sum;
  }

  // Changes the numbers by W Aᵀ λ.
  void move(const VectorXd& lambda) {
    std::vector<Vector2d> vertices(bows_.size(), Vector2d::Zero());
    for (std::size_t joint = 0; joint < bows_.size(); ++joint) {
      if (!bent_[joint]) continue;
      const Slopes by = slopes(joint);
      const double factor = lambda(static_cast<Index>(joint));
      for (std::size_t i = 0; i < 3; ++i) vertices[by.vertex[i]] += length_ * factor * by.by_vertex[i];
      for (std::size_t i = 0; i < 2; ++i) {
        bows_[by.piece[i]].sweep += bows_[by.piece[i]].rounding * factor * by.by_sweep[i];
      }
    }
    for (std::size_t joint = 0; joint < joints_; ++joint) {
      bows_[joint].to += vertices[joint];
      bows_[(joint + 1) % bows_.size()].from += vertices[joint];
    }
  }

  std::size_t joints_;
  double length_;
  std::vector<Bow> bows_;
  std::vector<char> bent_;  // whether rounding is undone at each joint
};

}  // namespace

ContourPiece bow_piece(const Vector2d& from, const Vector2d& to, double sweep) {
  if (std::abs(sweep) < kStraightSweep) {
    return LinePiece{from, to};
  }
  const double k = std::tan(sweep / 4);
  const Vector2d center = (from + to) / 2 + (1 - k * k) / (4 * k) * perp(Vector2d(to - from));
  return ArcPiece{center, (from - center).norm(), angle_of(Vector2d(from - center)), sweep};
}

void undo_rounding(std::vector<ContourPiece>& pieces, bool closed, double length,
                   std::span<const SweepRounding> sweeps) {
  if (pieces.size() < 2) {
    return;
  }
  RoundedContour contour(pieces, closed, length, sweeps);
  if (contour.is_of_tangents()) {
    contour.lay_tangents(pieces);
    return;
  }
  if (!contour.undo()) {
    return;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i] = contour.piece(i, pieces[i]);
  }
}

}  // namespace higherpair

#include "boundary_pieces.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr std::size_t kBlock = 8;  // pieces in a block

NormalCone cone_about(const Vector2d& sum, double slack) {
  const double norm = sum.norm();
  return norm > 0 ? NormalCone{sum / norm, slack} : NormalCone{Vector2d::UnitX(), 2};
}

bool are_opposed(const NormalCone& a, const NormalCone& b) {
  const double chords = a.chord + b.chord + kRoundingOfNormal;
  return (a.middle + b.middle).squaredNorm() <= chords * chords;
}

void close_block(const std::vector<BoundaryPiece>& pieces, std::size_t begin,
                 std::vector<PieceBlock>& blocks) {
  if (begin == pieces.size()) {
    return;
  }
  PieceBlock block;
  block.begin = begin;
  block.end = pieces.size();
  Vector2d normals = Vector2d::Zero();
  for (std::size_t i = begin; i < block.end; ++i) {
    block.center += (pieces[i].from + pieces[i].to) / (2 * static_cast<double>(block.end - begin));
    normals += pieces[i].normals.middle;
  }
  block.normals = cone_about(normals, 0);
  for (std::size_t i = begin; i < block.end; ++i) {
    const BoundaryPiece& piece = pieces[i];
    block.radius =
        std::max({block.radius, (piece.from - block.center).norm() + kSlackOfChord * piece.length(),
                  (piece.to - block.center).norm() + kSlackOfChord * piece.length()});
    block.normals.chord = std::max(
        block.normals.chord, (piece.normals.middle - block.normals.middle).norm() + piece.normals.chord);
  }
  blocks.push_back(block);
}

// Whether two pieces may have points with a common normal, at most `reach` apart.
bool may_face(const BoundaryPiece& a, const BoundaryPiece& b, double reach) {
  if (!are_opposed(a.normals, b.normals)) {
    return false;
  }
  const double lengths = a.length() + b.length();
  const Vector2d apart = b.middle() - a.middle();
  // Within the cones of normals the tangent turns, so that part of the offset along the normal counts along
  // it.
  const double turned = a.normals.chord + b.normals.chord;
  const double along = std::abs(apart.dot(perp(a.normals.middle)));
  return apart.norm() <= reach + lengths && along <= (0.5 + kSlackOfChord) * lengths + turned * apart.norm();
}

}  // namespace

BoundaryPieces boundary_pieces(const Boundary& boundary, const Pose<double>& X_1B, const Vector2d& center,
                               double reach) {
  BoundaryPieces all;
  std::size_t begin = 0;
  const auto& samples = boundary.samples();
  const Vector2d center_B = X_1B.inverse_times(center);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto& a = samples[i - 1];
    const auto& b = samples[i];
    if (a.place.span != b.place.span) {
      continue;
    }
    // Most are far away: they are rejected without square roots.
    const double length2 = (b.point.p_B - a.point.p_B).squaredNorm();
    const double away2 = (a.point.p_B - center_B).squaredNorm();
    if (away2 > 2 * reach * reach + 2 * (1 + kSlackOfChord) * (1 + kSlackOfChord) * length2 ||
        std::sqrt(away2) > reach + (1 + kSlackOfChord) * std::sqrt(length2)) {
      continue;
    }
    const Vector2d from = X_1B * a.point.p_B;
    const Vector2d to = X_1B * b.point.p_B;
    const NormalCone normals = cone_about(a.point.n_B + b.point.n_B, 0);
    const double chord = (a.point.n_B - normals.middle).norm();
    all.pieces.push_back(
        {from, to, {X_1B.R_WB * normals.middle, (1 + kSlackOfNormal) * chord}, a.place, b.place});
    if (all.pieces.size() - begin == kBlock) {
      close_block(all.pieces, begin, all.blocks);
      begin = all.pieces.size();
    }
  }
  close_block(all.pieces, begin, all.blocks);
  return all;
}

void for_each_facing(
    const BoundaryPieces& one, const BoundaryPieces& two, double reach,
    const std::function<void(const BoundaryPlace& place1, const BoundaryPlace& place2)>& found) {
  for (const PieceBlock& a : one.blocks) {
    for (const PieceBlock& b : two.blocks) {
      const double most = reach + a.radius + b.radius;
      if ((b.center - a.center).squaredNorm() > most * most || !are_opposed(a.normals, b.normals)) {
        continue;
      }
      for (std::size_t i = a.begin; i < a.end; ++i) {
        for (std::size_t k = b.begin; k < b.end; ++k) {
          if (may_face(one.pieces[i], two.pieces[k], reach)) {
            found(one.pieces[i].place_at(two.pieces[k].middle()),
                  two.pieces[k].place_at(one.pieces[i].middle()));
          }
        }
      }
    }
  }
}

std::optional<BoundaryPlace> nearest_place(const BoundaryPieces& all, const Vector2d& p, double reach) {
  std::optional<BoundaryPlace> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const PieceBlock& block : all.blocks) {
    if ((block.center - p).norm() - block.radius > std::min(reach, least)) {
      continue;
    }
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const double distance = all.pieces[i].distance_to(p);
      if (distance < least) {
        least = distance;
        nearest = all.pieces[i].place_at(p);
      }
    }
  }
  return nearest;
}

}  // namespace higherpair

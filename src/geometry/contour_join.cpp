#include "higherpair/geometry/contour.hpp"
#include "higherpair/geometry/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace higherpair {
namespace {

// Index 2i is the beginning of piece i, 2i + 1 is its end.
using EndIndex = std::size_t;

struct Cell {
  std::int64_t x = 0;
  std::int64_t y = 0;
  bool operator==(const Cell&) const = default;
};

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    constexpr std::uint64_t kMix = 0x9e3779b97f4a7c15U;
    const std::uint64_t h = static_cast<std::uint64_t>(cell.x) * kMix ^ static_cast<std::uint64_t>(cell.y);
    return static_cast<std::size_t>((h ^ (h >> 31)) * kMix);
  }
};

// The ends of all pieces, found by their positions.
class Ends {
public:
  Ends(const std::vector<ContourPiece>& pieces, double tolerance) : tolerance_(tolerance) {
    for (const ContourPiece& piece : pieces) {
      places_.push_back(begin_of(piece).p_B);
      places_.push_back(end_of(piece).p_B);
      far_ = std::max(
          {far_, places_.back().cwiseAbs().maxCoeff(), places_[places_.size() - 2].cwiseAbs().maxCoeff()});
    }
    width_ = std::max(2 * tolerance, far_ * kNarrowestCell);  // so that the indices of cells are exact
    for (EndIndex end = 0; end < places_.size(); ++end) {
      cells_[cell(places_[end])].push_back(end);
    }
  }

  [[nodiscard]] const Vector2d& place(EndIndex end) const { return places_[end]; }

  // The other ends at the position of this one.
  [[nodiscard]] std::vector<EndIndex> others_at(EndIndex end) const {
    std::vector<EndIndex> found;
    const Cell center = cell(places_[end]);
    for (const std::int64_t dx : {-1, 0, 1}) {
      for (const std::int64_t dy : {-1, 0, 1}) {
        const auto at = cells_.find({center.x + dx, center.y + dy});
        if (at == cells_.end()) {
          continue;
        }
        for (const EndIndex other : at->second) {
          if (other != end && (places_[other] - places_[end]).norm() <= tolerance_) {
            found.push_back(other);
          }
        }
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

private:
  [[nodiscard]] Cell cell(const Vector2d& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x() / width_)),
            static_cast<std::int64_t>(std::floor(p.y() / width_))};
  }

  double tolerance_;
  double width_ = 1;
  double far_ = 0;
  std::vector<Vector2d> places_;
  std::unordered_map<Cell, std::vector<EndIndex>, CellHash> cells_;
};

constexpr EndIndex kNone = static_cast<EndIndex>(-1);

EndIndex other_end(EndIndex end) {
  return end ^ 1U;
}

// The path from an end over unused pieces, as the ends at which it enters them.
std::vector<EndIndex> chain_from(EndIndex end, const std::vector<EndIndex>& partner,
                                 std::vector<char>& used) {
  std::vector<EndIndex> chain;
  while (end != kNone && used[end / 2] == 0) {
    used[end / 2] = 1;
    chain.push_back(end);
    end = partner[other_end(end)];
  }
  return chain;
}

}  // namespace

tl::expected<std::vector<Contour>, JoinFault> join(const std::vector<ContourPiece>& pieces,
                                                   double tolerance) {
  const Ends ends(pieces, tolerance);
  std::vector<EndIndex> partner(2 * pieces.size(), kNone);
  for (EndIndex end = 0; end < partner.size(); ++end) {
    const std::vector<EndIndex> others = ends.others_at(end);
    if (others.size() > 1) {
      JoinFault fault = {ends.place(end), {static_cast<int>(end / 2)}};
      for (const EndIndex other : others) {
        fault.pieces.push_back(static_cast<int>(other / 2));
      }
      return tl::unexpected(fault);
    }
    partner[end] = others.empty() ? kNone : others.front();
  }
  std::vector<Contour> contours;
  std::vector<char> used(pieces.size(), 0);
  for (EndIndex piece = 0; piece < pieces.size(); ++piece) {
    if (used[piece] != 0) {
      continue;
    }
    // Forwards to an end or all the way round; if open, also the pieces before.
    std::vector<EndIndex> chain = chain_from(2 * piece, partner, used);
    const EndIndex last = other_end(chain.back());
    Contour contour;
    contour.closed = partner[last] == chain.front();
    const EndIndex before = partner[chain.front()];
    if (!contour.closed && before != kNone) {
      std::vector<EndIndex> back = chain_from(before, partner, used);
      std::reverse(back.begin(), back.end());
      std::transform(back.begin(), back.end(), back.begin(), other_end);
      chain.insert(chain.begin(), back.begin(), back.end());
    }
    for (const EndIndex end : chain) {
      const ContourPiece& one = pieces[end / 2];
      contour.pieces.push_back(end % 2 == 0 ? one : reversed(one));
      contour.sources.push_back(static_cast<int>(end / 2));
    }
    contours.push_back(std::move(contour));
  }
  return contours;
}

}  // namespace higherpair

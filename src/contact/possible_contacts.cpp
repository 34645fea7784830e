#include "possible_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace higherpair {
namespace {

using boost::numeric::hull;
using boost::numeric::median;

// Neighbours share an edge up to rounding.
constexpr double kSlack = 1e-13;

// x moved by whole turns to next to y.
Interval next_to(const Interval& x, const Interval& y) {
  const double turns = std::round((median(y) - median(x)) / (2 * kPi));
  return turns == 0 ? x : x + 2 * turns * half_turn();
}

bool touch(const Interval& a, const Interval& b) {
  const Interval near = next_to(a, b);
  return near.lower() <= b.upper() + kSlack && b.lower() <= near.upper() + kSlack;
}

bool are_neighbours(std::size_t a, std::size_t b, std::size_t count) {
  const std::size_t apart = a > b ? a - b : b - a;
  return apart <= 1 || apart + 1 == count;
}

struct Merger {
  const SupportPair& pair;
  Interval theta1;
  const std::vector<PossiblePlace>& places;
  bool turns;

  [[nodiscard]] bool belong_together(const PossiblePlace& a, const PossiblePlace& b) const {
    return a.opposed == b.opposed && touch(a.place.psi1, b.place.psi1) && touch(a.place.psi2, b.place.psi2) &&
           are_neighbours(a.place.pieces.first, b.place.pieces.first, pair.curve1.pieces().size()) &&
           are_neighbours(a.place.pieces.second, b.place.pieces.second, pair.curve2.pieces().size());
  }

  // The bounds of a box next to those of another one that it touches.
  [[nodiscard]] Place unrolled(const PossiblePlace& one, const Place& other) const {
    Place place = one.place;
    place.psi1 = next_to(place.psi1, other.psi1);
    place.q = turns ? next_to(place.q, other.q) : place.q;
    return place;
  }

  // All boxes that hang together with `start`, which are taken off `left`.
  [[nodiscard]] PossibleContact cluster(std::size_t start, std::vector<std::size_t>& left) const {
    const PossiblePlace& first = places[start];
    Place all = first.place;
    std::vector<Place> front{all};
    PossibleContact merged{{}, {}, first.opposed, all.pieces.first, all.pieces.second, 1};
    std::vector<std::size_t> members{start};
    for (std::size_t i = 0; i < members.size(); ++i) {
      const auto rest = std::partition(left.begin(), left.end(), [&](std::size_t other) {
        return !belong_together(places[members[i]], places[other]);
      });
      for (auto next = rest; next != left.end(); ++next) {
        front.push_back(unrolled(places[*next], front[i]));
        all.psi1 = hull(all.psi1, front.back().psi1);
        all.q = hull(all.q, front.back().q);
        members.push_back(*next);
      }
      left.erase(rest, left.end());
    }
    merged.boxes = members.size();
    merged.phi = whole_turn_at_most(to_bounds(all.psi1 + theta1));
    merged.q = turns ? whole_turn_at_most(to_bounds(all.q)) : to_bounds(all.q);
    return merged;
  }

  static Bounds whole_turn_at_most(const Bounds& bounds) {
    if (bounds.width() >= 2 * kPi) {
      return {-kPi, kPi + 1e-15};
    }
    const double low = std::remainder(bounds.low, 2 * kPi);
    const double error = 1e-15 * (1 + std::abs(bounds.low));
    return bounds.low == low ? bounds : Bounds{low - error, low + bounds.width() + error};
  }
};

}  // namespace

std::vector<PossibleContact> merge_places(const SupportPair& pair, const Interval& theta1,
                                          const std::vector<PossiblePlace>& places, const Bounds& range) {
  const Merger merger{pair, theta1, places, pair.motion2.turns};
  std::vector<std::size_t> left(places.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<PossibleContact> clusters;
  while (!left.empty()) {
    const std::size_t start = left.back();
    left.pop_back();
    clusters.push_back(merger.cluster(start, left));
    Bounds& q = clusters.back().q;
    q = merger.turns ? q : Bounds{std::max(q.low, range.low), std::min(q.high, range.high)};
  }
  std::sort(clusters.begin(), clusters.end(),
            [](const PossibleContact& a, const PossibleContact& b) { return a.q.low < b.q.low; });
  return clusters;
}

}  // namespace higherpair

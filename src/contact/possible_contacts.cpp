#include "possible_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace higherpair {
namespace {

using boost::numeric::hull;
using boost::numeric::median;

Interval moved(const Interval& x, double turns) {
  return turns == 0 ? x : x + 2 * turns * half_turn();
}

// x moved by whole turns to next to y.
Interval next_to(const Interval& x, double y) {
  return moved(x, std::round((y - median(x)) / (2 * kPi)));
}

bool are_near(const Interval& a, const Interval& b, double slack) {
  return a.lower() <= b.upper() + slack && b.lower() <= a.upper() + slack;
}

bool are_neighbours(std::size_t a, std::size_t b, std::size_t count) {
  const std::size_t apart = a > b ? a - b : b - a;
  return apart <= 1 || apart + 1 == count;
}

// A box, by ψ1 and the other angle (a turning q, or ψ2), brought into one turn. One at the lower end of the
// turn appears at the upper end too.
struct Image {
  std::size_t of = 0;
  Interval psi1;
  Interval other;

  // Boxes that are near each other are so in this direction, few others are.
  [[nodiscard]] double low() const { return psi1.lower() + 0.618 * other.lower(); }
  [[nodiscard]] double high() const { return psi1.upper() + 0.618 * other.upper(); }
};

std::vector<Image> images_of(const std::vector<PossiblePlace>& places, bool turns, double slack) {
  std::vector<Image> images;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Interval psi1 = next_to(places[i].place.psi1, 0);
    const Interval other = next_to(turns ? places[i].place.q : places[i].place.psi2, 0);
    for (int k1 = 0; k1 <= (psi1.lower() <= -kPi + slack ? 1 : 0); ++k1) {
      for (int k2 = 0; k2 <= (other.lower() <= -kPi + slack ? 1 : 0); ++k2) {
        images.push_back({i, moved(psi1, k1), moved(other, k2)});
      }
    }
  }
  std::sort(images.begin(), images.end(), [](const Image& a, const Image& b) { return a.low() < b.low(); });
  return images;
}

// Which boxes are connected: each points to another one of its set, the first to itself.
class Sets {
public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t first_of(std::size_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax({first_of(a), first_of(b)});  // of a list: by value
    parent_[high] = low;
  }

private:
  std::vector<std::size_t> parent_;
};

Sets near_sets(const SupportPair& pair, const std::vector<PossiblePlace>& places, double slack) {
  const std::vector<Image> images = images_of(places, pair.motion2.turns, slack);
  Sets sets(places.size());
  const auto belong_together = [&](const Image& a, const Image& b) {
    const PossiblePlace& one = places[a.of];
    const PossiblePlace& other = places[b.of];
    return one.opposed == other.opposed && are_near(a.psi1, b.psi1, slack) &&
           are_near(a.other, b.other, slack) &&
           are_neighbours(one.place.pieces.first, other.place.pieces.first, pair.curve1.pieces().size()) &&
           are_neighbours(one.place.pieces.second, other.place.pieces.second, pair.curve2.pieces().size());
  };
  for (std::size_t i = 0; i < images.size(); ++i) {
    for (std::size_t k = i + 1; k < images.size() && images[k].low() <= images[i].high() + 2 * slack; ++k) {
      if (belong_together(images[i], images[k])) sets.join(images[i].of, images[k].of);
    }
  }
  return sets;
}

Bounds whole_turn_at_most(const Interval& x) {
  if (!(boost::numeric::width(x) < 2 * kPi)) {
    return {-kPi, kPi + 1e-15};
  }
  return to_bounds(moved(x, -std::round(x.lower() / (2 * kPi))));
}

}  // namespace

std::vector<PossibleContact> merge_places(const SupportPair& pair, const Interval& theta1,
                                          const std::vector<PossiblePlace>& places, const Bounds& range,
                                          double tolerance) {
  const bool turns = pair.motion2.turns;
  Sets sets = near_sets(pair, places, tolerance);
  std::vector<PieceContact> hulls(places.size());
  std::vector<std::size_t> boxes(places.size(), 0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PieceContact& place = places[i].place;
    const std::size_t first = sets.first_of(i);
    PieceContact& all = hulls[first];
    if (boxes[first]++ == 0) {
      all = place;
      continue;
    }
    const PieceContact& start = places[first].place;
    all.psi1 = hull(all.psi1, next_to(place.psi1, median(start.psi1)));
    all.q = hull(all.q, turns ? next_to(place.q, median(start.q)) : place.q);
  }
  std::vector<PossibleContact> clusters;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (boxes[i] == 0) {
      continue;
    }
    const Bounds q =
        turns ? whole_turn_at_most(hulls[i].q)
              : Bounds{std::max(hulls[i].q.lower(), range.low), std::min(hulls[i].q.upper(), range.high)};
    clusters.push_back({q, whole_turn_at_most(hulls[i].psi1 + theta1), places[i].opposed,
                        hulls[i].pieces.first, hulls[i].pieces.second, boxes[i]});
  }
  std::sort(clusters.begin(), clusters.end(),
            [](const PossibleContact& a, const PossibleContact& b) { return a.q.low < b.q.low; });
  return clusters;
}

}  // namespace higherpair

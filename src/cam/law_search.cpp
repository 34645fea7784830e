#include "law_search.hpp"

#include "higherpair/geometry/roots.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

struct Search {
  const LawPieces& law;
  const LawPiece& piece;
  int k;
  double shortest;
  double negligible;
  std::vector<double> found;

  [[nodiscard]] double value(double x) const { return law.derivative(piece, k, x); }

  void add(double x) {
    if (found.empty() || found.back() != x) {
      found.push_back(x);
    }
  }

  // The ends are either known not to be exact zeros, or have already been added.
  void inside(double from, double to) {
    const Bounds own = law.bounds(piece, k, from, to);
    if (own.low > 0 || own.high < 0) {
      return;
    }
    const double middle = (from + to) / 2;
    if (to - from <= shortest || std::max(-own.low, own.high) <= negligible) {
      add(middle);
      return;
    }
    const Bounds slope = law.bounds(piece, k + 1, from, to);
    if (slope.low > 0 || slope.high < 0) {
      const auto root =
          root_between([&](double t) { return value(from + t); }, value(from), to - from, value(to));
      if (root) {
        add(from + *root);
      }
      return;
    }
    inside(from, middle);
    inside(middle, to);
  }
};

}  // namespace

std::vector<double> zeros_of(const LawPieces& law, const LawPiece& piece, int k, double from, double to,
                             double negligible) {
  if (law.vanishes(piece, k)) {
    return {};
  }
  Search search{law, piece, k, kShortestLawInterval * (to - from), negligible, {}};
  search.inside(from, to);
  return std::move(search.found);
}

}  // namespace higherpair

#pragma once

#include "higherpair/geometry/vector.hpp"
#include "numeric/interval.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include <Eigen/LU>

namespace higherpair {

/// A box of N unknowns.
template <int N>
using Box = std::array<Interval, N>;

/// N equations F = 0 over a box: enclosures of F at its center, of F and of the Jacobian over all of it.
template <int N>
struct BoxExpansion {
  std::array<double, N> center = {};
  Box<N> at_center;
  Box<N> range;
  std::array<Box<N>, N> J;  ///< J[i][k] = ∂F_i/∂x_k
};

/// A root that is certified: one, and only one, lies in `unique`, and it is in `at`.
template <int N>
struct Root {
  Box<N> at;
  Box<N> unique;
};

template <int N>
struct SearchResult {
  std::vector<Root<N>> roots;
  std::vector<Box<N>> undecided;  ///< all other roots lie in these
  std::size_t boxes = 0;          ///< boxes looked at
  bool exhausted = false;         ///< the budget ended before the boxes were as small as the tolerance
};

namespace box_search {

template <int N>
[[nodiscard]] double widest(const Box<N>& box) {
  double widest = 0;
  for (const Interval& x : box) widest = std::max(widest, boost::numeric::width(x));
  return widest;
}

/// Whether the one box lies in the other, some unknowns meaning the same a whole turn farther.
template <int N>
[[nodiscard]] bool is_same_place(const Box<N>& inner, const Box<N>& outer,
                                 const std::array<bool, N>& is_periodic) {
  for (std::size_t k = 0; k < N; ++k) {
    const double away = boost::numeric::median(outer[k]) - boost::numeric::median(inner[k]);
    const double turns = is_periodic[k] ? std::round(away / (2 * kPi)) : 0;
    const Interval moved = turns == 0 ? inner[k] : inner[k] + 2 * turns * half_turn();
    if (!boost::numeric::subset(moved, outer[k])) return false;
  }
  return true;
}

/// Whether K(X) proves a single root in X, and the iteration goes on fast: K(X) lies in the interior of X and
/// is at most half as wide.
template <int N>
[[nodiscard]] bool is_contraction(const Box<N>& K, const Box<N>& X) {
  for (std::size_t k = 0; k < N; ++k) {
    const bool interior = X[k].lower() < K[k].lower() && K[k].upper() < X[k].upper();
    if (!interior || !(boost::numeric::width(K[k]) <= boost::numeric::width(X[k]) / 2)) return false;
  }
  return true;
}

/// The common part; none if there is none.
template <int N>
[[nodiscard]] std::optional<Box<N>> common(const Box<N>& a, const Box<N>& b) {
  Box<N> both;
  for (std::size_t k = 0; k < N; ++k) {
    if (!boost::numeric::overlap(a[k], b[k])) return std::nullopt;
    both[k] = boost::numeric::intersect(a[k], b[k]);
  }
  return both;
}

/// Krawczyk's operator K(X) = m - Y F(m) + (1 - Y J(X))(X - m), m the center, Y the inverse of the middle
/// Jacobian. Every root in X is in K(X); if K(X) lies in the interior of X, there is one root in X and no
/// second. None where the middle Jacobian has no inverse.
template <int N>
[[nodiscard]] std::optional<Box<N>> krawczyk(const Box<N>& X, const BoxExpansion<N>& e) {
  Eigen::Matrix<double, N, N> J;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = 0; k < N; ++k) {
      J(static_cast<int>(i), static_cast<int>(k)) = boost::numeric::median(e.J[i][k]);
    }
  }
  const Eigen::Matrix<double, N, N> Y = J.inverse();
  if (!Y.allFinite()) {
    return std::nullopt;
  }
  Box<N> K;
  for (std::size_t i = 0; i < N; ++i) {
    const auto y = [&](std::size_t j) { return Y(static_cast<int>(i), static_cast<int>(j)); };
    K[i] = Interval(e.center[i]);
    for (std::size_t j = 0; j < N; ++j) K[i] -= y(j) * e.at_center[j];
    for (std::size_t k = 0; k < N; ++k) {
      Interval rest = i == k ? 1 : 0;
      for (std::size_t j = 0; j < N; ++j) rest -= y(j) * e.J[j][k];
      K[i] += rest * (X[k] - e.center[k]);
    }
  }
  return K;
}

/// The box and an eighth of its width more on each side, within the limits: a root on the seam of two boxes
/// is in the interior of either. A little [rad] is added to a side that is known to within rounding already,
/// where no operator could lie in the interior.
template <int N>
[[nodiscard]] Box<N> inflated(const Box<N>& box, const Box<N>& limits) {
  Box<N> larger;
  for (std::size_t k = 0; k < N; ++k) {
    const double more = boost::numeric::width(box[k]) / 8 + 1e-13;
    larger[k] = boost::numeric::intersect(Interval(box[k].lower() - more, box[k].upper() + more), limits[k]);
  }
  return larger;
}

/// How finely a box is subdivided.
struct Finest {
  double width = 0;   ///< no side longer than this, ...
  double change = 0;  ///< ... and F changes along no side by more, ...
  double least = 0;   ///< ... but no side is cut below this
};

/// The side to cut next: the one along which F changes most, of those that are not fine enough; none if all
/// are.
template <int N>
[[nodiscard]] std::optional<std::size_t> coarsest_side(const Box<N>& box, const BoxExpansion<N>& e,
                                                       const Finest& finest) {
  std::optional<std::size_t> coarsest;
  double most = -1;
  for (std::size_t k = 0; k < N; ++k) {
    const double width = boost::numeric::width(box[k]);
    double slope = 0;
    for (std::size_t i = 0; i < N; ++i) slope = std::max(slope, boost::numeric::norm(e.J[i][k]));
    const double change = width * std::clamp(slope, 1e-300, 1e300);
    const bool fine = (width <= finest.width && change <= finest.change) || width <= finest.least;
    if (!fine && change > most) {
      most = change;
      coarsest = k;
    }
  }
  return coarsest;
}

template <int N>
[[nodiscard]] std::array<Box<N>, 2> halves(const Box<N>& box, std::size_t side) {
  std::array<Box<N>, 2> parts{box, box};
  const double m = boost::numeric::median(box[side]);
  parts[0][side].assign(box[side].lower(), m);
  parts[1][side].assign(m, box[side].upper());
  return parts;
}

/// Krawczyk's iteration until only rounding is left.
template <int N, class Expand>
[[nodiscard]] Box<N> tightened(Box<N> box, const Expand& expand) {
  for (int pass = 0; pass < 60; ++pass) {
    const auto K = krawczyk<N>(box, expand(box));
    const auto smaller = K ? common<N>(*K, box) : std::nullopt;
    if (!smaller) {
      return box;
    }
    const bool done = widest<N>(*smaller) > 0.9 * widest<N>(box);
    box = *smaller;
    if (done) {
      return box;
    }
  }
  return box;
}

}  // namespace box_search

/// Where to look for roots.
template <int N>
struct SearchProblem {
  std::vector<Box<N>> start;
  Box<N> limits;                         ///< the boxes of which F is asked lie in these
  std::array<bool, N> is_periodic = {};  ///< F has the period 2π in this unknown
  box_search::Finest finest;
  std::size_t budget = 0;  ///< boxes to look at
};

/// All roots of F in the boxes `start`, by bisection, largest boxes first: a box is dropped if F has no zero
/// in it by its enclosure or by Krawczyk's operator, or if it lies where a known root is the only one; it is
/// decided if the operator certifies its root, and left undecided when it is as fine as wanted.
/// \param expand  Box -> BoxExpansion
template <int N, class Expand>
[[nodiscard]] SearchResult<N> search_boxes(const SearchProblem<N>& problem, const Expand& expand) {
  using namespace box_search;
  SearchResult<N> result;
  std::deque<Box<N>> queue(problem.start.begin(), problem.start.end());
  const auto is_known = [&](const Box<N>& box) {
    return std::any_of(result.roots.begin(), result.roots.end(), [&](const Root<N>& root) {
      return is_same_place<N>(box, root.unique, problem.is_periodic);
    });
  };
  for (; !queue.empty() && result.boxes < problem.budget; queue.pop_front()) {
    Box<N> box = queue.front();
    if (is_known(box)) {
      continue;
    }
    ++result.boxes;
    const Box<N> larger = inflated<N>(box, problem.limits);
    const BoxExpansion<N> e = expand(larger);
    if (!std::all_of(e.range.begin(), e.range.end(), holds_zero)) {
      continue;
    }
    const std::optional<std::size_t> side = coarsest_side<N>(box, e, problem.finest);
    const double width = widest<N>(box);
    if (const auto K = krawczyk<N>(larger, e)) {
      const auto rest = common<N>(*K, box);
      if (!rest) {
        continue;
      }
      if (is_contraction<N>(*K, larger)) {
        const Root<N> root{tightened<N>(*K, expand), larger};
        if (!is_known(root.at)) {
          result.roots.push_back(root);
        }
        continue;
      }
      box = *rest;
    }
    if (!side) {
      result.undecided.push_back(box);
    } else if (widest<N>(box) < width / 2) {
      queue.push_back(box);
    } else {
      const auto parts = halves<N>(box, *side);
      queue.insert(queue.end(), parts.begin(), parts.end());
    }
  }
  result.exhausted = !queue.empty();
  result.undecided.insert(result.undecided.end(), queue.begin(), queue.end());
  std::erase_if(result.undecided, is_known);  // by roots that were found later
  return result;
}

}  // namespace higherpair

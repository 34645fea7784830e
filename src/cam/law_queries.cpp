// Queries on a law as a whole: bounds, extremes, zeros, breaks.
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "law_data.hpp"
#include "law_pieces.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cassert>
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

// Zeros of the k-th derivative of a piece from x = from to x = to, ascending. Intervals in which bounds show
// that there is none, or at most one, are settled directly; others are halved. An interval in which the
// absolute value is nowhere above `negligible` counts as one zero.
std::vector<double> zeros_of(const LawPieces& law, const LawPiece& piece, int k, double from, double to,
                             double negligible) {
  if (law.vanishes(piece, k)) {
    return {};
  }
  Search search{law, piece, k, kShortestLawInterval * (to - from), negligible, {}};
  search.inside(from, to);
  return std::move(search.found);
}

}  // namespace

std::vector<double> MotionLaw::breaks(double from, double to) const {
  std::vector<double> found;
  const auto visit = [&](const LawPiece* piece, double low, double high, double, double shift) {
    const bool breaks = piece == nullptr || (piece->start != PieceStart::kSmooth && low == piece->begin);
    const bool ends = high == end();
    for (const double x : {breaks ? low + shift : from, ends ? high + shift : from}) {
      if (x > from && x < to && (found.empty() || x > found.back())) {
        found.push_back(x);
      }
    }
  };
  data_->for_each_piece(from, to, visit);
  return found;
}

Bounds MotionLaw::bounds(int k, double from, double to) const {
  assert(from <= to);
  Bounds all{kInf, -kInf};
  const double near = kAtJoin * std::max(std::abs(from), std::abs(to));
  data_->for_each_piece(from - near, to + near,
                        [&](const LawPiece* piece, double low, double high, double offset, double) {
                          Bounds own = piece ? data_->law.bounds(*piece, k, low, high) : Bounds{};
                          if (k == 0) {
                            own.low += offset;
                            own.high += offset;
                          }
                          all.low = std::min(all.low, own.low);
                          all.high = std::max(all.high, own.high);
                        });
  return all;
}

LawExtremes MotionLaw::extremes(int k, double from, double to) const {
  assert(from <= to);
  LawExtremes best{kInf, 0, -kInf, 0};
  const auto consider = [&](double value, double x) {
    if (value < best.least) {
      best.least = value;
      best.least_at = x;
    }
    if (value > best.greatest) {
      best.greatest = value;
      best.greatest_at = x;
    }
  };
  const LawPieces& law = data_->law;
  const double negligible = kLawNoise * data_->size(k + 1);
  const auto value = [&](const LawPiece* piece, double x, double offset) {
    return (piece ? law.derivative(*piece, k, x) : 0) + (k == 0 ? offset : 0);
  };
  const auto at_ends = [&](const LawPiece* piece, double low, double high, double offset, double shift) {
    consider(value(piece, low, offset), low + shift);
    consider(value(piece, high, offset), high + shift);
  };
  const auto within = [&](const LawPiece* piece, double low, double high, double offset, double shift) {
    if (piece == nullptr) {
      return;
    }
    const Bounds own = law.bounds(*piece, k, low, high);
    const double base = k == 0 ? offset : 0;
    if (own.low + base < best.least || own.high + base > best.greatest) {
      for (const double x : zeros_of(law, *piece, k + 1, low, high, negligible)) {
        consider(value(piece, x, offset), x + shift);
      }
    }
  };
  data_->for_each_piece(from, to, at_ends);
  data_->for_each_piece(from, to, within);
  return best;
}

// Where the k-th derivative equals `level`, which is 0 unless k = 0.
std::vector<double> MotionLaw::Data::places(int k, double from, double to, double level) const {
  std::vector<double> found;
  const auto add = [&](double x) {
    if (found.empty() || x > found.back()) {
      found.push_back(x);
    }
  };
  const double negligible = kLawNoise * size(k);
  double before = 0;  // sign at the end of the preceding piece
  const auto visit = [&](const LawPiece* piece, double low, double high, double offset, double shift) {
    const double higher_by = k == 0 ? offset - level : 0;
    const auto value = [&](double x) { return (piece ? law.derivative(*piece, k, x) : 0) + higher_by; };
    const double at_low = value(low);
    if (before * at_low < 0) {
      add(low + shift);
    }
    before = value(high);
    if (piece == nullptr) {
      return;
    }
    // A copy of the piece, shifted by higher_by.
    LawPieces own;
    LawPiece raised = *piece;
    raised.base += higher_by;
    own.add(raised, std::span(law.powers).subspan(piece->first_power, piece->powers),
            std::span(law.waves).subspan(piece->first_wave, piece->waves));
    if (own.vanishes(own.pieces.front(), k)) {
      return;
    }
    if (std::abs(at_low) <= negligible) {
      add(low + shift);
    }
    for (const double x : zeros_of(own, own.pieces.front(), k, low, high, negligible)) {
      add(x + shift);
    }
    if (std::abs(before) <= negligible) {
      add(high + shift);
    }
  };
  for_each_piece(from, to, visit);
  return found;
}

std::vector<double> MotionLaw::zeros(int k, double from, double to) const {
  return data_->places(k, from, to, 0);
}

std::vector<double> MotionLaw::places(double value, double from, double to) const {
  return data_->places(0, from, to, value);
}

}  // namespace higherpair

#pragma once

#include "higherpair/numeric/special_values.hpp"
#include "law_pieces.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace higherpair {

struct MotionLaw::Data {
  LawPieces law;
  bool repeats = false;
  double first = 0;  ///< value at the beginning
  double last = 0;   ///< and at the end
  std::vector<LawJoin> joins;

  [[nodiscard]] double begin() const { return law.begins.front(); }
  [[nodiscard]] double end() const { return law.begins.back(); }
  [[nodiscard]] double length() const { return end() - begin(); }
  [[nodiscard]] double advance() const { return last - first; }

  // A piece and the position of x in it; no piece: beyond the ends of a law that does not repeat.
  struct Found {
    const LawPiece* piece = nullptr;
    double x = 0;
    double offset = 0;  // to be added to the value
  };

  [[nodiscard]] Found find(double x, LawSide side) const {
    const double near = kAtJoin * std::max({std::abs(x), std::abs(begin()), std::abs(end())});
    double offset = 0;
    if (repeats && (x < begin() || x >= end())) {
      const double turns = std::floor((x - begin()) / length());
      x -= turns * length();
      offset = turns * advance();
    }
    const auto next = std::upper_bound(law.begins.begin(), law.begins.end(), x);
    auto i = static_cast<std::ptrdiff_t>(next - law.begins.begin()) - 1;
    const auto count = static_cast<std::ptrdiff_t>(law.pieces.size());
    const auto join = [&](std::ptrdiff_t k) { return law.begins[k]; };
    if (side == LawSide::kAfter && i < count && join(i + 1) - x <= near) {
      x = join(++i);
    } else if (side == LawSide::kBefore && i >= 0 && x - join(i) <= near) {
      x = join(i--);
    } else if (side == LawSide::kBefore && i < count && join(i + 1) - x <= near) {
      x = join(i + 1);
    } else if (side == LawSide::kAfter && i >= 0 && x - join(i) <= near) {
      x = join(i);
    }
    if (repeats && i == count) {
      return {&law.pieces.front(), x - length(), offset + advance()};
    }
    if (repeats && i < 0) {
      return {&law.pieces.back(), x + length(), offset - advance()};
    }
    if (i < 0 || i >= count) {
      return {nullptr, x, i < 0 ? first : last};
    }
    return {&law.pieces[i], x, offset};
  }

  // Calls visit(piece, from, to, offset, shift) for every piece between two coordinates, in order; from and
  // to are in the first repetition, and the actual coordinates are greater by shift. No piece: the law is
  // constant.
  template <class Visit>
  void for_each_piece(double from, double to, const Visit& visit) const {
    const std::size_t count = law.pieces.size();
    const auto visit_turn = [&](double turn) {
      const double shift = turn * length();
      for (std::size_t i = 0; i < count; ++i) {
        const double low = std::max(from - shift, law.begins[i]);
        const double high = std::min(to - shift, law.begins[i + 1]);
        if (low <= high) {
          visit(&law.pieces[i], low, high, turn * advance(), shift);
        }
      }
    };
    if (repeats) {
      const double last_turn = std::floor((to - begin()) / length());
      for (double turn = std::floor((from - begin()) / length()); turn <= last_turn; ++turn) {
        visit_turn(turn);
      }
      return;
    }
    if (from < begin()) {
      visit(static_cast<const LawPiece*>(nullptr), from, std::min(to, begin()), first, 0.0);
    }
    visit_turn(0);
    if (to > end()) {
      visit(static_cast<const LawPiece*>(nullptr), std::max(from, end()), to, last, 0.0);
    }
  }

  [[nodiscard]] std::vector<double> places(int k, double from, double to, double level) const;

  // A bound of the absolute value of the k-th derivative over the whole law; infinite if it overflows.
  [[nodiscard]] double size(int k) const {
    double largest = 0;
    for (std::size_t i = 0; i < law.pieces.size(); ++i) {
      const Bounds own = law.bounds(law.pieces[i], k, law.begins[i], law.begins[i + 1]);
      if (!std::isfinite(own.width())) {
        return kInf;
      }
      largest = std::max({largest, -own.low, own.high});
    }
    return largest;
  }
};

}  // namespace higherpair

#pragma once

#include "higherpair/cam/motion_law.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace higherpair {

/// cosine cos(frequency t) + sine sin(frequency t).
struct LawWave {
  double cosine = 0;
  double sine = 0;
  double frequency = 0;
};

/// What may change where a piece begins.
enum class PieceStart : std::uint8_t {
  kSegment,  ///< a segment begins
  kPart,     ///< within a segment, where acceleration or jerk may jump
  kKnot,     ///< knot of a spline: a derivative higher than the jerk may jump, in a cubic one the jerk
  kSmooth,   ///< the same function continues, expanded about another place
};

/// A stretch of a law:  s = base + Σ c_k tᵏ + Σ waves,  t = x - origin. The origin is the end of the stretch
/// at which the law comes to rest, so that rest is exact there.
struct LawPiece {
  double begin = 0;
  double origin = 0;
  double base = 0;
  std::uint32_t first_power = 0;  ///< index into LawPieces::powers, from t⁰
  std::uint32_t powers = 0;
  std::uint32_t first_wave = 0;
  std::uint32_t waves = 0;
  PieceStart start = PieceStart::kSegment;
};

/// All pieces of a law. They share their storage.
struct LawPieces {
  std::vector<LawPiece> pieces;
  std::vector<double> begins;  ///< of the pieces, and the end of the last
  std::vector<double> powers;
  std::vector<LawWave> waves;

  /// Appends a piece; set_end ends the last one.
  void add(LawPiece piece, std::span<const double> c, std::span<const LawWave> own_waves);
  void set_end(double x) { begins.push_back(x); }

  /// Taylor coefficients of a piece at x.
  void expand(const LawPiece& piece, double x, std::span<double> out) const;
  [[nodiscard]] double derivative(const LawPiece& piece, int k, double x) const;
  /// Bounds of the k-th derivative of a piece from x = from to x = to.
  [[nodiscard]] Bounds bounds(const LawPiece& piece, int k, double from, double to) const;
  /// Whether the k-th derivative vanishes throughout.
  [[nodiscard]] bool vanishes(const LawPiece& piece, int k) const;
};

/// Adds the pieces of a segment that begins at `begin` with `value` and ends at `end`; returns its last
/// value.
/// \pre the segment has been checked
double add_segment(const LawSegment& segment, double begin, double end, double value, LawPieces& pieces);

/// The same for all points of a spline. \pre they have been checked
void add_spline(const LawDescription& description, LawPieces& pieces);

}  // namespace higherpair

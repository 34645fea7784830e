#pragma once

#include "higherpair/geometry/vector.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace higherpair {

/// How a segment of a motion law goes from its first value to its last; docs/laws.md has the formulas.
enum class LawType {
  kDwell,              ///< stays
  kUniform,            ///< constant velocity
  kParabolic,          ///< constant acceleration, then the same deceleration
  kHarmonic,           ///< half a wave of a cosine
  kCycloidal,          ///< acceleration: a whole wave of a sine
  kModifiedSine,       ///< acceleration: quarter waves of a short and a long sine
  kModifiedTrapezoid,  ///< acceleration: a trapezoid with quarter waves for its slopes
  kPolynomial345,      ///< v and a vanish at both ends
  kPolynomial4567,     ///< v, a and j vanish at both ends
  kPolynomial,         ///< of the lowest degree that has the values and derivatives in `start` and `end`
  kHarmonics,          ///< a straight line and a sum of whole waves
};

/// The names of the laws in profiles, in the order of LawType.
inline constexpr std::array<std::string_view, 11> kLawNames = {
    "dwell",           "uniform",       "parabolic",          "harmonic",
    "cycloidal",       "modified-sine", "modified-trapezoid", "polynomial-345",
    "polynomial-4567", "polynomial",    "harmonics",
};

/// A segment of a motion law. With u = 0 … 1 over the segment, `harmonics` is
///     s = s₀ + rise u + Σ cosines[k-1] (cos 2πku - 1) + sines[k-1] sin 2πku,   k = 1, 2, …
struct LawSegment {
  LawType type = LawType::kDwell;
  double over = 0;              ///< its length in the coordinate; > 0
  double rise = 0;              ///< last value less first; of a polynomial `start` and `end` give it
  std::vector<double> start{};  ///< of a polynomial: value, first derivative, second …; the value is absolute
  std::vector<double> end{};
  std::vector<double> cosines{};  ///< of `harmonics`
  std::vector<double> sines{};
};

/// What a spline does beyond its first and last point.
enum class SplineEnds { kNatural, kPeriodic };

/// A motion law as its user describes it: plain data, a function s of one coordinate x, in any units that go
/// together (SI units and radians in a Mechanism). Either segments one after the other, or a spline through
/// points.
struct LawDescription {
  double origin = 0;  ///< coordinate at which the first segment begins
  double start = 0;   ///< value there; of a polynomial its own counts
  std::vector<LawSegment> segments{};
  std::vector<Vector2d> points{};  ///< (x, s) in ascending order of x
  int degree = 5;                  ///< of the spline: 3 or 5
  SplineEnds ends = SplineEnds::kNatural;
  double period = 0;     ///< of a periodic spline; 0: the last point is the first, a period on
  double smoothing = 0;  ///< no point is left by more than this; 0: the spline goes through them
  /// Whether it goes on in the same way before and after. Where it ends higher than it began, every
  /// repetition begins higher.
  bool repeats = false;
};

}  // namespace higherpair

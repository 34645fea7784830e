#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// How a segment of a motion law goes from its first value to its last; docs/laws.md has the formulas.
enum class LawType {
  kDwell,              ///< constant
  kUniform,            ///< constant velocity
  kParabolic,          ///< constant acceleration, then the same deceleration
  kHarmonic,           ///< half a wave of a cosine
  kCycloidal,          ///< acceleration: one full sine wave
  kModifiedSine,       ///< acceleration: quarter waves of a short and a long sine
  kModifiedTrapezoid,  ///< acceleration: a trapezoid whose ramps are quarter sine waves
  kPolynomial345,      ///< v and a vanish at both ends
  kPolynomial4567,     ///< v, a and j vanish at both ends
  kPolynomial,         ///< of the lowest degree with the values and derivatives in `start` and `end`
  kHarmonics,          ///< a straight line plus a sum of harmonics
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
  double over = 0;  ///< length of the segment in x; > 0
  double rise = 0;  ///< last value minus the first; for a polynomial it follows from `start` and `end`
  std::vector<double> start{};  ///< polynomial only: value (absolute), first derivative, second …
  std::vector<double> end{};
  std::vector<double> cosines{};  ///< `harmonics` only
  std::vector<double> sines{};
};

/// End conditions of a spline.
enum class SplineEnds { kNatural, kPeriodic };

/// A motion law as its user describes it: plain data for a function s of one coordinate x, in any consistent
/// units (SI units and radians in a Mechanism). Either consecutive segments, or a spline through points.
struct LawDescription {
  double origin = 0;  ///< coordinate at which the first segment begins
  double start = 0;   ///< value there; a polynomial as first segment has its own
  std::vector<LawSegment> segments{};
  std::vector<Vector2d> points{};  ///< (x, s) in ascending order of x
  int degree = 5;                  ///< of the spline: 3 or 5
  SplineEnds ends = SplineEnds::kNatural;
  double period = 0;     ///< of a periodic spline; 0: the last point repeats the first one a period later
  double smoothing = 0;  ///< how far the spline may miss a point; 0: it passes through all of them
  /// Whether the law repeats before its beginning and after its end. If it ends higher than it begins, every
  /// repetition begins higher.
  bool repeats = false;
};

/// Which of two pieces that meet at a coordinate is evaluated.
enum class LawSide { kBefore, kAfter };

/// What is wrong with a description: "KEY: rule".
struct LawFault {
  std::optional<std::size_t> segment;  ///< index of the segment with the mistake
  std::optional<std::size_t> point;    ///< the same for a point of a spline
  std::string key;                     ///< "over", "start", …; empty: the law as a whole
  std::string rule;                    ///< the end of a sentence about it
};

/// Where two pieces of a law meet: the ends of segments, and points within them at which v, a or j jumps.
struct LawJoin {
  double x = 0;
  std::array<double, 4> before{};  ///< s, v, a, j: derivatives with respect to x
  std::array<double, 4> after{};
  std::array<bool, 4> is_jump{};  ///< whether they differ by more than rounding

  [[nodiscard]] bool jumps(std::size_t k) const { return is_jump[k]; }
  /// Order of the lowest derivative that jumps: 1, 2, 3 for v, a, j; 0: none jumps.
  [[nodiscard]] int lowest_jump() const { return is_jump[1] ? 1 : is_jump[2] ? 2 : is_jump[3] ? 3 : 0; }
};

/// Smallest and largest value of a derivative, and where it has them (at one place, if there are several).
struct LawExtremes {
  double least = 0;
  double least_at = 0;
  double greatest = 0;
  double greatest_at = 0;

  /// The one of larger absolute value, with its sign.
  [[nodiscard]] double peak() const { return -least > greatest ? least : greatest; }
};

/// A motion law s(x): piecewise polynomials and sine waves, with every derivative exact to within rounding.
/// Its units are those of the description. An immutable value, cheap to copy.
///
/// Outside of its pieces a law that does not repeat keeps its first or last value. A coordinate within
/// rounding of the joint of two pieces (8 units in the last place of the largest of x and the ends) counts as
/// the joint.
///
/// The functions of an interval need from <= to, both finite. Of a law that repeats they visit every
/// repetition in it, one after the other.
class MotionLaw {
public:
  [[nodiscard]] static tl::expected<MotionLaw, LawFault> make(const LawDescription& description);

  /// Where the first piece begins and the last one ends.
  [[nodiscard]] double begin() const;
  [[nodiscard]] double end() const;
  [[nodiscard]] bool repeats() const;
  /// By how much it ends higher than it begins.
  [[nodiscard]] double advance() const;
  /// The same law with `count` of its repetitions, from begin() on, as its pieces. \pre repeats(), count >= 1
  [[nodiscard]] MotionLaw repeated(int count) const;

  /// Taylor coefficients at x: out[k] = (1/k!) dᵏs/dxᵏ.
  void expand(double x, LawSide side, std::span<double> out) const;

  /// dᵏs/dxᵏ; k = 0: s itself.
  [[nodiscard]] double derivative(int k, double x, LawSide side = LawSide::kAfter) const;

  /// s itself.
  [[nodiscard]] double operator()(double x, LawSide side = LawSide::kAfter) const {
    return derivative(0, x, side);
  }

  /// Bounds of the k-th derivative between two coordinates, from <= to; at a jump they include both sides.
  /// They are rigorous, and their excess shrinks with the square of to - from.
  [[nodiscard]] Bounds bounds(int k, double from, double to) const;

  /// Smallest and largest value of the k-th derivative from begin() to end(), or between two coordinates:
  /// exact to within rounding. At a jump both sides count.
  [[nodiscard]] LawExtremes extremes(int k) const { return extremes(k, begin(), end()); }
  [[nodiscard]] LawExtremes extremes(int k, double from, double to) const;

  /// Where the k-th derivative is 0, or jumps across 0, between two coordinates, ascending; none from an
  /// interval in which it is 0 throughout. A zero without a change of sign may be returned as several close
  /// ones.
  [[nodiscard]] std::vector<double> zeros(int k, double from, double to) const;

  /// Where the law has a given value, in the same way.
  [[nodiscard]] std::vector<double> places(double value, double from, double to) const;

  /// The joins from begin() to end(), both included. There a law that does not repeat joins a constant value,
  /// and one that repeats joins its own other end.
  [[nodiscard]] const std::vector<LawJoin>& joins() const;

  /// Coordinates strictly between two given ones where one smooth function ends and another begins: joins,
  /// knots of a spline, and points at which only derivatives higher than the jerk jump.
  [[nodiscard]] std::vector<double> breaks(double from, double to) const;

  struct Data;

private:
  explicit MotionLaw(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  std::shared_ptr<const Data> data_;
};

}  // namespace higherpair

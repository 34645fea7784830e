#pragma once

#include "higherpair/geometry/curve.hpp"
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

/// Which of the two pieces that meet at a coordinate is meant.
enum class LawSide { kBefore, kAfter };

/// What is wrong with a description: "KEY: rule".
struct LawFault {
  std::optional<std::size_t> segment;  ///< the one with the mistake
  std::optional<std::size_t> point;    ///< the same of a spline
  std::string key;                     ///< "over", "start", …; empty: the law as a whole
  std::string rule;                    ///< the end of a sentence about it
};

/// Where two pieces of a law meet: the ends of segments, and places within them where v, a or j jumps.
struct LawJoin {
  double x = 0;
  std::array<double, 4> before{};  ///< s, v, a, j: derivatives by the coordinate
  std::array<double, 4> after{};
  std::array<bool, 4> is_jump{};  ///< whether they differ by more than rounding

  [[nodiscard]] bool jumps(std::size_t k) const { return is_jump[k]; }
  /// 1, 2, 3: v, a, j is the first that jumps; 0: none does.
  [[nodiscard]] int lowest_jump() const { return is_jump[1] ? 1 : is_jump[2] ? 2 : is_jump[3] ? 3 : 0; }
};

/// Smallest and largest value of a derivative, and where; of several places one.
struct LawExtremes {
  double least = 0;
  double least_at = 0;
  double greatest = 0;
  double greatest_at = 0;

  /// The larger of the two by size, with its sign.
  [[nodiscard]] double peak() const { return -least > greatest ? least : greatest; }
};

/// A motion law s(x): polynomials and sine waves piece by piece, of which every derivative is exact but for
/// rounding. Its units are those of the description. An immutable value, cheap to copy.
///
/// Outside of its pieces a law that does not repeat stays at its first or last value. A coordinate within
/// rounding of where two pieces meet (8 units in the last place of the largest of x and the ends) is there.
class MotionLaw {
public:
  [[nodiscard]] static tl::expected<MotionLaw, LawFault> make(const LawDescription& description);

  /// Where the first piece begins and the last one ends.
  [[nodiscard]] double begin() const;
  [[nodiscard]] double end() const;
  [[nodiscard]] bool repeats() const;
  /// By how much it ends higher than it begins.
  [[nodiscard]] double advance() const;

  /// Taylor coefficients at x: out[k] = (1/k!) dᵏs/dxᵏ.
  void expand(double x, LawSide side, std::span<double> out) const;

  /// dᵏs/dxᵏ; k = 0: s itself.
  [[nodiscard]] double derivative(int k, double x, LawSide side = LawSide::kAfter) const;

  /// s itself.
  [[nodiscard]] double operator()(double x, LawSide side = LawSide::kAfter) const {
    return derivative(0, x, side);
  }

  /// Bounds of the k-th derivative between two coordinates, from <= to; where it jumps, of both sides. They
  /// hold, and close up on the values with the square of to - from.
  [[nodiscard]] Bounds bounds(int k, double from, double to) const;

  /// Smallest and largest value of the k-th derivative from begin() to end(), or between two coordinates:
  /// exact but for rounding. Where it jumps, of both sides.
  [[nodiscard]] LawExtremes extremes(int k) const { return extremes(k, begin(), end()); }
  [[nodiscard]] LawExtremes extremes(int k, double from, double to) const;

  /// Where the k-th derivative is 0 between two coordinates or jumps over 0, ascending; none of a stretch in
  /// which it is 0 throughout. A zero that it touches without passing may come as several that are close.
  [[nodiscard]] std::vector<double> zeros(int k, double from, double to) const;

  /// Where the law has a value, in the same way.
  [[nodiscard]] std::vector<double> places(double value, double from, double to) const;

  /// From the begin to the end, both included: beyond the ends of a law that does not repeat it stays, and
  /// the end of one that does is followed by its begin.
  [[nodiscard]] const std::vector<LawJoin>& joins() const;

  /// Strictly between two coordinates, where one smooth function ends and another begins: joins, knots of a
  /// spline, and places where only higher derivatives than the jerk jump.
  [[nodiscard]] std::vector<double> breaks(double from, double to) const;

  struct Data;

private:
  explicit MotionLaw(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  std::shared_ptr<const Data> data_;
};

}  // namespace higherpair

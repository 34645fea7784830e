#pragma once

#include "higherpair/cam/motion_law.hpp"
#include "numeric/peaks.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace higherpair {

/// A law and its first two derivatives with respect to its coordinate.
struct Lift {
  double s = 0, v = 0, a = 0;
};

/// A function of the place on a law, with the derivatives of the law on one side of it. A NaN, or an
/// infinity, means that it is not defined there.
using LawFunction = std::function<double(double x, LawSide side)>;

/// Searches a stretch of a law for the largest values of functions of its value, velocity and acceleration.
/// The stretch is divided where the law is not smooth and where one of these three turns round: between
/// neighbouring places all three are monotonic, so that a few samples show every peak, however fast the law
/// oscillates.
class LawSearch {
public:
  LawSearch(const MotionLaw& law, double from, double to);
  explicit LawSearch(const MotionLaw& law) : LawSearch(law, law.begin(), law.end()) {}

  /// The ends of the stretch and the places that divide it, ascending.
  [[nodiscard]] const std::vector<double>& places() const { return places_; }

  /// The largest value, to within rounding; both sides count at jumps. Places where the function is not
  /// defined are ignored; none if there are no others.
  [[nodiscard]] std::optional<Peak> largest(const LawFunction& f) const;

  /// The first place from which on a function is at least `level`, or not defined.
  [[nodiscard]] std::optional<double> first_above(double level, const LawFunction& f) const;

private:
  struct Samples {
    std::vector<double> at, values;
  };
  [[nodiscard]] Samples sampled(std::size_t interval, const LawFunction& f) const;
  [[nodiscard]] PeakLimits limits() const;

  std::vector<double> places_;
  std::size_t parts_ = 1;  // of an interval between two places
};

/// Where a function of the lift is largest.
struct Worst {
  Peak peak;
  Lift lift;
};

/// Over the whole law that `search` covers, as LawSearch::largest; -inf if it is nowhere defined.
[[nodiscard]] Worst worst_of(const MotionLaw& law, const LawSearch& search,
                             const std::function<double(const Lift&)>& f);

}  // namespace higherpair

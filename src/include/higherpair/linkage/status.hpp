#pragma once

#include "higherpair/numeric/scalar.hpp"

namespace higherpair {

/// Which of the two assemblies of a linkage; the sign of its square root. Each linkage defines what it means
/// geometrically.
enum class AssemblyMode { kPlus = 1, kMinus = -1 };

/// The mode as a factor in the kernels.
[[nodiscard]] constexpr double sign(AssemblyMode mode) {
  return mode == AssemblyMode::kPlus ? 1.0 : -1.0;
}

/// Outcome of a position. `slack` and `noise` are those of `Reach`.
enum class LinkageStatus {
  kNotAssemblable,  ///< slack < -noise: the links cannot meet; all values of the result are meaningless
  kSingular,  ///< |slack| <= noise: a dead point to within rounding; the position is valid, rates do not
              ///< exist
  kOk,        ///< slack > noise: position and rates are valid
};

/// Distance of a linkage from the position in which its links only just meet.
///
/// With a, b the two links that close it and γ the angle between them, sin² γ = stretch·fold/(2ab)²: stretch
/// = (a+b)² - d² vanishes where the two are in line and point the same way, fold = d² - (a-b)² where they are
/// folded onto each other. (Where one of them is a slide, its header defines the two.)
template <class T>
struct Reach {
  T stretch{0};
  T fold{0};
  T noise{0};  ///< rounding error of either, in the same unit

  [[nodiscard]] T slack() const { return select(stretch < fold, stretch, fold); }
};

/// A slack that is not a number counts as not assemblable.
[[nodiscard]] constexpr LinkageStatus status_of(double slack, double noise) {
  if (slack > noise) return LinkageStatus::kOk;
  return slack >= -noise ? LinkageStatus::kSingular : LinkageStatus::kNotAssemblable;
}

/// Of the smaller slack of the two.
[[nodiscard]] inline LinkageStatus status_of(const Reach<double>& reach) {
  return status_of(reach.slack(), reach.noise);
}

}  // namespace higherpair

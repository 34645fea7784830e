#pragma once

#include "higherpair/geometry/scalar.hpp"

namespace higherpair {

/// Which of the two ways in which a linkage can be closed; the sign in front of its square root. Each linkage
/// says what it looks like.
enum class AssemblyMode { kPlus = 1, kMinus = -1 };

/// The mode as a factor of the kernels.
[[nodiscard]] constexpr double sign(AssemblyMode mode) {
  return mode == AssemblyMode::kPlus ? 1.0 : -1.0;
}

/// How a position came out. `slack` and `noise` are those of `Reach`.
enum class LinkageStatus {
  kNotAssemblable,  ///< slack < -noise: the links cannot meet; no value of the result means anything
  kSingular,  ///< |slack| <= noise: a dead point to within rounding; the position holds, rates do not exist
  kOk,        ///< slack > noise: position and rates hold
};

/// How far a linkage is from the position in which its links only just meet.
///
/// With a, b the two links that close it and γ the angle between them, sin² γ = stretch·fold/(2ab)²:
/// stretch = (a+b)² - d² runs out where the two are in line and point the same way, fold = d² - (a-b)² where
/// they lie on each other. (Where one of them is a slide, its header says what the two are.)
template <class T>
struct Reach {
  T stretch{0};
  T fold{0};
  T noise{0};  ///< rounding of either, in the same unit

  [[nodiscard]] T slack() const { return select(stretch < fold, stretch, fold); }
};

/// A slack that is not a number counts as not assemblable.
[[nodiscard]] constexpr LinkageStatus status_of(double slack, double noise) {
  if (slack > noise) return LinkageStatus::kOk;
  return slack >= -noise ? LinkageStatus::kSingular : LinkageStatus::kNotAssemblable;
}

[[nodiscard]] inline LinkageStatus status_of(const Reach<double>& reach) {
  return status_of(reach.slack(), reach.noise);
}

}  // namespace higherpair

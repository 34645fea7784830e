#include "fit_loss.hpp"

#include "higherpair/front/fit.hpp"

#include <cmath>

namespace higherpair {
namespace {

// Tuning constants for 95 % efficiency with normal noise.
constexpr double kHuberBend = 1.345;

}  // namespace

double weight_of(FitLoss loss, double u) {
  const double size = std::abs(u);
  switch (loss) {
    case FitLoss::kHuber:
      return size <= kHuberBend ? 1 : kHuberBend / size;
    case FitLoss::kTukey:
      return size < kOutlierDeviations ? std::pow(1 - u * u / (kOutlierDeviations * kOutlierDeviations), 2)
                                       : 0;
    case FitLoss::kSquares:
      break;
  }
  return 1;
}

double slope_of(FitLoss loss, double u) {
  const double size = std::abs(u);
  switch (loss) {
    case FitLoss::kHuber:
      return size <= kHuberBend ? 1 : 0;
    case FitLoss::kTukey: {
      const double share = u * u / (kOutlierDeviations * kOutlierDeviations);
      return size < kOutlierDeviations ? (1 - share) * (1 - 5 * share) : 0;
    }
    case FitLoss::kSquares:
      break;
  }
  return 1;
}

}  // namespace higherpair

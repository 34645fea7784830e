#include "common_normals.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

double curvature_of(double rho) {
  return std::isinf(rho) ? 0 : 1 / rho;
}

}  // namespace

CommonNormals common_normals(const PlacedCurve<double>& curve1, const PlacedCurve<double>& curve2) {
  const std::optional<NormalArc> normals1 = normals_of(curve1);
  std::optional<NormalArc> normals2 = normals_of(curve2);
  if (normals2) {
    normals2->middle += kPi;
  }
  CommonNormals common;
  common.arc = normals1 ? normals1 : normals2;
  if (normals1 && normals2) {
    const double shift = nearest_turn(normals2->middle, normals1->middle) - normals1->middle;
    const double low = std::max(-normals1->half, shift - normals2->half);
    const double high = std::min(normals1->half, shift + normals2->half);
    common.arc = NormalArc{normals1->middle + (low + high) / 2, (high - low) / 2};
    common.empty = !(low < high);
  }
  const bool ring1 = curve1.side < 0;
  if (ring1 || curve2.side < 0) {
    const std::optional<NormalArc>& of_ring = ring1 ? normals1 : normals2;
    const std::optional<NormalArc>& of_body = ring1 ? normals2 : normals1;
    const double wanted = of_ring ? of_ring->half : kPi;
    common.cover_ring =
        !common.empty && (!of_body || (common.arc && common.arc->half >= wanted * (1 - kFineGap)));
  }
  return common;
}

bool is_least_gap(const CommonNormal& at) {
  const double g = at.gap();
  if (at.rho1 == 0 || at.rho2 == 0) {
    return 1 + g * curvature_of(at.rho1 == 0 ? at.rho2 : at.rho1) > 0;
  }
  const double kappa1 = curvature_of(at.rho1);
  const double kappa2 = curvature_of(at.rho2);
  return kappa1 + kappa2 + g * kappa1 * kappa2 > 0;
}

}  // namespace higherpair

// Compiled for the machine at hand (-march=native) and its widest registers.
#include "numeric/arctangent.hpp"
#include "numeric/pack.hpp"
#include "variants.hpp"

#include <cmath>
#include <limits>

namespace higherpair::bench {
namespace {

#if defined(__AVX512F__)
using Rows = Pack<8>;
constexpr std::size_t kWidth = 8;
#elif defined(__AVX2__)
using Rows = Pack<4>;
constexpr std::size_t kWidth = 4;
#else
using Rows = Pack<2>;
constexpr std::size_t kWidth = 2;
#endif
static_assert(kVariantPositions % kWidth == 0);

}  // namespace

[[gnu::flatten]] ByHandResults variant_by_hand(const FourBarLengths& bar, const DriverTable& driver,
                                               double speed) {
  const Rows ground(bar.ground), crank(bar.crank), square(bar.coupler * bar.coupler);
  const Rows inv_coupler(1 / bar.coupler), along(bar.along), across(bar.across);
  const Rows difference((bar.coupler - bar.rocker) * (bar.coupler + bar.rocker));
  const Rows zero(0.0), half(0.5), rate(speed * bar.crank), turn(2 * kPi);
  Rows highest[3] = {Rows(-std::numeric_limits<double>::infinity()),
                     Rows(-std::numeric_limits<double>::infinity()),
                     Rows(-std::numeric_limits<double>::infinity())};
  Rows lowest[3] = {Rows(INFINITY), Rows(INFINITY), Rows(INFINITY)};
  Rows first = zero;
  for (std::size_t k = 0; k < kVariantPositions; k += kWidth) {
    const Rows c = Rows::load(&driver.cosine[k]);
    const Rows s = Rows::load(&driver.sine[k]);
    const Rows dx = ground - crank * c;
    const Rows dy = zero - crank * s;
    const Rows inv_d2 = Rows(1.0) / (dx * dx + dy * dy);
    const Rows on = half + half * difference * inv_d2;
    const Rows off = sqrt(square * inv_d2 - on * on);
    const Rows bx = on * dx + off * dy;  // coupler
    const Rows by = on * dy - off * dx;
    const Rows rx = bx - dx;  // rocker
    const Rows ry = by - dy;
    Rows angle = arctangent(ry, rx);
    first = k == 0 ? Rows(angle.lanes[0]) : first;
    angle = select(angle < first, angle + turn, angle);  // it turns once
    const Rows omega = rate * (bx * s - by * c) / (bx * ry - by * rx);
    const Rows height = crank * s + (by * along + bx * across) * inv_coupler;
    const Rows values[3] = {angle, omega, height};
    for (std::size_t i = 0; i < 3; ++i) {
      highest[i] = max(highest[i], values[i]);
      lowest[i] = select(values[i] < lowest[i], values[i], lowest[i]);
    }
  }
  ByHandResults results{};
  for (std::size_t i = 0; i < 3; ++i) {
    results.highest[i] = largest_lane(highest[i]);
    results.lowest[i] = -largest_lane(-lowest[i]);
  }
  return results;
}

}  // namespace higherpair::bench

#include "vector_floor.hpp"

#include <cstddef>

namespace higherpair::bench {
namespace {

struct Arrays {
  const double* cosines;
  const double* sines;
  double* outputs[VectorFourBar::kOutputs];
};

// The compiler vectorises the loop for each of these instruction sets, and the program selects the best at
// run time.
#if defined(__x86_64__)
__attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif
void work_out(const FourBarByHand& bar, const Arrays& arrays, std::size_t count) {
  const double* __restrict cosines = arrays.cosines;
  const double* __restrict sines = arrays.sines;
  double* __restrict cos3 = arrays.outputs[VectorFourBar::kCos3];
  double* __restrict sin3 = arrays.outputs[VectorFourBar::kSin3];
  double* __restrict cos4 = arrays.outputs[VectorFourBar::kCos4];
  double* __restrict sin4 = arrays.outputs[VectorFourBar::kSin4];
  double* __restrict omega3 = arrays.outputs[VectorFourBar::kOmega3];
  double* __restrict omega4 = arrays.outputs[VectorFourBar::kOmega4];
  double* __restrict alpha3 = arrays.outputs[VectorFourBar::kAlpha3];
  double* __restrict alpha4 = arrays.outputs[VectorFourBar::kAlpha4];
  const double r1 = bar.r1, r2 = bar.r2, r3 = bar.r3, sigma = bar.sigma;
  const double difference = bar.r3 * bar.r3 - bar.r4 * bar.r4;
  const double per_r3 = 1 / bar.r3, per_r4 = 1 / bar.r4;
  const double cc = bar.r4 * bar.r4;
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
  for (std::size_t k = 0; k < count; ++k) {
    const double ax = r2 * cosines[k];
    const double ay = r2 * sines[k];
    const double dx = r1 - ax;
    const double dy = -ay;
    const double per_d2 = 1 / (dx * dx + dy * dy);
    const double along = 0.5 + 0.5 * difference * per_d2;
    const double across = sigma * __builtin_sqrt(r3 * r3 * per_d2 - along * along);
    const double bx = along * dx - across * dy;
    const double by = along * dy + across * dx;
    const double cx = bx - dx;
    const double cy = by - dy;
    const double per_det = 1 / (bx * cy - by * cx);
    const double w3 = (ay * cx - ax * cy) * per_det;
    const double w4 = (ay * bx - ax * by) * per_det;
    const double bc = bx * cx + by * cy;
    cos3[k] = bx * per_r3;
    sin3[k] = by * per_r3;
    cos4[k] = cx * per_r4;
    sin4[k] = cy * per_r4;
    omega3[k] = w3;
    omega4[k] = w4;
    alpha3[k] = (ax * cx + ay * cy + w3 * w3 * bc - w4 * w4 * cc) * per_det;
    alpha4[k] = (ax * bx + ay * by + w3 * w3 * (r3 * r3) - w4 * w4 * bc) * per_det;
  }
}

}  // namespace

VectorFourBar::VectorFourBar(const FourBarByHand& bar, const std::vector<double>& positions) : bar_(bar) {
  for (const double theta : positions) {
    cosines_.push_back(std::cos(theta));
    sines_.push_back(std::sin(theta));
  }
  for (std::vector<double>& output : outputs_) {
    output.resize(positions.size());
  }
}

void VectorFourBar::work_out() {
  Arrays arrays{cosines_.data(), sines_.data(), {}};
  for (int i = 0; i < kOutputs; ++i) {
    arrays.outputs[i] = outputs_[i].data();
  }
  bench::work_out(bar_, arrays, cosines_.size());
}

}  // namespace higherpair::bench

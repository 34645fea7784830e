#pragma once

#include "floor.hpp"

#include <vector>

namespace higherpair::bench {

/// The four-bar of floor.hpp at many positions, by unit vectors and without trigonometric functions, in the
/// vector registers of this machine: positions and rates of both links for a crank of unit speed, without any
/// checks. It is the standard of comparison for a row of a chain.
class VectorFourBar {
public:
  /// \param positions  angles of the crank [rad]
  VectorFourBar(const FourBarByHand& bar, const std::vector<double>& positions);

  void work_out();

  enum Output { kCos3, kSin3, kCos4, kSin4, kOmega3, kOmega4, kAlpha3, kAlpha4, kOutputs };
  [[nodiscard]] const std::vector<double>& output(Output which) const { return outputs_[which]; }

private:
  FourBarByHand bar_;
  std::vector<double> cosines_, sines_;
  std::vector<double> outputs_[kOutputs];
};

}  // namespace higherpair::bench

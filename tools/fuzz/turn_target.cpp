// Like motion_target, through a whole turn in long steps: composite cams pass their joints and corners,
// contacts open and close.
#include "short_motion.hpp"
#include "target.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  higherpair::fuzz::run_short_motion(data, size, {8, 0.93, false});
  return 0;
}

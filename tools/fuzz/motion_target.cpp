// Every text that reads as a mechanism starts or gives a reason why not, and moves by a few small steps: its
// rows are finite, and those that are ok satisfy closure.
#include "short_motion.hpp"
#include "target.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  higherpair::fuzz::run_short_motion(data, size, {});
  return 0;
}

// Compiled for AVX2. Everything is inlined: a function that is not would be AVX2 code under a
// name that other sources use.
#include "chain_loop.hpp"

namespace higherpair {

[[gnu::flatten]] void fill_by_4(const ChainRowsJob& job) {
  chain_loop::fill<PackPair<4>>(job);
}

}  // namespace higherpair

// Compiled for AVX-512. Everything is inlined: a function that is not would be AVX-512 code
// under a name that other sources use.
#include "chain_loop.hpp"

namespace higherpair {

[[gnu::flatten]] void fill_by_8(const ChainRowsJob& job) {
  chain_loop::fill<PackPair<8>>(job);
}

}  // namespace higherpair

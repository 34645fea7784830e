// Compiled for AVX-512. Whatever is not inlined would be code for AVX-512 under a name that others use:
// flatten.
#include "chain_loop.hpp"

namespace higherpair {

[[gnu::flatten]] void fill_by_8(const ChainRowsJob& job) {
  chain_loop::fill<PackPair<8>>(job);
}

}  // namespace higherpair

// Compiled for AVX2. Whatever is not inlined would be code for AVX2 under a name that others use: flatten.
#include "chain_loop.hpp"

namespace higherpair {

[[gnu::flatten]] void fill_by_4(const ChainRowsJob& job) {
  chain_loop::fill<PackPair<4>>(job);
}

}  // namespace higherpair

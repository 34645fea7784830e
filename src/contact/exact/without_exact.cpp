// For builds without CGAL, GMP and MPFR (HIGHERPAIR_EXACT=OFF).
#include "exact_decision.hpp"
#include "higherpair/contact/certify.hpp"

namespace higherpair {

bool has_exact_arithmetic() {
  return false;
}

std::optional<std::vector<DecidedRoot>> decide_roots(const ContactPair& /*pair*/, double /*u*/) {
  return std::nullopt;
}

}  // namespace higherpair

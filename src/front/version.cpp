#include "higherpair/front/version.hpp"

namespace higherpair {

std::string_view version() {
  return HIGHERPAIR_VERSION;
}

}  // namespace higherpair

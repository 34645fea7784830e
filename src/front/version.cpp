#include "higherpair/front/model.hpp"

namespace higherpair {

std::string_view version() {
  return HIGHERPAIR_VERSION;
}

}  // namespace higherpair

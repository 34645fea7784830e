// Replaces picture_rsvg.cpp in builds without librsvg or cairo.
#include "picture.hpp"

#include <stdexcept>

namespace higherpair::cli {

bool can_convert() {
  return false;
}

std::string pdf_of(const std::string& /*svg*/) {
  throw std::logic_error("no librsvg");
}

std::string png_of(const std::string& /*svg*/) {
  throw std::logic_error("no librsvg");
}

}  // namespace higherpair::cli

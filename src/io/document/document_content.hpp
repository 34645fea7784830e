#pragma once

#include "document.hpp"
#include "higherpair/io/profile_document.hpp"

#include <string>
#include <vector>

namespace higherpair {

struct ProfileDocument::Content {
  io_detail::Value root;               ///< a table
  std::string text;                    ///< as given to the parser
  std::vector<std::string> overrides;  ///< applied so far
  std::vector<std::string> sources;    ///< what messages call the text and each override, by Mark::source
  std::vector<std::string> doubts;     ///< Overridden::doubt of each override
};

}  // namespace higherpair

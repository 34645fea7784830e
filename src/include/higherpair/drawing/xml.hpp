#pragma once

#include <string>
#include <string_view>

namespace higherpair {

/// Text between tags or quotes of XML or HTML: & < > " as entities, U+FFFD for control characters, which XML
/// cannot hold.
[[nodiscard]] std::string xml_escaped(std::string_view text);

}  // namespace higherpair

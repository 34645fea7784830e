#pragma once

#include <span>
#include <string>
#include <string_view>

namespace higherpair {

/// The words in one text, with a separator between neighbours.
[[nodiscard]] std::string joined_words(std::span<const std::string> words, std::string_view separator = ", ");

}  // namespace higherpair

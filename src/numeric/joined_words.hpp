#pragma once

#include <span>
#include <string>
#include <string_view>

namespace higherpair {

/// Words in one text, with a separator between each two.
[[nodiscard]] std::string joined_words(std::span<const std::string> words, std::string_view separator = ", ");

}  // namespace higherpair

#include "joined_words.hpp"

namespace higherpair {

std::string joined_words(std::span<const std::string> words, std::string_view separator) {
  std::string text;
  for (const std::string& word : words) {
    text += &word == words.data() ? "" : separator;
    text += word;
  }
  return text;
}

}  // namespace higherpair

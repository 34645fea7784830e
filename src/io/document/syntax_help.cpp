#include "syntax_help.hpp"

#include "higherpair/io/names.hpp"
#include "syntax_rules.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// `text` up to a comment, with quoted parts replaced by blanks.
std::string without_strings(std::string_view text) {
  std::string bare;
  char quote = 0;
  for (const char c : text) {
    if (quote == 0 && c == '#') {
      break;
    }
    const bool is_quote = c == '"' || c == '\'';
    bare += quote == 0 && !is_quote ? c : ' ';
    quote = is_quote && (quote == 0 || quote == c) ? (quote == 0 ? c : char{0}) : quote;
  }
  return bare;
}

// What to write instead of a character that word processors and web pages have; empty for any other.
std::string keyboard_advice(char32_t c, std::string_view text) {
  constexpr std::u32string_view kQuotes = U"“”„‟«»‘’‚‛′″‴`´＂＇";
  constexpr std::u32string_view kDashes = U"−–—‐‑‒―";
  if (kQuotes.find(c) != std::u32string_view::npos) {
    return fmt::format("{} is a typographic quotation mark, not the one of the keyboard; write the plain \"",
                       text);
  }
  if (kDashes.find(c) != std::u32string_view::npos) {
    return fmt::format("{} is a dash, not the minus sign of the keyboard; write the plain -", text);
  }
  if (c < 0x80 || !is_invisible(c)) {
    return "";
  }
  const bool is_blank =
      c == 0xA0 || (c >= 0x2000 && c <= 0x200A) || c == 0x202F || c == 0x205F || c == 0x3000;
  const bool is_line_end = c == 0x85 || c == 0x2028 || c == 0x2029;
  return fmt::format("the {} here (U+{:04X}) is {}",
                     is_blank      ? "blank"
                     : is_line_end ? "line end"
                                   : "invisible character",
                     static_cast<unsigned>(c),
                     is_blank      ? "not an ordinary one: replace it by a space"
                     : is_line_end ? "not an ordinary one: begin a new line instead"
                                   : "out of place: remove it");
}

Finding typographic_character(const SyntaxScan& scan) {
  const std::size_t begin = scan.quote.value_or(scan.token);
  const std::string_view line = scan.line_from(std::min(begin, scan.text.size()));
  const std::string bare = scan.quote ? std::string(line) : without_strings(line);
  for (std::size_t i = 0; i < bare.size();) {
    const std::string_view rest = line.substr(i);
    const std::size_t length = std::max<std::size_t>(character_length(rest), 1);
    const char32_t c = length > 1 ? character_at(rest) : static_cast<unsigned char>(rest[0]);
    if (std::string advice = keyboard_advice(c, rest.substr(0, length)); !advice.empty()) {
      return Found{begin + i, std::move(advice)};
    }
    i += length;
  }
  return std::nullopt;
}

Finding string_mistake(const SyntaxScan& scan, std::string_view message) {
  if (!scan.quote) {
    return std::nullopt;
  }
  const char quote = scan.text[*scan.quote];
  if (contains_text(message, "unknown escape") || contains_text(message, "hex digit")) {
    return Found{
        *scan.quote,
        "a backslash begins an escape within \"…\": write it twice, or the text in single quotes '…'"};
  }
  if (scan.text.substr(*scan.quote).starts_with(std::string(3, quote))) {
    return Found{*scan.quote, fmt::format("this text in {0}{0}{0} is not closed", quote)};
  }
  if (scan.stop < scan.text.size() && scan.text[scan.stop] != '\n' && scan.text[scan.stop] != '\r') {
    return Found{scan.stop, "a control character within a text"};
  }
  return Found{*scan.quote,
               fmt::format("the closing quotation mark {} of this text is missing on its line", quote)};
}

Finding line_end_mistake(const SyntaxScan& scan, std::string_view message) {
  return contains_text(message, "after '\\r'")
             ? Finding({scan.stop,
                        "a line ends with a carriage return alone: save the file with LF or CR LF line ends"})
             : std::nullopt;
}

// Lines that a profile has around it on a web page or in a chat.
Finding markdown_fence(const SyntaxScan& scan) {
  const std::size_t at = std::min(scan.token, scan.text.size());
  return scan.expecting == Expecting::kKey && scan.line_from(at).starts_with("```")
             ? Finding({at, "leave the lines ``` out, they are Markdown"})
             : std::nullopt;
}

// An odd number of quotation marks in the line: the word at the stop probably belongs to a string.
Finding missing_quote(const SyntaxScan& scan) {
  if (!scan.after_value || scan.in_table()) {
    return std::nullopt;
  }
  const std::string_view line = scan.line_from(scan.text.substr(0, scan.stop).rfind('\n') + 1);
  if (std::count(line.begin(), line.end(), '"') % 2 == 0) {
    return std::nullopt;
  }
  const std::string_view word = word_of(scan.line_from(scan.stop));
  return Found{scan.stop, word.empty()
                              ? "there is a quotation mark \" too many here, or one is missing before"
                              : fmt::format("a quotation mark \" is missing in this line, before "
                                            "or after `{}`",
                                            shown(word))};
}

// The parser's message without its beginning, on one line: "Error while parsing decimal integer: expected
// digit, saw '/'".
std::string parsers_own(std::string_view message) {
  constexpr std::string_view kBeginning = "Error while parsing ";
  if (message.starts_with(kBeginning)) {
    message.remove_prefix(kBeginning.size());
  }
  std::string text;
  for (const char c : message) {
    text += c == '\n' ? "\\n" : c == '\r' ? "\\r" : std::string(1, c);
  }
  return "this is no TOML: " + text;
}

constexpr std::size_t kLongestShown = 40;  // bytes, plus those that complete the last character

}  // namespace

std::string shown(std::string_view text) {
  text = trimmed(text.substr(0, text.find('\n')));
  std::size_t length = 0;
  while (length < std::min(text.size(), kLongestShown)) {
    length += std::max<std::size_t>(character_length(text.substr(length)), 1);
  }
  return visible(text.substr(0, length)) + (length < text.size() ? "…" : "");
}

std::string_view word_of(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size() && (std::isalnum(static_cast<unsigned char>(text[length])) != 0 ||
                                  text[length] == '_' || text[length] == '-')) {
    ++length;
  }
  return text.substr(0, length);
}

bool begins_statement(std::string_view text) {
  static const std::regex kStatement(R"(\s*(\[\[?[A-Za-z_][\w.-]*\]|[A-Za-z_"][\w."-]*\s*=).*)");
  return std::regex_match(text.begin(), text.end(), kStatement);
}

Mistake explain_syntax(std::string_view text, const Mark& place, std::string_view message) {
  const SyntaxScan scan = scan_syntax(text, byte_at(text, place.line, place.column));
  Finding found = redefinition(scan, message);
  const auto otherwise = [&](Finding next) {
    if (!found) found = std::move(next);
  };
  otherwise(line_end_mistake(scan, message));
  otherwise(markdown_fence(scan));
  otherwise(typographic_character(scan));
  otherwise(string_mistake(scan, message));
  otherwise(heading_mistake(scan, message));
  otherwise(missing_quote(scan));
  otherwise(unit_mistake(scan));
  otherwise(bracket_mistake(scan, message));
  otherwise(value_mistake(scan, message));
  otherwise(key_mistake(scan));
  return found ? Mistake{mark_at(text, found->at), found->message} : Mistake{place, parsers_own(message)};
}

}  // namespace higherpair::io_detail

// A profile's text with some of its numbers replaced.
#include "document_content.hpp"
#include "encoding.hpp"
#include "higherpair/io/profile_document.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include <fmt/core.h>

namespace higherpair {
namespace {

using io_detail::Mark;
using io_detail::Table;

struct Edit {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
};

// The byte offset of a mark of the file itself. Marks do not count the byte order mark.
std::optional<std::size_t> offset_of(std::string_view text, const Mark& mark) {
  if (mark.source != 0) return std::nullopt;
  const std::string_view content = io_detail::without_bom(text);
  const std::size_t at = io_detail::byte_at(content, mark.line, mark.column);
  return at < content.size() ? std::optional(text.size() - content.size() + at) : std::nullopt;
}

std::size_t end_of_number(std::string_view text, std::size_t begin) {
  const auto of_number = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '+' ||
           c == '-' || c == '.' || c == '_';
  };
  while (begin < text.size() && of_number(text[begin])) ++begin;
  return begin;
}

// The end of the text from `{` to its `}`. Within a pose braces occur only in quoted strings.
std::optional<std::size_t> end_of_braces(std::string_view text, std::size_t begin) {
  if (begin >= text.size() || text[begin] != '{') return std::nullopt;
  char quote = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    if (quote != 0) {
      quote = text[i] == quote ? '\0' : quote;
    } else if (text[i] == '"' || text[i] == '\'') {
      quote = text[i];
    } else if (text[i] == '}') {
      return i + 1;
    }
  }
  return std::nullopt;
}

// Adds the missing pose at `path` to a body whose table has a heading [bodies.NAME] on a line of its own.
std::optional<Edit> new_pose(const Table& root, std::string_view text, std::string_view path,
                             const std::string& value) {
  const std::string_view body = path.substr(0, path.rfind('.'));
  const io_detail::PathEnd found = io_detail::end_of_path(root, body);
  const auto at = found.value == nullptr || found.entry == nullptr ? std::nullopt
                                                                   : offset_of(text, found.entry->key_mark);
  if (!at) return std::nullopt;
  const std::size_t line = text.rfind('\n', *at) == std::string_view::npos ? 0 : text.rfind('\n', *at) + 1;
  const std::size_t first = text.find_first_not_of(" \t", line);
  const std::size_t end = text.find('\n', *at);
  if (first == std::string_view::npos || text[first] != '[' || end == std::string_view::npos)
    return std::nullopt;
  return Edit{end + 1, end + 1, fmt::format("pose = {}\n", value)};
}

std::optional<Edit> edit_of(const Table& root, std::string_view text,
                            const ProfileDocument::NewValue& value) {
  const io_detail::PathEnd found = io_detail::end_of_path(root, value.path);
  if (found.value == nullptr) {
    return value.path.ends_with(".pose") ? new_pose(root, text, value.path, value.text) : std::nullopt;
  }
  const auto begin = offset_of(text, found.value->mark);
  if (!begin) return std::nullopt;
  if (io_detail::number_in(*found.value)) {
    const std::size_t end = end_of_number(text, *begin);
    return end > *begin ? std::optional(Edit{*begin, end, value.text}) : std::nullopt;
  }
  const auto end = end_of_braces(text, *begin);
  return end ? std::optional(Edit{*begin, *end, value.text}) : std::nullopt;
}

}  // namespace

tl::expected<std::string, std::string> ProfileDocument::text_with(std::span<const NewValue> values) const {
  const auto& root = std::get<Table>(content_->root.content);
  std::vector<Edit> edits;
  for (const NewValue& value : values) {
    const auto edit = edit_of(root, content_->text, value);
    if (!edit) {
      return tl::unexpected(fmt::format("{}: the text has no such value that could be replaced", value.path));
    }
    edits.push_back(*edit);
  }
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string text;
  std::size_t at = 0;
  for (const Edit& edit : edits) {
    text.append(content_->text, at, edit.begin - at);
    text += edit.text;
    at = std::max(at, edit.end);
  }
  text.append(content_->text, at);
  return text;
}

}  // namespace higherpair

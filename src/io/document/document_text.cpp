// A profile's text with overrides written into it, and some of its numbers replaced.
#include "document_content.hpp"
#include "encoding.hpp"
#include "higherpair/io/names.hpp"
#include "higherpair/io/profile_document.hpp"
#include "toml_text.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace higherpair {
namespace {

using io_detail::Array;
using io_detail::Mark;
using io_detail::Table;
using io_detail::Value;

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

// The end of a string on one line; none of one whose end is not told by its quotation mark alone.
std::optional<std::size_t> end_of_string(std::string_view text, std::size_t begin) {
  const char quote = begin < text.size() ? text[begin] : '\0';
  if (quote != '"' && quote != '\'') return std::nullopt;
  const std::size_t end = text.find(quote, begin + 1);
  if (end == std::string_view::npos || end == begin + 1) return std::nullopt;
  const std::string_view inside = text.substr(begin + 1, end - begin - 1);
  return inside.find_first_of("\\\n") == std::string_view::npos ? std::optional(end + 1) : std::nullopt;
}

// The end of the text from a bracket or brace to its partner.
std::optional<std::size_t> end_of_brackets(std::string_view text, std::size_t begin) {
  char quote = 0;
  int depth = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      quote = c == quote ? '\0' : quote;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if ((c == '}' || c == ']') && --depth == 0) {
      return i + 1;
    }
    if (depth == 0) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<std::size_t> end_of_value(std::string_view text, std::size_t begin, const Value& value) {
  if (std::holds_alternative<std::string>(value.content)) return end_of_string(text, begin);
  if (std::holds_alternative<Table>(value.content) || std::holds_alternative<Array>(value.content)) {
    return end_of_brackets(text, begin);
  }
  const std::size_t end = end_of_number(text, begin);
  return end > begin ? std::optional(end) : std::nullopt;
}

// Adds the missing key at the end of `path` to a table that has a heading on a line of its own, or before all
// tables.
std::optional<Edit> new_entry(const Table& root, std::string_view text, std::string_view path,
                              const std::string& value) {
  const std::size_t dot = path.rfind('.');
  const std::string entry = fmt::format("{} = {}\n", path.substr(dot + 1), value);
  if (dot == std::string_view::npos) {
    const std::size_t begin = text.size() - io_detail::without_bom(text).size();
    return Edit{begin, begin, entry};
  }
  const io_detail::PathEnd found = io_detail::end_of_path(root, path.substr(0, dot));
  const auto at = found.value == nullptr || found.entry == nullptr ? std::nullopt
                                                                   : offset_of(text, found.entry->key_mark);
  if (!at) return std::nullopt;
  const std::size_t line = text.rfind('\n', *at) == std::string_view::npos ? 0 : text.rfind('\n', *at) + 1;
  const std::size_t first = text.find_first_not_of(" \t", line);
  const std::size_t end = text.find('\n', *at);
  if (first == std::string_view::npos || text[first] != '[' || end == std::string_view::npos)
    return std::nullopt;
  return Edit{end + 1, end + 1, entry};
}

std::optional<Edit> edit_of(const Table& root, std::string_view text,
                            const ProfileDocument::NewValue& value) {
  const io_detail::PathEnd found = io_detail::end_of_path(root, value.path);
  if (found.value == nullptr) {
    return new_entry(root, text, value.path, value.text);
  }
  const auto begin = offset_of(text, found.value->mark);
  const auto end = begin ? end_of_value(text, *begin, *found.value) : std::nullopt;
  return end ? std::optional(Edit{*begin, *end, value.text}) : std::nullopt;
}

std::string edited(std::string_view text, std::vector<Edit> edits) {
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t at = 0;
  for (const Edit& edit : edits) {
    result.append(text, at, edit.begin - at);
    result += edit.text;
    at = std::max(at, edit.end);
  }
  result.append(text, at);
  return result;
}

// The name of the table at the top of the document to which a heading belongs; empty if the line is none.
std::string_view heading_of(std::string_view line) {
  line = io_detail::trimmed(line);
  if (!line.starts_with('[')) return "";
  line.remove_prefix(std::min(line.find_first_not_of("[ \t"), line.size()));
  line = line.substr(0, line.find_first_of(".] \t"));
  return io_detail::is_name(line) ? line : "";
}

// The text without a table at the top of the document, which follows anew at the end.
std::string with_section(std::string_view text, const std::string& name, const Table& table) {
  std::string result;
  bool of_it = false;
  bool below_headings = false;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, std::min(text.find('\n'), text.size() - 1) + 1);
    if (const std::string_view heading = heading_of(line); !heading.empty()) {
      below_headings = true;
      of_it = heading == name;
    }
    const bool dotted = !below_headings && io_detail::trimmed(line).starts_with(name + ".");
    if (!of_it && !dotted) result += line;
    text.remove_prefix(line.size());
  }
  return result + (result.ends_with('\n') || result.empty() ? "\n" : "\n\n") +
         io_detail::toml_section(name, table);
}

// The text with an override written into it, as the value at its path where there is a place, else by writing
// the table at the top of its path anew; none if neither gives what the override gives.
std::optional<std::string> with_override(const std::string& text, const std::string& override) {
  const auto root = io_detail::parse_document(text, "");
  const auto wanted = root ? io_detail::apply_override(*root, override, 1) : tl::unexpected(std::string());
  if (!wanted) return std::nullopt;
  const auto says_it = [&](const std::string& written) {
    const auto read = io_detail::parse_document(written, "");
    return read && io_detail::same_content(*read, wanted->document);
  };
  std::string path = override.substr(0, override.find('='));
  std::erase_if(path, [](char c) { return c == ' ' || c == '\t'; });
  const auto& after = std::get<Table>(wanted->document.content);
  const Value* value = io_detail::end_of_path(after, path).value;
  if (value == nullptr) return std::nullopt;
  if (const auto edit = edit_of(std::get<Table>(root->content), text, {path, io_detail::toml_text(*value)})) {
    std::string written = edited(text, {*edit});
    if (says_it(written)) return written;
  }
  const std::string name = path.substr(0, path.find('.'));
  const Value* section = io_detail::find(after, name);
  const auto* table = section == nullptr ? nullptr : std::get_if<Table>(&section->content);
  if (table == nullptr) return std::nullopt;
  std::string written = with_section(text, name, *table);
  return says_it(written) ? std::optional(std::move(written)) : std::nullopt;
}

tl::expected<std::string, std::string> text_of_document(std::string text,
                                                        const std::vector<std::string>& overrides) {
  for (const std::string& override : overrides) {
    auto written = with_override(text, override);
    if (!written) {
      return tl::unexpected(fmt::format("{}: cannot be written into the text of the profile; change it there",
                                        io_detail::visible(override)));
    }
    text = *std::move(written);
  }
  return text;
}

}  // namespace

tl::expected<std::string, std::string> ProfileDocument::text_with(std::span<const NewValue> values) const {
  auto text = text_of_document(content_->text, content_->overrides);
  const auto document = text ? io_detail::parse_document(*text, "") : tl::unexpected(Diagnostic());
  if (!document) {
    return text;
  }
  const auto& root = std::get<Table>(document->content);
  std::vector<Edit> edits;
  for (const NewValue& value : values) {
    const bool has_place =
        io_detail::end_of_path(root, value.path).value != nullptr || value.path.ends_with(".pose");
    const auto edit = has_place ? edit_of(root, *text, value) : std::nullopt;
    if (!edit) {
      return tl::unexpected(fmt::format("{}: the text has no such value that could be replaced", value.path));
    }
    edits.push_back(*edit);
  }
  return edited(*text, std::move(edits));
}

}  // namespace higherpair

#include "consequences.hpp"

#include "higherpair/numeric/contains.hpp"
#include "numeric/joined_words.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// Whether a path is `outer` or leads into it.
bool is_within(std::string_view path, std::string_view outer) {
  return path.starts_with(outer) && (path.size() == outer.size() || path[outer.size()] == '.');
}

// Whether an unknown key holds what is looked for at a path: it was meant to be this path, or what leads to
// it.
bool holds(const Mistake& unknown, std::string_view path) {
  return std::any_of(unknown.meant.begin(), unknown.meant.end(), [&](const std::string& meant) {
    if (path == meant || !is_within(path, meant)) return path == meant;
    const auto* table = std::get_if<Table>(&unknown.value->content);
    return table != nullptr && end_of_path(*table, path.substr(meant.size() + 1)).value != nullptr;
  });
}

bool explains(const Mistake& cause, const Mistake& mistake) {
  return std::any_of(mistake.lacks.begin(), mistake.lacks.end(), [&](const std::string& path) {
    return holds(cause, path) || (!cause.subject.empty() && is_within(path, cause.subject));
  });
}

// Whether `other` is about the same missing thing, or about a part of it. Overrides have no lines to list.
bool is_part_of(const Mistake& other, const Mistake& whole) {
  return other.lacks.size() == 1 && whole.lacks.size() == 1 && other.mark.source == 0 &&
         whole.mark.source == 0 && is_within(other.lacks.front(), whole.lacks.front());
}

// The first mistake about the whole of what `mistake` misses; itself if there is no other.
std::size_t first_about(const std::vector<Mistake>& mistakes, std::size_t mistake) {
  std::size_t first = mistake;
  for (std::size_t i = 0; i < mistakes.size(); ++i) {
    if (!is_part_of(mistakes[first], mistakes[i])) continue;
    if (i < first || !is_part_of(mistakes[i], mistakes[first])) first = i;
  }
  return first;
}

void list_lines(Mistake& mistake, const std::vector<int>& lines) {
  std::vector<std::string> others;
  for (const int line : lines) {
    std::string text = fmt::format("{}", line);
    if (line != mistake.mark.line && !contains(others, text)) others.push_back(std::move(text));
  }
  if (!others.empty()) {
    mistake.message +=
        fmt::format(" (likewise in {} {})", others.size() == 1 ? "line" : "lines", joined_words(others));
  }
}

}  // namespace

std::vector<Mistake> without_consequences(std::vector<Mistake> mistakes) {
  std::stable_sort(mistakes.begin(), mistakes.end(),
                   [](const Mistake& a, const Mistake& b) { return a.mark < b.mark; });
  std::vector<Mistake> causes;
  for (const Mistake& mistake : mistakes) {
    const auto explains_it = [&](const Mistake& cause) { return explains(cause, mistake); };
    if (std::none_of(mistakes.begin(), mistakes.end(), explains_it)) causes.push_back(mistake);
  }
  std::vector<std::vector<int>> lines(causes.size());
  std::vector<Mistake> kept;
  for (std::size_t i = 0; i < causes.size(); ++i) {
    lines[first_about(causes, i)].push_back(causes[i].mark.line);
  }
  for (std::size_t i = 0; i < causes.size(); ++i) {
    if (lines[i].empty()) continue;
    kept.push_back(causes[i]);
    list_lines(kept.back(), lines[i]);
  }
  return kept;
}

}  // namespace higherpair::io_detail

#include "dxf_pairs.hpp"

#include "higherpair/io/names.hpp"

#include <charconv>

#include <fmt/core.h>

namespace higherpair::io_detail {

std::string_view DxfPairs::take_line() {
  ++line_;
  const std::size_t end = rest_.find('\n');
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!line.empty() && line.back() == '\r') {
    line.remove_suffix(1);
  }
  return trimmed(line);
}

std::optional<DxfPair> DxfPairs::next() {
  if (trimmed(rest_).empty() || !mistake_.empty()) {
    return std::nullopt;
  }
  DxfPair pair;
  const std::string_view code = take_line();
  const auto [end, status] = std::from_chars(code.data(), code.data() + code.size(), pair.code);
  if (status != std::errc() || end != code.data() + code.size() || pair.code < -10 || pair.code > 1100) {
    mistake_ =
        fmt::format("a group code is a whole number up to 1071, found \"{}\"", visible(code.substr(0, 20)));
    return std::nullopt;
  }
  if (rest_.empty()) {
    mistake_ = "the file ends behind a group code: is it cut off?";
    return std::nullopt;
  }
  pair.value = take_line();
  pair.line = line_;
  return pair;
}

}  // namespace higherpair::io_detail

#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::io_detail {

/// One group code and its value, on a line each.
struct DxfPair {
  int code = 0;
  std::string_view value;  ///< without surrounding spaces
  int line = 0;            ///< line of the value, counted from 1
};

/// Splits a text into pairs, one after the other.
class DxfPairs {
public:
  explicit DxfPairs(std::string_view text) : rest_(text) {}

  /// The next pair; none at the end of the text or at a malformed pair, for which mistake() is then set.
  [[nodiscard]] std::optional<DxfPair> next();
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] const std::string& mistake() const { return mistake_; }

private:
  std::string_view take_line();

  std::string_view rest_;
  int line_ = 0;
  std::string mistake_;
};

/// One entity, or anything else that begins with a pair of code 0.
struct DxfGroup {
  std::string_view type;
  int line = 0;
  std::vector<DxfPair> pairs;

  /// The first pair with this code; null if there is none.
  [[nodiscard]] const DxfPair* find(int code) const {
    const auto pair =
        std::find_if(pairs.begin(), pairs.end(), [&](const DxfPair& p) { return p.code == code; });
    return pair == pairs.end() ? nullptr : &*pair;
  }
};

}  // namespace higherpair::io_detail

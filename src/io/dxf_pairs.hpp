#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::io_detail {

/// A group of a drawing: a line with its code and a line with its value.
struct DxfPair {
  int code = 0;
  std::string_view value;  ///< without spaces around it
  int line = 0;            ///< of the value, from 1
};

/// A text taken apart into pairs, one after the other.
class DxfPairs {
public:
  explicit DxfPairs(std::string_view text) : rest_(text) {}

  /// The next pair; none at the end of the text, or where it is not one: then there is a mistake().
  [[nodiscard]] std::optional<DxfPair> next();
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] const std::string& mistake() const { return mistake_; }

private:
  std::string_view take_line();

  std::string_view rest_;
  int line_ = 0;
  std::string mistake_;
};

/// One entity, or anything else that a pair with the code 0 begins.
struct DxfGroup {
  std::string_view type;
  int line = 0;
  std::vector<DxfPair> pairs;
};

}  // namespace higherpair::io_detail

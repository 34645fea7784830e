#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace higherpair {

/// Writes JSON that may be embedded in a page of HTML: `<` and control characters are escaped, invalid UTF-8
/// is replaced. The caller opens and closes brackets; commas are added automatically.
class JsonWriter {
public:
  JsonWriter& open(char bracket) {
    separate();
    text_ += bracket;
    first_ = true;
    return *this;
  }
  JsonWriter& close(char bracket) {
    text_ += bracket;
    first_ = false;
    return *this;
  }
  JsonWriter& key(std::string_view name) {
    string(name);
    text_ += ':';
    first_ = true;
    return *this;
  }
  JsonWriter& string(std::string_view value);
  /// A list of texts.
  template <class Texts>
  JsonWriter& strings(const Texts& texts) {
    open('[');
    for (const auto& text : texts) string(text);
    return close(']');
  }
  JsonWriter& boolean(bool value) { return plain(value ? "true" : "false"); }
  JsonWriter& null() { return plain("null"); }
  JsonWriter& integer(long long value);
  /// \param digits  maximum number of significant digits; writes null where the value is not finite
  JsonWriter& number(double value, int digits);

  [[nodiscard]] std::string take() { return std::move(text_); }

private:
  void separate() {
    if (!first_) text_ += ',';
    first_ = false;
  }
  JsonWriter& plain(std::string_view word) {
    separate();
    text_ += word;
    return *this;
  }

  std::string text_;
  bool first_ = true;
};

}  // namespace higherpair

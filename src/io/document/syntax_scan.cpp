#include "syntax_scan.hpp"

#include "higherpair/io/names.hpp"

#include <algorithm>

namespace higherpair::io_detail {
namespace {

constexpr std::size_t kLongestLine =
    500;  // bytes; enough to show a mistake, and patterns are slow in longer lines

bool is_quote(char c) {
  return c == '"' || c == '\'';
}

// `a . "b"` -> `a.b`
std::string normal_key(std::string_view key) {
  std::string normal;
  for (const char c : key) {
    if (c != ' ' && c != '\t' && !is_quote(c)) {
      normal += c;
    }
  }
  return normal;
}

// Walks through statements, values and strings up to the position where the parser stopped.
class Scanner {
public:
  Scanner(std::string_view text, std::size_t stop) {
    scan_.text = text;
    scan_.stop = std::min(stop, text.size());
  }

  SyntaxScan run() {
    while (at_ < scan_.stop && !scan_.quote) {
      step();
    }
    // A statement that the parser refused at its first byte.
    if (scan_.stop < scan_.text.size() && scan_.open.empty() && scan_.expecting == Expecting::kStatement) {
      begin_statement();
    }
    if (scan_.open.empty() && scan_.expecting == Expecting::kKey) {
      const std::string_view line = scan_.line_from(scan_.token);
      scan_.statements.back().key = normal_key(line.substr(0, line.find('=')));
    }
    return std::move(scan_);
  }

private:
  [[nodiscard]] char here() const { return scan_.text[at_]; }

  void begin_token(std::size_t at, Expecting expecting) {
    scan_.token = at;
    scan_.expecting = expecting;
    scan_.after_value = false;
  }

  void begin_statement() {
    if (here() == '[') {
      const std::string_view line = scan_.line_from(at_);
      const std::size_t from = std::min(line.find_first_not_of('['), line.size());
      heading_ = normal_key(line.substr(from, line.find_first_of("]#", from) - from));
      scan_.statements.push_back({at_, heading_, ""});
      begin_token(at_, Expecting::kHeading);
    } else {
      scan_.statements.push_back({at_, heading_, ""});
      begin_token(at_, Expecting::kKey);
    }
  }

  void end_line() {
    if (scan_.open.empty()) {
      scan_.expecting = Expecting::kStatement;
      scan_.after_value = false;
    }
  }

  void step() {
    const char c = here();
    if (c == '\n') {
      end_line();
      ++at_;
    } else if (c == '#') {
      at_ = std::min(scan_.text.find('\n', at_), scan_.stop);
    } else {
      if (scan_.expecting == Expecting::kStatement && c != ' ' && c != '\t' && c != '\r') {
        begin_statement();
      }
      pass(c);
    }
  }

  // Consumes one character, or a whole string, within a statement.
  void pass(char c) {
    if (is_quote(c) && scan_.expecting != Expecting::kHeading) {
      pass_string(c);
      return;
    }
    if (scan_.expecting == Expecting::kKey && c == '=') {
      if (scan_.open.empty()) {
        scan_.statements.back().key = normal_key(scan_.text.substr(scan_.token, at_ - scan_.token));
      }
      begin_token(at_ + 1, Expecting::kValue);
    } else if (scan_.expecting == Expecting::kValue && (c == '[' || c == '{')) {
      scan_.open.push_back(at_);
      begin_token(at_ + 1, c == '{' ? Expecting::kKey : Expecting::kValue);
    } else if ((c == ']' || c == '}') && !scan_.open.empty()) {
      scan_.open.pop_back();
      scan_.expecting = Expecting::kValue;
      scan_.after_value = true;
    } else if (c == ',' && !scan_.open.empty()) {
      begin_token(at_ + 1, scan_.in_table() ? Expecting::kKey : Expecting::kValue);
    }
    ++at_;
  }

  // Consumes a string with its closing quote; if that is missing, the string stays open.
  void pass_string(char quote) {
    const std::string fence(3, quote);
    const bool is_long = scan_.text.substr(at_).starts_with(fence);
    const std::size_t begin = at_;
    at_ += is_long ? 3 : 1;
    while (at_ < scan_.stop) {
      const bool closed = is_long ? scan_.text.substr(at_).starts_with(fence) : here() == quote;
      if (closed) {
        at_ += is_long ? 3 : 1;
        scan_.after_value = scan_.expecting == Expecting::kValue;
        return;
      }
      at_ += quote == '"' && here() == '\\' ? 2 : 1;
    }
    scan_.quote = begin;
  }

  SyntaxScan scan_;
  std::size_t at_ = 0;
  std::string heading_;
};

}  // namespace

std::string_view SyntaxScan::line_from(std::size_t from) const {
  const std::string_view line = text.substr(from, std::min(text.find('\n', from) - from, kLongestLine));
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

std::string_view SyntaxScan::last_token() const {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n", token), text.size());
  const std::string_view line = line_from(begin);
  return trimmed(line.substr(0, line.find_first_of(",]}#")));
}

SyntaxScan scan_syntax(std::string_view text, std::size_t stop) {
  return Scanner(text, stop).run();
}

}  // namespace higherpair::io_detail

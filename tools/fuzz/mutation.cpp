#include "mutation.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <random>
#include <string_view>

namespace higherpair::fuzz {
namespace {

constexpr std::size_t kMostChanges = 6;
constexpr std::size_t kLongestPart = 200;  // longest part removed or repeated at once
constexpr std::size_t kLongestInput = 1 << 16;

constexpr std::array<std::string_view, 20> kNumbers{
    "0",   "-0.0", "1",   "-1", "3",   "1e-9",  "1e308",     "-1e308",     "5e-324",  "1e400",
    "nan", "-inf", "inf", "90", "180", "360.0", "999999999", "1000000001", "\"1 m\"", "[0, 0]"};

constexpr std::array<double, 12> kDoubles{0,
                                          -0.0,
                                          1,
                                          -1,
                                          1e-9,
                                          1e150,
                                          std::numeric_limits<double>::max(),
                                          std::numeric_limits<double>::lowest(),
                                          std::numeric_limits<double>::min(),
                                          std::numeric_limits<double>::denorm_min(),
                                          std::numeric_limits<double>::infinity(),
                                          std::numeric_limits<double>::quiet_NaN()};

bool is_of_number(char c) {
  return (c >= '0' && c <= '9') || c == '.';
}

class Mutation {
public:
  Mutation(const std::vector<std::string>& inputs, std::uint64_t number)
      : inputs_(inputs), random_(number), text_(any_input()) {}

  std::string make() {
    for (std::size_t changes = 1 + below(kMostChanges); changes > 0; --changes) {
      change();
    }
    text_.resize(std::min(text_.size(), kLongestInput));
    return text_;
  }

private:
  // Distributions of the standard library would differ between implementations.
  std::size_t below(std::size_t bound) { return random_() % bound; }

  const std::string& any_input() { return inputs_[below(inputs_.size())]; }

  void change() {
    if (text_.empty()) {
      text_ = any_input();
      return;
    }
    const std::size_t at = below(text_.size());
    switch (below(7)) {
      case 0:
        text_[at] = static_cast<char>(text_[at] ^ (1 << below(8)));
        break;
      case 1:
        text_[at] = static_cast<char>(below(256));
        break;
      case 2:
        text_.erase(at, 1 + below(kLongestPart));
        break;
      case 3:
        text_.insert(below(text_.size()), std::string(text_, at, 1 + below(kLongestPart)));
        break;
      case 4:
        insert_line(at);
        break;
      case 5:
        replace_number(at);
        break;
      default:
        replace_double(at);
        break;
    }
  }

  // Inserts a line of a random input at the beginning of a line.
  void insert_line(std::size_t at) {
    const std::string& other = any_input();
    if (other.empty()) {
      return;
    }
    const auto begin_of_line = [](const std::string& text, std::size_t place) {
      const std::size_t end = text.rfind('\n', place);
      return end == std::string::npos ? 0 : end + 1;
    };
    const std::size_t first = begin_of_line(other, below(other.size()));
    const std::size_t last = std::min(other.find('\n', first), other.size() - 1);
    text_.insert(begin_of_line(text_, at), std::string(other, first, last + 1 - first));
  }

  // Replaces the first decimal number from this position on.
  void replace_number(std::size_t at) {
    const auto from = text_.begin() + static_cast<std::ptrdiff_t>(at);
    const auto first = std::find_if(from, text_.end(), is_of_number);
    const auto last = std::find_if_not(first, text_.end(), is_of_number);
    text_.replace(first, last, kNumbers[below(kNumbers.size())]);
  }

  // Replaces the binary number at this position.
  void replace_double(std::size_t at) {
    const std::size_t first = at / sizeof(double) * sizeof(double);
    const double value = kDoubles[below(kDoubles.size())];
    const auto* bytes = reinterpret_cast<const char*>(&value);
    text_.replace(first, sizeof value, std::string(bytes, sizeof value));
  }

  const std::vector<std::string>& inputs_;
  std::mt19937_64 random_;
  std::string text_;
};

}  // namespace

std::string mutated(const std::vector<std::string>& inputs, std::uint64_t number) {
  return Mutation(inputs, number).make();
}

}  // namespace higherpair::fuzz

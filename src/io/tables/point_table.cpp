#include "point_table.hpp"

#include "csv_fields.hpp"
#include "higherpair/io/names.hpp"
#include "io/document/encoding.hpp"
#include "io/units/unit_table.hpp"
#include "numeric/joined_words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr std::size_t kMostMistakes = 5;

using Fields = std::vector<std::string_view>;

class PointReader {
public:
  PointReader(const PointColumns& columns, const Units& units)
      : columns_(columns),
        units_(units),
        scalings_{{{to_si(columns.dimensions[0], units), {}}, {to_si(columns.dimensions[1], units), {}}}} {}

  void line(std::string_view text, int number) {
    if (mistakes_.size() >= kMostMistakes) return;
    text = trimmed(text);
    const bool first = separator_ == 0;
    if (first) separator_ = separator_of(text);
    const Fields fields = fields_of(text, separator_);
    if (first && is_header(fields.front())) {
      header(fields, number);
    } else {
      row(fields, number);
    }
  }

  tl::expected<PointTable, std::vector<std::string>> finish() {
    if (mistakes_.empty() && table_.points.empty()) {
      mistakes_.push_back("has no points");
    }
    if (!mistakes_.empty()) {
      return tl::unexpected(std::move(mistakes_));
    }
    table_.unit = {quantity(1, 0).si, quantity(1, 1).si};
    return std::move(table_);
  }

private:
  void fail(int line, const std::string& what) {
    mistakes_.push_back(fmt::format("line {}: {}", line, what));
  }

  // Its first field may be empty, as that of an index. A number that is wrong does not make a header.
  static bool is_header(std::string_view field) {
    constexpr std::string_view kOfNumbers = "+-.0123456789";
    return !number_in(field) && (field.empty() || kOfNumbers.find(field.front()) == std::string_view::npos);
  }

  // The columns called `wanted`; if there is none, those called "owner.wanted".
  static std::vector<std::size_t> columns_called(const Fields& fields, std::string_view wanted) {
    std::vector<std::size_t> exact;
    std::vector<std::size_t> owned;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::string_view name = trimmed(fields[i].substr(0, fields[i].find('[')));
      if (name == wanted) exact.push_back(i);
      if (name.ends_with(fmt::format(".{}", wanted))) owned.push_back(i);
    }
    return exact.empty() ? owned : exact;
  }

  void header(const Fields& fields, int line) {
    count_ = fields.size();
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<std::size_t> found = columns_called(fields, columns_.names[k]);
      if (found.size() > 1) {
        std::vector<std::string> names;
        for (const std::size_t i : found) names.push_back(visible(fields[i]));
        fail(line, fmt::format("several columns may be {}: {}; leave one of them", columns_.names[k],
                               joined_words(names)));
        return;
      }
      if (found.empty() && count_ != 2) {
        fail(line,
             fmt::format("expected two columns, {0} and {1}, or a header that has {0} and {1} among others; "
                         "found {2} columns",
                         columns_.names[0], columns_.names[1], count_));
        return;
      }
      place_[k] = found.empty() ? k : found.front();
      const std::string_view field = fields[place_[k]];
      const std::size_t open = field.find('[');
      if (open != std::string_view::npos && field.ends_with(']')) {
        const std::string_view unit = field.substr(open + 1, field.size() - open - 2);
        if (const auto scalings = scalings_of(unit, columns_.dimensions[k], units_)) {
          scalings_[k] = *scalings;
        } else {
          fail(line, fmt::format("{}: {}", field, scalings.error()));
        }
      }
    }
  }

  void row(const Fields& fields, int line) {
    if (count_ == 0) count_ = 2;
    if (fields.size() != count_) {
      fail(line, fmt::format("expected {} columns, found {}{}", count_, fields.size(),
                             comma_advice(separator_, fields.size(), count_)));
      return;
    }
    std::array<Quantity, 2> point;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string_view field = fields[place_[k]];
      const auto value = number_in(field);
      if (!value) {
        fail(line, no_number(field, columns_.names[k]));
        return;
      }
      point[k] = quantity(*value, k);
      table_.decimals[k] = std::max(table_.decimals[k], decimals_of(field));
      if (!(std::abs(point[k].si) <= kLargestQuantity)) {
        fail(line, fmt::format("{} is too large", *value));
        return;
      }
    }
    table_.points.push_back(point);
    table_.lines.push_back(line);
  }

  [[nodiscard]] Quantity quantity(double value, std::size_t k) const {
    return {value, scalings_[k].to_si.apply(value), scalings_[k].to_profile.apply(value)};
  }

  const PointColumns& columns_;
  const Units& units_;
  char separator_ = 0;
  std::size_t count_ = 0;  // of columns, 0 until known
  std::array<std::size_t, 2> place_{0, 1};
  std::array<UnitScalings, 2> scalings_;
  PointTable table_;
  std::vector<std::string> mistakes_;
};

}  // namespace

int decimals_of(std::string_view number) {
  const std::size_t exponent_at = number.find_first_of("eE");
  const std::string_view digits = number.substr(0, exponent_at);
  const std::size_t point = digits.find('.');
  int decimals = point == std::string_view::npos ? 0 : static_cast<int>(digits.size() - point) - 1;
  if (exponent_at != std::string_view::npos) {
    std::string_view text = number.substr(exponent_at + 1);
    if (text.starts_with('+')) text.remove_prefix(1);
    int exponent = 0;
    std::from_chars(text.data(), text.data() + text.size(), exponent);
    decimals -= exponent;
  }
  return std::max(decimals, 0);
}

tl::expected<PointTable, std::vector<std::string>> read_points(std::string_view text,
                                                               const PointColumns& columns,
                                                               const Units& units) {
  PointReader reader(columns, units);
  const std::string plain = with_plain_blanks(text);
  for_each_line(plain, [&](std::string_view line, int number) { reader.line(line, number); });
  auto table = reader.finish();
  // Check the encoding only after a failure: comments may be in any encoding.
  const auto encoding = table ? std::nullopt : encoding_mistake(text);
  if (!encoding) {
    return table;
  }
  const int line = encoding->mark.line;
  return tl::unexpected(std::vector<std::string>{
      line > 0 ? fmt::format("line {}: {}", line, encoding->message) : encoding->message});
}

}  // namespace higherpair::io_detail

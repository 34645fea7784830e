#include "csv_fields.hpp"

#include "higherpair/io/names.hpp"
#include "io/document/encoding.hpp"
#include "io/units/unit_table.hpp"
#include "numeric/decimal.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

std::string_view bare(std::string_view field) {
  field = trimmed(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
    field = trimmed(field.substr(1, field.size() - 2));
  }
  return field;
}

// What is wrong with a field that should be a number, for the end of a message: a decimal comma, or a unit
// that belongs to the header. Empty if nothing is known.
std::string number_advice(std::string_view field, std::string_view column) {
  if (const std::string advice = separator_advice(field); !advice.empty()) {
    return ": " + advice;
  }
  std::string_view unit = field;
  if (unit.starts_with('[') && unit.ends_with(']')) unit = unit.substr(1, unit.size() - 2);
  return is_unit_name(unit.substr(0, unit.find_first_of("*/^ ")))
             ? fmt::format(": units follow the names in the first line, {}[{}]", visible(column), unit)
             : "";
}

}  // namespace

char separator_of(std::string_view line) {
  for (const char separator : {';', '\t', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ' ';
}

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  while (true) {
    if (separator == ' ') {
      line = trimmed(line);
      if (line.empty()) return fields;
    }
    const std::size_t end = separator == ' ' ? line.find_first_of(" \t") : line.find(separator);
    fields.push_back(bare(line.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

std::optional<double> number_in(std::string_view field) {
  if (field.starts_with('+') && !field.starts_with("+-")) field.remove_prefix(1);
  double value = 0;
  const auto [end, error] = read_decimal(field.data(), field.data() + field.size(), value);
  const bool whole = error == std::errc() && end == field.data() + field.size() && !field.empty();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string no_number(std::string_view field, std::string_view column) {
  return fmt::format("`{}` is no number{}", visible(field.substr(0, 40)), number_advice(field, column));
}

std::string comma_advice(char separator, std::size_t found, std::size_t expected) {
  return separator == ',' && found == 2 * expected ? kPointNotComma : "";
}

void for_each_line(std::string_view text,
                   const std::function<void(std::string_view line, int number)>& line) {
  text = without_bom(text);
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view one = text.substr(0, end);
    if (one.ends_with('\r')) one.remove_suffix(1);
    if (const std::string_view content = trimmed(one); !content.empty() && content.front() != '#') {
      line(one, number);
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace higherpair::io_detail

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::io_detail {

/// \name Tables of numbers as text: separated by commas, semicolons, tabs or spaces
/// @{

/// The separator found in the first line of a file; ' ' stands for any number of spaces or tabs.
[[nodiscard]] char separator_of(std::string_view line);

/// The fields of a line, stripped of surrounding spaces and quotes; they are views into `line`.
[[nodiscard]] std::vector<std::string_view> fields_of(std::string_view line, char separator);

/// The number if a finite decimal, with at most one sign, fills the whole field.
[[nodiscard]] std::optional<double> number_in(std::string_view field);

/// What is wrong with a field that should be a number: "`2,5` is no number: a decimal number …".
[[nodiscard]] std::string no_number(std::string_view field, std::string_view column);

/// The end of the message about a line with a wrong number of fields: kPointNotComma if it has two for each
/// that it should have, else empty.
[[nodiscard]] std::string comma_advice(char separator, std::size_t found, std::size_t expected);

/// Calls `line` with the text and number of each line, without its line end; skips a byte order mark, empty
/// lines and lines that begin with #.
void for_each_line(std::string_view text, const std::function<void(std::string_view line, int number)>& line);
/// @}

}  // namespace higherpair::io_detail

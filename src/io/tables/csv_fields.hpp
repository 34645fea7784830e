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

/// What is wrong with a field that should be a number, for the end of a message: a decimal comma, or a unit
/// that belongs to the header. Empty if nothing is known.
[[nodiscard]] std::string number_advice(std::string_view field, std::string_view column);

/// Calls `line` with the text and number of each line, without its line end; skips a byte order mark, empty
/// lines and lines that begin with #.
void for_each_line(std::string_view text, const std::function<void(std::string_view line, int number)>& line);
/// @}

}  // namespace higherpair::io_detail

#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace higherpair::io_detail {

/// \name Tables of numbers as text: separated by commas, semicolons, tabs or spaces
/// @{

/// The separator of a file is that of its first line; ' ' for any number of spaces.
[[nodiscard]] char separator_of(std::string_view line);

/// The fields of a line without spaces and quotes around them; parts of `line`.
[[nodiscard]] std::vector<std::string_view> fields_of(std::string_view line, char separator);

/// A finite decimal number that takes up the whole field, with or without a sign.
[[nodiscard]] std::optional<double> number_in(std::string_view field);

/// Calls `line` with the text and number of each line; no line ends, byte order mark and empty lines and
/// none that begin with #.
void for_each_line(std::string_view text, const std::function<void(std::string_view line, int number)>& line);
/// @}

}  // namespace higherpair::io_detail

#pragma once

#include <string>

namespace CLI {
class App;
}  // namespace CLI

namespace higherpair::cli {

/// Adds -o to a command that draws `profile`. The ending of the path determines the format; see
/// check_picture() and check_files().
void add_picture_option(CLI::App& command, const std::string& profile, std::string& path);

/// Throws CLI::ValidationError if no picture can be written to `path`: its ending is not .svg, .pdf or .png,
/// or is one of the last two and the module that converts pictures cannot be loaded. "-" is SVG on standard
/// output.
void check_picture(const std::string& path);

/// Converts an SVG picture to the format given by the ending of `path`; throws std::runtime_error on failure.
[[nodiscard]] std::string picture_for(const std::string& path, std::string svg);

/// Writes it; false on failure, or if interruption() occurs.
[[nodiscard]] bool write_picture(const std::string& path, std::string svg);

}  // namespace higherpair::cli

#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace higherpair::cli {

/// Adds -o to a command that draws: the picture's file, whose ending decides what is written. Kinds of files
/// that this program does not write are refused, so is a folder that does not exist.
CLI::Option* add_picture_option(CLI::App& command, std::string& path);

/// Throws CLI::ValidationError where a picture cannot go to `path`: another ending than .svg, .pdf and .png,
/// one of which this build knows nothing, a folder that does not exist. "-" is standard output, as SVG.
void check_picture(const std::string& path);

/// An SVG picture as what the ending of `path` asks for; throws std::runtime_error where that fails.
[[nodiscard]] std::string picture_for(const std::string& path, std::string svg);

/// Whether this build writes PDF and PNG.
[[nodiscard]] bool can_convert();

/// The same picture as PDF, 1 px being 1/96 inch.
[[nodiscard]] std::string pdf_of(const std::string& svg);
/// The same picture as PNG with two pixels for each px.
[[nodiscard]] std::string png_of(const std::string& svg);

}  // namespace higherpair::cli

#include "picture.hpp"

#include "module.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "picture_module.hpp"
#include "signals.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const std::string& path) {
  return path == "-" ? ".svg" : CLI::detail::to_lower(fs::path(path).extension().string());
}

using Convert = void(const std::string& svg, std::string& out);

// Converts an SVG picture to the format with this ending, .pdf or .png; an objection if the module cannot be
// loaded.
tl::expected<Convert*, std::string> converter_to(const std::string& ending) {
  const std::string module = "higherpair-pictures";
  return ending == ".pdf" ? load<decltype(higherpair_pdf_of)>(module, "higherpair_pdf_of")
                          : load<decltype(higherpair_png_of)>(module, "higherpair_png_of");
}

}  // namespace

void check_picture(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending != ".svg" && ending != ".pdf" && ending != ".png") {
    throw CLI::ValidationError("--output", path + ": a picture ends in .svg, .pdf or .png");
  }
  if (ending == ".svg") {
    return;
  }
  if (const auto convert = converter_to(ending); !convert) {
    throw CLI::ValidationError(
        "--output", path + ": this higherpair was built without librsvg and cairo, which " + ending +
                        " needs, or cannot load them (" + convert.error() +
                        "); write an .svg, or install librsvg2-dev and libcairo2-dev and build again");
  }
}

void add_picture_option(CLI::App& command, const std::string& profile, std::string& path) {
  command
      .add_option("-o,--output", path,
                  "the picture: a file that ends in .svg, .pdf or .png (-: SVG on standard output)")
      ->required();
  command.final_callback([&profile, &path] {
    check_files({{"FILE", profile}}, {{"--output", path}});
    check_picture(path);
  });
}

std::string picture_for(const std::string& path, std::string svg) {
  const std::string ending = ending_of(path);
  if (ending == ".svg") {
    return svg;
  }
  const auto convert = converter_to(ending);
  if (!convert) {
    throw std::runtime_error(convert.error());
  }
  std::string picture;
  (*convert)(svg, picture);
  return picture;
}

bool write_picture(const std::string& path, std::string svg) {
  return write_files({{path, picture_for(path, std::move(svg))}}, &interruption());
}

}  // namespace higherpair::cli

#include "picture.hpp"

#include "output_file.hpp"
#include "output_options.hpp"
#include "run_command.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const std::string& path) {
  std::string ending = path == "-" ? ".svg" : fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

}  // namespace

void check_picture(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending != ".svg" && ending != ".pdf" && ending != ".png") {
    throw CLI::ValidationError("--output", path + ": a picture ends in .svg, .pdf or .png");
  }
  if (ending != ".svg" && !can_convert()) {
    throw CLI::ValidationError(
        "--output", path + ": this higherpair was built without librsvg and cairo, which " + ending +
                        " needs; write an .svg, or install librsvg2-dev and libcairo2-dev and build again");
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
  return ending == ".pdf" ? pdf_of(svg) : ending == ".png" ? png_of(svg) : std::move(svg);
}

bool write_picture(const std::string& path, std::string svg) {
  return write_files({{path, picture_for(path, std::move(svg))}}, &interruption());
}

}  // namespace higherpair::cli

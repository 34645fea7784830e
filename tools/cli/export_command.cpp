#include "commands.hpp"
#include "higherpair/front/export.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "signals.hpp"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace higherpair::cli {
namespace {

struct ExportOptions : ProfileOptions {
  std::string output;
  std::vector<std::string> curves;
  std::string body;
  bool pitch = false;
  /// Lengths as given: numbers in the profile's unit, or with a unit of their own.
  std::optional<std::string> cutter;
  std::optional<std::string> reach;
  std::optional<std::string> tolerance;
  std::optional<int> points;
  std::optional<std::string> units;
};

namespace fs = std::filesystem;

enum class Format { kCsv, kDxf, kSvg };

std::optional<Format> format_of(const std::string& path) {
  const std::string ending =
      CLI::detail::to_lower(path == "-" ? ".csv" : fs::path(path).extension().string());
  if (ending == ".csv") return Format::kCsv;
  if (ending == ".dxf") return Format::kDxf;
  if (ending == ".svg") return Format::kSvg;
  return std::nullopt;
}

void check_options(const ExportOptions& options) {
  check_files({{"FILE", options.profile}}, {{"--output", options.output}});
  const auto format = format_of(options.output);
  if (!format) {
    throw CLI::ValidationError("--output",
                               options.output + ": a curve goes to a file that ends in .csv, .dxf or .svg");
  }
  if (options.points && *format != Format::kCsv) {
    throw CLI::ValidationError("--points", "is for .csv; arcs are as many as --tolerance takes");
  }
  if (*format == Format::kCsv && (options.curves.size() > 1 || !options.body.empty())) {
    throw CLI::ValidationError("--output", options.output + ": a .csv holds one curve; name it with --curve");
  }
}

tl::unexpected<Error> wrong_option(const std::string& name, const std::string& message) {
  return tl::unexpected(Error{ErrorKind::kInput, {about(name, message)}});
}

// The length in metres of "5" (in the profile's unit) or "5 mm".
Result<double> length_of(const std::string& name, const std::string& text, const Units& units) {
  double number = 0;
  const bool plain = CLI::detail::lexical_cast(text, number);
  double metres = to_si(dimension::kLength, units).apply(number);
  if (!plain) {
    const auto quantity = parse_quantity(text, dimension::kLength, units);
    if (!quantity) {
      return wrong_option(name, fmt::format("`{}`: {}", text, quantity.error()));
    }
    metres = quantity->si;
  }
  if (!(metres > 0 && metres <= kLargestQuantity)) {
    return wrong_option(name, fmt::format("`{}`: expected a length above 0", text));
  }
  return metres;
}

Result<Units> output_units(const ExportOptions& options, Units units) {
  if (options.units) {
    const auto unit = find_unit(*options.units);
    if (!unit || dimension_of(*unit) != dimension::kLength) {
      const std::string likely =
          unit ? "" : did_you_mean(*options.units, {"m", "cm", "mm", "um", "km", "in", "ft"});
      return wrong_option("--units",
                          fmt::format("`{}`: expected a unit of length: m, cm, mm, um, km, in, ft{}{}",
                                      *options.units, likely.empty() ? "" : "; ", likely));
    }
    units.length = *unit;
  }
  return units;
}

struct Settings {
  ExportSettings curves;
  ExportAccuracy accuracy;
  Units units;
};

Result<Settings> settings_of(const ExportOptions& options, const Units& units) {
  Settings settings;
  settings.curves.curves = options.curves;
  settings.curves.body = options.body;
  settings.accuracy.points = options.points;
  const auto output = output_units(options, units);
  if (!output) {
    return tl::unexpected(output.error());
  }
  settings.units = *output;
  const auto take = [&](const char* name, const std::optional<std::string>& text,
                        const auto& put) -> Result<bool> {
    if (!text) {
      return false;
    }
    return length_of(name, *text, units).map([&](double metres) {
      put(metres);
      return true;
    });
  };
  const auto cutter = take("--cutter", options.cutter, [&](double x) { settings.curves.cutter = x; });
  const auto reach = take("--reach", options.reach, [&](double x) { settings.curves.reach = x; });
  const auto tolerance =
      take("--tolerance", options.tolerance, [&](double x) { settings.accuracy.tolerance = x; });
  for (const auto* taken : {&cutter, &reach, &tolerance}) {
    if (!*taken) {
      return tl::unexpected(taken->error());
    }
  }
  settings.curves.path = *cutter         ? ExportSettings::Path::kCutter
                         : options.pitch ? ExportSettings::Path::kPitch
                                         : ExportSettings::Path::kCurve;
  return settings;
}

Result<std::string> flank_text(const Model& model, const std::vector<ExportedCurve>& curves,
                               const Settings& settings, Format format) {
  switch (format) {
    case Format::kDxf:
      return curves_dxf(model, curves, settings.accuracy, settings.units);
    case Format::kSvg:
      return curves_svg(model, curves, settings.accuracy, settings.units);
    case Format::kCsv:
      break;
  }
  return curve_csv(model, curves.front(), settings.accuracy, settings.units);
}

// Writes curves of a profile as CSV, DXF or SVG; returns the exit code.
int export_command(const ExportOptions& options) {
  const auto model = open_model(options, {{"--output", options.output}});
  if (!model) {
    return report_error(model.error());
  }
  const auto settings = settings_of(options, model->units());
  if (!settings) {
    return report_error(settings.error());
  }
  const auto text = exported_curves(*model, settings->curves).and_then([&](const auto& curves) {
    return flank_text(*model, curves, *settings, *format_of(options.output));
  });
  if (!text) {
    return report_error(text.error());
  }
  return write_files({{options.output, *text}}, &interruption()) ? kExitOk : exit_unwritten();
}

}  // namespace

CommandRun add_export(CLI::App& command) {
  const auto options = std::make_shared<ExportOptions>();
  add_profile_options(command, *options);
  command
      .add_option("-o,--output", options->output,
                  "a file that ends in .csv, .dxf or .svg (-: CSV on standard output)")
      ->required();
  command.add_option("--curve", options->curves, "BODY.CURVE: this curve; repeatable but for CSV")
      ->allow_extra_args(false);
  command.add_option("--body", options->body, "all curves of this body");
  auto* pitch = command.add_flag("--pitch", options->pitch,
                                 "instead the path of the centre of the roller that touches it");
  command
      .add_option("--cutter", options->cutter,
                  "instead the path of the centre of a round cutter of this radius")
      ->excludes(pitch);
  command.add_option("--tolerance", options->tolerance,
                     "largest distance of arcs and lines from the curve, as 0.01 or '5 um' (default: 1e-5 of "
                     "its size)");
  command
      .add_option("--points", options->points, "of CSV: number of points, at equal distances along the curve")
      ->check(CLI::Range(2, 10'000'000));
  command.add_option("--reach", options->reach, "how far curves without ends are followed from their vertex");
  command.add_option("--units", options->units, "unit of length of the file (default: the profile's)");
  command.final_callback([options] { check_options(*options); });
  return [options] { return export_command(*options); };
}

}  // namespace higherpair::cli
